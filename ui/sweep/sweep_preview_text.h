// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test in words before it runs and while it does: whether it can be run, whether the time
// is enough, how far it has got. Pure; main thread, in the language of the moment.
#pragma once

#include "session/sweep/sweep_test.h"
#include "ui/common/theme.h"

namespace ui {
struct PreviewText {
    Tone tone = Tone::Quiet;
    QString text; ///< rich text; a link in it means "take the time that is enough"
};

/// `switching`: servos in another mode will be switched.
PreviewText previewText(const std::vector<session::SweepPreview>& previews,
                        const results::SweepSpec& spec, const session::ServoRegistry& registry,
                        bool switching);

/// `run`: null before it has begun.
QString progressText(const jobs::SweepProgress& progress, const results::SweepRun* run);
} // namespace ui

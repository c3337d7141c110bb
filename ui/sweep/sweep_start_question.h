// SPDX-License-Identifier: GPL-3.0-or-later
// The question before servos move in a sweep test: which ones, how far, and whether they keep
// torque afterwards. Main thread.
#pragma once

#include "session/sweep/sweep_test.h"

#include <functional>

class QWidget;

namespace ui {
/// What the user agreed to. Another test of the same servos needs no second question.
struct SweepConsent {
    std::vector<session::ServoRef> servos;
    bool released = false; ///< torque off afterwards
    bool switchMode = false;
    bool operator==(const SweepConsent&) const = default;
};

SweepConsent consentFor(const session::SweepTestRequest& request);

/// `page` goes with the question; `previews` may know the range of a list of goals.
void askBeforeSweep(QWidget* page, const session::ServoRegistry& registry,
                    const session::SweepTestRequest& request,
                    const std::vector<session::SweepPreview>& previews,
                    const std::function<void()>& accepted);
} // namespace ui

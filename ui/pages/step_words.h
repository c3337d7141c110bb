// SPDX-License-Identifier: GPL-3.0-or-later
// Short words of the step page. Pure; main thread.
#pragma once

#include "record/step_run.h"

#include <QStringList>

namespace ui {
/// "position_p 40, position_d 20"
inline QString stepGainsText(const std::vector<record::StepGain>& gains)
{
    QStringList words;
    for (const record::StepGain& gain : gains)
        words << QStringLiteral("%1 %2").arg(gain.key).arg(gain.raw);
    return words.join(QStringLiteral(", "));
}
} // namespace ui

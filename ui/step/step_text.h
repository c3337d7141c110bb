// SPDX-License-Identifier: GPL-3.0-or-later
// Short words of the step page. Pure; main thread.
#pragma once

#include "base/journal.h"
#include "catalog/profile.h"
#include "results/step_run.h"
#include "text/language.h"
#include "text/translate.h"

#include <QStringList>

namespace ui {
/// "position_p 40, position_d 20"
inline QString stepGainsText(const std::vector<record::StepGain>& gains)
{
    QStringList parts;
    for (const record::StepGain& gain : gains)
        parts << QStringLiteral("%1 %2").arg(gain.key).arg(gain.raw);
    return parts.join(QStringLiteral(", "));
}

inline bool wasAborted(const record::StepRun* run)
{
    return run != nullptr && run->end != record::SweepEnd::Finished;
}

/// "Position loop P 12 (own value 32)"; by key without a profile.
inline QString unrevertedTrialText(const std::vector<base::JournalItem>& trial,
                                   const catalog::Profile* profile)
{
    QStringList parts;
    for (const base::JournalItem& item : trial) {
        const catalog::Register* reg = profile != nullptr ? profile->find(item.key) : nullptr;
        parts << text::translate("ui::StepPage", "%1 %2 (own value %3)")
                     .arg(reg != nullptr ? reg->name.in(text::isUiChinese()) : item.key)
                     .arg(item.newRaw)
                     .arg(item.oldRaw);
    }
    return parts.join(QStringLiteral(", "));
}
} // namespace ui

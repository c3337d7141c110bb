// SPDX-License-Identifier: GPL-3.0-or-later
// Short words of the step page. Pure; main thread.
#pragma once

#include "base/journal.h"
#include "catalog/profile.h"
#include "report/step_text.h"
#include "report/sweep_text.h"
#include "results/step_run.h"
#include "text/language.h"
#include "text/translate.h"

#include <QStringList>

namespace ui {
/// "position_p 40, position_d 20"
inline QString stepGainsText(const std::vector<results::StepGain>& gains)
{
    QStringList parts;
    for (const results::StepGain& gain : gains)
        parts << QStringLiteral("%1 %2").arg(gain.key).arg(gain.raw);
    return parts.join(QStringLiteral(", "));
}

/// "own values", or the values of the trial
inline QString stepTrialText(const results::StepSpec& spec)
{
    return spec.trial.empty() ? text::translate("ui::StepResults", "baseline")
                              : stepGainsText(spec.trial);
}

/// "ID 3 · STS3215 · 1800 → 2100 · own values", and how it ended if it was interrupted.
inline QString stepDetailsText(const results::StepRun& run)
{
    const snapshot::SnapshotServo& servo = run.parameters.servo;
    QString details = QStringLiteral("ID %1 · %2 · %3 → %4 · %5")
                          .arg(servo.id)
                          .arg(servo.model, report::stepValue(run.axis.from),
                               report::stepValue(run.axis.to), stepTrialText(run.spec));
    if (run.end != results::SweepEnd::Finished)
        details += QStringLiteral(" · ") + text::localized(report::endText(run.end));
    return details;
}

inline bool wasAborted(const results::StepRun* run)
{
    return run != nullptr && run->end != results::SweepEnd::Finished;
}

/// "Position loop P 12 (own value 32)"; by key without a profile.
inline QString unrevertedTrialText(const std::vector<base::JournalItem>& trial,
                                   const catalog::Profile* profile)
{
    QStringList parts;
    for (const base::JournalItem& item : trial) {
        parts << text::translate("ui::StepPage", "%1 %2 (old value %3)")
                     .arg(text::registerName(profile, item.key))
                     .arg(item.newRaw)
                     .arg(item.oldRaw);
    }
    return parts.join(QStringLiteral(", "));
}
} // namespace ui

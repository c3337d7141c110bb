// SPDX-License-Identifier: GPL-3.0-or-later
// Short words of the step page. Pure; main thread.
#pragma once

#include "base/journal.h"
#include "jobs/step/step_advice.h"
#include "report/step_text.h"
#include "report/sweep_text.h"
#include "results/step_run.h"
#include "text/language.h"
#include "text/translate.h"

#include <QStringList>

namespace ui {
/// "Position loop P 40, Position loop D 20"; by key without a profile.
inline QString stepGainsText(const std::vector<results::StepGain>& gains,
                             const catalog::Profile* profile)
{
    QStringList parts;
    for (const results::StepGain& gain : gains)
        parts << QStringLiteral("%1 %2").arg(text::registerName(profile, gain.key)).arg(gain.raw);
    return text::joinItems(parts);
}

/// "baseline", or the values of the trial.
inline QString stepTrialText(const results::StepSpec& spec, const catalog::Profile* profile)
{
    return spec.trial.empty() ? text::translate("ui::StepResults", "baseline")
                              : stepGainsText(spec.trial, profile);
}

/// "ID 3 · STS3215 · 1800 → 2100 · baseline", and how it ended if it was interrupted.
inline QString stepDetailsText(const results::StepRun& run, const catalog::Catalog& catalog)
{
    const catalog::ProfilePtr profile = jobs::profileOf(run, catalog);
    const snapshot::SnapshotServo& servo = run.parameters.servo;
    QString details =
        QStringLiteral("ID %1 · %2 · %3 → %4 · %5")
            .arg(servo.id)
            .arg(servo.model, report::stepValue(run.axis.from), report::stepValue(run.axis.to),
                 stepTrialText(run.spec, profile.get()));
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
    return text::joinItems(parts);
}
} // namespace ui

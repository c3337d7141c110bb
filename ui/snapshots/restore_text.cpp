// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/restore_text.h"

#include "text/language.h"
#include "text/restore_text.h"
#include "text/translate.h"

#include <algorithm>

namespace ui {
using text::translate;

bool isRowApplied(const jobs::RestoreRowResult& row)
{
    return row.write.outcome == device::WriteOutcome::Kept ||
           row.write.outcome == device::WriteOutcome::Temporary;
}

BannerText restoreOutcomeText(const jobs::RestoreOutcome& outcome, const RegisterNames& names)
{
    using jobs::RestoreVerdict;
    int applied = 0;
    QStringList others;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        if (isRowApplied(row))
            ++applied;
        else
            others << names.name(row.write.key);
    }
    const bool good =
        outcome.verdict == RestoreVerdict::Done || outcome.verdict == RestoreVerdict::AlreadySet;
    BannerText message;
    message.tone = good ? Tone::Good : Tone::Bad;
    message.message = text::restoreVerdictText(jobs::verdictName(outcome.verdict));
    if (outcome.verdict != RestoreVerdict::RolledBack)
        message.message +=
            QStringLiteral(": ") +
            translate("RestoreText", "%n row(s) written and read back", nullptr, applied);
    QStringList cause;
    if (!others.isEmpty())
        cause << translate("RestoreText", "Not written or not confirmed: %1.")
                     .arg(text::joinItems(others));
    cause << notRolledBackText(outcome, names) << openLockText(outcome.lock);
    message.cause = text::joinSentences(cause);
    if (outcome.verdict == RestoreVerdict::Failed)
        message.remedy = restoreRemedy(outcome);
    return message;
}

QString notRolledBackText(const jobs::RestoreOutcome& outcome, const RegisterNames& names)
{
    QStringList registers;
    for (const QString& key : outcome.notReverted) {
        const auto row = std::find_if(outcome.rows.begin(), outcome.rows.end(),
                                      [&key](const auto& one) { return one.write.key == key; });
        const auto read = row != outcome.rows.end() ? row->write.readBack : std::nullopt;
        registers << (read ? translate("RestoreText", "%1 (last reading: %2)")
                                 .arg(names.name(key), names.value(key, *read))
                           : translate("RestoreText", "%1 (value unknown)").arg(names.name(key)));
    }
    return registers.isEmpty()
               ? QString()
               : translate("RestoreText", "The old values could not be restored: %1.")
                     .arg(text::joinItems(registers));
}

QString restoreRemedy(const jobs::RestoreOutcome& outcome)
{
    if (outcome.notReverted.isEmpty())
        return translate("RestoreText", "Read the memory table, then write the remaining rows; the "
                                        "journal lists their values.");
    if (outcome.isChangeOpen)
        return translate("RestoreText", "When the servo replies again, open Port → Interrupted "
                                        "writes and choose Undo to restore the old values.");
    return translate("RestoreText",
                     "The snapshot saved before the first write contains the old values.");
}

QString openLockText(device::LockState lock)
{
    switch (lock) {
    case device::LockState::Open:
        return translate("RestoreText", "The EPROM is unlocked.");
    case device::LockState::Unknown:
        return translate("RestoreText", "The EPROM lock could not be confirmed.");
    case device::LockState::Closed:
    case device::LockState::None:
        break;
    }
    return {};
}
} // namespace ui

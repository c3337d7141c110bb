// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/restore_text.h"

#include "text/translate.h"

#include <algorithm>

namespace ui {
using text::translate;

QString notRolledBackText(const jobs::RestoreOutcome& outcome, const RegisterNames& names)
{
    QStringList registers;
    for (const QString& key : outcome.notReverted) {
        const auto row = std::find_if(outcome.rows.begin(), outcome.rows.end(),
                                      [&key](const auto& one) { return one.write.key == key; });
        const auto read = row != outcome.rows.end() ? row->write.readBack : std::nullopt;
        registers << (read ? translate("RestoreWords", "%1 (last read: %2)")
                                 .arg(names.name(key), names.value(key, *read))
                           : translate("RestoreWords", "%1 (value unknown)").arg(names.name(key)));
    }
    return registers.isEmpty()
               ? QString()
               : translate("RestoreWords", "The old values could not be put back: %1.")
                     .arg(registers.join(QStringLiteral(", ")));
}

QString restoreRemedy(const jobs::RestoreOutcome& outcome)
{
    if (outcome.notReverted.isEmpty())
        return translate("RestoreWords", "Read the table and write the rest again; the journal "
                                         "knows what was to be written.");
    if (outcome.isChangeOpen)
        return translate("RestoreWords", "When the servo answers again, open Port → Interrupted "
                                         "writes: Undo there puts the old values back.");
    return translate("RestoreWords", "The table that was saved before the first write has the old "
                                     "values.");
}

QString openLockText(device::LockState lock)
{
    switch (lock) {
    case device::LockState::Open:
        return translate("RestoreWords", "The EPROM lock is open.");
    case device::LockState::Unknown:
        return translate("RestoreWords", "The EPROM lock is not proven closed.");
    case device::LockState::Closed:
    case device::LockState::None:
        break;
    }
    return {};
}
} // namespace ui

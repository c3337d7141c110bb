// SPDX-License-Identifier: GPL-3.0-or-later
// Finishes or undoes the registers of an interrupted write, and ends its intent. A snapshot's
// restore is finished in the way it is started: torque off first, its rows in safe order, only up
// to the first failure. Internal to jobs; the job's thread.
#pragma once

#include "jobs/recover/recover.h"

namespace jobs {
struct AppliedRecovery {
    base::Result<void> result{};
    /// For a snapshot's restore every row, also those that only had to be proven; for others the
    /// rows written. Nullopt where nothing was written, or nothing had to be.
    std::optional<device::WriteReport> report{};
    /// The rows written now, with the values found before.
    std::vector<device::WriteItem> writtenNow{};
    /// Registers whose value differs from the action's and that are not written: see
    /// isRecoverable().
    QStringList skippedKeys{};
    bool isNothingToDo = false; ///< no register had to be written
    bool torqueIsOff = false;   ///< proven; only checked where a snapshot was restored
};
/// `servo`: as previewIntent() has found it.
AppliedRecovery applyRecovery(const device::Context& context, const base::Intent& intent,
                              device::Servo& servo, RecoveryAction action);

/// One intent from the preview to its end. An obstacle, also a lost link, is in the result together
/// with what was done until then. Errors: those of the preview, and of the journal.
base::Result<RecoveryResult> recoverIntent(const device::Context& context,
                                           const base::Intent& intent, RecoveryAction action,
                                           const BeforeWrite& beforeWrite = {});
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// Brings the registers of an interrupted write to one side or the other, and ends its intent. A
// snapshot's restore is ended as one is begun: torque off first, its rows in safe order, no further
// than the first that fails. Internal to jobs; the job's thread.
#pragma once

#include "jobs/recover/recover.h"

namespace jobs {
bool isSnapshotRestore(const base::Intent& intent);

struct AppliedRecovery {
    base::Result<void> result{};
    /// Of a snapshot's restore every row, also those that had only to be proved; of others what was
    /// written. Nullopt where nothing was, or nothing had to be.
    std::optional<device::WriteReport> report{};
    /// What was written only now, with the value it was found with.
    std::vector<device::WriteItem> writtenNow{};
    /// What has another value than the action asks for and is not written: see isRecoverable().
    QStringList skippedKeys{};
    bool isNothingToDo = false; ///< all of it is left
    bool torqueIsOff = false;   ///< proven; only asked for where a snapshot was restored
};
/// `servo`: as look() has found it.
AppliedRecovery applyRecovery(const device::Context& context, const base::Intent& intent,
                              device::Servo& servo, RecoveryAction action);

/// One intent from looking to its end. What stands against it, a lost link as well, is in the
/// result beside what was done until then. Errors: those of looking, and of the journal.
base::Result<RecoveryResult> recoverIntent(const device::Context& context,
                                           const base::Intent& intent, RecoveryAction action,
                                           const BeforeWrite& beforeWrite = {});
} // namespace jobs

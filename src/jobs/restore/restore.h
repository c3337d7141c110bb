// SPDX-License-Identifier: GPL-3.0-or-later
// Executes a restore plan: torque off first (it stays off), one EPROM transaction with every row
// read back, then ID and rate as jobs of their own. One intent in the journal holds all rows; if
// the link or the program fails in the middle it stays open, and finishing it
// (jobs/recover/recover.h) or restoring again completes the work. With nothing to write, nothing is
// sent at all. The job's thread; `servo` is updated to its new ID and rate. Errors (nothing was
// written): those of device::write before its first byte, BadArgument ("other servo") when the plan
// was made for another one, and those of `beforeWrite`.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"
#include "jobs/restore/restore_plan.h"
#include "snapshot/restore_result.h"

namespace jobs {
enum class OnFailure : std::uint8_t {
    Stop,     ///< at the first row that did not take its value; written rows stay
    RollBack, ///< then write the old values again, in a transaction of its own
};

/// Called once before the first write of a servo, and not at all when there is none: saves the
/// table (session::saveSafetySnapshot). Its error ends the restore before anything is written.
using BeforeWrite = std::function<base::Result<void>(const device::Context&, device::Servo&)>;

struct RestoreOptions {
    device::Consent consent{}; ///< to the dangerous rows that are selected
    OnFailure onFailure = OnFailure::Stop;
    BeforeWrite beforeWrite{};
};

enum class RestoreVerdict : std::uint8_t {
    AlreadySet, ///< nothing had to be written
    Done,       ///< every row took its value, the lock is closed
    Failed,     ///< some row did not: see the rows
    RolledBack, ///< some row did not, and all old values are proven to be back
};
QString verdictName(RestoreVerdict verdict); ///< "already-so", "done", "failed", "rolled-back"

struct RestoreRowResult {
    device::WriteResult write;
    bool rolledBack = false;
};

struct RestoreOutcome {
    RestoreVerdict verdict = RestoreVerdict::AlreadySet;
    std::vector<RestoreRowResult> rows{}; ///< in the order of writing; ID and rate last
    device::LockState lock = device::LockState::None;
    bool torqueSwitchedOff = false;
    int oldId = -1, newId = -1;
    int oldBaud = 0, newBaud = 0;
    /// Rolling back was requested, and these may not have their old values.
    QStringList notReverted{};
    bool isChangeOpen = false; ///< the journal still has values to restore: recovery continues
};

base::Result<RestoreOutcome> restore(const device::Context& context, device::Servo& servo,
                                     const RestorePlan& plan, const RestoreOptions& options,
                                     const ProgressFn& progress = {});

/// For saving (snapshot::saveRestoreResults). `source`: file or name of the snapshot.
snapshot::RestoreResult toRestoreResult(const RestoreOutcome& outcome, const device::Servo& servo,
                                        const QString& source, const QString& program);

/// The values of a snapshot are known beforehand, those that a servo restores itself (0x06) are
/// not.
bool isSnapshotRestore(const base::Intent& intent);
} // namespace jobs

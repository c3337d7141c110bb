// SPDX-License-Identifier: GPL-3.0-or-later
// One snapshot or template for several servos, and a bundle back onto its bus by ID: each servo is
// read, planned and written by itself, and a failure does not affect the others. Identity rows are
// never written here. The job's thread. An error is the verdict of its servo; a lost link, an
// emergency stop or the user's stop is the verdict of all remaining servos.
#pragma once

#include "jobs/restore/restore.h"
#include "snapshot/bundle.h"

namespace jobs {
enum class ApplyVerdict : std::uint8_t {
    AlreadySet,
    Done,
    Failed,
    RolledBack,
    Planned,    ///< dry run: there are values to write
    NoReply,    ///< no servo has this ID
    OtherServo, ///< bundle: another model has this ID now; not written
    Error,      ///< see `error`; nothing was written
};
QString verdictName(ApplyVerdict verdict); ///< "already-so", … "no-answer", "other-servo", "error"

struct ApplyResult {
    int id = -1;
    ApplyVerdict verdict = ApplyVerdict::Error;
    std::optional<device::Servo> servo{}; ///< as read, where it answered
    RestorePlan plan{};
    std::optional<RestoreOutcome> outcome{};
    std::optional<base::Error> error{};
};

struct ApplyOptions {
    RestoreChoice choice{}; ///< identity is ignored
    RestoreOptions restore{};
    bool dryRun = false; ///< read and plan only
    /// Protocols in which a servo may answer; empty: that of the snapshot.
    std::vector<base::Protocol> protocols{};
    bool otherModel = false; ///< bundle: also where another model has the ID
};

/// `onServo`: called after each servo, for a growing list.
using ApplyResultFn = std::function<void(const ApplyResult&)>;

std::vector<ApplyResult> applyToServos(const device::Context& context, const std::vector<int>& ids,
                                       const snapshot::Snapshot& snapshot,
                                       const ApplyOptions& options, const ProgressFn& progress = {},
                                       const ApplyResultFn& onServo = {});

/// Each snapshot of the bundle onto the servo with its ID.
std::vector<ApplyResult> restoreBundle(const device::Context& context,
                                       const snapshot::Bundle& bundle, const ApplyOptions& options,
                                       const ProgressFn& progress = {},
                                       const ApplyResultFn& onServo = {});

/// Reads all given servos (as a scan found them) into one bundle. A servo that cannot be read ends
/// it with its error, because an incomplete bundle would look complete.
base::Result<snapshot::Bundle> takeBundle(const device::Context& context,
                                          std::vector<device::Servo>& servos,
                                          const QString& program, const ProgressFn& progress = {});
} // namespace jobs

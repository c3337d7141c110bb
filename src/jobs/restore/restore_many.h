// SPDX-License-Identifier: GPL-3.0-or-later
// One snapshot or template for several servos, and a bundle back onto its bus by ID: each servo is
// read, planned and written for itself, and one that fails does not keep the others from theirs.
// Identity rows are never written here. The job's thread. What goes wrong is a servo's verdict; a
// lost link, an emergency stop or the user's stop is that of all servos from there on.
#pragma once

#include "jobs/restore/restore.h"
#include "snapshot/bundle.h"

namespace jobs {
enum class ApplyVerdict : std::uint8_t {
    AlreadySet,
    Done,
    Failed,
    RolledBack,
    Planned,    ///< dry run: there are writes to come
    NoReply,    ///< nobody has this ID
    OtherServo, ///< bundle: another model has this ID now; left alone
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
    /// Languages in which a servo may answer; empty: that of the snapshot.
    std::vector<base::Protocol> protocols{};
    bool otherModel = false; ///< bundle: also where another model has the ID
};

/// `onServo`: after each, for the list that grows.
using ApplyResultFn = std::function<void(const ApplyResult&)>;

std::vector<ApplyResult> applyToServos(const device::Context& context, const std::vector<int>& ids,
                                       const record::Snapshot& snapshot,
                                       const ApplyOptions& options, const ProgressFn& progress = {},
                                       const ApplyResultFn& onServo = {});

/// Each snapshot of the bundle onto the servo with its ID.
std::vector<ApplyResult> restoreBundle(const device::Context& context, const record::Bundle& bundle,
                                       const ApplyOptions& options, const ProgressFn& progress = {},
                                       const ApplyResultFn& onServo = {});

/// Reads every servo given (as a scan found them) into one bundle. A servo that cannot be read ends
/// it with its error: half a bundle would look like a whole one.
base::Result<record::Bundle> takeBundle(const device::Context& context,
                                        std::vector<device::Servo>& servos, const QString& program,
                                        const ProgressFn& progress = {});
} // namespace jobs

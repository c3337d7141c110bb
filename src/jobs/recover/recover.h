// SPDX-License-Identifier: GPL-3.0-or-later
// Open intents of the journal: what an interrupted write left behind, and finishing or undoing it.
// A preview writes nothing. An intent is finished or undone only if identity and values match; a
// lock is closed only where its flag reads open.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"
#include "jobs/restore/restore.h"

namespace jobs {
enum class Finding : std::uint8_t {
    AllOld, ///< nothing of it was written
    AllNew, ///< everything was written; only the end is missing
    Mixed,
    OtherServo, ///< identity or values differ: nothing is written
    NoReply,
    Unreadable, ///< replies come, but none is readable: it may be the servo
    UnderWay,   ///< in another running program: not examined
    /// Later writes in the journal explain the present values, or all of them are lost at power-off
    /// and read neither old nor new.
    Replaced,
};

struct OpenIntent {
    base::Intent intent;
    Finding finding = Finding::NoReply;
    int foundId = -1; ///< the ID under which it answers now
    int foundBaud = 0;
    std::optional<bool> lockOpen;
    QStringList replaced{}; ///< registers with such a value: not written
    std::optional<base::Error> unreadable{};
};

enum class RecoveryAction : std::uint8_t { Preview, Finish, Undo };

struct RecoveryResult {
    OpenIntent before;
    /// The action that was done, or tried: not always the requested one, see recover().
    RecoveryAction action = RecoveryAction::Preview;
    bool done = false;
    /// Registers that do not have the requested value and were not written, because they have a
    /// later value or the servo would move.
    QStringList skippedKeys{};
    bool isAllSkipped =
        false; ///< the change is abandoned: nothing of it was left to finish or undo
    /// For a snapshot's restore every row of the intent; for others the rows written, if any.
    std::optional<device::WriteReport> report;
    std::optional<base::Error> error;
    bool torqueIsOff = false; ///< proven; only checked where a snapshot was restored
};

/// Which intents are taken; never simulated ones on a real port or the reverse.
enum class IntentPorts : std::uint8_t {
    This, ///< those started on this port
    /// Also those of ports that are gone: an adapter may have another name now. Servos of a port
    /// that is present are searched there, because here another one of the same kind may answer.
    IncludingMissing,
    Any, ///< also those of ports that are present: the user states that it is the same servo
};

struct RecoveryOptions {
    IntentPorts ports = IntentPorts::This;
    QString uuid{}; ///< only this one
    /// Called before a servo is written to; its error leaves that intent open.
    BeforeWrite beforeWrite{};
};

/// Intents of real servos that were started on other ports than `port`, and are not taken there.
std::vector<base::Intent> startedOnOtherPorts(const std::vector<base::Intent>& open,
                                              const QString& port,
                                              IntentPorts ports = IntentPorts::This);

/// Whether the device on which the intent was started is present; false for network ports, where
/// that is not known.
bool isPortPresent(const base::Intent& intent);

/// Abandons an intent: it is recorded as abandoned, and the servo is not written. Held
/// ("other-program"): it belongs to another running program.
base::Result<void> forget(base::Journal& journal, const base::Intent& intent);

/// Whether recovery has written, or would write, this register.
bool isRecoveredBy(const RecoveryResult& recovered, const device::Servo& servo,
                   const catalog::Register& reg);

/// Finishes starting with the oldest, undoes starting with the latest. Where both a restore and its
/// rollback were interrupted, the rollback is finished and the restore undone, unless `uuid` names
/// one.
base::Result<std::vector<RecoveryResult>> recover(const device::Context& context,
                                                  RecoveryAction action,
                                                  const RecoveryOptions& options = {},
                                                  const ProgressFn& progress = {});
} // namespace jobs

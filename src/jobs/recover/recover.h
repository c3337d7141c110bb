// SPDX-License-Identifier: GPL-3.0-or-later
// Open intents of the journal: what an interrupted write left behind, and finishing or undoing it.
// Looking writes nothing. An intent is finished or undone only after identity and values match; a
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
    OtherServo, ///< identity or values differ: hands off
    NoReply,
    Unreadable, ///< something answers, but nothing readable: it may be the servo
    UnderWay,   ///< in another program that is running: not looked at
    /// Later writes to the servo, which the journal has, explain what stands there, or all of it is
    /// lost at power-off and reads neither old nor new.
    Replaced,
};

struct OpenIntent {
    base::Intent intent;
    Finding finding = Finding::NoReply;
    int foundId = -1; ///< where it answers now
    int foundBaud = 0;
    std::optional<bool> lockOpen;
    QStringList replaced{}; ///< registers with such a value: left alone
    std::optional<base::Error> unreadable{};
};

enum class RecoveryAction : std::uint8_t { Preview, Finish, Undo };

struct RecoveryResult {
    OpenIntent before;
    /// What was done, or tried: not always what was asked for, see recover().
    RecoveryAction action = RecoveryAction::Preview;
    bool done = false;
    /// Registers that read another value than was asked for and were not written, because a later
    /// value stands there or the servo would move.
    QStringList skippedKeys{};
    bool isAllSkipped = false; ///< the change is given up: nothing of it was there to be settled
    /// Of a snapshot's restore every row of the intent; of others what was written, if anything.
    std::optional<device::WriteReport> report;
    std::optional<base::Error> error;
    bool torqueIsOff = false; ///< proven; only asked for where a snapshot was restored
};

/// Whose intents are taken; never simulated ones on a real port or the other way round.
enum class IntentPorts : std::uint8_t {
    This, ///< those begun on this port
    /// And those of ports that are gone: an adapter may have another name now. On a port that is
    /// there the servo is looked for on that port; here another one of its kind may answer.
    IncludingMissing,
    Any, ///< and those of ports that are there: the user says that it is the same servo
};

struct RecoveryOptions {
    IntentPorts ports = IntentPorts::This;
    QString uuid{}; ///< only this one
    /// Before a servo is written to; its error leaves that intent open.
    BeforeWrite beforeWrite{};
};

/// Intents of real servos that were begun on other ports than `port`, and are not taken there.
std::vector<base::Intent> startedOnOtherPorts(const std::vector<base::Intent>& open,
                                              const QString& port,
                                              IntentPorts ports = IntentPorts::This);

/// The device that the intent was begun on is there; of a port in a network that is not known.
bool isPortPresent(const base::Intent& intent);

/// Gives an intent up: recorded as abandoned, the servo is left as it is. Held ("other-program"):
/// another program has it under way.
base::Result<void> forget(base::Journal& journal, const base::Intent& intent);

/// The register that recovery has brought, or would bring, to one side or the other.
bool isRecoveredBy(const RecoveryResult& recovered, const device::Servo& servo,
                   const catalog::Register& reg);

/// Finishes from the oldest on, undoes from the latest on. Where both a restore and its way back
/// were broken off, the way back is finished and the restore undone, unless one is named by `uuid`.
base::Result<std::vector<RecoveryResult>>
recover(const device::Context& context, RecoveryAction action, const RecoveryOptions& options = {});
} // namespace jobs

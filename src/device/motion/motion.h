// SPDX-License-Identifier: GPL-3.0-or-later
// Torque, modes and moves without surprises. Torque-on holds the present position, as each mode
// allows; a mode switch is a guarded procedure; fields that are not given are not written. Notices
// report what else happened.
// Errors: those of reading and writing, plus NotSupported, OutOfRange, TurnsUnknown (all before the
// first byte), Uncertain.
#pragma once

#include "device/alarms.h"
#include "device/writer.h"

namespace device {
enum class Torque : std::uint8_t { Off, On, Damp };

/// Off is sent first, even where writing is otherwise refused (two servos on one ID, a family in
/// doubt, a line that never falls silent); the error then states that it was sent, see
/// device/motion/torque_off.h.
base::Result<void> setTorque(const Context& context, Servo& servo, Torque torque);

/// Ends the motion at once; torque stays on where the servo can hold. Where no position to hold is
/// known (step mode, turns not known, far outside the limits), and where the servo keeps turning
/// after the stop command, torque is turned off, and that is noted. Where neither can be proven,
/// torque off is sent as with setTorque(). A servo that slows down is waited for.
base::Result<void> halt(const Context& context, Servo& servo);
/// In their order. All get the command before the first one is waited for.
std::vector<base::Result<void>> haltAll(const Context& context, const std::vector<Servo*>& servos);

/// The two halves of halt(), for several servos that become known one after the other.
struct HaltCommand {
    enum class Kind : std::uint8_t { Nothing, Holding, StopCommand };
    Kind kind = Kind::Nothing;              ///< what is still to be proven
    const catalog::Register* reg = nullptr; ///< the command; Nothing: torque, off already
    std::int64_t raw = 0;
};
base::Result<HaltCommand> commandHalt(const Context& context, Servo& servo);
base::Result<void> confirmHalt(const Context& context, Servo& servo, const HaltCommand& command);

/// Torque off → switch (both limits in one write) → zero the new mode's command → read back. Torque
/// stays off. The journal keeps the limits and the speed for the way back.
base::Result<WriteReport> switchMode(const Context& context, Servo& servo, const QString& mode);

/// What switchMode would do, for the user's decision. Reads only.
struct ModePlan {
    struct Write {
        QString key;
        std::optional<std::int64_t> oldRaw;
        std::int64_t newRaw = 0;
    };
    QString from; ///< mode key; empty: not known
    QString to;
    bool torqueGoesOff = false;      ///< it is on now
    std::vector<Write> writes;       ///< limits and mode, in order
    QString zeroed;                  ///< the command that is set to 0; empty: none
    bool limitsSaved = false;        ///< the present limits are saved for the way back
    bool limitsRestored = false;     ///< from the saved ones
    bool limitsSetToDefault = false; ///< none were saved: factory values
};
base::Result<ModePlan> planMode(const Context& context, Servo& servo, const QString& mode);

/// What write() also sets where these items select another mode: the command that is set to rest, a
/// current limit that changes its meaning. In the order of writing; empty: the mode stays. Based on
/// the values read so far. A speed saved for position modes may be restored as well.
std::vector<WriteItem> extraWritesOfSwitch(const Servo& servo, const std::vector<WriteItem>& items);

/// Torque off and the present mode's command at zero: the safe end of an incomplete mode switch.
base::Result<void> torqueOffAndZero(const Context& context, Servo& servo);

enum class MoveMethod : std::uint8_t { Write, Sync, Async };

/// One servo's move. Values as the user typed them, parsed against the register they go to.
struct MoveCommand {
    Servo* servo = nullptr;
    /// "2048", "90deg". Speed, PWM and current modes: "30rpm", "20%"; a plain number only where the
    /// unit is not documented (LX motor, SMCL speed), signed for the direction.
    QString goal;
    std::optional<QString> speed{};
    std::optional<QString> acceleration{};
    std::optional<QString> time{};    ///< milliseconds; only where the map has a time
    std::optional<QString> current{}; ///< HLS: the limit for this move; not in current mode
    /// Settings not older than this are not read again before the goal; 0: read now. For goals that
    /// follow each other quickly while a slider is dragged.
    base::Duration maxSettingsAge{};
    /// The goal is meant for this mode and refused in another one ("mode-changed"); empty: any.
    QString mode{};
};

/// What will be written, planned and checked before anything is sent.
struct MovePlan {
    Servo* servo = nullptr;
    std::vector<WriteItem> fields; ///< in the order of writing; the goal is last
    bool relative = false;         ///< step mode: never repeated blindly
    bool energizes = false;        ///< torque is off now
    base::Duration travelTime{};   ///< the travel time written with the goal
    std::int64_t goalRaw = 0;
    catalog::Role goalRole = catalog::Role::GoalPosition;
    QString mode{}; ///< key of the mode it was planned for
    /// Whether a start may find it in its servo. Also known after a failure; none: it was not sent.
    std::optional<bool> held{};
};

base::Result<MovePlan> planMove(const Context& context, const MoveCommand& order);

/// Sync and Async start all of them together, in the way of each family: one packet, held writes,
/// stored moves. NotSupported ("no-sync", "no-async") where one of them has no such way.
base::Result<void> sendMoves(const Context& context, std::vector<MovePlan>& plans, MoveMethod how);

/// The two halves of Async. sendAsyncMoves leaves each goal in its servo, which does not move yet.
/// NotSupported ("no-async").
base::Result<void> sendAsyncMoves(const Context& context, std::vector<MovePlan>& plans);
/// Starts the held goals. Several Feetech servos are started by one ACTION for all, which starts
/// every servo on the bus that holds a goal from any program; a single one and LX servos are
/// addressed. Before the first byte: Refused ("mode-changed") where a goal now means something
/// else.
base::Result<void> startAsyncMoves(const Context& context, std::vector<MovePlan>& plans);
/// Removes the held goals; nothing moves. Feetech: torque must be off, and is off afterwards.
base::Result<void> cancelAsyncMoves(const Context& context, std::vector<MovePlan>& plans);

/// The steps from the goal to the present position, if they are more than friction and a heavy arm
/// explain. Nullopt also where too little has been read. `relative`: step mode, in
/// which the position shows what remains.
std::optional<std::int64_t> goalDeviation(const Servo& servo, std::int64_t goalRaw, bool relative);

/// Waits until every servo's moving flag is down (without a flag: until it stands still and its own
/// travel time is over), or `limit` has passed (NoReply/Refused then), or stop. `onSample` sees
/// each reading.
struct MoveProgress {
    int id = 0;
    std::optional<double> position; ///< physical
    bool moving = false;
    std::uint8_t status = 0;
};
base::Result<void> waitForArrival(const Context& context, std::vector<MovePlan>& plans,
                                  base::Duration limit,
                                  const std::function<void(const MoveProgress&)>& onSample);
} // namespace device

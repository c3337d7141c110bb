// SPDX-License-Identifier: GPL-3.0-or-later
// Clears an alarm in the way its protection requires (protocol sheet §7): an overload by a small
// goal away from the stall, which moves the shaft; an overcurrent by a new goal, its present
// position; Modbus servos through their fault reset register. Voltage and temperature pass when the
// value returns, so nothing is written for them; an encoder alarm needs a power-cycle. First a
// plan, which only reads; then, with the user's consent, the action.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"

namespace jobs {
enum class ClearMethod : std::uint8_t {
    None,       ///< there is no alarm
    BackOff,    ///< a small goal away from the stall: moves
    NewGoal,    ///< its present position as the new goal: turns torque on
    FaultReset, ///< by register, holding its position
    Wait,       ///< passes by itself when the value is back within its limits
    PowerCycle,
    Unknown, ///< a status bit without a name
};
QString clearMethodName(ClearMethod release); ///< "turn-back", for JSON

/// One alarm with its measured value and limit. Values are raw, of the register `measured`.
struct Alarm {
    QString key; ///< "overload"; "bit4" where the family has no name for it
    ClearMethod release = ClearMethod::Unknown;
    bool derived = false; ///< derived from the limits; the servo reports none (LX)
    QString measured{};   ///< register key; empty: nothing shows it
    std::optional<std::int64_t> value{};
    std::optional<std::int64_t> min{}, max{};
};

struct AlarmPlan {
    std::vector<Alarm> alarms;
    ClearMethod next = ClearMethod::None; ///< the possible next step
    bool torqueOff = false;               ///< torque is off now, so the goal will turn it on
    std::optional<std::int64_t> from, to; ///< TurnBack, NewGoal: steps as in the goal register
    std::int64_t faultResetBits = 0;      ///< FaultReset
    /// Why this servo's mode or limits do not allow TurnBack.
    std::optional<base::Error> refused;

    /// Moves or turns torque on, so the user must have agreed.
    bool needsConsent() const
    {
        return !refused && (next == ClearMethod::BackOff || next == ClearMethod::NewGoal);
    }
};

/// Reads, writes nothing. Errors are those of reading.
base::Result<AlarmPlan> planClearAlarm(const device::Context& context, device::Servo& servo);

struct AlarmReport {
    AlarmPlan before;
    AlarmPlan after; ///< what is left, as read afterwards
    bool isExecuted = false;
    bool isCleared() const { return after.next == ClearMethod::None; }
};

/// Reads again and does what `agreed` allows. NeedsConsent when it would move or turn torque on
/// without agreement ("release-moves", "release-energizes"), or differs from it ("alarm-changed");
/// NotSupported as the plan's `refused`; else the errors of moves and writes. Nothing is written
/// where only waiting or a power-cycle helps.
base::Result<AlarmReport> clearAlarm(const device::Context& context, device::Servo& servo,
                                     const std::optional<AlarmPlan>& approved);
} // namespace jobs

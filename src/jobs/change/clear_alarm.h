// SPDX-License-Identifier: GPL-3.0-or-later
// Clearing an alarm by what releases it, and by nothing else (protocol sheet §7): an overload by a
// small goal away from the stall, which moves the shaft; an overcurrent by a new goal, its present
// place; Modbus servos through their fault reset register. Voltage and temperature pass when the
// value returns, so nothing is written for them; an encoder alarm needs a power-cycle. First a
// plan, which only reads; then, with the user's consent, the action.
#pragma once

#include "device/writer.h"
#include "jobs/job.h"

namespace jobs {
enum class ClearMethod : std::uint8_t {
    None,       ///< there is no alarm
    BackOff,    ///< a small goal away from the stall: moves
    NewGoal,    ///< its present place as the new goal: energizes
    FaultReset, ///< by register, holding where it is
    Wait,       ///< passes by itself when the value is back within its limits
    PowerCycle,
    Unknown, ///< a status bit without a name
};
QString clearMethodName(ClearMethod release); ///< "turn-back", for JSON

/// One alarm with what it is judged by. Values are raw, of the register `measured` and its kind.
struct Alarm {
    QString key; ///< "overload"; "bit4" where the family has no name for it
    ClearMethod release = ClearMethod::Unknown;
    bool derived = false; ///< worked out here from the limits; the servo reports none (LX)
    QString measured{};   ///< register key; empty: nothing shows it
    std::optional<std::int64_t> value{};
    std::optional<std::int64_t> min{}, max{};
};

struct AlarmPlan {
    std::vector<Alarm> alarms;
    ClearMethod next = ClearMethod::None; ///< what can be done now
    bool torqueOff = false;               ///< torque is off now, so the goal will energize it
    std::optional<std::int64_t> from, to; ///< TurnBack, NewGoal: steps as in the goal register
    std::int64_t faultResetBits = 0;      ///< FaultReset
    /// TurnBack that this servo's mode or limits do not allow: why.
    std::optional<base::Error> refused;

    /// Moves or energizes, so somebody must have agreed.
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

/// Looks again and does what `agreed` says. NeedsConsent when it would move or energize without
/// ("release-moves", "release-energizes"), or otherwise than agreed ("alarm-changed");
/// NotSupported as the plan's `refused`; else the errors of moves and writes. Nothing is written
/// where only waiting or a power-cycle helps.
base::Result<AlarmReport> clearAlarm(const device::Context& context, device::Servo& servo,
                                     const std::optional<AlarmPlan>& approved);
} // namespace jobs

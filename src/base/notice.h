// SPDX-License-Identifier: GPL-3.0-or-later
// What a manoeuvre did besides what was asked, or found on its way: torque switched off, a lock
// that stood open, limits restored. Data only; the text layer words it. Appended by device and
// jobs; the front end that started the work shows them. One thread (the job's).
#pragma once

#include <QString>

#include <cstdint>
#include <vector>

namespace base {
enum class NoticeCode : std::uint8_t {
    TorqueSwitchedOff,       ///< because a register or mode asked for it
    TorqueSwitchedOn,        ///< the goal written energizes the servo
    TorqueStaysOff,          ///< after the manoeuvre; on only when asked
    HoldingAt,               ///< a = goal raw at which the servo holds
    LockFoundOpen,           ///< the EPROM lock was open before the work began
    LockClosed,              ///< after LockFoundOpen, or recovered
    LockLeftOpen,            ///< could not be closed; it is in the journal
    CommandZeroed,           ///< key = goal_speed / goal_pwm …
    LimitsSaved,             ///< a, b = limits remembered for the way back
    LimitsRestored,          ///< a, b
    LimitsSetToDefault,      ///< a, b: nothing was remembered, factory values used
    SpeedRestored,           ///< a = raw speed for position mode put back
    SpeedZeroedForTime,      ///< SCS: the time acts only while the speed is 0, so 46 was set to 0
    ReplyLostButWritten,     ///< the acknowledgement was lost, reading proved the write
    ReplyLostResent,         ///< the acknowledgement was lost, reading proved nothing had happened
    AckFromNewId,            ///< a = the ID that acknowledged
    AlreadySet,              ///< nothing to do
    EffectiveAfterRestart,   ///< the new rate or bit takes effect at the next power-on
    AboveRecommended,        ///< key, a = value above what the sheet calls useful
    StoppedByUser,           ///< stopped by the user before key was written
    OverloadActive,          ///< overload: released by a goal away from the stall
    OvercurrentActive,       ///< overcurrent: torque is off until a new goal
    VoltageAlarmActive,      ///< voltage alarm: passes when the supply returns to its limits
    TemperatureAlarmActive,  ///< temperature alarm: passes by cooling only
    SensorAlarmActive,       ///< encoder alarm: power-cycle, repair if it returns
    RebootedAfter,           ///< a = milliseconds until it answered
    RateChanged,             ///< a = baud at which it answers now
    StillMoving,             ///< no longer waited for; a = 1: it may move, no flag shows it
    IdChanged,               ///< a = ID at which it answers now
    Resent,                  ///< reading proved that a write without acknowledgement never arrived
    PersistenceUndocumented, ///< no source states whether key survives power-off
    SaveUnverified,          ///< the save command was sent; only a power cycle could prove it
    CurrentLimitZero,        ///< key = the current limit, which is 0: no torque at all
    CurrentRestored,    ///< key, a = current limit put back after a mode that uses it otherwise
    DerivedTemperature, ///< key, a = reading, b = limit: worked out here, not reported
    DerivedVoltage,     ///< key, a = reading, b = the limit it is beyond
    MixedFamilies,      ///< SCS beside STS or SMS on one line
    LedNotRestored,     ///< key: still as it was made to blink; it is in the journal
    NotRecorded,        ///< key = why: the end of a change that was made is not in the journal
    SettingNotRestored, ///< key, a = value before: still as a test had set it; in the journal
};

struct Notice {
    NoticeCode code = NoticeCode::AlreadySet;
    int id = -1;
    QString key{};
    std::int64_t a = 0;
    std::int64_t b = 0;
    bool operator==(const Notice&) const = default;
};

using Notices = std::vector<Notice>;
} // namespace base

// SPDX-License-Identifier: GPL-3.0-or-later
// Does a servo still turn? Checked before the port closes, because a wheel, PWM or motor command
// continues without the program. Reads only. Errors: those of reading.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace jobs {
enum class Motion : std::uint8_t {
    Rest,
    ToGoal,  ///< ends by itself
    Endless, ///< speed, PWM, current: until the next command
};

base::Result<Motion> readMotion(const device::Context& context, device::Servo& servo);

/// By the latest readings of its moving flag, or of its speed where it has none: a speed command of
/// 0 alone does not stop every servo. The servo has a profile.
bool isTurning(const device::Servo& servo);

/// By the latest readings; Rest where too little has been read. A move to a goal counts only
/// where the servo has a moving flag.
Motion lastKnownMotion(const device::Servo& servo);

/// Its goals are positions that stay where they are: not relative ones, not a speed.
bool isInPositionMode(const device::Servo& servo);

/// NotSupported, reason NotInPositionMode, with the key of the mode.
base::Error notInPositionMode(const QString& operation, const device::Servo& servo);

/// Torque is on and the servo pushes against something: it reports an overload or overcurrent, or
/// rests away from its position goal with a load or current beyond that of holding. By the latest
/// readings. Resting away alone proves nothing, because a servo may hold where its torque was
/// turned on; it counts only where this program gave the goal (`ownGoal`) and no load was read with
/// the position.
bool isJammed(const device::Servo& servo, bool ownGoal);
} // namespace jobs

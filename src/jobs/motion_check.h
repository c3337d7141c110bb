// SPDX-License-Identifier: GPL-3.0-or-later
// Does a servo still turn? Asked before the port closes, since a wheel, PWM or motor command goes
// on without the program. Reads only. Errors: those of reading.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace jobs {
enum class Motion : std::uint8_t {
    Rest,
    ToGoal,  ///< ends by itself
    Endless, ///< speed, PWM, current: until it is told otherwise
};

base::Result<Motion> readMotion(const device::Context& context, device::Servo& servo);

/// As of the latest readings; Rest where too little has been read. A move to a goal counts only
/// where the servo has a moving flag.
Motion lastKnownMotion(const device::Servo& servo);

/// Torque is on and something is in the way: the servo stands away from its position goal, or
/// reports an overload or overcurrent. As of the latest readings.
bool isJammed(const device::Servo& servo);
} // namespace jobs

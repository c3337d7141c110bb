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

/// As of the latest readings, by its flag, or its speed where it has none: a speed command of 0
/// alone does not stop every servo. The servo has a profile.
bool isTurning(const device::Servo& servo);

/// As of the latest readings; Rest where too little has been read. A move to a goal counts only
/// where the servo has a moving flag.
Motion lastKnownMotion(const device::Servo& servo);

/// Torque is on and the servo pushes against something: it reports an overload or overcurrent, or
/// stands away from its position goal with a load or current that is more than holding takes. As of
/// the latest readings. Standing away alone proves nothing, since a servo may hold where its torque
/// was switched on; it counts only where this program gave the goal (`ownGoal`) and no load has
/// been read with the position.
bool isJammed(const device::Servo& servo, bool ownGoal);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out of a servo what waits in it for an ACTION: a held goal is replaced by a held "torque
// off" (Feetech), a stored move by the present place (LX). Turns no shaft. The job's thread; errors
// are those of reading and writing.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// For a servo of which torque is off, or an LX servo that stands still. True: something may still
/// wait.
base::Result<bool> cancelHeldGoal(const Context& context, Servo& servo);

/// For one that has an ACTION flag, whatever its torque: the closing of the EPROM lock, which is
/// closed already, takes the goal's place.
base::Result<bool> discardHeldGoal(const Context& context, Servo& servo);
} // namespace device

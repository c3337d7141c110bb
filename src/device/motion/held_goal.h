// SPDX-License-Identifier: GPL-3.0-or-later
// Removes the goal that waits in a servo for an ACTION: a held goal is replaced by a held "torque
// off" (Feetech), a stored move by the present position (LX). Turns no shaft. The job's thread;
// errors are those of reading and writing.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
/// For a servo whose torque is off, or an LX servo that stands still. True: a goal may still wait.
base::Result<bool> cancelHeldGoal(const Context& context, Servo& servo);

/// For a servo with an ACTION flag, with torque on or off: a held "close the EPROM lock", which is
/// closed already, replaces the goal.
base::Result<bool> discardHeldGoal(const Context& context, Servo& servo);
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
// What "stay here" is in each mode, and switching torque on without moving. Internal to device; the
// job's thread. Errors: those of reading and writing, NotSupported, OutOfRange, TurnsUnknown.
#pragma once

#include "device/transactions.h"

namespace device {
/// The goal with what travels in its frame: an LX angle with time 0, as fast as the servo can.
RegisterValues goalValues(const Servo& servo, const catalog::Register& goal, std::int64_t raw);

/// What keeps the servo where it is, or at a standstill: the present position as the goal, speed,
/// PWM or current 0, a relative move of nothing. Needs settings and present position.
base::Result<RegisterValues> holdValues(const Servo& servo);

/// Makes the mode's command mean "stay" and switches torque on.
base::Result<void> enableTorque(const Context& context, Servo& servo);
} // namespace device

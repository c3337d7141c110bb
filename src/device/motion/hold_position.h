// SPDX-License-Identifier: GPL-3.0-or-later
// The command for "stay here" in each mode, and turning torque on without moving. Internal to
// device; the job's thread. Errors: those of reading and writing, NotSupported, OutOfRange,
// TurnsUnknown.
#pragma once

#include "device/transactions.h"

namespace device {
/// The goal with the registers of its frame: an LX angle with time 0, as fast as the servo can.
RegisterValues goalValues(const Servo& servo, const catalog::Register& goal, std::int64_t raw);

/// The values that keep the servo where it is, or at a standstill: the present position as the
/// goal, speed, PWM or current 0, a relative move of 0. Needs settings and present position.
base::Result<RegisterValues> holdValues(const Servo& servo);

/// Sets the mode's command to "stay" and turns torque on.
base::Result<void> enableTorque(const Context& context, Servo& servo);
} // namespace device

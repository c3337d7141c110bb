// SPDX-License-Identifier: GPL-3.0-or-later
// After an emergency stop: is torque really off, and does anything wait in a servo that an ACTION
// would start? Who is still on is told again, a few times; what waits is replaced by something
// harmless: a held "torque off" (Feetech), the present place (LX). Switches nothing on and turns no
// shaft. Errors: LinkLost, Stopped, Preempted; what a single servo does wrong is in its verdict.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace jobs {
struct StopCheckResult {
    enum class Torque : std::uint8_t { Off, On, Unknown };
    Torque torque = Torque::Unknown;
    bool mayHavePendingGoal = false; ///< a goal may still wait in it
};

/// One verdict a servo, in their order. All answer at the bus' present rate.
base::Result<std::vector<StopCheckResult>>
verifyEmergencyStop(const device::Context& context, const std::vector<device::Servo*>& servos);
} // namespace jobs

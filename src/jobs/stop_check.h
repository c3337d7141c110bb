// SPDX-License-Identifier: GPL-3.0-or-later
// After an emergency stop: is torque really off, and does a goal wait in a servo that an ACTION
// would start? A servo with torque on gets torque off again, a few times; a waiting goal is
// replaced by something harmless: a held "torque off" (Feetech), the present position (LX). Turns
// no torque on and no shaft. Errors: LinkLost, Stopped, Preempted; errors of a single servo are in
// its verdict.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace jobs {
struct StopCheckResult {
    enum class Torque : std::uint8_t { Off, On, Unknown };
    Torque torque = Torque::Unknown;
    bool mayHavePendingGoal = false; ///< a goal may still wait in it
};

/// One verdict per servo, in their order. All answer at the present rate of the bus.
base::Result<std::vector<StopCheckResult>>
verifyEmergencyStop(const device::Context& context, const std::vector<device::Servo*>& servos);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep's hands: goals for all servos at once, and how they are left. Internal to the sweep
// job; its thread.
#pragma once

#include "jobs/sweep/sweep.h"

namespace jobs {
/// Every servo its goal, together where the family can. `targets` become what was really said.
base::Result<void> sendSweepGoals(const device::Context& context,
                                  std::vector<device::Servo>& servos, const record::SweepSpec& spec,
                                  std::vector<double>& targets);

/// How a servo is left.
enum class ServoEndState : std::uint8_t {
    AsRequested, ///< holding, or without torque, as the order says
    TorqueOff,   ///< without torque: it is what ended the test
    Untouched,   ///< it is another one: not written to, but for torque that a goal has given it
};

/// After the last leg or an early end; `how`: one a servo. Does what it can when servos do not
/// answer, and tells SweepCallbacks::onUnreleasedTorque of the rest.
void leaveServosSafe(const device::Context& context, std::vector<device::Servo>& servos,
                     const record::SweepRun& run, const std::vector<ServoEndState>& endStates,
                     const SweepCallbacks& callbacks);
} // namespace jobs

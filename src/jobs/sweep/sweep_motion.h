// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep's hands: goals for all servos at once, and how they are left. Internal to the sweep
// job; its thread.
#pragma once

#include "jobs/sweep/sweep.h"

namespace jobs {
/// Sends every servo its goal, together if the family can. `targets` become the sent values.
base::Result<void> sendSweepGoals(const device::Context& context,
                                  std::vector<device::Servo>& servos,
                                  const results::SweepSpec& spec, std::vector<double>& targets);

/// How a servo is left.
enum class ServoEndState : std::uint8_t {
    AsRequested, ///< holding or without torque, as requested
    TorqueOff,   ///< without torque: this servo ended the test
    Untouched,   ///< it is another one: not written to, but for torque that a goal has given it
};

/// After the last leg or an early end; `how`: one for each servo. Servos that could not be reached
/// are reported to SweepCallbacks::onUnreleasedTorque.
void leaveServosSafe(const device::Context& context, std::vector<device::Servo>& servos,
                     const results::SweepRun& run, const std::vector<ServoEndState>& endStates,
                     const SweepCallbacks& callbacks);
} // namespace jobs

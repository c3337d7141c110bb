// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a joint to both ends of its limits and back, slowly and with little torque, to show that
// the range is free. Torque limit, speed and acceleration are restored at the end, and torque is
// off. The job's thread.
// Errors: those of sweep() and TemporarySettings, Stopped, Preempted (emergency stop),
// NotSupported ("no-position-limits", "no-torque-limit", or not in position mode).
#pragma once

#include "base/arm.h"
#include "device/context.h"
#include "device/servo.h"

#include <functional>

namespace jobs {
constexpr int defaultTestTorque = 30; ///< % of the stall torque
constexpr int minTestTorque = 5;

struct MoveTestReport {
    base::MoveTestState state = base::MoveTestState::Reached;
    std::int64_t position = 0; ///< in steps: where it stands now
    std::int64_t goal = 0;     ///< where it was to go; not meaningful when Reached
};
using MoveTestFn = std::function<void(const MoveTestReport&)>;

/// `servo`: with its calibration read (readJoint()). `onMove` while it moves, with the state
/// Moving.
base::Result<MoveTestReport> testMoves(const device::Context& context, device::Servo& servo,
                                       int torquePercent, const MoveTestFn& onMove = {});
} // namespace jobs

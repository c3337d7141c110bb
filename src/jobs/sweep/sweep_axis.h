// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep test in the terms of one servo, and whether it can be run at all: everything that forbids
// it is told before anything moves. Reads settings, writes nothing. Internal to the sweep job and
// to whoever proposes one; the job's thread.
// Errors, operation "sweep", by detail: BadArgument same-ends, no-step, negative-step,
// step-too-long, no-points, no-pause, no-end, no-period, no-number KEY; NotSupported not-position
// (the mode); OutOfRange (the servo's own limits; registerKey is the goal's); those of reading.
#pragma once

#include "device/motion/motion.h"
#include "results/sweep_limits.h"
#include "results/sweep_spec.h"

namespace jobs {
base::Result<results::SweepAxis> sweepAxis(const device::Context& context, device::Servo& servo,
                                           const results::SweepSpec& spec,
                                           const results::SweepLimits& limits);

/// The order of a move to `target` (steps of the feedback). Its goal is the nearest the register
/// can say; `target` becomes that.
device::MoveCommand makeSweepMove(device::Servo& servo, const results::SweepSpec& spec,
                                  double& target);

/// Of a position unit or a rate of one in steps: "deg", "rpm", "step/s"; nullopt: no known unit.
std::optional<double> toSteps(double physical, const QString& unit, double stepsPerTurn);
/// Steps of a turn of its position feedback.
double stepsPerTurn(const device::Servo& servo);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// A test that ended because its servos could not be heard: says so where the line is there, but
// never falls silent. Main thread; asks the servo once.
#pragma once

#include "cli/output/console.h"
#include "device/context.h"
#include "device/servo.h"
#include "results/sweep_run.h"

namespace cli {
void explainBusyLine(Console& console, const device::Context& context, const device::Servo& servo,
                     record::SweepEnd end);
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// A hint for a test that ended because its servos did not reply, if the line is connected but never
// silent. Main thread; sends one request to the servo.
#pragma once

#include "cli/output/console.h"
#include "device/context.h"
#include "device/servo.h"
#include "results/sweep_run.h"

namespace cli {
void explainBusyLine(Console& console, const device::Context& context, const device::Servo& servo,
                     results::SweepEnd end);
} // namespace cli

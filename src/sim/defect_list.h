// SPDX-License-Identifier: GPL-3.0-or-later
// What may be said behind a servo in a list: "+overshoot=5+rest-hysteresis=12". Pure functions; any
// thread. BadArgument names the word it did not know or the figure that cannot be.
#pragma once

#include "base/error.h"
#include "sim/servo_maker.h"

#include <QStringList>

namespace sim {
/// Each "NAME=VALUE", said once: rest-hysteresis, static-error, overshoot, speed, speed-per-load,
/// noise, moving (0 or 1: the flag is stuck), load-friction (N·m), stop (degrees), supply-ohms,
/// ambient (°C).
base::Result<void> addDefects(ServoRecipe& recipe, const QStringList& words);

QStringList defectNames();
} // namespace sim

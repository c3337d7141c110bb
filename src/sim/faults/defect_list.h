// SPDX-License-Identifier: GPL-3.0-or-later
// The defects that follow a servo in a list, "+overshoot=5+deaf=1", or a preset for all of its
// servos. Pure functions; any thread. BadArgument names the unknown name or the impossible value.
#pragma once

#include "base/error.h"
#include "sim/servo/servo_spec.h"

#include <QStringList>

namespace sim {
/// Each "NAME=VALUE", at most once: rest-hysteresis, static-error, overshoot, speed,
/// speed-per-load, noise, moving (0 or 1: the flag is stuck), load-friction (N·m), stop (degrees),
/// supply-ohms, ambient (°C). And how its firmware behaves (FirmwareBehavior), 0 or 1: deaf,
/// new-id-reply, run-to-goal, late-baud, staggered-ping; eprom-ms: time of an EPROM write.
base::Result<void> addDefects(ServoSpec& servoSpec, const QStringList& words);

QStringList defectOptionNames();
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// The values a servo leaves the factory with: its identity, the defaults of the register sheet, and
// a typical value where no sheet states one. Pure function; any thread; cannot fail.
#pragma once

#include "sim/servo/memory.h"
#include "sim/servo/servo_types.h"

namespace sim {
struct ServoConfig;

void fillFactoryValues(Memory& memory, const ServoModel& model, const ServoConfig& config);
} // namespace sim

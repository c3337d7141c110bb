// SPDX-License-Identifier: GPL-3.0-or-later
// Reads limits that are part of a larger document (a stored sweep run). Faults go to the
// reader's error. Pure; any thread.
#pragma once

#include "files/json_reader.h"
#include "results/sweep_limits.h"

namespace results {
/// Without lines they are allowed here: a test may have been run without limits.
SweepLimits readSweepLimits(const files::JsonReader& json);
} // namespace results

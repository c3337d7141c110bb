// SPDX-License-Identifier: GPL-3.0-or-later
// Reads limits that are part of a larger document (a stored sweep run). What is wrong goes to the
// reader's complaint. Pure; any thread.
#pragma once

#include "files/json_reader.h"
#include "results/sweep_limits.h"

namespace record {
/// Without lines they are allowed here: a test may have been run without limits.
SweepLimits readSweepLimits(const JsonReader& json);
} // namespace record

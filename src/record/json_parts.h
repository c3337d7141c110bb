// SPDX-License-Identifier: GPL-3.0-or-later
// Documents that are files of their own and parts of a larger one, read from where they stand
// there. What is wrong goes to the reader's complaint. Pure; any thread.
#pragma once

#include "record/json_reader.h"
#include "record/snapshot.h"
#include "record/sweep_limits.h"

namespace record {
Snapshot readSnapshot(const JsonReader& json);

/// Without lines they are allowed here: a test may have been run without limits.
SweepLimits readSweepLimits(const JsonReader& json);
} // namespace record

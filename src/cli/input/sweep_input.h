// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the command "sweep". Main thread. BadArgument says what an option accepts; the
// files that they name fail as in results/sweep_points.h and sweep_limits.h.
#pragma once

#include "cli/command.h"
#include "results/sweep_limits.h"
#include "results/sweep_spec.h"

namespace cli {
std::vector<Option> sweepOptions();
base::Result<results::SweepSpec> sweepSpec(const Values& values);
/// The limits in the file of --limits; none: the built-in limits.
base::Result<std::optional<results::SweepLimits>> sweepLimits(const Values& values);

// Options that are numbers. Errors name the option and what it accepts. nullopt: not given.
base::Result<std::optional<int>> intOption(const Values& values, const char* flag, int min,
                                           int max);
base::Result<std::optional<base::Duration>> secondsOption(const Values& values, const char* flag,
                                                          double min, double max);
/// A speed or acceleration as typed; empty: not given. Its maximum depends on the servo, but
/// negative values are never valid.
base::Result<QString> nonNegativeOption(const Values& values, const char* flag);
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the command "sweep" as a test. Pure but for the files they name; main thread.
// BadArgument says what an option takes; files fail as record/sweep_points.h and sweep_limits.h
// say.
#pragma once

#include "cli/command.h"
#include "results/sweep_limits.h"
#include "results/sweep_spec.h"

namespace cli {
std::vector<Option> sweepOptions();
base::Result<record::SweepSpec> sweepSpec(const Values& values);
/// The user's file; none: the built-in ones are meant.
base::Result<std::optional<record::SweepLimits>> sweepLimits(const Values& values);

// Numbers of the tests' options; errors name the option and what it takes. nullopt: not given.
base::Result<std::optional<int>> intOption(const Values& values, const char* flag, int min,
                                           int max);
base::Result<std::optional<base::Duration>> secondsOption(const Values& values, const char* flag,
                                                          double min, double max);
/// A speed or the like as it was typed, empty where it was not: the servo's register says how much
/// is possible, but below 0 is nonsense of any.
base::Result<QString> nonNegativeOption(const Values& values, const char* flag);
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// From legs to the figures of a run and their grades. Pure; any thread. A target is what was aimed
// at more than once, to a tenth of a step; hysteresis is the difference between coming to it from
// below and from above, as the servo reports it (play behind its encoder is not in it).
// Judged values: the worst leg for errors, overshoot, settling, current, load; the mean for speeds
// and time to target; sums for what is counted.
#pragma once

#include "record/sweep_run.h"

namespace jobs {
/// In the order of record::sweepMetricKinds(), all of them. `startCelsius`: the temperature before
/// the first leg.
std::vector<record::SweepMetric> sweepMetrics(const std::vector<record::SweepLeg>& legs,
                                              const record::SweepErrors& errors,
                                              std::optional<double> startCelsius);

/// A line a limit. A value that is not a number fails.
std::vector<record::VerdictLine> judge(const std::vector<record::SweepMetric>& metrics,
                                       const record::SweepLimits& limits);
/// Fail before Warn before Pass; NotMeasured when no line was measured.
record::Grade worst(const std::vector<record::VerdictLine>& lines);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// From legs to the figures of a run and their grades. Pure; any thread.
// SweepMetric::value, the one that is judged, is
//   the mean of the legs   time to target, speeds
//   the worst leg          settling, overshoot, following error, current, load, voltage (lowest),
//                          temperature; steady error: the largest without its sign
//   the worst target       hysteresis, repeatability
//   a number               legs: missed targets, moving flag errors, alarms (legs with a status
//                          bit); communication errors of all kinds, of so many questions
// mean, min and max are those of the legs (steady errors with their sign) or of the targets;
// numbers have none. `count` is of what was measured: legs, targets, questions.
// A target is what was aimed at, to a tenth of a step, in legs that came to rest (they have a
// steady error). Hysteresis: the difference between the mean places of rest after coming to it from
// below and from above, without its sign, as the servo reports it (play behind its encoder is not
// in it). Repeatability: σ (n − 1) and range of the places of rest after at least two approaches
// from the same side, so that hysteresis is not in it; of the two sides the worse one.
// Of a sine no leg has a target, and none is missed. A value that is not a number stays one.
#pragma once

#include "record/sweep_run.h"

namespace jobs {
/// In the order of record::sweepMetricKinds(), all of them. `startCelsius`: the temperature before
/// the first leg.
std::vector<record::SweepMetric> sweepMetrics(const std::vector<record::SweepLeg>& legs,
                                              const record::SweepErrors& errors,
                                              std::optional<double> startCelsius);

/// A line a limit: Fail before Warn; exactly on the limit is still good; a limit without `fail`
/// only warns. What was not measured is NotMeasured; a value that is not a number fails.
std::vector<record::VerdictLine> judge(const std::vector<record::SweepMetric>& metrics,
                                       const record::SweepLimits& limits);
/// Fail before Warn before Pass; NotMeasured when no line was measured.
record::Grade worst(const std::vector<record::VerdictLine>& lines);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// From legs to the figures of a run; results/sweep_verdict.h grades them. Pure; any thread.
// SweepMetric::value, the one that is evaluated, is
//   the mean of the legs   time to target, speeds
//   the worst leg          settling, overshoot, following error, current, load, voltage (lowest),
//                          temperature; steady error: the largest without its sign
//   the worst target       hysteresis, repeatability
//   a number               legs: missed targets (of those with moves that prove an arrival, see
//                          results/sweep_verdict.h), moving flag errors, alarms (legs with a status
//                          bit); communication errors of all kinds, of so many questions
// mean, min and max are those of the legs (steady errors with their sign) or of the targets;
// numbers have none. `count` is of what was measured: legs, targets, questions.
// A target is what was aimed at, to a tenth of a step, in legs that came to rest (they have a
// steady error). Hysteresis: the difference between the mean places of rest after coming to it from
// below and from above, without its sign, as the servo reports it (play behind its encoder is not
// in it). Repeatability: σ (n − 1) and range of the places of rest after at least two approaches
// from the same side, so that hysteresis is not in it; of the two sides the worse one.
// Of a sine no leg has a target, and none is missed. A value that is not a number stays one.
// Relative following error: of a sine % of its amplitude, of random targets % of the range. Phase
// lag: the worst leg, by its magnitude. Both of a sine only in legs with half the readings of
// results::minReadingsPerPeriod. Readings per period: the leg with the fewest.
#pragma once

#include "results/sweep_verdict.h"

namespace jobs {
/// What the following error is relative to; nullopt: it is not evaluated.
struct ReferencePath {
    std::optional<double> scale{}; ///< results::followingScale()
    bool isSine = false;
    double tolerance = 0; ///< of a reached target, steps
};

/// In the order of results::sweepMetricKinds(), all of them. `startCelsius`: the temperature before
/// the first leg.
std::vector<results::SweepMetric> sweepMetrics(const std::vector<results::SweepLeg>& legs,
                                               const results::SweepErrors& errors,
                                               std::optional<double> startCelsius,
                                               const ReferencePath& path = {});

ReferencePath referencePath(const results::SweepSpec& spec, const results::SweepAxis& axis);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of one step response. Time to target, settling, overshoot, steady error and the peaks
// of current and load are those of its leg, as leg_meter.h defines them; besides, from its readings
//   dead time:   until it has gone 3 steps or 1 % of the way, whatever is more, and stays beyond
//   rise time:   from 10 to 90 % of the way from where it stood to the target, each when it was
//                first there; not measured without a reading in between
//   swings:      how often it turned round after it had first come within tolerance, each time by
//                more than its noise: 6 steps, or eight times the scatter of its readings about
//                a smooth curve. An overshoot and the return are one
//   frequency:   of three swings or more, from the first to the last
//   amplitude:   of two or more, half of the longest way between two of them
//   peak speed:  the leg's top speed; on shorter ways the speed that the servo reports
// A response whose motion was not seen throughout has no times, swings and speeds, nor an
// overshoot. Crossings are interpolated, but not across more than 50 ms. Pure; any thread.
#pragma once

#include "results/step_run.h"

namespace jobs {
results::StepFigures measureStep(const std::vector<results::StepSample>& samples,
                                 const results::SweepLeg& leg);

/// Until it had settled (`end`, if it never did) no two readings were further apart than 50 ms, or
/// than four times the usual distance in this response if that is more; never 300 ms.
bool isFullySampled(const std::vector<results::StepSample>& samples, const results::SweepLeg& leg,
                    base::Duration end);

/// Removes the figures of a response that was not seen throughout.
void clearMotionFigures(results::StepFigures& figures);
} // namespace jobs

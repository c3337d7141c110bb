// SPDX-License-Identifier: GPL-3.0-or-later
// What to try next after a step-response run, by the fault table of the vendor's tutorial: it lags
// → P, or the limits of speed and acceleration; overshoot → D; rests beside its target → I in small
// steps, a smaller dead zone; jitter → I 0, less D, less startup force, a larger dead zone; strong
// oscillation → P back to the stored one. Uses the means of the run, as far as they were measured;
// the worst problem comes first. Each advice is one small step inside the register's range, and
// there is none without room for it. Without a movement there is no advice on gains. Pure; any
// thread.
//   not seen     readings were missing in the motion of one or more
//   no motion    in no response it went further towards its target than noise goes
//   blocked      stood still in the last quarter of a response, further from its target than
//                friction and load may leave (1/64 turn)
//   oscillation  turned round four times or more, by more than the tolerance
//   jitter       as often, by less
//   overshoot    above 2 % of the way and twice the noise of leg_meter.h
//   lag          was never there, or took longer for the last 10 % than for the 80 % before
//   speed limit  was requested and reached
//   static error of two steps or more, where it stands still and did not overshoot
#pragma once

#include "catalog/catalog.h"
#include "results/step_run.h"

namespace jobs {
std::vector<results::StepAdvice> adviseStep(const results::StepRun& run,
                                            const catalog::Profile& profile);

/// Whether an earlier one of these runs has measured what is advised on the last one: completely,
/// on the same servo, with the same step and the same gains. Advice must not go in circles.
bool wasMeasured(const results::StepAdvice& advice, const std::vector<results::StepRun>& runs);

/// By the model and firmware that the run names. Null for a model that the catalog does not know.
catalog::ProfilePtr profileOf(const results::StepRun& run, const catalog::Catalog& catalog);

/// For a run from a file or from the history. None for a model that the catalog does not know.
std::vector<results::StepAdvice> adviseStoredStep(const results::StepRun& run,
                                                  const catalog::Catalog& catalog);
} // namespace jobs

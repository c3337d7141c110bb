// SPDX-License-Identifier: GPL-3.0-or-later
// What to try next after a step-response run, as the advice on faults has it (facts of the vendor's
// tutorial): it lags → P, or the limits of speed and acceleration; overshoot → D; rests beside its
// target → I in small steps, a smaller dead zone; jitter → I 0, less D, less startup force, a
// larger dead zone; strong oscillation → P back to the stored one. By the means of the run, of what
// was measured; the worst first. Each proposes one small step inside the register's range, and none
// where there is no room. Of a servo that never moved no gain is known. Pure; any thread.
//   not seen     readings were missing in the motion of one or more
//   no motion    in no response it went further towards its target than noise goes
//   blocked      stood still in the last quarter of a response, further from its target than
//                friction and load may leave (1/64 turn)
//   oscillation  turned round four times or more, by more than the tolerance
//   jitter       as often, by less
//   overshoot    above 2 % of the way and twice the noise of leg_meter.h
//   lag          was never there, or took longer for the last 10 % than for the 80 % before
//   speed limit  was asked for, and reached
//   static error of two steps or more, where it stands still and did not overshoot
#pragma once

#include "catalog/profile.h"
#include "results/step_run.h"

namespace jobs {
std::vector<record::StepAdvice> adviseStep(const record::StepRun& run,
                                           const catalog::Profile& profile);
} // namespace jobs

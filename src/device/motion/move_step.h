// SPDX-License-Identifier: GPL-3.0-or-later
// Relative moves (step mode), which must never be taken twice: what tells whether one was taken,
// and how a lost answer is settled. Internal to device; the job's thread. Errors: those of reading
// and writing, Uncertain.
#pragma once

#include "device/motion/move_blocks.h"

namespace device {
/// What tells, after a lost answer, whether a relative move was taken.
struct StepState {
    std::optional<std::int64_t> goal, remaining, moving, active;
    bool operator==(const StepState&) const = default;
};

/// The goal register must differ from the step to come, or a lost answer could not be judged later.
/// A relative move of nothing is harmless and may be repeated.
base::Result<StepState> prepareRelativeMove(const Context& context, MovePlan& plan);

/// A relative move whose answer was lost (or never comes, at response level 0): the state is read,
/// then decided. Never sent twice on suspicion.
base::Result<void> confirmStep(const Context& context, MovePlan& plan, const Block& block,
                               const StepState& before, bool lost);
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
// Relative moves (step mode), which must never be made twice: how to find out whether one was made,
// also after a lost reply. Internal to device; the job's thread. Errors: those of reading
// and writing, Uncertain.
#pragma once

#include "device/motion/move_blocks.h"

namespace device {
/// The state that shows, after a lost reply, whether a relative move was made.
struct StepState {
    std::optional<std::int64_t> goal, remaining, moving, active;
    bool operator==(const StepState&) const = default;
};

/// The goal register must differ from the next step, or a lost reply could not be resolved later. A
/// relative move of 0 is harmless and may be repeated.
base::Result<StepState> prepareRelativeMove(const Context& context, MovePlan& plan);

/// A relative move whose reply was lost (or never comes, at response level 0): the state is read to
/// decide. It is never sent twice without proof.
base::Result<void> confirmStep(const Context& context, MovePlan& plan, const Block& block,
                               const StepState& before, bool lost);
} // namespace device

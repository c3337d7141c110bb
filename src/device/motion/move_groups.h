// SPDX-License-Identifier: GPL-3.0-or-later
// Moves that start together: sync packets, held writes, stored moves. Internal to device; the job's
// thread. Errors: those of reading and writing, NotSupported before the first byte.
#pragma once

#include "device/motion/move_blocks.h"

namespace device {
/// The plans, grouped by the way in which they start together with the others.
struct MoveGroups {
    Plans packets; ///< sync write
    Plans held;    ///< REG WRITE and ACTION
    Plans stored;  ///< a stored move and its start
};

/// NotSupported ("no-sync", "no-async") when one of them has no way to start with others.
base::Result<MoveGroups> groupMoves(std::vector<MovePlan>& plans, MoveMethod how);

base::Result<void> sendSimultaneously(const Context& context, const MoveGroups& groups);

/// The parts of a common start: each goal waits in its servo; all of them are started; or all are
/// removed.
base::Result<void> sendAsyncGoals(const Context& context, const MoveGroups& groups);
base::Result<void> startGoals(const Context& context, const MoveGroups& groups);
base::Result<void> cancelGoals(const Context& context, const MoveGroups& groups);
/// After a hold or a start that failed and is not repeated: an ACTION of any program must not start
/// the move, so waiting goals are removed, with torque on or off. Fails with `error`, or with the
/// servo in which a goal may still wait.
base::Result<void> cancelAfterFailure(const Context& context, const Plans& plans,
                                      base::Error error);

/// One request whose reply is only an acknowledgement.
base::Result<void> sendRequest(const Context& context, protocol::Request request);

/// The blocks that come before the goal's.
base::Result<void> sendSettings(const Context& context, MovePlan& plan,
                                const std::vector<Block>& blocks);
} // namespace device

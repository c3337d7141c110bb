// SPDX-License-Identifier: GPL-3.0-or-later
// What MotionController executes on the job thread. Each function serves the task's own servo and
// its others, in their order. Internal to MotionController; errors are those of
// device/motion/motion.h and device/writer.h.
#pragma once

#include "session/motion/motion_controller.h"

namespace session {
/// A request, and the state of the servos when it was made.
struct MoveJob {
    struct Expected {
        QString mode; ///< empty: not known
        std::int64_t totalSteps = 0;
    };
    MoveRequest request;
    base::Duration maxSettingsAge{};
    std::vector<Expected> expected;
};

/// Plans all, then sends. `plans` is what went out, without servo pointers.
base::Result<void> sendMove(TaskContext& context, const MoveJob& job,
                            std::vector<device::MovePlan>& plans);
base::Result<void> startHeldGoals(TaskContext& context, std::vector<device::MovePlan>& plans);

/// These go on with the others when one fails, and return the first error.
base::Result<void> setTorqueAll(TaskContext& context, device::Torque torque);
base::Result<void> haltAll(TaskContext& context);

struct ModeJob {
    QString mode;
    std::vector<std::optional<device::MovePlan>> held; ///< goals of ours that wait in the servos
};
base::Result<void> switchModeAll(TaskContext& context, const ModeJob& job);
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/move_step.h"

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
base::Result<StepState> readStepState(const Context& context, Servo& servo)
{
    const auto done =
        readRoles(context, servo,
                  {Role::GoalPosition, Role::PresentPosition, Role::Moving, Role::ActiveGoal});
    if (!done)
        return tl::unexpected(done.error());
    return StepState{servo.raw(Role::GoalPosition), servo.raw(Role::PresentPosition),
                     servo.raw(Role::Moving), servo.raw(Role::ActiveGoal)};
}

} // namespace

base::Result<StepState> prepareRelativeMove(const Context& context, MovePlan& plan)
{
    Servo& servo = *plan.servo;
    auto before = readStepState(context, servo);
    if (!before || before->goal != plan.goalRaw || before->moving == 1 || plan.goalRaw == 0)
        return before;
    const catalog::Register& goal = *servo.profile->byRole(Role::GoalPosition);
    if (const auto zeroed = writeVerified(context, servo, goal, 0); !zeroed)
        return tl::unexpected(zeroed.error());
    return readStepState(context, servo);
}

namespace {
enum class StepTaken { Yes, No, Unclear };

base::Result<StepTaken> wasStepTaken(const Context& context, const MovePlan& plan,
                                     const StepState& before)
{
    const auto now = readStepState(context, *plan.servo);
    if (!now)
        return tl::unexpected(now.error());
    if (before.goal != plan.goalRaw)
        return now->goal == plan.goalRaw ? StepTaken::Yes : StepTaken::No;
    return *now == before ? StepTaken::Unclear : StepTaken::Yes;
}

} // namespace

base::Result<void> confirmStep(const Context& context, MovePlan& plan, const Block& block,
                               const StepState& before, bool lost)
{
    constexpr int sendCount = 3;
    for (int sent = 1;; ++sent) {
        const auto taken = wasStepTaken(context, plan, before);
        if (!taken)
            return tl::unexpected(taken.error());
        if (*taken == StepTaken::Yes) {
            if (lost)
                context.note(NoticeCode::ReplyLostButWritten, plan.servo->id);
            return {};
        }
        if (*taken == StepTaken::Unclear || sent >= sendCount) {
            return tl::unexpected(base::Error{*taken == StepTaken::Unclear ? ErrorCode::Uncertain
                                                                           : ErrorCode::NoReply,
                                              QStringLiteral("move"),
                                              {},
                                              plan.servo->id,
                                              {},
                                              sent});
        }
        noteResent(context, *plan.servo, lost);
        const auto again = writeBlock(context, *plan.servo, block.patch, protocol::Repeat::Never);
        lost = !again;
        if (again && plan.servo->repliesToWrites())
            return {};
        if (!again && !isReplyLost(again.error()))
            return again;
    }
}
} // namespace device

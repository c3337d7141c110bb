// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/move_step.h"

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
base::Result<StepEvidence> readEvidence(const Context& context, Servo& servo)
{
    const auto done =
        readRoles(context, servo,
                  {Role::GoalPosition, Role::PresentPosition, Role::Moving, Role::ActiveGoal});
    if (!done)
        return tl::unexpected(done.error());
    return StepEvidence{servo.raw(Role::GoalPosition), servo.raw(Role::PresentPosition),
                        servo.raw(Role::Moving), servo.raw(Role::ActiveGoal)};
}

} // namespace

base::Result<StepEvidence> prepareStep(const Context& context, MovePlan& plan)
{
    Servo& servo = *plan.servo;
    auto before = readEvidence(context, servo);
    if (!before || before->goal != plan.goalRaw || before->moving == 1 || plan.goalRaw == 0)
        return before;
    const catalog::Register& goal = *servo.profile->byRole(Role::GoalPosition);
    if (const auto zeroed = writeVerified(context, servo, goal, 0); !zeroed)
        return tl::unexpected(zeroed.error());
    return readEvidence(context, servo);
}

namespace {
enum class Taken { Yes, No, Unclear };

base::Result<Taken> wasTaken(const Context& context, const MovePlan& plan,
                             const StepEvidence& before)
{
    const auto now = readEvidence(context, *plan.servo);
    if (!now)
        return tl::unexpected(now.error());
    if (before.goal != plan.goalRaw)
        return now->goal == plan.goalRaw ? Taken::Yes : Taken::No;
    return *now == before ? Taken::Unclear : Taken::Yes;
}

} // namespace

base::Result<void> settleStep(const Context& context, MovePlan& plan, const Block& block,
                              const StepEvidence& before, bool lost)
{
    constexpr int sends = 3;
    for (int sent = 1;; ++sent) {
        const auto taken = wasTaken(context, plan, before);
        if (!taken)
            return tl::unexpected(taken.error());
        if (*taken == Taken::Yes) {
            if (lost)
                context.note(NoticeCode::AnswerLostButDone, plan.servo->id);
            return {};
        }
        if (*taken == Taken::Unclear || sent >= sends) {
            return tl::unexpected(
                base::Error{*taken == Taken::Unclear ? ErrorCode::Uncertain : ErrorCode::NoAnswer,
                            QStringLiteral("move"),
                            {},
                            plan.servo->id,
                            {},
                            sent});
        }
        noteSentAgain(context, *plan.servo, lost);
        const auto again = writeBlock(context, *plan.servo, block.patch, protocol::Repeat::Never);
        lost = !again;
        if (again && plan.servo->answersWrites())
            return {};
        if (!again && !answerLost(again.error()))
            return again;
    }
}
} // namespace device

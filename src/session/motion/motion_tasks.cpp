// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/motion/motion_tasks.h"

namespace session {
using base::ErrorCode;
using device::GoalKind;
using device::MovePlan;

namespace {
std::vector<device::Servo*> allOf(TaskContext& context)
{
    std::vector<device::Servo*> servos{&context.servo};
    servos.insert(servos.end(), context.otherServos.begin(), context.otherServos.end());
    return servos;
}

/// A plan outlives the task's copies of the servos.
void pointTo(std::vector<MovePlan>& plans, const std::vector<device::Servo*>& servos)
{
    for (std::size_t i = 0; i < plans.size(); ++i)
        plans[i].servo = i < servos.size() ? servos[i] : nullptr;
}

/// A goal in degrees means the same with one turn or several.
bool isSameGoalKind(std::optional<GoalKind> a, std::optional<GoalKind> b)
{
    const auto plain = [](std::optional<GoalKind> kind) {
        return kind == GoalKind::Turns ? GoalKind::Position : kind;
    };
    return plain(a) == plain(b);
}

base::Result<void> checkBudget(const MovePlan& plan, const MoveJob::Expected& expected)
{
    if (!plan.relative)
        return {};
    const std::int64_t remainingSteps =
        device::remainingSteps(expected.totalSteps, plan.goalRaw > 0);
    if (std::abs(plan.goalRaw) <= remainingSteps)
        return {};
    return base::fail(ErrorCode::Refused, QStringLiteral("move"), QStringLiteral("too-many-turns"),
                      plan.servo->id);
}

base::Result<MovePlan> planFor(const device::Context& context, device::Servo& servo,
                               const MoveJob& job, const MoveJob::Expected& expected)
{
    if (!servo.profile)
        return base::fail(ErrorCode::UnknownModel, QStringLiteral("move"), {}, servo.id);
    if (servo.mode() == nullptr) {
        if (const auto known = device::readSettings(context, servo); !known)
            return tl::unexpected(known.error());
    }
    const MoveRequest& request = job.request;
    const device::MoveFieldSet fields = device::moveFields(servo);
    device::MoveCommand moveOrder{&servo, request.goal};
    moveOrder.maxSettingsAge = job.maxSettingsAge;
    moveOrder.mode = expected.mode;
    if (fields.speed)
        moveOrder.speed = request.speed;
    if (fields.acceleration)
        moveOrder.acceleration = request.acceleration;
    if (fields.time && !moveOrder.speed)
        moveOrder.time = request.time;
    if (fields.current)
        moveOrder.current = request.current;
    auto plan = device::planMove(context, moveOrder);
    if (!plan)
        return plan;
    if (const auto fits = checkBudget(*plan, expected); !fits)
        return tl::unexpected(fits.error());
    return plan;
}

/// Runs it for every servo; the first error counts.
template <typename Action>
base::Result<void> forAll(TaskContext& context, Action&& action)
{
    base::Result<void> all;
    std::size_t index = 0;
    for (device::Servo* servo : allOf(context)) {
        auto done = action(*servo, index++);
        if (!done && all)
            all = done;
        // The user's stop and a lost link end it for all servos.
        if (!done &&
            (done.error().code == ErrorCode::Preempted || done.error().code == ErrorCode::Stopped ||
             done.error().code == ErrorCode::LinkLost))
            break;
    }
    return all;
}

base::Result<void> verdict(const device::WriteReport& report)
{
    if (report.isSuccessful())
        return {};
    for (const device::WriteResult& write : report.writes) {
        if (write.error)
            return tl::unexpected(*write.error);
    }
    const bool open =
        report.lock == device::LockState::Open || report.lock == device::LockState::Unknown;
    return base::fail(open ? ErrorCode::LockOpen : ErrorCode::Refused, QStringLiteral("mode"), {},
                      report.id);
}
} // namespace

base::Result<void> sendMove(TaskContext& context, const MoveJob& job, std::vector<MovePlan>& plans)
{
    const auto servos = allOf(context);
    for (std::size_t i = 0; i < servos.size(); ++i) {
        auto plan = planFor(context.device, *servos[i], job, job.expected[i]);
        if (!plan)
            return tl::unexpected(plan.error());
        if (!isSameGoalKind(device::goalKind(*servos[i]), device::goalKind(*servos.front()))) {
            return base::fail(ErrorCode::NotSupported, QStringLiteral("move"),
                              QStringLiteral("other-mode"), servos[i]->id);
        }
        plans.push_back(std::move(*plan));
    }
    const auto sent = job.request.how == device::MoveMethod::Async
                          ? device::sendAsyncMoves(context.device, plans)
                          : device::sendMoves(context.device, plans, job.request.how);
    pointTo(plans, {});
    return sent;
}

base::Result<void> startHeldGoals(TaskContext& context, std::vector<MovePlan>& plans)
{
    pointTo(plans, allOf(context));
    const auto started = device::startAsyncMoves(context.device, plans);
    pointTo(plans, {});
    return started;
}

base::Result<void> setTorqueAll(TaskContext& context, device::Torque torque)
{
    return forAll(context, [&](device::Servo& servo, std::size_t) {
        return device::setTorque(context.device, servo, torque);
    });
}

base::Result<void> haltAll(TaskContext& context)
{
    base::Result<void> all;
    for (auto& halted : device::haltAll(context.device, allOf(context))) {
        if (!halted && all)
            all = std::move(halted);
    }
    return all;
}

base::Result<void> switchModeAll(TaskContext& context, const ModeJob& job)
{
    return forAll(context, [&](device::Servo& servo, std::size_t index) -> base::Result<void> {
        // A goal that waits there would be started in a mode it was not meant for.
        if (job.held[index]) {
            const auto off = device::setTorque(context.device, servo, device::Torque::Off);
            if (!off)
                return off;
            std::vector<MovePlan> held{*job.held[index]};
            pointTo(held, {&servo});
            if (const auto forgotten = device::cancelAsyncMoves(context.device, held); !forgotten)
                return forgotten;
        }
        const auto report = device::switchMode(context.device, servo, job.mode);
        if (!report)
            return tl::unexpected(report.error());
        return verdict(*report);
    });
}
} // namespace session

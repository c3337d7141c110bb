// SPDX-License-Identifier: GPL-3.0-or-later
// Goals that wait in their servos, and their start.
#include "device/motion/held_goal.h"
#include "device/motion/move_groups.h"
#include "device/write_check.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
base::Result<bool> hasPendingGoal(const Context& context, Servo& servo)
{
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    if (flag == nullptr)
        return false;
    return readRegister(context, servo, *flag).map([](std::int64_t raw) { return raw == 1; });
}

base::Result<void> sendAsyncGoal(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    const auto before = hasPendingGoal(context, servo);
    if (!before)
        return tl::unexpected(before.error());
    auto request = protocol::Request::regWrite(servo.id, block.patch.writeOffset, block.patch.data,
                                               protocol::Repeat::Safe);
    request.acknowledged = servo.repliesToWrites();
    const bool acknowledged = request.acknowledged;
    plan.held = true;
    const auto held = sendRequest(context, std::move(request));
    if (!held && !isReplyLost(held.error()))
        return held;
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    if (flag == nullptr)
        return {};
    const auto pending = hasPendingGoal(context, servo);
    if (!pending)
        return tl::unexpected(pending.error());
    const bool accepted = held.has_value() && acknowledged;
    plan.held = *pending;
    // The flag shows whether it is held, so a lost reply does not matter; unless another goal was
    // waiting there before, for which the flag is set as well.
    if (*pending && (accepted || !*before))
        return {};
    const ErrorCode code = *pending ? ErrorCode::Uncertain : ErrorCode::Refused;
    return tl::unexpected(base::Error{code, QStringLiteral("reg-write"), {}, servo.id, flag->key});
}

base::Result<void> startAsync(const Context& context, const Plans& plans)
{
    if (plans.empty())
        return {};
    constexpr int sendCount = 3;
    // A single servo is addressed: others may still hold a goal of another program.
    const Servo& first = *plans.front()->servo;
    protocol::Request start =
        plans.size() == 1 ? protocol::Request::action(first.id) : protocol::Request::action();
    start.acknowledged = plans.size() == 1 && first.repliesToWrites();
    int waiting = -1;
    for (int sent = 0; sent < sendCount; ++sent) {
        // The flag below shows the result.
        const auto result = sendRequest(context, start);
        if (!result && !isReplyLost(result.error()))
            return result;
        waiting = -1;
        for (MovePlan* plan : plans) {
            const auto pending = hasPendingGoal(context, *plan->servo);
            if (!pending)
                return tl::unexpected(pending.error());
            plan->held = *pending;
            if (*pending && waiting < 0)
                waiting = plan->servo->id;
        }
        // A flag still set proves that this servo has not received the ACTION; the others hold
        // nothing any more, so a second one moves only this servo.
        if (waiting < 0)
            return {};
    }
    return base::fail(ErrorCode::Refused, QStringLiteral("action"), {}, waiting);
}

base::Result<void> sendAllAsync(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto blocks = blocksOf(*plan);
        if (const auto sent = sendSettings(context, *plan, blocks); !sent)
            return sent;
        if (const auto held = sendAsyncGoal(context, *plan, blocks.back()); !held)
            return held;
    }
    return {};
}

/// Some models never report what they store; the others must show it.
base::Result<void> storeMove(const Context& context, Servo& servo, std::int64_t goal,
                             base::Duration travelTime)
{
    RegisterValues stored{{servo.profile->byRole(Role::StoredGoal), goal}};
    if (const catalog::Register* time = servo.profile->byRole(Role::StoredTime))
        stored.push_back({time, travelTime / std::chrono::milliseconds(1)});
    const Patch patch = patchOf(servo, stored);
    constexpr int maxAttempts = 2;
    for (int attempt = 0; attempt < maxAttempts; ++attempt) {
        if (const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe); !sent)
            return sent;
        const auto back = readBlock(context, servo, patch.readOffset, patch.count(), 0);
        if (!back)
            return back.error().code == ErrorCode::NoReply ? base::Result<void>{} : back;
        if (servo.image.bytes(patch.readOffset, patch.count()) == patch.data)
            return {};
        if (attempt + 1 < maxAttempts)
            noteResent(context, servo, false, stored.front().reg->key);
    }
    return tl::unexpected(base::Error{
        ErrorCode::Refused, QStringLiteral("move"), {}, servo.id, stored.front().reg->key});
}

base::Result<void> storeAll(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        plan->held = true;
        const auto stored = storeMove(context, *plan->servo, plan->goalRaw, plan->travelTime);
        if (!stored)
            return stored;
    }
    return {};
}

/// There is no reply, so the start is sent more than once; a servo that has started holds nothing
/// any more. Each servo is addressed, half a millisecond apart: a start for all would also move
/// servos in which another program holds a goal.
base::Result<void> startStored(const Context& context, const Plans& plans)
{
    constexpr int sendCount = 3;
    for (int sent = 0; sent < sendCount; ++sent) {
        for (const MovePlan* plan : plans) {
            const Servo& servo = *plan->servo;
            const auto result =
                sendRequest(context, protocol::Request::action(servo.id).in(servo.protocol));
            if (!result)
                return result;
        }
    }
    return {};
}

/// A start command must not find an abandoned move. As far as the link allows; the result is the
/// earlier error.
void clearStored(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto waiting = cancelHeldGoal(context, *plan->servo);
        if (waiting && plan->held)
            plan->held = *waiting;
    }
}

base::Result<void> cancelGoal(const Context& context, Servo& servo)
{
    const auto hasPendingGoal = cancelHeldGoal(context, servo);
    if (!hasPendingGoal)
        return tl::unexpected(hasPendingGoal.error());
    return *hasPendingGoal
               ? base::fail(ErrorCode::Refused, QStringLiteral("forget-held"), {}, servo.id)
               : base::Result<void>{};
}

/// The goal is replaced by "torque off", so torque must be off.
base::Result<void> cancelAsyncGoal(const Context& context, Servo& servo)
{
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    const auto now =
        torque != nullptr ? readRegister(context, servo, *torque) : base::Result<std::int64_t>(0);
    if (!now)
        return tl::unexpected(now.error());
    if (*now != 0)
        return base::fail(ErrorCode::Refused, QStringLiteral("forget-held"), {}, servo.id);
    return cancelGoal(context, servo);
}
} // namespace

base::Result<void> sendRequest(const Context& context, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    transaction.epoch = context.epoch;
    const auto outcome = context.bus.transact(transaction);
    if (!outcome)
        return tl::unexpected(outcome.error());
    return {};
}

base::Result<void> sendAsyncGoals(const Context& context, const MoveGroups& groups)
{
    auto held = storeAll(context, groups.stored);
    if (held)
        held = sendAllAsync(context, groups.held);
    if (!held)
        clearStored(context, groups.stored);
    return held;
}

base::Result<void> startGoals(const Context& context, const MoveGroups& groups)
{
    if (const auto started = startStored(context, groups.stored); !started) {
        clearStored(context, groups.stored);
        return started;
    }
    for (MovePlan* plan : groups.stored)
        plan->held = false;
    return startAsync(context, groups.held);
}

base::Result<void> cancelAfterFailure(const Context& context, const Plans& plans, base::Error error)
{
    QStringList holding;
    int first = -1;
    for (MovePlan* plan : plans) {
        const bool sent = plan->held.value_or(false);
        const auto waiting = discardHeldGoal(context, *plan->servo);
        // An emergency stop itself removes waiting goals.
        const bool unknown = !waiting && sent && waiting.error().code != ErrorCode::Preempted;
        if (!unknown && !waiting.value_or(false))
            continue;
        holding << QString::number(plan->servo->id);
        first = first < 0 ? plan->servo->id : first;
    }
    if (holding.size() == 1)
        error = {ErrorCode::Refused, QStringLiteral("move"), QStringLiteral("forget-held"), first};
    else if (!holding.isEmpty())
        error = {ErrorCode::Refused, QStringLiteral("move"),
                 QStringLiteral("forget-held ") + holding.join(QStringLiteral(", "))};
    return tl::unexpected(std::move(error));
}

base::Result<void> cancelGoals(const Context& context, const MoveGroups& groups)
{
    for (MovePlan* plan : groups.stored) {
        if (const auto forgotten = cancelGoal(context, *plan->servo); !forgotten)
            return forgotten;
    }
    for (MovePlan* plan : groups.held) {
        if (const auto forgotten = cancelAsyncGoal(context, *plan->servo); !forgotten)
            return forgotten;
    }
    return {};
}
} // namespace device

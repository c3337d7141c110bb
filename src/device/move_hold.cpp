// SPDX-License-Identifier: GPL-3.0-or-later
// Goals that wait in their servos, and what starts them.
#include "device/disarm.h"
#include "device/move_together.h"
#include "device/write_check.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
base::Result<bool> waits(const Context& context, Servo& servo)
{
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    if (flag == nullptr)
        return false;
    return readRegister(context, servo, *flag).map([](std::int64_t raw) { return raw == 1; });
}

base::Result<void> holdGoal(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    const auto before = waits(context, servo);
    if (!before)
        return tl::unexpected(before.error());
    auto request = protocol::Request::regWrite(servo.id, block.patch.writeOffset, block.patch.data,
                                               protocol::Repeat::Safe);
    request.acknowledged = servo.answersWrites();
    const bool acknowledged = request.acknowledged;
    plan.held = true;
    const auto held = transactPlain(context, std::move(request));
    if (!held && !answerLost(held.error()))
        return held;
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    if (flag == nullptr)
        return {};
    const auto pending = waits(context, servo);
    if (!pending)
        return tl::unexpected(pending.error());
    const bool taken = held.has_value() && acknowledged;
    plan.held = *pending;
    // The flag tells whether it is held, so a lost answer does not matter; unless another goal has
    // been waiting there, of which it speaks just as well.
    if (*pending && (taken || !*before))
        return {};
    const ErrorCode code = *pending ? ErrorCode::Uncertain : ErrorCode::Refused;
    return tl::unexpected(base::Error{code, QStringLiteral("reg-write"), {}, servo.id, flag->key});
}

base::Result<void> releaseHeld(const Context& context, const Plans& plans)
{
    if (plans.empty())
        return {};
    constexpr int sends = 3;
    // One alone is told alone: others may hold a goal that somebody has forgotten.
    const Servo& first = *plans.front()->servo;
    protocol::Request start =
        plans.size() == 1 ? protocol::Request::action(first.id) : protocol::Request::action();
    start.acknowledged = plans.size() == 1 && first.answersWrites();
    int waiting = -1;
    for (int sent = 0; sent < sends; ++sent) {
        // The flag below tells what became of it.
        const auto acted = transactPlain(context, start);
        if (!acted && !answerLost(acted.error()))
            return acted;
        waiting = -1;
        for (MovePlan* plan : plans) {
            const auto pending = waits(context, *plan->servo);
            if (!pending)
                return tl::unexpected(pending.error());
            plan->held = *pending;
            if (*pending && waiting < 0)
                waiting = plan->servo->id;
        }
        // A flag still up proves that this servo has not heard the ACTION; the others hold nothing
        // any more, so a second one moves only it.
        if (waiting < 0)
            return {};
    }
    return base::fail(ErrorCode::Refused, QStringLiteral("action"), {}, waiting);
}

base::Result<void> holdAll(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto blocks = blocksOf(*plan);
        if (const auto sent = sendSettings(context, *plan, blocks); !sent)
            return sent;
        if (const auto held = holdGoal(context, *plan, blocks.back()); !held)
            return held;
    }
    return {};
}

/// Some models never tell what they store; those that do must show it.
base::Result<void> storeMove(const Context& context, Servo& servo, std::int64_t goal,
                             base::Duration ownTime)
{
    RegisterValues stored{{servo.profile->byRole(Role::StoredGoal), goal}};
    if (const catalog::Register* time = servo.profile->byRole(Role::StoredTime))
        stored.push_back({time, ownTime / std::chrono::milliseconds(1)});
    const Patch patch = patchOf(servo, stored);
    constexpr int tries = 2;
    for (int attempt = 0; attempt < tries; ++attempt) {
        if (const auto sent = writeBlock(context, servo, patch, protocol::Repeat::Safe); !sent)
            return sent;
        const auto back = readBlock(context, servo, patch.readOffset, patch.count(), 0);
        if (!back)
            return back.error().code == ErrorCode::NoAnswer ? base::Result<void>{} : back;
        if (servo.image.bytes(patch.readOffset, patch.count()) == patch.data)
            return {};
        if (attempt + 1 < tries)
            noteSentAgain(context, servo, false, stored.front().reg->key);
    }
    return tl::unexpected(base::Error{
        ErrorCode::Refused, QStringLiteral("move"), {}, servo.id, stored.front().reg->key});
}

base::Result<void> storeAll(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        plan->held = true;
        const auto stored = storeMove(context, *plan->servo, plan->goalRaw, plan->ownTime);
        if (!stored)
            return stored;
    }
    return {};
}

/// There is no answer, so the start is sent more than once; a servo that has started holds nothing
/// any more. Each servo is addressed, half a millisecond apart: a start for all would also move
/// servos in which another program holds a goal.
base::Result<void> startStored(const Context& context, const Plans& plans)
{
    constexpr int sends = 3;
    for (int sent = 0; sent < sends; ++sent) {
        for (const MovePlan* plan : plans) {
            const Servo& servo = *plan->servo;
            const auto acted =
                transactPlain(context, protocol::Request::action(servo.id).in(servo.protocol));
            if (!acted)
                return acted;
        }
    }
    return {};
}

/// A start command must not find a move that was given up. As far as the wire allows; what failed
/// before is what counts.
void forgetStored(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto waiting = disarm(context, *plan->servo);
        if (waiting && plan->held)
            plan->held = *waiting;
    }
}

base::Result<void> forgetGoal(const Context& context, Servo& servo)
{
    const auto waits = disarm(context, servo);
    if (!waits)
        return tl::unexpected(waits.error());
    return *waits ? base::fail(ErrorCode::Refused, QStringLiteral("forget-held"), {}, servo.id)
                  : base::Result<void>{};
}

/// What takes the goal's place is "torque off", so it must be off.
base::Result<void> forgetHeldGoal(const Context& context, Servo& servo)
{
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    const auto now =
        torque != nullptr ? readRegister(context, servo, *torque) : base::Result<std::int64_t>(0);
    if (!now)
        return tl::unexpected(now.error());
    if (*now != 0)
        return base::fail(ErrorCode::Refused, QStringLiteral("forget-held"), {}, servo.id);
    return forgetGoal(context, servo);
}
} // namespace

base::Result<void> transactPlain(const Context& context, protocol::Request request)
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

base::Result<void> holdGoals(const Context& context, const Ways& ways)
{
    auto held = storeAll(context, ways.stored);
    if (held)
        held = holdAll(context, ways.held);
    if (!held)
        forgetStored(context, ways.stored);
    return held;
}

base::Result<void> startGoals(const Context& context, const Ways& ways)
{
    if (const auto started = startStored(context, ways.stored); !started) {
        forgetStored(context, ways.stored);
        return started;
    }
    for (MovePlan* plan : ways.stored)
        plan->held = false;
    return releaseHeld(context, ways.held);
}

base::Result<void> giveUpHeld(const Context& context, const Plans& plans, base::Error error)
{
    QStringList holding;
    int first = -1;
    for (MovePlan* plan : plans) {
        const bool sent = plan->held.value_or(false);
        const auto waiting = dropHeld(context, *plan->servo);
        // An emergency stop takes out itself what waits.
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

base::Result<void> forgetGoals(const Context& context, const Ways& ways)
{
    for (MovePlan* plan : ways.stored) {
        if (const auto forgotten = forgetGoal(context, *plan->servo); !forgotten)
            return forgotten;
    }
    for (MovePlan* plan : ways.held) {
        if (const auto forgotten = forgetHeldGoal(context, *plan->servo); !forgotten)
            return forgotten;
    }
    return {};
}
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/move_together.h"

#include "device/move_step.h"
#include "device/write_check.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace device {
using base::ErrorCode;
using catalog::Role;

base::Result<void> sendSettings(const Context& context, MovePlan& plan,
                                const std::vector<Block>& blocks)
{
    for (const Block& block : blocks) {
        if (block.goal)
            continue;
        const auto sent = writeProven(context, *plan.servo, block.patch);
        if (!sent)
            return sent;
    }
    return {};
}

namespace {
base::Result<void> transactPlain(const Context& context, protocol::Request request)
{
    bus::Transaction transaction;
    transaction.request = std::move(request);
    transaction.priority = context.priority;
    transaction.hold = context.hold;
    const auto outcome = context.bus.transact(transaction);
    if (!outcome)
        return tl::unexpected(outcome.error());
    return {};
}

/// One packet serves only servos whose byte order, place and meaning of the fields agree.
using Packet = std::tuple<QString, base::ByteOrder, int, std::size_t, catalog::Role>;

base::Result<void> sendSyncPackets(const Context& context, const Plans& plans, bool goals)
{
    std::map<Packet, std::vector<protocol::Target>> packets;
    for (const MovePlan* plan : plans) {
        const catalog::Profile& profile = *plan->servo->profile;
        for (const Block& block : blocksOf(*plan)) {
            if (block.goal == goals) {
                packets[{profile.mapKey, profile.byteOrder, block.patch.writeOffset,
                         block.patch.data.size(), plan->goalRole}]
                    .push_back({plan->servo->id, block.patch.data});
            }
        }
    }
    for (auto& [packet, targets] : packets) {
        const auto sent = transactPlain(
            context, protocol::Request::syncWrite(std::get<2>(packet), std::move(targets)));
        if (!sent)
            return sent;
    }
    return {};
}

/// Nobody acknowledges a sync write: reading tells; a servo that missed it gets its own write.
base::Result<void> proveBlocks(const Context& context, MovePlan& plan)
{
    for (const Block& block : blocksOf(plan)) {
        if (block.goal && plan.relative)
            continue;
        const Patch& patch = block.patch;
        const auto back = readBlock(context, *plan.servo, patch.readOffset, patch.count());
        if (!back)
            return back;
        if (plan.servo->image.bytes(patch.readOffset, patch.count()) == patch.data)
            continue;
        const auto sent = writeProven(context, *plan.servo, patch);
        if (!sent)
            return sent;
    }
    return {};
}

base::Result<void> sendBySync(const Context& context, const Plans& plans)
{
    std::vector<StepEvidence> before(plans.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (!plans[i]->relative)
            continue;
        const auto evidence = prepareStep(context, *plans[i]);
        if (!evidence)
            return tl::unexpected(evidence.error());
        before[i] = *evidence;
    }
    for (const bool goals : {false, true}) {
        if (const auto sent = sendSyncPackets(context, plans, goals); !sent)
            return sent;
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (const auto proven = proveBlocks(context, *plans[i]); !proven)
            return proven;
        if (!plans[i]->relative)
            continue;
        const Block goal = blocksOf(*plans[i]).back();
        const auto settled = settleStep(context, *plans[i], goal, before[i], false);
        if (!settled)
            return settled;
    }
    return {};
}

base::Result<void> holdGoal(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    auto request = protocol::Request::regWrite(servo.id, block.patch.writeOffset, block.patch.data,
                                               protocol::Repeat::Safe);
    request.acknowledged = servo.answersWrites();
    // The flag below tells whether it is held, so a lost answer does not matter.
    const auto held = transactPlain(context, std::move(request));
    if (!held && !answerLost(held.error()))
        return held;
    const catalog::Register* flag = servo.profile->byRole(Role::AsyncFlag);
    if (flag == nullptr)
        return {};
    const auto pending = readRegister(context, servo, *flag);
    if (!pending)
        return tl::unexpected(pending.error());
    if (*pending == 1)
        return {};
    return tl::unexpected(
        base::Error{ErrorCode::Refused, QStringLiteral("reg-write"), {}, servo.id, flag->key});
}

base::Result<void> releaseHeld(const Context& context, const Plans& plans)
{
    if (plans.empty())
        return {};
    constexpr int sends = 3;
    for (int sent = 0; sent < sends; ++sent) {
        if (const auto acted = transactPlain(context, protocol::Request::action()); !acted)
            return acted;
        bool waiting = false;
        for (MovePlan* plan : plans) {
            const catalog::Register* flag = plan->servo->profile->byRole(Role::AsyncFlag);
            const auto pending = flag != nullptr ? readRegister(context, *plan->servo, *flag)
                                                 : base::Result<std::int64_t>(0);
            if (!pending)
                return tl::unexpected(pending.error());
            waiting |= *pending == 1;
        }
        // A flag still up proves that this servo has not heard the ACTION; the others hold nothing
        // any more, so a second one moves only it.
        if (!waiting)
            return {};
    }
    return base::fail(ErrorCode::Refused, QStringLiteral("action"));
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

bool canStore(const MovePlan& plan)
{
    return plan.goalRole == Role::GoalPosition &&
           plan.servo->profile->byRole(Role::StoredGoal) != nullptr;
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
            noteSentAgain(context, servo, stored.front().reg->key);
    }
    return tl::unexpected(base::Error{
        ErrorCode::Refused, QStringLiteral("move"), {}, servo.id, stored.front().reg->key});
}

base::Result<void> storeAll(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto stored = storeMove(context, *plan->servo, plan->goalRaw, plan->ownTime);
        if (!stored)
            return stored;
    }
    return {};
}

/// Nobody answers, so it is said more than once: who has heard it holds nothing any more. One
/// servo alone is addressed, as others may hold a move that somebody forgot.
base::Result<void> startStored(const Context& context, const Plans& plans)
{
    if (plans.empty())
        return {};
    const Servo& first = *plans.front()->servo;
    const auto request =
        plans.size() == 1 ? protocol::Request::action(first.id) : protocol::Request::action();
    constexpr int sends = 3;
    for (int sent = 0; sent < sends; ++sent) {
        if (const auto acted =
                transactPlain(context, protocol::Request(request).in(first.protocol));
            !acted)
            return acted;
    }
    return {};
}

/// A start command must not find a move that was given up: where it is becomes what it stores.
/// As far as the wire allows; what failed before is what counts.
void forgetStored(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        Servo& servo = *plan->servo;
        if (!readRoles(context, servo, {Role::PresentPosition}))
            continue;
        auto place = servo.raw(Role::PresentPosition).value_or(0);
        if (const auto range = goalRange(servo))
            place = std::clamp(place, range->min, range->max);
        (void)storeMove(context, servo, place, {});
    }
}

base::Result<void> startTogether(const Context& context, const Ways& ways)
{
    if (const auto stored = storeAll(context, ways.stored); !stored)
        return stored;
    if (const auto held = holdAll(context, ways.held); !held)
        return held;
    return startStored(context, ways.stored);
}

bool canSync(const MovePlan& plan)
{
    return canSay(*plan.servo, protocol::Request::syncWrite(0, {{plan.servo->id, {0}}}));
}

bool canHold(const MovePlan& plan)
{
    return canSay(*plan.servo,
                  protocol::Request::regWrite(plan.servo->id, 0, {0}, protocol::Repeat::Safe));
}

} // namespace

base::Result<Ways> sortOut(std::vector<MovePlan>& plans, MoveHow how)
{
    Ways ways;
    const bool sync = how == MoveHow::Sync;
    for (MovePlan& plan : plans) {
        if (sync ? canSync(plan) : canHold(plan))
            (sync ? ways.packets : ways.held).push_back(&plan);
        else if (canStore(plan))
            ways.stored.push_back(&plan);
        else
            return base::fail(ErrorCode::NotSupported, QStringLiteral("move"),
                              sync ? QStringLiteral("no-sync") : QStringLiteral("no-async"),
                              plan.servo->id);
    }
    return ways;
}

base::Result<void> sendTogether(const Context& context, const Ways& ways)
{
    if (const auto started = startTogether(context, ways); !started) {
        forgetStored(context, ways.stored);
        return started;
    }
    if (const auto acted = releaseHeld(context, ways.held); !acted)
        return acted;
    return sendBySync(context, ways.packets);
}
} // namespace device

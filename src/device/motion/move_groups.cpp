// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/move_groups.h"

#include "device/motion/move_step.h"

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
        const auto sent = writeConfirmed(context, *plan.servo, block.patch);
        if (!sent)
            return sent;
    }
    return {};
}

namespace {
/// One packet serves only servos with the same byte order, address and meaning of the fields.
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
        const auto sent = sendRequest(
            context, protocol::Request::syncWrite(std::get<2>(packet), std::move(targets)));
        if (!sent)
            return sent;
    }
    return {};
}

/// A sync write is not acknowledged, so it is read back; a servo that missed it gets its own write.
base::Result<void> verifyBlocks(const Context& context, MovePlan& plan)
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
        const auto sent = writeConfirmed(context, *plan.servo, patch);
        if (!sent)
            return sent;
    }
    return {};
}

base::Result<void> sendBySync(const Context& context, const Plans& plans)
{
    std::vector<StepState> before(plans.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (!plans[i]->relative)
            continue;
        const auto evidence = prepareRelativeMove(context, *plans[i]);
        if (!evidence)
            return tl::unexpected(evidence.error());
        before[i] = *evidence;
    }
    for (const bool goals : {false, true}) {
        if (const auto sent = sendSyncPackets(context, plans, goals); !sent)
            return sent;
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (const auto proven = verifyBlocks(context, *plans[i]); !proven)
            return proven;
        if (!plans[i]->relative)
            continue;
        const Block goal = blocksOf(*plans[i]).back();
        const auto settled = confirmStep(context, *plans[i], goal, before[i], false);
        if (!settled)
            return settled;
    }
    return {};
}

bool canStore(const MovePlan& plan)
{
    return plan.goalRole == Role::GoalPosition &&
           plan.servo->profile->byRole(Role::StoredGoal) != nullptr;
}

bool canSync(const MovePlan& plan)
{
    return canEncode(*plan.servo, protocol::Request::syncWrite(0, {{plan.servo->id, {0}}}));
}

bool canWriteAsync(const MovePlan& plan)
{
    return canEncode(*plan.servo,
                     protocol::Request::regWrite(plan.servo->id, 0, {0}, protocol::Repeat::Safe));
}

/// Goals are held one after the other, up to the servo that failed.
Plans plansUpTo(const Plans& plans, int failedId)
{
    const auto failed = std::find_if(plans.begin(), plans.end(), [failedId](const MovePlan* plan) {
        return plan->servo->id == failedId;
    });
    return failed == plans.end() ? plans : Plans(plans.begin(), std::next(failed));
}
} // namespace

base::Result<MoveGroups> groupMoves(std::vector<MovePlan>& plans, MoveMethod how)
{
    MoveGroups groups;
    const bool sync = how == MoveMethod::Sync;
    for (MovePlan& plan : plans) {
        if (sync ? canSync(plan) : canWriteAsync(plan))
            (sync ? groups.packets : groups.held).push_back(&plan);
        else if (canStore(plan))
            groups.stored.push_back(&plan);
        else
            return base::fail(ErrorCode::NotSupported, QStringLiteral("move"),
                              sync ? QStringLiteral("no-sync") : QStringLiteral("no-async"),
                              plan.servo->id);
    }
    return groups;
}

base::Result<void> sendSimultaneously(const Context& context, const MoveGroups& groups)
{
    if (const auto held = sendAsyncGoals(context, groups); !held)
        return cancelAfterFailure(context, plansUpTo(groups.held, held.error().id), held.error());
    if (const auto started = startGoals(context, groups); !started)
        return cancelAfterFailure(context, groups.held, started.error());
    return sendBySync(context, groups.packets);
}
} // namespace device

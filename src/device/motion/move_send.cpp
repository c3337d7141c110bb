// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/hold_position.h"
#include "device/motion/mode.h"
#include "device/motion/move_groups.h"
#include "device/motion/move_step.h"
#include "device/write_access.h"

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
base::Result<void> sendGoalBlock(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    if (!plan.relative)
        return writeConfirmed(context, servo, block.patch);
    const auto before = prepareRelativeMove(context, plan);
    if (!before)
        return tl::unexpected(before.error());
    const auto sent = writeBlock(context, servo, block.patch, protocol::Repeat::Never);
    if (sent && servo.repliesToWrites())
        return {};
    if (!sent && !isReplyLost(sent.error()))
        return sent;
    return confirmStep(context, plan, block, *before, !sent);
}

base::Result<void> sendByWrite(const Context& context, const Plans& plans)
{
    for (MovePlan* plan : plans) {
        const auto blocks = blocksOf(*plan);
        if (const auto sent = sendSettings(context, *plan, blocks); !sent)
            return sent;
        if (const auto sent = sendGoalBlock(context, *plan, blocks.back()); !sent)
            return sent;
    }
    return {};
}

/// Holding is only a step on the way to a goal here, so it gets no notice.
void removeHoldingNotices(const Context& context, std::size_t from)
{
    auto& notices = context.notices;
    notices.erase(
        std::remove_if(notices.begin() + static_cast<std::ptrdiff_t>(from), notices.end(),
                       [](const Notice& notice) { return notice.code == NoticeCode::HoldingAt; }),
        notices.end());
}

/// If a servo without torque would lose the goal, torque is turned on first, holding the position.
/// A servo outside its limits cannot hold there, but the goal that follows leads it back.
base::Result<void> energizeFirst(const Context& context, MovePlan& plan)
{
    Servo& servo = *plan.servo;
    if (!plan.energizes || !servo.movesNeedTorque())
        return {};
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return fresh;
    const std::size_t noted = context.notices.size();
    auto on = enableTorque(context, servo);
    if (!on && on.error().code == ErrorCode::OutOfRange)
        on = writeVerified(context, servo, *servo.profile->byRole(Role::TorqueSwitch), 1);
    if (!on)
        return on;
    removeHoldingNotices(context, noted);
    context.note(NoticeCode::TorqueSwitchedOn, servo.id);
    plan.energizes = false;
    return {};
}

/// Most servos turn torque on with the goal; for the others it is turned on here. Both are noted.
base::Result<void> energize(const Context& context, MovePlan& plan)
{
    if (!plan.energizes)
        return {};
    const catalog::Register* torque = plan.servo->profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return {};
    const auto now = readRegister(context, *plan.servo, *torque);
    if (!now)
        return tl::unexpected(now.error());
    if (*now != 1) {
        if (const auto on = writeVerified(context, *plan.servo, *torque, 1); !on)
            return on;
    }
    context.note(NoticeCode::TorqueSwitchedOn, plan.servo->id);
    return {};
}

base::Result<void> prepare(const Context& context, std::vector<MovePlan>& plans)
{
    for (MovePlan& plan : plans) {
        if (const auto on = energizeFirst(context, plan); !on)
            return on;
        if (const auto fresh = refreshBlocks(context, plan); !fresh)
            return fresh;
    }
    return {};
}

base::Result<void> sendEach(const Context& context, std::vector<MovePlan>& plans)
{
    Plans all;
    for (MovePlan& plan : plans)
        all.push_back(&plan);
    return sendByWrite(context, all);
}

/// Torque and notices of servos that have begun to move.
base::Result<void> finishMoves(const Context& context, std::vector<MovePlan>& plans)
{
    for (MovePlan& plan : plans) {
        if (const auto on = energize(context, plan); !on)
            return on;
        noteZeroCurrentLimit(context, *plan.servo);
        addAlarmNotices(context, *plan.servo);
    }
    return {};
}

/// The moves by the way they are sent, and the context that owns their servos.
struct HeldMoves {
    MoveGroups groups; ///< none for MoveMethod::Write
    Owned owned;
};

/// A method that a servo does not support is refused before the first byte.
base::Result<HeldMoves> holdMoves(const Context& outer, std::vector<MovePlan>& plans,
                                  MoveMethod how)
{
    auto groups =
        how == MoveMethod::Write ? base::Result<MoveGroups>(MoveGroups{}) : groupMoves(plans, how);
    if (!groups)
        return tl::unexpected(groups.error());
    std::vector<int> ids;
    ids.reserve(plans.size());
    for (const MovePlan& plan : plans)
        ids.push_back(plan.servo->id);
    if (outer.stop.isRequested())
        return base::fail(ErrorCode::Stopped, QStringLiteral("move"));
    Owned owned = own(outer, ids);
    for (const MovePlan& plan : plans) {
        const auto may = beginWriting(owned, *plan.servo, QStringLiteral("move"));
        if (!may)
            return tl::unexpected(may.error());
    }
    return HeldMoves{std::move(*groups), std::move(owned)};
}

/// The goal must still mean what it meant when it was stored.
base::Result<void> checkMode(const Context& context, MovePlan& plan)
{
    Servo& servo = *plan.servo;
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    const catalog::Mode* mode = servo.mode();
    if (mode != nullptr && mode->key == plan.mode) {
        plan.energizes = servo.raw(Role::TorqueSwitch).value_or(0) != 1;
        return {};
    }
    return tl::unexpected(base::Error{ErrorCode::Refused, QStringLiteral("move"),
                                      QStringLiteral("mode-changed"), servo.id});
}
} // namespace

base::Result<void> sendMoves(const Context& outer, std::vector<MovePlan>& plans, MoveMethod how)
{
    const auto held = holdMoves(outer, plans, how);
    if (!held)
        return tl::unexpected(held.error());
    const Context& context = held->owned.context;
    if (const auto ready = prepare(context, plans); !ready)
        return ready;
    const auto sent = how == MoveMethod::Write ? sendEach(context, plans)
                                               : sendSimultaneously(context, held->groups);
    if (!sent)
        return sent;
    return finishMoves(context, plans);
}

base::Result<void> sendAsyncMoves(const Context& outer, std::vector<MovePlan>& plans)
{
    const auto held = holdMoves(outer, plans, MoveMethod::Async);
    if (!held)
        return tl::unexpected(held.error());
    if (const auto ready = prepare(held->owned.context, plans); !ready)
        return ready;
    return sendAsyncGoals(held->owned.context, held->groups);
}

base::Result<void> startAsyncMoves(const Context& outer, std::vector<MovePlan>& plans)
{
    const auto held = holdMoves(outer, plans, MoveMethod::Async);
    if (!held)
        return tl::unexpected(held.error());
    const Context& context = held->owned.context;
    for (MovePlan& plan : plans) {
        if (const auto same = checkMode(context, plan); !same)
            return same;
        // A stored goal is lost on a servo whose torque was turned off meanwhile.
        if (const auto on = energizeFirst(context, plan); !on)
            return on;
    }
    if (const auto started = startGoals(context, held->groups); !started)
        return started;
    return finishMoves(context, plans);
}

base::Result<void> cancelAsyncMoves(const Context& outer, std::vector<MovePlan>& plans)
{
    const auto held = holdMoves(outer, plans, MoveMethod::Async);
    return held ? cancelGoals(held->owned.context, held->groups) : tl::unexpected(held.error());
}
} // namespace device

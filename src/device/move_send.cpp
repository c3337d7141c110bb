// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion.h"
#include "device/talk.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
/// Fields that stand side by side go in one frame. Nothing between them is written.
struct Block {
    int address = 0;
    base::Bytes data;
    bool goal = false;
};

std::vector<Block> blocksOf(const MovePlan& plan)
{
    const catalog::Profile& profile = *plan.servo->profile;
    std::vector<WriteItem> fields = plan.fields;
    std::sort(fields.begin(), fields.end(), [&](const WriteItem& a, const WriteItem& b) {
        return profile.find(a.key)->address < profile.find(b.key)->address;
    });
    std::vector<Block> blocks;
    for (const WriteItem& field : fields) {
        const catalog::Register& reg = *profile.find(field.key);
        const bool joins =
            !blocks.empty() &&
            blocks.back().address + static_cast<int>(blocks.back().data.size()) == reg.writeOffset;
        if (!joins)
            blocks.push_back({reg.writeOffset, {}, false});
        const base::Bytes bytes = wireBytes(*plan.servo, reg, field.raw);
        blocks.back().data.insert(blocks.back().data.end(), bytes.begin(), bytes.end());
        blocks.back().goal |= reg.role == plan.goalRole;
    }
    // The goal starts the motion, so speed and acceleration must be there before it.
    std::stable_partition(blocks.begin(), blocks.end(), [](const Block& b) { return !b.goal; });
    return blocks;
}

/// What tells, after a lost answer, whether a relative move was taken.
struct StepEvidence {
    std::optional<std::int64_t> goal, remaining, moving, active;
    bool operator==(const StepEvidence&) const = default;
};

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

/// The goal register must differ from the step to come, or a lost answer could not be judged later.
/// A relative move of nothing is harmless and may be repeated.
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

/// A relative move whose answer was lost (or never comes, at response level 0): the state is read,
/// then decided. Never sent twice on suspicion.
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
        context.note(NoticeCode::AnswerLostSentAgain, plan.servo->id);
        const auto again =
            writeBlock(context, *plan.servo, block.address, block.data, protocol::Repeat::Never);
        if (again && plan.servo->answersWrites())
            return {};
        if (!again && !answerLost(again.error()))
            return again;
    }
}

base::Result<void> sendGoalBlock(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    if (!plan.relative)
        return writeProven(context, servo, block.address, block.data);
    const auto before = prepareStep(context, plan);
    if (!before)
        return tl::unexpected(before.error());
    const auto sent =
        writeBlock(context, servo, block.address, block.data, protocol::Repeat::Never);
    if (sent && servo.answersWrites())
        return {};
    if (!sent && !answerLost(sent.error()))
        return sent;
    return settleStep(context, plan, block, *before, !sent);
}

base::Result<void> sendSettings(const Context& context, MovePlan& plan,
                                const std::vector<Block>& blocks)
{
    for (const Block& block : blocks) {
        if (block.goal)
            continue;
        const auto sent = writeProven(context, *plan.servo, block.address, block.data);
        if (!sent)
            return sent;
    }
    return {};
}

base::Result<void> sendByWrite(const Context& context, std::vector<MovePlan>& plans)
{
    for (MovePlan& plan : plans) {
        const auto blocks = blocksOf(plan);
        if (const auto sent = sendSettings(context, plan, blocks); !sent)
            return sent;
        if (const auto sent = sendGoalBlock(context, plan, blocks.back()); !sent)
            return sent;
    }
    return {};
}

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

base::Result<void> sendSyncPackets(const Context& context, std::vector<MovePlan>& plans, bool goals)
{
    std::map<Packet, std::vector<protocol::Target>> packets;
    for (const MovePlan& plan : plans) {
        const catalog::Profile& profile = *plan.servo->profile;
        for (const Block& block : blocksOf(plan)) {
            if (block.goal == goals) {
                packets[{profile.mapKey, profile.byteOrder, block.address, block.data.size(),
                         plan.goalRole}]
                    .push_back({plan.servo->id, block.data});
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
        const int count = static_cast<int>(block.data.size());
        if (const auto back = readBlock(context, *plan.servo, block.address, count); !back)
            return back;
        if (plan.servo->image.bytes(block.address, count) == block.data)
            continue;
        const auto sent = writeProven(context, *plan.servo, block.address, block.data);
        if (!sent)
            return sent;
    }
    return {};
}

base::Result<void> sendBySync(const Context& context, std::vector<MovePlan>& plans)
{
    std::vector<StepEvidence> before(plans.size());
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (!plans[i].relative)
            continue;
        const auto evidence = prepareStep(context, plans[i]);
        if (!evidence)
            return tl::unexpected(evidence.error());
        before[i] = *evidence;
    }
    for (const bool goals : {false, true}) {
        if (const auto sent = sendSyncPackets(context, plans, goals); !sent)
            return sent;
    }
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (const auto proven = proveBlocks(context, plans[i]); !proven)
            return proven;
        if (!plans[i].relative)
            continue;
        const Block goal = blocksOf(plans[i]).back();
        const auto settled = settleStep(context, plans[i], goal, before[i], false);
        if (!settled)
            return settled;
    }
    return {};
}

base::Result<void> holdGoal(const Context& context, MovePlan& plan, const Block& block)
{
    Servo& servo = *plan.servo;
    auto request =
        protocol::Request::regWrite(servo.id, block.address, block.data, protocol::Repeat::Safe);
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

base::Result<void> sendByAction(const Context& context, std::vector<MovePlan>& plans)
{
    for (MovePlan& plan : plans) {
        const auto blocks = blocksOf(plan);
        if (const auto sent = sendSettings(context, plan, blocks); !sent)
            return sent;
        if (const auto held = holdGoal(context, plan, blocks.back()); !held)
            return held;
    }
    constexpr int sends = 3;
    for (int sent = 0; sent < sends; ++sent) {
        if (const auto acted = transactPlain(context, protocol::Request::action()); !acted)
            return acted;
        bool waiting = false;
        for (MovePlan& plan : plans) {
            const catalog::Register* flag = plan.servo->profile->byRole(Role::AsyncFlag);
            const auto pending = flag != nullptr ? readRegister(context, *plan.servo, *flag)
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

/// Most servos switch torque on with the goal; whoever did not is switched on, and both are said.
base::Result<void> energise(const Context& context, MovePlan& plan)
{
    if (!plan.energises)
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
} // namespace

base::Result<void> sendMoves(const Context& outer, std::vector<MovePlan>& plans, MoveHow how)
{
    std::vector<int> ids;
    ids.reserve(plans.size());
    for (const MovePlan& plan : plans)
        ids.push_back(plan.servo->id);
    const Owned owned = own(outer, ids);
    const Context& context = owned.context;
    if (context.stop.requested())
        return base::fail(ErrorCode::Stopped, QStringLiteral("move"));
    const auto sent = how == MoveHow::Sync    ? sendBySync(context, plans)
                      : how == MoveHow::Async ? sendByAction(context, plans)
                                              : sendByWrite(context, plans);
    if (!sent)
        return sent;
    for (MovePlan& plan : plans) {
        if (const auto on = energise(context, plan); !on)
            return on;
        noteAlarms(context, *plan.servo);
    }
    return {};
}
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/holding.h"
#include "device/mode.h"
#include "device/motion.h"
#include "device/release.h"
#include "device/write_access.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
constexpr std::int64_t torqueIsOff = 0;
constexpr std::int64_t torqueIsOn = 1;
constexpr std::int64_t torqueDamps = 2;
/// Phase bit 4: the position feedback counts whole turns.
constexpr std::int64_t fullAngleBit = 1 << 4;
/// A servo this many steps outside its limits may be pulled back to them; further is a surprise.
constexpr std::int64_t outsideTolerance = 10;

tl::unexpected<base::Error> refuse(ErrorCode code, const Servo& servo, const QString& detail)
{
    return tl::unexpected(base::Error{code, QStringLiteral("torque"), detail, servo.id});
}

/// The goal that means "stay here", or why there is none.
base::Result<std::int64_t> holdingGoal(const Servo& servo, const catalog::Mode& mode)
{
    const auto present = servo.raw(Role::PresentPosition);
    const auto phase = servo.raw(Role::Phase);
    if (!present)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("position"));
    const bool fullAngle = phase && (*phase & fullAngleBit) != 0;
    if (mode.limitsZero && !fullAngle)
        return refuse(ErrorCode::TurnsUnknown, servo, {});
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    const auto goal = static_cast<std::int64_t>(
        std::llround(static_cast<double>(*present) / static_cast<double>(factor)));
    const auto range = goalRange(servo);
    if (!range)
        return goal;
    const std::int64_t inside = std::clamp(goal, range->min, range->max);
    if (std::abs(inside - goal) * factor > outsideTolerance) {
        return refuse(ErrorCode::OutOfRange, servo,
                      QStringLiteral("%1: %2 … %3").arg(goal).arg(range->min).arg(range->max));
    }
    return inside;
}
} // namespace

RegisterValues goalValues(const Servo& servo, const catalog::Register& goal, std::int64_t raw)
{
    RegisterValues values{{&goal, raw}};
    const catalog::Register* time = servo.profile->byRole(Role::GoalTime);
    if (goal.role == Role::GoalPosition && goal.block && time != nullptr &&
        time->block == goal.block)
        values.push_back({time, 0});
    return values;
}

base::Result<RegisterValues> holdingValues(const Servo& servo)
{
    const catalog::Mode* mode = servo.mode();
    if (mode == nullptr)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("mode"));
    const catalog::Register* command = servo.profile->byRole(mode->command);
    if (command == nullptr)
        return refuse(ErrorCode::NotSupported, servo, mode->key);
    std::int64_t goal = 0; // step mode: a relative move of nothing; speed and PWM: standstill
    if (mode->command == Role::GoalPosition && !isRelative(*mode)) {
        const auto holding = holdingGoal(servo, *mode);
        if (!holding)
            return tl::unexpected(holding.error());
        goal = *holding;
    }
    return goalValues(servo, *command, goal);
}

base::Result<void> switchOn(const Context& context, Servo& servo)
{
    const catalog::Register& torque = *servo.profile->byRole(Role::TorqueSwitch);
    const auto holding = holdingValues(servo);
    if (!holding)
        return tl::unexpected(holding.error());
    if (const auto commanded = writeVerified(context, servo, *holding); !commanded)
        return commanded;
    context.note(NoticeCode::HoldingAt, servo.id, holding->front().reg->key, holding->front().raw);
    // Writing the goal may already have energised it.
    const auto now = readRegister(context, servo, torque);
    if (!now)
        return tl::unexpected(now.error());
    if (*now == torqueIsOn)
        return {};
    const auto on = writeVerified(context, servo, torque, torqueIsOn);
    // An unloaded servo may have passed over the goal it got.
    if (!on || !servo.movesNeedTorque())
        return on;
    return writeVerified(context, servo, *holding);
}

namespace {
/// Sent first of all where it is not known yet that one servo answers: finding out takes its time,
/// and may end in a refusal.
base::Result<void> release(const Context& context, Servo& servo)
{
    if (!torqueOffOf(servo))
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("torque"));
    if (!context.bus.verifiedIds().contains(servo.protocol, servo.id, context.bus.baud()))
        sendTorqueOff(context, servo);
    auto off = beginWriting(context, servo, QStringLiteral("torque"));
    if (off)
        off = torqueOff(context, servo);
    return off ? off : releaseAnyway(context, servo, std::move(off.error()));
}
} // namespace

base::Result<void> setTorque(const Context& outer, Servo& servo, Torque wanted)
{
    const Owned owned = own(outer, {servo.id});
    const Context& context = owned.context;
    if (wanted == Torque::Off)
        return release(context, servo);
    if (const auto may = beginWriting(context, servo, QStringLiteral("torque")); !may)
        return may;
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("torque"));
    if (wanted == Torque::Damp && !servo.profile->damping)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("damp"));
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return fresh;
    const std::int64_t target = wanted == Torque::On ? torqueIsOn : torqueDamps;
    if (servo.raw(*torque).value_or(torqueIsOff) == target) {
        context.note(NoticeCode::AlreadySo, servo.id, torque->key);
        return {};
    }
    auto done = wanted == Torque::On ? switchOn(context, servo)
                                     : writeVerified(context, servo, *torque, target);
    if (!done && done.error().code == ErrorCode::Mismatch)
        done.error().code = ErrorCode::Refused;
    if (!done)
        return done;
    noteNoCurrent(context, servo);
    noteAlarms(context, servo);
    return {};
}

namespace {
/// Nothing tells where to hold: then the servo is let go, which ends the motion for certain.
bool nowhereToHold(const base::Error& error)
{
    return error.code == ErrorCode::TurnsUnknown || error.code == ErrorCode::OutOfRange ||
           error.code == ErrorCode::NotSupported;
}

base::Result<void> standStill(const Context& context, Servo& servo)
{
    const auto holding = holdingValues(servo);
    if (!holding && nowhereToHold(holding.error()))
        return torqueOff(context, servo);
    if (!holding)
        return tl::unexpected(holding.error());
    const auto halted = writeVerified(context, servo, *holding);
    if (halted) {
        context.note(NoticeCode::HoldingAt, servo.id, holding->front().reg->key,
                     holding->front().raw);
    }
    return halted;
}

/// True when the shaft moves between two looks.
base::Result<bool> stirs(const Context& context, Servo& servo)
{
    // Enough for three steps of the slowest move (LX: 1000 steps in 30 s).
    constexpr base::Duration gap = std::chrono::milliseconds(100);
    if (const auto first = readRoles(context, servo, {Role::PresentPosition}); !first)
        return tl::unexpected(first.error());
    const std::int64_t before = servo.raw(Role::PresentPosition).value_or(0);
    context.bus.clock().sleepFor(gap);
    if (const auto second = readRoles(context, servo, {Role::PresentPosition}); !second)
        return tl::unexpected(second.error());
    // The last step of the encoder comes and goes.
    return std::abs(servo.raw(Role::PresentPosition).value_or(0) - before) > 1;
}

/// Ends the move that is under way at its present place (LX). Nobody answers, so it is said more
/// than once, and the shaft tells; one that moves on gets its own place as the goal.
base::Result<void> sayHalt(const Context& context, Servo& servo)
{
    constexpr int sends = 3;
    for (int sent = 0; sent < sends; ++sent) {
        bus::Transaction transaction;
        transaction.request = protocol::Request::halt(servo.id).in(servo.protocol);
        transaction.priority = context.priority;
        transaction.hold = context.hold;
        transaction.epoch = context.epoch;
        if (const auto said = context.bus.transact(transaction); !said)
            return tl::unexpected(said.error());
    }
    const auto moves = stirs(context, servo);
    if (!moves)
        return tl::unexpected(moves.error());
    if (!*moves)
        return {};
    auto halted = standStill(context, servo);
    if (!halted && halted.error().code == ErrorCode::Mismatch)
        halted.error().code = ErrorCode::Refused;
    return halted;
}

base::Result<void> haltInPlace(const Context& context, Servo& servo)
{
    if (const auto may = beginWriting(context, servo, QStringLiteral("torque")); !may)
        return may;
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("torque"));
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    if (servo.raw(*torque).value_or(torqueIsOff) != torqueIsOn) {
        context.note(NoticeCode::AlreadySo, servo.id, torque->key);
        return {};
    }
    const catalog::Mode* mode = servo.mode();
    // A step that is under way cannot be taken back by another one.
    if (mode != nullptr && isRelative(*mode))
        return torqueOff(context, servo);
    const bool drivesPosition = mode != nullptr && mode->command == Role::GoalPosition;
    if (drivesPosition && canSay(servo, protocol::Request::halt(servo.id)))
        return sayHalt(context, servo);
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return fresh;
    return standStill(context, servo);
}
} // namespace

base::Result<void> halt(const Context& outer, Servo& servo)
{
    const Owned owned = own(outer, {servo.id});
    auto halted = haltInPlace(owned.context, servo);
    return halted ? halted : releaseAnyway(owned.context, servo, std::move(halted.error()));
}
} // namespace device

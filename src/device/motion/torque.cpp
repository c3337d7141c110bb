// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/hold_position.h"
#include "device/motion/mode.h"
#include "device/motion/motion.h"
#include "device/motion/torque_off.h"
#include "device/motion/turn_count.h"
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
/// A servo up to this many steps outside its limits may be pulled back to them; not from further.
constexpr std::int64_t outsideTolerance = 10;

tl::unexpected<base::Error> refuse(ErrorCode code, const Servo& servo, const QString& detail)
{
    return tl::unexpected(base::Error{code, QStringLiteral("torque"), detail, servo.id});
}

/// The goal that means "stay here", or the reason why there is none.
base::Result<std::int64_t> holdingGoal(const Servo& servo, const catalog::Mode& mode)
{
    const auto present = servo.raw(Role::PresentPosition);
    const auto phase = servo.raw(Role::Phase);
    if (!present)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("position"));
    const bool fullAngle = phase && (*phase & fullAnglePhaseBit) != 0;
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

base::Result<RegisterValues> holdValues(const Servo& servo)
{
    const catalog::Mode* mode = servo.mode();
    if (mode == nullptr)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("mode"));
    const catalog::Register* command = servo.profile->byRole(mode->command);
    if (command == nullptr)
        return refuse(ErrorCode::NotSupported, servo, mode->key);
    std::int64_t goal = 0; // step mode: a relative move of 0; speed and PWM: standstill
    if (mode->command == Role::GoalPosition && !isRelative(*mode)) {
        const auto holding = holdingGoal(servo, *mode);
        if (!holding)
            return tl::unexpected(holding.error());
        goal = *holding;
    }
    return goalValues(servo, *command, goal);
}

base::Result<void> enableTorque(const Context& context, Servo& servo)
{
    const catalog::Register& torque = *servo.profile->byRole(Role::TorqueSwitch);
    const auto holding = holdValues(servo);
    if (!holding)
        return tl::unexpected(holding.error());
    if (const auto commanded = writeVerified(context, servo, *holding); !commanded)
        return commanded;
    context.note(NoticeCode::HoldingAt, servo.id, holding->front().reg->key, holding->front().raw);
    // Writing the goal may already have turned torque on.
    const auto now = readRegister(context, servo, torque);
    if (!now)
        return tl::unexpected(now.error());
    if (*now == torqueIsOn)
        return {};
    const auto on = writeVerified(context, servo, torque, torqueIsOn);
    // A servo without torque may have ignored its goal.
    if (!on || !servo.movesNeedTorque())
        return on;
    return writeVerified(context, servo, *holding);
}

namespace {
/// Sent first of all where it is not known yet that one servo answers: finding out takes time and
/// may end in a refusal. The model does not matter: every table has this register at the same
/// address.
base::Result<void> switchOff(const Context& context, Servo& servo)
{
    if (!torqueOffOf(servo))
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("torque"));
    if (!context.bus.verifiedIds().contains(servo.protocol, servo.id, context.bus.baud()))
        sendTorqueOff(context, servo);
    auto off = requireVerified(context, servo, QStringLiteral("torque"));
    if (off)
        off = torqueOff(context, servo);
    return off ? off : forceTorqueOff(context, servo, std::move(off.error()));
}
} // namespace

base::Result<void> setTorque(const Context& outer, Servo& servo, Torque requested)
{
    const Owned owned = own(outer, {servo.id});
    const Context& context = owned.context;
    if (requested == Torque::Off)
        return switchOff(context, servo);
    if (const auto writable = requireWritable(servo, QStringLiteral("torque")); !writable)
        return writable;
    const catalog::Register* torque = servo.profile->byRole(Role::TorqueSwitch);
    if (torque == nullptr)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("torque"));
    if (requested == Torque::Damp && !servo.profile->damping)
        return refuse(ErrorCode::NotSupported, servo, QStringLiteral("damp"));
    if (const auto may = beginWriting(owned, servo, QStringLiteral("torque")); !may)
        return may;
    if (const auto fresh = readSettings(context, servo); !fresh)
        return fresh;
    if (const auto fresh = readRoles(context, servo, {Role::PresentPosition}); !fresh)
        return fresh;
    const std::int64_t target = requested == Torque::On ? torqueIsOn : torqueDamps;
    if (servo.raw(*torque).value_or(torqueIsOff) == target) {
        context.note(NoticeCode::AlreadySet, servo.id, torque->key);
        return {};
    }
    auto done = requested == Torque::On ? enableTorque(context, servo)
                                        : writeVerified(context, servo, *torque, target);
    if (!done && done.error().code == ErrorCode::Mismatch)
        done.error().code = ErrorCode::Refused;
    if (!done)
        return done;
    noteZeroCurrentLimit(context, servo);
    addAlarmNotices(context, servo);
    return {};
}
} // namespace device

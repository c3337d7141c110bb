// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/write_check.h"

#include "device/consent.h"
#include "device/persistence.h"
#include "device/write_access.h"
#include "device/write_meaning.h"

#include <algorithm>
#include <array>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
tl::unexpected<base::Error> refuse(ErrorCode code, const Servo& servo, const QString& key,
                                   const QString& detail = {})
{
    return tl::unexpected(base::Error{code, QStringLiteral("write"), detail, servo.id, key});
}

/// Registers that are changed by a command of their own: the error names it.
base::Result<void> checkDedicatedOperation(const Servo& servo, const catalog::Register& reg,
                                           std::int64_t raw)
{
    switch (classify(reg, raw).procedure) {
    case WriteProcedure::Id:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("set-id"));
    case WriteProcedure::BaudRate:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("set-baud"));
    case WriteProcedure::Center:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("center"));
    case WriteProcedure::Torque:
        if (raw != 0)
            return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("torque"));
        return {};
    case WriteProcedure::OpenLock:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("unlock"));
    case WriteProcedure::Register:
    case WriteProcedure::CloseLock:
        break;
    }
    return {};
}

/// A travel time is sent with its goal, so writing it alone would repeat the latest move.
base::Result<void> checkTime(const Servo& servo, const RegisterValues& items)
{
    const catalog::Register* time = servo.profile->byRole(Role::GoalTime);
    const catalog::Register* goal = servo.profile->byRole(Role::GoalPosition);
    if (time == nullptr || goal == nullptr || !time->block || time->block != goal->block)
        return {};
    const auto contains = [&](const catalog::Register* reg) {
        return std::any_of(items.begin(), items.end(),
                           [reg](const RegisterValue& item) { return item.reg == reg; });
    };
    if (!contains(time) || contains(goal))
        return {};
    return refuse(ErrorCode::NotSupported, servo, time->key, QStringLiteral("with-goal"));
}
} // namespace

base::Result<RegisterValues> checkItems(const Servo& servo, const std::vector<WriteItem>& items,
                                        const WriteOptions& options)
{
    if (const auto writable = requireWritable(servo, QStringLiteral("write")); !writable)
        return tl::unexpected(writable.error());
    RegisterValues checked;
    for (const WriteItem& item : items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        if (reg == nullptr)
            return refuse(ErrorCode::UnknownRegister, servo, item.key);
        if (!reg->writable())
            return refuse(ErrorCode::ReadOnly, servo, item.key);
        const bool twice =
            std::any_of(checked.begin(), checked.end(),
                        [reg](const RegisterValue& other) { return other.reg == reg; });
        if (twice)
            return refuse(ErrorCode::BadArgument, servo, item.key, QStringLiteral("given twice"));
        if (const auto allowed = checkDedicatedOperation(servo, *reg, item.raw); !allowed)
            return tl::unexpected(allowed.error());
        if (const auto allowed = requireConsent(*reg, item.raw, options.consent, servo.id);
            !allowed)
            return tl::unexpected(allowed.error());
        if (options.temporary && retentionOf(*reg) == Retention::Always)
            return refuse(ErrorCode::NotSupported, servo, item.key, QStringLiteral("always-kept"));
        checked.push_back({reg, item.raw});
    }
    if (const auto timed = checkTime(servo, checked); !timed)
        return tl::unexpected(timed.error());
    if (!options.keepOrder) {
        std::sort(checked.begin(), checked.end(),
                  [](const RegisterValue& a, const RegisterValue& b) {
                      return a.reg->writeOffset < b.reg->writeOffset;
                  });
    }
    return checked;
}

std::optional<std::int64_t> valueAfter(const Servo& servo, const RegisterValues& items, Role role)
{
    for (const RegisterValue& item : items) {
        if (item.reg->role == role)
            return item.raw;
    }
    return servo.raw(role);
}

bool isRelative(const catalog::Mode& mode)
{
    return mode.key == QLatin1StringView("step");
}

std::optional<GoalRange> goalRange(const Servo& servo)
{
    const catalog::Mode* mode = servo.mode();
    const auto min = servo.raw(Role::MinAngle);
    const auto max = servo.raw(Role::MaxAngle);
    if (mode == nullptr || mode->command != Role::GoalPosition || mode->limitsZero ||
        isRelative(*mode) || !min || !max)
        return std::nullopt;
    // The goal counts in coarse steps when a resolution factor is set; the limits do not.
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    return GoalRange{(*min + factor - 1) / factor, *max / factor};
}

namespace {
/// A minimum and its maximum; the lower one must stay below the upper one.
struct Pair {
    Role min;
    Role max;
};
constexpr std::array pairs{Pair{Role::MinAngle, Role::MaxAngle},
                           Pair{Role::MinVoltage, Role::MaxVoltage}};

/// Both 0 switches a limit off; as angles only where that is a mode.
bool isUnlimitedByZero(const Servo& servo, const Pair& pair)
{
    const auto& modes = servo.profile->modes;
    return pair.min != Role::MinAngle ||
           std::any_of(modes.begin(), modes.end(),
                       [](const catalog::Mode& mode) { return mode.limitsZero; });
}

base::Result<void> checkPair(const Servo& servo, const RegisterValues& items, const Pair& pair)
{
    const bool concerned = std::any_of(items.begin(), items.end(), [&](const RegisterValue& item) {
        return item.reg->role == pair.min || item.reg->role == pair.max;
    });
    const auto min = valueAfter(servo, items, pair.min);
    const auto max = valueAfter(servo, items, pair.max);
    if (!concerned || !min || !max || *min < *max)
        return {};
    if (*min == 0 && *max == 0 && isUnlimitedByZero(servo, pair))
        return {};
    return refuse(ErrorCode::OutOfRange, servo, servo.profile->byRole(pair.min)->key,
                  QStringLiteral("%1 >= %2").arg(*min).arg(*max));
}

base::Result<void> checkGoal(const Servo& servo, const RegisterValue& item)
{
    if (item.reg->role != Role::GoalPosition && item.reg->role != Role::StoredGoal)
        return {};
    const auto range = goalRange(servo);
    if (!range || (item.raw >= range->min && item.raw <= range->max))
        return {};
    return refuse(ErrorCode::OutOfRange, servo, item.reg->key,
                  QStringLiteral("%1 … %2").arg(range->min).arg(range->max));
}
} // namespace

base::Result<void> checkValues(const Context& context, const Servo& servo,
                               const RegisterValues& items, bool allowPreviousValues)
{
    for (const RegisterValue& item : items) {
        const auto value = catalog::checkNewValue(item.raw, *item.reg, servo.meaning(*item.reg),
                                                  servo.raw(*item.reg));
        if (!value && !(allowPreviousValues && value.error().code == ErrorCode::OutOfRange)) {
            base::Error error = value.error();
            error.id = servo.id;
            error.registerKey = item.reg->key;
            return tl::unexpected(error);
        }
        if (const auto goal = checkGoal(servo, item); !goal)
            return goal;
        if (item.reg->warnAbove && item.raw > *item.reg->warnAbove)
            context.note(NoticeCode::AboveRecommended, servo.id, item.reg->key,
                         *item.reg->warnAbove);
    }
    for (const Pair& pair : pairs) {
        const auto valid = checkPair(servo, items, pair);
        if (!valid && !allowPreviousValues)
            return valid;
    }
    return {};
}
} // namespace device

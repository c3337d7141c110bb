// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/write_check.h"

#include <algorithm>

namespace device {
using base::ErrorCode;
using catalog::Role;

namespace {
tl::unexpected<base::Error> refuse(ErrorCode code, const Servo& servo, const QString& key,
                                   const QString& detail = {})
{
    return tl::unexpected(base::Error{code, QStringLiteral("write"), detail, servo.id, key});
}

/// Registers whose writing is more than a write name their command instead.
base::Result<void> checkManoeuvre(const Servo& servo, const catalog::Register& reg,
                                  std::int64_t raw)
{
    switch (reg.role) {
    case Role::Id:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("set-id"));
    case Role::BaudRate:
        return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("set-baud"));
    case Role::TorqueSwitch:
        if (raw == 128)
            return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("center"));
        if (raw != 0)
            return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("torque"));
        return {};
    case Role::Lock:
        if (raw == 0)
            return refuse(ErrorCode::NotSupported, servo, reg.key, QStringLiteral("unlock"));
        return {};
    default:
        return {};
    }
}
} // namespace

base::Result<std::vector<CheckedItem>>
checkItems(const Servo& servo, const std::vector<WriteItem>& items, const WriteOptions& options)
{
    if (!servo.profile->writable) {
        return refuse(ErrorCode::UnknownModel, servo, {},
                      QStringLiteral("firmware ") + servo.profile->identity.firmware());
    }
    std::vector<CheckedItem> checked;
    for (const WriteItem& item : items) {
        const catalog::Register* reg = servo.profile->find(item.key);
        if (reg == nullptr)
            return refuse(ErrorCode::UnknownRegister, servo, item.key);
        if (!reg->writable())
            return refuse(ErrorCode::ReadOnly, servo, item.key);
        const bool twice =
            std::any_of(checked.begin(), checked.end(),
                        [reg](const CheckedItem& other) { return other.reg == reg; });
        if (twice)
            return refuse(ErrorCode::BadArgument, servo, item.key, QStringLiteral("given twice"));
        if (const auto own = checkManoeuvre(servo, *reg, item.raw); !own)
            return tl::unexpected(own.error());
        if (reg->dangerous && !options.dangerous)
            return refuse(ErrorCode::NeedsConsent, servo, item.key);
        checked.push_back({reg, item.raw});
    }
    std::sort(checked.begin(), checked.end(), [](const CheckedItem& a, const CheckedItem& b) {
        return a.reg->writeOffset < b.reg->writeOffset;
    });
    return checked;
}

std::optional<std::int64_t> valueAfter(const Servo& servo, const std::vector<CheckedItem>& items,
                                       Role role)
{
    for (const CheckedItem& item : items) {
        if (item.reg->role == role)
            return item.raw;
    }
    return servo.raw(role);
}

std::optional<GoalRange> goalRange(const Servo& servo)
{
    const catalog::Mode* mode = servo.mode();
    const auto min = servo.raw(Role::MinAngle);
    const auto max = servo.raw(Role::MaxAngle);
    if (mode == nullptr || mode->command != Role::GoalPosition || mode->limitsZero || !min || !max)
        return std::nullopt;
    // The goal counts in coarse steps when a resolution factor is set; the limits do not.
    const std::int64_t factor =
        std::max<std::int64_t>(1, servo.raw(Role::AngleResolution).value_or(1));
    return GoalRange{(*min + factor - 1) / factor, *max / factor};
}

namespace {
base::Result<void> checkLimits(const Servo& servo, const std::vector<CheckedItem>& items)
{
    const bool concerned = std::any_of(items.begin(), items.end(), [](const CheckedItem& item) {
        return item.reg->role == Role::MinAngle || item.reg->role == Role::MaxAngle;
    });
    if (!concerned)
        return {};
    const auto min = valueAfter(servo, items, Role::MinAngle);
    const auto max = valueAfter(servo, items, Role::MaxAngle);
    if (!min || !max || (*min == 0 && *max == 0) || *min < *max)
        return {};
    return refuse(ErrorCode::OutOfRange, servo, servo.profile->byRole(Role::MinAngle)->key,
                  QStringLiteral("%1 >= %2").arg(*min).arg(*max));
}

base::Result<void> checkGoal(const Servo& servo, const CheckedItem& item)
{
    if (item.reg->role != Role::GoalPosition)
        return {};
    const auto range = goalRange(servo);
    if (!range || (item.raw >= range->min && item.raw <= range->max))
        return {};
    return refuse(ErrorCode::OutOfRange, servo, item.reg->key,
                  QStringLiteral("%1 … %2").arg(range->min).arg(range->max));
}
} // namespace

base::Result<void> checkValues(const Context& context, const Servo& servo,
                               const std::vector<CheckedItem>& items)
{
    for (const CheckedItem& item : items) {
        const auto value = catalog::checkNewValue(item.raw, *item.reg, servo.meaning(*item.reg),
                                                  servo.raw(*item.reg));
        if (!value) {
            base::Error error = value.error();
            error.id = servo.id;
            error.registerKey = item.reg->key;
            return tl::unexpected(error);
        }
        if (const auto goal = checkGoal(servo, item); !goal)
            return goal;
        if (item.reg->warnAbove && item.raw > *item.reg->warnAbove)
            context.note(NoticeCode::AboveUsual, servo.id, item.reg->key, *item.reg->warnAbove);
    }
    return checkLimits(servo, items);
}
} // namespace device

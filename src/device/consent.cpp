// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/consent.h"

#include "device/write_check.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using catalog::Role;

namespace {
bool isUnlimitedByZero(const catalog::Profile& profile)
{
    return std::any_of(profile.modes.begin(), profile.modes.end(),
                       [](const catalog::Mode& mode) { return mode.limitsZero; });
}
} // namespace

bool removesAngleLimits(const Servo& servo, const RegisterValues& items)
{
    const bool concerned = std::any_of(items.begin(), items.end(), [](const RegisterValue& item) {
        return item.reg->role == Role::MinAngle || item.reg->role == Role::MaxAngle;
    });
    const bool hadNone = servo.raw(Role::MinAngle) == 0 && servo.raw(Role::MaxAngle) == 0;
    return concerned && !hadNone && isUnlimitedByZero(*servo.profile) &&
           valueAfter(servo, items, Role::MinAngle) == 0 &&
           valueAfter(servo, items, Role::MaxAngle) == 0;
}

bool canRemoveAngleLimits(const catalog::Profile& profile, const RegisterValues& items)
{
    const auto written = [&](Role role, auto condition) {
        return std::any_of(items.begin(), items.end(), [&](const RegisterValue& item) {
            return item.reg->role == role && condition(item.raw);
        });
    };
    return isUnlimitedByZero(profile) &&
           written(Role::MaxAngle, [](std::int64_t raw) { return raw == 0; }) &&
           !written(Role::MinAngle, [](std::int64_t raw) { return raw != 0; });
}

base::Result<void> requireConsent(const catalog::Register& reg, std::int64_t raw, Consent consent,
                                  int id)
{
    const WriteMeaning meaning = classify(reg, raw);
    if (!meaning.needsConsent || consent)
        return {};
    return tl::unexpected(base::Error{base::ErrorCode::NeedsConsent, QStringLiteral("write"),
                                      meaning.moves ? QStringLiteral("turns") : QString(), id,
                                      reg.key});
}

base::Result<void> requireConsent(const Servo& servo, const RegisterValues& items, Consent consent)
{
    for (const RegisterValue& item : items) {
        const auto allowed = requireConsent(*item.reg, item.raw, consent, servo.id);
        if (!allowed)
            return allowed;
    }
    if (consent || !removesAngleLimits(servo, items))
        return {};
    return tl::unexpected(base::Error{base::ErrorCode::NeedsConsent, QStringLiteral("write"),
                                      QStringLiteral("free-turning"), servo.id,
                                      servo.profile->byRole(Role::MinAngle)->key});
}
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/consent.h"

#include "device/motion/mode.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using catalog::Role;

bool removesAngleLimits(const Servo& servo, const RegisterValues& items)
{
    const bool concerned = std::any_of(items.begin(), items.end(), [](const RegisterValue& item) {
        return item.reg->role == Role::MinAngle || item.reg->role == Role::MaxAngle;
    });
    const auto change = modeChange(servo, items);
    return concerned && change && change->to->limitsZero;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/consent.h"

#include "device/write_check.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using catalog::Role;

bool removesAngleLimits(const Servo& servo, const RegisterValues& items)
{
    const auto& modes = servo.profile->modes;
    const auto after = [&](Role role) { return valueAfter(servo, items, role); };
    const bool hasLimits =
        servo.raw(Role::MinAngle).value_or(0) != 0 || servo.raw(Role::MaxAngle).value_or(0) != 0;
    return hasLimits && after(Role::MinAngle) == 0 && after(Role::MaxAngle) == 0 &&
           std::any_of(modes.begin(), modes.end(),
                       [](const catalog::Mode& mode) { return mode.limitsZero; });
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

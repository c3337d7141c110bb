// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/consent.h"

#include "device/motion/mode.h"
#include "device/write_meaning.h"

#include <algorithm>

namespace device {
using catalog::Role;

namespace {
bool isAngleLimit(const RegisterValue& item)
{
    return item.reg->role == Role::MinAngle || item.reg->role == Role::MaxAngle;
}
} // namespace

bool removesAngleLimits(const Servo& servo, const RegisterValues& items)
{
    const auto change = modeChange(servo, items);
    return std::any_of(items.begin(), items.end(), isAngleLimit) && change &&
           change->to->limitsZero;
}

bool canRemoveAngleLimits(const catalog::Profile& profile, const RegisterValues& items)
{
    const bool isMode = std::any_of(profile.modes.begin(), profile.modes.end(),
                                    [](const catalog::Mode& mode) { return mode.limitsZero; });
    const auto keepsLimit = [](const RegisterValue& item) {
        return isAngleLimit(item) && item.raw != 0;
    };
    return isMode && std::any_of(items.begin(), items.end(), isAngleLimit) &&
           std::none_of(items.begin(), items.end(), keepsLimit);
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

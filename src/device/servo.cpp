// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/servo.h"

namespace device {
using catalog::Role;

catalog::Lookup Servo::lookup() const
{
    // The registers that decide meanings (phase, mode, limits) have no variants themselves, so they
    // need no lookup: this ends every recursion.
    return [this](const QString& key) -> std::optional<std::int64_t> {
        const catalog::Register* reg = profile ? profile->find(key) : nullptr;
        if (reg == nullptr)
            return std::nullopt;
        const auto wire = image.bytes(reg->offset, reg->size);
        if (!wire)
            return std::nullopt;
        const auto plain = catalog::valueFormat(*reg, *profile, catalog::noLookup);
        return catalog::decodeRaw(*wire, *reg, plain, profile->byteOrder);
    };
}

catalog::ValueFormat Servo::meaning(const catalog::Register& reg) const
{
    return catalog::valueFormat(reg, *profile, lookup());
}

std::optional<std::int64_t> Servo::raw(const catalog::Register& reg) const
{
    const auto wire = image.bytes(reg.offset, reg.size);
    if (!wire)
        return std::nullopt;
    return catalog::decodeRaw(*wire, reg, meaning(reg), profile->byteOrder);
}

std::optional<std::int64_t> Servo::raw(const QString& key) const
{
    const catalog::Register* reg = profile ? profile->find(key) : nullptr;
    return reg != nullptr ? raw(*reg) : std::nullopt;
}

std::optional<std::int64_t> Servo::raw(Role role) const
{
    const catalog::Register* reg = profile ? profile->byRole(role) : nullptr;
    return reg != nullptr ? raw(*reg) : std::nullopt;
}

std::optional<double> Servo::physical(Role role) const
{
    const catalog::Register* reg = profile ? profile->byRole(role) : nullptr;
    const auto value = reg != nullptr ? raw(*reg) : std::nullopt;
    if (!value)
        return std::nullopt;
    return catalog::toPhysical(*value, meaning(*reg));
}

const catalog::Mode* Servo::mode() const
{
    return modeFor(*profile, raw(Role::OperatingMode), raw(Role::MinAngle), raw(Role::MaxAngle));
}

const catalog::Mode* modeFor(const catalog::Profile& profile,
                             std::optional<std::int64_t> operatingMode,
                             std::optional<std::int64_t> minAngle,
                             std::optional<std::int64_t> maxAngle)
{
    if (!minAngle || !maxAngle)
        return nullptr;
    if (profile.byRole(Role::OperatingMode) != nullptr && !operatingMode)
        return nullptr;
    const bool limitsZero = *minAngle == 0 && *maxAngle == 0;
    const catalog::Mode* sameNumber = nullptr;
    for (const catalog::Mode& mode : profile.modes) {
        if (mode.operatingMode && *mode.operatingMode != operatingMode.value_or(-1))
            continue;
        if (mode.limitsZero == limitsZero)
            return &mode;
        if (sameNumber == nullptr)
            sameNumber = &mode;
    }
    return sameNumber;
}

base::ServoIdentity Servo::identity() const
{
    base::ServoIdentity identity;
    identity.id = id;
    identity.port = port;
    identity.baud = baud;
    identity.protocol = protocol;
    if (profile) {
        identity.modelMajor = profile->identity.modelMajor;
        identity.modelMinor = profile->identity.modelMinor;
        identity.firmwareMajor = profile->identity.firmwareMajor;
        identity.firmwareMinor = profile->identity.firmwareMinor;
        identity.map = profile->mapKey;
        identity.model = profile->modelName;
    }
    return identity;
}

bool Servo::measures(const catalog::Register& reg) const
{
    using catalog::CurrentSensing;
    constexpr std::int64_t bridgeWithoutFeedback = 1 << 5; // phase bit 5, STS
    if (reg.role != Role::PresentCurrent || !profile)
        return true;
    if (profile->currentSensing == CurrentSensing::UnlessPhaseBit5)
        return (raw(Role::Phase).value_or(0) & bridgeWithoutFeedback) == 0;
    return profile->currentSensing != CurrentSensing::No;
}

bool Servo::acknowledgesWrites() const
{
    return protocol != base::Protocol::Lx;
}

bool Servo::repliesToWrites() const
{
    return acknowledgesWrites() && raw(Role::ResponseLevel).value_or(1) != 0;
}

bool Servo::repliesCarryStatus() const
{
    return protocol == base::Protocol::Feetech;
}

bool Servo::movesNeedTorque() const
{
    return protocol == base::Protocol::Lx;
}
} // namespace device

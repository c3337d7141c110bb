// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/factory_values.h"

#include "sim/servo/virtual_servo.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
using catalog::Role;

/// The code of a rate in this family's own table.
std::optional<int> baudCode(const catalog::Profile& profile, int rate)
{
    const catalog::Register* codes = profile.byRole(Role::BaudRate);
    if (codes == nullptr) {
        return std::nullopt;
    }
    for (const catalog::NamedValue& value : codes->values) {
        if (value.key.toInt() == rate) {
            return value.value;
        }
    }
    return std::nullopt;
}

/// Values that make this servo this servo, whatever the sheet's default is.
std::optional<int> configuredValue(Role role, const catalog::Profile& profile,
                                   const ServoConfig& config)
{
    switch (role) {
    case Role::FirmwareMajor:
        return profile.identity.firmwareMajor;
    case Role::FirmwareMinor:
        return profile.identity.firmwareMinor;
    case Role::ByteOrder:
        return profile.byteOrder == base::ByteOrder::Big ? 1 : 0;
    case Role::ModelMajor:
        return profile.identity.modelMajor;
    case Role::ModelMinor:
        return profile.identity.modelMinor;
    case Role::Id:
        return config.id;
    case Role::BaudRate: {
        const int factory = profile.defaultBaud.value_or(1000000);
        const auto code = baudCode(profile, config.baud.value_or(factory));
        return code ? code : baudCode(profile, factory);
    }
    case Role::ReturnDelay:
        return config.returnDelayRaw;
    default:
        return std::nullopt;
    }
}

int rawOf(const catalog::Register& reg, double physical)
{
    return int(std::lround(physical / reg.scale));
}

/// Values that no sheet states; the kind of servo decides.
int typicalValue(const catalog::Register& reg, const catalog::Profile& profile,
                 const ServoType& type)
{
    switch (reg.role) {
    case Role::MaxVoltage:
        return rawOf(reg, type.maxVoltage);
    case Role::MinVoltage:
        return rawOf(reg, type.minVoltage);
    case Role::MaxAngle:
        return profile.stepsPerTurn - 1;
    case Role::Phase:
        return type.phase;
    case Role::PositionP:
        return type.positionP;
    case Role::PositionD:
        return type.positionD;
    case Role::StartupForce:
        return type.startupForce;
    case Role::UnloadCondition:
        return type.unloadCondition;
    case Role::LedCondition:
        return type.ledCondition;
    case Role::SpeedP:
        return type.speedP;
    case Role::SpeedI:
        return type.speedI;
    case Role::OperatingMode:
        return type.mode;
    case Role::ProtectionCurrent:
        return rawOf(reg, 3250);
    case Role::ProtectionTorque:
        return rawOf(reg, 20);
    case Role::OverloadTorque:
        return rawOf(reg, 80);
    case Role::ProtectionTime:
    case Role::OvercurrentTime:
        return rawOf(reg, 2000);
    case Role::CwDeadZone:
    case Role::CcwDeadZone:
    case Role::ResponseLevel:
    case Role::Lock:
    case Role::AngleResolution:
        return 1;
    case Role::MaxTemperature:
        return 70;
    case Role::MaxTorque:
    case Role::TorqueLimit:
        return 1000;
    default:
        return 0;
    }
}

/// A sheet's default that cannot be this servo's: some are one list for all models.
bool isImplausible(const catalog::Register& reg, std::int64_t value,
                   const catalog::Profile& profile, const ServoType& type)
{
    const double physical = double(value) * reg.scale;
    switch (reg.role) {
    case Role::MaxVoltage:
        return physical < profile.maxVoltage.value_or(type.nominalVolts);
    case Role::MinVoltage:
        return physical > type.nominalVolts;
    case Role::ProtectionCurrent:
        return value == 0;
    case Role::OperatingMode:
        return value != type.mode;
    default:
        return false;
    }
}

/// Values of registers without a role, most of them in the factory area. Only the start values of
/// the Modbus servo act in the simulation; the others are just shown.
int miscDefault(const catalog::Register& reg, const catalog::Profile& profile, int maxSpeed)
{
    const QString& key = reg.key;
    if (key == QLatin1String("speed_default")) {
        return maxSpeed / 50;
    }
    if (key == QLatin1String("release_year")) {
        return 2023;
    }
    if (key == QLatin1String("release_month")) {
        return 6;
    }
    if (key == QLatin1String("acceleration_limit") && profile.protocol == base::Protocol::Feetech) {
        return 254;
    }
    if (reg.writable()) {
        return 0;
    }
    if (key == QLatin1String("max_speed_limit")) {
        return std::min(255, maxSpeed / 50);
    }
    if (key == QLatin1String("d_control_time")) {
        return 20;
    }
    return key == QLatin1String("acceleration_multiplier") ? 0 : 1;
}

int factoryValue(const catalog::Register& reg, const catalog::Profile& profile,
                 const ServoType& type, int maxSpeed)
{
    const auto fallback = [&] {
        return reg.role == Role::None ? miscDefault(reg, profile, maxSpeed)
                                      : typicalValue(reg, profile, type);
    };
    if (!reg.defaultRaw || isImplausible(reg, *reg.defaultRaw, profile, type)) {
        return fallback();
    }
    return int(*reg.defaultRaw);
}
} // namespace

void fillFactoryValues(Memory& memory, const ServoModel& model, const ServoConfig& config)
{
    const catalog::Profile& profile = *model.profile;
    const int maxSpeed = maximumSpeed(model.type, model.traits);
    for (const catalog::Register& reg : profile.registers) {
        const int defaultValue = factoryValue(reg, profile, model.type, maxSpeed);
        const int value = reg.key == QLatin1String("secondary_id")
                              ? config.id
                              : configuredValue(reg.role, profile, config).value_or(defaultValue);
        const base::Bytes bytes = base::writeUnsigned(std::uint64_t(std::max(0, value)),
                                                      std::size_t(reg.size), profile.byteOrder);
        for (std::size_t i = 0; i < bytes.size() && reg.offset + int(i) < Memory::size; ++i) {
            memory.setInitial(reg.offset + int(i), bytes[i]);
        }
    }
}
} // namespace sim

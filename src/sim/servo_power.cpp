// SPDX-License-Identifier: GPL-3.0-or-later
// What a servo leaves the factory with, and what switching it off and on does.
#include "sim/servo_state.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace sim {
namespace {
using catalog::Role;

/// Register 6; codes 8 and up only where the firmware has them. Source: baud code table of the
/// Feetech protocol notes.
constexpr std::array<int, 12> baudRates{1000000, 500000, 250000, 128000, 115200, 76800,
                                        57600,   38400,  19200,  14400,  9600,   4800};

std::optional<int> baudCode(int rate)
{
    const auto found = std::find(baudRates.begin(), baudRates.end(), rate);
    return found == baudRates.end() ? std::nullopt
                                    : std::optional<int>(int(found - baudRates.begin()));
}

/// Values that make this servo this servo, whatever the sheet's default is.
std::optional<int> ownValue(Role role, const catalog::Profile& profile, const ServoConfig& config)
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
        const auto code = baudCode(config.baud.value_or(factory));
        return code ? code : baudCode(factory);
    }
    case Role::ReturnDelay:
        return config.returnDelayRaw;
    default:
        return std::nullopt;
    }
}

/// What the sheet does not know and the kind of servo decides.
int typicalValue(Role role, const ServoType& type)
{
    switch (role) {
    case Role::MaxVoltage:
        return type.maxVoltageRaw;
    case Role::MinVoltage:
        return type.minVoltageRaw;
    case Role::Phase:
        return type.phase;
    case Role::PositionP:
        return 32;
    case Role::PositionD:
        return type.positionD;
    case Role::UnloadCondition:
        return type.unloadCondition;
    case Role::LedCondition:
        return type.ledCondition;
    case Role::SpeedP:
        return type.speedP;
    case Role::SpeedI:
        return type.speedI;
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

/// Read-only figures of the factory area, shown but not used by the simulation.
int factoryValue(const catalog::Register& reg, int maxSpeed)
{
    const QString& key = reg.key;
    if (reg.writable()) {
        return 0;
    }
    if (key == QLatin1String("max_speed_limit")) {
        return std::min(255, maxSpeed / 50);
    }
    if (key == QLatin1String("acceleration_limit")) {
        return 254;
    }
    if (key == QLatin1String("d_control_time")) {
        return 20;
    }
    return key == QLatin1String("acceleration_multiplier") ? 0 : 1;
}

double midRange(const catalog::Profile& profile)
{
    return 0.5 * profile.stepsPerTurn / stepsPerRadian(profile);
}
} // namespace

VirtualServo::State::State(catalog::ProfilePtr ownProfile, const ServoConfig& ownConfig)
    : profile(std::move(ownProfile))
    , config(ownConfig)
    , type(servoType(*profile))
    , map(*profile)
    , memory(*profile)
    , mechanics(driveOf(type), config.gearPlayDegrees * std::numbers::pi / 180.0,
                config.initialDegrees * std::numbers::pi / 180.0, midRange(*profile))
    , encoder(stepsPerRadian(*profile), !isScs(*profile), config.seed)
    , celsius(config.surroundings.ambientCelsius)
{
    fillFactoryValues();
    switchOn();
}

void VirtualServo::State::fillFactoryValues()
{
    const int maxSpeed = maximumSpeed(type, *profile);
    for (const catalog::Register& reg : profile->registers) {
        std::int64_t value = reg.defaultRaw.value_or(
            reg.role == Role::None ? factoryValue(reg, maxSpeed) : typicalValue(reg.role, type));
        value = ownValue(reg.role, *profile, config).value_or(int(value));
        const base::Bytes bytes =
            base::writeUnsigned(std::uint64_t(std::max<std::int64_t>(0, value)),
                                std::size_t(reg.size), profile->byteOrder);
        for (std::size_t i = 0; i < bytes.size() && reg.offset + int(i) < Memory::size; ++i) {
            memory.setInitial(reg.offset + int(i), bytes[i]);
        }
    }
}

void VirtualServo::State::switchOff()
{
    settings.torqueSwitch = 0;
    duty = 0;
    held.reset();
    moving = false;
    deafLeft = {};
    rebootLeft = {};
}

void VirtualServo::State::switchOn()
{
    memory.powerOn();
    map.put(memory, Role::TorqueLimit, map.read(memory, Role::MaxTorque));
    settings = readSettings(memory, map, *profile, type);
    map.put(memory, Role::GoalSpeed, settings.maxSpeed / (settings.fineSpeed ? 1 : 50));
    settings = readSettings(memory, map, *profile, type);
    takeBaud();
    protection.reset();
    volts = mechanics.supplyVolts(config.surroundings) * 10.0;
    encoder.settle(mechanics.angle());
    counted = encoder.sample(mechanics.angle(), ticks);
    speed = shownSpeed = 0;
    restTicks = stillTicks = 0;
    rebase();
    controller.energise(position);
    stepGoal = position;
}

void VirtualServo::State::takeBaud()
{
    const int code = map.read(memory, Role::BaudRate);
    if (code < int(baudRates.size())) {
        baud = baudRates[std::size_t(code)];
    }
}

base::Duration VirtualServo::State::replyDelay() const
{
    constexpr base::Duration shortest(40);
    const int raw = isSms(*profile) ? map.read(memory, Role::ReturnDelay) : 0;
    if (raw == 0) {
        return shortest;
    }
    return base::Duration(2 * std::max(raw, 50));
}
} // namespace sim

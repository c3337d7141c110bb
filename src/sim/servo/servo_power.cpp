// SPDX-License-Identifier: GPL-3.0-or-later
// Switching a servo off and on, and how it is spoken to.
#include "sim/servo/servo_state.h"

#include <algorithm>
#include <numbers>

namespace sim {
namespace {
using catalog::Role;

/// Registers that power-on loads with what another one holds, where a family has both.
struct StartLoad {
    const char* to;
    const char* from;
};
constexpr StartLoad startLoads[] = {
    {"torque_limit", "max_torque"},           {"torque_limit", "torque_limit_default"},
    {"acceleration", "acceleration_default"}, {"goal_speed", "speed_default"},
    {"goal_current", "protection_current"},
};
constexpr StartLoad positionGains[] = {
    {"kp", "position_p"},
    {"kd", "position_d"},
    {"ki", "position_i"},
};
constexpr StartLoad speedGains[] = {
    {"kp", "speed_p"},
    {"kd", "position_d"},
    {"ki", "speed_i"},
};

template <std::size_t count>
void copyRegisters(const StartLoad (&loads)[count], const catalog::Profile& profile,
                   const RegisterMap& map, Memory& memory)
{
    for (const StartLoad& load : loads) {
        const Field from = fieldOf(profile, QString::fromLatin1(load.from));
        if (from.exists()) {
            map.put(memory, fieldOf(profile, QString::fromLatin1(load.to)), map.read(memory, from));
        }
    }
}

/// Where gravity lets the load hang: the middle of the range.
double midRange(const catalog::Profile& profile, const ServoTraits& traits)
{
    return 0.5 * profile.stepsPerTurn / traits.stepsPerRadian;
}
} // namespace

VirtualServo::State::State(catalog::ProfilePtr servoProfile, const ServoConfig& servoConfig)
    : profile(std::move(servoProfile))
    , config(servoConfig)
    , traits(traitsOf(*profile))
    , type(servoType(*profile))
    , map(*profile)
    , secondaryId(fieldOf(*profile, QStringLiteral("secondary_id")))
    , memory(*profile)
    , mechanics(motorModelOf(type), config.gearPlayDegrees * std::numbers::pi / 180.0,
                config.initialDegrees * std::numbers::pi / 180.0, midRange(*profile, traits))
    , encoder(traits, config.seed)
    , baud(profile->defaultBaud.value_or(1000000))
    , celsius(config.environment.ambientCelsius)
{
    fillFactoryValues();
    switchOn();
}

std::optional<ServoReply> VirtualServo::State::handle(const ServoRequest& request)
{
    epromWritten = false;
    if (!isRunning() || deafLeft.count() > 0) {
        return std::nullopt;
    }
    // A deaf one speaks before it writes; the shortest reply has six bytes of ten bits.
    const base::Duration replyTime = replyDelay() + base::Duration(60'000'000 / baud);
    std::optional<ServoReply> reply;
    switch (profile->protocol) {
    case base::Protocol::Feetech:
        reply = handleFeetech(request);
        break;
    case base::Protocol::Modbus:
        reply = handleModbus(request);
        break;
    case base::Protocol::Lx:
        reply = handleLx(request);
        break;
    }
    if (epromWritten && config.behavior.deafWhileWriting) {
        deafLeft = config.epromTime + (reply ? replyTime : base::Duration());
    }
    return reply;
}

base::Duration VirtualServo::State::writeTime() const
{
    return epromWritten && !config.behavior.deafWhileWriting ? config.epromTime : base::Duration();
}

void VirtualServo::State::switchOff()
{
    settings.torqueSwitch = 0;
    duty = 0;
    pendingWrite.reset();
    moveStored = false;
    moving = false;
    deafLeft = {};
    rebootLeft = {};
}

void VirtualServo::State::restart()
{
    switchOff();
    rebootLeft = std::max(config.rebootTime, base::Duration(1));
}

void VirtualServo::State::loadDefaults()
{
    // Fast until told otherwise, as a Feetech servo starts.
    if (!traits.lx) {
        settings = readSettings(memory, map, *profile, traits, type);
        map.put(memory, Role::GoalSpeed, settings.maxSpeed / settings.speedUnit);
    }
    copyRegisters(startLoads, *profile, map, memory);
    loadGains();
    settings = readSettings(memory, map, *profile, traits, type);
}

/// HLS: what acts now depends on the mode.
void VirtualServo::State::loadGains()
{
    if (!traits.liveGains) {
        return;
    }
    if (settings.mode == DriveMode::Speed) {
        copyRegisters(speedGains, *profile, map, memory);
    } else {
        copyRegisters(positionGains, *profile, map, memory);
    }
}

void VirtualServo::State::switchOn()
{
    memory.powerOn();
    loadDefaults();
    loadBaud();
    protection.reset();
    volts = mechanics.supplyVolts(config.environment) * traits.rawPerVolt;
    encoder.reset(mechanics.angle());
    encoderCount = encoder.sample(mechanics.angle(), ticks);
    speed = reportedSpeed = 0;
    restTicks = stillTicks = 0;
    resetTurnBase();
    controller.energize(position);
    stepGoal = position;
    restGoal.reset();
    goalWritten = false;
}

/// A family without a baud register has one rate.
void VirtualServo::State::loadBaud()
{
    const catalog::Register* codes = profile->byRole(Role::BaudRate);
    if (codes == nullptr) {
        return;
    }
    const int code = map.read(memory, Role::BaudRate);
    for (const catalog::NamedValue& value : codes->values) {
        if (value.value == code) {
            baud = value.key.toInt();
        }
    }
}

/// SMS and SMCL count in 2 µs and act upon 1–49 like 50; Modbus counts in 1 µs from the silence
/// after the request on. The turn-around of an LX servo is not published.
base::Duration VirtualServo::State::replyDelay() const
{
    constexpr base::Duration minReplyDelay(40);
    constexpr base::Duration lxTurnAround(300);
    const Field& field = map.at(Role::ReturnDelay);
    if (traits.modbus) {
        return base::Duration(map.read(memory, field));
    }
    const int raw = field.exists() ? map.read(memory, field) : 0;
    if (raw == 0) {
        return traits.lx ? lxTurnAround : minReplyDelay;
    }
    return base::Duration(2 * std::max(raw, 50));
}
} // namespace sim

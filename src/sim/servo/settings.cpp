// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/settings.h"

#include "catalog/value.h"
#include "sim/servo/protection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
using catalog::Role;

constexpr int unreachable = 1 << 20;         ///< duty, ms or current that is not reached
constexpr double ampsPerUnit = 0.0065;       ///< of the current registers
constexpr double stepsPerAcceleration = 100; ///< step/s² of one raw, in every family

struct Reader {
    const Memory& memory;
    const RegisterMap& map;
    const catalog::Profile& profile;
    const ServoTraits& traits;

    int operator()(Role role, int fallback = 0) const { return map.read(memory, role, fallback); }

    int byKey(const QString& key) const
    {
        const catalog::Register* reg = profile.find(key);
        return reg == nullptr ? 0 : map.read(memory, fieldOf(*reg));
    }
    catalog::ValueFormat meaning(const catalog::Register& reg) const
    {
        return catalog::valueFormat(reg, profile,
                                    [this](const QString& key) { return byKey(key); });
    }
    /// In the meaning that the present mode gives the register.
    int decoded(Role role) const
    {
        const catalog::Register* reg = profile.byRole(role);
        if (reg == nullptr) {
            return 0;
        }
        return int(catalog::decodeRaw(memory.view(reg->offset, reg->size), *reg, meaning(*reg),
                                      profile.byteOrder));
    }
    /// A percentage as duty, in any unit of the register.
    int duty(Role role, int fallback) const
    {
        return map.at(role).exists() ? int(std::lround(map.physical(memory, role) * 10.0))
                                     : fallback;
    }
    int milliseconds(Role role, int fallback) const
    {
        return int(std::lround(map.physical(memory, role, fallback)));
    }
};

void readMode(Settings& s, const Reader& read)
{
    s.minAngle = read(Role::MinAngle);
    s.maxAngle = read(Role::MaxAngle);
    s.limitsZero = s.minAngle == 0 && s.maxAngle == 0;
    s.torqueSwitch = read(Role::TorqueSwitch);
    const ModeRule& mode = read.traits.modeOf(read(Role::OperatingMode), s.limitsZero);
    s.mode = mode.drive;
    s.command = mode.command;
    s.releaseAtGoal = mode.release;
}

void readPhase(Settings& s, const Reader& read, const ServoType& type)
{
    const int phase = read(Role::Phase);
    const PhaseMasks& masks = read.traits.phase;
    const auto has = [phase](int mask) { return (phase & mask) != 0; };
    s.driveSign = has(masks.driveDirection) ? -1.0 : 1.0;
    s.reversed = has(masks.feedbackDirection);
    s.fullAngle = has(masks.fullAngle);
    s.zeroSpeedIsMaximum =
        !read.traits.zeroSpeedStops && (masks.zeroIsMaximum == 0 || has(masks.zeroIsMaximum));
    s.hasCurrentSensing = type.currentSensing && !has(masks.integratedBridge);
    s.goalEnergizes = !read.traits.lx && !has(masks.torqueByCommand);
    if (read.traits.modbus) {
        s.release = has(masks.manualReset) ? FaultRelease::Cleared : FaultRelease::TurnBack;
    }
    s.offset = read(Role::PositionOffset);
    s.resolution = std::max(1, read(Role::AngleResolution, 1));
}

/// Goals and limits of a motion. LX: the speed belongs to motor mode, a move has a time only.
void readGoals(Settings& s, const Reader& read, const ServoType& type)
{
    s.maxSpeed = maximumSpeed(type, read.traits);
    if (const catalog::Register* speed = read.profile.byRole(Role::GoalSpeed)) {
        const double degrees = 180.0 / std::numbers::pi / read.traits.stepsPerRadian;
        const catalog::ValueFormat meaning = read.meaning(*speed);
        s.speedUnit = meaning.unit == QLatin1String("rpm")
                          ? std::max(1, int(std::lround(meaning.scale * 6.0 / degrees)))
                          : 1;
    }
    if (!read.traits.lx) {
        s.goalSpeed =
            std::clamp(read.decoded(Role::GoalSpeed) * s.speedUnit, -s.maxSpeed, s.maxSpeed);
    }
    s.goalPosition = read(Role::GoalPosition) * s.resolution;
    s.goalTime = read(Role::GoalTime);
    s.acceleration = read(Role::Acceleration) * stepsPerAcceleration;
    if (s.mode == DriveMode::Pwm) {
        // Positive PWM turns counter-clockwise on Feetech servos; LX does not state it: forward.
        const int pwm = std::clamp(read.decoded(s.command), -1000, 1000);
        s.pwm = read.traits.lx ? -pwm : pwm;
    }
    if (read.traits.currentLimited) {
        s.goalAmps = read.decoded(Role::GoalCurrent) * ampsPerUnit;
        s.currentLimit = std::abs(s.goalAmps);
    }
    const Role limit =
        read.map.at(Role::TorqueLimit).exists() ? Role::TorqueLimit : Role::MaxTorque;
    s.torqueLimit = std::min(read(limit, 1000), 1000);
}

/// P counts a quarter and D an eighth (register sheet), HLS the other way round, as printed; D
/// looks at the change of the error over the 20 ms of the firmware's D control time. What I counts
/// is not published: 4 duty/s for each step. LX has no gains to read, SMCL none for speed.
void readGains(Settings& s, const Reader& read, const ServoType& type)
{
    constexpr double controlTime = 0.020;
    const bool live = read.traits.liveGains;
    const int kp = live ? read.byKey(QStringLiteral("kp")) : 0;
    const int kd = live ? read.byKey(QStringLiteral("kd")) : 0;
    const int ki = live ? read.byKey(QStringLiteral("ki")) : 0;
    s.positionP = live ? kp / 8.0 : read(Role::PositionP, type.positionP) / 4.0;
    s.positionD = (live ? kd / 4.0 : read(Role::PositionD, type.positionD) / 8.0) * controlTime;
    s.positionI = live ? 0.0 : read(Role::PositionI) * 4.0;
    s.integralLimit = read(Role::IntegralLimit) * 4.0;
    s.startupForce = read(Role::StartupForce);
    s.cwDeadZone = read(Role::CwDeadZone);
    s.ccwDeadZone = read(Role::CcwDeadZone);
    s.speedP = (live ? kp : read(Role::SpeedP, type.speedP)) * 0.02;
    s.speedI = (live ? ki : read(Role::SpeedI, type.speedI)) * 0.02;
}

/// The LX mask has an order of its own. Its stall bit is not explained: full drive for a second.
void readLxProtection(Settings& s, const Reader& read)
{
    const int mask = read(Role::LedCondition);
    s.ledCondition = ((mask & 1) != 0 ? TemperatureBit : 0) | ((mask & 2) != 0 ? VoltageBit : 0) |
                     ((mask & 4) != 0 ? OverloadBit : 0);
    s.led = read(Role::Led) == 0;
    s.unloadCondition = VoltageBit | TemperatureBit;
    s.overloadDuty = 900;
    s.overloadTime = 1000;
    s.overcurrent = unreachable;
}

void readProtection(Settings& s, const Reader& read)
{
    s.maxTemperature = read(Role::MaxTemperature);
    s.maxVoltage = read(Role::MaxVoltage);
    s.minVoltage = read(Role::MinVoltage);
    if (read.traits.lx) {
        readLxProtection(s, read);
        return;
    }
    s.unloadCondition = read(Role::UnloadCondition);
    s.ledCondition = read(Role::LedCondition);
    s.led = s.ledCondition != 0;
    // A family watches nothing without a register for it: no overload in HLS, no overcurrent in
    // SCS.
    s.overloadDuty = read.duty(Role::OverloadTorque, unreachable);
    s.overloadTime = read.milliseconds(Role::ProtectionTime, unreachable);
    s.holdDuty = std::min(read.duty(Role::ProtectionTorque, unreachable), 1000);
    s.overcurrent = read(Role::ProtectionCurrent, unreachable);
    s.overcurrentTime = read.milliseconds(Role::OvercurrentTime, unreachable);
}

UnlockedArea unlockedAreaFor(int lock, bool modbus)
{
    constexpr int factory = 128;
    if (lock == 0) {
        return UnlockedArea::Eprom;
    }
    return modbus && lock == factory ? UnlockedArea::Factory : UnlockedArea::Nothing;
}
} // namespace

Settings readSettings(const Memory& memory, const RegisterMap& map, const catalog::Profile& profile,
                      const ServoTraits& traits, const ServoType& type)
{
    const Reader read{memory, map, profile, traits};
    Settings s;
    s.id = read(Role::Id);
    s.responseLevel = read(Role::ResponseLevel, 1);
    s.unlocked = unlockedAreaFor(read(Role::Lock, 1), traits.modbus);
    readMode(s, read);
    readPhase(s, read, type);
    readGoals(s, read, type);
    readGains(s, read, type);
    readProtection(s, read);
    return s;
}
} // namespace sim

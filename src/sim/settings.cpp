// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/settings.h"

#include <algorithm>

namespace sim {
namespace {
using catalog::Role;

constexpr int speedStep = 50; ///< step/s of the coarse speed unit

struct Reader {
    const Memory& memory;
    const RegisterMap& map;
    int operator()(Role role, int fallback = 0) const { return map.read(memory, role, fallback); }
};

/// 44 is magnitude and bit 10 wherever it drives the motor, whatever else it is in other modes.
int pwmWord(int word)
{
    const int magnitude = std::min(word & 0x3FF, 1000);
    return (word & 0x400) != 0 ? -magnitude : magnitude;
}

void readMode(Settings& s, const Reader& read, bool scs)
{
    s.minAngle = read(Role::MinAngle);
    s.maxAngle = read(Role::MaxAngle);
    s.limitsZero = s.minAngle == 0 && s.maxAngle == 0;
    s.torqueSwitch = read(Role::TorqueSwitch);
    if (scs) {
        s.mode = s.limitsZero ? DriveMode::Pwm : DriveMode::Position;
    } else {
        const int mode = read(Role::OperatingMode);
        s.mode = mode <= int(DriveMode::Step) ? DriveMode(mode) : DriveMode::Position;
    }
    const bool hasPwm = read.map.at(Role::GoalPwm).exists();
    switch (s.mode) {
    case DriveMode::Speed:
        s.command = Role::GoalSpeed;
        break;
    case DriveMode::Pwm:
        s.command = hasPwm ? Role::GoalPwm : Role::GoalTime;
        break;
    default:
        s.command = Role::GoalPosition;
    }
    const Role word44 = hasPwm ? Role::GoalPwm : Role::GoalTime;
    s.pwm = pwmWord(read.map.readUnsigned(read.memory, word44));
    s.goalTime = read.map.readUnsigned(read.memory, Role::GoalTime);
}

void readPhase(Settings& s, const Reader& read, bool scs, const ServoType& type, bool sts)
{
    const int phase = read(Role::Phase);
    s.driveSign = (phase & 1) != 0 ? -1.0 : 1.0;
    s.zeroSpeedIsMaximum = (phase & 8) != 0;
    s.senseCurrent = type.currentSensing && !(sts && (phase & 32) != 0);
    if (!scs) {
        s.fineSpeed = (phase & 4) != 0;
        s.fullAngle = (phase & 16) != 0;
        s.reversed = (phase & 128) != 0;
    }
    s.offset = read(Role::PositionOffset);
    s.resolution = std::max(1, read(Role::AngleResolution, 1));
}

/// P counts a quarter and D an eighth (register sheet); D looks at the change of the error over the
/// 20 ms of the firmware's D control time. What I counts is not published: 4 duty/s for each step.
void readGains(Settings& s, const Reader& read)
{
    s.positionP = read(Role::PositionP) / 4.0;
    s.positionD = read(Role::PositionD) / 8.0 * 0.020;
    s.positionI = read(Role::PositionI) * 4.0;
    s.integralLimit = read(Role::IntegralLimit) * 4.0;
    s.startupForce = read(Role::StartupForce);
    s.cwDeadZone = read(Role::CwDeadZone);
    s.ccwDeadZone = read(Role::CcwDeadZone);
    s.speedP = read(Role::SpeedP) * 0.02;
    s.speedI = read(Role::SpeedI) * 0.02;
}

void readProtection(Settings& s, const Reader& read)
{
    s.unloadCondition = read(Role::UnloadCondition);
    s.ledCondition = read(Role::LedCondition);
    s.maxTemperature = read(Role::MaxTemperature);
    s.maxVoltage = read(Role::MaxVoltage);
    s.minVoltage = read(Role::MinVoltage);
    s.overloadDuty = read(Role::OverloadTorque) * 10;
    s.overloadTime = read(Role::ProtectionTime) * 10;
    s.holdDuty = std::min(read(Role::ProtectionTorque) * 10, 1000);
    constexpr int never = 1 << 20; // SCS has no overcurrent protection
    s.overcurrent = read(Role::ProtectionCurrent, never);
    s.overcurrentTime = read(Role::OvercurrentTime) * 10;
}
} // namespace

Settings readSettings(const Memory& memory, const RegisterMap& map, const catalog::Profile& profile,
                      const ServoType& type)
{
    const Reader read{memory, map};
    const bool scs = isScs(profile);
    Settings s;
    s.id = read(Role::Id);
    s.responseLevel = read(Role::ResponseLevel, 1);
    s.locked = read(Role::Lock, 1) != 0;
    readMode(s, read, scs);
    readPhase(s, read, scs, type, !scs && !isSms(profile));
    readGains(s, read);
    readProtection(s, read);
    const int unit = s.fineSpeed ? 1 : speedStep;
    s.maxSpeed = maximumSpeed(type, profile);
    s.goalSpeed = std::clamp(read(Role::GoalSpeed) * unit, -s.maxSpeed, s.maxSpeed);
    s.goalPosition = read(Role::GoalPosition) * s.resolution;
    s.acceleration = read(Role::Acceleration) * 100.0;
    const Role limit = map.at(Role::TorqueLimit).exists() ? Role::TorqueLimit : Role::MaxTorque;
    s.torqueLimit = std::min(read(limit, 1000), 1000);
    return s;
}
} // namespace sim

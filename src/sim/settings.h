// SPDX-License-Identifier: GPL-3.0-or-later
// The registers the control loops and protections work with, decoded once after each write, so that
// a step of time never touches the memory table. Plain values; their servo's thread.
// Units: steps, step/s, duty in 0.1 % (−1000…1000), time in ms.
#pragma once

#include "sim/register_map.h"
#include "sim/servo_types.h"

namespace sim {
enum class DriveMode : std::uint8_t { Position, Speed, Pwm, Step };

struct Settings {
    int id = 1;
    int responseLevel = 1;
    bool locked = true;
    DriveMode mode = DriveMode::Position;
    catalog::Role command = catalog::Role::GoalPosition; ///< the register that drives this mode
    bool limitsZero = false; ///< 9 = 11 = 0: multi-turn (STS, SMS), motor mode (SCS)
    int torqueSwitch = 0;

    int minAngle = 0;
    int maxAngle = 0;
    int goalPosition = 0;    ///< steps of the sensor: the register × angle resolution
    int pwm = 0;             ///< 44 in the modes that drive with it
    int goalTime = 0;        ///< ms, SCS
    int goalSpeed = 0;       ///< step/s, sign as in the register
    int maxSpeed = 0;        ///< step/s
    double acceleration = 0; ///< step/s², 0: as fast as it can
    bool zeroSpeedIsMaximum = false;

    double positionP = 0;     ///< duty per step
    double positionD = 0;     ///< duty per step/s
    double positionI = 0;     ///< duty per step·s
    double integralLimit = 0; ///< duty
    double startupForce = 0;  ///< duty
    int cwDeadZone = 0;
    int ccwDeadZone = 0;
    double speedP = 0; ///< duty per step/s
    double speedI = 0; ///< duty per step
    double torqueLimit = 1000;

    double driveSign = 1;     ///< phase bit 0
    bool reversed = false;    ///< phase bit 7
    bool fullAngle = false;   ///< phase bit 4
    bool fineSpeed = true;    ///< phase bit 2; SCS always
    bool senseCurrent = true; ///< phase bit 5, or a family without it
    int offset = 0;
    int resolution = 1;

    int unloadCondition = 0;
    int ledCondition = 0;
    int maxTemperature = 0;
    int maxVoltage = 0;
    int minVoltage = 0;
    int overloadDuty = 0; ///< 36 × 10
    int overloadTime = 0;
    int holdDuty = 0;    ///< 34 × 10
    int overcurrent = 0; ///< 6.5 mA units
    int overcurrentTime = 0;
};

Settings readSettings(const Memory& memory, const RegisterMap& map, const catalog::Profile& profile,
                      const ServoType& type);
} // namespace sim

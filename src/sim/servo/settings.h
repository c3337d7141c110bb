// SPDX-License-Identifier: GPL-3.0-or-later
// The registers the control loops and protections work with, decoded once after each write, so that
// a step of time never touches the memory table. Plain values; their servo's thread.
// Units: steps, step/s, duty in 0.1 % (−1000…1000), time in ms.
#pragma once

#include "sim/servo/register_map.h"
#include "sim/servo/servo_traits.h"
#include "sim/servo/servo_types.h"

namespace sim {
/// What releases a latched overload or overcurrent.
enum class FaultRelease : std::uint8_t {
    Command,  ///< overcurrent any new one, overload one that turns back
    TurnBack, ///< both one that turns back, or torque off
    Cleared,  ///< nothing but the fault reset register; other faults stay as well
};

struct Settings {
    int id = 1;
    int responseLevel = 1;
    UnlockedArea unlocked = UnlockedArea::Nothing;
    DriveMode mode = DriveMode::Position;
    catalog::Role command = catalog::Role::GoalPosition; ///< the register that drives this mode
    bool releaseAtGoal = false;
    bool limitsZero = false; ///< 9 = 11 = 0: multi-turn (STS, SMS), motor mode (SCS)
    int torqueSwitch = 0;
    bool goalEnergizes = true; ///< writing a goal switches the torque on

    int minAngle = 0;
    int maxAngle = 0;
    int goalPosition = 0;    ///< steps of the sensor: the register × angle resolution
    int pwm = 0;             ///< the command register in PWM mode
    double goalAmps = 0;     ///< HLS 44 in current mode, signed
    double currentLimit = 0; ///< A; HLS, positive
    int goalTime = 0;        ///< ms; SCS, LX
    int goalSpeed = 0;       ///< step/s, sign as in the register
    int speedUnit = 1;       ///< step/s of one raw
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

    double driveSign = 1;          ///< −1: phase reverses the bridge
    bool reversed = false;         ///< phase reverses the feedback
    bool fullAngle = false;        ///< feedback counts turns
    bool hasCurrentSensing = true; ///< phase bit 5, or a family without it
    int offset = 0;
    int resolution = 1;

    FaultRelease release = FaultRelease::Command;
    int unloadCondition = 0;
    int ledCondition = 0;
    bool led = true; ///< LX: on while nothing is wrong
    int maxTemperature = 0;
    int maxVoltage = 0; ///< as the voltage registers count
    int minVoltage = 0;
    int overloadDuty = 0;
    int overloadTime = 0;
    int holdDuty = 0;    ///< what an overload leaves
    int overcurrent = 0; ///< 6.5 mA units
    int overcurrentTime = 0;
};

Settings readSettings(const Memory& memory, const RegisterMap& map, const catalog::Profile& profile,
                      const ServoTraits& traits, const ServoType& type);
} // namespace sim

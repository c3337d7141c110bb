// SPDX-License-Identifier: GPL-3.0-or-later
// How a family's firmware reads its registers, taken from the profile once: sensor, units, phase
// bits, modes. What no sheet states is decided here, with a comment. Pure values; any thread.
#pragma once

#include "catalog/profile.h"

#include <vector>

namespace sim {
enum class Sensor : std::uint8_t {
    Continuous,    ///< magnetic, counts turns
    Potentiometer, ///< a dead sector behind its range
    OneTurn,       ///< LX: a range of 240°, but readings all the way round
};

enum class DriveMode : std::uint8_t {
    Position,
    Direct, ///< HLS 4: position PD within one turn
    Speed,
    Current,
    Pwm,
    Step,
};

/// A mode as the registers choose it.
struct ModeRule {
    std::optional<int> value; ///< of the mode register, where there is one
    bool limitsZero = false;  ///< minimum and maximum angle both 0
    DriveMode drive = DriveMode::Position;
    catalog::Role command = catalog::Role::GoalPosition; ///< the register that drives it
    bool release = false;                                ///< Modbus 3: torque off at the goal
};

/// Masks of the phase register; 0: this family has no such bit.
struct PhaseMasks {
    int driveDirection = 0;
    int zeroIsMaximum = 0;
    int fullAngle = 0;
    int integratedBridge = 0; ///< no current feedback
    int feedbackDirection = 0;
    int torqueByCommand = 0; ///< a goal does not switch the torque on
    int manualReset = 0;     ///< faults stay until they are cleared
};

struct ServoTraits {
    Sensor sensor = Sensor::Continuous;
    double stepsPerRadian = 0;
    int turnSteps = 4096;
    double rawPerVolt = 10;
    PhaseMasks phase;
    std::vector<ModeRule> modes; ///< the first that fits
    bool liveGains = false;      ///< HLS: 50–52 act, the EPROM only loads them
    bool currentLimited = false; ///< HLS: 44
    bool zeroSpeedStops = false; ///< HLS: 46
    bool lx = false;             ///< no torque by itself, holds when loaded, no status register
    bool modbus = false;         ///< faults are released by turning back or by torque off

    const ModeRule& modeOf(int value, bool limitsZero) const;
};

ServoTraits traitsOf(const catalog::Profile& profile);
} // namespace sim

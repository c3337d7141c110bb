// SPDX-License-Identifier: GPL-3.0-or-later
// What the servo tells about itself: registers 56–70 and the LED.
#include "sim/servo/servo_state.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
using catalog::Role;

/// Even in the fine unit the firmware measures speed in steps of 50 step/s, and calls less than
/// one of them standing still.
int reportedSpeedSteps(double stepsPerSecond)
{
    return std::abs(stepsPerSecond) < minReportedSpeed
               ? 0
               : int(std::lround(stepsPerSecond / 50.0)) * 50;
}
} // namespace

/// Signed like the load; the sensor's range ends where its protection's does.
double VirtualServo::State::sensedCurrent() const
{
    constexpr double ampsPerUnit = 0.0065;
    if (!settings.hasCurrentSensing) {
        return 0.0;
    }
    const double units = -mechanics.motorAmps() * settings.driveSign / ampsPerUnit;
    return std::clamp<double>(units, -type.maxCurrent, type.maxCurrent);
}

/// Whole steps, of the register only.
double VirtualServo::State::readingNoise() const
{
    const double deviation = config.defects.positionNoise;
    return deviation == 0.0 ? 0.0 : std::round(deviation * encoder.gaussianNoise(ticks));
}

void VirtualServo::State::updateFeedback()
{
    const auto put = [this](Role role, double value) {
        map.put(memory, role, int(std::lround(value)));
    };
    double shown = position + readingNoise();
    if (encoder.isContinuous() && settings.mode == DriveMode::Step) {
        shown = stepGoal - shown;
    } else if (encoder.isContinuous() && !settings.fullAngle) {
        const double turn = traits.turnSteps;
        shown -= turn * std::floor(shown / turn);
    }
    put(Role::PresentPosition, shown);
    const int stepsPerSecond = reportedSpeedSteps(reportedSpeed);
    put(Role::PresentSpeed, double(stepsPerSecond) / settings.speedUnit);
    // The bridge drives larger positions with negative duty: 44 = 200 turns counter-clockwise with
    // 58 negative and 60 positive.
    put(Role::PresentLoad, -duty);
    const bool showVolts = settings.maxVoltage != 0 || settings.minVoltage != 0;
    put(Role::PresentVoltage, showVolts ? volts : 0.0);
    put(Role::PresentTemperature, celsius);
    put(Role::AsyncFlag, pendingWrite ? 1 : 0);
    put(Role::Status, reportedStatus());
    put(Role::Moving, reportedMoving());
    put(Role::ActiveGoal, controller.path().position);
    put(Role::PresentCurrent, sensedCurrent());
}

/// Modbus: bit 4 is a state, not a fault.
int VirtualServo::State::reportedStatus() const
{
    constexpr int torqueOn = 16;
    return protection.status() | (traits.modbus && settings.torqueSwitch == 1 ? torqueOn : 0);
}

/// HLS has two flags: faster than the threshold, and on the way to the goal.
int VirtualServo::State::reportedMoving() const
{
    if (const auto stuck = config.defects.movingFlagStuck) {
        const int all = type.movingBits ? 3 : 1;
        return *stuck ? all : 0;
    }
    if (!type.movingBits) {
        return moving ? 1 : 0;
    }
    return (std::abs(reportedSpeed) < minReportedSpeed ? 0 : 1) | (moving ? 2 : 0);
}

/// A fault that its condition names blinks it; without one it shines if there is a condition, on LX
/// as its own register says.
bool VirtualServo::State::led() const
{
    if (!isRunning()) {
        return false;
    }
    if ((protection.status() & settings.ledCondition) != 0) {
        return ticks / 250 % 2 == 0;
    }
    return settings.led;
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// What the servo tells about itself: registers 56–70 and the LED.
#include "sim/servo_state.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
using catalog::Role;

/// Even in the fine unit the firmware measures speed in steps of 50 step/s, and calls less than
/// one of them standing still.
int shownSpeedSteps(double stepsPerSecond)
{
    return std::abs(stepsPerSecond) < slowestShown ? 0
                                                   : int(std::lround(stepsPerSecond / 50.0)) * 50;
}
} // namespace

/// Signed like the load; the sensor's range ends at 9 bits.
double VirtualServo::State::sensedCurrent() const
{
    constexpr double ampsPerUnit = 0.0065;
    constexpr double largest = 511;
    if (!settings.senseCurrent) {
        return 0.0;
    }
    const double units = -mechanics.motorAmps() * settings.driveSign / ampsPerUnit;
    return std::clamp(units, -largest, largest);
}

void VirtualServo::State::publish()
{
    const auto put = [this](Role role, double value) {
        map.put(memory, role, int(std::lround(value)));
    };
    double shown = position;
    if (encoder.endless() && settings.mode == DriveMode::Step) {
        shown = stepGoal - position;
    } else if (encoder.endless() && !settings.fullAngle) {
        const double turn = profile->stepsPerTurn;
        shown = position - turn * std::floor(position / turn);
    }
    put(Role::PresentPosition, shown);
    const int stepsPerSecond = shownSpeedSteps(shownSpeed);
    put(Role::PresentSpeed, settings.fineSpeed ? stepsPerSecond : stepsPerSecond / 50);
    // The bridge drives larger positions with negative duty: 44 = 200 turns counter-clockwise with
    // 58 negative and 60 positive.
    put(Role::PresentLoad, -duty);
    const bool showVolts = settings.maxVoltage != 0 || settings.minVoltage != 0;
    put(Role::PresentVoltage, showVolts ? volts : 0.0);
    put(Role::PresentTemperature, celsius);
    put(Role::AsyncFlag, held ? 1 : 0);
    put(Role::Status, protection.status());
    put(Role::Moving, moving ? 1 : 0);
    put(Role::ActiveGoal, controller.path().position);
    put(Role::PresentCurrent, sensedCurrent());
}

/// A fault that 20 names blinks it; without one it shines if 20 is not 0.
bool VirtualServo::State::led() const
{
    if (!alive()) {
        return false;
    }
    if ((protection.status() & settings.ledCondition) != 0) {
        return ticks / 250 % 2 == 0;
    }
    return settings.ledCondition != 0;
}
} // namespace sim

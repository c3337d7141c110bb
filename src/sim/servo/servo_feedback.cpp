// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_feedback.h"

#include <cmath>

namespace sim {
using catalog::Role;

ServoFeedback::ServoFeedback(const ServoModel& model, const ServoConfig& config,
                             RegisterStore& registers, const ServoDrive& drive,
                             const ServoHealth& health, const Protection& protection)
    : m_model(model)
    , m_config(config)
    , m_registers(registers)
    , m_drive(drive)
    , m_health(health)
    , m_protection(protection)
{}

void ServoFeedback::update()
{
    const auto put = [this](Role role, double value) {
        m_registers.put(role, int(std::lround(value)));
    };
    put(Role::PresentPosition, shownPosition());
    put(Role::PresentSpeed, double(shownSpeed()) / m_registers.settings().speedUnit);
    // Negative duty drives towards larger positions: 44 = 200 turns counter-clockwise with 58
    // negative and 60 positive.
    put(Role::PresentLoad, -m_drive.duty());
    put(Role::PresentVoltage, m_health.watchesVoltage() ? m_health.volts() : 0.0);
    put(Role::PresentTemperature, m_health.celsius());
    put(Role::Status, status());
    put(Role::Moving, movingFlags());
    put(Role::ActiveGoal, m_drive.pathPosition());
    put(Role::PresentCurrent, m_drive.sensedCurrent());
}

double ServoFeedback::shownPosition() const
{
    const PositionSensor& sensor = m_drive.sensor();
    const Settings& settings = m_registers.settings();
    const double position =
        sensor.position() + sensor.noise(m_config.defects.positionNoise, m_drive.ticks());
    if (sensor.isContinuous() && settings.mode == DriveMode::Step) {
        return m_drive.goal().stepGoal() - position;
    }
    if (sensor.isContinuous() && !settings.fullAngle) {
        const double turn = m_model.traits.turnSteps;
        return position - turn * std::floor(position / turn);
    }
    return position;
}

/// The firmware measures speed in steps of 50 step/s even where the register's unit is finer.
int ServoFeedback::shownSpeed() const
{
    constexpr int resolution = int(PositionSensor::speedResolution);
    const PositionSensor& sensor = m_drive.sensor();
    return sensor.isStill() ? 0
                            : int(std::lround(sensor.reportedSpeed() / resolution)) * resolution;
}

/// Modbus: bit 4 is a state, not a fault.
int ServoFeedback::status() const
{
    constexpr int torqueOn = 16;
    const bool showsTorque = m_model.traits.modbus && m_registers.settings().torqueSwitch == 1;
    return m_protection.status() | (showsTorque ? torqueOn : 0);
}

/// HLS has two flags: faster than the threshold, and on the way to the goal.
int ServoFeedback::movingFlags() const
{
    const bool twoFlags = m_model.type.movingBits;
    if (const auto stuck = m_config.defects.movingFlagStuck) {
        const int all = twoFlags ? 3 : 1;
        return *stuck ? all : 0;
    }
    if (!twoFlags) {
        return m_drive.isMoving() ? 1 : 0;
    }
    return (m_drive.sensor().isStill() ? 0 : 1) | (m_drive.isMoving() ? 2 : 0);
}

/// It blinks with a fault that the LED condition names. Without such a fault it is on if there is a
/// condition; on LX servos its own register decides.
bool ServoFeedback::isLedOn() const
{
    if ((m_protection.status() & m_registers.settings().ledCondition) != 0) {
        return m_drive.ticks() / 250 % 2 == 0;
    }
    return m_registers.settings().led;
}
} // namespace sim

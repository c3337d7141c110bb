// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_health.h"

#include <cmath>

namespace sim {
ServoHealth::ServoHealth(const ServoModel& model, const ServoConfig& config,
                         RegisterStore& registers, const ServoDrive& drive, Protection& protection)
    : m_model(model)
    , m_config(config)
    , m_registers(registers)
    , m_drive(drive)
    , m_protection(protection)
    , m_celsius(config.environment.ambientCelsius)
{}

void ServoHealth::powerOn()
{
    m_protection.reset();
    m_volts = supplyVolts();
}

void ServoHealth::tick(bool isRunning)
{
    m_celsius += (m_config.environment.ambientCelsius +
                  m_drive.mechanics().copperWatts() * m_model.type.thermalResistance - m_celsius) *
                 (Controller::tick / m_model.type.thermalTime);
    if (isRunning) {
        watch();
    }
}

void ServoHealth::watch()
{
    constexpr double voltageShare = 0.05; // smoothing over 20 ms
    const Settings& settings = m_registers.settings();
    m_volts += (supplyVolts() - m_volts) * voltageShare;
    m_protection.update(settings,
                        {m_drive.duty(), std::abs(m_drive.sensedCurrent()), m_volts, m_celsius},
                        watchesVoltage());
    if (settings.release == FaultRelease::Command && m_protection.isOvercurrentTripped() &&
        settings.torqueSwitch != 0) {
        m_registers.setTorque(0);
    }
}

bool ServoHealth::watchesVoltage() const
{
    return m_registers.settings().maxVoltage != 0 || m_registers.settings().minVoltage != 0;
}

double ServoHealth::supplyVolts() const
{
    return m_drive.mechanics().supplyVolts(m_config.environment) * m_model.traits.rawPerVolt;
}
} // namespace sim

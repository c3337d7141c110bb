// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature and supply voltage of a servo, and what its protections are fed with. Owned by a
// ServoFirmware; one thread; one call a millisecond. °C, and volts as the voltage registers count.
#pragma once

#include "sim/servo/servo_drive.h"

namespace sim {
class ServoHealth {
public:
    /// All arguments must outlive it; `config` may change meanwhile.
    ServoHealth(const ServoModel& model, const ServoConfig& config, RegisterStore& registers,
                const ServoDrive& drive, Protection& protection);

    void powerOn();
    void tick(bool isRunning); ///< the servo cools and warms without power as well

    double celsius() const { return m_celsius; }
    void setCelsius(double celsius) { m_celsius = celsius; }
    double volts() const { return m_volts; }
    bool watchesVoltage() const; ///< otherwise it shows none either

private:
    double supplyVolts() const;
    void watch();

    const ServoModel& m_model;
    const ServoConfig& m_config;
    RegisterStore& m_registers;
    const ServoDrive& m_drive;
    Protection& m_protection;
    double m_celsius;
    double m_volts = 0;
};
} // namespace sim

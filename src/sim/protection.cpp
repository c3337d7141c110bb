// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/protection.h"

#include <algorithm>
#include <cmath>

namespace sim {
void Protection::mark(StatusBit bit, bool present)
{
    m_faults = std::uint8_t(present ? m_faults | bit : m_faults & ~bit);
}

/// A trip that 19 does not ask for is still shown for as long as its cause lasts.
void Protection::watchOverload(const Settings& s, double duty)
{
    m_overloadTicks = std::abs(duty) > s.overloadDuty ? m_overloadTicks + 1 : 0;
    const bool tooLong = m_overloadTicks > s.overloadTime;
    if (tooLong && (s.unloadCondition & OverloadBit) != 0 && !m_overload) {
        m_overload = true;
        m_stallDirection = duty > 0.0 ? 1.0 : -1.0;
    }
    mark(OverloadBit, m_overload || tooLong);
}

void Protection::watchCurrent(const Settings& s, double current)
{
    m_overcurrentTicks = s.senseCurrent && current > s.overcurrent ? m_overcurrentTicks + 1 : 0;
    const bool tooLong = m_overcurrentTicks > s.overcurrentTime;
    m_overcurrent = m_overcurrent || (tooLong && (s.unloadCondition & CurrentBit) != 0);
    mark(CurrentBit, m_overcurrent || tooLong);
}

void Protection::update(const Settings& s, const Measured& now, bool watchVoltage)
{
    watchOverload(s, now.duty);
    watchCurrent(s, now.current);
    // What is judged is what is shown.
    const long volts = std::lround(now.volts);
    mark(VoltageBit, watchVoltage && (volts > s.maxVoltage || volts < s.minVoltage));
    mark(TemperatureBit, std::lround(now.celsius) > s.maxTemperature);
}

bool Protection::commanded(double direction)
{
    const bool opposite = m_overload && direction * m_stallDirection < 0.0;
    const bool released = m_overcurrent || opposite;
    m_overcurrent = false;
    m_overcurrentTicks = 0;
    if (opposite) {
        m_overload = false;
        m_overloadTicks = 0;
    }
    return released;
}

bool Protection::unloads(const Settings& s) const
{
    constexpr int unloading = VoltageBit | SensorBit | TemperatureBit;
    return m_overcurrent || (status() & s.unloadCondition & unloading) != 0;
}

double Protection::dutyLimit(const Settings& s) const
{
    return m_overload ? std::min<double>(s.torqueLimit, s.holdDuty) : s.torqueLimit;
}
} // namespace sim

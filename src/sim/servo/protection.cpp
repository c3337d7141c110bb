// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/protection.h"

#include <algorithm>
#include <cmath>

namespace sim {
void Protection::setFault(const Settings& s, StatusBit bit, bool present)
{
    if (present) {
        m_faults = std::uint8_t(m_faults | bit);
    } else if (s.release != FaultRelease::Cleared) {
        m_faults = std::uint8_t(m_faults & ~bit);
    }
}

/// A fault that is not in the unload condition is still shown for as long as its cause lasts.
void Protection::watchOverload(const Settings& s, double duty)
{
    m_overloadTicks = std::abs(duty) > s.overloadDuty ? m_overloadTicks + 1 : 0;
    const bool tooLong = m_overloadTicks > s.overloadTime;
    if (tooLong && (s.unloadCondition & OverloadBit) != 0 && !m_overload) {
        m_overload = true;
        m_stallDirection = duty > 0.0 ? 1.0 : -1.0;
    }
    setFault(s, OverloadBit, m_overload || tooLong);
}

void Protection::watchCurrent(const Settings& s, const Measured& now)
{
    m_overcurrentTicks =
        s.hasCurrentSensing && now.current > s.overcurrent ? m_overcurrentTicks + 1 : 0;
    const bool tooLong = m_overcurrentTicks > s.overcurrentTime;
    if (tooLong && (s.unloadCondition & CurrentBit) != 0 && !m_overcurrent) {
        m_overcurrent = true;
        m_stallDirection = now.duty > 0.0 ? 1.0 : -1.0;
    }
    setFault(s, CurrentBit, m_overcurrent || tooLong);
}

void Protection::update(const Settings& s, const Measured& now, bool watchVoltage)
{
    watchOverload(s, now.duty);
    watchCurrent(s, now);
    // Compares the values that the registers show.
    const long volts = std::lround(now.volts);
    setFault(s, VoltageBit, watchVoltage && (volts > s.maxVoltage || volts < s.minVoltage));
    setFault(s, TemperatureBit, std::lround(now.celsius) > s.maxTemperature);
}

bool Protection::newCommand(const Settings& s, double direction)
{
    if (s.release == FaultRelease::Cleared) {
        return false;
    }
    const bool isTurningBack = direction * m_stallDirection < 0.0;
    const bool current = m_overcurrent && (isTurningBack || s.release == FaultRelease::Command);
    const bool overload = m_overload && isTurningBack;
    release(current || s.release == FaultRelease::Command, overload);
    return current || overload;
}

void Protection::torqueOff(const Settings& s)
{
    const bool released = s.release == FaultRelease::TurnBack;
    release(released, released);
}

void Protection::clear(std::uint8_t bits)
{
    release((bits & CurrentBit) != 0, (bits & OverloadBit) != 0);
    m_faults = std::uint8_t(m_faults & ~bits);
    m_injected = std::uint8_t(m_injected & ~bits);
}

void Protection::release(bool current, bool overload)
{
    if (current) {
        m_overcurrent = false;
        m_overcurrentTicks = 0;
    }
    if (overload) {
        m_overload = false;
        m_overloadTicks = 0;
    }
}

bool Protection::mustUnload(const Settings& s) const
{
    constexpr int unloading = VoltageBit | SensorBit | TemperatureBit;
    return m_overcurrent || (status() & s.unloadCondition & unloading) != 0;
}

double Protection::dutyLimit(const Settings& s) const
{
    return m_overload ? std::min<double>(s.torqueLimit, s.holdDuty) : s.torqueLimit;
}
} // namespace sim

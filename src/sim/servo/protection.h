// SPDX-License-Identifier: GPL-3.0-or-later
// The servo's protections: what is watched, for how long, what happens and what releases it.
// Source: protection section of the Feetech protocol notes (register 19, 13–15, 28, 34–36, 38) and
// the Modbus table (134, 392).
// Plain class; its servo's thread; one call a millisecond.
#pragma once

#include "sim/servo/settings.h"

namespace sim {
/// Bits of register 65 and of the error byte, and of 19 and 20.
enum StatusBit : std::uint8_t {
    VoltageBit = 1,
    SensorBit = 2,
    TemperatureBit = 4,
    CurrentBit = 8,
    OverloadBit = 32,
};

class Protection {
public:
    struct Measured {
        double duty = 0;    ///< −1000…1000, towards larger positions positive
        double current = 0; ///< 6.5 mA units, unsigned
        double volts = 0;   ///< as the voltage registers count
        double celsius = 0;
    };

    void update(const Settings& s, const Measured& now, bool watchVoltage);

    /// A new command that would turn the servo this way (sign) has been written. True when that
    /// released it.
    bool newCommand(const Settings& s, double direction);
    void torqueOff(const Settings& s); ///< by the host
    void clear(std::uint8_t bits);     ///< by command; a persisting cause sets them again
    void inject(std::uint8_t bits) { m_injected = bits; }
    void reset() { *this = Protection(); } ///< power-on

    std::uint8_t status() const { return std::uint8_t(m_faults | m_injected); }
    /// A fault for which register 19 releases the torque; overload only weakens it.
    bool mustUnload(const Settings& s) const;
    bool isOvercurrentTripped() const { return m_overcurrent; }
    double dutyLimit(const Settings& s) const;

private:
    void watchOverload(const Settings& s, double duty);
    void watchCurrent(const Settings& s, const Measured& now);
    void release(bool current, bool overload);
    void setFault(const Settings& s, StatusBit bit, bool present);

    std::uint8_t m_faults = 0;
    std::uint8_t m_injected = 0;
    int m_overloadTicks = 0;
    int m_overcurrentTicks = 0;
    bool m_overload = false;    ///< latched
    bool m_overcurrent = false; ///< latched
    double m_stallDirection = 0;
};
} // namespace sim

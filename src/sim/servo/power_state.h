// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a servo has power and its firmware runs: power supply, reboot time, and the time in which
// it receives nothing because it writes its EPROM. Plain value of one servo; its thread.
#pragma once

#include "base/clock.h"
#include "sim/servo/bootloader.h"

#include <algorithm>

namespace sim {
class PowerState {
public:
    bool isOn() const { return m_on; }
    bool isRunning() const { return m_on && m_rebootLeft.count() == 0; }
    bool isRebooting() const { return m_on && m_rebootLeft.count() > 0; }
    bool isDeaf() const { return !isRunning() || m_deafLeft.count() > 0; }

    /// Its bootloader could still be reached.
    bool hasJustComeOn() const { return m_on && m_windowLeft.count() > 0; }

    void setOn(bool on)
    {
        m_windowLeft = on && !m_on ? Bootloader::window : base::Duration();
        m_on = on;
    }
    void stop() { m_deafLeft = m_rebootLeft = {}; } ///< ends both times
    void startReboot(base::Duration time) { m_rebootLeft = std::max(time, base::Duration(1)); }
    void startDeafTime(base::Duration time) { m_deafLeft = time; }

    /// True when a reboot has just ended.
    bool advance(base::Duration dt)
    {
        m_deafLeft = std::max(base::Duration(), m_deafLeft - dt);
        m_windowLeft = std::max(base::Duration(), m_windowLeft - dt);
        if (m_rebootLeft.count() == 0) {
            return false;
        }
        m_rebootLeft = std::max(base::Duration(), m_rebootLeft - dt);
        return m_rebootLeft.count() == 0;
    }

private:
    bool m_on = true;
    base::Duration m_rebootLeft{};
    base::Duration m_deafLeft{};
    base::Duration m_windowLeft{};
};
} // namespace sim

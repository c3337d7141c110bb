// SPDX-License-Identifier: GPL-3.0-or-later
// What a servo reports about itself: the registers it measures (56–70 of Feetech servos) and its
// LED. Owned by a ServoFirmware; one thread; changes nothing but those registers.
#pragma once

#include "sim/servo/servo_health.h"

namespace sim {
class ServoFeedback {
public:
    /// All arguments must outlive it; `config` may change meanwhile.
    ServoFeedback(const ServoModel& model, const ServoConfig& config, RegisterStore& registers,
                  const ServoDrive& drive, const ServoHealth& health, const Protection& protection);

    void update(); ///< before the registers are read
    bool isLedOn() const;

private:
    double shownPosition() const;
    int shownSpeed() const; ///< step/s
    int status() const;
    int movingFlags() const;

    const ServoModel& m_model;
    const ServoConfig& m_config;
    RegisterStore& m_registers;
    const ServoDrive& m_drive;
    const ServoHealth& m_health;
    const Protection& m_protection;
};
} // namespace sim

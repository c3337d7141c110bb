// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware of a simulated servo: it owns the registers, the drive and the protections, and
// decides what a write, a power-on and each millisecond do to them. Knows no protocol; the request
// handlers work on it. Owned by a VirtualServo; one thread. Nothing here can fail.
#pragma once

#include "sim/servo/bootloader.h"
#include "sim/servo/power_state.h"
#include "sim/servo/servo_feedback.h"

namespace sim {
class ServoFirmware {
public:
    ServoFirmware(catalog::ProfilePtr profile, const ServoConfig& servoConfig);
    ServoFirmware(const ServoFirmware&) = delete;
    ServoFirmware& operator=(const ServoFirmware&) = delete;

    const catalog::Profile& profile() const { return *m_model.profile; }
    const Settings& settings() const { return m_registers.settings(); }
    const ServoDrive& drive() const { return m_drive; }
    RegisterStore& registers() { return m_registers; }
    const RegisterStore& registers() const { return m_registers; }
    Protection& protection() { return m_protection; }
    const Protection& protection() const { return m_protection; }
    ServoHealth& health() { return m_health; }
    PowerState& power() { return m_power; }
    const PowerState& power() const { return m_power; }
    ServoConfig& config() { return m_config; }
    const ServoConfig& config() const { return m_config; }
    int baud() const { return m_baud; }
    base::Duration replyDelay() const;
    /// At a restart, and for good if there is no whole firmware. An LX servo is not known to have
    /// one.
    bool isInBootloader() const;
    /// Also after power-up, although the firmware of a simulated servo runs at once then.
    bool hearsFirmware() const;
    /// What its bootloader replies to a byte at Bootloader::baud, which may change its firmware.
    std::optional<Bootloader::Reply> receiveInBootloader(std::uint8_t byte);
    bool isRunning() const { return m_power.isRunning() && !isInBootloader(); }

    void advance(base::Duration dt);
    void switchOff(); ///< what ends with the power or at a restart
    void switchOn();
    void restart(); ///< by request: silent for the reboot time

    /// A write from outside, with everything it sets in motion.
    void write(int address, base::ByteView data);
    /// What a write to these bytes sets in motion, after they have changed.
    void applyChanges(int address, int count);
    void restoreBackup(); ///< everything but the ID; nothing while the lock is closed
    void setPresentPosition(int position); ///< by the offset register
    void resetTurns() { m_drive.resetTurns(); }
    void stopMove(); ///< LX: holds where it is

    void updateFeedback() { m_feedback.update(); } ///< before the registers are read
    bool ledOn() const { return isRunning() && m_feedback.isLedOn(); }

private:
    void loadBaud();
    void changeMode(DriveMode before);
    void switchTorque(int before);
    void resetFaults();
    void installFirmware();

    ServoConfig m_config;
    const ServoModel m_model;
    RegisterStore m_registers;
    Protection m_protection;
    ServoDrive m_drive;
    ServoHealth m_health;
    ServoFeedback m_feedback;
    PowerState m_power;
    Bootloader m_bootloader;
    int m_baud;
    base::Duration m_pending{}; ///< time that is not yet a whole tick
};
} // namespace sim

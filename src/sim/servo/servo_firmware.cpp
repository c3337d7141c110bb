// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_firmware.h"

#include <algorithm>
#include <array>

namespace sim {
namespace {
using catalog::Role;

constexpr int middle = 2048; ///< what a centering command makes of the present position
} // namespace

ServoFirmware::ServoFirmware(catalog::ProfilePtr profile, const ServoConfig& servoConfig)
    : m_config(servoConfig)
    , m_model(std::move(profile))
    , m_registers(m_model, m_config)
    , m_drive(m_model, m_config, m_registers, m_protection)
    , m_health(m_model, m_config, m_registers, m_drive, m_protection)
    , m_feedback(m_model, m_config, m_registers, m_drive, m_health, m_protection)
    , m_baud(m_config.baud.value_or(m_model.profile->defaultBaud.value_or(1000000)))
{
    switchOn();
}

void ServoFirmware::switchOff()
{
    m_registers.powerOff();
    m_drive.powerOff();
    m_power.stop();
    m_bootloader = {};
}

void ServoFirmware::switchOn()
{
    m_registers.powerOn();
    loadBaud();
    m_health.powerOn();
    m_drive.powerOn();
}

void ServoFirmware::restart()
{
    switchOff();
    m_power.startReboot(m_config.rebootTime);
}

void ServoFirmware::advance(base::Duration dt)
{
    constexpr base::Duration tickTime = std::chrono::milliseconds(1);
    if (m_power.advance(dt)) {
        switchOn();
    }
    for (m_pending += dt; m_pending >= tickTime; m_pending -= tickTime) {
        m_drive.tick(isRunning());
        m_health.tick(isRunning());
    }
}

bool ServoFirmware::isInBootloader() const
{
    return !m_model.traits.lx &&
           (m_power.isRebooting() || (m_power.isOn() && m_config.defects.firmwareLost));
}

bool ServoFirmware::hearsFirmware() const
{
    return isInBootloader() || (!m_model.traits.lx && m_power.hasJustComeOn());
}

std::optional<Bootloader::Reply> ServoFirmware::receiveInBootloader(std::uint8_t byte)
{
    const auto reply = m_bootloader.receive(byte);
    if (m_bootloader.isTransferring())
        m_power.startReboot(std::chrono::hours(24)); // it waits for as long as it takes
    if (m_bootloader.hasErased())
        m_config.defects.firmwareLost = true;
    if (m_bootloader.hasEnded()) {
        const bool isComplete = m_bootloader.isComplete();
        m_power.stop();
        m_bootloader = {};
        if (isComplete)
            installFirmware();
        if (!m_config.defects.firmwareLost)
            switchOn();
    }
    return reply;
}

/// What is in the file is not known: its version is the next one, and two defaults have changed.
void ServoFirmware::installFirmware()
{
    const auto change = [this](const catalog::Register* reg, int by) {
        if (reg != nullptr)
            m_registers.setInitial(*reg, m_registers.raw(*reg) + by);
    };
    m_config.defects.firmwareLost = false;
    change(profile().byRole(Role::FirmwareMinor), 1);
    change(profile().find(QStringLiteral("protection_time")), 50);
    change(profile().find(QStringLiteral("overload_torque")), -5);
}

/// A family without a baud register has one rate.
void ServoFirmware::loadBaud()
{
    m_baud = m_registers.baudRate().value_or(m_baud);
}

/// SMS and SMCL count in 2 µs and act upon 1–49 like 50; Modbus counts in 1 µs from the silence
/// after the request on. The turn-around of an LX servo is not published.
base::Duration ServoFirmware::replyDelay() const
{
    constexpr base::Duration minReplyDelay(40);
    constexpr base::Duration lxTurnAround(300);
    const Field& field = m_registers.field(Role::ReturnDelay);
    if (m_model.traits.modbus) {
        return base::Duration(m_registers.read(field));
    }
    const int raw = field.exists() ? m_registers.read(field) : 0;
    if (raw == 0) {
        return m_model.traits.lx ? lxTurnAround : minReplyDelay;
    }
    return base::Duration(2 * std::max(raw, 50));
}

void ServoFirmware::write(int address, base::ByteView data)
{
    applyChanges(address, m_registers.write(address, data));
}

void ServoFirmware::restoreBackup()
{
    if (m_registers.restoreBackup()) {
        applyChanges(0, m_registers.field(Role::TorqueSwitch).address);
    }
}

void ServoFirmware::applyChanges(int address, int count)
{
    const auto isTouched = [&](Role role) {
        return m_registers.field(role).overlaps(address, count);
    };
    const Settings before = settings();
    const double goalBefore = m_drive.goal().position();
    if (isTouched(Role::GoalPosition) && !m_model.traits.lx) {
        m_drive.goalRegisterWritten();
    }
    m_registers.reload();

    if (settings().id != before.id && !m_registers.secondaryId().overlaps(address, count)) {
        m_registers.copyIdToSecondary();
    }
    if (isTouched(Role::OperatingMode)) {
        changeMode(before.mode);
    }
    if (isTouched(Role::BaudRate) && !m_config.behavior.baudAfterRestart) {
        loadBaud();
    }
    if (settings().offset != before.offset || settings().reversed != before.reversed) {
        m_drive.resetTurns();
    }
    if (isTouched(Role::FaultReset)) {
        resetFaults();
    }
    if (isTouched(Role::TorqueSwitch)) {
        switchTorque(before.torqueSwitch);
    }
    if (isTouched(settings().command)) {
        // A write that includes the torque switch decides about the torque itself.
        m_drive.command(!isTouched(Role::TorqueSwitch), goalBefore);
    }
    if (settings().mode != before.mode) {
        m_drive.stopMoving();
    }
    m_drive.wake();
}

/// Feetech servos switch their torque off; an LX servo comes back from motor mode holding.
void ServoFirmware::changeMode(DriveMode before)
{
    if (m_model.traits.lx) {
        if (settings().mode != before) {
            m_drive.holdPresentPosition();
        }
        return;
    }
    m_registers.setTorque(0);
    m_registers.loadGains();
    m_registers.reload();
}

void ServoFirmware::switchTorque(int before)
{
    constexpr int center = 128;
    const catalog::Profile& model = profile();
    const int requested = m_registers.read(Role::TorqueSwitch);
    if (requested == center && model.centering == catalog::Centering::Write128) {
        setPresentPosition(middle);
        m_registers.setTorque(0);
    } else if (requested > (model.damping ? 2 : 1)) {
        m_registers.setTorque(0);
    }
    if (settings().torqueSwitch == 0) {
        m_protection.torqueOff(settings());
    }
    const bool holdsPosition =
        m_model.traits.lx || (!m_drive.goal().wasWritten() && !m_config.behavior.runsToOldGoal);
    if (holdsPosition && settings().torqueSwitch == 1 && before != 1) {
        m_drive.holdPresentPosition();
    }
}

/// Modbus 134: each bit clears the faults it names, and all return to 0 when that is done.
void ServoFirmware::resetFaults()
{
    struct Reset {
        int bit;
        StatusBit fault;
    };
    static constexpr std::array<Reset, 5> resets{
        {{0, OverloadBit}, {1, CurrentBit}, {5, VoltageBit}, {6, TemperatureBit}, {7, SensorBit}}};
    constexpr int center = 4;
    const int requested = m_registers.read(Role::FaultReset);
    for (const Reset& reset : resets) {
        if ((requested >> reset.bit & 1) != 0) {
            m_protection.clear(reset.fault);
        }
    }
    if ((requested & center) != 0) {
        setPresentPosition(middle);
    }
    m_registers.put(Role::FaultReset, 0);
}

/// The correction is a write to the offset register: it survives a power-off only with the lock
/// open.
void ServoFirmware::setPresentPosition(int position)
{
    if (m_drive.sensor().isContinuous()) {
        write(m_registers.field(Role::PositionOffset).address,
              m_registers.encode(Role::PositionOffset, m_drive.sensor().offsetFor(position)));
    }
}

/// The move read back stays the one commanded. In motor mode it does nothing.
void ServoFirmware::stopMove()
{
    if (settings().mode == DriveMode::Position && settings().torqueSwitch == 1) {
        m_drive.holdPresentPosition();
    }
}
} // namespace sim

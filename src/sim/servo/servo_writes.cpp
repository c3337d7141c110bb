// SPDX-License-Identifier: GPL-3.0-or-later
// What a write to the memory table sets in motion.
#include "sim/servo/servo_state.h"

#include <algorithm>
#include <array>

namespace sim {
using catalog::Role;

namespace {
/// What the register can stand for. Ranges of plain numbers are the host's business.
bool isKnownValue(const catalog::Register& reg, int value)
{
    if (reg.role == Role::Id) {
        return value <= reg.max.value_or(253);
    }
    return reg.values.empty() ||
           std::any_of(reg.values.begin(), reg.values.end(),
                       [value](const catalog::NamedValue& named) { return named.value == value; });
}
} // namespace

void VirtualServo::State::write(int address, base::ByteView data)
{
    const base::Bytes bytes = acceptedBytes(address, data);
    epromWritten = memory.write(address, bytes, settings.unlocked) || epromWritten;
    applyChanges(address, int(bytes.size()));
}

/// What a Feetech servo takes of a write. ID 254 is the broadcast address and "must never be
/// stored" (register sheets). What a servo does when it is told to, or to use a rate or mode that
/// its sheet does not list, is in no source; chosen here: that byte keeps its value, and the write
/// is acknowledged all the same, since the error byte has no "rejected" (protocol notes, 2.2).
base::Bytes VirtualServo::State::acceptedBytes(int address, base::ByteView data) const
{
    base::Bytes bytes(data.begin(), data.end());
    if (profile->protocol != base::Protocol::Feetech) {
        return bytes;
    }
    for (const Role role : {Role::Id, Role::BaudRate, Role::OperatingMode}) {
        const catalog::Register* reg = profile->byRole(role);
        if (reg == nullptr || reg->offset < address || reg->offset >= address + int(data.size())) {
            continue;
        }
        std::uint8_t& byte = bytes[std::size_t(reg->offset - address)];
        byte = isKnownValue(*reg, byte) ? byte : memory.at(reg->offset);
    }
    return bytes;
}

/// Everything but the ID. With the lock closed there is nothing it could bring back into the EPROM,
/// so it is acknowledged without effect.
void VirtualServo::State::restore()
{
    if (settings.unlocked != UnlockedArea::Nothing) {
        memory.restore(map.at(Role::Id).address);
        epromWritten = true;
        applyChanges(0, map.at(Role::TorqueSwitch).address);
    }
}

void VirtualServo::State::backup()
{
    if (settings.unlocked != UnlockedArea::Nothing) {
        memory.backup();
        epromWritten = true;
    }
}

void VirtualServo::State::applyChanges(int address, int count)
{
    const auto isTouched = [&](Role role) { return map.at(role).overlaps(address, count); };
    const Settings before = settings;
    const double goalBefore = positionGoal();
    if (isTouched(Role::GoalPosition) && !traits.lx) {
        goalWritten = true;
        restGoal.reset();
    }
    settings = readSettings(memory, map, *profile, traits, type);

    if (settings.id != before.id && !secondaryId.overlaps(address, count)) {
        copyIdToSecondary();
    }
    if (isTouched(Role::OperatingMode)) {
        changeMode(before.mode);
    }
    if (isTouched(Role::BaudRate) && !config.behavior.baudAfterRestart) {
        loadBaud();
    }
    if (settings.offset != before.offset || settings.reversed != before.reversed) {
        resetTurnBase();
    }
    if (isTouched(Role::FaultReset)) {
        resetFaults();
    }
    if (isTouched(Role::TorqueSwitch)) {
        switchTorque(before.torqueSwitch);
    }
    if (isTouched(settings.command)) {
        command(!isTouched(Role::TorqueSwitch));
        moving = moving || positionGoal() != goalBefore;
        stillTicks = 0;
    }
    if (settings.mode != before.mode) {
        moving = false;
    }
    restTicks = 0;
}

/// HLS: writing the ID also sets the second one, for as long as the ID itself stays.
void VirtualServo::State::copyIdToSecondary()
{
    if (secondaryId.exists()) {
        const std::array<std::uint8_t, 1> id{std::uint8_t(settings.id)};
        memory.write(secondaryId.address, id, settings.unlocked);
    }
}

/// Feetech servos switch their torque off; an LX servo comes back from motor mode holding.
void VirtualServo::State::changeMode(DriveMode before)
{
    if (traits.lx) {
        if (settings.mode != before) {
            holdPresentPosition();
        }
        return;
    }
    setTorque(0);
    loadGains();
    settings = readSettings(memory, map, *profile, traits, type);
}

void VirtualServo::State::setTorque(int value)
{
    settings.torqueSwitch = value;
    map.put(memory, Role::TorqueSwitch, value);
}

void VirtualServo::State::switchTorque(int before)
{
    constexpr int center = 128;
    constexpr int middle = 2048;
    const int requested = map.read(memory, Role::TorqueSwitch);
    if (requested == center && profile->centering == catalog::Centering::Write128) {
        setPresentPosition(middle);
        setTorque(0);
    } else if (requested > (profile->damping ? 2 : 1)) {
        setTorque(0);
    }
    if (settings.torqueSwitch == 0) {
        protection.torqueOff(settings);
    }
    const bool holdsPosition = traits.lx || (!goalWritten && !config.behavior.runsToOldGoal);
    if (holdsPosition && settings.torqueSwitch == 1 && before != 1) {
        holdPresentPosition();
    }
}

/// Modbus 134: the bits return to 0 when it is done. Status bits of the faults it names.
void VirtualServo::State::resetFaults()
{
    struct Reset {
        int bit;
        StatusBit fault;
    };
    static constexpr std::array<Reset, 5> resets{
        {{0, OverloadBit}, {1, CurrentBit}, {5, VoltageBit}, {6, TemperatureBit}, {7, SensorBit}}};
    constexpr int center = 4;
    constexpr int middle = 2048;
    const int requested = map.read(memory, Role::FaultReset);
    for (const Reset& reset : resets) {
        if ((requested >> reset.bit & 1) != 0) {
            protection.clear(reset.fault);
        }
    }
    if ((requested & center) != 0) {
        setPresentPosition(middle);
    }
    map.put(memory, Role::FaultReset, 0);
}

/// The correction lands in the offset register; it survives a power-off only with the lock open.
void VirtualServo::State::setPresentPosition(int requested)
{
    if (!encoder.isContinuous()) {
        return;
    }
    const auto turn = std::int64_t(traits.turnSteps);
    const std::int64_t uncorrected =
        (settings.reversed ? turn - 1 - encoderCount : encoderCount) - requested;
    std::int64_t offset = ((uncorrected % turn) + turn) % turn;
    if (offset >= turn / 2) {
        offset -= turn;
    }
    write(map.at(Role::PositionOffset).address, map.encode(Role::PositionOffset, int(offset)));
}

double VirtualServo::State::commandDirection() const
{
    switch (settings.mode) {
    case DriveMode::Speed:
        return settings.goalSpeed;
    case DriveMode::Pwm:
        return -settings.pwm;
    case DriveMode::Current:
        return -settings.goalAmps;
    default:
        return positionGoal() - position;
    }
}

void VirtualServo::State::holdPresentPosition()
{
    restGoal = position;
    moving = false;
    controller.energize(position);
}

/// A write to the register that drives the present mode: it energizes, unless the write says itself
/// what the torque shall be, releases protections and, in step mode, adds to the goal each time it
/// is sent. An LX servo obeys only when it is loaded.
void VirtualServo::State::command(bool energize)
{
    if (traits.lx && settings.torqueSwitch != 1) {
        return;
    }
    restGoal.reset();
    if (settings.mode == DriveMode::Step && (settings.limitsZero || traits.modbus)) {
        constexpr double maxSteps = 30719;
        stepGoal = std::clamp(stepGoal + settings.goalPosition, -maxSteps, maxSteps);
    }
    if (settings.goalTime > 0) {
        timedSpeed = std::abs(positionGoal() - position) * 1000.0 / settings.goalTime;
    } else {
        timedSpeed = 0;
    }
    if (protection.newCommand(settings, commandDirection())) {
        controller.energize(position);
    }
    if (energize && settings.goalEnergizes) {
        setTorque(1);
    }
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// What a write to the memory table sets in motion.
#include "sim/servo_state.h"

#include <algorithm>

namespace sim {
using catalog::Role;

void VirtualServo::State::write(int address, base::ByteView data)
{
    const bool keep = !settings.locked;
    const bool eprom = memory.write(address, data, keep);
    epromWritten = epromWritten || (eprom && keep);
    applyChanges(address, int(data.size()));
}

/// Everything but the ID. With the lock closed there is nothing it could bring back into the EPROM,
/// so it is acknowledged without effect.
void VirtualServo::State::restore()
{
    if (!settings.locked) {
        memory.restore(map.at(Role::Id).address);
        epromWritten = true;
        applyChanges(0, map.at(Role::TorqueSwitch).address);
    }
}

void VirtualServo::State::backup()
{
    if (!settings.locked) {
        memory.backup();
        epromWritten = true;
    }
}

void VirtualServo::State::applyChanges(int address, int count)
{
    const auto touched = [&](Role role) { return map.at(role).touches(address, count); };
    const DriveMode modeBefore = settings.mode;
    const int offsetBefore = settings.offset;
    const bool reversedBefore = settings.reversed;
    const double goalBefore = positionGoal();
    settings = readSettings(memory, map, *profile, type);

    if (touched(Role::OperatingMode)) {
        setTorque(0);
    }
    if (touched(Role::BaudRate) && !config.baudAfterRestart) {
        takeBaud();
    }
    if (settings.offset != offsetBefore || settings.reversed != reversedBefore) {
        rebase();
    }
    if (touched(Role::TorqueSwitch)) {
        switchTorque();
    }
    if (touched(settings.command)) {
        command();
        moving = moving || positionGoal() != goalBefore;
        stillTicks = 0;
    }
    if (settings.mode != modeBefore) {
        moving = false;
    }
    restTicks = 0;
}

void VirtualServo::State::setTorque(int value)
{
    settings.torqueSwitch = value;
    map.put(memory, Role::TorqueSwitch, value);
}

void VirtualServo::State::switchTorque()
{
    constexpr int centre = 128;
    constexpr int middle = 2048;
    const int wanted = map.read(memory, Role::TorqueSwitch);
    if (wanted == centre && profile->centering == catalog::Centering::Write128) {
        makePresent(middle);
        setTorque(0);
    } else if (wanted > (profile->damping ? 2 : 1)) {
        setTorque(0);
    }
}

/// The correction lands in register 31; it survives a power-off only with the lock open.
void VirtualServo::State::makePresent(int wanted)
{
    if (!encoder.endless()) {
        return;
    }
    const auto turn = std::int64_t(profile->stepsPerTurn);
    const std::int64_t uncorrected = (settings.reversed ? turn - 1 - counted : counted) - wanted;
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
    default:
        return positionGoal() - position;
    }
}

/// A write to the register that drives the present mode: it energises, releases protections and, in
/// step mode, adds to the goal each time it is sent.
void VirtualServo::State::command()
{
    if (settings.mode == DriveMode::Step && settings.limitsZero) {
        constexpr double farthest = 30719;
        stepGoal = std::clamp(stepGoal + settings.goalPosition, -farthest, farthest);
    }
    if (settings.goalTime > 0) {
        timedSpeed = std::abs(positionGoal() - position) * 1000.0 / settings.goalTime;
    } else {
        timedSpeed = 0;
    }
    if (protection.commanded(commandDirection())) {
        controller.energise(position);
    }
    setTorque(1);
}
} // namespace sim

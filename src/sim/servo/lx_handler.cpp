// SPDX-License-Identifier: GPL-3.0-or-later
// LX commands as reads and writes of the table. A command is recognized by the places its
// parameters have in the map, so every parameter of the sheet has its read, its write and its save.
// Source: Hiwonder LX protocol page. Writes are never answered; what is out of range, of another
// length or unknown is ignored.
#include "catalog/value.h"
#include "sim/servo/servo_state.h"

#include <algorithm>

namespace sim {
namespace {
using catalog::Role;

enum Command : std::uint8_t {
    MoveStored = 7,
    ReadStored = 8,
    MoveStart = 11,
    MoveStop = 12,
    IdRead = 14
};

constexpr int bytesPerCommand = 8;

/// The block whose read or write command this is.
std::optional<catalog::Block> blockOf(const catalog::Profile& profile, int command, bool write)
{
    for (const catalog::Register& reg : profile.registers) {
        if (!reg.block || (write && !reg.writable())) {
            continue;
        }
        if ((write ? reg.block->writeOffset : reg.block->offset) == bytesPerCommand * command) {
            return reg.block;
        }
    }
    return std::nullopt;
}

bool isWithinRange(const catalog::Register& reg, std::int64_t raw)
{
    return raw >= reg.min.value_or(raw) && raw <= reg.max.value_or(raw);
}

/// Seen on an LX-16A, where the command stays unanswered; not reported of others.
bool canReadStored(const catalog::Profile& profile)
{
    return profile.modelName != QLatin1String("LX-16A");
}
} // namespace

std::optional<ServoReply> VirtualServo::State::handleLx(const ServoRequest& request)
{
    const bool isWrite = !request.params.empty() || !blockOf(*profile, request.instruction, false);
    if (!isWrite) {
        return readLx(request);
    }
    writeLx(request.instruction, request.params);
    return std::nullopt;
}

std::optional<ServoReply> VirtualServo::State::readLx(const ServoRequest& request)
{
    const std::uint8_t command = request.instruction;
    if ((request.broadcast && command != IdRead) ||
        (command == ReadStored && !canReadStored(*profile))) {
        return std::nullopt;
    }
    updateFeedback();
    const catalog::Block block = *blockOf(*profile, command, false);
    const base::ByteView data = memory.view(block.offset, block.size);
    return ServoReply{settings.id, 0, {data.begin(), data.end()}, command};
}

void VirtualServo::State::writeLx(std::uint8_t command, base::ByteView params)
{
    if (params.empty() && command == MoveStart) {
        startStored();
    } else if (params.empty() && command == MoveStop) {
        stopMove();
    } else if (params.empty()) {
        for (const catalog::Register& reg : profile->registers) {
            if (reg.saveOffset == bytesPerCommand * command) {
                epromWritten = memory.save(reg.offset, reg.size) || epromWritten;
            }
        }
    } else if (const auto block = blockOf(*profile, command, true)) {
        if (params.size() == std::size_t(block->size) && acceptsLx(*block, params)) {
            moveStored = moveStored || command == MoveStored;
            write(block->offset, params);
        }
    }
}

/// Every value in its range, and a minimum below its maximum.
bool VirtualServo::State::acceptsLx(const catalog::Block& block, base::ByteView params) const
{
    std::vector<std::int64_t> limits;
    for (const catalog::Register& reg : profile->registers) {
        if (!(reg.block && *reg.block == block)) {
            continue;
        }
        const auto meaning = catalog::valueFormat(reg, *profile, catalog::noLookup);
        const auto place = std::size_t(reg.offset - block.offset);
        const std::int64_t raw = catalog::decodeRaw(params.subspan(place, std::size_t(reg.size)),
                                                    reg, meaning, profile->byteOrder);
        if (!isWithinRange(reg, raw)) {
            return false;
        }
        const bool limit = reg.role == Role::MinAngle || reg.role == Role::MaxAngle ||
                           reg.role == Role::MinVoltage || reg.role == Role::MaxVoltage;
        if (limit) {
            limits.push_back(raw);
        }
    }
    return limits.size() < 2 || limits[0] < limits[1];
}

void VirtualServo::State::startStored()
{
    if (!moveStored) {
        return;
    }
    moveStored = false;
    map.put(memory, Role::GoalTime, map.read(memory, Role::StoredTime));
    map.put(memory, Role::GoalPosition, map.read(memory, Role::StoredGoal));
    const Field& goal = map.at(Role::GoalPosition);
    applyChanges(goal.address, goal.size);
}

/// The move read back stays the one commanded. In motor mode it does nothing.
void VirtualServo::State::stopMove()
{
    if (settings.mode == DriveMode::Position && settings.torqueSwitch == 1) {
        holdPresentPosition();
    }
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/requests/lx_handler.h"

#include "catalog/value.h"

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

std::optional<ServoReply> LxHandler::handle(const ServoRequest& request)
{
    if (!request.params.empty()) {
        writeBlock(request.instruction, request.params);
    } else if (const auto block = blockOf(profile(), request.instruction, false)) {
        return readBlock(request, *block);
    } else {
        executeWithoutParams(request.instruction);
    }
    return std::nullopt;
}

std::optional<ServoReply> LxHandler::readBlock(const ServoRequest& request,
                                               const catalog::Block& block)
{
    const std::uint8_t command = request.instruction;
    if ((request.broadcast && command != IdRead) ||
        (command == ReadStored && !canReadStored(profile()))) {
        return std::nullopt;
    }
    const base::ByteView data = read(block.offset, block.size);
    return ServoReply{settings().id, 0, {data.begin(), data.end()}, command};
}

void LxHandler::executeWithoutParams(std::uint8_t command)
{
    if (command == MoveStart) {
        startStored();
        return;
    }
    if (command == MoveStop) {
        firmware().stopMove();
        return;
    }
    for (const catalog::Register& reg : profile().registers) {
        if (reg.saveOffset == bytesPerCommand * command) {
            registers().save(reg.offset, reg.size);
        }
    }
}

void LxHandler::writeBlock(std::uint8_t command, base::ByteView params)
{
    const auto block = blockOf(profile(), command, true);
    if (block && params.size() == std::size_t(block->size) && accepts(*block, params)) {
        m_moveStored = m_moveStored || command == MoveStored;
        firmware().write(block->offset, params);
    }
}

/// Every value in its range, and a minimum below its maximum.
bool LxHandler::accepts(const catalog::Block& block, base::ByteView params) const
{
    std::vector<std::int64_t> limits;
    for (const catalog::Register& reg : profile().registers) {
        if (!(reg.block && *reg.block == block)) {
            continue;
        }
        const auto format = catalog::valueFormat(reg, profile(), catalog::noLookup);
        const auto place = std::size_t(reg.offset - block.offset);
        const std::int64_t raw = catalog::decodeRaw(params.subspan(place, std::size_t(reg.size)),
                                                    reg, format, profile().byteOrder);
        if (!isWithinRange(reg, raw)) {
            return false;
        }
        const bool isLimit = reg.role == Role::MinAngle || reg.role == Role::MaxAngle ||
                             reg.role == Role::MinVoltage || reg.role == Role::MaxVoltage;
        if (isLimit) {
            limits.push_back(raw);
        }
    }
    return limits.size() < 2 || limits[0] < limits[1];
}

void LxHandler::startStored()
{
    if (!m_moveStored) {
        return;
    }
    m_moveStored = false;
    registers().put(Role::GoalTime, registers().read(Role::StoredTime));
    registers().put(Role::GoalPosition, registers().read(Role::StoredGoal));
    const Field& goal = registers().field(Role::GoalPosition);
    firmware().applyChanges(goal.address, goal.size);
}
} // namespace sim

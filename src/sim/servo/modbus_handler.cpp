// SPDX-License-Identifier: GPL-3.0-or-later
// Modbus functions as reads and writes of the table, and what is answered. Source: vendor's Modbus
// page; for what it leaves open the Modbus standard: exception 2 for any register that is not there
// or cannot be written (the factory block without 128 in 133 included), 3 for a count that does not
// fit or a value outside the register sheet, silence to station 0.
#include "catalog/value.h"
#include "sim/servo/servo_state.h"

#include <algorithm>

namespace sim {
namespace {
enum Function : std::uint8_t {
    ReadRegisters = 0x03,
    WriteOne = 0x06,
    WriteSeveral = 0x10,
    ReportId = 0x11,
    Reboot = 0x41,
};
enum Exception : std::uint8_t { NoSuchFunction = 1, NoSuchAddress = 2, BadValue = 3 };

constexpr std::uint8_t exceptionFlag = 0x80;
constexpr int registerBytes = 2;
constexpr int maxReadRegisters = 125; ///< registers, Modbus standard
constexpr int maxWriteRegisters = 123;

int registerAt(base::ByteView params, std::size_t at)
{
    return int(base::readUnsigned(params.subspan(at, 2), base::ByteOrder::Big));
}

/// A span of registers as the request names it.
struct ByteRange {
    int address = 0; ///< byte of the table
    int count = 0;   ///< bytes
};

ByteRange rangeOf(base::ByteView params)
{
    return {registerBytes * registerAt(params, 0), registerBytes * registerAt(params, 2)};
}

base::ByteView valuesOf(const ServoRequest& request)
{
    return base::ByteView(request.params).subspan(request.instruction == WriteOne ? 2 : 5);
}

std::optional<std::uint8_t> readException(const Memory& memory, base::ByteView params)
{
    const ByteRange range = rangeOf(params);
    if (range.count == 0 || range.count > registerBytes * maxReadRegisters) {
        return BadValue;
    }
    return memory.isMapped(range.address, range.count) ? std::nullopt
                                                       : std::optional<std::uint8_t>(NoSuchAddress);
}
} // namespace

/// Ranges and lists of the sheet; where a register means something else in the present mode, its
/// range there. What has no range takes every word.
bool VirtualServo::State::isWithinLimits(int address, base::ByteView data) const
{
    const auto lookup = [this](const QString& key) -> std::optional<std::int64_t> {
        const catalog::Register* reg = profile->find(key);
        return reg == nullptr ? 0 : map.read(memory, fieldOf(*reg));
    };
    const auto end = address + int(data.size());
    return std::all_of(
        profile->registers.begin(), profile->registers.end(), [&](const catalog::Register& reg) {
            if (reg.offset < address || reg.offset + reg.size > end) {
                return true;
            }
            const auto meaning = catalog::valueFormat(reg, *profile, lookup);
            const base::ByteView wire =
                data.subspan(std::size_t(reg.offset - address), std::size_t(reg.size));
            const auto raw = catalog::decodeRaw(wire, reg, meaning, profile->byteOrder);
            return catalog::checkNewValue(raw, reg, meaning, std::nullopt).has_value();
        });
}

std::optional<std::uint8_t> VirtualServo::State::writeException(const ServoRequest& request) const
{
    const base::ByteView params = request.params;
    ByteRange range = rangeOf(params);
    if (request.instruction == WriteOne) {
        range.count = registerBytes;
    } else if (range.count == 0 || range.count > registerBytes * maxWriteRegisters ||
               params[4] != range.count || params.size() != 5 + std::size_t(range.count)) {
        return BadValue;
    }
    if (!memory.writable(range.address, range.count, settings.unlocked)) {
        return NoSuchAddress;
    }
    return isWithinLimits(range.address, valuesOf(request)) ? std::nullopt
                                                            : std::optional<std::uint8_t>(BadValue);
}

std::optional<std::uint8_t> VirtualServo::State::refusal(const ServoRequest& request) const
{
    const std::size_t size = request.params.size();
    switch (request.instruction) {
    case ReadRegisters:
        return size == 4 ? readException(memory, request.params) : BadValue;
    case WriteOne:
        return size == 4 ? writeException(request) : BadValue;
    case WriteSeveral:
        return size >= 5 ? writeException(request) : BadValue;
    case ReportId:
    case Reboot:
        return size == 0 ? std::nullopt : std::optional<std::uint8_t>(BadValue);
    default:
        return NoSuchFunction;
    }
}

std::optional<ServoReply> VirtualServo::State::handleModbus(const ServoRequest& request)
{
    const std::uint8_t function = request.instruction;
    if (const auto reason = refusal(request)) {
        if (request.broadcast) {
            return std::nullopt;
        }
        return ServoReply{settings.id, 0, {*reason}, std::uint8_t(function | exceptionFlag)};
    }
    // A write repeats its request, so the reply to a new station number comes from the old one.
    ServoReply reply{settings.id, 0, {}, function};
    const base::ByteView params = request.params;
    switch (function) {
    case ReadRegisters: {
        updateFeedback();
        const ByteRange range = rangeOf(params);
        const base::ByteView data = memory.view(range.address, range.count);
        reply.data.push_back(std::uint8_t(range.count));
        reply.data.insert(reply.data.end(), data.begin(), data.end());
        break;
    }
    case WriteOne:
    case WriteSeveral: {
        write(rangeOf(params).address, valuesOf(request));
        const base::ByteView head = params.first(4);
        reply.data.assign(head.begin(), head.end());
        break;
    }
    case ReportId:
        // What the status word holds is not documented: the faults.
        reply.data = {3, std::uint8_t(settings.id), 0, protection.status()};
        return reply;
    default:
        restart();
        return std::nullopt;
    }
    return request.broadcast ? std::nullopt : std::optional(reply);
}
} // namespace sim

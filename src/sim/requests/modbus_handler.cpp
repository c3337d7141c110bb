// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/requests/modbus_handler.h"

#include "catalog/value.h"

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

} // namespace

ModbusHandler::ExceptionCode ModbusHandler::readException(base::ByteView params) const
{
    const ByteRange range = rangeOf(params);
    if (range.count == 0 || range.count > registerBytes * maxReadRegisters) {
        return BadValue;
    }
    return registers().memory().isMapped(range.address, range.count) ? std::nullopt
                                                                     : ExceptionCode(NoSuchAddress);
}

/// Ranges and lists of the sheet; for a register that means something else in the present mode, the
/// range of that mode. A register without a range takes every word.
bool ModbusHandler::isWithinLimits(int address, base::ByteView data) const
{
    const auto lookup = [this](const QString& key) -> std::optional<std::int64_t> {
        const catalog::Register* reg = profile().find(key);
        return reg == nullptr ? 0 : registers().read(fieldOf(*reg));
    };
    const auto end = address + int(data.size());
    return std::all_of(
        profile().registers.begin(), profile().registers.end(), [&](const catalog::Register& reg) {
            if (reg.offset < address || reg.offset + reg.size > end) {
                return true;
            }
            const auto format = catalog::valueFormat(reg, profile(), lookup);
            const base::ByteView wire =
                data.subspan(std::size_t(reg.offset - address), std::size_t(reg.size));
            const auto raw = catalog::decodeRaw(wire, reg, format, profile().byteOrder);
            return catalog::checkNewValue(raw, reg, format, std::nullopt).has_value();
        });
}

ModbusHandler::ExceptionCode ModbusHandler::writeException(const ServoRequest& request) const
{
    const base::ByteView params = request.params;
    ByteRange range = rangeOf(params);
    if (request.instruction == WriteOne) {
        range.count = registerBytes;
    } else if (range.count == 0 || range.count > registerBytes * maxWriteRegisters ||
               params[4] != range.count || params.size() != 5 + std::size_t(range.count)) {
        return BadValue;
    }
    if (!registers().memory().writable(range.address, range.count, settings().unlocked)) {
        return NoSuchAddress;
    }
    return isWithinLimits(range.address, valuesOf(request)) ? std::nullopt
                                                            : ExceptionCode(BadValue);
}

ModbusHandler::ExceptionCode ModbusHandler::exceptionFor(const ServoRequest& request) const
{
    const std::size_t size = request.params.size();
    switch (request.instruction) {
    case ReadRegisters:
        return size == 4 ? readException(request.params) : BadValue;
    case WriteOne:
        return size == 4 ? writeException(request) : BadValue;
    case WriteSeveral:
        return size >= 5 ? writeException(request) : BadValue;
    case ReportId:
    case Reboot:
        return size == 0 ? std::nullopt : ExceptionCode(BadValue);
    default:
        return NoSuchFunction;
    }
}

std::optional<ServoReply> ModbusHandler::handle(const ServoRequest& request)
{
    const auto exception = exceptionFor(request);
    if (!exception) {
        return execute(request);
    }
    if (request.broadcast) {
        return std::nullopt;
    }
    return ServoReply{
        settings().id, 0, {*exception}, std::uint8_t(request.instruction | exceptionFlag)};
}

std::optional<ServoReply> ModbusHandler::execute(const ServoRequest& request)
{
    const base::ByteView params = request.params;
    // A write repeats its request, so the reply to a new station number comes from the old one.
    ServoReply reply{settings().id, 0, {}, request.instruction};
    switch (request.instruction) {
    case ReadRegisters: {
        const ByteRange range = rangeOf(params);
        const base::ByteView data = read(range.address, range.count);
        reply.data.push_back(std::uint8_t(range.count));
        reply.data.insert(reply.data.end(), data.begin(), data.end());
        break;
    }
    case WriteOne:
    case WriteSeveral: {
        firmware().write(rangeOf(params).address, valuesOf(request));
        const base::ByteView head = params.first(4);
        reply.data.assign(head.begin(), head.end());
        break;
    }
    case ReportId:
        // The content of the status word is not documented; chosen here: the faults.
        reply.data = {3, std::uint8_t(settings().id), 0, firmware().protection().status()};
        return reply;
    default:
        firmware().restart();
        return std::nullopt;
    }
    return request.broadcast ? std::nullopt : std::optional(reply);
}
} // namespace sim

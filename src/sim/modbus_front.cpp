// SPDX-License-Identifier: GPL-3.0-or-later
// Modbus functions as reads and writes of the table, and what is answered. Source: vendor's Modbus
// page; for what it leaves open the Modbus standard: exception 2 for any register that is not there
// or cannot be written, 3 for a count that does not fit, silence to station 0.
#include "sim/servo_state.h"

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
constexpr int mostRead = 125; ///< registers, Modbus standard
constexpr int mostWritten = 123;

int wordAt(base::ByteView params, std::size_t at)
{
    return int(base::readUnsigned(params.subspan(at, 2), base::ByteOrder::Big));
}

/// A span of registers as the request names it.
struct Span {
    int address = 0; ///< byte of the table
    int count = 0;   ///< bytes
};

Span spanOf(base::ByteView params)
{
    return {registerBytes * wordAt(params, 0), registerBytes * wordAt(params, 2)};
}

std::optional<Exception> refusesRead(const Memory& memory, base::ByteView params)
{
    const Span span = spanOf(params);
    if (span.count == 0 || span.count > registerBytes * mostRead) {
        return BadValue;
    }
    return memory.mapped(span.address, span.count) ? std::nullopt : std::optional(NoSuchAddress);
}

std::optional<Exception> refusesWrite(const Memory& memory, std::uint8_t function,
                                      base::ByteView params)
{
    Span span = spanOf(params);
    if (function == WriteOne) {
        span.count = registerBytes;
    } else if (span.count == 0 || span.count > registerBytes * mostWritten ||
               params[4] != span.count || params.size() != 5 + std::size_t(span.count)) {
        return BadValue;
    }
    return memory.writable(span.address, span.count) ? std::nullopt : std::optional(NoSuchAddress);
}

std::optional<Exception> refuses(const Memory& memory, const ServoRequest& request)
{
    const std::size_t size = request.params.size();
    switch (request.instruction) {
    case ReadRegisters:
        return size == 4 ? refusesRead(memory, request.params) : BadValue;
    case WriteOne:
        return size == 4 ? refusesWrite(memory, WriteOne, request.params) : BadValue;
    case WriteSeveral:
        return size >= 5 ? refusesWrite(memory, WriteSeveral, request.params) : BadValue;
    case ReportId:
    case Reboot:
        return size == 0 ? std::nullopt : std::optional(BadValue);
    default:
        return NoSuchFunction;
    }
}
} // namespace

std::optional<ServoAnswer> VirtualServo::State::handleModbus(const ServoRequest& request)
{
    const std::uint8_t function = request.instruction;
    if (const auto reason = refuses(memory, request)) {
        if (request.broadcast) {
            return std::nullopt;
        }
        return ServoAnswer{settings.id, 0, {*reason}, std::uint8_t(function | exceptionFlag)};
    }
    // A write repeats its request, so the reply to a new station number comes from the old one.
    ServoAnswer reply{settings.id, 0, {}, function};
    const base::ByteView params = request.params;
    switch (function) {
    case ReadRegisters: {
        publish();
        const Span span = spanOf(params);
        const base::ByteView data = memory.view(span.address, span.count);
        reply.data.push_back(std::uint8_t(span.count));
        reply.data.insert(reply.data.end(), data.begin(), data.end());
        break;
    }
    case WriteOne:
    case WriteSeveral: {
        write(spanOf(params).address, params.subspan(function == WriteOne ? 2 : 5));
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

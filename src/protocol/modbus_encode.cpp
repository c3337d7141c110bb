// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to Modbus bytes, and the replies they expect.
#include "protocol/encode_error.h"
#include "protocol/modbus_codec.h"
#include "protocol/modbus_frame.h"

namespace protocol {
namespace {
using base::Bytes;
using base::Result;

constexpr int registers = 65'536;
constexpr int maxReadRegisters = 125; ///< what one byte of count and 256 bytes a frame leave
constexpr int maxWriteRegisters = 123;
constexpr int identityRegisters = 4; ///< from 0 on
constexpr int reportBytes = 3;

std::uint8_t stationOf(const Request& request)
{
    return static_cast<std::uint8_t>(request.id == broadcastId ? 0 : request.id);
}

void appendWord(Bytes& bytes, int word)
{
    bytes.push_back(static_cast<std::uint8_t>((word >> 8) & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
}

bool isEchoProbe(const Request& request)
{
    const Request probe = modbusEchoProbe();
    return request.op == Op::Read && request.id == probe.id && request.address == probe.address &&
           request.count == probe.count;
}

Result<void> checkStation(const Request& request)
{
    const bool toAll = request.id == broadcastId && request.op != Op::Read;
    const bool one = request.id >= 1 && request.id <= modbus::maxStation;
    if (toAll || one || isEchoProbe(request))
        return {};
    return refuse(request, QStringLiteral("ID %1: Modbus stations are 1 to 247").arg(request.id));
}

Result<void> checkArea(const Request& request, int bytes, int maxRegisters)
{
    if (request.address < 0 || request.address >= 2 * registers)
        return refuse(request, QStringLiteral("address %1").arg(request.address));
    if (request.address % 2 != 0 || bytes % 2 != 0)
        return refuse(request, QStringLiteral("half a register"));
    if (bytes < 2 || bytes > 2 * maxRegisters)
        return refuse(request, QStringLiteral("%1 registers").arg(bytes / 2));
    if (request.address + bytes > 2 * registers)
        return refuse(request, QStringLiteral("%1 registers from %2 pass the end of the table")
                                   .arg(bytes / 2)
                                   .arg(request.address / 2));
    return {};
}

Bytes readFrame(const Request& request, int first, int count)
{
    Bytes data;
    appendWord(data, first);
    appendWord(data, count);
    return modbus::buildFrame(stationOf(request), modbus::fnRead, data);
}

Result<Bytes> encodeRead(const Request& request)
{
    return checkArea(request, request.count, maxReadRegisters).transform([&] {
        return readFrame(request, request.address / 2, request.count / 2);
    });
}

/// The content of the acknowledgement: the address, and the value or the number of registers.
Bytes writeHead(const Request& request)
{
    const Bytes& data = request.data;
    const auto second =
        data.size() == 2 ? data[0] << 8 | data[1] : static_cast<int>(data.size() / 2);
    Bytes head;
    appendWord(head, request.address / 2);
    appendWord(head, second);
    return head;
}

std::uint8_t writeFunction(const Request& request)
{
    return request.data.size() == 2 ? modbus::fnWriteOne : modbus::fnWrite;
}

Result<Bytes> encodeWrite(const Request& request)
{
    if (request.data.size() > modbus::maxFrame)
        return refuse(request, QStringLiteral("%1 registers").arg(request.data.size() / 2));
    const int size = static_cast<int>(request.data.size());
    return checkArea(request, size, maxWriteRegisters).transform([&] {
        Bytes data = writeHead(request);
        if (writeFunction(request) == modbus::fnWrite) {
            data.push_back(static_cast<std::uint8_t>(size));
            data.insert(data.end(), request.data.begin(), request.data.end());
        }
        return modbus::buildFrame(stationOf(request), writeFunction(request), data);
    });
}

Result<Bytes> encodePing(const Request& request)
{
    if (request.id == broadcastId)
        return modbus::buildFrame(stationOf(request), modbus::fnReportId, {});
    return readFrame(request, 0, identityRegisters);
}

Result<Bytes> encodeAddressed(const Request& request)
{
    switch (request.op) {
    case Op::Ping:
        return encodePing(request);
    case Op::Read:
        return encodeRead(request);
    case Op::Write:
        return encodeWrite(request);
    default:
        return modbus::buildFrame(stationOf(request), modbus::fnReboot, {});
    }
}

Expectation answer(const Request& request, std::uint8_t function, Bytes head, int dataBytes)
{
    Expectation expected;
    expected.ids = {request.id};
    expected.alternateId = request.alternateReplyId;
    expected.command = function;
    expected.dataBytes = dataBytes;
    expected.replyBytes = static_cast<int>(modbus::overhead + head.size()) + dataBytes;
    expected.head = std::move(head);
    return expected;
}

Expectation counted(const Request& request, std::uint8_t function, int dataBytes)
{
    return answer(request, function, {static_cast<std::uint8_t>(dataBytes)}, dataBytes);
}
} // namespace

Result<Bytes> encodeModbus(const Request& request)
{
    switch (request.op) {
    case Op::Raw:
        return encodeRaw(request, modbus::maxFrame);
    case Op::Ping:
    case Op::Read:
    case Op::Write:
    case Op::Reboot:
        return checkStation(request).and_then([&] { return encodeAddressed(request); });
    default:
        return refuseUnsupported(request);
    }
}

Expectation expectModbus(const Request& request)
{
    const bool toAll = request.id == broadcastId;
    switch (request.op) {
    case Op::Ping:
        return toAll ? counted(request, modbus::fnReportId, reportBytes)
                     : counted(request, modbus::fnRead, 2 * identityRegisters);
    case Op::Read:
        return toAll || isEchoProbe(request) ? Expectation{}
                                             : counted(request, modbus::fnRead, request.count);
    case Op::Write:
        return toAll || !request.acknowledged
                   ? Expectation{}
                   : answer(request, writeFunction(request), writeHead(request), 0);
    default:
        return {};
    }
}

Request modbusEchoProbe()
{
    return Request::read(broadcastId, 0, 2).in(base::Protocol::Modbus);
}

Bytes encodeModbusReply(int station, std::uint8_t function, base::ByteView data)
{
    return modbus::buildFrame(station, function, data);
}
} // namespace protocol

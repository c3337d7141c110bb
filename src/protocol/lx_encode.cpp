// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to LX bytes, and the replies they expect: writes are never acknowledged.
#include "protocol/encode_error.h"
#include "protocol/lx_codec.h"
#include "protocol/lx_frame.h"

namespace protocol {
namespace {
using base::Bytes;
using base::Result;

constexpr int commands = 256;

std::uint8_t commandOf(const Request& request)
{
    return static_cast<std::uint8_t>(request.address / lx::bytesPerCommand);
}

bool isEchoProbe(const Request& request)
{
    const Request probe = lxEchoProbe();
    return request.op == Op::Read && request.id == probe.id && request.address == probe.address &&
           request.count == probe.count;
}

Result<void> checkLxId(const Request& request)
{
    const bool toAll =
        request.id == broadcastId && (request.op != Op::Read || isEchoProbe(request));
    if (toAll || (request.id >= 0 && request.id <= maxId))
        return {};
    return refuse(request, QStringLiteral("ID %1").arg(request.id));
}

/// Parameters are read and written as the whole list of one command.
Result<void> checkCommand(const Request& request, std::size_t params)
{
    if (request.address < lx::bytesPerCommand || request.address >= commands * lx::bytesPerCommand)
        return refuse(request, QStringLiteral("address %1").arg(request.address));
    if (request.address % lx::bytesPerCommand != 0)
        return refuse(request, QStringLiteral("part of a command's parameters"));
    if (params > lx::maxParams)
        return refuse(request, QStringLiteral("%1 parameters").arg(params));
    return {};
}

Result<Bytes> encodeLxRead(const Request& request)
{
    if (request.count < 1)
        return refuse(request, QStringLiteral("no bytes"));
    return checkCommand(request, static_cast<std::size_t>(request.count)).transform([&] {
        return lx::buildFrame(request.id, commandOf(request), {});
    });
}

Result<Bytes> encodeLxWrite(const Request& request)
{
    return checkCommand(request, request.data.size()).transform([&] {
        return lx::buildFrame(request.id, commandOf(request), request.data);
    });
}

Result<Bytes> encodeAddressed(const Request& request)
{
    switch (request.op) {
    case Op::Ping:
        return lx::buildFrame(request.id, lx::cmdIdRead, {});
    case Op::Read:
        return encodeLxRead(request);
    case Op::Write:
        return encodeLxWrite(request);
    case Op::Action:
        return lx::buildFrame(request.id, lx::cmdMoveStart, {});
    default:
        return lx::buildFrame(request.id, lx::cmdMoveStop, {});
    }
}

Expectation answer(int id, std::uint8_t command, int dataBytes)
{
    Expectation expected;
    expected.ids = {id};
    expected.command = command;
    expected.dataBytes = dataBytes;
    expected.replyBytes = static_cast<int>(lx::overhead) + dataBytes;
    return expected;
}
} // namespace

Result<Bytes> encodeLx(const Request& request)
{
    switch (request.op) {
    case Op::Raw:
        return encodeRaw(request, lx::maxRawFrame);
    case Op::Ping:
    case Op::Read:
    case Op::Write:
    case Op::Action:
    case Op::Halt:
        return checkLxId(request).and_then([&] { return encodeAddressed(request); });
    default:
        return refuseUnsupported(request);
    }
}

Expectation expectLx(const Request& request)
{
    switch (request.op) {
    case Op::Ping:
        return answer(request.id, lx::cmdIdRead, 1);
    case Op::Read:
        return request.id == broadcastId ? Expectation{}
                                         : answer(request.id, commandOf(request), request.count);
    default:
        return {};
    }
}

Request lxEchoProbe()
{
    return Request::read(broadcastId, lx::bytesPerCommand * lx::cmdPositionRead, 2)
        .in(base::Protocol::Lx);
}

Bytes encodeLxReply(int id, std::uint8_t command, base::ByteView params)
{
    return lx::buildFrame(id, command, params);
}
} // namespace protocol

// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/modbus_codec.h"
#include "protocol/modbus_frame.h"

#include <algorithm>

namespace protocol {
namespace {
using base::ByteView;

bool isCommand(std::uint8_t function, const Expectation& expected)
{
    return function == expected.command ||
           (expected.command == modbus::fnReportId && function == modbus::fnReportIdDisputed);
}

class ModbusRules final : public FrameRules {
public:
    FrameMatch replyAt(ByteView rest, const Expectation& expected) const override
    {
        if (rest[0] == 0 || !canReply(rest[0], modbus::maxStation, expected))
            return {};
        if (rest.size() > 1 && rest[1] == (expected.command | modbus::exceptionFlag))
            return modbus::matchOf(rest, modbus::replySize(rest));
        if (rest.size() > 1 && !isCommand(rest[1], expected))
            return {};
        const ByteView head = rest.subspan(std::min<std::size_t>(rest.size(), 2));
        const std::size_t known = std::min(head.size(), expected.head.size());
        if (!std::equal(expected.head.begin(),
                        expected.head.begin() + static_cast<std::ptrdiff_t>(known), head.begin()))
            return {};
        return modbus::matchOf(rest, static_cast<std::size_t>(expected.replyBytes));
    }

    FrameMatch frameAt(ByteView rest) const override
    {
        const FrameMatch request = modbus::matchOf(rest, modbus::requestSize(rest));
        const FrameMatch reply = modbus::matchOf(rest, modbus::replySize(rest));
        if (request.status == FrameStatus::Valid || reply.status == FrameStatus::Valid)
            return request.status == FrameStatus::Valid ? request : reply;
        return request.status == FrameStatus::Partial ? request : reply;
    }

    Reply parseReply(ByteView frame, const Expectation& expected) const override
    {
        if ((frame[1] & modbus::exceptionFlag) != 0)
            return {frame[0], 0, {}, frame[2]};
        const ByteView data = modbus::content(frame).subspan(expected.head.size());
        return {frame[0], 0, {data.begin(), data.end()}};
    }

    Reply parseForeign(ByteView frame) const override
    {
        if ((frame[1] & modbus::exceptionFlag) != 0)
            return {modbus::idOf(frame[0]), 0, {}, frame[2]};
        const ByteView data = modbus::content(frame);
        return {modbus::idOf(frame[0]), 0, {data.begin(), data.end()}};
    }
};

/// A function we do not know gives no length: such a request ends where its CRC fits.
std::size_t sizeByCrc(ByteView buffer)
{
    for (std::size_t size = modbus::overhead; size <= buffer.size(); ++size) {
        if (modbus::isCrcValid(buffer.first(size)))
            return size;
    }
    return buffer.size() < modbus::maxFrame ? buffer.size() + 1 : 0;
}

FrameMatch requestAt(ByteView buffer)
{
    std::size_t size = modbus::requestSize(buffer);
    if (size == 0 && buffer[0] <= modbus::maxStation && (buffer[1] & modbus::exceptionFlag) == 0)
        size = sizeByCrc(buffer);
    return modbus::matchOf(buffer, size);
}
} // namespace

ScanResult scanModbus(ByteView buffer, const Expectation& expected, bool atDeadline)
{
    return scanFrames(ModbusRules(), buffer, expected, atDeadline);
}

RequestScan scanModbusRequest(ByteView buffer)
{
    RequestScan result;
    if (buffer.empty())
        return result;
    const FrameMatch request = requestAt(buffer);
    if (request.status == FrameStatus::Valid) {
        const ByteView params = modbus::content(buffer.first(request.size));
        return {ScanKind::Reply,
                request.size,
                modbus::idOf(buffer[0]),
                buffer[1],
                {params.begin(), params.end()}};
    }
    // Stations hear each other's replies as well.
    const FrameMatch reply = modbus::matchOf(buffer, modbus::replySize(buffer));
    if (reply.status == FrameStatus::Valid) {
        result.kind = ScanKind::Noise;
        result.consumed = reply.size;
    } else if (request.status == FrameStatus::Broken && reply.status != FrameStatus::Partial) {
        result.kind = ScanKind::BadChecksum;
        result.consumed = request.size;
    } else if (request.status == FrameStatus::None && reply.status != FrameStatus::Partial) {
        result.kind = ScanKind::Noise;
        result.consumed = 1;
    }
    return result;
}
} // namespace protocol

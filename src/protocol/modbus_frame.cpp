// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/modbus_frame.h"

#include "base/crc.h"

namespace protocol::modbus {
namespace {
using base::ByteView;

constexpr std::size_t maxDataBytes = 250;

/// Words only, at least one.
std::size_t countedSize(std::size_t overheadBytes, std::uint8_t count)
{
    return count == 0 || count % 2 != 0 || count > maxDataBytes ? 0 : overheadBytes + count;
}

bool isFunction(std::uint8_t code)
{
    switch (code) {
    case fnRead:
    case fnWriteOne:
    case fnWrite:
    case fnReportId:
    case fnReboot:
        return true;
    default:
        return false;
    }
}
} // namespace

base::Bytes buildFrame(int station, std::uint8_t function, ByteView data)
{
    base::Bytes frame;
    frame.reserve(overhead + data.size());
    frame.assign({static_cast<std::uint8_t>(station), function});
    frame.insert(frame.end(), data.begin(), data.end());
    const unsigned crc = base::crc16Modbus(frame);
    frame.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    frame.push_back(static_cast<std::uint8_t>(crc >> 8));
    return frame;
}

std::size_t requestSize(ByteView rest)
{
    const std::size_t incomplete = rest.size() + 1;
    if (rest.empty())
        return incomplete;
    if (rest[0] > maxStation)
        return 0;
    if (rest.size() == 1)
        return incomplete;
    switch (rest[1]) {
    case fnRead:
    case fnWriteOne:
        return 8;
    case fnWrite:
        return rest.size() < 7 ? incomplete : countedSize(9, rest[6]);
    case fnReportId:
    case fnReboot:
        return overhead;
    default:
        return 0;
    }
}

std::size_t replySize(ByteView rest)
{
    const std::size_t incomplete = rest.size() + 1;
    if (rest.empty())
        return incomplete;
    if (rest[0] == 0 || rest[0] > maxStation)
        return 0;
    if (rest.size() == 1)
        return incomplete;
    switch (rest[1]) {
    case fnRead:
        return rest.size() < 3 ? incomplete : countedSize(5, rest[2]);
    case fnWriteOne:
    case fnWrite:
        return 8;
    case fnReportId:
    case fnReportIdDisputed:
        return rest.size() < 3 ? incomplete : rest[2] == 3 ? 8 : 0;
    default:
        break;
    }
    if ((rest[1] & exceptionFlag) == 0 || !isFunction(rest[1] & 0x7FU))
        return 0;
    return rest.size() > 2 && rest[2] == 0 ? 0 : exceptionSize;
}

bool isCrcValid(ByteView frame)
{
    const ByteView crc = frame.last(2);
    return base::crc16Modbus(frame.first(frame.size() - 2)) ==
           base::readUnsigned(crc, base::ByteOrder::Little);
}

FrameMatch matchOf(ByteView rest, std::size_t size)
{
    if (size == 0)
        return {};
    if (rest.size() < size)
        return {FrameStatus::Partial, size};
    return {isCrcValid(rest.first(size)) ? FrameStatus::Valid : FrameStatus::Broken, size};
}
} // namespace protocol::modbus

// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/feetech_frame.h"

namespace protocol::feetech {
namespace {
constexpr std::uint8_t headerByte = 0xFF;
constexpr std::size_t minLength = 2;
} // namespace

std::uint8_t checksum(base::ByteView body)
{
    unsigned sum = 0;
    for (const std::uint8_t byte : body)
        sum += byte;
    return static_cast<std::uint8_t>(~sum & 0xFFU);
}

base::Bytes buildFrame(int id, std::uint8_t instructionOrError, base::ByteView params)
{
    base::Bytes frame;
    frame.reserve(overhead + params.size());
    frame.assign({headerByte, headerByte, static_cast<std::uint8_t>(id),
                  static_cast<std::uint8_t>(params.size() + minLength), instructionOrError});
    frame.insert(frame.end(), params.begin(), params.end());
    frame.push_back(checksum(base::ByteView(frame).subspan(2)));
    return frame;
}

FrameState frameStateAt(base::ByteView buffer, std::size_t offset)
{
    const base::ByteView rest = buffer.subspan(offset);
    for (std::size_t i = 0; i < 2; ++i) {
        if (i == rest.size())
            return FrameState::Partial;
        if (rest[i] != headerByte)
            return FrameState::None;
    }
    if (rest.size() == 2)
        return FrameState::Partial;
    if (rest[2] > maxFrameId)
        return FrameState::None;
    if (rest.size() == 3)
        return FrameState::Partial;
    const std::size_t length = rest[3];
    if (length < minLength || length + 4 > maxFrame)
        return FrameState::None;
    if (rest.size() < length + 4)
        return FrameState::Partial;
    return checksum(rest.subspan(2, length + 1)) == rest[length + 3] ? FrameState::Valid
                                                                     : FrameState::Broken;
}

std::size_t nextStart(base::ByteView buffer, std::size_t from)
{
    while (from < buffer.size() && frameStateAt(buffer, from) == FrameState::None)
        ++from;
    return from;
}
} // namespace protocol::feetech

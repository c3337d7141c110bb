// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/lx_frame.h"

namespace protocol::lx {
namespace {
constexpr std::uint8_t headerByte = 0x55;

/// `body` is everything between header and checksum.
std::uint8_t checksum(base::ByteView body)
{
    unsigned sum = 0;
    for (const std::uint8_t byte : body)
        sum += byte;
    return static_cast<std::uint8_t>(~sum & 0xFFU);
}
} // namespace

base::Bytes buildFrame(int id, std::uint8_t command, base::ByteView params)
{
    base::Bytes frame;
    frame.reserve(overhead + params.size());
    frame.assign({headerByte, headerByte, static_cast<std::uint8_t>(id),
                  static_cast<std::uint8_t>(params.size() + minLength), command});
    frame.insert(frame.end(), params.begin(), params.end());
    frame.push_back(checksum(base::ByteView(frame).subspan(2)));
    return frame;
}

FrameMatch matchAt(base::ByteView rest)
{
    for (std::size_t i = 0; i < 2; ++i) {
        if (i == rest.size())
            return {FrameStatus::Partial, 0};
        if (rest[i] != headerByte)
            return {};
    }
    if (rest.size() > 2 && rest[2] > broadcastId)
        return {};
    if (rest.size() < 4)
        return {FrameStatus::Partial, 0};
    const std::size_t length = rest[3];
    const std::size_t size = length + 3;
    if (length < minLength || size > maxFrame)
        return {};
    if (rest.size() < size)
        return {FrameStatus::Partial, size};
    const bool valid = checksum(rest.subspan(2, length)) == rest[size - 1];
    return {valid ? FrameStatus::Valid : FrameStatus::Broken, size};
}
} // namespace protocol::lx

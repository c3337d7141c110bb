// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/firmware_block.h"

#include "base/crc.h"

#include <algorithm>

namespace protocol {
namespace {
constexpr std::uint8_t binFile = 1;
constexpr std::uint8_t endOfFile = 0x04;
constexpr std::uint8_t moreFollows = 0x06;
constexpr std::uint8_t fill = 0xFF;
/// The checksum begins with the header, and so leaves out the last three bytes of the file's data.
constexpr std::size_t checkedBytes = 64;
} // namespace

int firmwareBlocks(std::size_t fileSize)
{
    return int((fileSize + firmwareBlockData - 1) / firmwareBlockData);
}

base::Bytes firmwareBlock(base::ByteView file, int index)
{
    const auto sequence = std::uint8_t(index + 1);
    base::Bytes block{sequence, std::uint8_t(~sequence), binFile};
    const std::size_t from = std::min(std::size_t(index) * firmwareBlockData, file.size());
    const base::ByteView data = file.subspan(from, std::min(firmwareBlockData, file.size() - from));
    block.insert(block.end(), data.begin(), data.end());
    block.resize(block.size() + firmwareBlockData - data.size(), fill);
    const std::uint16_t crc = base::crc16Xmodem(base::ByteView(block).first(checkedBytes));
    block.push_back(std::uint8_t(crc >> 8));
    block.push_back(std::uint8_t(crc & 0xFF));
    block.push_back(index + 1 == firmwareBlocks(file.size()) ? endOfFile : moreFollows);
    return block;
}
} // namespace protocol

// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/crc.h"

namespace base {
std::uint16_t crc16Modbus(ByteView bytes)
{
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? (crc >> 1) ^ 0xA001U : crc >> 1;
    }
    return static_cast<std::uint16_t>(crc);
}
} // namespace base

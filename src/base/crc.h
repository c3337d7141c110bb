// SPDX-License-Identifier: GPL-3.0-or-later
// Checksums of 16 bits. Pure; any thread.
#pragma once

#include "base/bytes.h"

namespace base {
/// Reflected polynomial 0xA001, start 0xFFFF; of "123456789" it is 0x4B37.
std::uint16_t crc16Modbus(ByteView bytes);
/// Polynomial 0x1021, start 0; of "123456789" it is 0x31C3.
std::uint16_t crc16Xmodem(ByteView bytes);
} // namespace base

// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-16/MODBUS: reflected polynomial 0xA001, start 0xFFFF; of "123456789" it is 0x4B37. Pure; any
// thread.
#pragma once

#include "base/bytes.h"

namespace base {
std::uint16_t crc16Modbus(ByteView bytes);
} // namespace base

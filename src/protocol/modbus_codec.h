// SPDX-License-Identifier: GPL-3.0-or-later
// The parts the Modbus codec is put together from, one file each. Pure functions, any thread.
// All other code uses modbusCodec() of protocol/codec.h.
#pragma once

#include "protocol/codec.h"

namespace protocol {
base::Result<base::Bytes> encodeModbus(const Request& request);
Expectation expectModbus(const Request& request);
ScanResult scanModbus(base::ByteView buffer, const Expectation& expected, bool atDeadline);
QString explainModbus(base::ByteView frame, bool fromHost);

/// 0x03 to station 0, the broadcast address: nothing is returned to it but for 0x11 (Modbus
/// standard, vendor's page), and stations 248 to 255, which are reserved, are left alone. No reply
/// comes from station 0, so its echo cannot be taken for one.
Request modbusEchoProbe();
} // namespace protocol

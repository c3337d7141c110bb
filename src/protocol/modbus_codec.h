// SPDX-License-Identifier: GPL-3.0-or-later
// The parts the Modbus codec is put together from, one file each. Pure functions, any thread.
// Everybody else uses modbusCodec() of protocol/codec.h.
#pragma once

#include "protocol/codec.h"

namespace protocol {
base::Result<base::Bytes> encodeModbus(const Request& request);
Expectation expectModbus(const Request& request);
ScanResult scanModbus(base::ByteView buffer, const Expectation& expected, bool atDeadline);
QString explainModbus(base::ByteView frame, bool fromHost);

/// 0x03 to station 248, which cannot exist; as a reply its echo would have a byte count of 0.
Request modbusEchoProbe();
} // namespace protocol

// SPDX-License-Identifier: GPL-3.0-or-later
// The parts the LX codec is put together from, one file each. Pure functions, any thread.
// All other code uses lxCodec() of protocol/codec.h.
#pragma once

#include "protocol/codec.h"

namespace protocol {
base::Result<base::Bytes> encodeLx(const Request& request);
Expectation expectLx(const Request& request);
ScanResult scanLx(base::ByteView buffer, const Expectation& expected, bool atDeadline);
QString explainLx(base::ByteView frame, bool fromHost);

/// Reading the position of 254: only an ID may be read so, and an echo has LEN 3, a reply more.
Request lxEchoProbe();
} // namespace protocol

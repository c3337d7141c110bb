// SPDX-License-Identifier: GPL-3.0-or-later
// The parts the Feetech codec is put together from, one file each. Pure functions, any thread.
// All other code uses feetechCodec() of protocol/codec.h.
#pragma once

#include "protocol/codec.h"

namespace protocol {
base::Result<base::Bytes> encodeFeetech(const Request& request);
ScanResult scanFeetech(base::ByteView buffer, const Expectation& expected, bool atDeadline);
QString explainFeetech(base::ByteView frame, bool fromHost);

/// READ 254, one byte: no servo answers it, and a status packet with one byte of data has another
/// length, so its echo cannot be taken for a reply.
Request feetechEchoProbe();
} // namespace protocol

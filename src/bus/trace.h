// SPDX-License-Identifier: GPL-3.0-or-later
// Every frame that crossed the wire. A bounded ring inside the bus: the oldest entries fall out and
// are counted. Values; any thread.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "base/protocol.h"

namespace bus {
enum class TraceKind : std::uint8_t {
    Sent,
    Received,
    Echo,
    Foreign,
    Late,
    BadChecksum,
    Noise,
    Note
};

struct TraceEntry {
    base::Duration at{};
    TraceKind kind = TraceKind::Sent;
    base::Bytes bytes;
    base::Protocol protocol = base::Protocol::Feetech; ///< of the request at that time
    std::uint64_t dropped = 0;                         ///< entries lost before this one
};
} // namespace bus

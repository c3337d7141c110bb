// SPDX-License-Identifier: GPL-3.0-or-later
// A wire with responders that know only bytes: each has 128 of them, answers PING, READ and WRITE
// of the Feetech protocol, and nothing else. Simultaneous replies of two of them collide, or
// comes one after the other. Shares nothing with the simulator. One thread, on a manual clock.
#pragma once

#include "base/clock.h"
#include "transport/link.h"

#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace support {
struct RawServo {
    int id = 1;
    base::Bytes table = base::Bytes(128, 0);
    int writes = 0; ///< frames that changed it
};

struct RawServoLine {
    enum class ReplyTiming : std::uint8_t {
        Simultaneous, ///< at the same instant: low bits win, as on an open line
        Sequential,   ///< whole frames in a row
    };
    std::vector<RawServo> servos;
    ReplyTiming replies = ReplyTiming::Simultaneous;
    base::Duration adapterLatency{};
    bool echo = false;                              ///< the adapter returns what the host sends
    base::Duration secondReplyDelay{};              ///< how much later the second reply comes
    std::function<void(int, base::Bytes&)> spoil{}; ///< may change the n-th reply
    std::vector<base::Bytes> frames;                ///< what the host has sent
    int asked = 0;

    int writeCount(std::size_t index) const { return servos[index].writes; }
    /// Writes, restores and the like among the frames.
    int writeFrameCount() const;
};

/// `line` and `clock` must outlive it.
std::unique_ptr<transport::Link> openRawServoLine(RawServoLine& line, base::ManualClock& clock);

/// An STS3215 with firmware 3.10 at rest: identity, limits, lock closed, 7.4 V, 30 °C.
RawServo rawSts3215(int id, int position = 2048);
} // namespace support

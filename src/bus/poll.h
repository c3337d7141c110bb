// SPDX-License-Identifier: GPL-3.0-or-later
// Regular reading that runs inside the bus thread, so that fast sampling never crosses threads per
// sample. Knows addresses, not meanings. Values; any thread.
#pragma once

#include "base/bytes.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/protocol.h"

#include <cstdint>
#include <vector>

namespace bus {
using PollId = std::uint64_t;

struct PollSpan {
    int address = 0;
    int count = 0;
    int every = 1; ///< read in every n-th round only, for what changes slowly
    bool operator==(const PollSpan&) const = default;
};

struct PollServo {
    int id = 0;
    /// Spans of equal `every` that overlap or lie near are merged into block reads.
    std::vector<PollSpan> spans;
    /// Servos with equal spans, equal `group` and syncRead are read by one sync read. The group
    /// keeps families apart that must not share a packet.
    bool syncRead = false;
    int group = 0;
    base::Protocol protocol = base::Protocol::Feetech;
    int mergeGap = 12;  ///< unwanted bytes that may be read along; -1: spans are read as they are
    int maxBlock = 128; ///< bytes in one merged read
};

struct PollPlan {
    std::vector<PollServo> servos;
    base::Duration period{}; ///< 0: as fast as the wire allows
};

/// One block read of one servo. An unanswered poll is a sample too: `error` set, `data` empty.
struct Sample {
    int id = 0;
    int address = 0;
    base::Bytes data;
    std::uint8_t status = 0;
    /// When the last byte of the reply had arrived, bus clock; of a reply that this program took up
    /// much later: when it was due.
    base::Duration at{};
    bool answered = false;
    base::ErrorCode error = base::ErrorCode::NoReply;  ///< meaningful when not answered
    base::Protocol protocol = base::Protocol::Feetech; ///< IDs are those of one protocol
    bool endsRound = false; ///< no other block of this servo is due in this round
};
} // namespace bus

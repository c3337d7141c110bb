// SPDX-License-Identifier: GPL-3.0-or-later
// From wishes to what the bus reads regularly: the union of all of them, one block a servo where
// that is possible, one sync read for servos of a family. Pure; main thread.
#pragma once

#include "bus/poll.h"
#include "session/feed.h"

namespace session {
/// What is read of one servo.
struct FeedTarget {
    ServoRef ref = 0;
    int id = -1;
    catalog::ProfilePtr profile;
    std::vector<const catalog::Register*> registers; ///< what readings are made of
    std::vector<bus::PollSpan> common;               ///< as the bus reads them
    std::vector<bus::PollSpan> beside;
    base::Protocol protocol = base::Protocol::Feetech;
};

struct FeedPlan {
    std::vector<FeedTarget> targets;
    bus::PollPlan common;
    /// What one servo of a family needs and the others do not: read beside, so that it does not
    /// break up or swell their packet. May be empty.
    bus::PollPlan beside;
};

/// `present`: the servos that may be asked now. `baud` 0: unknown.
FeedPlan planFeed(const std::vector<FeedWish>& wishes,
                  const std::vector<const ServoEntry*>& present, int baud);
} // namespace session

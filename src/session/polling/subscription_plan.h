// SPDX-License-Identifier: GPL-3.0-or-later
// From subscriptions to what the bus reads regularly: the union of all of them, one block per servo
// where that is possible, one sync read for servos of a family. Pure; main thread.
#pragma once

#include "bus/poll.h"
#include "session/polling/subscription.h"

namespace session {
/// What is read of one servo.
struct PollTarget {
    ServoRef ref = 0;
    int id = -1;
    catalog::ProfilePtr profile;
    std::vector<const catalog::Register*> registers; ///< what readings are made of
    std::vector<bus::PollSpan> primary;              ///< as the bus reads them
    std::vector<bus::PollSpan> secondary;
    base::Protocol protocol = base::Protocol::Feetech;
};

struct SubscriptionPlan {
    std::vector<PollTarget> targets;
    bus::PollPlan primary;
    /// What one servo of a family needs and the others do not: read beside, so that it does not
    /// break up or swell their packet. May be empty.
    bus::PollPlan secondary;
};

/// `present`: the servos that may be asked now. `baud` 0: unknown.
SubscriptionPlan planSubscriptions(const std::vector<Subscription>& subscriptions,
                                   const std::vector<const ServoEntry*>& present, int baud);
} // namespace session

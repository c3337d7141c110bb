// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly, and the readings. Pages and recordings subscribe; one poll plan on the
// bus thread covers all subscriptions: one block read per servo, or one sync read for all servos
// that support it. Workbench owns the plan and merges every reading into its list. Values; main
// thread.
#pragma once

#include "jobs/watch/poll_reader.h"
#include "session/servos/servo_entry.h"

#include <QStringList>

namespace session {
struct SubscriptionItem {
    ServoRef servo = 0;
    QStringList keys; ///< registers it has not, or cannot measure, are left out
    /// Read about twice a second, by reads of their own beside the fast ones: torque switch, mode,
    /// limits, which another program may change.
    QStringList slowKeys{};
};

struct Subscription {
    std::vector<SubscriptionItem> parts;
    base::Duration period{}; ///< 0: as fast as the wire allows; the shortest of all counts
};

/// One reading of one servo. The clock of the bus is that of the workbench.
struct Reading : jobs::PollReading {
    ServoRef servo = 0;
    catalog::ProfilePtr profile;
};

/// Of the last second.
struct PollRate {
    double hz = 0; ///< answered readings
    std::uint64_t missed = 0;
    std::optional<base::Duration> lastAt; ///< of the latest answered one, ever
};
} // namespace session

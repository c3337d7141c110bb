// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly, and what has come of it. Pages and recordings each say their wish; one
// poll plan on the bus thread covers them all: one block read a servo, or one sync read for all
// that can. Desk owns the plan and merges every reading into its list. Values; main thread.
#pragma once

#include "catalog/value.h"
#include "session/servo_entry.h"

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
    base::Duration period{}; ///< 0: as fast as the wire allows; the shortest of all wishes counts
};

struct ReadValue {
    const catalog::Register* reg = nullptr; ///< of the profile in `Reading`
    std::int64_t raw = 0;
    double physical = 0; ///< in the unit the register has now (phase, mode)
};

/// One reading of one servo. Not answered: no values.
struct Reading {
    ServoRef servo = 0;
    catalog::ProfilePtr profile;
    base::Duration at{}; ///< desk clock, when the last byte had arrived
    bool answered = false;
    base::ErrorCode error = base::ErrorCode::NoReply; ///< meaningful when not answered
    std::uint8_t status = 0;                          ///< as device::Servo::status
    std::vector<ReadValue> values;
};

/// Of the last second.
struct PollRate {
    double hz = 0; ///< answered readings
    std::uint64_t missed = 0;
    std::optional<base::Duration> lastAt; ///< of the latest answered one, ever
};

/// How talking to one servo goes.
struct Communication {
    bool answering = false;
    std::optional<base::Duration> silentSince{}; ///< desk clock
    base::Duration age{};                        ///< of what was heard latest
    PollRate rate{};
    std::uint64_t timeouts = 0;     ///< of this ID since the port was opened
    std::uint64_t badChecksums = 0; ///< likewise
};
} // namespace session

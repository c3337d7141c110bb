// SPDX-License-Identifier: GPL-3.0-or-later
// When which poll is due. A servo that misses its turns is asked less often, so that one that is
// absent does not slow the others down; one that cannot do sync reads is read singly. Bus thread
// only; never waits and does no I/O.
#pragma once

#include "bus/poll_planner.h"

#include <functional>
#include <optional>

namespace bus {
struct PollRead {
    PollId plan = 0;
    std::size_t group = 0;
    base::Protocol protocol = base::Protocol::Feetech;
    std::vector<int> ids; ///< more than one: a sync read
    PollSpan block;
    bool endsRound = false; ///< the last block that is due for these servos
};

class PollRunner {
public:
    /// From when on a servo may be polled: a past instant, the end of its quiet time, or some time
    /// ahead for one that is held.
    using ReadyAt = std::function<base::Duration(int id)>;

    void start(PollId id, const PollPlan& plan, base::Duration now);
    void stop(PollId id);

    /// When to call next() again; nullopt while there are no plans.
    std::optional<base::Duration> nextDue() const;
    std::optional<PollRead> next(base::Duration now, const ReadyAt& readyAt);

    /// `missing`: those of read.ids that did not answer.
    void finished(const PollRead& read, const std::vector<int>& missing, base::Duration now);

private:
    struct Servo {
        bool single = false;     ///< not part of the sync read
        bool noSyncRead = false; ///< answered singly at once: this one cannot do sync reads
        int syncMisses = 0;      ///< in a row
        int misses = 0;          ///< single reads, in a row
        base::Duration notBefore{};
    };
    struct Group {
        PollGroup reads;
        std::vector<Servo> servos; ///< as reads.ids
    };
    struct Plan {
        PollId id = 0;
        base::Duration period{};
        base::Duration due{};
        std::vector<Group> groups;
        std::vector<PollRead> round;
        std::size_t position = 0;
        std::uint64_t rounds = 0;
        bool inRound() const { return position < round.size(); }
    };
    void beginRound(Plan& plan, base::Duration now, const ReadyAt& readyAt);
    static void countMiss(Servo& servo, bool sync, base::Duration now);
    static void countReply(Servo& servo, bool sync);

    std::vector<Plan> m_plans;
};
} // namespace bus

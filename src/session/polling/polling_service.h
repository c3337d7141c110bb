// SPDX-License-Identifier: GPL-3.0-or-later
// The wishes of everybody who watches, the polls that serve them, and what comes back: decoded,
// merged into the list, with what it tells of alarms, silence and turns. Owned by Desk; main
// thread, never waits.
#pragma once

#include "bus/bus.h"
#include "jobs/watch/poll_spans.h"
#include "recording/trigger.h"
#include "session/polling/subscription_plan.h"

#include <array>
#include <deque>

namespace session {
/// What has come since the batch before, in time order.
struct ReadingBatch {
    std::vector<Reading> readings;
    std::vector<record::Mark> marks;
    std::set<ServoRef> updated; ///< their numbers are new
    std::set<ServoRef> changed; ///< alarms, silence
};

class PollingService {
public:
    void subscribe(const QString& user, const Subscription& subscription); ///< no parts: ends it
    void limitRate(base::Duration period); ///< no more often than this; 0: as was wished
    void removeServo(ServoRef ref);
    void removeAllServos();
    bool isRunning() const { return m_polls[0] != 0; }

    /// True when the polls must change: other wishes, other servos `present` (those that may be
    /// asked now), another ID, map or rate.
    bool isOutdated(const std::vector<const ServoEntry*>& present, int baud) const;
    /// Ends what ran; take() before.
    void startPolls(bus::Bus& bus, const std::vector<const ServoEntry*>& present);
    void stop(bus::Bus* bus); ///< null: the port is gone, and its polls with it

    using EntryLookup = std::function<ServoEntry*(ServoRef)>;
    ReadingBatch takeBatch(bus::Bus& bus, const EntryLookup& entryLookup);

    PollRate rate(ServoRef ref) const;

private:
    struct Field {
        const catalog::Register* reg = nullptr;
        catalog::ValueFormat meaning;
    };
    struct Round { ///< of one of the two polls
        jobs::PollRoundTracker cut;
        Reading reading;
        std::map<std::size_t, bool> answered; ///< latest outcome by block, in this batch
    };
    struct Source {
        PollTarget target;
        std::vector<Field> fields;
        std::array<Round, 2> rounds;
    };
    struct RateHistory {
        std::deque<base::Duration> answered; ///< of the last second
        std::deque<base::Duration> missed;
        std::optional<base::Duration> lastAt;
        base::Duration since{};
        void end()
        {
            answered.clear();
            missed.clear();
        }
    };
    struct PolledServo {
        ServoRef ref = 0;
        int id = -1;
        const catalog::Profile* profile = nullptr;
        bool operator==(const PolledServo&) const = default;
    };
    void endPolls(bus::Bus* bus);
    bool isSubscribed(ServoRef ref) const;
    std::vector<PolledServo> polledServosOf(const std::vector<const ServoEntry*>& present) const;
    static const std::vector<bus::PollSpan>& spansOf(const Source& source, std::size_t poll);
    void updateMeanings(Source& source, const ServoEntry& entry);
    void takeSample(Source& source, std::size_t poll, ServoEntry& entry, const bus::Sample& sample);
    static void decode(const Source& source, Reading& into, const bus::Sample& sample);
    void finishRound(Source& source, std::size_t poll, ServoEntry& entry);
    void updateState(ServoEntry& entry, const Reading& reading);
    void finishBatch(Source& source, ServoEntry& entry);
    void count(const Reading& reading);

    std::map<QString, Subscription> m_subscriptions;
    bool m_subscriptionsChanged = false;
    base::Duration m_minPeriod{};
    std::vector<PolledServo> m_polledServos;
    int m_baud = 0;
    std::array<bus::PollId, 2> m_polls{}; ///< common, beside
    std::map<std::pair<base::Protocol, int>, Source> m_sources;
    ReadingBatch m_batch; ///< being made
    std::map<ServoRef, RateHistory> m_rateHistory;
    base::Duration m_takenAt{};
};

/// Latches what the servo's status and measurements say now, and tells the changes as marks.
std::vector<record::Mark> latchAlarms(ServoEntry& entry, base::Duration at);
} // namespace session

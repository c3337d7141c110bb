// SPDX-License-Identifier: GPL-3.0-or-later
// The subscriptions, the polls that serve them, and the readings: decoded, merged into the list,
// with the alarms, silences and turns that follow from them. Owned by Workbench; main thread, never
// waits.
#pragma once

#include "bus/bus.h"
#include "recording/trigger.h"
#include "session/polling/subscription_plan.h"

#include <array>
#include <deque>

namespace session {
/// What has come since the batch before, in time order.
struct ReadingBatch {
    std::vector<Reading> readings;
    std::vector<recording::Mark> marks;
    std::set<ServoRef> updated; ///< their numbers are new
    std::set<ServoRef> changed; ///< alarms, silence
};

class PollingService {
public:
    void subscribe(const QString& user, const Subscription& subscription); ///< no parts: ends it
    void limitRate(base::Duration period); ///< no more often than this; 0: as subscribed
    void removeServo(ServoRef ref);
    void removeAllServos();
    bool isRunning() const { return m_polls[0] != 0; }
    base::Duration period() const { return m_period; } ///< of what is read most often

    /// True when the polls must change: other subscriptions, other servos `present` (those that may
    /// be asked now), another ID, map or rate.
    bool isOutdated(const std::vector<const ServoEntry*>& present, int baud) const;
    /// Ends what ran; take() before.
    void startPolls(bus::Bus& bus, const std::vector<const ServoEntry*>& present);
    void stop(bus::Bus* bus); ///< null: the port is gone, and its polls with it

    using EntryLookup = std::function<ServoEntry*(ServoRef)>;
    ReadingBatch takeBatch(bus::Bus& bus, const EntryLookup& entryLookup);

    PollRate rate(ServoRef ref) const;

private:
    struct PollState { ///< of one of the two polls
        jobs::PollReader reader;
        std::map<std::size_t, bool> answered; ///< latest outcome by block, in this batch
    };
    struct Source {
        PollTarget target;
        std::array<PollState, 2> polls;
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
    void takeSample(Source& source, std::size_t poll, ServoEntry& entry, const bus::Sample& sample);
    void takeReading(const PollTarget& target, ServoEntry& entry, jobs::PollReading polled);
    void updateState(ServoEntry& entry, const Reading& reading);
    void finishBatch(Source& source, ServoEntry& entry);
    void count(const Reading& reading);

    std::map<QString, Subscription> m_subscriptions;
    bool m_subscriptionsChanged = false;
    base::Duration m_minPeriod{};
    std::vector<PolledServo> m_polledServos;
    int m_baud = 0;
    std::array<bus::PollId, 2> m_polls{}; ///< common, beside
    base::Duration m_period{};
    std::map<std::pair<base::Protocol, int>, Source> m_sources;
    ReadingBatch m_batch; ///< being made
    std::map<ServoRef, RateHistory> m_rateHistory;
    base::Duration m_takenAt{};
};

/// Latches the alarms in the servo's status and measurements, and returns the changes as marks.
std::vector<recording::Mark> latchAlarms(ServoEntry& entry, base::Duration at);
} // namespace session

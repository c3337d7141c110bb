// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/polling/polling_service.h"

#include <algorithm>

namespace session {
using base::Duration;

namespace {
constexpr Duration rateWindow = std::chrono::seconds(1);

void removeOlder(std::deque<Duration>& instants, Duration before)
{
    while (!instants.empty() && instants.front() <= before)
        instants.pop_front();
}
} // namespace

void PollingService::subscribe(const QString& user, const Subscription& subscription)
{
    if (subscription.parts.empty())
        m_subscriptions.erase(user);
    else
        m_subscriptions[user] = subscription;
    m_subscriptionsChanged = true;
}

void PollingService::limitRate(Duration period)
{
    m_subscriptionsChanged = m_subscriptionsChanged || period != m_minPeriod;
    m_minPeriod = period;
}

void PollingService::removeServo(ServoRef ref)
{
    for (auto subscription = m_subscriptions.begin(); subscription != m_subscriptions.end();) {
        std::erase_if(subscription->second.parts,
                      [ref](const SubscriptionItem& part) { return part.servo == ref; });
        subscription = subscription->second.parts.empty() ? m_subscriptions.erase(subscription)
                                                          : std::next(subscription);
    }
    m_rateHistory.erase(ref);
}

void PollingService::removeAllServos()
{
    m_subscriptions.clear();
    m_rateHistory.clear();
    m_subscriptionsChanged = true;
}

bool PollingService::isSubscribed(ServoRef ref) const
{
    for (const auto& [user, subscription] : m_subscriptions) {
        if (std::any_of(subscription.parts.begin(), subscription.parts.end(),
                        [ref](const SubscriptionItem& part) { return part.servo == ref; }))
            return true;
    }
    return false;
}

std::vector<PollingService::PolledServo>
PollingService::polledServosOf(const std::vector<const ServoEntry*>& present) const
{
    std::vector<PolledServo> polled;
    for (const ServoEntry* entry : present) {
        if (isSubscribed(entry->ref))
            polled.push_back({entry->ref, entry->servo.id, entry->servo.profile.get()});
    }
    return polled;
}

bool PollingService::isOutdated(const std::vector<const ServoEntry*>& present, int baud) const
{
    if (m_subscriptions.empty() && m_polledServos.empty())
        return false;
    return m_subscriptionsChanged || (baud != m_baud && !m_polledServos.empty()) ||
           polledServosOf(present) != m_polledServos;
}

void PollingService::startPolls(bus::Bus& bus, const std::vector<const ServoEntry*>& present)
{
    endPolls(&bus);
    m_baud = bus.baud();
    m_polledServos = polledServosOf(present);
    m_subscriptionsChanged = false;
    std::vector<Subscription> subscriptions;
    for (const auto& [user, one] : m_subscriptions)
        subscriptions.push_back(one);
    SubscriptionPlan plan = planSubscriptions(subscriptions, present, m_baud);
    plan.primary.period = std::max(plan.primary.period, m_minPeriod);
    plan.secondary.period = std::max(plan.secondary.period, m_minPeriod);
    m_period = plan.primary.period;
    for (auto& [ref, rateHistory] : m_rateHistory) {
        if (std::none_of(plan.targets.begin(), plan.targets.end(),
                         [r = ref](const PollTarget& target) { return target.ref == r; }))
            rateHistory.end();
    }
    for (PollTarget& target : plan.targets) {
        RateHistory& rateHistory = m_rateHistory[target.ref];
        if (rateHistory.answered.empty() && rateHistory.missed.empty())
            rateHistory.since = bus.clock().now();
        Source& source = m_sources[{target.protocol, target.id}];
        source.polls[0].reader = jobs::PollReader(target.registers, target.primary);
        source.polls[1].reader = jobs::PollReader(target.registers, target.secondary);
        source.target = std::move(target);
    }
    if (!plan.primary.servos.empty())
        m_polls[0] = bus.startPoll(plan.primary);
    if (!plan.secondary.servos.empty())
        m_polls[1] = bus.startPoll(plan.secondary);
}

void PollingService::stop(bus::Bus* bus)
{
    endPolls(bus);
    for (auto& [ref, rateHistory] : m_rateHistory)
        rateHistory.end();
}

void PollingService::endPolls(bus::Bus* bus)
{
    for (bus::PollId& poll : m_polls) {
        if (poll != 0 && bus != nullptr)
            bus->stopPoll(poll);
        poll = 0;
    }
    m_sources.clear();
    m_polledServos.clear();
}

void PollingService::count(const Reading& reading)
{
    RateHistory& rateHistory = m_rateHistory[reading.servo];
    removeOlder(rateHistory.answered, reading.at - rateWindow);
    removeOlder(rateHistory.missed, reading.at - rateWindow);
    (reading.answered ? rateHistory.answered : rateHistory.missed).push_back(reading.at);
    if (reading.answered)
        rateHistory.lastAt = reading.at;
}

PollRate PollingService::rate(ServoRef ref) const
{
    const auto found = m_rateHistory.find(ref);
    if (found == m_rateHistory.end())
        return {};
    const RateHistory& rateHistory = found->second;
    const Duration from = m_takenAt - rateWindow;
    const auto within = [&](const std::deque<Duration>& instants) {
        return std::uint64_t(instants.end() -
                             std::upper_bound(instants.begin(), instants.end(), from));
    };
    const Duration span = std::clamp(m_takenAt - rateHistory.since, Duration(1), rateWindow);
    const double seconds = std::chrono::duration<double>(span).count();
    return {double(within(rateHistory.answered)) / seconds, within(rateHistory.missed),
            rateHistory.lastAt};
}
} // namespace session

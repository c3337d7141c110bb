// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/feeder.h"

#include <algorithm>

namespace session {
using base::Duration;

namespace {
constexpr Duration rateSpan = std::chrono::seconds(1);

void forgetOld(std::deque<Duration>& instants, Duration before)
{
    while (!instants.empty() && instants.front() <= before)
        instants.pop_front();
}
} // namespace

void Feeder::wish(const QString& user, const FeedWish& wish)
{
    if (wish.parts.empty())
        m_wishes.erase(user);
    else
        m_wishes[user] = wish;
    m_wishesChanged = true;
}

void Feeder::slowDown(Duration period)
{
    m_wishesChanged = m_wishesChanged || period != m_least;
    m_least = period;
}

void Feeder::forget(ServoRef ref)
{
    for (auto wish = m_wishes.begin(); wish != m_wishes.end();) {
        std::erase_if(wish->second.parts,
                      [ref](const FeedPart& part) { return part.servo == ref; });
        wish = wish->second.parts.empty() ? m_wishes.erase(wish) : std::next(wish);
    }
    m_past.erase(ref);
}

void Feeder::forgetAll()
{
    m_wishes.clear();
    m_past.clear();
    m_wishesChanged = true;
}

bool Feeder::wished(ServoRef ref) const
{
    for (const auto& [user, wish] : m_wishes) {
        if (std::any_of(wish.parts.begin(), wish.parts.end(),
                        [ref](const FeedPart& part) { return part.servo == ref; }))
            return true;
    }
    return false;
}

std::vector<Feeder::Asked> Feeder::askedOf(const std::vector<const ServoEntry*>& present) const
{
    std::vector<Asked> asked;
    for (const ServoEntry* entry : present) {
        if (wished(entry->ref))
            asked.push_back({entry->ref, entry->servo.id, entry->servo.profile.get()});
    }
    return asked;
}

bool Feeder::outdated(const std::vector<const ServoEntry*>& present, int baud) const
{
    if (m_wishes.empty() && m_asked.empty())
        return false;
    return m_wishesChanged || (baud != m_baud && !m_asked.empty()) || askedOf(present) != m_asked;
}

void Feeder::start(bus::Bus& bus, const std::vector<const ServoEntry*>& present)
{
    endPolls(&bus);
    m_baud = bus.baud();
    m_asked = askedOf(present);
    m_wishesChanged = false;
    std::vector<FeedWish> wishes;
    for (const auto& [user, one] : m_wishes)
        wishes.push_back(one);
    FeedPlan plan = planFeed(wishes, present, m_baud);
    plan.common.period = std::max(plan.common.period, m_least);
    plan.beside.period = std::max(plan.beside.period, m_least);
    for (auto& [ref, past] : m_past) {
        if (std::none_of(plan.targets.begin(), plan.targets.end(),
                         [r = ref](const FeedTarget& target) { return target.ref == r; }))
            past.end();
    }
    for (FeedTarget& target : plan.targets) {
        Past& past = m_past[target.ref];
        if (past.answered.empty() && past.missed.empty())
            past.since = bus.clock().now();
        Source& source = m_sources[{target.protocol, target.id}];
        for (const catalog::Register* reg : target.registers)
            source.fields.push_back({reg, {}});
        source.target = std::move(target);
    }
    if (!plan.common.servos.empty())
        m_polls[0] = bus.startPoll(plan.common);
    if (!plan.beside.servos.empty())
        m_polls[1] = bus.startPoll(plan.beside);
}

void Feeder::stop(bus::Bus* bus)
{
    endPolls(bus);
    for (auto& [ref, past] : m_past)
        past.end();
}

void Feeder::endPolls(bus::Bus* bus)
{
    for (bus::PollId& poll : m_polls) {
        if (poll != 0 && bus != nullptr)
            bus->stopPoll(poll);
        poll = 0;
    }
    m_sources.clear();
    m_asked.clear();
}

const std::vector<bus::PollSpan>& Feeder::spansOf(const Source& source, std::size_t poll)
{
    return poll == 0 ? source.target.common : source.target.beside;
}

void Feeder::count(const Reading& reading)
{
    Past& past = m_past[reading.servo];
    forgetOld(past.answered, reading.at - rateSpan);
    forgetOld(past.missed, reading.at - rateSpan);
    (reading.answered ? past.answered : past.missed).push_back(reading.at);
    if (reading.answered)
        past.lastAt = reading.at;
}

FeedRate Feeder::rate(ServoRef ref) const
{
    const auto found = m_past.find(ref);
    if (found == m_past.end())
        return {};
    const Past& past = found->second;
    const Duration from = m_takenAt - rateSpan;
    const auto within = [&](const std::deque<Duration>& instants) {
        return std::uint64_t(instants.end() -
                             std::upper_bound(instants.begin(), instants.end(), from));
    };
    const Duration span = std::clamp(m_takenAt - past.since, Duration(1), rateSpan);
    const double seconds = std::chrono::duration<double>(span).count();
    return {double(within(past.answered)) / seconds, within(past.missed), past.lastAt};
}
} // namespace session

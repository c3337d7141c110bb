// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/late_guard.h"

#include <algorithm>
#include <utility>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// Later than this must not make the bus wait for ever after.
constexpr Duration believable = LateGuard::longestLateness;
constexpr Duration shortestWindow = 20ms;
/// A busy servo takes tens of milliseconds, however quick the adapter is.
constexpr Duration shortestReplyTimeout = 25ms;

bool speaksToAll(const protocol::Request& request)
{
    return request.targets.empty() &&
           (request.id == protocol::broadcastId || request.op == protocol::Op::Raw);
}
} // namespace

Duration LateGuard::patience() const
{
    return Duration(std::max(m_start.load(std::memory_order_relaxed),
                             m_learnt.load(std::memory_order_relaxed)));
}

void LateGuard::setPatience(Duration start)
{
    m_start.store(start.count(), std::memory_order_relaxed);
}

Duration LateGuard::replyTimeout() const
{
    return std::max(hasMeasured() ? shortestReplyTimeout : longestLateness, patience());
}

void LateGuard::learn(Duration lateness)
{
    if (lateness > believable)
        return;
    m_measured.store(true, std::memory_order_relaxed);
    const Duration::rep wanted = lateness.count() * 3 / 2;
    if (wanted > m_learnt.load(std::memory_order_relaxed))
        m_learnt.store(wanted, std::memory_order_relaxed);
}

Duration LateGuard::window() const
{
    return std::max(shortestWindow, patience());
}

void LateGuard::timedOut(int id, Duration onTime, Duration now, base::Protocol language)
{
    if (!known(id)) {
        m_broadcastOwed = onTime;
        quietAll(now);
        return;
    }
    Servo& servo = m_servos[std::size_t(id)];
    std::erase_if(servo.owed, [&](const Owed& owed) { return onTime - owed.onTime > believable; });
    servo.owed.push_back({onTime, language});
    servo.trailing = false;
    beQuiet(servo, now + window());
}

void LateGuard::answered(int id, Duration onTime, Duration now, base::Protocol language)
{
    if (!known(id))
        return;
    Servo& servo = m_servos[std::size_t(id)];
    const auto oldest = owedIn(servo, language);
    if (oldest == servo.owed.end())
        return;
    // If this was the reply to the first request, that to the last one comes just as late.
    beQuiet(servo, now + std::min(onTime - oldest->onTime, believable) + window());
    servo.trailing = true;
    servo.owed.erase(oldest);
    servo.owed.push_back({onTime, language});
}

/// The oldest request in a language: replies keep their order, and no language reads another's.
std::vector<LateGuard::Owed>::iterator LateGuard::owedIn(Servo& servo, base::Protocol language)
{
    return std::find_if(servo.owed.begin(), servo.owed.end(),
                        [language](const Owed& owed) { return owed.language == language; });
}

void LateGuard::beQuiet(Servo& servo, Duration until)
{
    servo.quietUntil = until;
    m_latestQuiet = std::max(m_latestQuiet, until);
}

template <typename Visit>
void LateGuard::visit(const protocol::Request& request, Visit&& visitor)
{
    for (const protocol::Target& target : request.targets) {
        if (known(target.id))
            visitor(m_servos[std::size_t(target.id)]);
    }
    if (request.targets.empty() && known(request.id))
        visitor(m_servos[std::size_t(request.id)]);
}

void LateGuard::sending(const protocol::Request& request)
{
    visit(request, [](Servo& servo) {
        if (std::exchange(servo.trailing, false))
            servo.owed.clear();
    });
}

std::optional<Duration> LateGuard::settle(int id, Duration now, base::Protocol language)
{
    if (!known(id))
        return std::nullopt;
    Servo& servo = m_servos[std::size_t(id)];
    const auto settled = owedIn(servo, language);
    if (settled == servo.owed.end()) {
        const auto owed = std::exchange(m_broadcastOwed, std::nullopt);
        return owed && now - *owed <= believable ? std::optional(now - *owed) : std::nullopt;
    }
    const Duration lateness = now - settled->onTime;
    servo.owed.erase(settled);
    // The replies to the others come as late as this one.
    if (!servo.owed.empty() && lateness <= believable)
        beQuiet(servo, std::max(servo.quietUntil, servo.owed.back().onTime + lateness * 3 / 2));
    return lateness;
}

Duration LateGuard::quietUntil(int id) const
{
    return known(id) ? std::max(m_allQuietUntil, m_servos[std::size_t(id)].quietUntil)
                     : m_allQuietUntil;
}

Duration LateGuard::quietUntil(const protocol::Request& request) const
{
    if (speaksToAll(request))
        return std::max(m_allQuietUntil, m_latestQuiet);
    Duration until = quietUntil(request.id);
    for (const protocol::Target& target : request.targets)
        until = std::max(until, quietUntil(target.id));
    return until;
}

void LateGuard::quietAll(Duration now)
{
    m_allQuietUntil = std::max(m_allQuietUntil, now + window());
}
} // namespace bus

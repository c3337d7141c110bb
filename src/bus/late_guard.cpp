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

void LateGuard::timedOut(int id, Duration onTime, Duration now)
{
    if (!known(id)) {
        m_anybodyOwes = onTime;
        quietAll(now);
        return;
    }
    Servo& servo = m_servos[std::size_t(id)];
    if (servo.debt != Debt::Owed || onTime - servo.onTime > believable)
        servo.onTime = onTime;
    servo.debt = Debt::Owed;
    beQuiet(servo, now + window());
}

void LateGuard::answered(int id, Duration onTime, Duration now)
{
    if (!known(id) || m_servos[std::size_t(id)].debt != Debt::Owed)
        return;
    // If this was the reply to the first request, that to the last one comes just as late.
    Servo& servo = m_servos[std::size_t(id)];
    beQuiet(servo, now + std::min(onTime - servo.onTime, believable) + window());
    servo.debt = Debt::Trailing;
    servo.onTime = onTime;
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
        if (servo.debt == Debt::Trailing)
            servo.debt = Debt::None;
    });
}

std::optional<Duration> LateGuard::settle(int id, Duration now)
{
    if (!known(id))
        return std::nullopt;
    if (m_servos[std::size_t(id)].debt == Debt::None) {
        const auto owed = std::exchange(m_anybodyOwes, std::nullopt);
        return owed && now - *owed <= believable ? std::optional(now - *owed) : std::nullopt;
    }
    Servo& servo = m_servos[std::size_t(id)];
    servo.debt = Debt::None;
    return now - servo.onTime;
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

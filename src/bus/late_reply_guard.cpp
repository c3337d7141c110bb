// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/late_reply_guard.h"

#include <algorithm>
#include <utility>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// Later than this must not make the bus wait for ever after.
constexpr Duration plausibleLateness = LateReplyGuard::maxLateness;
constexpr Duration minWindow = 20ms;
/// A busy servo takes tens of milliseconds, however quick the adapter is.
constexpr Duration minReplyLateness = 25ms;
/// Longer ago, it may have been plugged in again.
constexpr Duration silenceMemory = 2s;

bool isBroadcast(const protocol::Request& request)
{
    return request.targets.empty() &&
           (request.id == protocol::broadcastId || request.op == protocol::Op::Raw);
}
} // namespace

Duration LateReplyGuard::timeout() const
{
    return Duration(std::max(m_start.load(std::memory_order_relaxed),
                             m_learnedTimeout.load(std::memory_order_relaxed)));
}

void LateReplyGuard::setTimeout(Duration start)
{
    m_start.store(start.count(), std::memory_order_relaxed);
}

Duration LateReplyGuard::maxReplyLateness() const
{
    return std::max(hasMeasured() ? minReplyLateness : maxLateness, timeout());
}

void LateReplyGuard::learn(Duration lateness)
{
    if (lateness > plausibleLateness)
        return;
    m_measured.store(true, std::memory_order_relaxed);
    const Duration::rep newTimeout = lateness.count() * 3 / 2;
    if (newTimeout > m_learnedTimeout.load(std::memory_order_relaxed))
        m_learnedTimeout.store(newTimeout, std::memory_order_relaxed);
}

Duration LateReplyGuard::window() const
{
    return std::max(minWindow, timeout());
}

void LateReplyGuard::timedOut(int id, Duration expectedAt, Duration now, base::Protocol protocol)
{
    if (!isServoId(id)) {
        m_broadcastPendingSince = expectedAt;
        quietAll(now);
        return;
    }
    Servo& servo = m_servos[std::size_t(id)];
    std::erase_if(servo.pending, [&](const PendingReply& pending) {
        return expectedAt - pending.expectedAt > plausibleLateness;
    });
    servo.pending.push_back({expectedAt, protocol});
    servo.trailing = false;
    setQuietUntil(servo, now + window());
}

void LateReplyGuard::silenceProven(int id, Duration now, base::Protocol protocol)
{
    if (!isServoId(id))
        return;
    m_servos[std::size_t(id)].silentAt = now;
    m_servos[std::size_t(id)].silentProtocol = protocol;
}

bool LateReplyGuard::isKnownSilent(int id, Duration now, base::Protocol protocol) const
{
    if (!isServoId(id))
        return false;
    const Servo& servo = m_servos[std::size_t(id)];
    return servo.silentProtocol == protocol && now - servo.silentAt < silenceMemory;
}

void LateReplyGuard::forgetSilence()
{
    for (Servo& servo : m_servos)
        servo.silentAt = noSilence;
}

void LateReplyGuard::replyReceived(int id, Duration expectedAt, Duration now,
                                   base::Protocol protocol)
{
    if (!isServoId(id))
        return;
    Servo& servo = m_servos[std::size_t(id)];
    servo.silentAt = noSilence;
    const auto oldest = findPending(servo, protocol);
    if (oldest == servo.pending.end())
        return;
    // If this was the reply to the first request, that to the last one comes just as late.
    setQuietUntil(servo,
                  now + std::min(expectedAt - oldest->expectedAt, plausibleLateness) + window());
    servo.trailing = true;
    servo.pending.erase(oldest);
    servo.pending.push_back({expectedAt, protocol});
}

/// The oldest request of a protocol: replies keep their order, and protocols do not mix.
std::vector<LateReplyGuard::PendingReply>::iterator
LateReplyGuard::findPending(Servo& servo, base::Protocol protocol)
{
    return std::find_if(
        servo.pending.begin(), servo.pending.end(),
        [protocol](const PendingReply& pending) { return pending.protocol == protocol; });
}

void LateReplyGuard::setQuietUntil(Servo& servo, Duration until)
{
    servo.quietUntil = until;
    m_latestQuietUntil = std::max(m_latestQuietUntil, until);
}

template <typename Function>
void LateReplyGuard::forEachServo(const protocol::Request& request, Function&& function)
{
    for (const protocol::Target& target : request.targets) {
        if (isServoId(target.id))
            function(m_servos[std::size_t(target.id)]);
    }
    if (request.targets.empty() && isServoId(request.id))
        function(m_servos[std::size_t(request.id)]);
}

void LateReplyGuard::aboutToSend(const protocol::Request& request)
{
    forEachServo(request, [](Servo& servo) {
        if (std::exchange(servo.trailing, false))
            servo.pending.clear();
    });
}

std::optional<Duration> LateReplyGuard::matchLateReply(int id, Duration now,
                                                       base::Protocol protocol)
{
    if (!isServoId(id))
        return std::nullopt;
    Servo& servo = m_servos[std::size_t(id)];
    servo.silentAt = noSilence;
    const auto matched = findPending(servo, protocol);
    if (matched == servo.pending.end()) {
        const auto pending = std::exchange(m_broadcastPendingSince, std::nullopt);
        return pending && now - *pending <= plausibleLateness ? std::optional(now - *pending)
                                                              : std::nullopt;
    }
    ++m_lateReplies;
    const Duration lateness = now - matched->expectedAt;
    servo.pending.erase(matched);
    // The replies to the others come as late as this one, or together with it after a stall.
    if (!servo.pending.empty()) {
        const Duration until = lateness <= plausibleLateness
                                   ? servo.pending.back().expectedAt + lateness * 3 / 2
                                   : now + window();
        setQuietUntil(servo, std::max(servo.quietUntil, until));
    }
    return lateness;
}

Duration LateReplyGuard::quietUntil(int id) const
{
    return isServoId(id) ? std::max(m_allQuietUntil, m_servos[std::size_t(id)].quietUntil)
                         : m_allQuietUntil;
}

Duration LateReplyGuard::quietUntil(const protocol::Request& request) const
{
    if (isBroadcast(request))
        return std::max(m_allQuietUntil, m_latestQuietUntil);
    Duration until = quietUntil(request.id);
    for (const protocol::Target& target : request.targets)
        until = std::max(until, quietUntil(target.id));
    return until;
}

void LateReplyGuard::quietAll(Duration now)
{
    m_allQuietUntil = std::max(m_allQuietUntil, now + window());
}
} // namespace bus

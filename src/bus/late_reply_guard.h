// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a late reply from being taken for the answer to the next request. Replies carry no
// address, so after a time-out the bus only listens for a while before it sends to that servo
// again; and it learns from every reply how long it has to wait. Bus thread only, except timeout(),
// maxReplyLateness() and setTimeout().
#pragma once

#include "base/clock.h"
#include "protocol/request.h"

#include <array>
#include <atomic>
#include <optional>
#include <vector>

namespace bus {
class LateReplyGuard {
public:
    /// Of ordinary transactions, beyond wire time and reply delay.
    base::Duration timeout() const;
    void setTimeout(base::Duration start);
    /// See Bus::maxReplyLateness().
    base::Duration maxReplyLateness() const;
    /// No adapter is later than this.
    static constexpr base::Duration maxLateness = std::chrono::milliseconds(250);
    /// A busy computer may hold back replies for as long as this.
    static constexpr base::Duration maxStall = std::chrono::milliseconds(500);
    /// A servo that was silent for maxStall is not waited for so long again for the next seconds,
    /// unless it replies: one that is unplugged during a long write must not take half a second per
    /// register. Not proven by a lost write, because the question what the servo holds after it
    /// must be asked patiently.
    void silenceProven(int id, base::Duration now, base::Protocol protocol);
    bool isKnownSilent(int id, base::Duration now, base::Protocol protocol) const;
    void forgetSilence(); ///< at another rate
    /// A reply has shown how late this link is.
    bool hasMeasured() const { return m_measured.load(std::memory_order_relaxed); }

    /// So many replies came after their request had timed out.
    std::uint64_t lateReplies() const { return m_lateReplies; }

    /// A reply came `lateness` after the instant at which a prompt adapter would have shown it.
    void learn(base::Duration lateness);

    void timedOut(int id, base::Duration expectedAt, base::Duration now, base::Protocol protocol);
    /// `onTime` is that of the request which was answered.
    void replyReceived(int id, base::Duration expectedAt, base::Duration now,
                       base::Protocol protocol);
    void aboutToSend(const protocol::Request& request);
    /// A frame from `id` that answers no request: its lateness if that servo owes a reply.
    std::optional<base::Duration> matchLateReply(int id, base::Duration now,
                                                 base::Protocol protocol);

    /// From when on requests to this servo, or to all targets of the request, may be sent.
    base::Duration quietUntil(int id) const;
    base::Duration quietUntil(const protocol::Request& request) const;
    /// Nothing is sent for a while: replies of unknown origin may be on their way.
    void quietAll(base::Duration now);

private:
    static constexpr base::Duration noSilence = -std::chrono::hours(1);

    /// A request that timed out; its reply may still come.
    struct PendingReply {
        base::Duration expectedAt{}; ///< when a prompt reply would have come
        base::Protocol protocol{};
    };
    struct Servo {
        base::Duration quietUntil{};
        std::vector<PendingReply> pending{}; ///< oldest first
        bool trailing = false;               ///< answered, maybe by the reply to an earlier request
        base::Duration silentAt = noSilence; ///< when its silence was proven
        base::Protocol silentProtocol{};
    };
    static std::vector<PendingReply>::iterator findPending(Servo& servo, base::Protocol protocol);
    base::Duration window() const;
    void setQuietUntil(Servo& servo, base::Duration until);
    template <typename Function>
    void forEachServo(const protocol::Request& request, Function&& function);
    bool isServoId(int id) const { return id >= 0 && id <= protocol::maxId; }

    std::array<Servo, protocol::maxId + 1> m_servos{};
    base::Duration m_allQuietUntil{};
    base::Duration m_latestQuietUntil{}; ///< of any servo
    std::optional<base::Duration>
        m_broadcastPendingSince; ///< since when: a question to all timed out
    std::atomic<base::Duration::rep> m_start{25'000};
    std::atomic<base::Duration::rep> m_learnedTimeout{0};
    std::atomic<bool> m_measured{false};
    std::uint64_t m_lateReplies = 0;
};
} // namespace bus

// SPDX-License-Identifier: GPL-3.0-or-later
// The link with what it lacks: the time bytes take on the wire, the echo of what was sent, and the
// bytes that have come but are not understood yet. Counts and traces what it sends. What it keeps
// is bounded, and dropping what was understood costs nothing. Bus thread only, except the plain
// values. The first error of the link is final, LinkLost from then on,
// unless its return is awaited: then the line is silent and nothing can be sent, until the link is
// open again or the time for that is over.
#pragma once

#include "base/clock.h"
#include "bus/statistics_collector.h"
#include "bus/trace_ring.h"
#include "transport/link.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace bus {
using Reopener = std::function<base::Result<std::unique_ptr<transport::Link>>()>;

class Line {
public:
    Line(std::unique_ptr<transport::Link> link, base::Clock& clock, int bitsPerByte,
         StatisticsCollector& statistics, TraceRing& trace, Reopener reopen = {});

    base::Duration wireTime(std::size_t bytes) const;
    /// After this time without a byte a reply that was running has ended.
    base::Duration silence() const;

    /// Waits until earlier bytes have left the wire, then sends. When the sending began. NoReply
    /// while the link is away: nothing was sent.
    base::Result<base::Duration> send(base::ByteView frame);
    /// Waits for bytes, for `span` or less; true if some came.
    base::Result<bool> receive(base::Duration span);

    /// Bytes not understood yet, without echo. Empty while an echo is still being received.
    base::ByteView pending() const { return m_echo.empty() ? unreadBytes() : base::ByteView{}; }
    std::size_t received() const { return unreadBytes().size(); } ///< echo included
    void consume(std::size_t bytes) { m_consumed += bytes; }
    /// All but the latest `kept` pending bytes are dropped.
    void keepLatest(std::size_t count);
    base::Bytes takePending();
    /// The echo did not come as it was sent: as many bytes as were sent are dropped.
    void discardEcho();
    std::size_t pendingEchoBytes() const { return m_echo.size(); }

    base::Duration lastByteAt() const { return m_lastByteAt; }
    base::Duration freeAt() const { return m_freeAt; } ///< when what was sent has left the wire

    bool hasEcho() const { return m_hasEcho.load(std::memory_order_relaxed); }
    void setHasEcho(bool echoes) { m_hasEcho.store(echoes, std::memory_order_relaxed); }

    base::Result<void> setBaud(int baud);
    int baud() const { return m_baud.load(std::memory_order_relaxed); }
    bool canSetBaud() const { return m_hasBaud; }
    const QString& name() const { return m_name; }
    bool lost() const { return m_lost.load(); }
    bool isReconnecting() const { return m_reconnecting.load(); }
    void setReconnectTimeout(base::Duration span) { m_reconnectTimeout.store(span.count()); }
    base::Result<void> requireLink() const; ///< LinkLost once it is, NoReply while away

    /// The link must be destroyed on the thread that owns it, the line may live on.
    void close();

private:
    tl::unexpected<base::Error> handleLoss(const base::Error& error);
    base::Result<bool> tryReconnect(base::Duration span);
    bool reconnect();
    void stripEcho();
    base::ByteView unreadBytes() const { return base::ByteView(m_buffer).subspan(m_consumed); }
    void compactBuffer();

    std::unique_ptr<transport::Link> m_link;
    base::Clock& m_clock;
    int m_bitsPerByte;
    StatisticsCollector& m_statistics;
    TraceRing& m_trace;
    QString m_name;
    bool m_hasBaud;
    std::atomic<int> m_baud;
    std::atomic<bool> m_hasEcho{false};
    std::atomic<bool> m_lost{false};
    Reopener m_reopen;
    std::atomic<base::Duration::rep> m_reconnectTimeout{0};
    std::atomic<bool> m_reconnecting{false};
    std::optional<base::Duration> m_reconnectDeadline; ///< none since a byte has come
    base::Duration m_nextReconnect{};
    base::Bytes m_buffer;
    std::size_t m_consumed = 0; ///< bytes at the front of the buffer that are understood
    base::Bytes m_echo;         ///< sent, and still to come back
    base::Duration m_freeAt{};
    base::Duration m_lastByteAt{};
};
} // namespace bus

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/line.h"

#include <algorithm>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// An adapter that was taken for an echoing one and returns nothing must not fill the memory.
constexpr std::size_t maxPendingEcho = 4096;

/// Nor must what comes in place of the echo.
constexpr std::size_t maxBytesBeforeEcho = 4096;

/// A link that is away is tried this often.
constexpr Duration reconnectInterval = 200ms;
} // namespace

Line::Line(std::unique_ptr<transport::Link> link, base::Clock& clock, int bitsPerByte,
           StatisticsCollector& statistics, TraceRing& trace, Reopener reopen)
    : m_link(std::move(link))
    , m_clock(clock)
    , m_bitsPerByte(bitsPerByte)
    , m_statistics(statistics)
    , m_trace(trace)
    , m_name(m_link->name())
    , m_hasBaud(m_link->canSetBaud())
    , m_baud(m_link->baud())
    , m_reopen(std::move(reopen))
{}

Duration Line::wireTime(std::size_t bytes) const
{
    const std::int64_t rate = std::max(baud(), 1);
    const std::int64_t bits = static_cast<std::int64_t>(bytes) * m_bitsPerByte;
    return Duration((bits * 1'000'000 + rate - 1) / rate);
}

Duration Line::silence() const
{
    return wireTime(4) + 500us;
}

tl::unexpected<base::Error> Line::handleLoss(const base::Error& error)
{
    m_link.reset();
    const Duration timeout(m_reconnectTimeout.load());
    if (!m_reopen || timeout <= Duration{}) {
        m_lost.store(true);
        return base::fail(base::ErrorCode::LinkLost, error.operation, error.detail);
    }
    const Duration now = m_clock.now();
    // A link that comes and goes without a word is waited for once.
    m_reconnectDeadline = m_reconnectDeadline.value_or(now + timeout);
    m_nextReconnect = now + reconnectInterval;
    m_buffer.clear();
    m_consumed = 0;
    m_echo.clear();
    m_reconnecting.store(true);
    m_trace.note(now, QStringLiteral("link away"));
    return base::fail(base::ErrorCode::NoReply, error.operation, error.detail);
}

/// Silence, for `span` or less.
base::Result<bool> Line::tryReconnect(Duration span)
{
    const Duration now = m_clock.now();
    if (now >= m_nextReconnect) {
        if (reconnect())
            return false;
        m_nextReconnect = m_clock.now() + reconnectInterval;
    }
    if (m_clock.now() >= *m_reconnectDeadline) {
        m_lost.store(true);
        m_reconnecting.store(false);
        m_trace.note(m_clock.now(), QStringLiteral("link lost"));
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("port"), m_name);
    }
    if (span > Duration{})
        m_clock.sleepUntil(std::min(now + span, *m_reconnectDeadline));
    return false;
}

bool Line::reconnect()
{
    auto link = m_reopen();
    // A dead one may still let itself be opened.
    if (!link || !(*link)->waitForReadyRead(Duration{}))
        return false;
    if ((*link)->canSetBaud() && (*link)->baud() != baud() && !(*link)->setBaud(baud()))
        return false;
    m_link = std::move(*link);
    m_freeAt = m_lastByteAt = m_clock.now();
    m_reconnecting.store(false);
    m_trace.note(m_clock.now(), QStringLiteral("link back"));
    return true;
}

base::Result<void> Line::requireLink() const
{
    if (isReconnecting())
        return base::fail(base::ErrorCode::NoReply, QStringLiteral("port"), m_name);
    if (m_link == nullptr)
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("port"), m_name);
    return {};
}

base::Result<Duration> Line::send(base::ByteView frame)
{
    if (const auto available = requireLink(); !available)
        return tl::unexpected(available.error());
    if (m_clock.now() < m_freeAt)
        m_clock.sleepUntil(m_freeAt);
    const Duration now = m_clock.now();
    if (const auto written = m_link->write(frame); !written)
        return handleLoss(written.error());
    const Duration span = wireTime(frame.size());
    m_freeAt = now + span;
    // What comes back as echo is counted when it comes.
    m_statistics.bytesSent(frame.size(), hasEcho() ? Duration{} : span);
    m_trace.add(now, TraceKind::Sent, frame);
    if (hasEcho()) {
        if (m_echo.size() > maxPendingEcho)
            m_echo.clear();
        m_echo.insert(m_echo.end(), frame.begin(), frame.end());
    }
    return now;
}

base::Result<bool> Line::receive(Duration span)
{
    if (isReconnecting())
        return tryReconnect(span);
    if (const auto available = requireLink(); !available)
        return tl::unexpected(available.error());
    const auto ready = m_link->waitForReadyRead(std::max(span, Duration{}));
    const auto onLoss = [this](const base::Error& error) -> base::Result<bool> {
        const auto reason = handleLoss(error);
        return isReconnecting() ? base::Result<bool>(false) : reason;
    };
    if (!ready)
        return onLoss(ready.error());
    if (!*ready)
        return false;
    compactBuffer();
    const auto count = m_link->read(m_buffer);
    if (!count)
        return onLoss(count.error());
    if (*count == 0)
        return false;
    m_lastByteAt = m_clock.now();
    m_reconnectDeadline.reset();
    m_statistics.bytesReceived(*count, wireTime(*count));
    stripEcho();
    return true;
}

void Line::stripEcho()
{
    if (m_echo.empty())
        return;
    const auto found = std::search(m_buffer.begin(), m_buffer.end(), m_echo.begin(), m_echo.end());
    if (found == m_buffer.end()) {
        if (m_buffer.size() > m_echo.size() + maxBytesBeforeEcho)
            discardEcho();
        return;
    }
    m_trace.add(m_lastByteAt, TraceKind::Echo, m_echo);
    m_buffer.erase(found, found + static_cast<std::ptrdiff_t>(m_echo.size()));
    m_echo.clear();
}

void Line::discardEcho()
{
    if (m_echo.empty())
        return;
    const std::size_t count = std::min(m_echo.size(), received());
    m_trace.add(m_lastByteAt, TraceKind::Echo, unreadBytes().first(count));
    m_echo.clear();
    consume(count);
}

void Line::keepLatest(std::size_t count)
{
    if (received() > count)
        consume(received() - count);
}

/// Once an arrival, not once a frame: what is left is at most the beginning of a frame.
void Line::compactBuffer()
{
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_consumed));
    m_consumed = 0;
}

base::Bytes Line::takePending()
{
    compactBuffer();
    return std::exchange(m_buffer, {});
}

base::Result<void> Line::setBaud(int baud)
{
    if (const auto available = requireLink(); !available)
        return available;
    // The adapter still has to put out what it was given at the old rate.
    if (m_clock.now() < m_freeAt + 2ms)
        m_clock.sleepUntil(m_freeAt + 2ms);
    const auto set = m_link->setBaud(baud);
    if (!set)
        return set.error().code == base::ErrorCode::LinkLost ? handleLoss(set.error()) : set;
    m_baud.store(m_link->baud(), std::memory_order_relaxed);
    m_trace.note(m_clock.now(), QStringLiteral("rate %1").arg(baud));
    return {};
}

void Line::close()
{
    m_link.reset();
    m_reconnecting.store(false);
    m_lost.store(true);
}
} // namespace bus

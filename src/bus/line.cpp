// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/line.h"

#include <algorithm>

namespace bus {
namespace {
using base::Duration;
using namespace std::chrono_literals;

/// An adapter that was taken for an echoing one and returns nothing must not fill the memory.
constexpr std::size_t mostEchoOwed = 4096;

/// Nor must what comes in place of the echo.
constexpr std::size_t maxBeforeEcho = 4096;

/// A link that is away is tried this often.
constexpr Duration tryEvery = 200ms;
} // namespace

Line::Line(std::unique_ptr<transport::Link> link, base::Clock& clock, int bitsPerByte,
           StatisticsCollector& statistics, TraceRing& trace, Reopener reopen)
    : m_link(std::move(link))
    , m_clock(clock)
    , m_bitsPerByte(bitsPerByte)
    , m_statistics(statistics)
    , m_trace(trace)
    , m_name(m_link->name())
    , m_hasBaud(m_link->hasBaud())
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

tl::unexpected<base::Error> Line::loss(const base::Error& error)
{
    m_link.reset();
    const Duration patience(m_patience.load());
    if (!m_reopen || patience <= Duration{}) {
        m_lost.store(true);
        return base::fail(base::ErrorCode::LinkLost, error.operation, error.detail);
    }
    const Duration now = m_clock.now();
    // A link that comes and goes without a word is waited for once.
    m_awayUntil = m_awayUntil.value_or(now + patience);
    m_nextTry = now + tryEvery;
    m_buffer.clear();
    m_taken = 0;
    m_echo.clear();
    m_away.store(true);
    m_trace.note(now, QStringLiteral("link away"));
    return base::fail(base::ErrorCode::NoAnswer, error.operation, error.detail);
}

/// Silence, at most `span` of it.
base::Result<bool> Line::lookForReturn(Duration span)
{
    const Duration now = m_clock.now();
    if (now >= m_nextTry) {
        if (comesBack())
            return false;
        m_nextTry = m_clock.now() + tryEvery;
    }
    if (m_clock.now() >= *m_awayUntil) {
        m_lost.store(true);
        m_away.store(false);
        m_trace.note(m_clock.now(), QStringLiteral("link lost"));
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("port"), m_name);
    }
    if (span > Duration{})
        m_clock.sleepUntil(std::min(now + span, *m_awayUntil));
    return false;
}

bool Line::comesBack()
{
    auto link = m_reopen();
    // A dead one may still let itself be opened.
    if (!link || !(*link)->waitReadable(Duration{}))
        return false;
    if ((*link)->hasBaud() && (*link)->baud() != baud() && !(*link)->setBaud(baud()))
        return false;
    m_link = std::move(*link);
    m_freeAt = m_lastByteAt = m_clock.now();
    m_away.store(false);
    m_trace.note(m_clock.now(), QStringLiteral("link back"));
    return true;
}

base::Result<void> Line::alive() const
{
    if (away())
        return base::fail(base::ErrorCode::NoAnswer, QStringLiteral("port"), m_name);
    if (m_link == nullptr)
        return base::fail(base::ErrorCode::LinkLost, QStringLiteral("port"), m_name);
    return {};
}

base::Result<Duration> Line::send(base::ByteView frame)
{
    if (const auto up = alive(); !up)
        return tl::unexpected(up.error());
    if (m_clock.now() < m_freeAt)
        m_clock.sleepUntil(m_freeAt);
    const Duration now = m_clock.now();
    if (const auto written = m_link->write(frame); !written)
        return loss(written.error());
    const Duration span = wireTime(frame.size());
    m_freeAt = now + span;
    // What comes back as echo is counted when it comes.
    m_statistics.bytesSent(frame.size(), echoes() ? Duration{} : span);
    m_trace.add(now, TraceKind::Sent, frame);
    if (echoes()) {
        if (m_echo.size() > mostEchoOwed)
            m_echo.clear();
        m_echo.insert(m_echo.end(), frame.begin(), frame.end());
    }
    return now;
}

base::Result<bool> Line::receive(Duration span)
{
    if (away())
        return lookForReturn(span);
    if (const auto up = alive(); !up)
        return tl::unexpected(up.error());
    const auto ready = m_link->waitReadable(std::max(span, Duration{}));
    const auto gone = [this](const base::Error& error) -> base::Result<bool> {
        const auto reason = loss(error);
        return away() ? base::Result<bool>(false) : reason;
    };
    if (!ready)
        return gone(ready.error());
    if (!*ready)
        return false;
    dropTaken();
    const auto count = m_link->read(m_buffer);
    if (!count)
        return gone(count.error());
    if (*count == 0)
        return false;
    m_lastByteAt = m_clock.now();
    m_awayUntil.reset();
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
        if (m_buffer.size() > m_echo.size() + maxBeforeEcho)
            giveUpEcho();
        return;
    }
    m_trace.add(m_lastByteAt, TraceKind::Echo, m_echo);
    m_buffer.erase(found, found + static_cast<std::ptrdiff_t>(m_echo.size()));
    m_echo.clear();
}

void Line::giveUpEcho()
{
    if (m_echo.empty())
        return;
    const std::size_t count = std::min(m_echo.size(), received());
    m_trace.add(m_lastByteAt, TraceKind::Echo, waiting().first(count));
    m_echo.clear();
    consume(count);
}

void Line::consumeAllBut(std::size_t kept)
{
    if (received() > kept)
        consume(received() - kept);
}

/// Once an arrival, not once a frame: what is left is at most the beginning of a frame.
void Line::dropTaken()
{
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_taken));
    m_taken = 0;
}

base::Bytes Line::takePending()
{
    dropTaken();
    return std::exchange(m_buffer, {});
}

base::Result<void> Line::setBaud(int baud)
{
    if (const auto up = alive(); !up)
        return up;
    // The adapter still has to put out what it was given at the old rate.
    if (m_clock.now() < m_freeAt + 2ms)
        m_clock.sleepUntil(m_freeAt + 2ms);
    const auto set = m_link->setBaud(baud);
    if (!set)
        return set.error().code == base::ErrorCode::LinkLost ? loss(set.error()) : set;
    m_baud.store(m_link->baud(), std::memory_order_relaxed);
    m_trace.note(m_clock.now(), QStringLiteral("rate %1").arg(baud));
    return {};
}

void Line::close()
{
    m_link.reset();
    m_away.store(false);
    m_lost.store(true);
}
} // namespace bus

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/exchange.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Result;
using protocol::Expectation;
using protocol::Part;
using protocol::ScanKind;
using Event = StatisticsCollector::Event;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t longestFrame = 256;
/// No decision needs more: the longest frame, and what may begin inside it.
constexpr std::size_t scanWindow = 1024;
/// What answers a raw request is kept up to this much.
constexpr std::size_t maxRawReply = 65'536;

bool has(const std::vector<int>& ids, int id)
{
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Broadcast and unknown servos count in the sum only.
int countedId(int id)
{
    return id <= protocol::maxId ? id : -1;
}

/// Which of several troubles tells most about the cause.
int rank(FaultKind kind)
{
    switch (kind) {
    case FaultKind::Unrest:
        return 5;
    case FaultKind::BadCheck:
        return 4;
    case FaultKind::WrongShape:
        return 3;
    case FaultKind::Noise:
        return 2;
    default:
        return 1;
    }
}

/// What must reach the servo as far as the wire allows: a lock that is to be closed, torque that is
/// to go off. Reading tells later what became of it.
bool isSentRegardless(const protocol::Request& request)
{
    switch (request.op) {
    case protocol::Op::Write:
    case protocol::Op::RegWrite:
    case protocol::Op::SyncWrite:
    case protocol::Op::Halt:
        return request.repeat == protocol::Repeat::Safe;
    case protocol::Op::Raw:
        return true;
    default:
        return false;
    }
}
} // namespace

base::ErrorCode errorFor(FaultKind kind)
{
    switch (kind) {
    case FaultKind::BadCheck:
    case FaultKind::Noise:
        return base::ErrorCode::Garbled;
    case FaultKind::WrongShape:
        return base::ErrorCode::WrongAnswer;
    case FaultKind::Unrest:
        return base::ErrorCode::LineBusy;
    default:
        return base::ErrorCode::NoAnswer;
    }
}

/// A request under way.
struct Exchange::Wait {
    Expectation expected; ///< `ids` shrinks as the replies come
    Attempt attempt;
    Duration onTime{}; ///< when a prompt adapter would have shown the last reply
    Duration deadline{};
    std::vector<int> broken; ///< answered with a wrong checksum
    /// A PING asks whether a servo is there: silence is an answer to that, not an error.
    bool asksWhoIsThere = false;

    bool asks(int id) const { return has(expected.ids, id); }
    /// The servo that noise is counted for.
    int blamed() const { return expected.ids.size() == 1 ? expected.ids.front() : -1; }
    void trouble(FaultKind kind)
    {
        if (!attempt.fault || rank(kind) > rank(*attempt.fault))
            attempt.fault = kind;
    }
    bool done() const
    {
        return std::all_of(expected.ids.begin(), expected.ids.end(),
                           [this](int id) { return has(broken, id); });
    }
};

Exchange::Exchange(Line& line, const protocol::Codec& probeCodec, base::Clock& clock,
                   LateGuard& guard, StatisticsCollector& statistics, TraceRing& trace,
                   StrayList& strays)
    : m_line(line)
    , m_codec(&probeCodec)
    , m_clock(clock)
    , m_guard(guard)
    , m_statistics(statistics)
    , m_trace(trace)
    , m_strays(strays)
{}

Result<Attempt> Exchange::run(const protocol::Request& request, base::ByteView frame,
                              Duration patience, Duration replyDelay, const Interrupt& interrupt)
{
    if (const auto quiet = awaitSilence(interrupt); !quiet)
        return tl::unexpected(quiet.error());
    const bool raw = request.op == protocol::Op::Raw;
    Wait wait;
    const protocol::Codec& codec = protocol::codecFor(request.protocol);
    // Nothing is sent yet, so stop may end this even if the request must not be repeated.
    if (unrest() == Unrest::None) {
        if (const auto silent = keepSilence(codec, interrupt); !silent)
            return tl::unexpected(silent.error());
    }
    const Unrest before = unrest();
    m_codec = &codec;
    m_language = request.protocol;
    m_trace.speak(request.protocol);
    wait.expected = m_codec->expect(request);
    wait.asksWhoIsThere = request.op == protocol::Op::Ping;
    if (before == Unrest::Unreadable && !isSentRegardless(request))
        return refused(wait, interrupt);
    const std::size_t replies = wait.expected.ids.size();
    // An emergency that came while the line was looked at goes first.
    if (const auto reason = interrupt.due())
        return base::fail(*reason);
    m_guard.sending(request);
    const auto sentAt = m_line.send(frame);
    if (!sentAt && !m_line.away())
        return tl::unexpected(sentAt.error());
    countSent(request, wait.expected);
    if (!sentAt)
        return unheard(wait, interrupt);

    wait.attempt.sentAt = *sentAt;
    wait.onTime = m_line.freeAt() +
                  m_line.wireTime(replies * static_cast<std::size_t>(wait.expected.replyBytes));
    if (raw || replies > 0)
        wait.onTime += replyDelay * std::max<std::size_t>(replies, 1);
    wait.attempt.onTime = wait.onTime;
    wait.deadline = wait.onTime + (patience > 0us ? patience : m_guard.patience());
    m_repliesUntil = wait.onTime;
    m_unsettled = true;
    return receiveFor(request, wait, before, interrupt);
}

Result<Attempt> Exchange::receiveFor(const protocol::Request& request, Wait& wait, Unrest before,
                                     const Interrupt& interrupt)
{
    const bool raw = request.op == protocol::Op::Raw;
    const std::size_t replies = wait.expected.ids.size();
    Interrupt early = interrupt;
    if (request.repeat == protocol::Repeat::Never)
        early.caller = nullptr;
    const bool believed = raw || before != Unrest::Unreadable;
    const auto received = raw                       ? receiveRaw(wait, early)
                          : believed && replies > 0 ? receiveReplies(wait, early)
                                                    : listenUntil(m_line.freeAt(), {});
    if (!received)
        return tl::unexpected(received.error());
    wait.attempt.endedAt = m_clock.now();
    if (!believed)
        giveUp(wait, true);
    if (before != Unrest::None && !wait.attempt.missing.empty())
        wait.trouble(FaultKind::Unrest);
    // Nobody was to answer, but the link has died under it: it may not have got through.
    if (replies == 0 && m_line.away())
        wait.trouble(FaultKind::TimeOut);
    return std::move(wait.attempt);
}

/// The link is away, and nothing was sent: to whoever asks that is silence.
Result<Attempt> Exchange::unheard(Wait& wait, const Interrupt& interrupt)
{
    wait.attempt.sentAt = m_clock.now();
    // Nobody goes round faster than the line can come back.
    if (const auto heard = listenUntil(wait.attempt.sentAt + waitSlice, interrupt); !heard)
        return tl::unexpected(heard.error());
    wait.attempt.endedAt = m_clock.now();
    wait.attempt.missing = wait.expected.ids;
    for (const int id : wait.expected.ids)
        countSilence(wait, id);
    wait.trouble(FaultKind::TimeOut);
    return std::move(wait.attempt);
}

void Exchange::countSilence(const Wait& wait, int id)
{
    if (!wait.asksWhoIsThere)
        m_statistics.count(Event::TimeOut, countedId(id));
}

Duration Exchange::tolerance() const
{
    return maxNoiseTime + m_line.wireTime(maxNoiseBytes);
}

bool Exchange::overloaded() const
{
    return m_unrest.overloaded(tolerance(), m_clock.now());
}

void Exchange::unasked(std::size_t bytes, bool frame)
{
    // Forgotten soon after it has ended, however much it was.
    const Duration most = tolerance() + waitSlice;
    m_unrest.heard(m_line.wireTime(bytes), frame, m_line.lastByteAt(), most);
}

Exchange::Unrest Exchange::unrest() const
{
    if (overloaded() || (m_neverSilent && m_unrest.framesHeard()))
        return Unrest::Unreadable;
    return m_neverSilent ? Unrest::Noisy : Unrest::None;
}

/// Whatever came now might be taken for the reply, so nothing is asked.
Result<Attempt> Exchange::refused(Wait& wait, const Interrupt& interrupt)
{
    wait.attempt.sentAt = m_clock.now();
    m_trace.note(wait.attempt.sentAt, QStringLiteral("line busy"));
    // A caller that asks again does not do so at the speed of the processor.
    if (const auto heard = listenUntil(wait.attempt.sentAt + waitSlice, interrupt); !heard)
        return tl::unexpected(heard.error());
    wait.attempt.endedAt = m_clock.now();
    wait.attempt.missing = wait.expected.ids;
    wait.attempt.refused = true;
    wait.trouble(FaultKind::Unrest);
    return std::move(wait.attempt);
}

void Exchange::countSent(const protocol::Request& request, const Expectation& expected)
{
    if (!expected.any())
        m_statistics.count(Event::Sent, countedId(request.id));
    for (const int id : expected.ids)
        m_statistics.count(Event::Sent, countedId(id));
}

/// Receives until `ended`, asked after every arrival, says so; at most until the deadline and the
/// end of a reply that is running then.
template <typename Ended>
Result<void> Exchange::receiveUntil(const Wait& wait, const Interrupt& interrupt, Ended&& ended)
{
    const Duration limit = wait.deadline + m_line.wireTime(longestFrame);
    for (bool lastLook = false; !lastLook;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        const Duration silentAt =
            m_line.received() > 0 ? m_line.lastByteAt() + m_line.silence() : Duration{};
        const Duration until = std::max(wait.deadline, std::min(silentAt, limit));
        // A thread that was not scheduled in time still finds what has come meanwhile.
        lastLook = now >= until;
        const auto came = m_line.receive(std::clamp(until - now, Duration{}, waitSlice));
        if (!came)
            return tl::unexpected(came.error());
        if (*came && ended())
            return {};
        lastLook = lastLook && !(*came && now < limit);
    }
    return {};
}

Result<void> Exchange::receiveReplies(Wait& wait, const Interrupt& interrupt)
{
    const auto replyBytes = static_cast<std::size_t>(wait.expected.replyBytes);
    const bool anybody = wait.asks(protocol::broadcastId);
    const auto received = receiveUntil(wait, interrupt, [&] {
        if (m_line.received() >= m_line.echoOwed() + replyBytes)
            m_line.giveUpEcho();
        digest(wait, false);
        return wait.expected.ids.empty() || (wait.done() && m_line.received() == 0);
    });
    if (!received) {
        giveUp(wait, true);
        return received;
    }
    if (!wait.expected.ids.empty()) {
        m_line.giveUpEcho();
        digest(wait, true);
        giveUp(wait, false);
    }
    if (wait.attempt.missing.empty())
        wait.attempt.fault.reset();
    m_unsettled = anybody || !wait.attempt.missing.empty() || m_line.received() > 0;
    return {};
}

Result<void> Exchange::receiveRaw(Wait& wait, const Interrupt& interrupt)
{
    const auto received =
        receiveUntil(wait, interrupt, [this] { return m_line.received() >= maxRawReply; });
    // Nobody knows whom the bytes spoke to, nor whether all answers are in.
    m_guard.quietAll(m_clock.now());
    m_line.giveUpEcho();
    base::Bytes bytes = m_line.takePending();
    if (!bytes.empty())
        m_trace.add(m_line.lastByteAt(), TraceKind::Received, bytes);
    wait.attempt.arrivals.push_back({{-1, 0, std::move(bytes)}, m_line.lastByteAt()});
    return received;
}

void Exchange::giveUp(Wait& wait, bool interrupted)
{
    const Duration now = m_clock.now();
    for (const int id : wait.expected.ids) {
        wait.attempt.missing.push_back(id);
        if (has(wait.broken, id))
            continue;
        m_guard.timedOut(id, wait.onTime, now, m_language);
        if (interrupted)
            continue;
        wait.trouble(FaultKind::TimeOut);
        countSilence(wait, id);
        m_trace.note(now, QStringLiteral("time-out %1").arg(id));
    }
}

void Exchange::digest(Wait& wait, bool atDeadline)
{
    while (!m_line.pending().empty()) {
        // However much waits, the work for each byte is the same.
        const base::ByteView all = m_line.pending();
        const base::ByteView window = all.first(std::min(all.size(), scanWindow));
        const bool more = window.size() < all.size();
        protocol::ScanResult result = m_codec->scan(window, wait.expected, atDeadline);
        if (result.kind == ScanKind::Incomplete && more)
            result = m_codec->scan(window, wait.expected, true);
        if (result.kind == ScanKind::Incomplete)
            return;
        const base::ByteView bytes = window.first(result.consumed);
        switch (result.kind) {
        case ScanKind::Reply:
            m_trace.add(m_line.lastByteAt(), TraceKind::Received, bytes);
            takeReply(wait, std::move(result.part));
            break;
        case ScanKind::Foreign:
            takeForeign(wait, std::move(result.part), bytes);
            break;
        case ScanKind::BadCheck:
            unasked(bytes.size(), false);
            m_trace.add(m_line.lastByteAt(), TraceKind::BadCheck, bytes);
            takeBadCheck(wait, result.part.id);
            break;
        case ScanKind::Noise:
        case ScanKind::Incomplete:
            unasked(bytes.size(), false);
            m_trace.add(m_line.lastByteAt(), TraceKind::Noise, bytes);
            m_statistics.noise(wait.blamed(), bytes.size());
            wait.trouble(FaultKind::Noise);
            break;
        }
        m_line.consume(result.consumed);
    }
}

void Exchange::digestStrays(bool atDeadline)
{
    Wait nobody;
    digest(nobody, atDeadline);
}

void Exchange::takeReply(Wait& wait, Part part)
{
    const Duration at = m_line.lastByteAt();
    auto& ids = wait.expected.ids;
    auto asked = std::find(ids.begin(), ids.end(), part.id);
    if (asked == ids.end()) // broadcast PING, or an ID write acknowledged from the new ID
        asked = ids.begin();
    const int id = *asked == protocol::broadcastId ? part.id : *asked;
    ids.erase(asked);
    m_guard.answered(id, wait.onTime, at, m_language);
    m_guard.learn(at - wait.onTime);
    m_statistics.answered(id, at - wait.attempt.sentAt);
    wait.attempt.arrivals.push_back({std::move(part), at});
}

void Exchange::takeForeign(Wait& wait, Part part, base::ByteView frame)
{
    const Duration at = m_line.lastByteAt();
    const int id = countedId(part.id);
    if (const auto lateness = m_guard.settle(id, at, m_language)) {
        m_guard.learn(*lateness);
        m_statistics.count(Event::Late, id);
        m_trace.add(at, TraceKind::Late, frame);
    } else {
        unasked(frame.size(), true);
        m_statistics.count(Event::Foreign, id);
        m_trace.add(at, TraceKind::Foreign, frame);
        if (wait.asks(part.id))
            wait.trouble(FaultKind::WrongShape);
        else if (id >= 0 && !wait.expected.ids.empty())
            wait.attempt.foreignId = id;
    }
    if (id >= 0)
        m_strays.add({id, part.status, std::move(part.data), at, part.exception});
}

void Exchange::takeBadCheck(Wait& wait, int id)
{
    m_statistics.count(Event::BadCheck, countedId(id));
    wait.trouble(FaultKind::BadCheck);
    const int blamed = wait.asks(id) ? id : wait.blamed();
    if (!has(wait.broken, blamed))
        wait.broken.push_back(blamed);
}
} // namespace bus

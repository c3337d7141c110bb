// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/exchange.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Result;
using protocol::Expectation;
using protocol::Reply;
using protocol::ScanKind;
using Event = StatisticsCollector::Event;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t maxFrameSize = 256;
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
    case FaultKind::LineBusy:
        return 5;
    case FaultKind::BadChecksum:
        return 4;
    case FaultKind::UnexpectedReply:
        return 3;
    case FaultKind::Noise:
        return 2;
    default:
        return 1;
    }
}

/// What must reach the servo as far as the wire allows: a lock that is to be closed, torque that is
/// to go off. Reading tells later what became of it.
bool isSentOnBusyLine(const protocol::Request& request)
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
    case FaultKind::BadChecksum:
    case FaultKind::Noise:
        return base::ErrorCode::Garbled;
    case FaultKind::UnexpectedReply:
        return base::ErrorCode::UnexpectedReply;
    case FaultKind::LineBusy:
        return base::ErrorCode::LineBusy;
    default:
        return base::ErrorCode::NoReply;
    }
}

/// A request under way.
struct Exchange::Wait {
    Expectation expected; ///< `ids` shrinks as the replies come
    Attempt attempt;
    Duration expectedAt{}; ///< when a prompt adapter would have shown the last reply
    Duration deadline{};
    std::vector<int> broken; ///< answered with a wrong checksum
    /// A PING asks whether a servo is there: silence is an answer to that, not an error.
    bool isPing = false;

    bool expects(int id) const { return has(expected.ids, id); }
    /// The servo that noise is counted for.
    int soleTarget() const { return expected.ids.size() == 1 ? expected.ids.front() : -1; }
    void addFault(FaultKind kind)
    {
        if (!attempt.fault || rank(kind) > rank(*attempt.fault))
            attempt.fault = kind;
    }
    bool isDone() const
    {
        return std::all_of(expected.ids.begin(), expected.ids.end(),
                           [this](int id) { return has(broken, id); });
    }
};

Exchange::Exchange(Line& line, const protocol::Codec& probeCodec, base::Clock& clock,
                   LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics,
                   TraceRing& trace, UnexpectedFrameList& strays)
    : m_line(line)
    , m_codec(&probeCodec)
    , m_clock(clock)
    , m_lateReplyGuard(lateReplyGuard)
    , m_statistics(statistics)
    , m_trace(trace)
    , m_unexpectedFrames(strays)
{}

Result<Attempt> Exchange::run(const protocol::Request& request, base::ByteView frame,
                              Duration timeout, Duration replyDelay, const Interrupt& interrupt)
{
    if (const auto quiet = awaitSilence(interrupt); !quiet)
        return tl::unexpected(quiet.error());
    const bool raw = request.op == protocol::Op::Raw;
    Wait wait;
    const protocol::Codec& codec = protocol::codecFor(request.protocol);
    // Nothing is sent yet, so stop may end this even if the request must not be repeated.
    if (lineState() == LineState::None) {
        if (const auto silent = awaitFrameGap(codec, interrupt); !silent)
            return tl::unexpected(silent.error());
    }
    const LineState before = lineState();
    m_codec = &codec;
    m_protocol = request.protocol;
    m_trace.setProtocol(request.protocol);
    wait.expected = m_codec->expect(request);
    wait.isPing = request.op == protocol::Op::Ping;
    if (before == LineState::Unreadable && !isSentOnBusyLine(request))
        return refused(wait, interrupt);
    const std::size_t replies = wait.expected.ids.size();
    // An emergency that came while the line was looked at goes first.
    if (const auto reason = interrupt.due())
        return base::fail(*reason);
    m_lateReplyGuard.aboutToSend(request);
    const auto sentAt = m_line.send(frame);
    if (!sentAt && !m_line.isReconnecting())
        return tl::unexpected(sentAt.error());
    countSent(request, wait.expected);
    if (!sentAt)
        return sendFailed(wait, interrupt);

    wait.attempt.sentAt = *sentAt;
    wait.expectedAt = m_line.freeAt() +
                      m_line.wireTime(replies * static_cast<std::size_t>(wait.expected.replyBytes));
    if (raw || replies > 0)
        wait.expectedAt += replyDelay * std::max<std::size_t>(replies, 1);
    wait.attempt.expectedAt = wait.expectedAt;
    wait.deadline = wait.expectedAt + (timeout > 0us ? timeout : m_lateReplyGuard.timeout());
    m_repliesUntil = wait.expectedAt;
    m_awaitingSilence = true;
    return receiveAttempt(request, wait, before, interrupt);
}

Result<Attempt> Exchange::receiveAttempt(const protocol::Request& request, Wait& wait,
                                         LineState before, const Interrupt& interrupt)
{
    const bool raw = request.op == protocol::Op::Raw;
    const std::size_t replies = wait.expected.ids.size();
    Interrupt interruptible = interrupt;
    if (request.repeat == protocol::Repeat::Never)
        interruptible.caller = nullptr;
    const bool isReadable = raw || before != LineState::Unreadable;
    const auto received = raw                         ? receiveRaw(wait, interruptible)
                          : isReadable && replies > 0 ? receiveReplies(wait, interruptible)
                                                      : listenUntil(m_line.freeAt(), {});
    if (!received)
        return tl::unexpected(received.error());
    wait.attempt.endedAt = m_clock.now();
    if (!isReadable)
        giveUp(wait, true);
    if (before != LineState::None && !wait.attempt.missing.empty())
        wait.addFault(FaultKind::LineBusy);
    // Nobody was to answer, but the link has died under it: it may not have got through.
    if (replies == 0 && m_line.isReconnecting())
        wait.addFault(FaultKind::Timeout);
    return std::move(wait.attempt);
}

/// The link is away, and nothing was sent: to whoever asks that is silence.
Result<Attempt> Exchange::sendFailed(Wait& wait, const Interrupt& interrupt)
{
    wait.attempt.sentAt = m_clock.now();
    // Nobody goes round faster than the line can come back.
    if (const auto listened = listenUntil(wait.attempt.sentAt + waitSlice, interrupt); !listened)
        return tl::unexpected(listened.error());
    wait.attempt.endedAt = m_clock.now();
    wait.attempt.missing = wait.expected.ids;
    for (const int id : wait.expected.ids)
        countTimeout(wait, id);
    wait.addFault(FaultKind::Timeout);
    return std::move(wait.attempt);
}

void Exchange::countTimeout(const Wait& wait, int id)
{
    if (!wait.isPing)
        m_statistics.count(Event::Timeout, countedId(id));
}

Duration Exchange::tolerance() const
{
    return maxNoiseTime + m_line.wireTime(maxNoiseBytes);
}

bool Exchange::isOverloaded() const
{
    return m_lineNoise.isOverloaded(tolerance(), m_clock.now());
}

void Exchange::countUnsolicited(std::size_t bytes, bool frame)
{
    // Forgotten soon after it has ended, however much it was.
    const Duration maxLevel = tolerance() + waitSlice;
    m_lineNoise.addBytes(m_line.wireTime(bytes), frame, m_line.lastByteAt(), maxLevel);
}

Exchange::LineState Exchange::lineState() const
{
    if (isOverloaded() || (m_lineBusy && m_lineNoise.hasFrames()))
        return LineState::Unreadable;
    return m_lineBusy ? LineState::Noisy : LineState::None;
}

/// Whatever came now might be taken for the reply, so nothing is asked.
Result<Attempt> Exchange::refused(Wait& wait, const Interrupt& interrupt)
{
    wait.attempt.sentAt = m_clock.now();
    m_trace.note(wait.attempt.sentAt, QStringLiteral("line busy"));
    // A caller that asks again does not do so at the speed of the processor.
    if (const auto listened = listenUntil(wait.attempt.sentAt + waitSlice, interrupt); !listened)
        return tl::unexpected(listened.error());
    wait.attempt.endedAt = m_clock.now();
    wait.attempt.missing = wait.expected.ids;
    wait.attempt.refused = true;
    wait.addFault(FaultKind::LineBusy);
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
template <typename Predicate>
Result<void> Exchange::receiveUntil(const Wait& wait, const Interrupt& interrupt,
                                    Predicate&& isFinished)
{
    const Duration limit = wait.deadline + m_line.wireTime(maxFrameSize);
    for (bool lastPass = false; !lastPass;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        const Duration silentAt =
            m_line.received() > 0 ? m_line.lastByteAt() + m_line.silence() : Duration{};
        const Duration until = std::max(wait.deadline, std::min(silentAt, limit));
        // A thread that was not scheduled in time still finds what has come meanwhile.
        lastPass = now >= until;
        const auto hasData = m_line.receive(std::clamp(until - now, Duration{}, waitSlice));
        if (!hasData)
            return tl::unexpected(hasData.error());
        if (*hasData && isFinished())
            return {};
        lastPass = lastPass && !(*hasData && now < limit);
    }
    return {};
}

Result<void> Exchange::receiveReplies(Wait& wait, const Interrupt& interrupt)
{
    const auto replyBytes = static_cast<std::size_t>(wait.expected.replyBytes);
    const bool isBroadcastPing = wait.expects(protocol::broadcastId);
    const auto received = receiveUntil(wait, interrupt, [&] {
        if (m_line.received() >= m_line.pendingEchoBytes() + replyBytes)
            m_line.discardEcho();
        parseBuffer(wait, false);
        return wait.expected.ids.empty() || (wait.isDone() && m_line.received() == 0);
    });
    if (!received) {
        giveUp(wait, true);
        return received;
    }
    if (!wait.expected.ids.empty()) {
        m_line.discardEcho();
        parseBuffer(wait, true);
        giveUp(wait, false);
    }
    if (wait.attempt.missing.empty())
        wait.attempt.fault.reset();
    m_awaitingSilence = isBroadcastPing || !wait.attempt.missing.empty() || m_line.received() > 0;
    return {};
}

Result<void> Exchange::receiveRaw(Wait& wait, const Interrupt& interrupt)
{
    const auto received =
        receiveUntil(wait, interrupt, [this] { return m_line.received() >= maxRawReply; });
    // Nobody knows whom the bytes spoke to, nor whether all answers are in.
    m_lateReplyGuard.quietAll(m_clock.now());
    m_line.discardEcho();
    base::Bytes bytes = m_line.takePending();
    if (!bytes.empty())
        m_trace.add(m_line.lastByteAt(), TraceKind::Received, bytes);
    wait.attempt.receivedReplies.push_back({{-1, 0, std::move(bytes)}, m_line.lastByteAt()});
    return received;
}

void Exchange::giveUp(Wait& wait, bool interrupted)
{
    const Duration now = m_clock.now();
    for (const int id : wait.expected.ids) {
        wait.attempt.missing.push_back(id);
        if (has(wait.broken, id))
            continue;
        m_lateReplyGuard.timedOut(id, wait.expectedAt, now, m_protocol);
        if (interrupted)
            continue;
        wait.addFault(FaultKind::Timeout);
        countTimeout(wait, id);
        m_trace.note(now, QStringLiteral("time-out %1").arg(id));
    }
}

void Exchange::parseBuffer(Wait& wait, bool atDeadline)
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
            handleReply(wait, std::move(result.part));
            break;
        case ScanKind::Foreign:
            handleForeign(wait, std::move(result.part), bytes);
            break;
        case ScanKind::BadChecksum:
            countUnsolicited(bytes.size(), false);
            m_trace.add(m_line.lastByteAt(), TraceKind::BadChecksum, bytes);
            handleBadChecksum(wait, result.part.id);
            break;
        case ScanKind::Noise:
        case ScanKind::Incomplete:
            countUnsolicited(bytes.size(), false);
            m_trace.add(m_line.lastByteAt(), TraceKind::Noise, bytes);
            m_statistics.addNoise(wait.soleTarget(), bytes.size());
            wait.addFault(FaultKind::Noise);
            break;
        }
        m_line.consume(result.consumed);
    }
}

void Exchange::parseUnexpected(bool atDeadline)
{
    Wait noRequest;
    parseBuffer(noRequest, atDeadline);
}

void Exchange::handleReply(Wait& wait, Reply part)
{
    const Duration at = m_line.lastByteAt();
    auto& ids = wait.expected.ids;
    auto asked = std::find(ids.begin(), ids.end(), part.id);
    if (asked == ids.end()) // broadcast PING, or an ID write acknowledged from the new ID
        asked = ids.begin();
    const int id = *asked == protocol::broadcastId ? part.id : *asked;
    ids.erase(asked);
    m_lateReplyGuard.replyReceived(id, wait.expectedAt, at, m_protocol);
    m_lateReplyGuard.learn(at - wait.expectedAt);
    m_statistics.replyReceived(id, at - wait.attempt.sentAt);
    wait.attempt.receivedReplies.push_back({std::move(part), at});
}

void Exchange::handleForeign(Wait& wait, Reply part, base::ByteView frame)
{
    const Duration at = m_line.lastByteAt();
    const int id = countedId(part.id);
    if (const auto lateness = m_lateReplyGuard.matchLateReply(id, at, m_protocol)) {
        m_lateReplyGuard.learn(*lateness);
        m_statistics.count(Event::Late, id);
        m_trace.add(at, TraceKind::Late, frame);
    } else {
        countUnsolicited(frame.size(), true);
        m_statistics.count(Event::Foreign, id);
        m_trace.add(at, TraceKind::Foreign, frame);
        if (wait.expects(part.id))
            wait.addFault(FaultKind::UnexpectedReply);
        else if (id >= 0 && !wait.expected.ids.empty())
            wait.attempt.foreignId = id;
    }
    if (id >= 0)
        m_unexpectedFrames.add({id, part.status, std::move(part.data), at, part.exception});
}

void Exchange::handleBadChecksum(Wait& wait, int id)
{
    m_statistics.count(Event::BadChecksum, countedId(id));
    wait.addFault(FaultKind::BadChecksum);
    const int soleTarget = wait.expects(id) ? id : wait.soleTarget();
    if (!has(wait.broken, soleTarget))
        wait.broken.push_back(soleTarget);
}
} // namespace bus

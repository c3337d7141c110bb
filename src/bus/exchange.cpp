// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/exchange.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Result;
using namespace std::chrono_literals;

namespace {
constexpr std::size_t maxFrameSize = 256;
/// What answers a raw request is kept up to this much.
constexpr std::size_t maxRawReply = 65'536;

/// What must reach the servo as far as the wire allows: a lock that is to be closed, torque that is
/// to go off. Its result is read back later.
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

Exchange::Exchange(Line& line, const protocol::Codec& probeCodec, base::Clock& clock,
                   LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics,
                   TraceRing& trace, UnexpectedFrameList& unexpectedFrames)
    : m_line(line)
    , m_clock(clock)
    , m_lateReplyGuard(lateReplyGuard)
    , m_trace(trace)
    , m_scanner(line, probeCodec, clock, lateReplyGuard, statistics, trace, unexpectedFrames)
{}

Result<Attempt> Exchange::run(const protocol::Request& request, base::ByteView frame,
                              Duration timeout, Duration replyDelay, const Interrupt& interrupt)
{
    if (const auto quiet = awaitSilence(interrupt); !quiet)
        return tl::unexpected(quiet.error());
    const bool raw = request.op == protocol::Op::Raw;
    PendingRequest pending;
    const protocol::Codec& codec = protocol::codecFor(request.protocol);
    // Nothing is sent yet, so stop may end this even if the request must not be repeated.
    if (lineState() == LineState::None) {
        if (const auto silent = awaitFrameGap(codec, interrupt); !silent)
            return tl::unexpected(silent.error());
    }
    const LineState before = lineState();
    m_scanner.setProtocol(request.protocol);
    pending.expected = codec.expect(request);
    pending.isPing = request.op == protocol::Op::Ping;
    if (before == LineState::Unreadable && !isSentOnBusyLine(request))
        return refused(pending, interrupt);
    const std::size_t replies = pending.expected.ids.size();
    // An emergency that came while the line was looked at goes first.
    if (const auto reason = interrupt.due())
        return base::fail(*reason);
    m_lateReplyGuard.aboutToSend(request);
    const auto sentAt = m_line.send(frame);
    if (!sentAt && !m_line.isReconnecting())
        return tl::unexpected(sentAt.error());
    m_scanner.countSent(request, pending.expected);
    if (!sentAt)
        return sendFailed(pending, interrupt);

    pending.attempt.sentAt = *sentAt;
    pending.attempt.expectedAt =
        m_line.freeAt() +
        m_line.wireTime(replies * static_cast<std::size_t>(pending.expected.replyBytes));
    if (raw || replies > 0)
        pending.attempt.expectedAt += replyDelay * std::max<std::size_t>(replies, 1);
    pending.deadline =
        pending.attempt.expectedAt + (timeout > 0us ? timeout : m_lateReplyGuard.timeout());
    m_repliesUntil = pending.attempt.expectedAt;
    m_awaitingSilence = true;
    return receiveAttempt(request, pending, before, interrupt);
}

Result<Attempt> Exchange::receiveAttempt(const protocol::Request& request, PendingRequest& pending,
                                         LineState before, const Interrupt& interrupt)
{
    const bool raw = request.op == protocol::Op::Raw;
    const std::size_t replies = pending.expected.ids.size();
    Interrupt interruptible = interrupt;
    if (request.repeat == protocol::Repeat::Never)
        interruptible.caller = nullptr;
    const bool isReadable = raw || before != LineState::Unreadable;
    const auto received = raw                         ? receiveRaw(request, pending, interruptible)
                          : isReadable && replies > 0 ? receiveReplies(pending, interruptible)
                                                      : listenUntil(m_line.freeAt(), {});
    if (!received)
        return tl::unexpected(received.error());
    pending.attempt.endedAt = m_clock.now();
    if (!isReadable)
        m_scanner.giveUp(pending, true);
    // Whether a write got through can still be read back: that is no reason to give it up.
    const bool isFlooded = pending.isFlooded && request.isRead();
    if ((before != LineState::None || isFlooded) && !pending.attempt.missing.empty())
        pending.addFault(FaultKind::LineBusy);
    // No reply was expected, but the link broke meanwhile: the request may not have got through.
    if (replies == 0 && m_line.isReconnecting())
        pending.addFault(FaultKind::Timeout);
    return std::move(pending.attempt);
}

/// The link is away, and nothing was sent: the caller gets a time-out.
Result<Attempt> Exchange::sendFailed(PendingRequest& pending, const Interrupt& interrupt)
{
    pending.attempt.sentAt = m_clock.now();
    // Callers must not repeat faster than the link can come back.
    if (const auto listened = listenUntil(pending.attempt.sentAt + waitSlice, interrupt); !listened)
        return tl::unexpected(listened.error());
    pending.attempt.endedAt = m_clock.now();
    pending.attempt.missing = pending.expected.ids;
    for (const int id : pending.expected.ids)
        m_scanner.countTimeout(pending, id);
    pending.addFault(FaultKind::Timeout);
    return std::move(pending.attempt);
}

Exchange::LineState Exchange::lineState() const
{
    if (m_scanner.isOverloaded() || (m_lineBusy && m_scanner.hasUnsolicitedFrames()))
        return LineState::Unreadable;
    return m_lineBusy ? LineState::Noisy : LineState::None;
}

/// Any bytes might be taken for the reply, so nothing is sent.
Result<Attempt> Exchange::refused(PendingRequest& pending, const Interrupt& interrupt)
{
    pending.attempt.sentAt = m_clock.now();
    m_trace.note(pending.attempt.sentAt, QStringLiteral("line busy"));
    // A caller that asks again does not do so at the speed of the processor.
    if (const auto listened = listenUntil(pending.attempt.sentAt + waitSlice, interrupt); !listened)
        return tl::unexpected(listened.error());
    pending.attempt.endedAt = m_clock.now();
    pending.attempt.missing = pending.expected.ids;
    pending.attempt.refused = true;
    pending.addFault(FaultKind::LineBusy);
    return std::move(pending.attempt);
}

/// Receives until `ended`, asked after every arrival, says so; at most until the deadline and the
/// end of a reply that is running then.
template <typename Predicate>
Result<void> Exchange::receiveUntil(const PendingRequest& pending, const Interrupt& interrupt,
                                    Predicate&& isFinished)
{
    const Duration limit = pending.deadline + m_line.wireTime(maxFrameSize);
    for (bool lastPass = false; !lastPass;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        const Duration silentAt =
            m_line.received() > 0 ? m_line.lastByteAt() + m_line.silence() : Duration{};
        const Duration until = std::max(pending.deadline, std::min(silentAt, limit));
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

Result<void> Exchange::receiveReplies(PendingRequest& pending, const Interrupt& interrupt)
{
    const auto replyBytes = static_cast<std::size_t>(pending.expected.replyBytes);
    const bool isBroadcastPing = pending.expects(protocol::broadcastId);
    const auto received = receiveUntil(pending, interrupt, [&] {
        if (m_line.received() >= m_line.pendingEchoBytes() + replyBytes)
            m_line.discardEcho();
        m_scanner.scan(pending, false);
        pending.isFlooded = pending.isFlooded || m_scanner.isOverloaded();
        return pending.expected.ids.empty() || (pending.isDone() && m_line.received() == 0);
    });
    if (!received) {
        m_scanner.giveUp(pending, true);
        return received;
    }
    if (!pending.expected.ids.empty()) {
        m_line.discardEcho();
        m_scanner.scan(pending, true);
        m_scanner.giveUp(pending, false);
    }
    if (pending.attempt.missing.empty())
        pending.attempt.fault.reset();
    m_awaitingSilence =
        isBroadcastPing || !pending.attempt.missing.empty() || m_line.received() > 0;
    return {};
}

Result<void> Exchange::receiveRaw(const protocol::Request& request, PendingRequest& pending,
                                  const Interrupt& interrupt)
{
    const std::size_t wanted = request.count > 0 ? std::size_t(request.count) : maxRawReply;
    const auto isComplete = [&] { return m_line.received() >= m_line.pendingEchoBytes() + wanted; };
    const auto received = receiveUntil(pending, interrupt, isComplete);
    // It is not known which servos the bytes addressed, nor whether all replies are in.
    if (request.count == 0)
        m_lateReplyGuard.quietAll(m_clock.now());
    m_line.discardEcho();
    base::Bytes bytes = m_line.takePending();
    if (!bytes.empty())
        m_trace.add(m_line.lastByteAt(), TraceKind::Received, bytes);
    pending.attempt.receivedReplies.push_back({{-1, 0, std::move(bytes)}, m_line.lastByteAt()});
    return received;
}

} // namespace bus

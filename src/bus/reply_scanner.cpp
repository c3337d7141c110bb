// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/reply_scanner.h"

#include "bus/interrupt.h"

namespace bus {
using base::Duration;
using protocol::Reply;
using protocol::ScanKind;
using Event = StatisticsCollector::Event;

namespace {
/// No decision needs more: the longest frame, and what may begin inside it.
constexpr std::size_t scanWindow = 1024;

bool has(const std::vector<int>& ids, int id)
{
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Broadcast and unknown servos count in the sum only.
int countedId(int id)
{
    return id <= protocol::maxId ? id : -1;
}

/// Of several faults the one with the highest rank says most about the cause.
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

bool PendingRequest::expects(int id) const
{
    return has(expected.ids, id);
}

bool PendingRequest::isDone() const
{
    return std::all_of(expected.ids.begin(), expected.ids.end(),
                       [this](int id) { return has(broken, id); });
}

int PendingRequest::soleTarget() const
{
    return expected.ids.size() == 1 ? expected.ids.front() : -1;
}

void PendingRequest::addFault(FaultKind kind)
{
    if (!attempt.fault || rank(kind) > rank(*attempt.fault))
        attempt.fault = kind;
}

ReplyScanner::ReplyScanner(Line& line, const protocol::Codec& codec, base::Clock& clock,
                           LateReplyGuard& lateReplyGuard, StatisticsCollector& statistics,
                           TraceRing& trace, UnexpectedFrameList& unexpectedFrames)
    : m_line(line)
    , m_codec(&codec)
    , m_protocol(codec.echoProbe().protocol)
    , m_clock(clock)
    , m_lateReplyGuard(lateReplyGuard)
    , m_statistics(statistics)
    , m_trace(trace)
    , m_unexpectedFrames(unexpectedFrames)
{}

void ReplyScanner::setProtocol(base::Protocol protocol)
{
    m_codec = &protocol::codecFor(protocol);
    m_protocol = protocol;
    m_trace.setProtocol(protocol);
}

void ReplyScanner::countSent(const protocol::Request& request,
                             const protocol::Expectation& expected)
{
    if (!expected.any())
        m_statistics.count(Event::Sent, countedId(request.id));
    for (const int id : expected.ids)
        m_statistics.count(Event::Sent, countedId(id));
}

void ReplyScanner::countTimeout(const PendingRequest& request, int id)
{
    if (!request.isPing)
        m_statistics.count(Event::Timeout, countedId(id));
}

Duration ReplyScanner::noiseTolerance() const
{
    return maxNoiseTime + m_line.wireTime(maxNoiseBytes);
}

bool ReplyScanner::isOverloaded() const
{
    return m_lineNoise.isOverloaded(noiseTolerance(), m_clock.now());
}

void ReplyScanner::countUnsolicited(std::size_t bytes, bool isFrame)
{
    // Forgotten soon after it has ended, however much it was.
    const Duration maxLevel = noiseTolerance() + waitSlice;
    m_lineNoise.addBytes(m_line.wireTime(bytes), isFrame, m_line.lastByteAt(), maxLevel);
}

void ReplyScanner::countNoise(const PendingRequest& request, std::size_t bytes)
{
    countUnsolicited(bytes, false);
    if (request.expected.ids.empty())
        m_statistics.addUnsolicitedNoise(bytes);
}

void ReplyScanner::giveUp(PendingRequest& request, bool interrupted)
{
    const Duration now = m_clock.now();
    for (const int id : request.expected.ids) {
        request.attempt.missing.push_back(id);
        if (has(request.broken, id))
            continue;
        m_lateReplyGuard.timedOut(id, request.attempt.expectedAt, now, m_protocol);
        if (interrupted)
            continue;
        request.addFault(FaultKind::Timeout);
        countTimeout(request, id);
        m_trace.note(now, QStringLiteral("time-out %1").arg(id));
    }
}

void ReplyScanner::scan(PendingRequest& request, bool atDeadline)
{
    while (!m_line.pending().empty()) {
        // However much waits, the work for each byte is the same.
        const base::ByteView all = m_line.pending();
        const base::ByteView window = all.first(std::min(all.size(), scanWindow));
        const bool more = window.size() < all.size();
        protocol::ScanResult result = m_codec->scan(window, request.expected, atDeadline);
        if (result.kind == ScanKind::Incomplete && more)
            result = m_codec->scan(window, request.expected, true);
        if (result.kind == ScanKind::Incomplete)
            return;
        const base::ByteView bytes = window.first(result.consumed);
        switch (result.kind) {
        case ScanKind::Reply:
            m_trace.add(m_line.lastByteAt(), TraceKind::Received, bytes);
            handleReply(request, std::move(result.part));
            break;
        case ScanKind::Foreign:
            handleForeign(request, std::move(result.part), bytes);
            break;
        case ScanKind::BadChecksum:
            countNoise(request, bytes.size());
            m_trace.add(m_line.lastByteAt(), TraceKind::BadChecksum, bytes);
            handleBadChecksum(request, result.part.id);
            break;
        case ScanKind::Noise:
        case ScanKind::Incomplete:
            countNoise(request, bytes.size());
            m_trace.add(m_line.lastByteAt(), TraceKind::Noise, bytes);
            m_statistics.addNoise(request.soleTarget(), bytes.size());
            request.addFault(FaultKind::Noise);
            break;
        }
        m_line.consume(result.consumed);
    }
}

void ReplyScanner::scanUnexpected(bool atDeadline)
{
    PendingRequest none;
    scan(none, atDeadline);
}

void ReplyScanner::handleReply(PendingRequest& request, Reply part)
{
    const Duration at = m_line.lastByteAt();
    auto& ids = request.expected.ids;
    auto asked = std::find(ids.begin(), ids.end(), part.id);
    if (asked == ids.end()) // broadcast PING, or an ID write acknowledged from the new ID
        asked = ids.begin();
    const int id = *asked == protocol::broadcastId ? part.id : *asked;
    ids.erase(asked);
    m_lateReplyGuard.replyReceived(id, request.attempt.expectedAt, at, m_protocol);
    m_lateReplyGuard.learn(at - request.attempt.expectedAt);
    m_statistics.replyReceived(id, at - request.attempt.sentAt);
    request.attempt.receivedReplies.push_back({std::move(part), at});
}

void ReplyScanner::handleForeign(PendingRequest& request, Reply part, base::ByteView frame)
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
        if (request.expects(part.id))
            request.addFault(FaultKind::UnexpectedReply);
        else if (id >= 0 && !request.expected.ids.empty())
            request.attempt.foreignId = id;
    }
    if (id >= 0)
        m_unexpectedFrames.add({id, part.status, std::move(part.data), at, part.exception});
}

void ReplyScanner::handleBadChecksum(PendingRequest& request, int id)
{
    m_statistics.count(Event::BadChecksum, countedId(id));
    request.addFault(FaultKind::BadChecksum);
    const int soleTarget = request.expects(id) ? id : request.soleTarget();
    if (!has(request.broken, soleTarget))
        request.broken.push_back(soleTarget);
}
} // namespace bus

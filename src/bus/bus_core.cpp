// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_core.h"

#include "protocol/encode_error.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::Error;
using base::ErrorCode;
using base::Result;
using protocol::Op;
using protocol::Repeat;
using namespace std::chrono_literals;

namespace {
/// Errors name what the user asked for, in whichever form it was sent.
QString operationOf(Op op)
{
    switch (op) {
    case Op::SyncRead:
        return protocol::operationName(Op::Read);
    case Op::RegWrite:
    case Op::SyncWrite:
        return protocol::operationName(Op::Write);
    default:
        return protocol::operationName(op);
    }
}

/// Silence is the weakest finding: if anything came in any attempt, the user gets that error.
ErrorCode errorFor(const std::vector<Fault>& faults)
{
    ErrorCode code = ErrorCode::NoReply;
    for (const Fault& fault : faults) {
        if (fault.kind != FaultKind::Timeout)
            code = errorFor(fault.kind);
    }
    return code;
}

bool isSilence(const std::vector<Fault>& faults)
{
    return std::all_of(faults.begin(), faults.end(),
                       [](const Fault& fault) { return fault.kind == FaultKind::Timeout; });
}

/// A lost write is followed by the question what the servo holds now, to be asked as patiently.
bool provesSilence(const protocol::Request& request)
{
    return request.op == Op::Ping || request.op == Op::Read;
}

/// A servo that refuses explicitly (Modbus exceptions) is not asked again.
std::optional<Error> exceptionIn(const Attempt& attempt)
{
    for (const ReceivedReply& arrival : attempt.receivedReplies) {
        if (arrival.part.exception != 0)
            return Error{ErrorCode::Refused, {}, exceptionName(arrival.part.exception)};
    }
    return std::nullopt;
}

std::vector<protocol::Reply> repliesOf(std::vector<ReceivedReply> receivedReplies)
{
    std::vector<protocol::Reply> replies;
    replies.reserve(receivedReplies.size());
    for (ReceivedReply& arrival : receivedReplies)
        replies.push_back(std::move(arrival.part));
    return replies;
}
} // namespace

BusCore::BusCore(std::unique_ptr<transport::Link> link, const protocol::Codec& codec,
                 base::Clock& clock, CoreOptions options)
    : m_clock(clock)
    , m_options(std::move(options))
    , m_thread(std::this_thread::get_id())
    , m_statistics(clock.now())
    , m_line(std::move(link), clock, m_options.bitsPerByte, m_statistics, m_trace,
             std::move(m_options.reopen))
    , m_exchange(m_line, codec, clock, m_lateReplyGuard, m_statistics, m_trace, m_unexpectedFrames)
{
    if (const auto echoes = m_exchange.probeEcho(interruptBy(nullptr)); echoes)
        m_line.setHasEcho(*echoes);
}

Interrupt BusCore::interruptBy(const base::StopToken* stop) const
{
    return {&m_emergency, m_options.shutdown, stop};
}

Result<Outcome> BusCore::transact(const Transaction& transaction)
{
    return execute(transaction, m_holds.access(transaction.request, transaction.hold,
                                               std::this_thread::get_id(), transaction.epoch));
}

Result<Outcome> BusCore::execute(const Transaction& transaction, HoldTable::Access access)
{
    switch (access) {
    case HoldTable::Access::Pass:
        return run(transaction);
    case HoldTable::Access::Preempted:
        handleEmergency();
        return tl::unexpected(withContext({ErrorCode::Preempted}, transaction.request, 0));
    case HoldTable::Access::Wait:
    case HoldTable::Access::Refused:
        break;
    }
    return tl::unexpected(withContext({ErrorCode::Held}, transaction.request, 0));
}

Result<Outcome> BusCore::run(const Transaction& transaction)
{
    const protocol::Request& request = transaction.request;
    const auto frame = protocol::codecFor(request.protocol).encode(request);
    if (!frame)
        return tl::unexpected(frame.error());
    if (handleEmergency() && transaction.priority != Priority::Emergency) {
        m_holds.clearPreemption(transaction.hold);
        return tl::unexpected(withContext({ErrorCode::Preempted}, request, 0));
    }
    runOverduePoll(transaction.priority);
    auto outcome = transactWithRetries(transaction, *frame);
    if (!outcome && outcome.error().code == ErrorCode::Preempted) {
        m_holds.clearPreemption(transaction.hold);
        handleEmergency();
        // A check after a stop gets "no reply", not the report of another stop.
        if (m_line.isReconnecting() && transaction.priority == Priority::Emergency)
            return tl::unexpected(withContext({ErrorCode::NoReply}, request, 1));
    }
    return outcome;
}

Result<Outcome> BusCore::transactWithRetries(const Transaction& transaction, base::ByteView frame)
{
    const protocol::Request& request = transaction.request;
    const int maxRetries = transaction.retries >= 0 ? transaction.retries : m_retries.load();
    int attempts = request.repeat == Repeat::Never ? 1 : maxRetries + 1;
    const Interrupt interrupt = interruptBy(transaction.stop);
    const int countedId = request.id <= protocol::maxId ? request.id : -1;
    Outcome outcome;
    bool refused = false;
    std::optional<int> foreignId;
    while (outcome.attempts < attempts) {
        if (const auto ready = waitForTurn(transaction, interrupt); !ready)
            return tl::unexpected(withContext(ready.error(), request, outcome.attempts));
        if (outcome.attempts == 1)
            m_statistics.count(StatisticsCollector::Event::Retried, countedId);
        ++outcome.attempts;
        auto attempt = m_exchange.run(request, frame, transaction.timeout, replyDelay(), interrupt);
        if (!attempt)
            return tl::unexpected(withContext(attempt.error(), request, outcome.attempts));
        if (const auto exception = exceptionIn(*attempt))
            return tl::unexpected(withContext(*exception, request, outcome.attempts));
        if (!attempt->receivedReplies.empty() || !attempt->fault) {
            outcome.sentAt = attempt->sentAt;
            outcome.roundTrip = attempt->endedAt - attempt->sentAt;
            outcome.replies = repliesOf(std::move(attempt->receivedReplies));
            return outcome;
        }
        refused = attempt->refused;
        foreignId = attempt->foreignId;
        outcome.faults.push_back({*attempt->fault, attempt->endedAt});
        const bool first = outcome.attempts == 1 && !m_lateReplyGuard.hasMeasured();
        const bool last =
            outcome.attempts == maxRetries + 1 && transaction.patient &&
            !m_lateReplyGuard.isKnownSilent(request.id, m_clock.now(), request.protocol);
        if (attempts > 1 && transaction.timeout <= 0us && (first || last) &&
            isSilence(outcome.faults)) {
            const Duration patience = last ? LateReplyGuard::maxStall : LateReplyGuard::maxLateness;
            const auto late = awaitLateReply(attempt->sentAt + patience, interrupt);
            if (!late)
                return tl::unexpected(withContext(late.error(), request, outcome.attempts));
            attempts += last && *late ? 1 : 0;
            if (last && !*late && !m_line.isReconnecting() && provesSilence(request))
                m_lateReplyGuard.silenceProven(request.id, m_clock.now(), request.protocol);
        }
    }
    Error error{errorFor(outcome.faults)};
    if (foreignId && error.code == ErrorCode::NoReply)
        error.detail = QStringLiteral("from %1").arg(*foreignId);
    if (request.repeat == Repeat::Never && !refused) {
        error.detail = base::errorName(error.code);
        error.code = ErrorCode::Uncertain;
    }
    return tl::unexpected(withContext(std::move(error), request, refused ? 0 : outcome.attempts));
}

/// An adapter may be slower than the timeout a link has at first, and a busy computer may hold back
/// every reply for longer than a few prompt attempts take: silence is only believed when it has
/// lasted until `limit`. Ends with the late reply, which is learned from; true then. Also true if
/// it is damaged: requests that were held back and sent in one go collide with the replies. Polls
/// of others run meanwhile.
Result<bool> BusCore::awaitLateReply(Duration limit, const Interrupt& interrupt)
{
    const std::uint64_t before = m_lateReplyGuard.lateReplies();
    DamagedReplyWatch damaged(*this);
    while (m_lateReplyGuard.lateReplies() == before && !damaged.hasReplyCome()) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        if (now >= limit || m_line.isReconnecting()) // nothing was sent, or all is lost
            return false;
        if (runPoll())
            continue;
        const Duration until = std::min(limit, nextPoll().value_or(now + waitSlice));
        if (const auto listened = m_exchange.listenUntil(std::max(until, now + 1ms), interrupt);
            !listened)
            return tl::unexpected(listened.error());
    }
    return true;
}

/// Listens until the servos may be spoken to; polls of others run meanwhile.
Result<void> BusCore::waitForTurn(const Transaction& transaction, const Interrupt& interrupt)
{
    for (;;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        const Duration quiet = m_lateReplyGuard.quietUntil(transaction.request);
        if (now >= quiet)
            return {};
        if (transaction.priority != Priority::Emergency && runPoll())
            continue;
        const Duration next = nextPoll().value_or(quiet);
        const Duration until = std::clamp(next, now + 1ms, std::max(quiet, now + 1ms));
        if (const auto listened = m_exchange.listenUntil(std::min(until, quiet), interrupt);
            !listened)
            return listened;
    }
}

Error BusCore::withContext(Error error, const protocol::Request& request, int attempts) const
{
    error.operation = operationOf(request.op);
    error.id = request.id <= protocol::maxId ? request.id : -1;
    error.attempts = attempts;
    if (error.detail.isEmpty() && error.code == ErrorCode::LinkLost)
        error.detail = m_line.name();
    return error;
}

Result<void> BusCore::listen(Duration span)
{
    handleEmergency();
    auto listened = m_exchange.listenUntil(m_clock.now() + span, interruptBy(nullptr));
    if (!listened && listened.error().code == ErrorCode::Preempted)
        handleEmergency();
    return listened;
}

Result<void> BusCore::setBaud(int baud)
{
    const Interrupt interrupt = interruptBy(nullptr);
    auto quiet = m_exchange.awaitSilence(interrupt);
    while (!quiet && quiet.error().code == ErrorCode::Preempted) {
        handleEmergency();
        quiet = m_exchange.awaitSilence(interrupt);
    }
    if (!quiet)
        return quiet;
    m_lateReplyGuard.forgetSilence();
    return m_line.setBaud(baud);
}

bool BusCore::pauseUntil(Duration instant, const base::StopToken* stop)
{
    for (;;) {
        if (interruptBy(stop).due() == ErrorCode::Stopped)
            return false;
        handleEmergency();
        const Duration now = m_clock.now();
        if (now >= instant)
            return true;
        if (runPoll())
            continue;
        if (m_line.isReconnecting()) {
            static_cast<void>(m_exchange.listenUntil(std::min(instant, now + waitSlice), {}));
            continue;
        }
        Duration until = std::min(instant, nextPoll().value_or(instant));
        if (lost())
            until = instant;
        if (!m_clock.isManual())
            until = std::min(until, now + waitSlice);
        m_clock.sleepUntil(std::max(until, now + 1us), stop);
    }
}

Hold BusCore::hold(const std::vector<int>& ids, std::optional<std::uint64_t> epoch)
{
    return {this, m_holds.take(ids, std::this_thread::get_id(), epoch)};
}

void BusCore::setStopFrames(std::vector<StopFrame> frames)
{
    const std::lock_guard lock(m_stopFramesMutex);
    m_stopFrames = std::move(frames);
}

void BusCore::requestEmergency()
{
    m_holds.preemptAll();
    m_emergency.store(true, std::memory_order_release);
}

void BusCore::emergency()
{
    requestEmergency();
    if (std::this_thread::get_id() == m_thread)
        handleEmergency();
}

bool BusCore::handleEmergency()
{
    if (!m_emergency.load(std::memory_order_acquire))
        return false;
    // Nothing to say it on: until the link is back it is owed, and nothing else is said before it.
    if (m_line.isReconnecting())
        static_cast<void>(m_exchange.listenUntil(m_clock.now() + waitSlice, {}));
    if (m_line.isReconnecting() || !m_emergency.exchange(false, std::memory_order_acq_rel))
        return false;
    std::vector<StopFrame> frames;
    {
        const std::lock_guard lock(m_stopFramesMutex);
        frames = m_stopFrames;
    }
    m_trace.note(m_clock.now(), QStringLiteral("emergency"));
    // A lost link shows in the next transaction.
    static_cast<void>(m_exchange.sendStopFrames(frames, replyDelay()));
    if (m_line.isReconnecting()) // the link has died under it
        m_emergency.store(true, std::memory_order_release);
    return true;
}

Statistics BusCore::statistics() const
{
    Statistics statistics = m_statistics.snapshot(m_clock.now());
    statistics.timeout = m_lateReplyGuard.timeout();
    statistics.samplesLost = m_samples.lost();
    return statistics;
}

void BusCore::checkLink()
{
    static_cast<void>(m_exchange.listenUntil(Duration{}, {}));
}
} // namespace bus

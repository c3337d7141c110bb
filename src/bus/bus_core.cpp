// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_core.h"

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

QString operationName(Op op)
{
    switch (op) {
    case Op::Ping:
        return QStringLiteral("ping");
    case Op::Read:
    case Op::SyncRead:
        return QStringLiteral("read");
    case Op::Write:
    case Op::RegWrite:
    case Op::SyncWrite:
        return QStringLiteral("write");
    case Op::Action:
        return QStringLiteral("action");
    case Op::Halt:
        return QStringLiteral("halt");
    case Op::Restore:
        return QStringLiteral("restore");
    case Op::Backup:
        return QStringLiteral("backup");
    case Op::StateReset:
        return QStringLiteral("state-reset");
    case Op::Calibrate:
        return QStringLiteral("calibrate");
    case Op::Reboot:
        return QStringLiteral("reboot");
    case Op::Raw:
        return QStringLiteral("raw");
    }
    return {};
}

/// Silence says least: if anything came in any attempt, that is what the user is told.
ErrorCode errorFor(const std::vector<Fault>& faults)
{
    ErrorCode code = ErrorCode::NoAnswer;
    for (const Fault& fault : faults) {
        if (fault.kind != FaultKind::TimeOut)
            code = errorFor(fault.kind);
    }
    return code;
}

/// A servo that refuses in so many words (Modbus exceptions) is not asked again.
std::optional<Error> refusalIn(const Attempt& attempt)
{
    for (const Arrival& arrival : attempt.arrivals) {
        if (arrival.part.exception != 0)
            return Error{ErrorCode::Refused, {}, exceptionName(arrival.part.exception)};
    }
    return std::nullopt;
}

std::vector<protocol::Part> partsOf(std::vector<Arrival> arrivals)
{
    std::vector<protocol::Part> parts;
    parts.reserve(arrivals.size());
    for (Arrival& arrival : arrivals)
        parts.push_back(std::move(arrival.part));
    return parts;
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
    , m_exchange(m_line, codec, clock, m_guard, m_statistics, m_trace, m_strays)
{
    if (const auto echoes = m_exchange.probeEcho(interruptBy(nullptr)); echoes)
        m_line.setEchoes(*echoes);
}

Interrupt BusCore::interruptBy(const base::Stop* stop) const
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
        serveEmergency();
        return tl::unexpected(described({ErrorCode::Preempted}, transaction.request, 0));
    case HoldTable::Access::Wait:
    case HoldTable::Access::Refused:
        break;
    }
    return tl::unexpected(described({ErrorCode::Held}, transaction.request, 0));
}

Result<Outcome> BusCore::run(const Transaction& transaction)
{
    const protocol::Request& request = transaction.request;
    const auto frame = protocol::codecFor(request.protocol).encode(request);
    if (!frame)
        return tl::unexpected(frame.error());
    if (serveEmergency() && transaction.priority != Priority::Emergency) {
        m_holds.forgetPreemption(transaction.hold);
        return tl::unexpected(described({ErrorCode::Preempted}, request, 0));
    }
    sharePolls(transaction.priority);
    auto outcome = repeat(transaction, *frame);
    if (!outcome && outcome.error().code == ErrorCode::Preempted) {
        m_holds.forgetPreemption(transaction.hold);
        serveEmergency();
        // What looks after a stop hears that nobody answers, not that there is another stop.
        if (m_line.away() && transaction.priority == Priority::Emergency)
            return tl::unexpected(described({ErrorCode::NoAnswer}, request, 1));
    }
    return outcome;
}

Result<Outcome> BusCore::repeat(const Transaction& transaction, base::ByteView frame)
{
    const protocol::Request& request = transaction.request;
    const int wanted = transaction.retries >= 0 ? transaction.retries : m_retries.load();
    const int attempts = request.repeat == Repeat::Never ? 1 : wanted + 1;
    const Interrupt interrupt = interruptBy(transaction.stop);
    const int countedId = request.id <= protocol::maxId ? request.id : -1;
    Outcome outcome;
    bool refused = false;
    std::optional<int> foreignId;
    while (outcome.attempts < attempts) {
        if (const auto turn = awaitTurn(transaction, interrupt); !turn)
            return tl::unexpected(described(turn.error(), request, outcome.attempts));
        if (outcome.attempts == 1)
            m_statistics.count(StatisticsCollector::Event::Retried, countedId);
        ++outcome.attempts;
        auto attempt =
            m_exchange.run(request, frame, transaction.patience, replyDelay(), interrupt);
        if (!attempt)
            return tl::unexpected(described(attempt.error(), request, outcome.attempts));
        if (const auto refusal = refusalIn(*attempt))
            return tl::unexpected(described(*refusal, request, outcome.attempts));
        if (!attempt->arrivals.empty() || !attempt->fault) {
            outcome.sentAt = attempt->sentAt;
            outcome.roundTrip = attempt->endedAt - attempt->sentAt;
            outcome.parts = partsOf(std::move(attempt->arrivals));
            return outcome;
        }
        refused = attempt->refused;
        foreignId = attempt->foreignId;
        outcome.faults.push_back({*attempt->fault, attempt->endedAt});
        const bool first = outcome.attempts == 1 && attempts > 1 && transaction.patience <= 0us;
        if (first && *attempt->fault == FaultKind::TimeOut) {
            if (const auto heard = awaitFirstReply(attempt->sentAt, interrupt); !heard)
                return tl::unexpected(described(heard.error(), request, outcome.attempts));
        }
    }
    Error error{errorFor(outcome.faults)};
    if (foreignId && error.code == ErrorCode::NoAnswer)
        error.detail = QStringLiteral("from %1").arg(*foreignId);
    if (request.repeat == Repeat::Never && !refused) {
        error.detail = base::errorName(error.code);
        error.code = ErrorCode::Uncertain;
    }
    return tl::unexpected(described(std::move(error), request, refused ? 0 : outcome.attempts));
}

/// On a link that has shown nothing yet silence says nothing either: its adapter may be slower than
/// the patience it is given at first. A late reply ends the wait, and teaches.
Result<void> BusCore::awaitFirstReply(Duration sentAt, const Interrupt& interrupt)
{
    const Duration limit = sentAt + LateGuard::longestLateness;
    while (!m_guard.hasMeasured() && m_clock.now() < limit) {
        const Duration until = std::min(limit, m_clock.now() + waitSlice);
        if (const auto heard = m_exchange.listenUntil(until, interrupt); !heard)
            return heard;
    }
    return {};
}

/// Listens until the servos may be spoken to; polls of others run meanwhile.
Result<void> BusCore::awaitTurn(const Transaction& transaction, const Interrupt& interrupt)
{
    for (;;) {
        if (const auto reason = interrupt.due())
            return base::fail(*reason);
        const Duration now = m_clock.now();
        const Duration quiet = m_guard.quietUntil(transaction.request);
        if (now >= quiet)
            return {};
        if (transaction.priority != Priority::Emergency && runPoll())
            continue;
        const Duration next = nextPoll().value_or(quiet);
        const Duration until = std::clamp(next, now + 1ms, std::max(quiet, now + 1ms));
        if (const auto heard = m_exchange.listenUntil(std::min(until, quiet), interrupt); !heard)
            return heard;
    }
}

Error BusCore::described(Error error, const protocol::Request& request, int attempts) const
{
    error.operation = operationName(request.op);
    error.id = request.id <= protocol::maxId ? request.id : -1;
    error.attempts = attempts;
    if (error.detail.isEmpty() && error.code == ErrorCode::LinkLost)
        error.detail = m_line.name();
    return error;
}

Result<void> BusCore::listen(Duration span)
{
    serveEmergency();
    auto heard = m_exchange.listenUntil(m_clock.now() + span, interruptBy(nullptr));
    if (!heard && heard.error().code == ErrorCode::Preempted)
        serveEmergency();
    return heard;
}

Result<void> BusCore::setBaud(int baud)
{
    const Interrupt interrupt = interruptBy(nullptr);
    auto quiet = m_exchange.awaitSilence(interrupt);
    while (!quiet && quiet.error().code == ErrorCode::Preempted) {
        serveEmergency();
        quiet = m_exchange.awaitSilence(interrupt);
    }
    if (!quiet)
        return quiet;
    return m_line.setBaud(baud);
}

bool BusCore::pauseUntil(Duration instant, const base::Stop* stop)
{
    for (;;) {
        if (interruptBy(stop).due() == ErrorCode::Stopped)
            return false;
        serveEmergency();
        const Duration now = m_clock.now();
        if (now >= instant)
            return true;
        if (runPoll())
            continue;
        if (m_line.away()) {
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
        serveEmergency();
}

bool BusCore::serveEmergency()
{
    if (!m_emergency.load(std::memory_order_acquire))
        return false;
    // Nothing to say it on: until the link is back it is owed, and nothing else is said before it.
    if (m_line.away())
        static_cast<void>(m_exchange.listenUntil(m_clock.now() + waitSlice, {}));
    if (m_line.away() || !m_emergency.exchange(false, std::memory_order_acq_rel))
        return false;
    std::vector<StopFrame> frames;
    {
        const std::lock_guard lock(m_stopFramesMutex);
        frames = m_stopFrames;
    }
    m_trace.note(m_clock.now(), QStringLiteral("emergency"));
    // A lost link shows in the next transaction.
    static_cast<void>(m_exchange.sendStopFrames(frames, replyDelay()));
    if (m_line.away()) // the link has died under it
        m_emergency.store(true, std::memory_order_release);
    return true;
}

Statistics BusCore::statistics() const
{
    Statistics statistics = m_statistics.snapshot(m_clock.now());
    statistics.patience = m_guard.patience();
    statistics.samplesLost = m_samples.lost();
    return statistics;
}

void BusCore::lookAtLink()
{
    static_cast<void>(m_exchange.listenUntil(Duration{}, {}));
}
} // namespace bus

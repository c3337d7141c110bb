// SPDX-License-Identifier: GPL-3.0-or-later
// The polling half of BusCore.
#include "bus/bus_core.h"

namespace bus {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr Duration maxPollDelay = 20ms;
/// A held servo is looked at again after this time.
constexpr Duration heldPollDelay = 5ms;
} // namespace

PollId BusCore::startPoll(const PollPlan& plan)
{
    const PollId id = reservePoll();
    beginPoll(id, plan);
    return id;
}

void BusCore::beginPoll(PollId id, const PollPlan& plan)
{
    m_polls.start(id, plan, m_clock.now());
}

void BusCore::stopPoll(PollId id)
{
    m_polls.stop(id);
    m_samples.close(id);
}

/// Feedback must not stop while transactions keep the wire busy.
void BusCore::runOverduePoll(Priority priority)
{
    if (priority != Priority::Emergency && m_clock.now() >= m_lastPoll + maxPollDelay)
        runPoll();
}

bool BusCore::runPoll()
{
    if (m_line.lost())
        return false;
    const Duration now = m_clock.now();
    const auto read = m_polls.next(now, [&](int id) {
        return m_holds.isHeld(id) ? now + heldPollDelay : m_lateReplyGuard.quietUntil(id);
    });
    if (!read)
        return false;
    const auto request =
        (read->ids.size() == 1
             ? protocol::Request::read(read->ids.front(), read->block.address, read->block.count)
             : protocol::Request::syncRead(read->block.address, read->block.count, read->ids))
            .in(read->protocol);
    const auto frame = protocol::codecFor(request.protocol).encode(request);
    if (!frame) {
        Attempt refused;
        refused.missing = read->ids;
        refused.endedAt = now;
        storeSamples(*read, std::move(refused), frame.error().code);
        return true;
    }
    auto attempt = m_exchange.run(request, *frame, {}, replyDelay(), interruptBy(nullptr));
    m_lastPoll = m_clock.now();
    if (!attempt)
        return attempt.error().code != base::ErrorCode::LinkLost;
    const auto error = attempt->fault ? errorFor(*attempt->fault) : base::ErrorCode::NoReply;
    storeSamples(*read, std::move(*attempt), error);
    return true;
}

namespace {
/// No adapter is as late as that: it was this program that stood still (suspended, a busy machine).
/// The servo has answered long ago.
Duration sampleTime(const ReceivedReply& arrival, const Attempt& attempt)
{
    const bool arrivedTooLate = arrival.at > attempt.expectedAt + LateReplyGuard::maxLateness;
    return arrivedTooLate ? attempt.expectedAt : arrival.at;
}
} // namespace

void BusCore::storeSamples(const PollRead& read, Attempt attempt, base::ErrorCode error)
{
    m_polls.finished(read, attempt.missing, attempt.endedAt);
    for (ReceivedReply& arrival : attempt.receivedReplies) {
        protocol::Reply& part = arrival.part;
        const Duration at = sampleTime(arrival, attempt);
        const bool answered = part.exception == 0;
        m_samples.add(read.plan,
                      {part.id, read.block.address, std::move(part.data), part.status, at, answered,
                       answered ? error : base::ErrorCode::Refused, read.protocol, read.endsRound});
    }
    for (const int id : attempt.missing)
        m_samples.add(read.plan, {id,
                                  read.block.address,
                                  {},
                                  0,
                                  attempt.endedAt,
                                  false,
                                  error,
                                  read.protocol,
                                  read.endsRound});
}
} // namespace bus

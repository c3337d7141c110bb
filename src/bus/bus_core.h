// SPDX-License-Identifier: GPL-3.0-or-later
// The bus on the caller's thread: runs a transaction, and the polls that are due, while the caller
// waits. For tests, fast simulation on a manual clock, and as the engine of BusThread. One thread,
// except what fetches or sets plain values: emergency(), take…(), statistics(), setRetries(),
// setTimeout(), maxReplyLateness(), setReplyDelay(), setStopFrames(), setReconnectTimeout(),
// lost(), away() may be called from any.
#pragma once

#include "bus/exchange.h"
#include "bus/hold_table.h"
#include "bus/poll_buffer.h"
#include "bus/poll_runner.h"

#include <atomic>
#include <mutex>
#include <thread>

namespace bus {
struct CoreOptions {
    int bitsPerByte = 10;                      ///< 11 with parity
    const base::StopToken* shutdown = nullptr; ///< ends every wait with Stopped
    Reopener reopen{};                         ///< opens the same port again; none: lost is lost
};

class BusCore final : public Bus {
public:
    /// Takes the open link and finds out whether it echoes, by a request of `codec`:
    /// about 0.3 s if it does not, since adapters are up to a quarter of a second late. Requests
    /// name their own protocol.
    BusCore(std::unique_ptr<transport::Link> link, const protocol::Codec& codec, base::Clock& clock,
            CoreOptions options = {});

    base::Result<Outcome> transact(const Transaction& transaction) override;
    base::Result<void> listen(base::Duration span) override;
    std::vector<UnexpectedFrame> takeUnexpectedFrames() override
    {
        return m_unexpectedFrames.take();
    }

    base::Result<void> setBaud(int baud) override;
    int baud() const override { return m_line.baud(); }
    bool canSetBaud() const override { return m_line.canSetBaud(); }
    QString portName() const override { return m_line.name(); }
    bool hasEcho() const override { return m_line.hasEcho(); }
    bool isReconnecting() const override { return m_line.isReconnecting(); }
    void setReconnectTimeout(base::Duration span) override { m_line.setReconnectTimeout(span); }

    bool pauseUntil(base::Duration instant, const base::StopToken* stop) override;
    Hold hold(const std::vector<int>& ids, std::optional<std::uint64_t> epoch = {}) override;

    PollId startPoll(const PollPlan& plan) override;
    void stopPoll(PollId id) override;
    std::vector<Sample> takeSamples(PollId id) override { return m_samples.take(id); }

    void setStopFrames(std::vector<StopFrame> frames) override;
    void emergency() override;
    std::uint64_t emergencyCount() const override { return m_holds.emergencyCount(); }

    void setRetries(int retries) override { m_retries.store(retries); }
    void setTimeout(base::Duration timeout) override { m_lateReplyGuard.setTimeout(timeout); }
    base::Duration maxReplyLateness() const override { return m_lateReplyGuard.maxReplyLateness(); }
    void setReplyDelay(base::Duration delay) override { m_replyDelay.store(delay.count()); }

    void setSilence(base::Duration silence) override { m_exchange.setSilence(silence); }

    Statistics statistics() const override;
    std::uint64_t unsolicitedNoise() const override { return m_statistics.unsolicitedNoise(); }
    std::vector<TraceEntry> takeTrace() override { return m_trace.take(); }
    base::Clock& clock() const override { return m_clock; }

    // For BusThread, which queues, checks holds and waits by itself.

    /// As transact, after the holds were asked. Access::Wait ends with Held.
    base::Result<Outcome> execute(const Transaction& transaction, HoldTable::Access access);
    HoldTable& holds() { return m_holds; }
    PollId reservePoll() { return m_samples.open(); }
    void beginPoll(PollId id, const PollPlan& plan);
    std::optional<base::Duration> nextPoll() const { return m_polls.nextDue(); }
    /// Runs one read that is due; false if there is none.
    bool runPoll();
    void requestEmergency(); ///< served by the bus' thread
    bool handleEmergency();  ///< true if there was one
    void checkLink();        ///< notices unplugging; received frames count as unexpected
    bool lost() const override { return m_line.lost(); }
    void closeLink() { m_line.close(); }

protected:
    void release(std::uint64_t token) override { m_holds.release(token); }

private:
    Interrupt interruptBy(const base::StopToken* stop) const;
    base::Duration replyDelay() const { return base::Duration(m_replyDelay.load()); }
    base::Result<Outcome> run(const Transaction& transaction);
    base::Result<void> waitForTurn(const Transaction& transaction, const Interrupt& interrupt);
    base::Result<Outcome> transactWithRetries(const Transaction& transaction, base::ByteView frame);
    base::Result<bool> awaitLateReply(base::Duration limit, const Interrupt& interrupt);
    void runOverduePoll(Priority priority);
    void storeSamples(const PollRead& read, Attempt attempt, base::ErrorCode error);
    base::Error withContext(base::Error error, const protocol::Request& request,
                            int attempts) const;

    base::Clock& m_clock;
    CoreOptions m_options;
    std::thread::id m_thread;
    std::atomic<bool> m_emergency{false};
    std::atomic<int> m_retries{2};
    std::atomic<base::Duration::rep> m_replyDelay{508};
    StatisticsCollector m_statistics;
    TraceRing m_trace;
    UnexpectedFrameList m_unexpectedFrames;
    PollBuffer m_samples;
    HoldTable m_holds;
    LateReplyGuard m_lateReplyGuard;
    Line m_line;
    Exchange m_exchange;
    PollRunner m_polls;
    base::Duration m_lastPoll{};
    std::mutex m_stopFramesMutex;
    std::vector<StopFrame> m_stopFrames;
};
} // namespace bus

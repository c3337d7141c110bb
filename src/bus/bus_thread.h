// SPDX-License-Identifier: GPL-3.0-or-later
// The bus on a thread of its own: opens the port there, keeps the queue (emergency > interactive >
// job, polls in between) and notices unplugging. All calls from any thread but the bus' own, except
// emergency(). A blocking call blocks its caller only. Needs a clock that runs by itself.
#pragma once

#include "bus/bus_core.h"

#include <QThread>

#include <condition_variable>
#include <deque>

namespace bus {
class BusThread final : public Bus {
public:
    using Opener = std::function<base::Result<std::unique_ptr<transport::Link>>()>;
    using Done = std::function<void(base::Result<Outcome>)>;

    /// Blocks until the port is open (about 0.3 s more to find out about echo) or failed to. The
    /// opener is kept, for setReconnectTimeout().
    static base::Result<std::unique_ptr<BusThread>>
    open(Opener opener, const protocol::Codec& codec, base::Clock& clock, int bitsPerByte = 10);

    /// Ends the thread; callers that still wait get Stopped.
    ~BusThread() override;

    /// Does not block; `done` is called once, on the bus thread, and must be quick. A transaction
    /// still waiting when the bus ends is done with Stopped.
    void submit(Transaction transaction, Done done);
    bool lost() const override { return m_core->lost(); }
    bool isReconnecting() const override { return m_core->isReconnecting(); }
    void setReconnectTimeout(base::Duration span) override { m_core->setReconnectTimeout(span); }

    base::Result<Outcome> transact(const Transaction& transaction) override;
    base::Result<void> listen(base::Duration span) override;
    std::vector<UnexpectedFrame> takeUnexpectedFrames() override
    {
        return m_core->takeUnexpectedFrames();
    }

    base::Result<void> setBaud(int baud) override;
    int baud() const override { return m_core->baud(); }
    bool canSetBaud() const override { return m_core->canSetBaud(); }
    QString portName() const override { return m_core->portName(); }
    bool hasEcho() const override { return m_core->hasEcho(); }

    bool pauseUntil(base::Duration instant, const base::StopToken* stop) override;
    Hold hold(const std::vector<int>& ids, std::optional<std::uint64_t> epoch = {}) override;

    PollId startPoll(const PollPlan& plan) override;
    void stopPoll(PollId id) override;
    std::vector<Sample> takeSamples(PollId id) override { return m_core->takeSamples(id); }

    void setStopFrames(std::vector<StopFrame> frames) override;
    void emergency() override;
    std::uint64_t emergencyCount() const override { return m_core->emergencyCount(); }

    void setRetries(int retries) override { m_core->setRetries(retries); }
    void setTimeout(base::Duration timeout) override { m_core->setTimeout(timeout); }
    base::Duration maxReplyLateness() const override { return m_core->maxReplyLateness(); }
    void setReplyDelay(base::Duration delay) override { m_core->setReplyDelay(delay); }
    void setSilence(base::Duration silence) override { m_core->setSilence(silence); }

    Statistics statistics() const override { return m_core->statistics(); }
    std::uint64_t unsolicitedNoise() const override { return m_core->unsolicitedNoise(); }
    std::vector<TraceEntry> takeTrace() override { return m_core->takeTrace(); }
    base::Clock& clock() const override { return m_clock; }

protected:
    void release(std::uint64_t token) override;

private:
    using Command = std::function<void(BusCore&)>;
    struct Pending;
    struct CallGuard; ///< a caller inside the object

    BusThread(const protocol::Codec& codec, base::Clock& clock, int bitsPerByte);
    base::Result<void> start(Opener opener);
    void run(const Opener& opener, base::Event& opened);
    void serve();
    void finishAll();
    bool runNext();
    void idle();
    void post(Command command);
    HoldTable::Access accessOf(const Pending& pending);
    void finish(Pending& pending, base::Result<Outcome> result);
    void enqueue(std::shared_ptr<Pending> pending);
    base::Result<Outcome> await(const std::shared_ptr<Pending>& pending);
    base::Result<void> onBusThread(std::function<base::Result<void>(BusCore&)> work);

    const protocol::Codec& m_codec;
    base::Clock& m_clock;
    int m_bitsPerByte;
    base::StopToken m_shutdown;
    std::unique_ptr<BusCore> m_core; ///< made on the bus thread, never replaced
    std::unique_ptr<QThread> m_thread;
    std::unique_ptr<base::Event> m_work; ///< there may be something to do

    std::mutex m_mutex;                           ///< guards what follows
    std::condition_variable m_changed;            ///< a hold released, ended, a caller left
    std::deque<std::shared_ptr<Pending>> m_queue; ///< oldest first
    std::deque<Command> m_commands;
    std::optional<base::Result<void>> m_opened;
    bool m_ended = false;
    int m_activeCalls = 0;
    base::Duration m_lastLinkCheck{}; ///< bus thread only
};
} // namespace bus

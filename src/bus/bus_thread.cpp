// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_thread.h"

#include <algorithm>

namespace bus {
using base::Duration;
using base::ErrorCode;
using base::Result;
using namespace std::chrono_literals;

namespace {
/// Unplugging is noticed within this time although nothing is said on the wire.
constexpr Duration linkCheckInterval = 200ms;
/// A caller whose turn has not come yet looks at its stop this often.
constexpr auto stopInterval = 20ms;
} // namespace

/// A transaction, or other work for the bus thread, on its way through the queue.
struct BusThread::Pending {
    explicit Pending(base::Clock& clock)
        : finished(clock.makeEvent())
    {}

    Transaction transaction;
    std::function<Result<void>(BusCore&)> work; ///< instead of the transaction
    Done done;                                  ///< instead of a caller that waits
    std::thread::id caller;
    bool preempted = false; ///< an emergency came while it waited
    std::unique_ptr<base::Event> finished;
    std::optional<Result<Outcome>> result;
};

/// Keeps the object alive until the callers inside have left it. Constructed and destroyed with the
/// mutex held.
struct BusThread::CallGuard {
    explicit CallGuard(BusThread& thread)
        : bus(thread)
    {
        ++bus.m_activeCalls;
    }
    ~CallGuard()
    {
        if (--bus.m_activeCalls == 0)
            bus.m_changed.notify_all();
    }
    BusThread& bus;
};

BusThread::BusThread(const protocol::Codec& codec, base::Clock& clock, int bitsPerByte)
    : m_codec(codec)
    , m_clock(clock)
    , m_bitsPerByte(bitsPerByte)
    , m_work(clock.makeEvent())
{}

Result<std::unique_ptr<BusThread>> BusThread::open(Opener opener, const protocol::Codec& codec,
                                                   base::Clock& clock, int bitsPerByte)
{
    std::unique_ptr<BusThread> bus(new BusThread(codec, clock, bitsPerByte));
    if (const auto started = bus->start(std::move(opener)); !started)
        return tl::unexpected(started.error());
    return bus;
}

Result<void> BusThread::start(Opener opener)
{
    const std::shared_ptr<base::Event> opened = m_clock.makeEvent();
    m_thread.reset(
        QThread::create([this, opened, opener = std::move(opener)] { run(opener, *opened); }));
    m_thread->setObjectName(QStringLiteral("bus"));
    m_thread->start();
    opened->waitUntil(Duration::max());
    const std::lock_guard lock(m_mutex);
    return *m_opened;
}

BusThread::~BusThread()
{
    m_shutdown.request();
    m_work->set();
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return m_ended && m_activeCalls == 0; });
    }
    m_thread->wait();
}

void BusThread::run(const Opener& opener, base::Event& opened)
{
    const base::ClockThread clockThread(m_clock);
    auto link = opener();
    if (link)
        m_core = std::make_unique<BusCore>(std::move(*link), m_codec, m_clock,
                                           CoreOptions{m_bitsPerByte, &m_shutdown, opener});
    {
        const std::lock_guard lock(m_mutex);
        m_opened = link ? Result<void>{} : tl::unexpected(link.error());
    }
    opened.set();
    if (m_core)
        serve();
    finishAll();
}

void BusThread::serve()
{
    while (!m_shutdown.isRequested()) {
        m_core->handleEmergency();
        if (!runNext() && !m_core->runPoll())
            idle();
    }
    m_core->closeLink();
}

void BusThread::finishAll()
{
    for (;;) {
        std::shared_ptr<Pending> pending;
        {
            const std::lock_guard lock(m_mutex);
            if (m_queue.empty()) {
                m_ended = true;
                m_changed.notify_all();
                return;
            }
            pending = m_queue.front();
            m_queue.pop_front();
        }
        finish(*pending, base::fail(ErrorCode::Stopped));
    }
}

/// Runs the request of the highest priority that no hold keeps back; false if there is none.
bool BusThread::runNext()
{
    std::shared_ptr<Pending> next;
    auto access = HoldTable::Access::Pass;
    {
        std::unique_lock lock(m_mutex);
        if (!m_commands.empty()) {
            const Command command = std::move(m_commands.front());
            m_commands.pop_front();
            lock.unlock();
            command(*m_core);
            return true;
        }
        const auto entry = std::find_if(m_queue.begin(), m_queue.end(), [&](const auto& pending) {
            access = accessOf(*pending);
            return access != HoldTable::Access::Wait;
        });
        if (entry == m_queue.end())
            return false;
        next = *entry;
        m_queue.erase(entry);
    }
    finish(*next, next->work ? next->work(*m_core).map([] { return Outcome{}; })
                             : m_core->execute(next->transaction, access));
    return true;
}

HoldTable::Access BusThread::accessOf(const Pending& pending)
{
    const Transaction& transaction = pending.transaction;
    if (pending.work)
        return HoldTable::Access::Pass;
    if (pending.preempted) {
        m_core->holds().clearPreemption(transaction.hold);
        return HoldTable::Access::Preempted;
    }
    return m_core->holds().access(transaction.request, transaction.hold, pending.caller,
                                  transaction.epoch);
}

void BusThread::finish(Pending& pending, Result<Outcome> result)
{
    if (pending.done) {
        pending.done(std::move(result));
        return;
    }
    {
        const std::lock_guard lock(m_mutex);
        pending.result = std::move(result);
    }
    pending.finished->set();
}

void BusThread::idle()
{
    const Duration now = m_clock.now();
    if (now >= m_lastLinkCheck + linkCheckInterval) {
        m_lastLinkCheck = now;
        m_core->checkLink();
    }
    Duration until = m_lastLinkCheck + linkCheckInterval;
    if (!lost())
        until = std::min(until, m_core->nextPoll().value_or(until));
    m_work->waitUntil(until);
}

void BusThread::post(Command command)
{
    {
        const std::lock_guard lock(m_mutex);
        m_commands.push_back(std::move(command));
    }
    m_work->set();
}

/// With the mutex held. Equal priorities keep their order.
void BusThread::enqueue(std::shared_ptr<Pending> pending)
{
    const auto entry =
        std::upper_bound(m_queue.begin(), m_queue.end(), pending, [](const auto& a, const auto& b) {
            return a->transaction.priority < b->transaction.priority;
        });
    m_queue.insert(entry, std::move(pending));
    m_work->set();
}

Result<Outcome> BusThread::await(const std::shared_ptr<Pending>& pending)
{
    const base::StopToken* const stop = pending->transaction.stop;
    std::unique_lock lock(m_mutex);
    const CallGuard callGuard(*this);
    if (m_ended)
        return base::fail(ErrorCode::Stopped);
    enqueue(pending);
    for (;;) {
        lock.unlock();
        const bool finished = pending->finished->waitUntil(
            stop == nullptr ? Duration::max() : m_clock.now() + stopInterval);
        lock.lock();
        if (finished)
            return std::move(*pending->result);
        const auto entry = std::find(m_queue.begin(), m_queue.end(), pending);
        if (stop->isRequested() && entry != m_queue.end()) {
            m_queue.erase(entry);
            return base::fail(ErrorCode::Stopped);
        }
    }
}

Result<Outcome> BusThread::transact(const Transaction& transaction)
{
    const auto pending = std::make_shared<Pending>(m_clock);
    pending->transaction = transaction;
    pending->caller = std::this_thread::get_id();
    return await(pending);
}

void BusThread::submit(Transaction transaction, Done done)
{
    const auto pending = std::make_shared<Pending>(m_clock);
    pending->transaction = std::move(transaction);
    pending->done = std::move(done);
    pending->caller = std::this_thread::get_id();
    {
        const std::lock_guard lock(m_mutex);
        if (!m_ended) {
            enqueue(pending);
            return;
        }
    }
    pending->done(base::fail(ErrorCode::Stopped));
}

Result<void> BusThread::onBusThread(std::function<Result<void>(BusCore&)> work)
{
    const auto pending = std::make_shared<Pending>(m_clock);
    pending->work = std::move(work);
    return await(pending).map([](const Outcome&) {});
}

Result<void> BusThread::listen(Duration span)
{
    return onBusThread([span](BusCore& core) { return core.listen(span); });
}

Result<void> BusThread::setBaud(int baud)
{
    return onBusThread([baud](BusCore& core) { return core.setBaud(baud); });
}

bool BusThread::pauseUntil(Duration instant, const base::StopToken* stop)
{
    return m_clock.sleepUntil(instant, stop);
}

Hold BusThread::hold(const std::vector<int>& ids, std::optional<std::uint64_t> epoch)
{
    std::uint64_t token = 0;
    std::unique_lock lock(m_mutex);
    const CallGuard callGuard(*this);
    m_changed.wait(lock, [&] {
        if (!m_shutdown.isRequested())
            token = m_core->holds().take(ids, std::this_thread::get_id(), epoch);
        return token != 0 || m_shutdown.isRequested();
    });
    return {this, token};
}

void BusThread::release(std::uint64_t token)
{
    m_core->holds().release(token);
    m_work->set();
    const std::lock_guard lock(m_mutex);
    m_changed.notify_all();
}

PollId BusThread::startPoll(const PollPlan& plan)
{
    const PollId id = m_core->reservePoll();
    post([id, plan](BusCore& core) { core.beginPoll(id, plan); });
    return id;
}

void BusThread::stopPoll(PollId id)
{
    post([id](BusCore& core) { core.stopPoll(id); });
}

void BusThread::setStopFrames(std::vector<StopFrame> frames)
{
    m_core->setStopFrames(std::move(frames));
}

void BusThread::emergency()
{
    m_core->requestEmergency();
    const std::lock_guard lock(m_mutex);
    for (const auto& pending : m_queue)
        pending->preempted = pending->transaction.priority != Priority::Emergency;
    m_work->set();
}
} // namespace bus

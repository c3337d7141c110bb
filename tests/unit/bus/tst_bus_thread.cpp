// SPDX-License-Identifier: GPL-3.0-or-later
// The bus on its own thread, with callers on others, on the system clock.
#include "bus/bus_thread.h"
#include "protocol/codec.h"

#include <QRegularExpression>
#include <QTest>

#include <future>

using namespace bus;
using base::Bytes;
using base::Duration;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
/// What the test and the link on the bus thread share.
struct World {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<Bytes> sent;
    std::vector<int> present{1, 2, 3};
    bool cut = false;
    bool withhold = false; ///< replies stay where they are until released
    Bytes withheld;
    Bytes toHost;
    std::atomic<bool> linkAlive{false};

    /// Waits until the link has written so many frames.
    void awaitSent(std::size_t count)
    {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return sent.size() >= count; });
    }
    void awaitFrame(const Bytes& frame)
    {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return std::count(sent.begin(), sent.end(), frame) > 0; });
    }
    std::vector<Bytes> takeSent()
    {
        const std::lock_guard lock(mutex);
        return std::exchange(sent, {});
    }
    void holdReplies()
    {
        const std::lock_guard lock(mutex);
        withhold = true;
    }
    void releaseReplies()
    {
        const std::lock_guard lock(mutex);
        withhold = false;
        toHost.insert(toHost.end(), withheld.begin(), withheld.end());
        withheld.clear();
        changed.notify_all();
    }
    void mend()
    {
        const std::lock_guard lock(mutex);
        cut = false;
    }
    void cutLink()
    {
        const std::lock_guard lock(mutex);
        cut = true;
        changed.notify_all();
    }
};

/// Replies at once, with a table in which each byte is its address.
class PromptLink final : public transport::Link {
public:
    explicit PromptLink(std::shared_ptr<World> world)
        : m_world(std::move(world))
    {
        m_world->linkAlive = true;
    }
    ~PromptLink() override { m_world->linkAlive = false; }

    base::Result<void> write(base::ByteView bytes) override
    {
        const std::lock_guard lock(m_world->mutex);
        if (m_world->cut)
            return base::fail(ErrorCode::LinkLost);
        const Bytes frame(bytes.begin(), bytes.end());
        m_world->sent.push_back(frame);
        const auto& present = m_world->present;
        if (std::count(present.begin(), present.end(), frame[2]) > 0) {
            Bytes data;
            for (int i = 0; frame[4] == 2 && i < frame[6]; ++i)
                data.push_back(std::uint8_t(frame[5] + i));
            const Bytes reply = protocol::encodeFeetechStatus(frame[2], 0, data);
            Bytes& into = m_world->withhold ? m_world->withheld : m_world->toHost;
            into.insert(into.end(), reply.begin(), reply.end());
        }
        m_world->changed.notify_all();
        return {};
    }
    base::Result<std::size_t> read(Bytes& buffer) override
    {
        const std::lock_guard lock(m_world->mutex);
        const std::size_t count = m_world->toHost.size();
        buffer.insert(buffer.end(), m_world->toHost.begin(), m_world->toHost.end());
        m_world->toHost.clear();
        return count;
    }
    base::Result<bool> waitReadable(Duration span) override
    {
        std::unique_lock lock(m_world->mutex);
        m_world->changed.wait_for(lock, span,
                                  [&] { return m_world->cut || !m_world->toHost.empty(); });
        if (m_world->cut)
            return base::fail(ErrorCode::LinkLost);
        return !m_world->toHost.empty();
    }
    base::Result<void> setBaud(int baud) override
    {
        m_baud = baud;
        return {};
    }
    int baud() const override { return m_baud; }
    QString name() const override { return QStringLiteral("prompt"); }

private:
    std::shared_ptr<World> m_world;
    int m_baud = 1'000'000;
};

struct Bench {
    std::shared_ptr<World> world = std::make_shared<World>();
    base::SystemClock clock;
    std::unique_ptr<BusThread> bus;

    Bench()
    {
        bus =
            BusThread::open([this] { return openLink(); }, protocol::feetechCodec(), clock).value();
        world->takeSent();
    }
    base::Result<std::unique_ptr<transport::Link>> openLink()
    {
        return std::make_unique<PromptLink>(world);
    }
    static Transaction made(Request request, Priority priority = Priority::Job)
    {
        Transaction transaction;
        transaction.request = std::move(request);
        transaction.priority = priority;
        return transaction;
    }
    std::future<base::Result<Outcome>> start(Transaction transaction)
    {
        return std::async(std::launch::async,
                          [this, transaction] { return bus->transact(transaction); });
    }
    /// A transaction that keeps the bus busy until its reply is released or something ends it.
    std::future<base::Result<Outcome>> occupy()
    {
        world->holdReplies();
        Transaction transaction = made(Request::ping(1));
        transaction.patience = 60s;
        auto future = start(transaction);
        world->awaitSent(1);
        return future;
    }
};

Bytes ping(int id)
{
    return protocol::feetechCodec().encode(Request::ping(id)).value();
}
} // namespace

class TestBusThread : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void answersCallersFromManyThreads()
    {
        Bench bench;
        std::vector<std::future<int>> workers;
        for (int id = 1; id <= 3; ++id) {
            workers.push_back(std::async(std::launch::async, [&bench, id] {
                int right = 0;
                for (int i = 0; i < 200; ++i) {
                    const int address = 10 * id + i % 7;
                    const auto outcome =
                        bench.bus->transact(Bench::made(Request::read(id, address, 2)));
                    right += outcome && outcome->data().front() == address ? 1 : 0;
                }
                return right;
            }));
        }
        for (auto& worker : workers)
            QCOMPARE(worker.get(), 200);
        QCOMPARE(bench.bus->statistics().total.ok, std::uint64_t(600));
    }

    void failureToOpenIsReported()
    {
        base::SystemClock clock;
        const auto bus = BusThread::open(
            []() -> base::Result<std::unique_ptr<transport::Link>> {
                return base::fail(ErrorCode::PortBusy, QStringLiteral("open"));
            },
            protocol::feetechCodec(), clock);
        QVERIFY(!bus);
        QCOMPARE(bus.error().code, ErrorCode::PortBusy);
    }

    void urgentBeforeLessUrgent()
    {
        Bench bench;
        std::mutex mutex;
        std::vector<int> order;
        std::promise<void> all;
        bench.world->present = {1, 11, 12, 13, 14};
        auto busy = bench.occupy();
        const auto submit = [&](int id, Priority priority) {
            bench.bus->submit(Bench::made(Request::ping(id), priority), [&, id](const auto&) {
                const std::lock_guard lock(mutex);
                order.push_back(id);
                if (order.size() == 4)
                    all.set_value();
            });
        };
        submit(11, Priority::Job);
        submit(12, Priority::Interactive);
        submit(13, Priority::Emergency);
        submit(14, Priority::Interactive);
        bench.world->releaseReplies();
        QVERIFY(busy.get());
        all.get_future().wait();
        QCOMPARE(order, (std::vector{13, 12, 14, 11}));
    }

    void stopFreesACallerWhoseTurnHasNotCome()
    {
        Bench bench;
        auto busy = bench.occupy();
        base::Stop stop;
        Transaction transaction = Bench::made(Request::ping(2));
        transaction.stop = &stop;
        auto waiting = bench.start(transaction);
        stop.request();
        QCOMPARE(waiting.get().error().code, ErrorCode::Stopped);
        bench.world->releaseReplies();
        QVERIFY(busy.get());
        const auto sent = bench.world->takeSent();
        QCOMPARE(std::count(sent.begin(), sent.end(), ping(2)), 0);
    }

    void stopEndsTheRunningTransaction()
    {
        Bench bench;
        base::Stop stop;
        Transaction transaction = Bench::made(Request::ping(99));
        transaction.patience = 60s;
        transaction.stop = &stop;
        auto running = bench.start(transaction);
        bench.world->awaitSent(1);
        stop.request();
        QCOMPARE(running.get().error().code, ErrorCode::Stopped);
    }

    void emergencyGoesAheadOfEverything()
    {
        Bench bench;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        bench.bus->setStopFrames({{base::Protocol::Feetech, off}});
        auto busy = bench.occupy();
        std::promise<base::Result<Outcome>> queued;
        bench.bus->submit(Bench::made(Request::write(2, 42, {0, 8}, Repeat::Safe)),
                          [&](base::Result<Outcome> outcome) { queued.set_value(outcome); });
        bench.bus->emergency();
        QCOMPARE(busy.get().error().code, ErrorCode::Preempted);
        QCOMPARE(queued.get_future().get().error().code, ErrorCode::Preempted);
        bench.world->awaitFrame(off);
        QCOMPARE(bench.world->takeSent(), (std::vector{ping(1), off}));
    }

    /// By the bus' own record: not at the deadline of what is running, which is a minute away.
    void noDeadlineKeepsAnEmergencyWaiting()
    {
        Bench bench;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        bench.bus->setStopFrames({{base::Protocol::Feetech, off}});
        bench.bus->takeTrace();
        auto busy = bench.occupy();
        const Duration called = bench.clock.now();
        bench.bus->emergency();
        QCOMPARE(busy.get().error().code, ErrorCode::Preempted);
        bench.world->awaitFrame(off);
        std::optional<Duration> sent;
        QTRY_VERIFY([&] {
            for (const TraceEntry& entry : bench.bus->takeTrace()) {
                if (entry.kind == TraceKind::Sent && entry.bytes == off)
                    sent = entry.at;
            }
            return sent.has_value();
        }());
        QVERIFY(*sent >= called && *sent - called < 30s);
    }

    /// Asked for before, and begun after: not even its first frame goes out.
    void whatWasAskedForBeforeAnEmergencyIsNotBegun()
    {
        Bench bench;
        const std::uint64_t before = bench.bus->emergencies();
        bench.bus->emergency();
        bench.world->takeSent();
        const Hold late = bench.bus->hold({1}, before);
        Transaction step = Bench::made(Request::write(1, 42, {0, 8}, Repeat::Safe));
        step.hold = late.token();
        QCOMPARE(bench.bus->transact(step).error().code, ErrorCode::Preempted);
        Transaction loose = Bench::made(Request::write(2, 42, {0, 8}, Repeat::Safe));
        loose.epoch = before;
        QCOMPARE(bench.bus->transact(loose).error().code, ErrorCode::Preempted);
        QVERIFY(bench.world->takeSent().empty());
        QVERIFY2(bench.bus->transact(step), "a lock can still be closed");
    }

    void emergencyWakesAnIdleBus()
    {
        Bench bench;
        const Bytes off = ping(254);
        bench.bus->setStopFrames({{base::Protocol::Feetech, off}});
        bench.bus->emergency();
        bench.world->awaitFrame(off);
    }

    void othersWaitForAHold()
    {
        Bench bench;
        Hold job = bench.bus->hold({1});
        auto waiting = bench.start(Bench::made(Request::ping(1)));
        QVERIFY2(bench.bus->transact(Bench::made(Request::ping(2))), "others are free");
        Transaction own = Bench::made(Request::read(1, 55, 1));
        QCOMPARE(bench.bus->transact(own).error().code, ErrorCode::Held);
        own.hold = job.token();
        QVERIFY(bench.bus->transact(own));
        const auto before = bench.world->takeSent();
        QCOMPARE(std::count(before.begin(), before.end(), ping(1)), 0);
        job = Hold();
        QVERIFY(waiting.get());
    }

    void aHoldWaitsForOtherHolders()
    {
        Bench bench;
        std::atomic<bool> released{false};
        Hold first = bench.bus->hold({1, 2});
        const Hold again = bench.bus->hold({2}); // the same thread may
        auto second = std::async(std::launch::async, [&] {
            const Hold hold = bench.bus->hold({1});
            return released.load() && hold.token() != 0;
        });
        QVERIFY(bench.bus->transact(Bench::made(Request::ping(3))));
        released = true;
        first = Hold();
        QVERIFY(second.get());
    }

    void pollsGoOnWhileAJobIsBusy()
    {
        Bench bench;
        PollPlan plan;
        plan.servos.push_back({3, {{56, 15}}, false, 0});
        const PollId id = bench.bus->startPoll(plan);
        base::Stop stop;
        std::atomic<int> done{0};
        auto job = std::async(std::launch::async, [&] {
            while (!stop.requested())
                done += bench.bus->transact(Bench::made(Request::read(1, 0, 5))) ? 1 : 0;
        });
        std::size_t polled = 0;
        while (polled < 20 || done < 20) {
            for (const Sample& sample : bench.bus->takeSamples(id)) {
                QVERIFY(sample.answered);
                QCOMPARE(sample.data.size(), std::size_t(15));
                polled += done > 0 ? 1 : 0;
            }
            bench.bus->pauseUntil(bench.clock.now() + 5ms, nullptr);
        }
        stop.request();
        job.wait();
        bench.bus->stopPoll(id);
    }

    void pollsRunWhenNobodyAsks()
    {
        Bench bench;
        PollPlan plan;
        plan.servos = {{1, {{56, 2}}, true, 0}, {2, {{56, 2}}, false, 0}};
        plan.period = 1ms;
        const PollId id = bench.bus->startPoll(plan);
        std::map<int, int> seen;
        while (seen[1] < 10 || seen[2] < 10) {
            for (const Sample& sample : bench.bus->takeSamples(id))
                ++seen[sample.id];
            bench.bus->pauseUntil(bench.clock.now() + 2ms, nullptr);
        }
        QVERIFY(qAbs(seen[1] - seen[2]) <= 2);
    }

    void unpluggingIsNoticedWhileIdle()
    {
        Bench bench;
        QVERIFY(!bench.bus->lost());
        bench.world->cutLink();
        QTRY_VERIFY(bench.bus->lost());
        QVERIFY2(!bench.world->linkAlive, "closed at once");
        QCOMPARE(bench.bus->transact(Bench::made(Request::ping(1))).error().code,
                 ErrorCode::LinkLost);
        QCOMPARE(bench.bus->setBaud(500'000).error().code, ErrorCode::LinkLost);
    }

    void unpluggingEndsTheRunningTransaction()
    {
        Bench bench;
        auto busy = bench.occupy();
        bench.world->cutLink();
        QCOMPARE(busy.get().error().code, ErrorCode::LinkLost);
    }

    void destructionFreesWhoeverWaits()
    {
        Bench bench;
        auto busy = bench.occupy();
        std::promise<base::Result<Outcome>> submitted;
        bench.bus->submit(Bench::made(Request::ping(3)),
                          [&](base::Result<Outcome> outcome) { submitted.set_value(outcome); });
        bench.bus.reset();
        QCOMPARE(busy.get().error().code, ErrorCode::Stopped);
        QCOMPARE(submitted.get_future().get().error().code, ErrorCode::Stopped);
        QVERIFY(!bench.world->linkAlive);
    }

    void rateAndListeningAreDoneOnTheBusThread()
    {
        Bench bench;
        QVERIFY(bench.bus->setBaud(500'000));
        QCOMPARE(bench.bus->baud(), 500'000);
        {
            const std::lock_guard lock(bench.world->mutex);
            bench.world->toHost = protocol::encodeFeetechStatus(42, 0, {});
        }
        QVERIFY(bench.bus->listen(1ms));
        const auto strays = bench.bus->takeStrays();
        QCOMPARE(strays.size(), std::size_t(1));
        QCOMPARE(strays.front().id, 42);
    }

    /// Callers, polls and a stop on other threads while the link goes and comes.
    void aLinkThatComesBackIsServedAgain()
    {
        Bench bench;
        PollServo servo;
        servo.id = 2;
        servo.spans = {{56, 2}};
        const PollId poll = bench.bus->startPoll({{servo}, 5ms});
        const LinkPatience patience(*bench.bus, 30s);
        bench.world->cutLink();
        QTRY_VERIFY(bench.bus->away());
        QVERIFY(!bench.bus->lost());
        const auto deaf = bench.bus->transact(Bench::made(Request::ping(1)));
        QVERIFY(!deaf);
        QCOMPARE(deaf.error().code, ErrorCode::NoAnswer);
        bench.world->mend();
        QTRY_VERIFY(!bench.bus->away());
        QVERIFY(bench.bus->transact(Bench::made(Request::ping(1))));
        bool heard = false;
        const auto look = [&] {
            for (const Sample& sample : bench.bus->takeSamples(poll))
                heard = sample.answered;
            return heard;
        };
        look();
        heard = false;
        QTRY_VERIFY(heard || look());
    }

    void aStopWhileTheLinkIsAwayIsTheFirstWord()
    {
        Bench bench;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        bench.bus->setStopFrames({{base::Protocol::Feetech, off}});
        const LinkPatience patience(*bench.bus, 30s);
        bench.world->cutLink();
        QTRY_VERIFY(bench.bus->away());
        bench.world->takeSent();
        bench.bus->emergency();
        const auto preempted = bench.bus->transact(Bench::made(Request::ping(1)));
        QVERIFY(!preempted);
        QCOMPARE(preempted.error().code, ErrorCode::Preempted);
        bench.world->mend();
        bench.world->awaitFrame(off);
        QCOMPARE(bench.world->takeSent().front(), off);
        QTRY_VERIFY(bench.bus->transact(Bench::made(Request::ping(1))).has_value());
    }

    void theBusEndsWhileTheLinkIsAway()
    {
        Bench bench;
        bench.bus->awaitReturn(60s);
        bench.world->cutLink();
        QTRY_VERIFY(bench.bus->away());
        bench.bus->emergency();
        bench.bus.reset(); // does not wait for the rest of the minute
        QVERIFY(!bench.world->linkAlive);
    }
};

QTEST_GUILESS_MAIN(TestBusThread)
#include "tst_bus_thread.moc"

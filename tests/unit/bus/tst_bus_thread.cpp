// SPDX-License-Identifier: GPL-3.0-or-later
// The bus on its own thread, with callers on others, on the system clock.
#include "bus/bus_thread.h"
#include "protocol/codec.h"
#include "support/test_main.h"

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
struct SharedState {
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
    void waitForSent(std::size_t count)
    {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return sent.size() >= count; });
    }
    void waitForFrame(const Bytes& frame)
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
    void restoreLink()
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
class ImmediateLink final : public transport::Link {
public:
    explicit ImmediateLink(std::shared_ptr<SharedState> shared)
        : m_shared(std::move(shared))
    {
        m_shared->linkAlive = true;
    }
    ~ImmediateLink() override { m_shared->linkAlive = false; }

    base::Result<void> write(base::ByteView bytes) override
    {
        const std::lock_guard lock(m_shared->mutex);
        if (m_shared->cut)
            return base::fail(ErrorCode::LinkLost);
        const Bytes frame(bytes.begin(), bytes.end());
        m_shared->sent.push_back(frame);
        const auto& present = m_shared->present;
        if (std::count(present.begin(), present.end(), frame[2]) > 0) {
            Bytes data;
            for (int i = 0; frame[4] == 2 && i < frame[6]; ++i)
                data.push_back(std::uint8_t(frame[5] + i));
            const Bytes reply = protocol::encodeFeetechStatus(frame[2], 0, data);
            Bytes& into = m_shared->withhold ? m_shared->withheld : m_shared->toHost;
            into.insert(into.end(), reply.begin(), reply.end());
        }
        m_shared->changed.notify_all();
        return {};
    }
    base::Result<std::size_t> read(Bytes& buffer) override
    {
        const std::lock_guard lock(m_shared->mutex);
        const std::size_t count = m_shared->toHost.size();
        buffer.insert(buffer.end(), m_shared->toHost.begin(), m_shared->toHost.end());
        m_shared->toHost.clear();
        return count;
    }
    base::Result<bool> waitForReadyRead(Duration span) override
    {
        std::unique_lock lock(m_shared->mutex);
        m_shared->changed.wait_for(lock, span,
                                   [&] { return m_shared->cut || !m_shared->toHost.empty(); });
        if (m_shared->cut)
            return base::fail(ErrorCode::LinkLost);
        return !m_shared->toHost.empty();
    }
    base::Result<void> setBaud(int baud) override
    {
        m_baud = baud;
        return {};
    }
    int baud() const override { return m_baud; }
    QString name() const override { return QStringLiteral("prompt"); }

private:
    std::shared_ptr<SharedState> m_shared;
    int m_baud = 1'000'000;
};

struct Fixture {
    std::shared_ptr<SharedState> shared = std::make_shared<SharedState>();
    base::SystemClock clock;
    std::unique_ptr<BusThread> bus;

    Fixture()
    {
        bus =
            BusThread::open([this] { return openLink(); }, protocol::feetechCodec(), clock).value();
        shared->takeSent();
    }
    base::Result<std::unique_ptr<transport::Link>> openLink()
    {
        return std::make_unique<ImmediateLink>(shared);
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
    std::future<base::Result<Outcome>> startActivity()
    {
        shared->holdReplies();
        Transaction transaction = made(Request::ping(1));
        transaction.timeout = 60s;
        auto future = start(transaction);
        shared->waitForSent(1);
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

    void servesCallersFromManyThreads()
    {
        Fixture fixture;
        std::vector<std::future<int>> workers;
        for (int id = 1; id <= 3; ++id) {
            workers.push_back(std::async(std::launch::async, [&fixture, id] {
                int right = 0;
                for (int i = 0; i < 200; ++i) {
                    const int address = 10 * id + i % 7;
                    const auto outcome =
                        fixture.bus->transact(Fixture::made(Request::read(id, address, 2)));
                    right += outcome && outcome->data().front() == address ? 1 : 0;
                }
                return right;
            }));
        }
        for (auto& worker : workers)
            QCOMPARE(worker.get(), 200);
        QCOMPARE(fixture.bus->statistics().total.ok, std::uint64_t(600));
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

    void higherPriorityFirst()
    {
        Fixture fixture;
        std::mutex mutex;
        std::vector<int> order;
        std::promise<void> all;
        fixture.shared->present = {1, 11, 12, 13, 14};
        auto busy = fixture.startActivity();
        const auto submit = [&](int id, Priority priority) {
            fixture.bus->submit(Fixture::made(Request::ping(id), priority), [&, id](const auto&) {
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
        fixture.shared->releaseReplies();
        QVERIFY(busy.get());
        all.get_future().wait();
        QCOMPARE(order, (std::vector{13, 12, 14, 11}));
    }

    void stopReleasesAQueuedCaller()
    {
        Fixture fixture;
        auto busy = fixture.startActivity();
        base::StopToken stop;
        Transaction transaction = Fixture::made(Request::ping(2));
        transaction.stop = &stop;
        auto waiting = fixture.start(transaction);
        stop.request();
        QCOMPARE(waiting.get().error().code, ErrorCode::Stopped);
        fixture.shared->releaseReplies();
        QVERIFY(busy.get());
        const auto sent = fixture.shared->takeSent();
        QCOMPARE(std::count(sent.begin(), sent.end(), ping(2)), 0);
    }

    void stopEndsTheRunningTransaction()
    {
        Fixture fixture;
        base::StopToken stop;
        Transaction transaction = Fixture::made(Request::ping(99));
        transaction.timeout = 60s;
        transaction.stop = &stop;
        auto running = fixture.start(transaction);
        fixture.shared->waitForSent(1);
        stop.request();
        QCOMPARE(running.get().error().code, ErrorCode::Stopped);
    }

    void emergencyGoesAheadOfEverything()
    {
        Fixture fixture;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        fixture.bus->setStopFrames({{base::Protocol::Feetech, off}});
        auto busy = fixture.startActivity();
        std::promise<base::Result<Outcome>> queued;
        fixture.bus->submit(Fixture::made(Request::write(2, 42, {0, 8}, Repeat::Safe)),
                            [&](base::Result<Outcome> outcome) { queued.set_value(outcome); });
        fixture.bus->emergency();
        QCOMPARE(busy.get().error().code, ErrorCode::Preempted);
        QCOMPARE(queued.get_future().get().error().code, ErrorCode::Preempted);
        fixture.shared->waitForFrame(off);
        QCOMPARE(fixture.shared->takeSent(), (std::vector{ping(1), off}));
    }

    /// By the bus' own record: not at the deadline of what is running, which is a minute away.
    void noDeadlineDelaysAnEmergency()
    {
        Fixture fixture;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        fixture.bus->setStopFrames({{base::Protocol::Feetech, off}});
        fixture.bus->takeTrace();
        auto busy = fixture.startActivity();
        const Duration callTime = fixture.clock.now();
        fixture.bus->emergency();
        QCOMPARE(busy.get().error().code, ErrorCode::Preempted);
        fixture.shared->waitForFrame(off);
        std::optional<Duration> sent;
        QTRY_VERIFY([&] {
            for (const TraceEntry& entry : fixture.bus->takeTrace()) {
                if (entry.kind == TraceKind::Sent && entry.bytes == off)
                    sent = entry.at;
            }
            return sent.has_value();
        }());
        QVERIFY(*sent >= callTime && *sent - callTime < 30s);
    }

    /// Asked for before, and begun after: not even its first frame goes out.
    void requestsBeforeAnEmergencyAreNotStarted()
    {
        Fixture fixture;
        const std::uint64_t before = fixture.bus->emergencyCount();
        fixture.bus->emergency();
        fixture.shared->takeSent();
        const Hold late = fixture.bus->hold({1}, before);
        Transaction step = Fixture::made(Request::write(1, 42, {0, 8}, Repeat::Safe));
        step.hold = late.token();
        QCOMPARE(fixture.bus->transact(step).error().code, ErrorCode::Preempted);
        Transaction loose = Fixture::made(Request::write(2, 42, {0, 8}, Repeat::Safe));
        loose.epoch = before;
        QCOMPARE(fixture.bus->transact(loose).error().code, ErrorCode::Preempted);
        QVERIFY(fixture.shared->takeSent().empty());
        QVERIFY2(fixture.bus->transact(step), "a lock can still be closed");
    }

    void emergencyWakesAnIdleBus()
    {
        Fixture fixture;
        const Bytes off = ping(254);
        fixture.bus->setStopFrames({{base::Protocol::Feetech, off}});
        fixture.bus->emergency();
        fixture.shared->waitForFrame(off);
    }

    void othersWaitForAHold()
    {
        Fixture fixture;
        Hold job = fixture.bus->hold({1});
        auto waiting = fixture.start(Fixture::made(Request::ping(1)));
        QVERIFY2(fixture.bus->transact(Fixture::made(Request::ping(2))), "others are free");
        Transaction own = Fixture::made(Request::read(1, 55, 1));
        QCOMPARE(fixture.bus->transact(own).error().code, ErrorCode::Held);
        own.hold = job.token();
        QVERIFY(fixture.bus->transact(own));
        const auto before = fixture.shared->takeSent();
        QCOMPARE(std::count(before.begin(), before.end(), ping(1)), 0);
        job = Hold();
        QVERIFY(waiting.get());
    }

    void aHoldWaitsForOtherHolders()
    {
        Fixture fixture;
        std::atomic<bool> released{false};
        Hold first = fixture.bus->hold({1, 2});
        const Hold again = fixture.bus->hold({2}); // the same thread may
        auto second = std::async(std::launch::async, [&] {
            const Hold hold = fixture.bus->hold({1});
            return released.load() && hold.token() != 0;
        });
        QVERIFY(fixture.bus->transact(Fixture::made(Request::ping(3))));
        released = true;
        first = Hold();
        QVERIFY(second.get());
    }

    void pollsContinueDuringAJob()
    {
        Fixture fixture;
        PollPlan plan;
        plan.servos.push_back({3, {{56, 15}}, false, 0});
        const PollId id = fixture.bus->startPoll(plan);
        base::StopToken stop;
        std::atomic<int> done{0};
        auto job = std::async(std::launch::async, [&] {
            while (!stop.isRequested())
                done += fixture.bus->transact(Fixture::made(Request::read(1, 0, 5))) ? 1 : 0;
        });
        std::size_t polled = 0;
        while (polled < 20 || done < 20) {
            for (const Sample& sample : fixture.bus->takeSamples(id)) {
                QVERIFY(sample.answered);
                QCOMPARE(sample.data.size(), std::size_t(15));
                polled += done > 0 ? 1 : 0;
            }
            fixture.bus->pauseUntil(fixture.clock.now() + 5ms, nullptr);
        }
        stop.request();
        job.wait();
        fixture.bus->stopPoll(id);
    }

    void pollsRunWhenIdle()
    {
        Fixture fixture;
        PollPlan plan;
        plan.servos = {{1, {{56, 2}}, true, 0}, {2, {{56, 2}}, false, 0}};
        plan.period = 1ms;
        const PollId id = fixture.bus->startPoll(plan);
        std::map<int, int> seen;
        while (seen[1] < 10 || seen[2] < 10) {
            for (const Sample& sample : fixture.bus->takeSamples(id))
                ++seen[sample.id];
            fixture.bus->pauseUntil(fixture.clock.now() + 2ms, nullptr);
        }
        QVERIFY(qAbs(seen[1] - seen[2]) <= 2);
    }

    void unpluggingIsNoticedWhileIdle()
    {
        Fixture fixture;
        QVERIFY(!fixture.bus->lost());
        fixture.shared->cutLink();
        QTRY_VERIFY(fixture.bus->lost());
        QVERIFY2(!fixture.shared->linkAlive, "closed at once");
        QCOMPARE(fixture.bus->transact(Fixture::made(Request::ping(1))).error().code,
                 ErrorCode::LinkLost);
        QCOMPARE(fixture.bus->setBaud(500'000).error().code, ErrorCode::LinkLost);
    }

    void unpluggingEndsTheRunningTransaction()
    {
        Fixture fixture;
        auto busy = fixture.startActivity();
        fixture.shared->cutLink();
        QCOMPARE(busy.get().error().code, ErrorCode::LinkLost);
    }

    void destructionReleasesWaitingCallers()
    {
        Fixture fixture;
        auto busy = fixture.startActivity();
        std::promise<base::Result<Outcome>> submitted;
        fixture.bus->submit(Fixture::made(Request::ping(3)),
                            [&](base::Result<Outcome> outcome) { submitted.set_value(outcome); });
        fixture.bus.reset();
        QCOMPARE(busy.get().error().code, ErrorCode::Stopped);
        QCOMPARE(submitted.get_future().get().error().code, ErrorCode::Stopped);
        QVERIFY(!fixture.shared->linkAlive);
    }

    void rateAndListeningAreDoneOnTheBusThread()
    {
        Fixture fixture;
        QVERIFY(fixture.bus->setBaud(500'000));
        QCOMPARE(fixture.bus->baud(), 500'000);
        {
            const std::lock_guard lock(fixture.shared->mutex);
            fixture.shared->toHost = protocol::encodeFeetechStatus(42, 0, {});
        }
        QVERIFY(fixture.bus->listen(1ms));
        const auto strays = fixture.bus->takeUnexpectedFrames();
        QCOMPARE(strays.size(), std::size_t(1));
        QCOMPARE(strays.front().id, 42);
    }

    /// Callers, polls and a stop on other threads while the link goes and comes.
    void aReturningLinkIsServedAgain()
    {
        Fixture fixture;
        PollServo servo;
        servo.id = 2;
        servo.spans = {{56, 2}};
        const PollId poll = fixture.bus->startPoll({{servo}, 5ms});
        const ReconnectScope reconnect(*fixture.bus, 30s);
        fixture.shared->cutLink();
        QTRY_VERIFY(fixture.bus->isReconnecting());
        QVERIFY(!fixture.bus->lost());
        const auto deaf = fixture.bus->transact(Fixture::made(Request::ping(1)));
        QVERIFY(!deaf);
        QCOMPARE(deaf.error().code, ErrorCode::NoReply);
        fixture.shared->restoreLink();
        QTRY_VERIFY(!fixture.bus->isReconnecting());
        QVERIFY(fixture.bus->transact(Fixture::made(Request::ping(1))));
        bool isReceived = false;
        const auto look = [&] {
            for (const Sample& sample : fixture.bus->takeSamples(poll))
                isReceived = sample.answered;
            return isReceived;
        };
        look();
        isReceived = false;
        QTRY_VERIFY(isReceived || look());
    }

    void aStopWhileTheLinkIsAwayIsSentFirst()
    {
        Fixture fixture;
        const Bytes off =
            protocol::feetechCodec().encode(Request::write(254, 40, {0}, Repeat::Safe)).value();
        fixture.bus->setStopFrames({{base::Protocol::Feetech, off}});
        const ReconnectScope reconnect(*fixture.bus, 30s);
        fixture.shared->cutLink();
        QTRY_VERIFY(fixture.bus->isReconnecting());
        fixture.shared->takeSent();
        fixture.bus->emergency();
        const auto preempted = fixture.bus->transact(Fixture::made(Request::ping(1)));
        QVERIFY(!preempted);
        QCOMPARE(preempted.error().code, ErrorCode::Preempted);
        fixture.shared->restoreLink();
        fixture.shared->waitForFrame(off);
        QCOMPARE(fixture.shared->takeSent().front(), off);
        QTRY_VERIFY(fixture.bus->transact(Fixture::made(Request::ping(1))).has_value());
    }

    void theBusEndsWhileTheLinkIsAway()
    {
        Fixture fixture;
        fixture.bus->setReconnectTimeout(60s);
        fixture.shared->cutLink();
        QTRY_VERIFY(fixture.bus->isReconnecting());
        fixture.bus->emergency();
        fixture.bus.reset(); // does not wait for the rest of the minute
        QVERIFY(!fixture.shared->linkAlive);
    }
};

SERVODESK_GUILESS_TEST(TestBusThread)
#include "tst_bus_thread.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Stop, emergency and holds on one thread; what another thread would do is done from a wait.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "bus_fixture.h"

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
const Bytes torqueOffAll = frameOf(254, 3, {40, 0});
const Bytes torqueOff1 = frameOf(1, 3, {40, 0});

std::vector<StopFrame> inFeetech(const std::vector<Bytes>& frames)
{
    std::vector<StopFrame> made;
    for (const Bytes& frame : frames)
        made.push_back({base::Protocol::Feetech, frame});
    return made;
}

/// Calls `action` on another thread, once, in the first wait at or after `delay` from now.
void meanwhile(BusFixture& fixture, Duration delay, std::function<void()> action)
{
    const Duration at = fixture.script.clock.now() + delay;
    fixture.script.onWait = [&fixture, at, action = std::move(action), done = false]() mutable {
        if (fixture.script.clock.now() < at || std::exchange(done, true))
            return;
        std::thread(action).join();
    };
}

std::vector<Bytes> framesOf(const std::vector<SentFrame>& sent)
{
    std::vector<Bytes> frames;
    for (const SentFrame& frame : sent)
        frames.push_back(frame.bytes);
    return frames;
}
} // namespace

class TestBusStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void stopEndsAWaitSoon()
    {
        BusFixture fixture;
        fixture.open();
        base::StopToken stop;
        Transaction transaction;
        transaction.request = Request::read(9, 56, 2);
        transaction.timeout = 10s;
        transaction.stop = &stop;
        const Duration start = fixture.script.clock.now();
        meanwhile(fixture, 100ms, [&] { stop.request(); });
        const auto outcome = fixture.core->transact(transaction);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Stopped);
        QVERIFY(fixture.script.clock.now() - start <= 120ms);
    }

    void stopBlocksRequestsToTheServoToo()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.latency = 22ms;
        base::StopToken stop;
        Transaction transaction;
        transaction.request = Request::read(1, 56, 2);
        transaction.stop = &stop;
        meanwhile(fixture, 2ms, [&] { stop.request(); });
        QVERIFY(!fixture.core->transact(transaction));
        const auto outcome = fixture.transact(Request::read(1, 62, 2), 0);
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 62, 2));
    }

    void nonRepeatableRequestsAreAwaitedAfterStop()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.latency = 20ms;
        base::StopToken stop;
        Transaction transaction;
        transaction.request = Request::write(1, 5, {5}, Repeat::Never);
        transaction.stop = &stop;
        meanwhile(fixture, 1us, [&] { stop.request(); });
        QVERIFY2(fixture.core->transact(transaction), "its fate is known");
        const auto next = fixture.core->transact(transaction);
        QVERIFY(!next);
        QCOMPARE(next.error().code, ErrorCode::Stopped);
        QCOMPARE(fixture.script.sent.size(), std::size_t(1));
    }

    void nothingInterruptsWithoutAStop()
    {
        BusFixture fixture;
        fixture.open();
        base::StopToken stop;
        stop.request();
        QVERIFY(!fixture.core->pauseUntil(fixture.script.clock.now() + 1s, &stop));
        QVERIFY2(fixture.transact(Request::write(1, 55, {1}, Repeat::Safe)), "the lock is closed");
    }

    void shutdownEndsEverything()
    {
        BusFixture fixture;
        base::StopToken shutdown;
        fixture.open({10, &shutdown});
        shutdown.request();
        QCOMPARE(fixture.transact(Request::ping(1)).error().code, ErrorCode::Stopped);
        QCOMPARE(fixture.core->listen(1s).error().code, ErrorCode::Stopped);
        QVERIFY(!fixture.core->pauseUntil(fixture.script.clock.now() + 1s, nullptr));
    }

    void emergencyPreemptsTheRunningTransaction()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setStopFrames(inFeetech({torqueOffAll, torqueOff1}));
        const Duration start = fixture.script.clock.now();
        meanwhile(fixture, 50ms, [&] { fixture.core->emergency(); });
        const auto outcome = fixture.transact(Request::ping(9), 5, 10s);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Preempted);
        const auto sent = fixture.script.takeSent();
        QCOMPARE(framesOf(sent), (std::vector<Bytes>{frameOf(9, 1, {}), torqueOffAll, torqueOff1}));
        QVERIFY2(sent.at(1).at - start <= 50ms + 10ms, "at the next slice");
        QCOMPARE(int(fixture.script.tables.at(1).at(40)), 0);
    }

    void emergencyFromTheSameThreadIsServedAtOnce()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setStopFrames(inFeetech({torqueOffAll}));
        fixture.core->emergency();
        QCOMPARE(framesOf(fixture.script.sent), (std::vector<Bytes>{torqueOffAll}));
        QVERIFY(fixture.transact(Request::ping(1)));
    }

    void emergencyInAPauseIsServedAtOnce()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setStopFrames(inFeetech({torqueOffAll}));
        fixture.core->startPoll({{{1, {{56, 2}}, false, 0}}, 10ms});
        const Duration start = fixture.script.clock.now();
        meanwhile(fixture, 30ms, [&] { fixture.core->emergency(); });
        fixture.core->pauseUntil(start + 100ms, nullptr);
        const auto sent = fixture.script.takeSent();
        const auto stop = std::find_if(sent.begin(), sent.end(),
                                       [](const auto& f) { return f.bytes == torqueOffAll; });
        QVERIFY(stop != sent.end());
        QVERIFY(stop->at - start <= 40ms + 1ms);
        QVERIFY2(sent.end() - stop > 4, "polling goes on");
    }

    void stopFramesDoNotCollideWithAReply()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setBaud(115'200);
        fixture.core->setStopFrames(inFeetech({torqueOffAll}));
        Duration replyEnds{};
        fixture.script.intercept = [&](const Bytes& frame) {
            if (frame[4] != 0x02)
                return true;
            // 46 bytes at 115200 take 4 ms
            for (const std::uint8_t byte : frameOf(1, 0, Bytes(40)))
                fixture.script.reply({byte});
            replyEnds = fixture.script.wireFreeAt;
            return true;
        };
        meanwhile(fixture, 1ms, [&] { fixture.core->emergency(); });
        QVERIFY(!fixture.transact(Request::read(1, 0, 40)));
        QCOMPARE(fixture.script.sent.size(), std::size_t(2));
        QVERIFY(fixture.script.sent.at(1).at >= replyEnds);
        QVERIFY(fixture.script.sent.at(1).at - fixture.script.sent.at(0).at <= 11ms);
    }

    void stopFramesLeaveRoomForTheirReplies()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setStopFrames(
            inFeetech({torqueOff1, frameOf(2, 3, {40, 0}), frameOf(3, 3, {40, 0})}));
        fixture.script.replyDelay = 508us;
        fixture.core->emergency();
        const auto sent = fixture.script.takeSent();
        QCOMPARE(sent.size(), std::size_t(3));
        for (std::size_t i = 1; i < sent.size(); ++i)
            QVERIFY(sent[i].at - sent[i - 1].at >= 80us + 508us + 60us);
        QVERIFY(fixture.transact(Request::read(2, 40, 1)));
    }

    void aLateReplyToAStopFrameIsNoReply()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.latency = 16ms;
        fixture.core->setStopFrames(inFeetech({torqueOff1}));
        fixture.core->emergency();
        fixture.script.tables.clear();
        QVERIFY(!fixture.transact(Request::write(1, 55, {1}, Repeat::Safe), 0));
    }

    void everyHoldIsNotifiedOfTheEmergency()
    {
        BusFixture fixture;
        fixture.open();
        const Hold job = fixture.core->hold({1});
        fixture.core->emergency();
        const auto step =
            fixture.transact(Request::write(1, 42, {0, 8}, Repeat::Safe), -1, {}, job.token());
        QVERIFY(!step);
        QCOMPARE(step.error().code, ErrorCode::Preempted);
        QVERIFY(fixture.script.sent.empty());
        QVERIFY2(fixture.transact(Request::write(1, 55, {1}, Repeat::Safe), -1, {}, job.token()),
                 "the job can still close a lock");
    }

    void thePreemptedTransactionFailsOnce()
    {
        BusFixture fixture;
        fixture.open();
        const Hold job = fixture.core->hold({9, 1});
        meanwhile(fixture, 1ms, [&] { fixture.core->emergency(); });
        const auto step = fixture.transact(Request::ping(9), -1, {}, job.token());
        QCOMPARE(step.error().code, ErrorCode::Preempted);
        QVERIFY(fixture.transact(Request::ping(1), -1, {}, job.token()));
    }

    void heldServosNeedTheToken()
    {
        BusFixture fixture;
        fixture.open();
        {
            const Hold hold = fixture.core->hold({1});
            QCOMPARE(fixture.transact(Request::ping(1)).error().code, ErrorCode::Held);
            QCOMPARE(fixture.transact(Request::action()).error().code, ErrorCode::Held);
            QVERIFY(fixture.script.sent.empty());
            QVERIFY(fixture.transact(Request::ping(2)));
            QVERIFY(fixture.transact(Request::ping(1), -1, {}, hold.token()));
        }
        QVERIFY(fixture.transact(Request::ping(1)));
    }

    void aHoldCanBeMoved()
    {
        BusFixture fixture;
        fixture.open();
        Hold outer;
        {
            Hold inner = fixture.core->hold({1});
            outer = std::move(inner);
        }
        QCOMPARE(fixture.transact(Request::ping(1)).error().code, ErrorCode::Held);
        outer = Hold();
        QVERIFY(fixture.transact(Request::ping(1)));
    }
};

SERVODESK_GUILESS_TEST(TestBusStop)
#include "tst_bus_stop.moc"

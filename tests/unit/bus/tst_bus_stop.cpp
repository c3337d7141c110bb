// SPDX-License-Identifier: GPL-3.0-or-later
// Stop, emergency and holds on one thread; what another thread would do is done from a wait.
#include <QRegularExpression>
#include <QTest>

#include "bench_bus.h"

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
void meanwhile(Bench& bench, Duration delay, std::function<void()> action)
{
    const Duration at = bench.script.clock.now() + delay;
    bench.script.onWait = [&bench, at, action = std::move(action), done = false]() mutable {
        if (bench.script.clock.now() < at || std::exchange(done, true))
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
        Bench bench;
        bench.open();
        base::Stop stop;
        Transaction transaction;
        transaction.request = Request::read(9, 56, 2);
        transaction.patience = 10s;
        transaction.stop = &stop;
        const Duration start = bench.script.clock.now();
        meanwhile(bench, 100ms, [&] { stop.request(); });
        const auto outcome = bench.core->transact(transaction);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Stopped);
        QVERIFY(bench.script.clock.now() - start <= 120ms);
    }

    void stopLeavesTheServoInPeaceToo()
    {
        Bench bench;
        bench.open();
        bench.script.latency = 22ms;
        base::Stop stop;
        Transaction transaction;
        transaction.request = Request::read(1, 56, 2);
        transaction.stop = &stop;
        meanwhile(bench, 2ms, [&] { stop.request(); });
        QVERIFY(!bench.core->transact(transaction));
        const auto outcome = bench.transact(Request::read(1, 62, 2), 0);
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 62, 2));
    }

    void whatMustNotBeRepeatedIsWaitedForAfterStop()
    {
        Bench bench;
        bench.open();
        bench.script.latency = 20ms;
        base::Stop stop;
        Transaction transaction;
        transaction.request = Request::write(1, 5, {5}, Repeat::Never);
        transaction.stop = &stop;
        meanwhile(bench, 1us, [&] { stop.request(); });
        QVERIFY2(bench.core->transact(transaction), "its fate is known");
        const auto next = bench.core->transact(transaction);
        QVERIFY(!next);
        QCOMPARE(next.error().code, ErrorCode::Stopped);
        QCOMPARE(bench.script.sent.size(), std::size_t(1));
    }

    void withoutAStopNothingStopsIt()
    {
        Bench bench;
        bench.open();
        base::Stop stop;
        stop.request();
        QVERIFY(!bench.core->pauseUntil(bench.script.clock.now() + 1s, &stop));
        QVERIFY2(bench.transact(Request::write(1, 55, {1}, Repeat::Safe)), "the lock is closed");
    }

    void shutdownEndsEverything()
    {
        Bench bench;
        base::Stop shutdown;
        bench.open({10, &shutdown});
        shutdown.request();
        QCOMPARE(bench.transact(Request::ping(1)).error().code, ErrorCode::Stopped);
        QCOMPARE(bench.core->listen(1s).error().code, ErrorCode::Stopped);
        QVERIFY(!bench.core->pauseUntil(bench.script.clock.now() + 1s, nullptr));
    }

    void emergencyPreemptsTheRunningTransaction()
    {
        Bench bench;
        bench.open();
        bench.core->setStopFrames(inFeetech({torqueOffAll, torqueOff1}));
        const Duration start = bench.script.clock.now();
        meanwhile(bench, 50ms, [&] { bench.core->emergency(); });
        const auto outcome = bench.transact(Request::ping(9), 5, 10s);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Preempted);
        const auto sent = bench.script.takeSent();
        QCOMPARE(framesOf(sent), (std::vector<Bytes>{frameOf(9, 1, {}), torqueOffAll, torqueOff1}));
        QVERIFY2(sent.at(1).at - start <= 50ms + 10ms, "at the next slice");
        QCOMPARE(int(bench.script.tables.at(1).at(40)), 0);
    }

    void emergencyFromTheSameThreadIsServedAtOnce()
    {
        Bench bench;
        bench.open();
        bench.core->setStopFrames(inFeetech({torqueOffAll}));
        bench.core->emergency();
        QCOMPARE(framesOf(bench.script.sent), (std::vector<Bytes>{torqueOffAll}));
        QVERIFY(bench.transact(Request::ping(1)));
    }

    void emergencyInAPauseIsServedAtOnce()
    {
        Bench bench;
        bench.open();
        bench.core->setStopFrames(inFeetech({torqueOffAll}));
        bench.core->startPoll({{{1, {{56, 2}}, false, 0}}, 10ms});
        const Duration start = bench.script.clock.now();
        meanwhile(bench, 30ms, [&] { bench.core->emergency(); });
        bench.core->pauseUntil(start + 100ms, nullptr);
        const auto sent = bench.script.takeSent();
        const auto stop = std::find_if(sent.begin(), sent.end(),
                                       [](const auto& f) { return f.bytes == torqueOffAll; });
        QVERIFY(stop != sent.end());
        QVERIFY(stop->at - start <= 40ms + 1ms);
        QVERIFY2(sent.end() - stop > 4, "polling goes on");
    }

    void stopFramesDoNotFallIntoARunningReply()
    {
        Bench bench;
        bench.open();
        bench.core->setBaud(115'200);
        bench.core->setStopFrames(inFeetech({torqueOffAll}));
        Duration replyEnds{};
        bench.script.intercept = [&](const Bytes& frame) {
            if (frame[4] != 0x02)
                return true;
            // 46 bytes at 115200 take 4 ms
            for (const std::uint8_t byte : frameOf(1, 0, Bytes(40)))
                bench.script.reply({byte});
            replyEnds = bench.script.wireFree;
            return true;
        };
        meanwhile(bench, 1ms, [&] { bench.core->emergency(); });
        QVERIFY(!bench.transact(Request::read(1, 0, 40)));
        QCOMPARE(bench.script.sent.size(), std::size_t(2));
        QVERIFY(bench.script.sent.at(1).at >= replyEnds);
        QVERIFY(bench.script.sent.at(1).at - bench.script.sent.at(0).at <= 11ms);
    }

    void stopFramesLeaveRoomForTheirReplies()
    {
        Bench bench;
        bench.open();
        bench.core->setStopFrames(
            inFeetech({torqueOff1, frameOf(2, 3, {40, 0}), frameOf(3, 3, {40, 0})}));
        bench.script.replyDelay = 508us;
        bench.core->emergency();
        const auto sent = bench.script.takeSent();
        QCOMPARE(sent.size(), std::size_t(3));
        for (std::size_t i = 1; i < sent.size(); ++i)
            QVERIFY(sent[i].at - sent[i - 1].at >= 80us + 508us + 60us);
        QVERIFY(bench.transact(Request::read(2, 40, 1)));
    }

    void aLateReplyToAStopFrameIsNoAnswer()
    {
        Bench bench;
        bench.open();
        bench.script.latency = 16ms;
        bench.core->setStopFrames(inFeetech({torqueOff1}));
        bench.core->emergency();
        bench.script.tables.clear();
        QVERIFY(!bench.transact(Request::write(1, 55, {1}, Repeat::Safe), 0));
    }

    void everyHoldLearnsOfTheEmergency()
    {
        Bench bench;
        bench.open();
        const Hold job = bench.core->hold({1});
        bench.core->emergency();
        const auto step =
            bench.transact(Request::write(1, 42, {0, 8}, Repeat::Safe), -1, {}, job.token());
        QVERIFY(!step);
        QCOMPARE(step.error().code, ErrorCode::Preempted);
        QVERIFY(bench.script.sent.empty());
        QVERIFY2(bench.transact(Request::write(1, 55, {1}, Repeat::Safe), -1, {}, job.token()),
                 "the job can still close a lock");
    }

    void thePreemptedTransactionIsToldOnce()
    {
        Bench bench;
        bench.open();
        const Hold job = bench.core->hold({9, 1});
        meanwhile(bench, 1ms, [&] { bench.core->emergency(); });
        const auto step = bench.transact(Request::ping(9), -1, {}, job.token());
        QCOMPARE(step.error().code, ErrorCode::Preempted);
        QVERIFY(bench.transact(Request::ping(1), -1, {}, job.token()));
    }

    void heldServosNeedTheToken()
    {
        Bench bench;
        bench.open();
        {
            const Hold hold = bench.core->hold({1});
            QCOMPARE(bench.transact(Request::ping(1)).error().code, ErrorCode::Held);
            QCOMPARE(bench.transact(Request::action()).error().code, ErrorCode::Held);
            QVERIFY(bench.script.sent.empty());
            QVERIFY(bench.transact(Request::ping(2)));
            QVERIFY(bench.transact(Request::ping(1), -1, {}, hold.token()));
        }
        QVERIFY(bench.transact(Request::ping(1)));
    }

    void aHoldCanBeMoved()
    {
        Bench bench;
        bench.open();
        Hold outer;
        {
            Hold inner = bench.core->hold({1});
            outer = std::move(inner);
        }
        QCOMPARE(bench.transact(Request::ping(1)).error().code, ErrorCode::Held);
        outer = Hold();
        QVERIFY(bench.transact(Request::ping(1)));
    }
};

QTEST_GUILESS_MAIN(TestBusStop)
#include "tst_bus_stop.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// How soon the first stop frame begins, whatever the wire is doing: at 115200 and above within
// 50 ms, below right after the computed end of the reply that is running; never after a deadline,
// and never into a reply. On the manual clock, so the figures are exact. And: what was asked for
// before the stop says nothing after it, however late it gets to its first word.
#include <QRegularExpression>
#include <QTest>

#include "bench_bus.h"

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
const Bytes off = frameOf(254, 3, {40, 0});
constexpr Duration longPatience = 10s;

enum class Doing {
    Read,
    SyncRead,
    Poll,
    SyncPoll,
    ScanPing,
    Broadcast,
    Listen,
    Settle,
    Pause,
    Raw
};

/// Starts the activity; it lasts until the emergency ends it, or by itself.
void occupy(Bench& bench, Doing doing)
{
    BusCore& core = *bench.core;
    const Duration later = bench.script.clock.now() + 2s;
    switch (doing) {
    case Doing::Read:
        static_cast<void>(bench.transact(Request::read(1, 0, 100), 5));
        static_cast<void>(bench.transact(Request::read(9, 0, 100), 5, longPatience));
        break;
    case Doing::SyncRead:
        static_cast<void>(bench.transact(Request::syncRead(0, 60, {1, 2, 3}), 5, longPatience));
        static_cast<void>(bench.transact(Request::ping(9), 5, longPatience));
        break;
    case Doing::Poll:
        core.startPoll({{{1, {{0, 100}}, false, 0}}, {}});
        core.pauseUntil(later, nullptr);
        break;
    case Doing::SyncPoll:
        core.startPoll({{{1, {{0, 60}}, true, 0}, {2, {{0, 60}}, true, 0}}, {}});
        core.pauseUntil(later, nullptr);
        break;
    case Doing::ScanPing:
        for (int id = 0; id < 254; ++id)
            static_cast<void>(bench.transact(Request::ping(id), 0, 4ms));
        break;
    case Doing::Broadcast:
        static_cast<void>(bench.transact(Request::ping(254), 0, longPatience));
        break;
    case Doing::Listen:
        static_cast<void>(core.listen(2s));
        break;
    case Doing::Settle: // a line that is never silent keeps the rate from being changed
        for (int i = 0; i < 4000; ++i)
            bench.script.deliver(bench.script.clock.now() + i * 500us, {0x55});
        static_cast<void>(core.setBaud(bench.script.baud));
        break;
    case Doing::Pause:
        core.pauseUntil(later, nullptr);
        break;
    case Doing::Raw:
        static_cast<void>(bench.transact(Request::raw(frameOf(1, 2, {0, 100})), 0, longPatience));
        break;
    }
}

/// When the replies to the latest frame would be over, as far as a host can know.
Duration computedEndOf(const Script& script)
{
    if (script.sent.empty())
        return {};
    const SentFrame& last = script.sent.back();
    const bool sync = last.instruction() == 0x82;
    const std::size_t replies = sync ? last.bytes.size() - 8 : 1;
    const std::size_t data = sync || last.instruction() == 2 ? last.bytes.at(6) : 0;
    return last.at + script.wire(last.bytes.size()) + script.wire(replies * (data + 6)) +
           replies * 508us;
}
} // namespace

Q_DECLARE_METATYPE(Doing)

class TestBusStopTiming : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theFirstStopFrameIsPrompt_data()
    {
        QTest::addColumn<Doing>("doing");
        QTest::addColumn<int>("baud");
        QTest::addColumn<Duration>("after");
        const std::pair<const char*, Doing> all[] = {
            {"read", Doing::Read},     {"sync read", Doing::SyncRead},
            {"poll", Doing::Poll},     {"sync poll", Doing::SyncPoll},
            {"scan", Doing::ScanPing}, {"broadcast", Doing::Broadcast},
            {"listen", Doing::Listen}, {"settle", Doing::Settle},
            {"pause", Doing::Pause},   {"raw", Doing::Raw},
        };
        for (const auto& [name, doing] : all) {
            for (const int baud : {1'000'000, 115'200, 38'400, 9'600}) {
                for (const Duration after : {Duration(1us), Duration(1700us), Duration(23ms)}) {
                    QTest::addRow("%s at %d after %d us", name, baud, int(after.count()))
                        << doing << baud << after;
                }
            }
        }
    }
    void theFirstStopFrameIsPrompt()
    {
        QFETCH(const Doing, doing);
        QFETCH(const int, baud);
        QFETCH(const Duration, after);
        Bench bench;
        bench.script.baud = baud;
        bench.open();
        bench.script.replyDelay = 200us;
        bench.core->setStopFrames({{base::Protocol::Feetech, off}});
        std::optional<Duration> called;
        Duration repliesEnd{};  // of what is on the wire when the call comes
        Duration computedEnd{}; // also of an absent servo's
        const Duration from = bench.script.clock.now() + after;
        bench.script.onWait = [&] {
            if (called || bench.script.clock.now() < from)
                return;
            called = bench.script.clock.now();
            repliesEnd = bench.script.wireFree;
            computedEnd = computedEndOf(bench.script);
            std::thread([&] { bench.core->emergency(); }).join();
        };
        occupy(bench, doing);
        if (!called) // it was over before
            return;
        static_cast<void>(bench.transact(Request::ping(1)));
        const auto stop = std::find_if(bench.script.sent.begin(), bench.script.sent.end(),
                                       [](const SentFrame& frame) { return frame.bytes == off; });
        QVERIFY(stop != bench.script.sent.end());
        const Duration waited = stop->at - *called;
        if (baud >= 115'200)
            QVERIFY2(waited <= 50ms, qPrintable(QString::number(waited.count())));
        const Duration due =
            std::max({*called, repliesEnd, computedEnd}) + waitSlice + bench.script.wire(4) + 500us;
        if (doing != Doing::Settle)
            QVERIFY2(stop->at <= due, qPrintable(QString::number((stop->at - due).count())));
        // Nobody knows how long the answer to raw bytes will be.
        const bool intoReply = stop->at < repliesEnd && waited < 30ms;
        QVERIFY2(!intoReply || doing == Doing::Raw, "not into a reply");
    }

    /// Between a task's last look at its stop and its first frame there is a moment.
    void whatWasAskedForBeforeTheStopSaysNothingAfterIt()
    {
        Bench bench;
        bench.open();
        bench.core->setStopFrames({{base::Protocol::Feetech, off}});
        const std::uint64_t before = bench.core->emergencies();
        bench.core->emergency();
        QCOMPARE(bench.core->emergencies(), before + 1);
        bench.script.sent.clear();
        {
            const Hold late = bench.core->hold({1}, before);
            const auto move =
                bench.transact(Request::write(1, 42, {0, 8}, Repeat::Safe), -1, {}, late.token());
            QCOMPARE(move.error().code, ErrorCode::Preempted);
        }
        Transaction loose;
        loose.request = Request::write(1, 42, {0, 8}, Repeat::Safe);
        loose.epoch = before;
        for (int i = 0; i < 2; ++i) // each time, not once
            QCOMPARE(bench.core->transact(loose).error().code, ErrorCode::Preempted);
        QVERIFY(bench.script.sent.empty());
        loose.epoch = bench.core->emergencies();
        QVERIFY(bench.core->transact(loose));
        const Hold fresh = bench.core->hold({1}, bench.core->emergencies());
        QVERIFY(bench.transact(Request::ping(1), -1, {}, fresh.token()));
    }

    void aLateHoldCanStillCloseALock()
    {
        Bench bench;
        bench.open();
        bench.core->emergency();
        const Hold late = bench.core->hold({1}, 0);
        Transaction step;
        step.hold = late.token();
        step.epoch = 0;
        step.request = Request::write(1, 42, {0, 8}, Repeat::Safe);
        QCOMPARE(bench.core->transact(step).error().code, ErrorCode::Preempted);
        step.request = Request::write(1, 55, {1}, Repeat::Safe);
        QVERIFY(bench.core->transact(step));
    }
};

QTEST_GUILESS_MAIN(TestBusStopTiming)
#include "tst_bus_stop_timing.moc"

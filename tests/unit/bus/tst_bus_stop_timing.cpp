// SPDX-License-Identifier: GPL-3.0-or-later
// How soon the first stop frame begins, whatever the wire is doing: at 115200 and above within
// 50 ms, below right after the computed end of the reply that is running; never after a deadline,
// and never into a reply. On the manual clock, so the figures are exact. And: what was asked for
// before the stop says nothing after it, however late it gets to its first word.
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
const Bytes off = frameOf(254, 3, {40, 0});
constexpr Duration longTimeout = 10s;

enum class BusActivity {
    Read,
    SyncRead,
    Poll,
    SyncPoll,
    ScanPing,
    Broadcast,
    Listen,
    RecoverLine,
    Pause,
    Raw,
    SilentServo
};

/// Starts the activity; it lasts until the emergency ends it, or by itself.
void startActivity(BusFixture& fixture, BusActivity doing)
{
    BusCore& core = *fixture.core;
    const Duration later = fixture.script.clock.now() + 2s;
    switch (doing) {
    case BusActivity::Read:
        static_cast<void>(fixture.transact(Request::read(1, 0, 100), 5));
        static_cast<void>(fixture.transact(Request::read(9, 0, 100), 5, longTimeout));
        break;
    case BusActivity::SyncRead:
        static_cast<void>(fixture.transact(Request::syncRead(0, 60, {1, 2, 3}), 5, longTimeout));
        static_cast<void>(fixture.transact(Request::ping(9), 5, longTimeout));
        break;
    case BusActivity::Poll:
        core.startPoll({{{1, {{0, 100}}, false, 0}}, {}});
        core.pauseUntil(later, nullptr);
        break;
    case BusActivity::SyncPoll:
        core.startPoll({{{1, {{0, 60}}, true, 0}, {2, {{0, 60}}, true, 0}}, {}});
        core.pauseUntil(later, nullptr);
        break;
    case BusActivity::ScanPing:
        for (int id = 0; id < 254; ++id)
            static_cast<void>(fixture.transact(Request::ping(id), 0, 4ms));
        break;
    case BusActivity::Broadcast:
        static_cast<void>(fixture.transact(Request::ping(254), 0, longTimeout));
        break;
    case BusActivity::Listen:
        static_cast<void>(core.listen(2s));
        break;
    case BusActivity::RecoverLine: // a line that is never silent keeps the rate from being changed
        for (int i = 0; i < 4000; ++i)
            fixture.script.deliver(fixture.script.clock.now() + i * 500us, {0x55});
        static_cast<void>(core.setBaud(fixture.script.baud));
        break;
    case BusActivity::Pause:
        core.pauseUntil(later, nullptr);
        break;
    case BusActivity::SilentServo: // whose late reply is awaited, while others are polled
        core.startPoll({{{1, {{0, 100}}, false, 0}}, {}});
        static_cast<void>(fixture.transact(Request::ping(1)));
        static_cast<void>(fixture.transact(Request::ping(9), 2));
        break;
    case BusActivity::Raw:
        static_cast<void>(fixture.transact(Request::raw(frameOf(1, 2, {0, 100})), 0, longTimeout));
        break;
    }
}

/// When the replies to the latest frame would be over, as far as a host can know.
Duration computeExpectedEnd(const Script& script)
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

class TestBusStopTiming : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theFirstStopFrameIsPrompt_data()
    {
        QTest::addColumn<BusActivity>("doing");
        QTest::addColumn<int>("baud");
        QTest::addColumn<Duration>("after");
        const std::pair<const char*, BusActivity> all[] = {
            {"read", BusActivity::Read},     {"sync read", BusActivity::SyncRead},
            {"poll", BusActivity::Poll},     {"sync poll", BusActivity::SyncPoll},
            {"scan", BusActivity::ScanPing}, {"broadcast", BusActivity::Broadcast},
            {"listen", BusActivity::Listen}, {"settle", BusActivity::RecoverLine},
            {"pause", BusActivity::Pause},   {"raw", BusActivity::Raw},
        };
        for (const auto& [name, doing] : all) {
            for (const int baud : {1'000'000, 115'200, 38'400, 9'600}) {
                for (const Duration after : {Duration(1us), Duration(1700us), Duration(23ms)}) {
                    QTest::addRow("%s at %d after %d us", name, baud, int(after.count()))
                        << doing << baud << after;
                }
            }
        }
        for (const Duration after : {Duration(90ms), Duration(170ms), Duration(230ms)})
            QTest::addRow("silent servo after %d us", int(after.count()))
                << BusActivity::SilentServo << 1'000'000 << after;
    }
    void theFirstStopFrameIsPrompt()
    {
        QFETCH(const BusActivity, doing);
        QFETCH(const int, baud);
        QFETCH(const Duration, after);
        BusFixture fixture;
        fixture.script.baud = baud;
        fixture.open();
        fixture.script.replyDelay = 200us;
        fixture.core->setStopFrames({{base::Protocol::Feetech, off}});
        std::optional<Duration> callTime;
        Duration repliesEnd{};  // of what is on the wire when the call comes
        Duration expectedEnd{}; // also of an absent servo's
        const Duration from = fixture.script.clock.now() + after;
        fixture.script.onWait = [&] {
            if (callTime || fixture.script.clock.now() < from)
                return;
            callTime = fixture.script.clock.now();
            repliesEnd = fixture.script.wireFreeAt;
            expectedEnd = computeExpectedEnd(fixture.script);
            std::thread([&] { fixture.core->emergency(); }).join();
        };
        startActivity(fixture, doing);
        if (!callTime) // it was over before
            return;
        static_cast<void>(fixture.transact(Request::ping(1)));
        const auto stop = std::find_if(fixture.script.sent.begin(), fixture.script.sent.end(),
                                       [](const SentFrame& frame) { return frame.bytes == off; });
        QVERIFY(stop != fixture.script.sent.end());
        const Duration waited = stop->at - *callTime;
        if (baud >= 115'200)
            QVERIFY2(waited <= 50ms, qPrintable(QString::number(waited.count())));
        const Duration due = std::max({*callTime, repliesEnd, expectedEnd}) + waitSlice +
                             fixture.script.wire(4) + 500us;
        if (doing != BusActivity::RecoverLine)
            QVERIFY2(stop->at <= due, qPrintable(QString::number((stop->at - due).count())));
        // Nobody knows how long the answer to raw bytes will be.
        const bool intoReply = stop->at < repliesEnd && waited < 30ms;
        QVERIFY2(!intoReply || doing == BusActivity::Raw, "not into a reply");
    }

    /// Between a task's last look at its stop and its first frame there is a moment.
    void requestsBeforeTheStopAreDroppedAfterIt()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setStopFrames({{base::Protocol::Feetech, off}});
        const std::uint64_t before = fixture.core->emergencyCount();
        fixture.core->emergency();
        QCOMPARE(fixture.core->emergencyCount(), before + 1);
        fixture.script.sent.clear();
        {
            const Hold late = fixture.core->hold({1}, before);
            const auto move =
                fixture.transact(Request::write(1, 42, {0, 8}, Repeat::Safe), -1, {}, late.token());
            QCOMPARE(move.error().code, ErrorCode::Preempted);
        }
        Transaction loose;
        loose.request = Request::write(1, 42, {0, 8}, Repeat::Safe);
        loose.epoch = before;
        for (int i = 0; i < 2; ++i) // each time, not once
            QCOMPARE(fixture.core->transact(loose).error().code, ErrorCode::Preempted);
        QVERIFY(fixture.script.sent.empty());
        loose.epoch = fixture.core->emergencyCount();
        QVERIFY(fixture.core->transact(loose));
        const Hold fresh = fixture.core->hold({1}, fixture.core->emergencyCount());
        QVERIFY(fixture.transact(Request::ping(1), -1, {}, fresh.token()));
    }

    void aLateHoldCanStillCloseALock()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->emergency();
        const Hold late = fixture.core->hold({1}, 0);
        Transaction step;
        step.hold = late.token();
        step.epoch = 0;
        step.request = Request::write(1, 42, {0, 8}, Repeat::Safe);
        QCOMPARE(fixture.core->transact(step).error().code, ErrorCode::Preempted);
        step.request = Request::write(1, 55, {1}, Repeat::Safe);
        QVERIFY(fixture.core->transact(step));
    }
};

SERVODESK_GUILESS_TEST(TestBusStopTiming)
#include "tst_bus_stop_timing.moc"

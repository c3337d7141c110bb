// SPDX-License-Identifier: GPL-3.0-or-later
// A link that dies and comes back while its return is awaited: silence meanwhile, the stop first
// afterwards, and lost for good when it stays away. On a manual clock.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "bus_fixture.h"

using namespace bus;
using base::ErrorCode;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
/// A bench whose link can be opened again as long as it is not cut.
struct ReconnectFixture : BusFixture {
    int opened = 0;

    ReconnectFixture()
    {
        CoreOptions options;
        options.reopen = [this]() -> base::Result<std::unique_ptr<transport::Link>> {
            ++opened;
            if (script.cut)
                return base::fail(ErrorCode::PortMissing);
            return std::make_unique<ScriptedLink>(script);
        };
        open(options);
    }
    ErrorCode ping(int id)
    {
        const auto outcome = transact(Request::ping(id));
        return outcome ? ErrorCode::Held : outcome.error().code; // Held: no error
    }
    void pass(Duration span) { core->pauseUntil(script.clock.now() + span, nullptr); }
    bool noted(const char* words)
    {
        const auto entries = core->takeTrace();
        return std::any_of(entries.begin(), entries.end(), [&](const TraceEntry& entry) {
            return entry.kind == TraceKind::Note &&
                   QByteArray(reinterpret_cast<const char*>(entry.bytes.data()),
                              qsizetype(entry.bytes.size())) == words;
        });
    }
};

constexpr auto answered = ErrorCode::Held;

StopFrame stopFrame()
{
    const Request off = Request::write(254, 40, {0}, protocol::Repeat::Safe);
    return {base::Protocol::Feetech, protocol::feetechCodec().encode(off).value()};
}
} // namespace

class TestBusReconnect : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void withoutReconnectTimeoutItIsLostAtOnce()
    {
        ReconnectFixture fixture;
        fixture.script.cut = true;
        QCOMPARE(fixture.ping(1), ErrorCode::LinkLost);
        fixture.script.cut = false;
        QCOMPARE(fixture.ping(1), ErrorCode::LinkLost);
        QVERIFY(fixture.core->lost());
        QCOMPARE(fixture.opened, 0);
    }

    void linkReturns()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        QCOMPARE(fixture.ping(1), answered);
        fixture.script.cut = true;
        QCOMPARE(fixture.ping(1), ErrorCode::NoReply);
        QVERIFY(fixture.core->isReconnecting());
        QVERIFY(!fixture.core->lost());
        fixture.script.sent.clear();
        fixture.pass(3s);
        QVERIFY(fixture.script.sent.empty());
        QVERIFY(fixture.opened >= 10 && fixture.opened <= 20);
        fixture.script.cut = false;
        fixture.pass(300ms);
        fixture.ping(2); // looks for it
        QCOMPARE(fixture.ping(1), answered);
        QVERIFY(!fixture.core->isReconnecting());
        QVERIFY(fixture.noted("link back"));
    }

    void lostAfterTheReconnectTimeout()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.cut = true;
        const Duration from = fixture.script.clock.now();
        while (fixture.ping(1) == ErrorCode::NoReply) {
        }
        QVERIFY(fixture.core->lost());
        QVERIFY(!fixture.core->isReconnecting());
        const Duration span = fixture.script.clock.now() - from;
        QVERIFY(span >= 5s && span < 5200ms);
        fixture.script.cut = false;
        QCOMPARE(fixture.ping(1), ErrorCode::LinkLost);
    }

    /// One that opens and dies again without a word does not renew the patience.
    void aFalseReturnIsLostInTime()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.cut = true;
        fixture.ping(1);
        const Duration from = fixture.script.clock.now();
        fixture.script.tables.clear();
        while (!fixture.core->lost() && fixture.script.clock.now() < from + 20s) {
            fixture.script.cut = !fixture.script.cut;
            fixture.ping(1);
            fixture.pass(50ms);
        }
        QVERIFY(fixture.core->lost());
        QVERIFY(fixture.script.clock.now() - from < 6s);
    }

    void eachUnplugHasItsOwnTimeout()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        for (int times = 0; times < 3; ++times) {
            fixture.script.cut = true;
            fixture.ping(1);
            fixture.pass(4s);
            fixture.script.cut = false;
            while (fixture.ping(1) != answered)
                QVERIFY(!fixture.core->lost());
        }
    }

    void theRateIsRestored()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        QVERIFY(fixture.core->setBaud(500'000));
        fixture.script.cut = true;
        fixture.ping(1);
        QCOMPARE(fixture.core->setBaud(250'000).error().code, ErrorCode::NoReply);
        fixture.script.baud = 1'000'000; // what the port was opened with
        fixture.script.cut = false;
        while (fixture.ping(1) != answered)
            QVERIFY(!fixture.core->lost());
        QCOMPARE(fixture.script.baud, 500'000);
    }

    void pollsCountAsLost()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        PollServo servo;
        servo.id = 1;
        servo.spans = {{56, 2}};
        const PollPlan plan{{servo}, 20ms};
        const PollId id = fixture.core->startPoll(plan);
        fixture.pass(200ms);
        fixture.core->takeSamples(id);
        fixture.script.cut = true;
        fixture.pass(1s);
        const auto lost = fixture.core->takeSamples(id);
        QVERIFY2(lost.size() >= 3, qPrintable(QString::number(lost.size())));
        QVERIFY(std::all_of(lost.begin(), lost.end(), [](const Sample& sample) {
            return !sample.answered && sample.error == ErrorCode::NoReply;
        }));
        QVERIFY(fixture.counters(1).timeouts >= lost.size());
        fixture.script.cut = false;
        fixture.pass(1s);
        const auto again = fixture.core->takeSamples(id);
        QVERIFY(!again.empty() && again.back().answered);
    }

    void unansweredIsNotReportedDelivered()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.cut = true;
        const auto together = fixture.transact(Request::syncWrite(42, {{1, {0, 4}}, {2, {0, 4}}}));
        QVERIFY(!together);
        QCOMPARE(together.error().code, ErrorCode::Uncertain);
        fixture.script.sent.clear();
        fixture.script.cut = false;
        fixture.pass(1s);
        for (const SentFrame& frame : fixture.script.sent)
            QVERIFY(frame.instruction() != 0x83); // nothing is sent later by itself
    }

    void aStopRequestedWhileAwayIsSentFirst()
    {
        ReconnectFixture fixture;
        fixture.core->setStopFrames({stopFrame()});
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.cut = true;
        fixture.ping(1);
        fixture.core->emergency();
        QCOMPARE(fixture.core->emergencyCount(), std::uint64_t(1));
        fixture.script.sent.clear();
        QCOMPARE(fixture.ping(1), ErrorCode::Preempted);
        fixture.pass(2s);
        QCOMPARE(fixture.ping(2), ErrorCode::Preempted); // nothing is said before it
        QVERIFY(fixture.script.sent.empty());
        fixture.script.cut = false;
        fixture.pass(500ms);
        QVERIFY(!fixture.script.sent.empty());
        QCOMPARE(fixture.script.sent.front().bytes, stopFrame().bytes);
        QCOMPARE(fixture.ping(1), answered);
    }

    /// The one who asked for patience has ended; the stop is still owed.
    void aPendingStopOutlivesTheWaitingJob()
    {
        ReconnectFixture fixture;
        fixture.core->setStopFrames({stopFrame()});
        {
            const ReconnectScope reconnect(*fixture.core, 5s);
            fixture.script.cut = true;
            fixture.ping(1);
            fixture.core->emergency();
        }
        fixture.script.sent.clear();
        fixture.pass(2s);
        fixture.script.cut = false;
        fixture.pass(500ms);
        QVERIFY(!fixture.script.sent.empty());
        QCOMPARE(fixture.script.sent.front().bytes, stopFrame().bytes);
    }

    void aStopInterruptedByLinkLossIsResent()
    {
        ReconnectFixture fixture;
        fixture.core->setStopFrames({stopFrame()});
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.intercept = [&](const Bytes& frame) {
            fixture.script.cut = frame == stopFrame().bytes;
            return fixture.script.cut;
        };
        fixture.core->emergency();
        QVERIFY(fixture.core->isReconnecting());
        fixture.script.intercept = {};
        fixture.script.sent.clear();
        fixture.script.cut = false;
        fixture.pass(500ms);
        QVERIFY(!fixture.script.sent.empty());
        QCOMPARE(fixture.script.sent.front().bytes, stopFrame().bytes);
    }

    void afterAStopTheLineIsSilent()
    {
        ReconnectFixture fixture;
        const ReconnectScope reconnect(*fixture.core, 5s);
        fixture.script.cut = true;
        fixture.ping(1);
        fixture.core->emergency();
        Transaction look;
        look.request = Request::ping(1);
        look.priority = Priority::Emergency;
        const auto seen = fixture.core->transact(look);
        QVERIFY(!seen);
        QCOMPARE(seen.error().code, ErrorCode::NoReply);
    }
};

SERVODESK_GUILESS_TEST(TestBusReconnect)
#include "tst_bus_reconnect.moc"

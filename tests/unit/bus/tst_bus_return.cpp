// SPDX-License-Identifier: GPL-3.0-or-later
// A link that dies and comes back while its return is awaited: silence meanwhile, the stop first
// afterwards, and lost for good when it stays away. On a manual clock.
#include <QRegularExpression>
#include <QTest>

#include "bench_bus.h"

using namespace bus;
using base::ErrorCode;
using protocol::Request;
using namespace std::chrono_literals;

namespace {
/// A bench whose link can be opened again as long as it is not cut.
struct ReturnBench : Bench {
    int opened = 0;

    ReturnBench()
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

class TestBusReturn : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void withoutPatienceItIsLostAtOnce()
    {
        ReturnBench bench;
        bench.script.cut = true;
        QCOMPARE(bench.ping(1), ErrorCode::LinkLost);
        bench.script.cut = false;
        QCOMPARE(bench.ping(1), ErrorCode::LinkLost);
        QVERIFY(bench.core->lost());
        QCOMPARE(bench.opened, 0);
    }

    void itComesBack()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        QCOMPARE(bench.ping(1), answered);
        bench.script.cut = true;
        QCOMPARE(bench.ping(1), ErrorCode::NoAnswer);
        QVERIFY(bench.core->away());
        QVERIFY(!bench.core->lost());
        bench.script.sent.clear();
        bench.pass(3s);
        QVERIFY(bench.script.sent.empty());
        QVERIFY(bench.opened >= 10 && bench.opened <= 20);
        bench.script.cut = false;
        bench.pass(300ms);
        bench.ping(2); // looks for it
        QCOMPARE(bench.ping(1), answered);
        QVERIFY(!bench.core->away());
        QVERIFY(bench.noted("link back"));
    }

    void afterThePatienceItIsLost()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        bench.script.cut = true;
        const Duration from = bench.script.clock.now();
        while (bench.ping(1) == ErrorCode::NoAnswer) {
        }
        QVERIFY(bench.core->lost());
        QVERIFY(!bench.core->away());
        const Duration span = bench.script.clock.now() - from;
        QVERIFY(span >= 5s && span < 5200ms);
        bench.script.cut = false;
        QCOMPARE(bench.ping(1), ErrorCode::LinkLost);
    }

    /// One that opens and dies again without a word does not renew the patience.
    void aLinkThatOnlySeemsToComeBackIsLostInTime()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        bench.script.cut = true;
        bench.ping(1);
        const Duration from = bench.script.clock.now();
        bench.script.tables.clear();
        while (!bench.core->lost() && bench.script.clock.now() < from + 20s) {
            bench.script.cut = !bench.script.cut;
            bench.ping(1);
            bench.pass(50ms);
        }
        QVERIFY(bench.core->lost());
        QVERIFY(bench.script.clock.now() - from < 6s);
    }

    void thePatienceOfEachPlugIsItsOwn()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        for (int times = 0; times < 3; ++times) {
            bench.script.cut = true;
            bench.ping(1);
            bench.pass(4s);
            bench.script.cut = false;
            while (bench.ping(1) != answered)
                QVERIFY(!bench.core->lost());
        }
    }

    void theRateIsThatOfBefore()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        QVERIFY(bench.core->setBaud(500'000));
        bench.script.cut = true;
        bench.ping(1);
        QCOMPARE(bench.core->setBaud(250'000).error().code, ErrorCode::NoAnswer);
        bench.script.baud = 1'000'000; // what the port was opened with
        bench.script.cut = false;
        while (bench.ping(1) != answered)
            QVERIFY(!bench.core->lost());
        QCOMPARE(bench.script.baud, 500'000);
    }

    void pollsCountAsLost()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        PollServo servo;
        servo.id = 1;
        servo.spans = {{56, 2}};
        const PollPlan plan{{servo}, 20ms};
        const PollId id = bench.core->startPoll(plan);
        bench.pass(200ms);
        bench.core->takeSamples(id);
        bench.script.cut = true;
        bench.pass(1s);
        const auto lost = bench.core->takeSamples(id);
        QVERIFY2(lost.size() >= 3, qPrintable(QString::number(lost.size())));
        QVERIFY(std::all_of(lost.begin(), lost.end(), [](const Sample& sample) {
            return !sample.answered && sample.error == ErrorCode::NoAnswer;
        }));
        QVERIFY(bench.counters(1).timeOuts >= lost.size());
        bench.script.cut = false;
        bench.pass(1s);
        const auto again = bench.core->takeSamples(id);
        QVERIFY(!again.empty() && again.back().answered);
    }

    void whatIsNotAnsweredIsNotSaidToHaveArrived()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        bench.script.cut = true;
        const auto together = bench.transact(Request::syncWrite(42, {{1, {0, 4}}, {2, {0, 4}}}));
        QVERIFY(!together);
        QCOMPARE(together.error().code, ErrorCode::Uncertain);
        bench.script.sent.clear();
        bench.script.cut = false;
        bench.pass(1s);
        for (const SentFrame& frame : bench.script.sent)
            QVERIFY(frame.instruction() != 0x83); // nothing is sent later by itself
    }

    void aStopAskedForMeanwhileIsTheFirstWord()
    {
        ReturnBench bench;
        bench.core->setStopFrames({stopFrame()});
        const LinkPatience patience(*bench.core, 5s);
        bench.script.cut = true;
        bench.ping(1);
        bench.core->emergency();
        QCOMPARE(bench.core->emergencies(), std::uint64_t(1));
        bench.script.sent.clear();
        QCOMPARE(bench.ping(1), ErrorCode::Preempted);
        bench.pass(2s);
        QCOMPARE(bench.ping(2), ErrorCode::Preempted); // nothing is said before it
        QVERIFY(bench.script.sent.empty());
        bench.script.cut = false;
        bench.pass(500ms);
        QVERIFY(!bench.script.sent.empty());
        QCOMPARE(bench.script.sent.front().bytes, stopFrame().bytes);
        QCOMPARE(bench.ping(1), answered);
    }

    /// The one who asked for patience has ended; the stop is still owed.
    void aStopIsOwedBeyondThePatientJob()
    {
        ReturnBench bench;
        bench.core->setStopFrames({stopFrame()});
        {
            const LinkPatience patience(*bench.core, 5s);
            bench.script.cut = true;
            bench.ping(1);
            bench.core->emergency();
        }
        bench.script.sent.clear();
        bench.pass(2s);
        bench.script.cut = false;
        bench.pass(500ms);
        QVERIFY(!bench.script.sent.empty());
        QCOMPARE(bench.script.sent.front().bytes, stopFrame().bytes);
    }

    void aStopThatTheLinkDiesUnderIsSaidAgain()
    {
        ReturnBench bench;
        bench.core->setStopFrames({stopFrame()});
        const LinkPatience patience(*bench.core, 5s);
        bench.script.intercept = [&](const Bytes& frame) {
            bench.script.cut = frame == stopFrame().bytes;
            return bench.script.cut;
        };
        bench.core->emergency();
        QVERIFY(bench.core->away());
        bench.script.intercept = {};
        bench.script.sent.clear();
        bench.script.cut = false;
        bench.pass(500ms);
        QVERIFY(!bench.script.sent.empty());
        QCOMPARE(bench.script.sent.front().bytes, stopFrame().bytes);
    }

    void whoLooksAfterAStopHearsSilence()
    {
        ReturnBench bench;
        const LinkPatience patience(*bench.core, 5s);
        bench.script.cut = true;
        bench.ping(1);
        bench.core->emergency();
        Transaction look;
        look.request = Request::ping(1);
        look.priority = Priority::Emergency;
        const auto seen = bench.core->transact(look);
        QVERIFY(!seen);
        QCOMPARE(seen.error().code, ErrorCode::NoAnswer);
    }
};

QTEST_GUILESS_MAIN(TestBusReturn)
#include "tst_bus_return.moc"

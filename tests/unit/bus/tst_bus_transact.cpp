// SPDX-License-Identifier: GPL-3.0-or-later
// One transaction: what it answers, how long it waits, when it repeats, and who may speak when.
#include <QRegularExpression>
#include <QTest>

#include "bench_bus.h"

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

Q_DECLARE_METATYPE(protocol::Request)
Q_DECLARE_METATYPE(Duration)
Q_DECLARE_METATYPE(base::ErrorCode)
Q_DECLARE_METATYPE(Bytes)

class TestBusTransact : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void readAnswers()
    {
        Bench bench;
        bench.open();
        const auto outcome = bench.transact(Request::read(1, 56, 15));
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 15));
        QCOMPARE(outcome->attempts, 1);
        QVERIFY(outcome->faults.empty());
        QCOMPARE(outcome->roundTrip, Duration(80 + 210));
        const Counters counters = bench.counters(1);
        QCOMPARE(counters.sent, std::uint64_t(1));
        QCOMPARE(counters.ok, std::uint64_t(1));
        QVERIFY(qAbs(counters.roundTripP50.count() - 290) <= 290 / 64);
    }

    void alarmIsData()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply(frameOf(1, 0x20, {7}));
            return true;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 1));
        QVERIFY(outcome);
        QCOMPARE(int(outcome->status()), 0x20);
        QCOMPARE(outcome->data(), (Bytes{7}));
    }

    void waitsForWireDelayAndPatience_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<int>("baud");
        QTest::addColumn<int>("bits");
        QTest::addColumn<Duration>("replyDelay");
        QTest::addColumn<Duration>("patience");
        QTest::addColumn<Duration>("waits");
        const auto row = [](const char* name, const Request& request, int baud, int bits,
                            Duration delay, Duration patience, Duration waits) {
            QTest::newRow(name) << request << baud << bits << delay << patience << waits;
        };
        const Request read = Request::read(9, 56, 15);
        row("default", read, 1'000'000, 10, 508us, 0us, 290us + 508us + 25ms);
        row("scan", Request::ping(9), 1'000'000, 10, 508us, 4ms, 120us + 508us + 4ms);
        row("slow wire", read, 100'000, 10, 508us, 0us, 2900us + 508us + 25ms);
        row("parity", read, 1'000'000, 11, 508us, 0us, 319us + 508us + 25ms);
        row("long delay", read, 1'000'000, 10, 2ms, 0us, 290us + 2ms + 25ms);
        row("sync read of three", Request::syncRead(56, 15, {7, 8, 9}), 1'000'000, 10, 508us, 0us,
            110us + 3 * 210us + 3 * 508us + 25ms);
    }

    void waitsForWireDelayAndPatience()
    {
        QFETCH(const Request, request);
        QFETCH(const Duration, replyDelay);
        QFETCH(const Duration, patience);
        QFETCH(const Duration, waits);
        QFETCH(const int, baud);
        QFETCH(const int, bits);
        Bench bench;
        bench.script.baud = baud;
        bench.open({bits, nullptr});
        bench.core->setReplyDelay(replyDelay);
        QCOMPARE(bench.timed(request, 0, patience), waits);
    }

    void patienceCanBeSet()
    {
        Bench bench;
        bench.open();
        bench.core->setReplyDelay(0us);
        bench.core->setPatience(100ms);
        QCOMPARE(bench.timed(Request::ping(9)), Duration(120us + 100ms));
        bench.core->setPatience(10ms);
        QCOMPARE(bench.timed(Request::ping(8)), Duration(120us + 10ms));
    }

    void lostAnswersAreAskedForAgain_data()
    {
        QTest::addColumn<int>("lost");
        QTest::addColumn<int>("retries");
        QTest::addColumn<int>("attempts");
        QTest::addColumn<bool>("answered");
        QTest::newRow("one lost") << 1 << -1 << 2 << true;
        QTest::newRow("two lost") << 2 << -1 << 3 << true;
        QTest::newRow("three lost, default gives up") << 3 << -1 << 3 << false;
        QTest::newRow("three lost, three retries") << 3 << 3 << 4 << true;
        QTest::newRow("one lost, no retries") << 1 << 0 << 1 << false;
    }

    void lostAnswersAreAskedForAgain()
    {
        QFETCH(const int, lost);
        QFETCH(const int, retries);
        QFETCH(const int, attempts);
        QFETCH(const bool, answered);
        Bench bench;
        bench.open();
        bench.script.intercept = [left = lost](const Bytes&) mutable { return left-- > 0; };
        const auto outcome = bench.transact(Request::read(1, 56, 2), retries);
        QCOMPARE(outcome.has_value(), answered);
        QCOMPARE(int(bench.script.sent.size()), attempts);
        QCOMPARE(int(bench.counters(1).timeOuts), lost);
        QCOMPARE(int(bench.counters(1).retried), attempts > 1 ? 1 : 0);
        if (answered) {
            QCOMPARE(outcome->attempts, attempts);
            QCOMPARE(int(outcome->faults.size()), lost);
            QCOMPARE(outcome->faults.front().kind, FaultKind::TimeOut);
            QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        } else {
            QCOMPARE(outcome.error().code, ErrorCode::NoAnswer);
            QCOMPARE(outcome.error().attempts, attempts);
            QCOMPARE(outcome.error().id, 1);
        }
    }

    void defaultRetriesCanBeSet()
    {
        Bench bench;
        bench.open();
        bench.core->setRetries(0);
        QVERIFY(!bench.transact(Request::ping(9)));
        QCOMPARE(bench.script.sent.size(), std::size_t(1));
    }

    void whatMustNotBeRepeatedIsNot_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("relative move") << Request::write(1, 42, {0, 4}, Repeat::Never);
        QTest::newRow("calibration") << Request::calibrate(1, {}, base::ByteOrder::Little);
        QTest::newRow("restore") << Request::restore(1);
        QTest::newRow("state reset") << Request::stateReset(1);
    }

    void whatMustNotBeRepeatedIsNot()
    {
        QFETCH(const Request, request);
        Bench bench;
        bench.open();
        bench.script.intercept = [](const Bytes&) { return true; };
        const auto outcome = bench.transact(request, 5);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Uncertain);
        QCOMPARE(bench.script.sent.size(), std::size_t(1));
    }

    void troublesAreToldApart_data()
    {
        QTest::addColumn<Bytes>("answer");
        QTest::addColumn<ErrorCode>("code");
        Bytes broken = frameOf(1, 0, {1, 2});
        broken.back() ^= 0x10;
        const Bytes good = frameOf(1, 0, {1, 2});
        QTest::newRow("silence") << Bytes{} << ErrorCode::NoAnswer;
        QTest::newRow("wrong checksum") << broken << ErrorCode::Garbled;
        QTest::newRow("noise") << Bytes{0x00, 0x13, 0x37} << ErrorCode::Garbled;
        QTest::newRow("cut short") << Bytes(good.begin(), good.end() - 2) << ErrorCode::Garbled;
        QTest::newRow("too short a frame") << frameOf(1, 0, {1}) << ErrorCode::WrongAnswer;
        QTest::newRow("another servo") << frameOf(2, 0, {1, 2}) << ErrorCode::NoAnswer;
    }

    void troublesAreToldApart()
    {
        QFETCH(const Bytes, answer);
        QFETCH(const ErrorCode, code);
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            if (!answer.empty())
                bench.script.reply(answer);
            return true;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, code);
    }

    void anythingHeardOutweighsSilence()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&, first = true](const Bytes&) mutable {
            if (std::exchange(first, false))
                bench.script.reply({0x42});
            return true;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
    }

    void brokenReplyIsRepeatedAtOnce()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&, first = true](const Bytes&) mutable {
            if (!std::exchange(first, false))
                return false;
            Bytes broken = frameOf(1, 0, {1, 2});
            broken.back() ^= 1;
            bench.script.reply(broken);
            return true;
        };
        const Duration start = bench.script.clock.now();
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->faults.front().kind, FaultKind::BadCheck);
        QCOMPARE(bench.counters(1).badChecks, std::uint64_t(1));
        QVERIFY(bench.script.clock.now() - start < 2ms);
    }

    void brokenReplyKeepsTheLineUntilItIsSilent()
    {
        Bench bench;
        bench.open();
        Duration tailAt{};
        bench.script.intercept = [&, first = true](const Bytes&) mutable {
            if (!std::exchange(first, false))
                return false;
            Bytes broken = frameOf(1, 0, {1, 2});
            broken.back() ^= 1;
            bench.script.reply(broken);
            bench.script.reply({0x55, 0x55}, 100us); // the twin has not finished
            tailAt = bench.script.wireFree;
            return true;
        };
        QVERIFY(bench.transact(Request::read(1, 56, 2)));
        QVERIFY(bench.script.sent.at(1).at >= tailAt);
    }

    void noiseAheadDoesNotCostTheReply()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply({0xFF, 0xFF, 0x01, 0x00, 0xFF});
            return false;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->attempts, 1);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        QCOMPARE(bench.counters(1).noiseBytes, std::uint64_t(5));
    }

    void replyInPieces()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            for (const std::uint8_t byte : frameOf(1, 0, {1, 2}))
                bench.script.reply({byte});
            return true;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), (Bytes{1, 2}));
    }

    void replyRunningAtTheDeadlineIsHeardOut()
    {
        Bench bench;
        bench.open();
        bench.core->setReplyDelay(0us);
        const Bytes reply = frameOf(1, 0, {1, 2});
        bench.script.intercept = [&](const Bytes&) {
            // Its first bytes come just before the deadline, 160 + 4000 µs after sending.
            const Duration now = bench.script.clock.now();
            for (std::size_t i = 0; i < reply.size(); ++i)
                bench.script.deliver(now + 4100us + Duration(10 * i), {reply[i]});
            return true;
        };
        QVERIFY(bench.transact(Request::read(1, 56, 2), 0, 4ms));
    }

    void silentServosCostNoTime_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<int>("bytes");
        Request quiet = Request::write(1, 42, {0, 8}, Repeat::Safe);
        quiet.acknowledged = false;
        QTest::newRow("response level 0") << quiet << 9;
        QTest::newRow("broadcast") << Request::action() << 6;
        QTest::newRow("reboot") << Request::reboot(1) << 6;
        QTest::newRow("sync write") << Request::syncWrite(42, {{1, {0, 8}}, {2, {0, 8}}}) << 14;
    }

    void silentServosCostNoTime()
    {
        QFETCH(const Request, request);
        QFETCH(const int, bytes);
        Bench bench;
        bench.script.intercept = [](const Bytes& frame) { return frame[4] != 0x02; };
        bench.open();
        const Duration start = bench.script.clock.now();
        const auto outcome = bench.transact(request);
        QVERIFY(outcome);
        QVERIFY(outcome->parts.empty());
        QCOMPARE(bench.script.clock.now() - start, Duration(10 * bytes));
    }

    void syncReadTakesWhoAnswers()
    {
        Bench bench;
        bench.open();
        const auto outcome = bench.transact(Request::syncRead(56, 4, {3, 9, 1}));
        QVERIFY(outcome);
        QCOMPARE(outcome->attempts, 1);
        QCOMPARE(outcome->parts.size(), std::size_t(2));
        QCOMPARE(outcome->parts[0].id, 3);
        QCOMPARE(outcome->parts[0].data, tableBytes(3, 56, 4));
        QCOMPARE(outcome->parts[1].id, 1);
        QCOMPARE(outcome->parts[1].data, tableBytes(1, 56, 4));
        QCOMPARE(bench.counters(9).timeOuts, std::uint64_t(1));
        QCOMPARE(bench.counters(1).ok, std::uint64_t(1));
    }

    void syncReadOfAllPresentEndsWithTheLastByte()
    {
        Bench bench;
        bench.open();
        QCOMPARE(bench.timed(Request::syncRead(56, 4, {3, 2, 1})), Duration(110 + 3 * 100));
    }

    void syncReadOfNobodyIsNoAnswer()
    {
        Bench bench;
        bench.open();
        const auto outcome = bench.transact(Request::syncRead(56, 4, {8, 9}));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoAnswer);
    }

    void idWriteAcknowledgedFromTheNewId()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply(frameOf(7, 0, {}));
            return true;
        };
        Request request = Request::write(1, 5, {7}, Repeat::Never);
        request.answersAs = 7;
        const auto outcome = bench.transact(request);
        QVERIFY(outcome);
        QCOMPARE(outcome->parts.front().id, 7);
    }

    void broadcastPingFindsAnybody()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply(frameOf(77, 0, {}));
            return true;
        };
        const auto outcome = bench.transact(Request::ping(254));
        QVERIFY(outcome);
        QCOMPARE(outcome->parts.front().id, 77);
    }

    void rawReturnsAllThatCame()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply({0x11, 0xFF});
            bench.script.reply(frameOf(1, 0, {}), 3ms);
            return true;
        };
        Bytes all{0x11, 0xFF};
        const Bytes frame = frameOf(1, 0, {});
        all.insert(all.end(), frame.begin(), frame.end());
        const auto outcome = bench.transact(Request::raw({0xFF, 0xFF, 1, 2, 1, 0xFB}));
        QVERIFY(outcome);
        QCOMPARE(outcome->parts.size(), std::size_t(1));
        QCOMPARE(outcome->data(), all);
        bench.script.intercept = nullptr;
        const auto silence = bench.transact(Request::raw({0x00}));
        QVERIFY(silence);
        QVERIFY(silence->data().empty());
    }

    void neverSpeaksIntoARunningFrame()
    {
        Bench bench;
        bench.open();
        // Another servo's frame is half in when the transaction begins.
        const Bytes frame = frameOf(99, 0, Bytes(40, 0x22));
        const Duration now = bench.script.clock.now();
        for (std::size_t i = 0; i < frame.size(); ++i)
            bench.script.deliver(now + Duration(10 * i), {frame[i]});
        const Duration end = now + Duration(10 * (frame.size() - 1));
        bench.script.clock.advance(100us);
        QVERIFY(bench.transact(Request::read(1, 56, 2)));
        QVERIFY(bench.script.sent.front().at >= end);
        QCOMPARE(bench.counters(99).foreign, std::uint64_t(1));
    }

    /// It is no silence: the error names the ID that replied instead.
    void namesTheIdThatRepliedInstead()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&bench](const Bytes&) {
            bench.script.reply(frameOf(2, 0, {0x10, 0x20}));
            return true;
        };
        const auto outcome = bench.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoAnswer);
        QCOMPARE(outcome.error().detail, QStringLiteral("from 2"));
    }

    void endlessNoiseDoesNotBlockForEver()
    {
        Bench bench;
        bench.open();
        const Duration now = bench.script.clock.now();
        for (int i = 0; i < 20'000; ++i)
            bench.script.deliver(now + Duration(50 * i), {0x55});
        const auto outcome = bench.transact(Request::read(9, 56, 2), 0);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QVERIFY(bench.script.clock.now() - now < 100ms);
    }

    void badRequestsNeverReachTheWire()
    {
        Bench bench;
        bench.open();
        const auto outcome = bench.transact(Request::read(254, 0, 9));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::BadArgument);
        QVERIFY(bench.script.sent.empty());
    }

    void rateChangesTheWireTime()
    {
        Bench bench;
        bench.open();
        QVERIFY(bench.core->setBaud(100'000));
        QCOMPARE(bench.core->baud(), 100'000);
        QCOMPARE(bench.transact(Request::read(1, 56, 15))->roundTrip, Duration(2900));
        bench.script.refusedBaud = 128'000;
        const auto refused = bench.core->setBaud(128'000);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::RateUnsupported);
        QCOMPARE(bench.core->baud(), 100'000);
        QVERIFY(bench.transact(Request::ping(1)));
    }

    void rateChangeLetsTheLastFrameLeave()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [](const Bytes&) { return true; };
        QVERIFY(bench.transact(Request::syncWrite(42, {{1, Bytes(200)}})));
        const Duration left = bench.script.wireFree;
        QVERIFY(bench.core->setBaud(500'000));
        QVERIFY(bench.script.clock.now() > left);
    }

    void lostLinkStaysLost()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) { return bench.script.cut = true; };
        const auto outcome = bench.transact(Request::write(1, 5, {2}, Repeat::Never));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LinkLost);
        QVERIFY(bench.core->lost());
        bench.script.cut = false;
        QCOMPARE(bench.transact(Request::ping(1)).error().code, ErrorCode::LinkLost);
        QCOMPARE(bench.core->listen(1ms).error().code, ErrorCode::LinkLost);
        QCOMPARE(bench.core->setBaud(500'000).error().code, ErrorCode::LinkLost);
        QCOMPARE(bench.script.sent.size(), std::size_t(1));
    }

    void listeningCollectsStrays()
    {
        Bench bench;
        bench.open();
        bench.script.deliver(bench.script.clock.now() + 5ms, frameOf(42, 4, {9}));
        const Duration start = bench.script.clock.now();
        QVERIFY(bench.core->listen(40ms));
        QCOMPARE(bench.script.clock.now() - start, Duration(40ms));
        const auto strays = bench.core->takeStrays();
        QCOMPARE(strays.size(), std::size_t(1));
        QCOMPARE(strays.front().id, 42);
        QCOMPARE(int(strays.front().status), 4);
        QCOMPARE(strays.front().data, (Bytes{9}));
        QVERIFY(bench.core->takeStrays().empty());
    }

    void traceShowsEveryFrame()
    {
        Bench bench;
        bench.open();
        bench.script.intercept = [&](const Bytes&) {
            bench.script.reply({0x13});
            bench.script.reply(frameOf(2, 0, {}));
            return false;
        };
        QVERIFY(bench.transact(Request::read(1, 56, 2)));
        std::vector<TraceKind> kinds;
        for (const TraceEntry& entry : bench.core->takeTrace())
            kinds.push_back(entry.kind);
        QCOMPARE(kinds, (std::vector{TraceKind::Sent, TraceKind::Noise, TraceKind::Foreign,
                                     TraceKind::Received}));
    }

    void wireTimeIsCounted()
    {
        Bench bench;
        bench.open();
        const Statistics before = bench.core->statistics();
        QVERIFY(bench.transact(Request::read(1, 56, 15)));
        const Statistics after = bench.core->statistics();
        QCOMPARE(after.bytesOut - before.bytesOut, std::uint64_t(8));
        QCOMPARE(after.bytesIn - before.bytesIn, std::uint64_t(21));
        QCOMPARE(after.wireTime - before.wireTime, Duration(290));
    }
};

QTEST_GUILESS_MAIN(TestBusTransact)
#include "tst_bus_transact.moc"

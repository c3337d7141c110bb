// SPDX-License-Identifier: GPL-3.0-or-later
// One transaction: what it answers, how long it waits, when it repeats, and who may speak when.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "bus_fixture.h"

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

class TestBusTransact : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void readReplies()
    {
        BusFixture fixture;
        fixture.open();
        const auto outcome = fixture.transact(Request::read(1, 56, 15));
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 15));
        QCOMPARE(outcome->attempts, 1);
        QVERIFY(outcome->faults.empty());
        QCOMPARE(outcome->roundTrip, Duration(80 + 210));
        const Counters counters = fixture.counters(1);
        QCOMPARE(counters.sent, std::uint64_t(1));
        QCOMPARE(counters.ok, std::uint64_t(1));
        QVERIFY(qAbs(counters.roundTripP50.count() - 290) <= 290 / 64);
    }

    void alarmIsData()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply(frameOf(1, 0x20, {7}));
            return true;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 1));
        QVERIFY(outcome);
        QCOMPARE(int(outcome->status()), 0x20);
        QCOMPARE(outcome->data(), (Bytes{7}));
    }

    void waitsForWireDelayAndTimeout_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<int>("baud");
        QTest::addColumn<int>("bits");
        QTest::addColumn<Duration>("replyDelay");
        QTest::addColumn<Duration>("timeout");
        QTest::addColumn<Duration>("waits");
        const auto row = [](const char* name, const Request& request, int baud, int bits,
                            Duration delay, Duration timeout, Duration waits) {
            QTest::newRow(name) << request << baud << bits << delay << timeout << waits;
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

    void waitsForWireDelayAndTimeout()
    {
        QFETCH(const Request, request);
        QFETCH(const Duration, replyDelay);
        QFETCH(const Duration, timeout);
        QFETCH(const Duration, waits);
        QFETCH(const int, baud);
        QFETCH(const int, bits);
        BusFixture fixture;
        fixture.script.baud = baud;
        fixture.open({bits, nullptr});
        fixture.core->setReplyDelay(replyDelay);
        QCOMPARE(fixture.timed(request, 0, timeout), waits);
    }

    void timeoutCanBeSet()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        fixture.core->setTimeout(100ms);
        QCOMPARE(fixture.timed(Request::ping(9)), Duration(120us + 100ms));
        fixture.core->setTimeout(10ms);
        QCOMPARE(fixture.timed(Request::ping(8)), Duration(120us + 10ms));
    }

    void lostRepliesAreRequestedAgain_data()
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

    void lostRepliesAreRequestedAgain()
    {
        QFETCH(const int, lost);
        QFETCH(const int, retries);
        QFETCH(const int, attempts);
        QFETCH(const bool, answered);
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [left = lost](const Bytes&) mutable { return left-- > 0; };
        const auto outcome = fixture.transact(Request::read(1, 56, 2), retries);
        QCOMPARE(outcome.has_value(), answered);
        QCOMPARE(int(fixture.script.sent.size()), attempts);
        QCOMPARE(int(fixture.counters(1).timeouts), lost);
        QCOMPARE(int(fixture.counters(1).retried), attempts > 1 ? 1 : 0);
        if (answered) {
            QCOMPARE(outcome->attempts, attempts);
            QCOMPARE(int(outcome->faults.size()), lost);
            QCOMPARE(outcome->faults.front().kind, FaultKind::Timeout);
            QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        } else {
            QCOMPARE(outcome.error().code, ErrorCode::NoReply);
            QCOMPARE(outcome.error().attempts, attempts);
            QCOMPARE(outcome.error().id, 1);
        }
    }

    void defaultRetriesCanBeSet()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setRetries(0);
        QVERIFY(!fixture.transact(Request::ping(9)));
        QCOMPARE(fixture.script.sent.size(), std::size_t(1));
    }

    void nonRepeatableRequestsAreNotRetried_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("relative move") << Request::write(1, 42, {0, 4}, Repeat::Never);
        QTest::newRow("calibration") << Request::calibrate(1, {}, base::ByteOrder::Little);
        QTest::newRow("restore") << Request::restore(1);
        QTest::newRow("state reset") << Request::stateReset(1);
    }

    void nonRepeatableRequestsAreNotRetried()
    {
        QFETCH(const Request, request);
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [](const Bytes&) { return true; };
        const auto outcome = fixture.transact(request, 5);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Uncertain);
        QCOMPARE(fixture.script.sent.size(), std::size_t(1));
    }

    void errorsAreDistinguished_data()
    {
        QTest::addColumn<Bytes>("answer");
        QTest::addColumn<ErrorCode>("code");
        Bytes broken = frameOf(1, 0, {1, 2});
        broken.back() ^= 0x10;
        const Bytes good = frameOf(1, 0, {1, 2});
        QTest::newRow("silence") << Bytes{} << ErrorCode::NoReply;
        QTest::newRow("wrong checksum") << broken << ErrorCode::Garbled;
        QTest::newRow("noise") << Bytes{0x00, 0x13, 0x37} << ErrorCode::Garbled;
        QTest::newRow("cut short") << Bytes(good.begin(), good.end() - 2) << ErrorCode::Garbled;
        QTest::newRow("too short a frame") << frameOf(1, 0, {1}) << ErrorCode::UnexpectedReply;
        QTest::newRow("another servo") << frameOf(2, 0, {1, 2}) << ErrorCode::NoReply;
    }

    void errorsAreDistinguished()
    {
        QFETCH(const Bytes, answer);
        QFETCH(const ErrorCode, code);
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            if (!answer.empty())
                fixture.script.reply(answer);
            return true;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, code);
    }

    void anyReceivedBytesOutweighSilence()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&, first = true](const Bytes&) mutable {
            if (std::exchange(first, false))
                fixture.script.reply({0x42});
            return true;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::Garbled);
    }

    void garbledReplyIsRetriedAtOnce()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&, first = true](const Bytes&) mutable {
            if (!std::exchange(first, false))
                return false;
            Bytes broken = frameOf(1, 0, {1, 2});
            broken.back() ^= 1;
            fixture.script.reply(broken);
            return true;
        };
        const Duration start = fixture.script.clock.now();
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->faults.front().kind, FaultKind::BadChecksum);
        QCOMPARE(fixture.counters(1).badChecksums, std::uint64_t(1));
        QVERIFY(fixture.script.clock.now() - start < 2ms);
    }

    void garbledReplyHoldsTheLineUntilSilent()
    {
        BusFixture fixture;
        fixture.open();
        Duration tailAt{};
        fixture.script.intercept = [&, first = true](const Bytes&) mutable {
            if (!std::exchange(first, false))
                return false;
            Bytes broken = frameOf(1, 0, {1, 2});
            broken.back() ^= 1;
            fixture.script.reply(broken);
            fixture.script.reply({0x55, 0x55}, 100us); // the twin has not finished
            tailAt = fixture.script.wireFreeAt;
            return true;
        };
        QVERIFY(fixture.transact(Request::read(1, 56, 2)));
        QVERIFY(fixture.script.sent.at(1).at >= tailAt);
    }

    void noiseAheadDoesNotLoseTheReply()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply({0xFF, 0xFF, 0x01, 0x00, 0xFF});
            return false;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->attempts, 1);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        QCOMPARE(fixture.counters(1).noiseBytes, std::uint64_t(5));
    }

    void replyInPieces()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            for (const std::uint8_t byte : frameOf(1, 0, {1, 2}))
                fixture.script.reply({byte});
            return true;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), (Bytes{1, 2}));
    }

    void replyInProgressAtTheDeadlineIsReceived()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        const Bytes reply = frameOf(1, 0, {1, 2});
        fixture.script.intercept = [&](const Bytes&) {
            // Its first bytes come just before the deadline, 160 + 4000 µs after sending.
            const Duration now = fixture.script.clock.now();
            for (std::size_t i = 0; i < reply.size(); ++i)
                fixture.script.deliver(now + 4100us + Duration(10 * i), {reply[i]});
            return true;
        };
        QVERIFY(fixture.transact(Request::read(1, 56, 2), 0, 4ms));
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
        BusFixture fixture;
        fixture.script.intercept = [](const Bytes& frame) { return frame[4] != 0x02; };
        fixture.open();
        const Duration start = fixture.script.clock.now();
        const auto outcome = fixture.transact(request);
        QVERIFY(outcome);
        QVERIFY(outcome->replies.empty());
        QCOMPARE(fixture.script.clock.now() - start, Duration(10 * bytes));
    }

    void syncReadReturnsWhoReplies()
    {
        BusFixture fixture;
        fixture.open();
        const auto outcome = fixture.transact(Request::syncRead(56, 4, {3, 9, 1}));
        QVERIFY(outcome);
        QCOMPARE(outcome->attempts, 1);
        QCOMPARE(outcome->replies.size(), std::size_t(2));
        QCOMPARE(outcome->replies[0].id, 3);
        QCOMPARE(outcome->replies[0].data, tableBytes(3, 56, 4));
        QCOMPARE(outcome->replies[1].id, 1);
        QCOMPARE(outcome->replies[1].data, tableBytes(1, 56, 4));
        QCOMPARE(fixture.counters(9).timeouts, std::uint64_t(1));
        QCOMPARE(fixture.counters(1).ok, std::uint64_t(1));
    }

    void syncReadOfAllPresentEndsWithTheLastByte()
    {
        BusFixture fixture;
        fixture.open();
        QCOMPARE(fixture.timed(Request::syncRead(56, 4, {3, 2, 1})), Duration(110 + 3 * 100));
    }

    void syncReadWithoutServosIsNoAnswer()
    {
        BusFixture fixture;
        fixture.open();
        const auto outcome = fixture.transact(Request::syncRead(56, 4, {8, 9}));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoReply);
    }

    void idWriteAcknowledgedFromTheNewId()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply(frameOf(7, 0, {}));
            return true;
        };
        Request request = Request::write(1, 5, {7}, Repeat::Never);
        request.alternateReplyId = 7;
        const auto outcome = fixture.transact(request);
        QVERIFY(outcome);
        QCOMPARE(outcome->replies.front().id, 7);
    }

    void broadcastPingFindsAnyServo()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply(frameOf(77, 0, {}));
            return true;
        };
        const auto outcome = fixture.transact(Request::ping(254));
        QVERIFY(outcome);
        QCOMPARE(outcome->replies.front().id, 77);
    }

    void rawReturnsAllBytes()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply({0x11, 0xFF});
            fixture.script.reply(frameOf(1, 0, {}), 3ms);
            return true;
        };
        Bytes all{0x11, 0xFF};
        const Bytes frame = frameOf(1, 0, {});
        all.insert(all.end(), frame.begin(), frame.end());
        const auto outcome = fixture.transact(Request::raw({0xFF, 0xFF, 1, 2, 1, 0xFB}));
        QVERIFY(outcome);
        QCOMPARE(outcome->replies.size(), std::size_t(1));
        QCOMPARE(outcome->data(), all);
        fixture.script.intercept = nullptr;
        const auto silence = fixture.transact(Request::raw({0x00}));
        QVERIFY(silence);
        QVERIFY(silence->data().empty());
    }

    void neverSendsDuringAnIncomingFrame()
    {
        BusFixture fixture;
        fixture.open();
        // Another servo's frame is half in when the transaction begins.
        const Bytes frame = frameOf(99, 0, Bytes(40, 0x22));
        const Duration now = fixture.script.clock.now();
        for (std::size_t i = 0; i < frame.size(); ++i)
            fixture.script.deliver(now + Duration(10 * i), {frame[i]});
        const Duration end = now + Duration(10 * (frame.size() - 1));
        fixture.script.clock.advance(100us);
        QVERIFY(fixture.transact(Request::read(1, 56, 2)));
        QVERIFY(fixture.script.sent.front().at >= end);
        QCOMPARE(fixture.counters(99).foreign, std::uint64_t(1));
    }

    /// It is no silence: the error names the ID that replied instead.
    void namesTheIdThatRepliedInstead()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&fixture](const Bytes&) {
            fixture.script.reply(frameOf(2, 0, {0x10, 0x20}));
            return true;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 2));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::NoReply);
        QCOMPARE(outcome.error().detail, QStringLiteral("from 2"));
    }

    void endlessNoiseDoesNotBlockForEver()
    {
        BusFixture fixture;
        fixture.open();
        const Duration now = fixture.script.clock.now();
        for (int i = 0; i < 20'000; ++i)
            fixture.script.deliver(now + Duration(50 * i), {0x55});
        const auto outcome = fixture.transact(Request::read(9, 56, 2), 0);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LineBusy);
        QVERIFY(fixture.script.clock.now() - now < 100ms);
    }

    void badRequestsNeverReachTheWire()
    {
        BusFixture fixture;
        fixture.open();
        const auto outcome = fixture.transact(Request::read(254, 0, 9));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::BadArgument);
        QVERIFY(fixture.script.sent.empty());
    }

    void rateChangesTheWireTime()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.core->setBaud(100'000));
        QCOMPARE(fixture.core->baud(), 100'000);
        QCOMPARE(fixture.transact(Request::read(1, 56, 15))->roundTrip, Duration(2900));
        fixture.script.refusedBaud = 128'000;
        const auto refused = fixture.core->setBaud(128'000);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::RateUnsupported);
        QCOMPARE(fixture.core->baud(), 100'000);
        QVERIFY(fixture.transact(Request::ping(1)));
    }

    void rateChangeLetsTheLastFrameLeave()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [](const Bytes&) { return true; };
        QVERIFY(fixture.transact(Request::syncWrite(42, {{1, Bytes(200)}})));
        const Duration left = fixture.script.wireFreeAt;
        QVERIFY(fixture.core->setBaud(500'000));
        QVERIFY(fixture.script.clock.now() > left);
    }

    void lostLinkStaysLost()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) { return fixture.script.cut = true; };
        const auto outcome = fixture.transact(Request::write(1, 5, {2}, Repeat::Never));
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::LinkLost);
        QVERIFY(fixture.core->lost());
        fixture.script.cut = false;
        QCOMPARE(fixture.transact(Request::ping(1)).error().code, ErrorCode::LinkLost);
        QCOMPARE(fixture.core->listen(1ms).error().code, ErrorCode::LinkLost);
        QCOMPARE(fixture.core->setBaud(500'000).error().code, ErrorCode::LinkLost);
        QCOMPARE(fixture.script.sent.size(), std::size_t(1));
    }

    void listeningCollectsStrays()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.deliver(fixture.script.clock.now() + 5ms, frameOf(42, 4, {9}));
        const Duration start = fixture.script.clock.now();
        QVERIFY(fixture.core->listen(40ms));
        QCOMPARE(fixture.script.clock.now() - start, Duration(40ms));
        const auto strays = fixture.core->takeUnexpectedFrames();
        QCOMPARE(strays.size(), std::size_t(1));
        QCOMPARE(strays.front().id, 42);
        QCOMPARE(int(strays.front().status), 4);
        QCOMPARE(strays.front().data, (Bytes{9}));
        QVERIFY(fixture.core->takeUnexpectedFrames().empty());
    }

    void traceShowsEveryFrame()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.reply({0x13});
            fixture.script.reply(frameOf(2, 0, {}));
            return false;
        };
        QVERIFY(fixture.transact(Request::read(1, 56, 2)));
        std::vector<TraceKind> kinds;
        for (const TraceEntry& entry : fixture.core->takeTrace())
            kinds.push_back(entry.kind);
        QCOMPARE(kinds, (std::vector{TraceKind::Sent, TraceKind::Noise, TraceKind::Foreign,
                                     TraceKind::Received}));
    }

    void wireTimeIsCounted()
    {
        BusFixture fixture;
        fixture.open();
        const Statistics before = fixture.core->statistics();
        QVERIFY(fixture.transact(Request::read(1, 56, 15)));
        const Statistics after = fixture.core->statistics();
        QCOMPARE(after.bytesOut - before.bytesOut, std::uint64_t(8));
        QCOMPARE(after.bytesIn - before.bytesIn, std::uint64_t(21));
        QCOMPARE(after.wireTime - before.wireTime, Duration(290));
    }
};

SERVODESK_GUILESS_TEST(TestBusTransact)
#include "tst_bus_transact.moc"

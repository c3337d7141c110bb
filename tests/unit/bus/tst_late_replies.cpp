// SPDX-License-Identifier: GPL-3.0-or-later
// Late replies and echoes: nothing that came for an earlier request, or from the host itself, is
// ever taken for an answer.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "bus_fixture.h"
#include <random>

using namespace bus;
using base::ErrorCode;
using protocol::Repeat;
using protocol::Request;
using namespace std::chrono_literals;

class TestLateReplies : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void slowAdapterNeverGivesTheWrongRegister_data()
    {
        QTest::addColumn<Duration>("latency");
        QTest::addColumn<Duration>("timeout");
        QTest::addColumn<int>("lostEvery");
        QTest::newRow("16 ms, 5 ms patience") << Duration(16ms) << Duration(5ms) << 0;
        QTest::newRow("16 ms, 4 ms patience, losses") << Duration(16ms) << Duration(4ms) << 5;
        QTest::newRow("20 ms") << Duration(20ms) << Duration(1ms) << 0;
        QTest::newRow("40 ms, default patience") << Duration(40ms) << Duration(25ms) << 7;
        QTest::newRow("60 ms: later than the pause") << Duration(60ms) << Duration(25ms) << 0;
        QTest::newRow("150 ms: later than all tries") << Duration(150ms) << Duration(25ms) << 0;
        QTest::newRow("150 ms, losses") << Duration(150ms) << Duration(25ms) << 7;
    }

    void slowAdapterNeverGivesTheWrongRegister()
    {
        QFETCH(const Duration, latency);
        QFETCH(const Duration, timeout);
        QFETCH(const int, lostEvery);
        for (const bool adaptive : {true, false}) {
            BusFixture fixture;
            fixture.open();
            fixture.script.latency = latency;
            fixture.core->setTimeout(timeout);
            int count = 0;
            fixture.script.intercept = [&](const Bytes&) {
                return lostEvery > 0 && ++count % lostEvery == 0;
            };
            int wrong = 0;
            int right = 0;
            for (int i = 0; i < 400; ++i) {
                const int address = i % 2 == 0 ? 56 : 62;
                const auto outcome = fixture.transact(Request::read(1, address, 2), 2,
                                                      adaptive ? Duration{} : timeout);
                if (!outcome)
                    continue;
                (outcome->data() == tableBytes(1, address, 2) ? right : wrong) += 1;
            }
            QCOMPARE(wrong, 0);
            if (adaptive)
                QVERIFY2(right >= 390, "the bus learns how patient it has to be");
        }
    }

    void noRequestToTheSameServoAfterATimeout_data()
    {
        QTest::addColumn<Request>("next");
        QTest::addColumn<bool>("waits");
        QTest::newRow("same servo") << Request::ping(9) << true;
        QTest::newRow("another servo") << Request::ping(1) << false;
        QTest::newRow("broadcast") << Request::action() << true;
        QTest::newRow("raw") << Request::raw({0xFF}) << true;
        QTest::newRow("sync read with it") << Request::syncRead(56, 2, {1, 9}) << true;
        QTest::newRow("sync read without") << Request::syncRead(56, 2, {1, 2}) << false;
        QTest::newRow("sync write with it") << Request::syncWrite(42, {{9, {0, 8}}}) << true;
        QTest::newRow("sync write without") << Request::syncWrite(42, {{1, {0, 8}}}) << false;
    }

    void noRequestToTheSameServoAfterATimeout()
    {
        QFETCH(const Request, next);
        QFETCH(const bool, waits);
        for (const Duration timeout : {Duration(5ms), Duration(60ms)}) {
            BusFixture fixture;
            fixture.open();
            fixture.core->setTimeout(timeout);
            QVERIFY(!fixture.transact(Request::read(9, 56, 2), 0));
            const Duration timedOut = fixture.script.clock.now();
            static_cast<void>(fixture.transact(next, 0));
            const Duration pause = fixture.script.sent.at(1).at - timedOut;
            QCOMPARE(pause, waits ? std::max<Duration>(20ms, timeout) : Duration{});
        }
    }

    void lateReplyIsCountedKeptAndMeasured()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        fixture.core->setTimeout(5ms);
        fixture.script.latency = 16ms;
        QVERIFY(!fixture.transact(Request::ping(1), 0));
        QVERIFY(fixture.core->listen(20ms));
        QCOMPARE(fixture.counters(1).late, std::uint64_t(1));
        QCOMPARE(fixture.counters(1).foreign, std::uint64_t(0));
        const auto strays = fixture.core->takeUnexpectedFrames();
        QCOMPARE(strays.size(), std::size_t(1));
        QCOMPARE(strays.front().id, 1);
        QCOMPARE(fixture.core->statistics().timeout, Duration(24ms));
        QVERIFY2(fixture.transact(Request::ping(1), 0), "now patient enough");
    }

    /// As on a computer that is busy for a moment, on a link that has been prompt until then.
    void aStallIsNoSilence_data()
    {
        QTest::addColumn<Duration>("stall");
        QTest::addColumn<bool>("answered");
        QTest::newRow("shorter than the attempts") << Duration(90ms) << true;
        QTest::newRow("longer than prompt attempts") << Duration(200ms) << true;
        QTest::newRow("later than any adapter") << Duration(450ms) << true;
        QTest::newRow("ends while the next is asked") << Duration(650ms) << false;
        QTest::newRow("longer than any stall") << Duration(800ms) << false;
    }
    void aStallIsNoSilence()
    {
        QFETCH(const Duration, stall);
        QFETCH(const bool, answered);
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.transact(Request::ping(1), 2));
        const Duration began = fixture.script.clock.now();
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.latency =
                std::max(Duration(0), began + stall - fixture.script.clock.now());
            return false;
        };
        for (const int address : {56, 62}) {
            const auto outcome = fixture.transact(Request::read(1, address, 2), 2);
            if (outcome)
                QCOMPARE(outcome->data(), tableBytes(1, address, 2));
            if (address == 62)
                break; // the stall may have ended
            QCOMPARE(outcome.has_value(), answered);
            if (!answered)
                QCOMPARE(outcome.error().code, ErrorCode::NoReply);
            if (!answered) // an absent servo costs no more than this
                QVERIFY(fixture.script.clock.now() - began < 700ms);
        }
    }

    /// Requests that were held back and sent in one go collide with the replies.
    void aDamagedLateReplyIsNoSilence()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.transact(Request::ping(1), 2));
        int sent = 0;
        fixture.script.intercept = [&](const Bytes&) {
            if (++sent == 3)
                fixture.script.deliver(fixture.script.clock.now() + 300ms, {4, 5, 1, 0, 0, 4});
            return sent <= 3;
        };
        QVERIFY(fixture.transact(Request::read(1, 56, 2), 2));
        QCOMPARE(sent, 4);
    }

    /// A search, the check after an emergency stop and a reconnect ask many that are not there.
    void onlyTheLastAttemptIsPatient()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.transact(Request::ping(1), 2));
        const auto silence = [&](int retries, Duration timeout) {
            const Duration began = fixture.script.clock.now();
            (void)fixture.transact(Request::ping(9), retries, timeout);
            return fixture.script.clock.now() - began;
        };
        QVERIFY(silence(0, {}) < 60ms);
        QVERIFY(fixture.core->listen(300ms));
        QVERIFY(silence(2, 20ms) < 150ms);
        QVERIFY(fixture.core->listen(300ms));
        QVERIFY(silence(2, {}) > 500ms);
        QVERIFY(fixture.core->listen(300ms));
        const Duration began = fixture.script.clock.now();
        Transaction quick;
        quick.request = Request::ping(9);
        quick.retries = 2;
        quick.patient = false;
        QVERIFY(!fixture.core->transact(quick));
        QVERIFY(fixture.script.clock.now() - began < 150ms);
    }

    /// A servo that is unplugged while many of its registers are written.
    void aProvenSilenceIsNotWaitedForAgain()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.transact(Request::ping(1), 2));
        fixture.script.tables.erase(1);
        const auto span = [&](int id) {
            static_cast<void>(fixture.core->listen(300ms));
            return fixture.timed(Request::ping(id), 2);
        };
        QVERIFY(span(1) > 500ms);
        QVERIFY(span(1) < 150ms);
        QVERIFY2(span(9) > 500ms, "another one");
        QVERIFY(fixture.core->listen(2s));
        QVERIFY2(span(1) > 500ms, "it may have been plugged in again");
        QVERIFY(span(1) < 150ms);
        QVERIFY(fixture.core->setBaud(500'000));
        QVERIFY2(span(1) > 500ms, "at another rate");
        fixture.script.tables[1] = sequentialTable(1);
        QVERIFY(span(1) < 50ms);
        fixture.script.tables.erase(1);
        QVERIFY2(span(1) > 500ms, "it has replied since");
    }

    /// Whether it was carried out must be read as patiently as if nothing had been lost.
    void aLostWriteProvesNoSilence()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(fixture.transact(Request::ping(1), 2));
        fixture.script.tables.erase(1);
        QVERIFY(fixture.timed(Request::write(1, 42, {0, 8}, protocol::Repeat::Safe), 2) > 500ms);
        static_cast<void>(fixture.core->listen(300ms));
        QVERIFY(fixture.timed(Request::read(1, 64, 1), 2) > 500ms);
    }

    void repliesInTimeAreMeasuredToo()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        fixture.script.latency = 20ms;
        QVERIFY(fixture.transact(Request::ping(1)));
        QCOMPARE(fixture.core->statistics().timeout, Duration(30ms));
        fixture.script.latency = 0ms;
        QVERIFY(fixture.transact(Request::ping(1)));
        QCOMPARE(fixture.core->statistics().timeout, Duration(30ms));
    }

    void explicitTimeoutIsUnchanged()
    {
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        fixture.script.latency = 20ms;
        QVERIFY(fixture.transact(Request::ping(1)));
        QCOMPARE(fixture.timed(Request::ping(9), 0, 4ms), Duration(120us + 4ms));
    }

    void implausibleLatencyIsIgnored()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(!fixture.transact(Request::ping(9), 0));
        fixture.script.deliver(fixture.script.clock.now() + 900ms, frameOf(9, 0, {}));
        QVERIFY(fixture.core->listen(1s));
        QCOMPARE(fixture.counters(9).late, std::uint64_t(1));
        QCOMPARE(fixture.core->statistics().timeout, Duration(25ms));
    }

    void firstReplyMeasuresTheLink_data()
    {
        QTest::addColumn<Duration>("latency");
        for (const int ms : {0, 20, 40, 60, 100, 150})
            QTest::addRow("%d ms", ms) << Duration(ms * 1ms);
    }

    /// Whatever was asked in vain before, in other languages too.
    void firstReplyMeasuresTheLink()
    {
        QFETCH(const Duration, latency);
        BusFixture fixture;
        fixture.open();
        fixture.core->setReplyDelay(0us);
        fixture.script.latency = latency;
        QCOMPARE(fixture.core->maxReplyLateness(), LateReplyGuard::maxLateness);
        static_cast<void>(fixture.transact(Request::read(1, 56, 2), 0));
        static_cast<void>(fixture.transact(Request::ping(1).in(base::Protocol::Modbus), 0));
        for (int i = 0; i < 20; ++i) {
            const int address = i % 2 == 0 ? 56 : 62;
            const auto outcome = fixture.transact(Request::read(1, address, 2));
            QVERIFY(outcome);
            QCOMPARE(outcome->data(), tableBytes(1, address, 2));
        }
        // A reply that was lost in the other language may make it look later than it is.
        const Duration learnt = fixture.core->maxReplyLateness();
        QVERIFY(learnt >= std::max<Duration>(25ms, latency * 3 / 2));
        QVERIFY(learnt <= (latency > 25ms ? LateReplyGuard::maxLateness * 3 / 2 : 30ms));
    }

    void silenceOfOthersIsNotMeasured()
    {
        BusFixture fixture;
        fixture.open();
        QVERIFY(!fixture.transact(Request::ping(9)));
        QCOMPARE(fixture.core->maxReplyLateness(), LateReplyGuard::maxLateness);
        QVERIFY(fixture.transact(Request::ping(1)));
        QCOMPARE(fixture.core->maxReplyLateness(), Duration(25ms));
        fixture.core->setTimeout(200ms);
        QCOMPARE(fixture.core->maxReplyLateness(), Duration(200ms));
        fixture.core->setTimeout(5ms);
        QCOMPARE(fixture.core->maxReplyLateness(), Duration(25ms));
    }

    void lateRepliesOfAScanNameTheirServo()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.latency = 16ms;
        int answered = 0;
        for (int id = 0; id <= 20; ++id)
            answered += fixture.transact(Request::ping(id), 0, 4ms) ? 1 : 0;
        QVERIFY(fixture.core->listen(40ms));
        QCOMPARE(answered, 0);
        std::vector<int> ids;
        for (const UnexpectedFrame& stray : fixture.core->takeUnexpectedFrames())
            ids.push_back(stray.id);
        QCOMPARE(ids, (std::vector{1, 2, 3}));
        QCOMPARE(fixture.core->statistics().total.late, std::uint64_t(3));
    }

    void badLineNeverGivesAWrongValue_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    /// Dropped, damaged, cut, late and garbage-led replies: right or honestly failed.
    void badLineNeverGivesAWrongValue()
    {
        QFETCH(const unsigned, seed);
        std::mt19937 random(seed);
        const auto chance = [&](unsigned percent) { return random() % 100 < percent; };
        BusFixture fixture;
        fixture.open();
        fixture.script.intercept = [&](const Bytes& request) {
            const int id = request[2];
            Bytes reply = frameOf(id, 0, tableBytes(id, request[5], request[6]));
            if (chance(5))
                return true;
            if (chance(4))
                reply[random() % reply.size()] ^= std::uint8_t(1U << random() % 8);
            if (chance(4))
                reply.resize(random() % reply.size());
            if (chance(4)) {
                Bytes garbage(1 + random() % 12);
                for (auto& byte : garbage)
                    byte = chance(50) ? 0xFF : std::uint8_t(random());
                fixture.script.reply(garbage);
            }
            fixture.script.reply(reply, chance(4) ? Duration(30ms) : Duration{});
            return true;
        };
        int right = 0;
        for (int i = 0; i < 2000; ++i) {
            const int id = 1 + int(random() % 3);
            const int address = 40 + int(random() % 30);
            const auto outcome = fixture.transact(Request::read(id, address, 2));
            if (!outcome)
                continue;
            QCOMPARE(outcome->data(), tableBytes(id, address, 2));
            ++right;
        }
        QVERIFY2(right > 1900, QByteArray::number(right).constData());
    }

    void requestsPauseAfterRawBytes()
    {
        BusFixture fixture;
        fixture.open();
        fixture.script.latency = 40ms;
        // The answer to a raw READ comes after the raw transaction has ended.
        QVERIFY(fixture.transact(Request::raw(frameOf(1, 2, {56, 2}))));
        const auto outcome = fixture.transact(Request::read(1, 62, 2));
        QVERIFY(!outcome || outcome->data() == tableBytes(1, 62, 2));
    }

    void echoIsDetected_data()
    {
        QTest::addColumn<bool>("echo");
        QTest::addColumn<int>("lostFirst");
        QTest::addColumn<bool>("garbleFirst");
        QTest::addColumn<Duration>("latency");
        QTest::newRow("no echo") << false << 0 << false << Duration{};
        QTest::newRow("echo") << true << 0 << false << Duration{};
        QTest::newRow("echo, 16 ms adapter") << true << 0 << false << Duration(16ms);
        for (const Duration latency : {40ms, 60ms, 100ms, 150ms, 240ms}) {
            QTest::addRow("echo, %d ms adapter", int(latency / 1ms))
                << true << 0 << false << latency;
        }
        QTest::newRow("no echo, 60 ms adapter") << false << 0 << false << Duration(60ms);
        QTest::newRow("echo, first frame lost, 60 ms adapter")
            << true << 1 << false << Duration(60ms);
        QTest::newRow("echo, first frame lost") << true << 1 << false << Duration{};
        QTest::newRow("echo, first one garbled") << true << 0 << true << Duration{};
        QTest::newRow("no echo, noise at first") << false << 0 << true << Duration{};
    }

    void echoIsDetected()
    {
        QFETCH(const bool, echo);
        QFETCH(const int, lostFirst);
        QFETCH(const bool, garbleFirst);
        QFETCH(const Duration, latency);
        BusFixture fixture;
        fixture.script.latency = latency;
        fixture.script.echo = echo && lostFirst == 0 && !garbleFirst;
        int frames = 0;
        fixture.script.intercept = [&](const Bytes& frame) {
            if (garbleFirst && frames == 0)
                fixture.script.reply(Bytes(frame.begin(), frame.begin() + 4));
            fixture.script.echo = echo;
            ++frames;
            return true;
        };
        fixture.open();
        QCOMPARE(fixture.core->hasEcho(), echo);
    }

    void echoIsNeverAReply_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<bool>("present");
        QTest::newRow("ping 1, whose echo is a valid reply") << Request::ping(1) << false;
        QTest::newRow("ping 1, answered") << Request::ping(1) << true;
        QTest::newRow("read of 2, echo of equal length") << Request::read(1, 56, 2) << false;
        QTest::newRow("read of 2, answered") << Request::read(1, 56, 2) << true;
        QTest::newRow("sync read") << Request::syncRead(56, 2, {1, 2}) << true;
        QTest::newRow("write of nothing much")
            << Request::write(1, 42, {0, 8}, Repeat::Safe) << true;
    }

    void echoIsNeverAReply()
    {
        QFETCH(const Request, request);
        QFETCH(const bool, present);
        for (const Duration latency : {0ms, 16ms, 40ms, 60ms, 150ms}) {
            BusFixture fixture;
            fixture.script.echo = true;
            fixture.script.latency = latency;
            fixture.open();
            QVERIFY(fixture.core->hasEcho());
            if (!present)
                fixture.script.tables.clear();
            const auto outcome = fixture.transact(request, 0);
            QCOMPARE(outcome.has_value(), present);
            if (present)
                QCOMPARE(int(outcome->status()), 0);
            if (request.op == protocol::Op::Read && present)
                QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        }
    }

    void echoesOfUnansweredFramesAreDroppedLater()
    {
        BusFixture fixture;
        fixture.script.echo = true;
        fixture.script.latency = 16ms;
        fixture.open();
        for (int i = 0; i < 3; ++i)
            QVERIFY(fixture.transact(Request::syncWrite(42, {{1, {0, 8}}})));
        const auto outcome = fixture.transact(Request::read(1, 56, 2), 0);
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 2));
        QCOMPARE(fixture.core->statistics().total.foreign, std::uint64_t(0));
    }

    void damagedEchoIsDroppedByItsLength()
    {
        BusFixture fixture;
        fixture.script.echo = true;
        fixture.open();
        fixture.script.echo = false;
        fixture.script.intercept = [&](const Bytes& frame) {
            Bytes damaged = frame;
            damaged[3] ^= 0x40;
            fixture.script.deliver(fixture.script.wireFreeAt, damaged);
            return false;
        };
        const auto outcome = fixture.transact(Request::read(1, 56, 15), 0);
        QVERIFY(outcome);
        QCOMPARE(outcome->data(), tableBytes(1, 56, 15));
    }

    void lateFrameAheadOfAnEchoDoesNotShiftIt()
    {
        BusFixture fixture;
        fixture.script.echo = true;
        fixture.open();
        fixture.script.tables.erase(1);
        // Six bytes of another servo come just after the host has begun to send PING 1.
        fixture.script.intercept = [&](const Bytes&) {
            fixture.script.deliver(fixture.script.clock.now() + 10us, frameOf(7, 0, {}));
            return true;
        };
        QVERIFY(!fixture.transact(Request::ping(1), 0));
        QCOMPARE(fixture.counters(7).foreign, std::uint64_t(1));
    }
};

SERVODESK_GUILESS_TEST(TestLateReplies)
#include "tst_late_replies.moc"

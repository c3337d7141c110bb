// SPDX-License-Identifier: GPL-3.0-or-later
// What is received when rates differ or two servos send at once: levels combine, low wins.
#include "sim/bus/uart_receiver.h"
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;
using sim::Burst;
using sim::RxFilter;
using sim::UartReceiver;
using sim::WireLine;

namespace {
struct Byte {
    std::uint8_t value;
    bool framed;
    bool operator==(const Byte&) const = default;
};

std::vector<Byte> listen(const WireLine& line, int baud, RxFilter filter = RxFilter::All)
{
    UartReceiver receiver(filter, baud, 0);
    std::vector<Byte> bytes;
    while (const auto received = receiver.peek(line)) {
        receiver.take(*received);
        bytes.push_back({received->value, received->framed});
    }
    return bytes;
}
} // namespace

class TestWireCollisions : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyByteIsReceivedAtTheRightRate()
    {
        Bytes all(256);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint8_t>(i);
        WireLine line;
        line.transmit(Burst(0, 1000, 115'200, all));
        const auto received = listen(line, 115'200);
        QCOMPARE(received.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            QVERIFY((received[i] == Byte{all[i], true}));
    }

    // 2.4 % apart: less than half a bit at the end of a byte, so real receivers manage, too.
    void nearbyRatesAreCompatible()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 256'000, {0x00, 0x55, 0xFF, 0x01, 0x80}));
        const std::vector<Byte> expected{
            {0x00, true}, {0x55, true}, {0xFF, true}, {0x01, true}, {0x80, true}};
        QVERIFY(listen(line, 250'000) == expected);
    }

    // 0x00 at half the listener's rate: start bit and eight low bits last 18 of its bits.
    void aSlowSenderCausesFramingErrors()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 500'000, {0x00}));
        QVERIFY((listen(line, 1'000'000) == std::vector<Byte>{{0x00, false}}));
    }

    // Nine low bits of the speaker last four and a half of the listener's: start bit and three.
    void aFastSenderIsReceivedAsOtherBytes()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 1'000'000, {0x00}));
        QVERIFY((listen(line, 500'000) == std::vector<Byte>{{0xF8, true}}));
    }

    // The only low bit of 0xFF is over before a listener at an eighth of the rate looks again.
    void aShortPulseIsNoStartBit()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 1'000'000, {0xFF}));
        QVERIFY(listen(line, 125'000).empty());
    }

    void simultaneousBytesCombineLowWins_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::newRow("all and nothing") << 0xFF << 0x00;
        QTest::newRow("complements") << 0xAA << 0x55;
        QTest::newRow("equal") << 0x3C << 0x3C;
        QTest::newRow("overlap") << 0xF3 << 0x3F;
    }
    void simultaneousBytesCombineLowWins()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        WireLine line;
        line.transmit(Burst(0, 0, 1'000'000, {static_cast<std::uint8_t>(first)}));
        line.transmit(Burst(1, 0, 1'000'000, {static_cast<std::uint8_t>(second)}));
        const auto expected = static_cast<std::uint8_t>(first & second);
        QVERIFY((listen(line, 1'000'000) == std::vector<Byte>{{expected, true}}));
    }

    // The second speaker starts two bits later: its start bit blanks data bit 1 of the first.
    void offsetBytesCombineBitByBit()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 1'000'000, {0xFF}));
        line.transmit(Burst(1, 2000, 1'000'000, {0xFF}));
        QVERIFY((listen(line, 1'000'000) == std::vector<Byte>{{0xFD, true}}));
    }

    void cleanBytesAroundACollisionSurvive()
    {
        WireLine line;
        line.transmit(Burst(0, 0, 1'000'000, {0x11, 0xFF, 0x33}));
        line.transmit(Burst(1, 10'000, 1'000'000, {0x0F}));
        const std::vector<Byte> expected{{0x11, true}, {0x0F, true}, {0x33, true}};
        QVERIFY(listen(line, 1'000'000) == expected);
    }

    void receiversGetOnlyTheirSenders()
    {
        WireLine line;
        line.transmit(Burst(sim::hostSender, 0, 1'000'000, {0x11}));
        line.transmit(Burst(0, 20'000, 1'000'000, {0x22}));
        QVERIFY((listen(line, 1'000'000, RxFilter::Host) == std::vector<Byte>{{0x11, true}}));
        QVERIFY((listen(line, 1'000'000, RxFilter::Servos) == std::vector<Byte>{{0x22, true}}));
        QCOMPARE(listen(line, 1'000'000, RxFilter::All).size(), std::size_t{2});
    }

    void aServoAtAnotherRateReceivesNothing_data()
    {
        QTest::addColumn<int>("hostBaud");
        for (const int baud : {1'000'000, 500'000, 250'000, 57'600, 9'600})
            QTest::addRow("%d", baud) << baud;
    }
    void aServoAtAnotherRateReceivesNothing()
    {
        QFETCH(int, hostBaud);
        const auto bus = wire::bus("sts3215@1:115200");
        Duration now = 1ms;
        bus->hostReads(now);
        for (int attempt = 0; attempt < 5; ++attempt)
            QVERIFY(wire::ask(*bus, wire::ping(1), now, hostBaud).empty());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now, 115'200), 1));
    }

    void aHostAtAnotherRateGetsGarbage()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        bus->hostWrites(wire::read(1, 0, 5), 1'000'000, now);
        bus->setHostBaud(500'000);
        now += 10ms;
        const Bytes received = bus->hostReads(now);
        QVERIFY(!received.empty());
        QVERIFY(!wire::isStatusOf(received, 1));
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::read(1, 0, 5), now), 1));
    }

    void mixedRatesDoNotDisturbEachOther()
    {
        const auto bus = wire::bus("sts3215@1:1000000,sts3250@2:500000,sm40blhv@3:115200");
        Duration now = 1ms;
        bus->hostReads(now);
        const std::vector<std::pair<std::uint8_t, int>> servos{
            {1, 1'000'000}, {2, 500'000}, {3, 115'200}};
        for (int round = 0; round < 3; ++round) {
            for (const auto& [id, baud] : servos) {
                for (const auto& [other, otherBaud] : servos)
                    QCOMPARE(!wire::ask(*bus, wire::ping(id), now, otherBaud).empty(), id == other);
            }
        }
    }

    // Same ID, same reply, same instant: two equal replies look like one.
    void duplicatesWithEqualRepliesLookLikeOneServo()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    void differingDuplicatesCorruptEachOther()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@1");
        bus->servos()[0]->poke(QStringLiteral("position_p"), 0x1E);
        bus->servos()[1]->poke(QStringLiteral("position_p"), 0x2D);
        Duration now = 1ms;
        bus->hostReads(now);
        const Bytes received = wire::ask(*bus, wire::read(1, 21, 1), now);
        const Bytes one = wire::frame(1, 0, {0x1E});
        const Bytes other = wire::frame(1, 0, {0x2D});
        QCOMPARE(received.size(), one.size());
        for (std::size_t i = 0; i < received.size(); ++i)
            QCOMPARE(int{received[i]}, one[i] & other[i]);
        QVERIFY(!wire::isStatusOf(received, 1));
    }

    void aHostSendingIntoAReplyCorruptsBoth()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@2");
        Duration now = 1ms;
        bus->hostReads(now);
        bus->hostWrites(wire::read(1, 0, 40), 1'000'000, now);
        const Duration replying = now + 80us + bus->servo(1)->replyDelay() + 105us;
        bus->hostWrites(wire::ping(2), 1'000'000, replying);
        const Bytes received = bus->hostReads(now + 10ms);
        QVERIFY(!received.empty());
        QVERIFY(!wire::isStatusOf(received, 1));
        // Servo 2 received its ping through the reply of servo 1, which is no ping.
        QVERIFY(received.size() <= 46);
        now += 50ms;
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(2), now), 2));
    }

    void aServoUnresponsiveWhileWriting()
    {
        const auto bus = wire::bus("sts3215@1+deaf=1");
        Duration now = 1ms;
        bus->hostReads(now);
        wire::ask(*bus, wire::write(1, 55, 0), now);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::write(1, 21, 40), now, 1'000'000, 1ms), 1));
        QVERIFY(wire::ask(*bus, wire::ping(1), now, 1'000'000, 1ms).empty());
        now += 20ms;
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    // A servo that is deaf at the start of a frame has not received it.
    void aServoMissesTheRestOfAFrame()
    {
        const auto bus = wire::bus("sts3215@1+deaf=1", 4'800 * 8); // 38400: a ping takes 1.6 ms
        Duration now = 1ms;
        bus->hostReads(now);
        wire::ask(*bus, wire::write(1, 55, 0), now, 38'400);
        bus->hostWrites(wire::write(1, 21, 40), 38'400, now);
        while (!bus->servo(1)->isDeaf())
            bus->hostReads(now += 100us);
        while (bus->servo(1)->isDeaf()) {
            const Duration at = now;
            bus->hostWrites(wire::ping(1), 38'400, at);
            bus->hostReads(now += 1700us);
        }
        QVERIFY(!bus->nextHostRun(now + 10ms));
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now, 38'400), 1));
    }

    void servosFindTheRequestAfterNoise_data()
    {
        QTest::addColumn<QByteArray>("rubbish");
        QTest::newRow("noise") << QByteArray::fromHex("0055aa17");
        QTest::newRow("header bytes") << QByteArray::fromHex("ffffff");
        QTest::newRow("wrong checksum") << QByteArray::fromHex("ffff01020100");
        QTest::newRow("another servo's reply") << QByteArray::fromHex("ffff020200fb");
    }
    void servosFindTheRequestAfterNoise()
    {
        QFETCH(QByteArray, rubbish);
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        Bytes request(rubbish.begin(), rubbish.end());
        const Bytes ping = wire::ping(1);
        request.insert(request.end(), ping.begin(), ping.end());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, request, now), 1));
    }

    void anIncompleteRequestIsDroppedAfterASilence()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::ask(*bus, {0xFF, 0xFF, 0x01, 0x40, 0x03}, now).empty());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    void repliesOfOthersDoNotConfuse()
    {
        // The reply of servo 3 with alarm bits looks like an instruction when it is read as
        // one.
        const auto bus = wire::bus("sts3215@3,sts3215@4");
        bus->servo(3)->injectStatus(0x02);
        Duration now = 1ms;
        bus->hostReads(now);
        const Bytes reply = wire::ask(*bus, wire::ping(3), now);
        QVERIFY(wire::isStatusOf(reply, 3));
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(4), now), 4));
    }
};

SERVODESK_GUILESS_TEST(TestWireCollisions)
#include "tst_wire_collisions.moc"

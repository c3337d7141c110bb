// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to requests that reach a servo while it writes its EPROM: they wait in its receive
// buffer, as the programs of the field rely on.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QtTest>

#include "wire_fixture.h"

using base::Bytes;
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int rate = 1'000'000;

/// A bus whose servos have their locks open, at 1 ms.
struct Fixture {
    std::unique_ptr<sim::VirtualBus> bus;
    Duration now = 1ms;

    explicit Fixture(const char* servos, const sim::WireConfig& config = {})
        : bus(wire::bus(servos, {}, config))
    {
        bus->hostReads(now);
        for (sim::VirtualServo* servo : bus->servos())
            servo->poke(QStringLiteral("lock"), 0);
    }
    void send(const Bytes& request) { bus->hostWrites(request, rate, now); }
    Bytes receive(Duration span) { return bus->hostReads(now += span); }
    int at(int id, std::uint8_t address)
    {
        const Bytes reply = wire::ask(*bus, wire::read(std::uint8_t(id), address, 1), now);
        return reply.size() == 7 ? reply[5] : -1;
    }
};

const Bytes acknowledged = wire::frame(1, 0);
} // namespace

class TestBusyServo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theReplyFollowsTheWrite()
    {
        Fixture fixture("sts3215@1+eprom-ms=20");
        fixture.send(wire::write(1, 21, 40));
        QVERIFY(fixture.receive(20ms).empty());
        QCOMPARE(fixture.receive(1ms), acknowledged);
        fixture.send(wire::write(1, 41, 40)); // RAM costs no time
        QCOMPARE(fixture.receive(1ms), acknowledged);
    }

    void requestsWaitForTheirTurn()
    {
        Fixture fixture("sts3215@1");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::write(1, 22, 41));
        fixture.send(wire::read(1, 21, 2));
        fixture.send(wire::write(1, 23, 42));
        QCOMPARE(fixture.receive(50ms), wire::joined({acknowledged, acknowledged,
                                                      wire::frame(1, 0, {40, 41}), acknowledged}));
        QCOMPARE(fixture.at(1, 23), 42);
    }

    // Nothing polls the bus: it reports when the next bytes come.
    void waitingForBytesFindsEveryReply()
    {
        Fixture fixture("sts3215@1");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::write(1, 22, 41));
        Bytes received;
        const Duration end = fixture.now + 100ms;
        while (const auto due = fixture.bus->nextHostRun(end)) {
            QVERIFY(*due > fixture.now || received.empty());
            const Bytes more = fixture.bus->hostReads(fixture.now = *due);
            received.insert(received.end(), more.begin(), more.end());
        }
        QCOMPARE(received, wire::joined({acknowledged, acknowledged}));
        QVERIFY(fixture.now < 1ms + 13ms);
    }

    void othersReplyMeanwhile()
    {
        Fixture fixture("sts3215@1+eprom-ms=20,sts3215@2");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::ping(2));
        QCOMPARE(fixture.receive(10ms), wire::frame(2, 0));
        QCOMPARE(fixture.receive(20ms), acknowledged);
    }

    void anUnansweredWriteKeepsItBusyToo_data()
    {
        QTest::addColumn<Bytes>("request");
        QTest::newRow("broadcast") << wire::write(0xFE, 21, 40);
        QTest::newRow("sync write") << wire::frame(0xFE, 0x83, {21, 1, 1, 40});
    }
    void anUnansweredWriteKeepsItBusyToo()
    {
        QFETCH(Bytes, request);
        Fixture fixture("sts3215@1+eprom-ms=20");
        fixture.send(request);
        fixture.send(wire::read(1, 21, 1));
        QVERIFY(fixture.receive(20ms).empty());
        QCOMPARE(fixture.receive(2ms), wire::frame(1, 0, {40}));
    }

    void theNextRequestMayUseTheNewId()
    {
        Fixture fixture("sts3215@1");
        fixture.send(wire::write(1, 5, 9));
        fixture.send(wire::write(9, 55, 1));
        fixture.send(wire::ping(1));
        QCOMPARE(fixture.receive(50ms), wire::joined({acknowledged, wire::frame(9, 0)}));
    }

    void aSyncReadWaitsAsWell()
    {
        Fixture fixture("sts3215@1,sts3215@2");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::frame(0xFE, 0x82, {21, 1, 1, 2}));
        const Bytes received = fixture.receive(50ms);
        QCOMPARE(received.size(), std::size_t(7 + 6 + 7));
        QCOMPARE(Bytes(received.end() - 7, received.end()), wire::frame(1, 0, {40}));
    }

    // 256 bytes: 32 requests of 8 bytes, for any servo; then one without room.
    void theBufferIsBounded_data()
    {
        QTest::addColumn<int>("id");
        QTest::newRow("its own requests") << 1;
        QTest::newRow("those of others") << 7;
    }
    void theBufferIsBounded()
    {
        QFETCH(int, id);
        Fixture fixture("sts3215@1+eprom-ms=20");
        fixture.send(wire::write(1, 21, 40));
        for (int i = 0; i < 31; ++i)
            fixture.send(wire::write(std::uint8_t(id), 41, std::uint8_t(i)));
        fixture.send(wire::write(1, 44, 3));
        fixture.send(wire::write(1, 46, 4)); // the 33rd
        fixture.receive(100ms);
        QCOMPARE(fixture.at(1, 44), 3);
        QVERIFY(fixture.at(1, 46) != 4);
        QCOMPARE(fixture.at(1, 41), id == 1 ? 30 : 0);
    }

    void powerOffDropsPendingRequests_data()
    {
        QTest::addColumn<bool>("unplugged");
        QTest::newRow("power cycle") << false;
        QTest::newRow("plug") << true;
    }
    void powerOffDropsPendingRequests()
    {
        QFETCH(bool, unplugged);
        Fixture fixture("sts3215@1+eprom-ms=20");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::write(1, 22, 41));
        QVERIFY(fixture.receive(5ms).empty());
        if (unplugged) {
            fixture.bus->unplug(0);
            fixture.bus->plug(0);
        } else {
            fixture.bus->powerCycle();
        }
        QVERIFY(fixture.receive(50ms).empty());
        QCOMPARE(fixture.at(1, 22), 32);
    }

    void aRestartDropsFollowingRequests()
    {
        Fixture fixture("sts3215@1+eprom-ms=20");
        fixture.send(wire::write(1, 21, 40));
        fixture.send(wire::frame(1, 0x08));
        fixture.send(wire::write(1, 41, 9));
        QCOMPARE(fixture.receive(2s), acknowledged);
        QCOMPARE(fixture.at(1, 41), 0);
    }

    void modbusAndLxWaitToo()
    {
        // Maximum angle := 3000, then read it back, each frame after its silence.
        Fixture modbus("smsmb@1+eprom-ms=20");
        const auto sendHex = [&](const char* hex) {
            const QByteArray raw = QByteArray::fromHex(hex);
            modbus.bus->hostWrites(Bytes(raw.begin(), raw.end()), 115'200, modbus.now);
            return modbus.receive(2ms);
        };
        modbus.bus->setHostBaud(115'200);
        QVERIFY(sendHex("0106000E0BB8EF4B").empty());
        QVERIFY(sendHex("0103000E0001E5C9").empty());
        const Bytes received = modbus.receive(50ms);
        const QByteArray expected = QByteArray::fromHex("0106000E0BB8EF4B");
        QCOMPARE(received.size(), std::size_t(8 + 7));
        QVERIFY(std::equal(expected.begin(), expected.end(), received.begin(),
                           [](char a, std::uint8_t b) { return std::uint8_t(a) == b; }));
        QCOMPARE(int(received[11]) << 8 | received[12], 3000);
    }

    void severalReplyToABroadcastPingInTurn()
    {
        Fixture fixture("sts3215@1+staggered-ping=1,sts3215@2+staggered-ping=1,"
                        "sts3215@6+staggered-ping=1");
        fixture.send(wire::ping(0xFE));
        // As long as lerobot listens: 252 replies, 3 ms for each, 16 ms.
        QCOMPARE(fixture.receive(15ms + 756ms + 16ms),
                 wire::joined({wire::frame(1, 0), wire::frame(2, 0), wire::frame(6, 0)}));
    }

    void severalCollideInABroadcastPingByDefault()
    {
        Fixture fixture("sts3215@1,sts3215@2");
        fixture.send(wire::ping(0xFE));
        const Bytes received = fixture.receive(800ms);
        QVERIFY(!wire::isStatusOf(received, 1) && !wire::isStatusOf(received, 2));
        QVERIFY(received.size() <= 6);
    }
};

SERVODESK_GUILESS_TEST(TestBusyServo)
#include "tst_busy_servo.moc"

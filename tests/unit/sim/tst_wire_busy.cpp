// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to requests that reach a servo while it writes its EPROM: they wait in its receive
// buffer, as the programs of the field rely on.
#include <QRegularExpression>
#include <QtTest>

#include "wire_bench.h"

using base::Bytes;
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int rate = 1'000'000;

/// A bus whose servos have their locks open, at 1 ms.
struct Bench {
    std::unique_ptr<sim::VirtualBus> bus;
    Duration now = 1ms;

    explicit Bench(const char* servos, const sim::WireConfig& config = {})
        : bus(wire::bus(servos, {}, config))
    {
        bus->hostReads(now);
        for (sim::VirtualServo* servo : bus->servos())
            servo->poke(QStringLiteral("lock"), 0);
    }
    void send(const Bytes& request) { bus->hostWrites(request, rate, now); }
    Bytes hear(Duration span) { return bus->hostReads(now += span); }
    int at(int id, std::uint8_t address)
    {
        const Bytes reply = wire::ask(*bus, wire::read(std::uint8_t(id), address, 1), now);
        return reply.size() == 7 ? reply[5] : -1;
    }
};

Bytes joined(std::initializer_list<Bytes> frames)
{
    Bytes all;
    for (const Bytes& frame : frames)
        all.insert(all.end(), frame.begin(), frame.end());
    return all;
}

const Bytes acknowledged = wire::frame(1, 0);
} // namespace

class TestWireBusy : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theAnswerComesWhenTheValueIsWritten()
    {
        Bench bench("sts3215@1+eprom-ms=20");
        bench.send(wire::write(1, 21, 40));
        QVERIFY(bench.hear(20ms).empty());
        QCOMPARE(bench.hear(1ms), acknowledged);
        bench.send(wire::write(1, 41, 40)); // RAM costs no time
        QCOMPARE(bench.hear(1ms), acknowledged);
    }

    void requestsWaitForTheirTurn()
    {
        Bench bench("sts3215@1");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::write(1, 22, 41));
        bench.send(wire::read(1, 21, 2));
        bench.send(wire::write(1, 23, 42));
        QCOMPARE(bench.hear(50ms),
                 joined({acknowledged, acknowledged, wire::frame(1, 0, {40, 41}), acknowledged}));
        QCOMPARE(bench.at(1, 23), 42);
    }

    // Nothing asks the bus to look: whoever waits for the next bytes is told when to.
    void waitingForBytesFindsEveryAnswer()
    {
        Bench bench("sts3215@1");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::write(1, 22, 41));
        Bytes heard;
        const Duration end = bench.now + 100ms;
        while (const auto due = bench.bus->nextHostRun(end)) {
            QVERIFY(*due > bench.now || heard.empty());
            const Bytes more = bench.bus->hostReads(bench.now = *due);
            heard.insert(heard.end(), more.begin(), more.end());
        }
        QCOMPARE(heard, joined({acknowledged, acknowledged}));
        QVERIFY(bench.now < 1ms + 13ms);
    }

    void othersAnswerMeanwhile()
    {
        Bench bench("sts3215@1+eprom-ms=20,sts3215@2");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::ping(2));
        QCOMPARE(bench.hear(10ms), wire::frame(2, 0));
        QCOMPARE(bench.hear(20ms), acknowledged);
    }

    void aWriteThatIsNotAnsweredKeepsItBusyToo_data()
    {
        QTest::addColumn<Bytes>("request");
        QTest::newRow("broadcast") << wire::write(0xFE, 21, 40);
        QTest::newRow("sync write") << wire::frame(0xFE, 0x83, {21, 1, 1, 40});
    }
    void aWriteThatIsNotAnsweredKeepsItBusyToo()
    {
        QFETCH(Bytes, request);
        Bench bench("sts3215@1+eprom-ms=20");
        bench.send(request);
        bench.send(wire::read(1, 21, 1));
        QVERIFY(bench.hear(20ms).empty());
        QCOMPARE(bench.hear(2ms), wire::frame(1, 0, {40}));
    }

    void theNextRequestMayUseTheNewId()
    {
        Bench bench("sts3215@1");
        bench.send(wire::write(1, 5, 9));
        bench.send(wire::write(9, 55, 1));
        bench.send(wire::ping(1));
        QCOMPARE(bench.hear(50ms), joined({acknowledged, wire::frame(9, 0)}));
    }

    void aSyncReadWaitsAsWell()
    {
        Bench bench("sts3215@1,sts3215@2");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::frame(0xFE, 0x82, {21, 1, 1, 2}));
        const Bytes heard = bench.hear(50ms);
        QCOMPARE(heard.size(), std::size_t(7 + 6 + 7));
        QCOMPARE(Bytes(heard.end() - 7, heard.end()), wire::frame(1, 0, {40}));
    }

    // 256 bytes: 32 requests of 8 bytes, whoever they are for; then one that has no room.
    void theBufferIsBounded_data()
    {
        QTest::addColumn<int>("id");
        QTest::newRow("its own requests") << 1;
        QTest::newRow("those of others") << 7;
    }
    void theBufferIsBounded()
    {
        QFETCH(int, id);
        Bench bench("sts3215@1+eprom-ms=20");
        bench.send(wire::write(1, 21, 40));
        for (int i = 0; i < 31; ++i)
            bench.send(wire::write(std::uint8_t(id), 41, std::uint8_t(i)));
        bench.send(wire::write(1, 44, 3));
        bench.send(wire::write(1, 46, 4)); // the 33rd
        bench.hear(100ms);
        QCOMPARE(bench.at(1, 44), 3);
        QVERIFY(bench.at(1, 46) != 4);
        QCOMPARE(bench.at(1, 41), id == 1 ? 30 : 0);
    }

    void powerOffForgetsWhatWaits_data()
    {
        QTest::addColumn<bool>("unplugged");
        QTest::newRow("power cycle") << false;
        QTest::newRow("plug") << true;
    }
    void powerOffForgetsWhatWaits()
    {
        QFETCH(bool, unplugged);
        Bench bench("sts3215@1+eprom-ms=20");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::write(1, 22, 41));
        QVERIFY(bench.hear(5ms).empty());
        if (unplugged) {
            bench.bus->unplug(0);
            bench.bus->plug(0);
        } else {
            bench.bus->powerCycle();
        }
        QVERIFY(bench.hear(50ms).empty());
        QCOMPARE(bench.at(1, 22), 32);
    }

    void aRestartForgetsWhatFollowsIt()
    {
        Bench bench("sts3215@1+eprom-ms=20");
        bench.send(wire::write(1, 21, 40));
        bench.send(wire::frame(1, 0x08));
        bench.send(wire::write(1, 41, 9));
        QCOMPARE(bench.hear(2s), acknowledged);
        QCOMPARE(bench.at(1, 41), 0);
    }

    void modbusAndLxWaitToo()
    {
        // Maximum angle := 3000, then read it back, each frame after its silence.
        Bench modbus("smsmb@1+eprom-ms=20");
        const auto say = [&](const char* hex) {
            const QByteArray raw = QByteArray::fromHex(hex);
            modbus.bus->hostWrites(Bytes(raw.begin(), raw.end()), 115'200, modbus.now);
            return modbus.hear(2ms);
        };
        modbus.bus->setHostBaud(115'200);
        QVERIFY(say("0106000E0BB8EF4B").empty());
        QVERIFY(say("0103000E0001E5C9").empty());
        const Bytes heard = modbus.hear(50ms);
        const QByteArray expected = QByteArray::fromHex("0106000E0BB8EF4B");
        QCOMPARE(heard.size(), std::size_t(8 + 7));
        QVERIFY(std::equal(expected.begin(), expected.end(), heard.begin(),
                           [](char a, std::uint8_t b) { return std::uint8_t(a) == b; }));
        QCOMPARE(int(heard[11]) << 8 | heard[12], 3000);
    }

    void severalAnswerABroadcastPingInTurn()
    {
        Bench bench("sts3215@1+staggered-ping=1,sts3215@2+staggered-ping=1,"
                    "sts3215@6+staggered-ping=1");
        bench.send(wire::ping(0xFE));
        // As long as lerobot listens: 252 replies, 3 ms for each, 16 ms.
        QCOMPARE(bench.hear(15ms + 756ms + 16ms),
                 joined({wire::frame(1, 0), wire::frame(2, 0), wire::frame(6, 0)}));
    }

    void severalCollideInABroadcastPingByDefault()
    {
        Bench bench("sts3215@1,sts3215@2");
        bench.send(wire::ping(0xFE));
        const Bytes heard = bench.hear(800ms);
        QVERIFY(!wire::isStatusOf(heard, 1) && !wire::isStatusOf(heard, 2));
        QVERIFY(heard.size() <= 6);
    }
};

QTEST_GUILESS_MAIN(TestWireBusy)
#include "tst_wire_busy.moc"

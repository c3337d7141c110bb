// SPDX-License-Identifier: GPL-3.0-or-later
// When bytes reach the host: 10 bits a byte at each speaker's rate, reply delay, echo, adapter
// latency. Expected instants are computed here from the rate, to the microsecond.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"
#include <cmath>

using namespace std::chrono_literals;
using base::Bytes;
using base::Duration;

namespace {
/// Microseconds that `count` bytes take, rounded up as by the bus.
Duration byteTimes(double count, int baud)
{
    return Duration(static_cast<Duration::rep>(std::ceil(count * 1e7 / baud - 1e-6)));
}
} // namespace

class TestWireTiming : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aReplyTakesItsByteTimes_data()
    {
        QTest::addColumn<int>("baud");
        for (const int baud : {1000000, 500000, 250000, 128000, 115200, 76800, 57600, 38400})
            QTest::addRow("%d", baud) << baud;
    }
    void aReplyTakesItsByteTimes()
    {
        QFETCH(int, baud);
        const auto bus = wire::bus("sts3215@1", baud);
        bus->setHostBaud(baud);
        const Duration start = 5ms;
        bus->hostReads(start);
        bus->hostWrites(wire::ping(1), baud, start);
        const Duration delay = bus->servos()[0]->replyDelay();
        // The servo has received the request when its last byte has passed.
        QVERIFY(bus->hostReads(start + byteTimes(6, baud)).empty());
        const auto first = bus->nextHostByte();
        QVERIFY(first);
        const Duration expected = start + byteTimes(7, baud) + delay;
        QVERIFY2(std::abs((*first - expected).count()) <= 1, qPrintable(QString::number(baud)));
        QVERIFY(bus->hostReads(*first - 1us).empty());
        QCOMPARE(bus->hostReads(*first), Bytes{0xFF});
        const auto whole = bus->nextHostRun(start + 1s);
        QVERIFY(whole);
        QVERIFY(std::abs((*whole - start - byteTimes(12, baud) - delay).count()) <= 1);
        QCOMPARE(bus->hostReads(*whole - 1us).size(), std::size_t{4});
        QCOMPARE(bus->hostReads(*whole).size(), std::size_t{1});
        QVERIFY(!bus->nextHostByte());
        QVERIFY(!bus->nextHostRun(start + 1s));
    }

    // 8 bytes out, 21 back: 0.29 ms at 1 Mbaud.
    void theFeedbackBlockTakesItsPublishedTime()
    {
        const auto bus = wire::bus("sts3215@1");
        bus->hostReads(0us);
        bus->hostWrites(wire::read(1, 56, 15), 1'000'000, 0us);
        QCOMPARE(*bus->nextHostRun(1s), 290us + bus->servos()[0]->replyDelay());
    }

    void aReplyWaitsTheReplyDelayRegister()
    {
        const auto bus = wire::bus("sm40blhv@1", 1'000'000);
        sim::VirtualServo& servo = *bus->servo(1);
        servo.poke(QStringLiteral("return_delay"), 250);
        bus->hostReads(0us);
        bus->hostWrites(wire::ping(1), 1'000'000, 0us);
        // 250 × 2 µs after the request, as published for SMS.
        QVERIFY(*bus->nextHostRun(1s) >= 60us + 500us + 60us);
        QVERIFY(*bus->nextHostRun(1s) <= 60us + 520us + 60us);
    }

    void aDeadlineLimitsTheLookAhead()
    {
        const auto bus = wire::bus("sts3215@1");
        bus->hostReads(0us);
        bus->hostWrites(wire::ping(1), 1'000'000, 0us);
        QVERIFY(!bus->nextHostRun(59us));
        QVERIFY(!bus->nextHostRun(119us));
        QVERIFY(bus->nextHostRun(1ms));
    }

    void requestsQueueBehindEachOther()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@2");
        bus->hostReads(0us);
        // Broadcasts stay unanswered, so only their own time passes.
        bus->hostWrites(wire::frame(0xFE, 0x05), 1'000'000, 0us);
        bus->hostWrites(wire::ping(2), 1'000'000, 10us);
        QCOMPARE(*bus->nextHostRun(1s), 180us + bus->servo(2)->replyDelay());
    }

    void theClockMayStartAnywhere()
    {
        const auto bus = wire::bus("sts3215@1");
        const Duration boot = 400h;
        Duration now = boot;
        QVERIFY(bus->hostReads(now).empty());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    void bytesArriveLaterByTheAdaptersLatency()
    {
        sim::WireConfig config;
        config.adapterLatency = 16ms;
        const auto bus = wire::bus("sts3215@1", {}, config);
        bus->hostReads(0us);
        bus->hostWrites(wire::ping(1), 1'000'000, 0us);
        const Duration delay = bus->servos()[0]->replyDelay();
        QCOMPARE(*bus->nextHostRun(1s), 120us + delay + 16ms);
        QVERIFY(bus->hostReads(60us + delay + 16ms).empty());
        QCOMPARE(*bus->nextHostByte(), 70us + delay + 16ms);
        QVERIFY(wire::isStatusOf(bus->hostReads(120us + delay + 16ms), 1));
    }

    void anEchoingAdapterReturnsWhatIsSent()
    {
        sim::WireConfig config;
        config.echo = true;
        const auto bus = wire::bus("sts3215@1", {}, config);
        Duration now = 1ms;
        bus->hostReads(now);
        const Bytes request = wire::ping(1);
        bus->hostWrites(request, 1'000'000, now);
        QCOMPARE(bus->hostReads(now + 60us), request);
        QVERIFY(wire::isStatusOf(bus->hostReads(now + 1ms), 1));
        // Nobody has ID 9: only the echo comes.
        now += 10ms;
        QCOMPARE(wire::ask(*bus, wire::read(9, 56, 2), now), wire::read(9, 56, 2));
    }

    void anHourOfSilenceLeavesNoData()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 0us;
        QVERIFY(bus->hostReads(now).empty());
        now += 10min;
        QVERIFY(bus->hostReads(now).empty());
        QVERIFY(!bus->nextHostRun(now + 10min));
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }
};

SERVODESK_GUILESS_TEST(TestWireTiming)
#include "tst_wire_timing.moc"

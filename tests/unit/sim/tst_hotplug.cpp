// SPDX-License-Identifier: GPL-3.0-or-later
// Servos that are plugged in and out: an unplugged servo has no power and is silent, what it
// keeps it keeps, and a bag gives one servo after the other.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "wire_fixture.h"

using namespace std::chrono_literals;
using base::Duration;

namespace {
std::unique_ptr<sim::VirtualBus> bag(const char* name)
{
    return std::move(*sim::makePreset(QString::fromLatin1(name), wire::models()));
}

bool answers(sim::VirtualBus& bus, int id, Duration& now, int baud = 1'000'000)
{
    const auto number = static_cast<std::uint8_t>(id);
    return wire::isStatusOf(wire::ask(bus, wire::ping(number), now, baud), number);
}
} // namespace

class TestHotplug : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void unpluggedServosAreSilentAndLoseRam()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@2", 1'000'000);
        Duration now = 1ms;
        bus->hostReads(now);
        bus->servos()[0]->poke(QStringLiteral("torque_switch"), 1);
        bus->unplug(0);
        QVERIFY(!bus->isPlugged(0) && bus->isPlugged(1));
        QVERIFY(!answers(*bus, 1, now));
        QVERIFY(answers(*bus, 2, now));
        bus->powerCycle(); // of those on the wire
        QVERIFY(!answers(*bus, 1, now));
        bus->plug(0);
        now += 2s;
        QVERIFY(answers(*bus, 1, now));
        QCOMPARE(bus->servos()[0]->raw(QStringLiteral("torque_switch")), 0);
    }

    void unpluggingDuringAReplyTruncatesIt()
    {
        const auto bus = wire::bus("sts3215@1", 38'400);
        Duration now = 1ms;
        bus->hostReads(now);
        bus->setHostBaud(38'400);
        bus->hostWrites(wire::ping(1), 38'400, now);
        now += 2300us; // six bytes take 1.6 ms, and so does the answer
        auto received = bus->hostReads(now);
        bus->unplug(0);
        now += 50ms;
        const auto rest = bus->hostReads(now);
        received.insert(received.end(), rest.begin(), rest.end());
        QVERIFY(!received.empty());
        QVERIFY(received.size() < 6);
    }

    void hotplugQueueGivesOneServoAtATime()
    {
        const auto bus = bag("line");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(bus->hasHotplugQueue());
        QCOMPARE(bus->pendingServoCount(), std::size_t{6});
        QVERIFY(!answers(*bus, 1, now));
        for (std::size_t place = 0; place < 6; ++place) {
            QCOMPARE(bus->connectNext(), std::optional(place));
            QCOMPARE(bus->pendingServoCount(), 5 - place);
            now += 2s;
            QVERIFY(answers(*bus, 1, now, bus->servos()[place]->baud()));
            for (std::size_t other = 0; other < 6; ++other)
                QCOMPARE(bus->isPlugged(other), other == place);
        }
        QCOMPARE(bus->connectNext(), std::nullopt);
        QVERIFY(!answers(*bus, 1, now));
        bus->plug(3); // one that has been on already
        now += 2s;
        QVERIFY(answers(*bus, 1, now));
    }

    void factoryServosHaveTheirFactoryRate()
    {
        const auto bus = bag("line");
        for (const sim::VirtualServo* servo : bus->servos()) {
            QCOMPARE(servo->id(), 1);
            QCOMPARE(servo->baud(), *servo->profile().defaultBaud);
        }
    }
};

SERVODESK_GUILESS_TEST(TestHotplug)
#include "tst_hotplug.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// A servo in its bootloader: what it replies to is taken from public tools, written out by hand.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QtTest>

#include "wire_fixture.h"

using base::Bytes;
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int bootloaderRate = 500'000;
const Bytes preamble{0x31, 0x66, 0x42, 0x56, 0x41};
const Bytes accepted{0x06};
} // namespace

class TestBootloader : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aServoWithoutFirmwareOnlyTakesThePreamble()
    {
        const auto bus = wire::bus("sts3215@1+firmware-lost=1");
        Duration now = 1ms;
        bus->hostReads(now);
        for (int round = 0; round < 2; ++round) {
            QCOMPARE(wire::ask(*bus, wire::ping(1), now), Bytes());
            QCOMPARE(wire::ask(*bus, wire::ping(1), now, bootloaderRate), Bytes());
            QCOMPARE(wire::ask(*bus, preamble, now), Bytes());
            QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), accepted);
            now += 5s; // it does not start on its own
            bus->powerCycle();
        }
    }

    void thePreambleMustBeWhole()
    {
        const auto bus = wire::bus("sts3215@1+firmware-lost=1");
        Duration now = 1ms;
        bus->hostReads(now);
        QCOMPARE(wire::ask(*bus, {0x31, 0x66, 0x42}, now, bootloaderRate), Bytes());
        QCOMPARE(wire::ask(*bus, {0x41}, now, bootloaderRate), Bytes());
        QCOMPARE(wire::ask(*bus, {0x31, 0x31, 0x66, 0x42, 0x56}, now, bootloaderRate), Bytes());
        QCOMPARE(wire::ask(*bus, {0x41}, now, bootloaderRate), accepted);
    }

    /// Every start runs through the bootloader.
    void aRestartIsAWindow()
    {
        const auto bus = wire::bus("sts3215@1");
        Duration now = 1ms;
        bus->hostReads(now);
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), Bytes());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
        wire::ask(*bus, wire::frame(1, 0x08), now);
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), accepted);
        now += 1s;
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), Bytes());
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
    }

    void theOthersReplyAsUsual()
    {
        const auto bus = wire::bus("sts3215@1+firmware-lost=1,sts3215@2");
        Duration now = 1ms;
        bus->hostReads(now);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(2), now), 2));
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), accepted);
        QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(2), now), 2));
    }

    /// None is known of LX servos.
    void anLxServoHasNone()
    {
        const auto bus = wire::bus("lx-16a@1+firmware-lost=1");
        Duration now = 1ms;
        bus->hostReads(now);
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), Bytes());
    }
};

SERVODESK_GUILESS_TEST(TestBootloader)
#include "tst_bootloader.moc"

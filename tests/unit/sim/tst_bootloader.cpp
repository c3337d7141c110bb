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
const Bytes start{0x01};
const Bytes accepted{0x06};
const Bytes refused{0x15};

/// The two frames of the protocol sheet with their checksums.
Bytes zeros()
{
    Bytes block{0x01, 0xFE, 0x01};
    block.resize(67, 0);
    block.insert(block.end(), {0xF2, 0xE8, 0x06});
    return block;
}
Bytes counting()
{
    Bytes block{0x01, 0xFE, 0x01};
    for (int i = 0; i < 64; ++i)
        block.push_back(std::uint8_t(i));
    block.insert(block.end(), {0x17, 0xC8, 0x06});
    return block;
}

/// A servo without firmware that has been told to wait for blocks.
struct Transfer {
    explicit Transfer(const char* servos = "sts3215@1+firmware-lost=1")
        : bus(wire::bus(servos))
    {
        bus->hostReads(now);
        begin();
    }
    void begin()
    {
        bus->powerCycle();
        QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), accepted);
        QCOMPARE(wire::ask(*bus, start, now, bootloaderRate), accepted);
    }
    Bytes send(const Bytes& block) { return wire::ask(*bus, block, now, bootloaderRate); }
    bool isRunning() { return wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1); }

    Duration now = 1ms;
    std::unique_ptr<sim::VirtualBus> bus;
};
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
        for (const bool byRequest : {true, false}) {
            const auto bus = wire::bus("sts3215@1");
            Duration now = 1ms;
            bus->hostReads(now);
            QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), Bytes());
            QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
            if (byRequest)
                wire::ask(*bus, wire::frame(1, 0x08), now);
            else
                bus->powerCycle();
            QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), accepted);
            now += 1s;
            QCOMPARE(wire::ask(*bus, preamble, now, bootloaderRate), Bytes());
            QVERIFY(wire::isStatusOf(wire::ask(*bus, wire::ping(1), now), 1));
        }
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

    void theChecksumDecides()
    {
        Transfer transfer;
        QCOMPARE(transfer.send(zeros()), accepted);
        Transfer other;
        QCOMPARE(other.send(counting()), accepted);
        for (const std::size_t broken : {3, 63, 67, 68}) {
            Transfer third;
            Bytes block = counting();
            block[broken] ^= 1;
            QCOMPARE(third.send(block), refused);
            QCOMPARE(third.send(counting()), accepted); // once more
        }
    }

    /// A quirk: the last three bytes of the data are not protected.
    void theChecksumLeavesOutThreeBytes()
    {
        for (const std::size_t changed : {64, 65, 66}) {
            Transfer transfer;
            Bytes block = counting();
            block[changed] ^= 0xFF;
            QCOMPARE(transfer.send(block), accepted);
        }
    }

    void blocksComeInOrder()
    {
        Transfer transfer;
        QCOMPARE(transfer.send(counting()), accepted);
        QCOMPARE(transfer.send(counting()), refused);
        Bytes wrongFlag = counting();
        wrongFlag[2] = 0;
        Transfer other;
        QCOMPARE(other.send(wrongFlag), refused);
    }

    void theLastBlockStartsTheFirmware()
    {
        Transfer transfer;
        QCOMPARE(transfer.send(counting()), accepted);
        transfer.now += 1min; // it waits between blocks
        // Block 2, and the last one: all bytes 0, with its checksum.
        Bytes last{0x02, 0xFD, 0x01};
        last.resize(67, 0);
        last.insert(last.end(), {0xB4, 0x3B, 0x04});
        QCOMPARE(transfer.send(last), accepted);
        QVERIFY(transfer.isRunning());
    }

    void aPowerOffBetweenBlocksLosesTheFirmware()
    {
        Transfer transfer("sts3215@1");
        QCOMPARE(transfer.send(counting()), accepted);
        transfer.bus->powerCycle();
        transfer.now += 5s;
        QVERIFY(!transfer.isRunning());
        transfer.begin();
        QCOMPARE(transfer.send(counting()), accepted);
    }

    void refusedBlocksWithoutEndEndIt()
    {
        Transfer transfer;
        Bytes broken = zeros();
        broken[67] ^= 1;
        for (int i = 0; i < 200; ++i)
            QCOMPARE(transfer.send(broken), refused);
        QCOMPARE(transfer.send(zeros()), Bytes()); // it waits for the preamble again
        transfer.begin();
    }

    /// All servos on one supply: their replies come at the same time.
    void everyServoOnTheSupplyTakesTheFirmware()
    {
        const auto bus = wire::bus("sts3215@1,sts3215@2");
        Duration now = 1ms;
        bus->hostReads(now);
        const auto before = bus->servo(2)->raw(QStringLiteral("firmware_minor"));
        bus->powerCycle();
        wire::ask(*bus, preamble, now, bootloaderRate);
        wire::ask(*bus, start, now, bootloaderRate);
        Bytes only = counting();
        only.back() = 0x04;
        wire::ask(*bus, only, now, bootloaderRate);
        now += 1s;
        bus->hostReads(now);
        for (sim::VirtualServo* servo : bus->servos())
            QCOMPARE(servo->raw(QStringLiteral("firmware_minor")), before + 1);
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a firmware against frames that were computed from the published layout, by hand.
#include "base/crc.h"
#include "protocol/firmware_block.h"
#include "support/test_main.h"

#include <QtTest>

#include <numeric>

using base::Bytes;

namespace {
Bytes counting(std::size_t size)
{
    Bytes bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t(0));
    return bytes;
}
} // namespace

class TestFirmwareBlock : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void checksumIsXmodem()
    {
        const QByteArray digits("123456789");
        QCOMPARE(base::crc16Xmodem(Bytes(digits.begin(), digits.end())), std::uint16_t(0x31C3));
    }

    void theLayoutIsThePublishedOne()
    {
        const Bytes file = counting(65); // one more block follows
        const Bytes block = protocol::firmwareBlock(file, 0);
        QCOMPARE(block.size(), std::size_t(70));
        QCOMPARE(base::toHex(base::ByteView(block).first(6)), QStringLiteral("01 FE 01 00 01 02"));
        QCOMPARE(base::toHex(base::ByteView(block).last(4)), QStringLiteral("3F 17 C8 06"));
        QCOMPARE(base::toHex(base::ByteView(protocol::firmwareBlock(Bytes(65, 0), 0)).last(3)),
                 QStringLiteral("F2 E8 06"));
    }

    void theLastBlockIsFilledUp()
    {
        const Bytes block = protocol::firmwareBlock(counting(65), 1);
        QCOMPARE(base::toHex(base::ByteView(block).first(5)), QStringLiteral("02 FD 01 40 FF"));
        QCOMPARE(block[66], std::uint8_t(0xFF));
        QCOMPARE(block.back(), std::uint8_t(0x04));
        QCOMPARE(protocol::firmwareBlocks(65), 2);
        QCOMPARE(protocol::firmwareBlocks(64), 1);
        QCOMPARE(protocol::firmwareBlock(counting(64), 0).back(), std::uint8_t(0x04));
    }

    void theNumberOfABlockWraps()
    {
        const Bytes file(64 * 300, 0x55);
        QCOMPARE(protocol::firmwareBlock(file, 254)[0], std::uint8_t(0xFF));
        QCOMPARE(protocol::firmwareBlock(file, 255)[0], std::uint8_t(0x00));
        QCOMPARE(protocol::firmwareBlock(file, 255)[1], std::uint8_t(0xFF));
        QCOMPARE(protocol::firmwareBlock(file, 256)[0], std::uint8_t(0x01));
    }
};

SERVODESK_GUILESS_TEST(TestFirmwareBlock)
#include "tst_firmware_block.moc"

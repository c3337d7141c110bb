// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to Modbus bytes, what is expected back, and words for the trace. The frames are those
// computed from the published rules; they were not produced by this code.
#include "base/crc.h"
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

using namespace protocol;
using base::Bytes;
using base::ErrorCode;

namespace {
constexpr int reg(int number)
{
    return 2 * number;
}

Request modbusWrite(int station, int number, const char* data)
{
    return Request::write(station, reg(number), hex(data), Repeat::Safe);
}
} // namespace

class TestModbusEncode : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void crcCheckValue()
    {
        const QByteArray text("123456789");
        QCOMPARE(int(base::crc16Modbus({reinterpret_cast<const std::uint8_t*>(text.data()),
                                        std::size_t(text.size())})),
                 0x4B37);
    }

    void encodes_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<QString>("frame");
        const auto row = [](const char* name, const Request& request, const char* frame) {
            QTest::newRow(name) << request << QString::fromLatin1(frame);
        };
        row("ping reads the identity", Request::ping(1), "01 03 00 00 00 04 44 09");
        row("read identity", Request::read(1, 0, 8), "01 03 00 00 00 04 44 09");
        row("read feedback", Request::read(1, reg(256), 16), "01 03 01 00 00 08 45 F0");
        row("torque on", modbusWrite(1, 129, "00 01"), "01 06 00 81 00 01 18 22");
        row("unlock", modbusWrite(1, 133, "00 00"), "01 06 00 85 00 00 98 23");
        row("move", modbusWrite(1, 128, "08 00 00 01 00 0A 00 32"),
            "01 10 00 80 00 04 08 08 00 00 01 00 0A 00 32 29 B5");
        row("who is there", Request::ping(254), "00 11 C1 BC");
        row("reboot", Request::reboot(1), "01 41 C0 10");
        row("reboot all", Request::reboot(254), "00 41 C1 80");
        row("raw goes out as it is", Request::raw(hex("01 11 C0 2C")), "01 11 C0 2C");
    }

    void encodes()
    {
        QFETCH(const Request, request);
        QFETCH(const QString, frame);
        const auto bytes = modbusCodec().encode(request);
        QVERIFY(bytes);
        QCOMPARE(base::toHex(*bytes), frame);
    }

    void broadcastWriteGoesToStation0()
    {
        const auto bytes = modbusCodec().encode(modbusWrite(254, 129, "00 00"));
        QVERIFY(bytes);
        QCOMPARE(base::toHex(base::ByteView(*bytes).first(6)), QStringLiteral("00 06 00 81 00 00"));
    }

    void longestPacketsPass_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<int>("size");
        QTest::addColumn<int>("replyBytes");
        QTest::newRow("read 125") << Request::read(1, 0, 250) << 8 << 255;
        QTest::newRow("write 123") << Request::write(1, 0, Bytes(246), Repeat::Safe) << 255 << 8;
        QTest::newRow("last register")
            << Request::write(247, reg(65535), Bytes(2), Repeat::Safe) << 8 << 8;
    }

    void longestPacketsPass()
    {
        QFETCH(const Request, request);
        QFETCH(const int, size);
        QFETCH(const int, replyBytes);
        const auto bytes = modbusCodec().encode(request);
        QVERIFY(bytes);
        QCOMPARE(int(bytes->size()), size);
        QCOMPARE(modbusCodec().expect(request).replyBytes, replyBytes);
    }

    void refuses_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<QString>("detail");
        const auto bad = [](const char* name, const Request& request, const char* detail) {
            QTest::newRow(name) << request << ErrorCode::BadArgument << QString::fromLatin1(detail);
        };
        bad("station 0", Request::ping(0), "ID 0: Modbus stations are 1 to 247");
        bad("station 248", Request::ping(248), "ID 248: Modbus stations are 1 to 247");
        bad("station 253", Request::read(253, 0, 2), "ID 253: Modbus stations are 1 to 247");
        bad("station 255", Request::reboot(255), "ID 255: Modbus stations are 1 to 247");
        bad("negative station", modbusWrite(-1, 128, "00 00"),
            "ID -1: Modbus stations are 1 to 247");
        bad("read of 248", Request::read(248, 0, 2), "ID 248: Modbus stations are 1 to 247");
        bad("broadcast read other than the echo probe", Request::read(254, 0, 4),
            "ID 254: Modbus stations are 1 to 247");
        bad("odd address", Request::read(1, 257, 2), "half a register");
        bad("odd count", Request::read(1, 256, 3), "half a register");
        bad("half a value", Request::write(1, 256, Bytes(1), Repeat::Safe), "half a register");
        bad("read of nothing", Request::read(1, 0, 0), "0 registers");
        bad("write of nothing", Request::write(1, 0, {}, Repeat::Safe), "0 registers");
        bad("read 126", Request::read(1, 0, 252), "126 registers");
        bad("write 124", Request::write(1, 0, Bytes(248), Repeat::Safe), "124 registers");
        bad("write over a frame", Request::write(1, 0, Bytes(258), Repeat::Safe), "129 registers");
        bad("negative address", Request::read(1, -2, 2), "address -2");
        bad("past the last register", Request::read(1, reg(65536), 2), "address 131072");
        bad("over the end", Request::read(1, reg(65535), 4),
            "2 registers from 65535 pass the end of the table");
        bad("raw nothing", Request::raw({}), "no bytes");
        bad("raw over 256 bytes", Request::raw(Bytes(257)), "packet longer than 256 bytes");

        const auto lacks = [](const char* name, const Request& request) {
            QTest::newRow(name) << request << ErrorCode::NotSupported
                                << QStringLiteral("no such instruction");
        };
        lacks("reg write", Request::regWrite(1, 0, Bytes(2), Repeat::Safe));
        lacks("action", Request::action());
        lacks("halt", Request::halt(1));
        lacks("restore", Request::restore(1));
        lacks("back up", Request::backup(1));
        lacks("state reset", Request::stateReset(1));
        lacks("calibrate", Request::calibrate(1, {}, base::ByteOrder::Big));
        lacks("sync read", Request::syncRead(0, 2, {1, 2}));
        lacks("sync write", Request::syncWrite(0, {{1, Bytes(2)}, {2, Bytes(2)}}));
    }

    void refuses()
    {
        QFETCH(const Request, request);
        QFETCH(const ErrorCode, code);
        QFETCH(const QString, detail);
        const auto bytes = modbusCodec().encode(request);
        QVERIFY(!bytes);
        QCOMPARE(bytes.error().code, code);
        QCOMPARE(bytes.error().detail, detail);
    }

    void expects_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<std::vector<int>>("ids");
        QTest::addColumn<int>("replyBytes");
        const auto row = [](const char* name, const Request& request, std::vector<int> ids,
                            int bytes) { QTest::newRow(name) << request << ids << bytes; };
        row("ping", Request::ping(7), {7}, 13);
        row("who is there", Request::ping(254), {254}, 8);
        row("read feedback", Request::read(7, reg(256), 16), {7}, 21);
        row("write one", modbusWrite(7, 129, "00 01"), {7}, 8);
        row("write four", modbusWrite(7, 128, "08 00 00 01 00 0A 00 32"), {7}, 8);
        row("broadcast write", modbusWrite(254, 129, "00 00"), {}, 0);
        row("silent servo", unacknowledged(modbusWrite(7, 129, "00 00")), {}, 0);
        row("silent servo answers reads", unacknowledged(Request::read(7, 0, 2)), {7}, 7);
        row("reboot is not answered", Request::reboot(7), {}, 0);
        row("reboot all", Request::reboot(254), {}, 0);
        row("raw", Request::raw(hex("01 11 C0 2C")), {}, 0);
        row("echo probe", modbusCodec().echoProbe(), {}, 0);
    }

    void expects()
    {
        QFETCH(const Request, request);
        QFETCH(const std::vector<int>, ids);
        QFETCH(const int, replyBytes);
        const Expectation expected = modbusCodec().expect(request);
        QCOMPARE(expected.ids, ids);
        QCOMPARE(expected.replyBytes, replyBytes);
    }

    // 248 to 255 are reserved, and to a read of station 0 nobody answers.
    void echoProbeAddressesNoServo()
    {
        const auto frame = modbusCodec().encode(modbusCodec().echoProbe());
        QVERIFY(frame);
        QCOMPARE(*frame, hex("00 03 00 00 00 01 85 DB"));
    }

    void echoProbeIsNoReply_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("to who is there") << Request::ping(254);
        for (const int count : {2, 4, 16})
            QTest::addRow("to a read of %d", count) << Request::read(247, 0, count);
    }

    void echoProbeIsNoReply()
    {
        QFETCH(const Request, request);
        const auto frame = modbusCodec().encode(modbusCodec().echoProbe());
        QVERIFY(frame);
        for (const QString& word :
             verdicts(modbusCodec(), *frame, modbusCodec().expect(request), true))
            QVERIFY2(word.startsWith(QStringLiteral("noise")) ||
                         word.startsWith(QStringLiteral("foreign")),
                     qPrintable(word));
    }

    void silence_data()
    {
        QTest::addColumn<int>("baud");
        QTest::addColumn<qint64>("microseconds");
        QTest::newRow("256000") << 256'000 << qint64(1750);
        QTest::newRow("115200") << 115'200 << qint64(1750);
        QTest::newRow("38400") << 38'400 << qint64(1750);
        QTest::newRow("19200: 3.5 characters") << 19'200 << qint64(1823);
        QTest::newRow("9600") << 9'600 << qint64(3646);
        QTest::newRow("4800") << 4'800 << qint64(7292);
    }

    void silence()
    {
        QFETCH(const int, baud);
        QFETCH(const qint64, microseconds);
        QCOMPARE(qint64(modbusCodec().silence(baud).count()), microseconds);
    }

    void explains_data()
    {
        QTest::addColumn<QString>("frame");
        QTest::addColumn<bool>("fromHost");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* frame, bool fromHost, const char* text) {
            QTest::newRow(text) << QString::fromLatin1(frame) << fromHost
                                << QString::fromUtf8(text);
        };
        row("01 03 01 00 00 08 45 F0", true, "READ 1 @256 ×8");
        row("01 06 00 81 00 01 18 22", true, "WRITE 1 @129: 00 01");
        row("01 06 00 81 00 01 18 22", false, "REPLY WRITE 1 @129: 00 01");
        row("01 10 00 80 00 04 08 08 00 00 01 00 0A 00 32 29 B5", true,
            "WRITE 1 @128 ×4: 08 00 00 01 00 0A 00 32");
        row("01 10 00 80 00 04 C0 22", false, "REPLY WRITE 1 @128 ×4");
        row("01 11 C0 2C", true, "REPORT ID 1");
        row("00 11 C1 BC", true, "REPORT ID all");
        row("01 11 03 01 00 00 AC 4D", false, "REPLY REPORT ID 1: 01 00 00");
        row("01 41 C0 10", true, "REBOOT 1");
        row("00 41 C1 80", true, "REBOOT all");
        row("01 83 02 C0 F1", false, "EXCEPTION READ 1: illegal address");
        row("01 83 02 C0 F2", false, "EXCEPTION READ 1: illegal address (CRC wrong)");
        row("01 03 01 00 00 08 45 F1", true, "READ 1 @256 ×8 (CRC wrong)");
        row("01 03 01 00", true, "bytes: 01 03 01 00");
        row("FF FF 01 02 01 FB", true, "bytes: FF FF 01 02 01 FB");
        row("", false, "bytes");
    }

    void explains()
    {
        QFETCH(const QString, frame);
        QFETCH(const bool, fromHost);
        QFETCH(const QString, text);
        QCOMPARE(modbusCodec().explain(hex(frame), fromHost), text);
    }

    void explainsReasonsByName()
    {
        const auto said = [](std::uint8_t function, std::uint8_t reason) {
            return modbusCodec().explain(encodeModbusReply(3, function, Bytes{reason}), false);
        };
        QCOMPARE(said(0x90, 1), QStringLiteral("EXCEPTION WRITE 3: illegal function"));
        QCOMPARE(said(0x86, 3), QStringLiteral("EXCEPTION WRITE 3: illegal value"));
        QCOMPARE(said(0x91, 4), QStringLiteral("EXCEPTION REPORT ID 3: reason 4"));
    }
};

SERVODESK_GUILESS_TEST(TestModbusEncode)
#include "tst_modbus_encode.moc"

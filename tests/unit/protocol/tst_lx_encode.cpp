// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to LX bytes, what is expected back, and words for the trace. The frames are those
// computed from the maker's rules; they were not produced by this code.
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

using namespace protocol;
using base::Bytes;
using base::ErrorCode;

namespace {
constexpr int command(int code)
{
    return 8 * code;
}

Request lxWrite(int id, int code, const char* data)
{
    return Request::write(id, command(code), hex(data), Repeat::Safe);
}

Request read(int id, int code, int count)
{
    return Request::read(id, command(code), count);
}
} // namespace

class TestLxEncode : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void encodes_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<QString>("frame");
        const auto row = [](const char* name, const Request& request, const char* frame) {
            QTest::newRow(name) << request << QString::fromLatin1(frame);
        };
        row("move", lxWrite(1, 1, "F4 01 E8 03"), "55 55 01 07 01 F4 01 E8 03 16");
        row("stored move", lxWrite(2, 7, "E8 03 30 75"), "55 55 02 07 07 E8 03 30 75 5F");
        row("start all", Request::action(), "55 55 FE 03 0B F3");
        row("stop all", Request::halt(254), "55 55 FE 03 0C F2");
        row("ID 1 to 7", lxWrite(1, 13, "07"), "55 55 01 04 0D 07 E6");
        row("who is there", Request::ping(254), "55 55 FE 03 0E F0");
        row("offset -30", lxWrite(1, 17, "E2"), "55 55 01 04 11 E2 07");
        row("save the offset", lxWrite(1, 18, ""), "55 55 01 03 12 E9");
        row("read the offset", read(1, 19, 1), "55 55 01 03 13 E8");
        row("angle limits", lxWrite(1, 20, "64 00 84 03"), "55 55 01 07 14 64 00 84 03 F8");
        row("voltage limits", lxWrite(1, 22, "64 19 E0 2E"), "55 55 01 07 16 64 19 E0 2E 56");
        row("temperature limit", lxWrite(1, 24, "55"), "55 55 01 04 18 55 8D");
        row("read temperature", read(1, 26, 1), "55 55 01 03 1A E1");
        row("read voltage", read(1, 27, 2), "55 55 01 03 1B E0");
        row("read position", read(1, 28, 2), "55 55 01 03 1C DF");
        row("motor -500", lxWrite(1, 29, "01 00 0C FE"), "55 55 01 07 1D 01 00 0C FE CF");
        row("position mode", lxWrite(1, 29, "00 00 00 00"), "55 55 01 07 1D 00 00 00 00 DA");
        row("load", lxWrite(1, 31, "01"), "55 55 01 04 1F 01 DA");
        row("unload", lxWrite(1, 31, "00"), "55 55 01 04 1F 00 DB");
        row("LED off", lxWrite(1, 33, "01"), "55 55 01 04 21 01 D8");
        row("LED fault mask", lxWrite(1, 35, "07"), "55 55 01 04 23 07 D0");
        row("raw goes out as it is", Request::raw(hex("55 55 00")), "55 55 00");
    }

    void encodes()
    {
        QFETCH(const Request, request);
        QFETCH(const QString, frame);
        const auto bytes = lxCodec().encode(request);
        QVERIFY(bytes);
        QCOMPARE(base::toHex(*bytes), frame);
    }

    void refuses_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<QString>("detail");
        const auto bad = [](const char* name, const Request& request, const char* detail) {
            QTest::newRow(name) << request << ErrorCode::BadArgument << QString::fromLatin1(detail);
        };
        bad("ID 255", Request::ping(255), "ID 255");
        bad("negative ID", Request::halt(-1), "ID -1");
        bad("broadcast read", read(254, 26, 1), "ID 254");
        bad("broadcast read of the ID is a ping", read(254, 14, 1), "ID 254");
        bad("read of nothing", read(1, 26, 0), "no bytes");
        bad("part of a reply", Request::read(1, command(21) + 2, 2),
            "part of a command's parameters");
        bad("part of a request", Request::write(1, command(20) + 2, Bytes(2), Repeat::Safe),
            "part of a command's parameters");
        bad("command 0", read(1, 0, 1), "address 0");
        bad("command 256", read(1, 256, 1), "address 2048");
        bad("negative address", read(1, -1, 1), "address -8");
        bad("reply too long", read(1, 21, 9), "9 parameters");
        bad("request too long", Request::write(1, command(20), Bytes(9), Repeat::Safe),
            "9 parameters");
        bad("raw nothing", Request::raw({}), "no bytes");
        bad("raw over 258 bytes", Request::raw(Bytes(259)), "packet longer than 258 bytes");

        const auto lacks = [](const char* name, const Request& request) {
            QTest::newRow(name) << request << ErrorCode::NotSupported
                                << QStringLiteral("no such instruction");
        };
        lacks("reg write", Request::regWrite(1, command(1), Bytes(4), Repeat::Safe));
        lacks("restore", Request::restore(1));
        lacks("back up", Request::backup(1));
        lacks("state reset", Request::stateReset(1));
        lacks("calibrate", Request::calibrate(1, {}, base::ByteOrder::Little));
        lacks("reboot", Request::reboot(1));
        lacks("sync read", Request::syncRead(command(28), 2, {1, 2}));
        lacks("sync write", Request::syncWrite(command(1), {{1, Bytes(4)}}));
    }

    void refuses()
    {
        QFETCH(const Request, request);
        QFETCH(const ErrorCode, code);
        QFETCH(const QString, detail);
        const auto bytes = lxCodec().encode(request);
        QVERIFY(!bytes);
        QCOMPARE(bytes.error().code, code);
        QCOMPARE(bytes.error().detail, detail);
    }

    void expects_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<std::vector<int>>("ids");
        QTest::addColumn<int>("replyBytes");
        QTest::addColumn<int>("repeated");
        const auto row = [](const char* name, const Request& request, std::vector<int> ids,
                            int bytes, int repeated) {
            QTest::newRow(name) << request << ids << bytes << repeated;
        };
        row("ping", Request::ping(7), {7}, 7, 14);
        row("who is there", Request::ping(254), {254}, 7, 14);
        row("read position", read(7, 28, 2), {7}, 8, 28);
        row("read limits", read(7, 21, 4), {7}, 10, 21);
        row("writes are not acknowledged", lxWrite(7, 1, "F4 01 E8 03"), {}, 0, -1);
        row("start", Request::action(7), {}, 0, -1);
        row("stop", Request::halt(7), {}, 0, -1);
        row("raw", Request::raw(hex("55 55 01 03 1C DF")), {}, 0, -1);
        row("echo probe", lxCodec().echoProbe(), {}, 0, -1);
    }

    void expects()
    {
        QFETCH(const Request, request);
        QFETCH(const std::vector<int>, ids);
        QFETCH(const int, replyBytes);
        QFETCH(const int, repeated);
        const Expectation expected = lxCodec().expect(request);
        QCOMPARE(expected.ids, ids);
        QCOMPARE(expected.replyBytes, replyBytes);
        QCOMPARE(expected.command, repeated);
    }

    void echoProbeIsNoReply_data()
    {
        QTest::addColumn<Request>("request");
        QTest::newRow("to who is there") << Request::ping(254);
        for (const int count : {1, 2, 4})
            QTest::addRow("to a read of %d", count) << read(253, 28, count);
    }

    void echoProbeIsNoReply()
    {
        QFETCH(const Request, request);
        const auto frame = lxCodec().encode(lxCodec().echoProbe());
        QVERIFY(frame);
        QVERIFY(frame->at(4) != 14);
        QCOMPARE(verdicts(lxCodec(), *frame, lxCodec().expect(request), true),
                 QStringList{QStringLiteral("foreign 254 00 []")});
    }

    void noSilenceIsRequired() { QCOMPARE(lxCodec().silence(115'200).count(), 0); }

    void explains_data()
    {
        QTest::addColumn<QString>("frame");
        QTest::addColumn<bool>("fromHost");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* frame, bool fromHost, const char* text) {
            QTest::newRow(text) << QString::fromLatin1(frame) << fromHost
                                << QString::fromLatin1(text);
        };
        row("55 55 01 07 01 F4 01 E8 03 16", true, "MOVE TIME WRITE 1: F4 01 E8 03");
        row("55 55 FE 03 0B F3", true, "MOVE START all");
        row("55 55 FE 03 0E F0", true, "ID READ all");
        row("55 55 07 04 0E 07 DF", false, "REPLY ID READ 7: 07");
        row("55 55 01 03 1C DF", true, "POS READ 1");
        row("55 55 01 05 1C FD FF E1", false, "REPLY POS READ 1: FD FF");
        row("55 55 01 05 1C FD FF E2", false, "REPLY POS READ 1: FD FF (checksum wrong)");
        row("55 55 01 07 1D 01 00 0C FE CF", true, "SERVO OR MOTOR MODE WRITE 1: 01 00 0C FE");
        row("55 55 01 03 63 98", true, "command 99 1");
        row("55 55 01", true, "bytes: 55 55 01");
        row("", false, "bytes");
    }

    void explains()
    {
        QFETCH(const QString, frame);
        QFETCH(const bool, fromHost);
        QFETCH(const QString, text);
        QCOMPARE(lxCodec().explain(hex(frame), fromHost), text);
    }
};

SERVODESK_GUILESS_TEST(TestLxEncode)
#include "tst_lx_encode.moc"

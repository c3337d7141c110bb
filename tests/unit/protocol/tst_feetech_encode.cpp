// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to bytes. The frames are the vendor's worked examples and those computed from the
// published rules; they were not produced by this code.
#include "protocol/codec.h"
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

using namespace protocol;
using base::ByteOrder;
using base::Bytes;

namespace {
Request syncWrite6(std::initializer_list<int> ids)
{
    std::vector<Target> targets;
    for (const int id : ids)
        targets.push_back({id, hex("00 08 00 00 E8 03")});
    return Request::syncWrite(42, std::move(targets));
}
} // namespace

class TestFeetechEncode : public QObject {
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
        const auto write = [](int id, int address, const char* data) {
            return Request::write(id, address, hex(data), Repeat::Safe);
        };
        row("ping", Request::ping(1), "FF FF 01 02 01 FB");
        row("read 2", Request::read(1, 56, 2), "FF FF 01 04 02 38 02 BE");
        row("read feedback block", Request::read(1, 56, 15), "FF FF 01 04 02 38 0F B1");
        row("read identity", Request::read(1, 0, 5), "FF FF 01 04 02 00 05 F3");
        row("broadcast write", write(254, 5, "01"), "FF FF FE 04 03 05 01 F4");
        row("write position", write(1, 42, "00 08 00 00 E8 03"),
            "FF FF 01 09 03 2A 00 08 00 00 E8 03 D5");
        row("reg write", Request::regWrite(1, 42, hex("00 08 00 00 E8 03"), Repeat::Safe),
            "FF FF 01 09 04 2A 00 08 00 00 E8 03 D4");
        row("action", Request::action(), "FF FF FE 02 05 FA");
        row("sync write, 4 servos", syncWrite6({1, 2, 3, 4}),
            "FF FF FE 20 83 2A 06 01 00 08 00 00 E8 03 02 00 08 00 00 E8 03 "
            "03 00 08 00 00 E8 03 04 00 08 00 00 E8 03 58");
        row("sync write, 2 servos",
            Request::syncWrite(30, {{11, hex("00 00")}, {12, hex("0A 14")}}),
            "FF FF FE 0A 83 1E 02 0B 00 00 0C 0A 14 1F");
        row("sync read 8", Request::syncRead(56, 8, {1, 2}), "FF FF FE 06 82 38 08 01 02 36");
        row("sync read 2", Request::syncRead(30, 2, {11, 12}), "FF FF FE 06 82 1E 02 0B 0C 42");
        row("state reset", Request::stateReset(1), "FF FF 01 02 0A F2");
        row("calibrate to the middle", Request::calibrate(1, {}, ByteOrder::Little),
            "FF FF 01 02 0B F1");
        row("calibrate to 1024", Request::calibrate(1, 1024, ByteOrder::Little),
            "FF FF 01 04 0B 00 04 EB");
        row("restore", Request::restore(1), "FF FF 01 02 06 F6");
        row("back up", Request::backup(1), "FF FF 01 02 09 F3");
        row("reboot", Request::reboot(1), "FF FF 01 02 08 F4");
        row("unlock", write(1, 55, "00"), "FF FF 01 04 03 37 00 C0");
        row("lock", write(1, 55, "01"), "FF FF 01 04 03 37 01 BF");
        row("lock ID 5", write(5, 55, "01"), "FF FF 05 04 03 37 01 BB");
        row("ID 1 to 5", write(1, 5, "05"), "FF FF 01 04 03 05 05 ED");
        row("SCS unlock", write(1, 48, "00"), "FF FF 01 04 03 30 00 C7");
        row("SCS lock", write(1, 48, "01"), "FF FF 01 04 03 30 01 C6");
        row("centre by 128", write(1, 40, "80"), "FF FF 01 04 03 28 80 4F");
        row("STS burst", write(1, 41, "32 E8 83 00 00 60 09"),
            "FF FF 01 0A 03 29 32 E8 83 00 00 60 09 C2");
        row("STS speed -1000", write(1, 46, "E8 83"), "FF FF 01 05 03 2E E8 83 5D");
        row("STS PWM -200", write(1, 44, "C8 04"), "FF FF 01 05 03 2C C8 04 FE");
        row("SCS position 512 in 1 s", write(1, 42, "02 00 03 E8 00 00"),
            "FF FF 01 09 03 2A 02 00 03 E8 00 00 DB");
        row("SCS PWM -200", write(1, 44, "04 C8"), "FF FF 01 05 03 2C 04 C8 FE");
        row("raw goes out as it is", Request::raw(hex("FF FF 00 12")), "FF FF 00 12");
        row("lowest ID", Request::ping(0), "FF FF 00 02 01 FC");
        row("highest ID", Request::ping(253), "FF FF FD 02 01 FF");
        row("broadcast ping", Request::ping(254), "FF FF FE 02 01 FE");
    }

    void encodes()
    {
        QFETCH(const Request, request);
        QFETCH(const QString, frame);
        const auto bytes = feetechCodec().encode(request);
        QVERIFY(bytes);
        QCOMPARE(base::toHex(*bytes), frame);
    }

    void calibrationValueFollowsTheByteOrder()
    {
        const auto big = feetechCodec().encode(Request::calibrate(1, 1024, ByteOrder::Big));
        QVERIFY(big);
        QCOMPARE(base::toHex(*big), QStringLiteral("FF FF 01 04 0B 04 00 EB"));
    }

    void refuses_data()
    {
        QTest::addColumn<Request>("request");
        const auto row = [](const char* name, const Request& request) {
            QTest::newRow(name) << request;
        };
        std::vector<int> many(243);
        std::iota(many.begin(), many.end(), 0);
        std::vector<Target> wide;
        for (int id = 0; id < 31; ++id)
            wide.push_back({id, Bytes(7)});
        Request calibrate = Request::calibrate(1, {}, ByteOrder::Little);
        calibrate.data = Bytes(1);
        row("ping of the header byte", Request::ping(255));
        row("negative ID", Request::ping(-1));
        row("broadcast read", Request::read(254, 56, 15));
        row("read of nothing", Request::read(1, 0, 0));
        row("reply over 250 bytes", Request::read(1, 0, 245));
        row("read past the table", Request::read(1, 250, 7));
        row("negative address", Request::read(1, -1, 2));
        row("address over a byte", Request::write(1, 256, Bytes(1), Repeat::Safe));
        row("write of nothing", Request::write(1, 5, {}, Repeat::Safe));
        row("packet over 250 bytes", Request::write(1, 0, Bytes(244), Repeat::Safe));
        row("reg write over 250 bytes", Request::regWrite(1, 0, Bytes(244), Repeat::Safe));
        row("one byte of calibration", calibrate);
        row("sync read of nobody", Request::syncRead(56, 8, {}));
        row("sync read twice the same", Request::syncRead(56, 8, {1, 2, 1}));
        row("sync read of broadcast", Request::syncRead(56, 8, {1, 254}));
        row("sync read over 250 bytes", Request::syncRead(56, 8, many));
        row("sync read, reply over 250", Request::syncRead(0, 245, {1}));
        row("sync write of nobody", Request::syncWrite(42, {}));
        row("sync write of nothing", Request::syncWrite(42, {{1, {}}}));
        row("sync write, unequal data", Request::syncWrite(42, {{1, Bytes(2)}, {2, Bytes(3)}}));
        row("sync write over 250 bytes", Request::syncWrite(41, wide));
        row("raw nothing", Request::raw({}));
        row("raw over 250 bytes", Request::raw(Bytes(251)));
    }

    void refuses()
    {
        QFETCH(const Request, request);
        const auto bytes = feetechCodec().encode(request);
        QVERIFY(!bytes);
        QCOMPARE(bytes.error().code, base::ErrorCode::BadArgument);
        QVERIFY(!bytes.error().detail.isEmpty());
    }

    void longestPacketsPass_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<int>("size");
        std::vector<Target> thirty;
        for (int id = 0; id < 30; ++id)
            thirty.push_back({id, Bytes(7)});
        std::vector<int> many(242);
        std::iota(many.begin(), many.end(), 0);
        QTest::newRow("write 243") << Request::write(1, 0, Bytes(243), Repeat::Safe) << 250;
        QTest::newRow("sync write 30 × 7") << Request::syncWrite(41, thirty) << 248;
        QTest::newRow("sync read 242") << Request::syncRead(56, 2, many) << 250;
        QTest::newRow("read 244") << Request::read(1, 0, 244) << 8;
    }

    void longestPacketsPass()
    {
        QFETCH(const Request, request);
        QFETCH(const int, size);
        const auto bytes = feetechCodec().encode(request);
        QVERIFY(bytes);
        QCOMPARE(int(bytes->size()), size);
    }

    void expects_data()
    {
        QTest::addColumn<Request>("request");
        QTest::addColumn<std::vector<int>>("ids");
        QTest::addColumn<int>("replyBytes");
        const Request write = Request::write(7, 42, Bytes(6), Repeat::Safe);
        const auto row = [](const char* name, const Request& request, std::vector<int> ids,
                            int bytes) { QTest::newRow(name) << request << ids << bytes; };
        row("ping", Request::ping(7), {7}, 6);
        row("broadcast ping: anybody", Request::ping(254), {254}, 6);
        row("read", Request::read(7, 56, 15), {7}, 21);
        row("write", write, {7}, 6);
        row("broadcast write", Request::write(254, 5, Bytes(1), Repeat::Never), {}, 0);
        row("reg write", Request::regWrite(7, 42, Bytes(6), Repeat::Safe), {7}, 6);
        row("action, broadcast", Request::action(), {}, 0);
        row("action, one servo", Request::action(7), {7}, 6);
        row("restore", Request::restore(7), {7}, 6);
        row("back up", Request::backup(7), {7}, 6);
        row("state reset", Request::stateReset(7), {7}, 6);
        row("calibrate", Request::calibrate(7, 1024, ByteOrder::Little), {7}, 6);
        row("reboot is never answered", Request::reboot(7), {}, 0);
        row("sync read", Request::syncRead(56, 8, {7, 3}), {7, 3}, 14);
        row("sync write", syncWrite6({7}), {}, 0);
        row("level 0: write", unacknowledged(write), {}, 0);
        row("level 0: calibrate", unacknowledged(Request::calibrate(7, {}, ByteOrder::Little)), {},
            0);
        row("level 0: ping is answered", unacknowledged(Request::ping(7)), {7}, 6);
        row("level 0: read is answered", unacknowledged(Request::read(7, 0, 5)), {7}, 11);
        row("echo probe", feetechCodec().echoProbe(), {}, 0);
    }

    void expects()
    {
        QFETCH(const Request, request);
        QFETCH(const std::vector<int>, ids);
        QFETCH(const int, replyBytes);
        const Expectation expected = feetechCodec().expect(request);
        QCOMPARE(expected.ids, ids);
        QCOMPARE(expected.replyBytes, replyBytes);
    }

    void echoProbeEncodesAndIsNoReplyToItself()
    {
        const Request probe = feetechCodec().echoProbe();
        const auto frame = feetechCodec().encode(probe);
        QVERIFY(frame);
        Expectation broadcastPing;
        broadcastPing.ids = {broadcastId};
        broadcastPing.dataBytes = probe.count;
        broadcastPing.replyBytes = 6 + probe.count;
        QVERIFY(feetechCodec().scan(*frame, broadcastPing).kind != ScanKind::Reply);
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
        row("FF FF 01 02 01 FB", true, "PING 1");
        row("FF FF 01 02 01 FB", false, "STATUS 1 error 0x01");
        row("FF FF 01 02 00 FC", false, "STATUS 1");
        row("FF FF 01 04 02 38 0F B1", true, "READ 1 @56 ×15");
        row("FF FF 01 04 00 18 05 DD", false, "STATUS 1: 18 05");
        row("FF FF 01 04 00 18 05 DE", false, "STATUS 1: 18 05 (checksum wrong)");
        row("FF FF FE 04 03 05 01 F4", true, "WRITE all @5: 01");
        row("FF FF 01 04 0B 00 04 EB", true, "CALIBRATE 1: 00 04");
        row("FF FF FE 02 05 FA", true, "ACTION all");
        row("FF FF FE 06 82 38 08 01 02 36", true, "SYNC READ @56 ×8: 1, 2");
        row("FF FF FE 0A 83 1E 02 0B 00 00 0C 0A 14 1F", true,
            "SYNC WRITE @30 ×2: 11 = 00 00, 12 = 0A 14");
        row("FF FF 01 02 0D EF", true, "0x0d 1");
        row("FF FF 01", true, "bytes: FF FF 01");
        row("", false, "bytes");
    }

    void explains()
    {
        QFETCH(const QString, frame);
        QFETCH(const bool, fromHost);
        QFETCH(const QString, text);
        QCOMPARE(feetechCodec().explain(base::fromHex(frame).value(), fromHost), text);
    }
};

SERVODESK_GUILESS_TEST(TestFeetechEncode)
#include "tst_feetech_encode.moc"

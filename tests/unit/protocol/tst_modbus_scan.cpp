// SPDX-License-Identifier: GPL-3.0-or-later
// Modbus bytes to replies. Frames whose CRC is written out are those computed from the published
// rules; the others get theirs from the standard's algorithm, which has a check value of its own.
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using namespace protocol;
using base::Bytes;

namespace {
const Request feedback = Request::read(1, 2 * 256, 16);
const Request torqueOn = Request::write(1, 2 * 129, {0, 1}, Repeat::Safe);
const Request writeFourRegisters = Request::write(1, 2 * 128, Bytes(8), Repeat::Safe);
const Request pingRequest = Request::ping(254);

Expectation expectFor(const Request& request)
{
    return modbusCodec().expect(request);
}

/// Adds the CRC.
QString framed(const char* text)
{
    const Bytes bytes = hex(text);
    return base::toHex(encodeModbusReply(bytes[0], bytes[1], base::ByteView(bytes).subspan(2)));
}

/// Data that contain the beginnings of other frames.
const char* const feedbackData = "01 03 10 00 01 06 08 00 00 FA FF 38 01 83 00 2A";

QString feedbackReply(int station = 1)
{
    return base::toHex(encodeModbusReply(
        station, 3, hex(QStringLiteral("10 ") + QString::fromLatin1(feedbackData))));
}

const auto feedbackText = QStringLiteral("reply 1 00 [%1]").arg(QString::fromLatin1(feedbackData));
} // namespace

class TestModbusScan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void scans_data()
    {
        QTest::addColumn<Expectation>("expected");
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QStringList>("said");
        const auto row = [](const char* name, const Expectation& expected, const QString& bytes,
                            const QStringList& said) {
            QTest::newRow(name) << expected << bytes << said;
        };
        const auto text = [](const char* words) { return QString::fromLatin1(words); };
        const Expectation read = expectFor(feedback);
        const Expectation one = expectFor(torqueOn);
        const Expectation four = expectFor(writeFourRegisters);
        const Expectation broadcastPing = expectFor(pingRequest);
        const QString reply = feedbackReply();

        row("write of one", one, text("01 06 00 81 00 01 18 22"), {text("reply 1 00 []")});
        row("write of four", four, text("01 10 00 80 00 04 C0 22"), {text("reply 1 00 []")});
        row("who is there", broadcastPing, text("01 11 03 01 00 00 AC 4D"),
            {text("reply 1 00 [01 00 00]")});
        row("who is there, function as the vendor's table prints it", broadcastPing,
            framed("01 17 03 01 00 00"), {text("reply 1 00 [01 00 00]")});
        row("feedback", read, reply, {feedbackText});
        row("exception", read, text("01 83 02 C0 F1"), {text("reply 1 00 [] exception 2")});
        row("exception to a write of one", one, framed("01 86 03"),
            {text("reply 1 00 [] exception 3")});
        row("exception to a write of four", four, framed("01 90 01"),
            {text("reply 1 00 [] exception 1")});
        row("exception of another function", one, text("01 83 02 C0 F1"),
            {text("foreign 1 00 [] exception 2")});
        row("exception from elsewhere", read, framed("02 83 02"),
            {text("foreign 2 00 [] exception 2")});
        row("exception, bad CRC", read, text("01 83 02 C0 F2"), {text("bad 5")});
        row("noise, exception", read, text("7F 55 01 83 02 C0 F1"),
            {text("noise 2"), text("reply 1 00 [] exception 2")});

        row("acknowledgement of another register", one, framed("01 06 00 80 00 01"),
            {text("foreign 1 00 [00 80 00 01]")});
        row("acknowledgement of another value", one, framed("01 06 00 81 00 00"),
            {text("foreign 1 00 [00 81 00 00]")});
        row("acknowledgement of fewer registers", four, framed("01 10 00 80 00 03"),
            {text("foreign 1 00 [00 80 00 03]")});
        row("short reply", read, framed("01 03 02 00 01"), {text("foreign 1 00 [02 00 01]")});
        row("long reply", expectFor(Request::read(1, 0, 2)), framed("01 03 04 00 01 00 02"),
            {text("foreign 1 00 [04 00 01 00 02]")});
        row("reply of another function", one, framed("01 03 02 00 01"),
            {text("foreign 1 00 [02 00 01]")});
        row("another station", read, framed("02 03 04 00 01 00 02"),
            {text("foreign 2 00 [04 00 01 00 02]")});
        row("the reply may have begun inside another station's", read, feedbackReply(2),
            {text("wait 21")});
        row("another station, then the reply", read, framed("02 03 02 00 01") + u' ' + reply,
            {text("foreign 2 00 [02 00 01]"), feedbackText});
        row("echo of the read", read, text("01 03 01 00 00 08 45 F0 ") + reply,
            {text("foreign 1 00 [01 00 00 08]"), feedbackText});
        row("another master's broadcast", read, text("00 41 C1 80 ") + reply,
            {text("foreign 254 00 []"), feedbackText});
        row("Feetech frame before", read, text("FF FF 01 02 00 FC ") + reply,
            {text("noise 6"), feedbackText});

        row("bad CRC", one, text("01 06 00 81 00 01 18 23"), {text("bad 8")});
        row("CRC high byte first", one, text("01 06 00 81 00 01 22 18"), {text("bad 8")});
        row("bad CRC, then good", one, text("01 06 00 81 00 01 18 23 01 06 00 81 00 01 18 22"),
            {text("bad 8"), text("reply 1 00 []")});
        row("noise before", read, text("00 FE 55 ") + reply, {text("noise 3"), feedbackText});
        row("noise after", read, reply + text(" FE"), {feedbackText, text("noise 1")});
        row("station twice", read, text("01 ") + reply, {text("noise 1"), feedbackText});
        row("cut short, then the reply", read, text("01 03 10 00 01 ") + reply,
            {text("bad 5"), feedbackText});
        row("false beginning of a long frame", read, text("09 03 F0 11 ") + reply,
            {text("noise 4"), feedbackText});
        row("false beginning, reply not there yet", read, text("09 03 F0 11 01 03 10 00"),
            {text("wait 8")});
        row("two frames at once", one,
            text("01 06 00 81 00 01 18 22 ") + framed("02 06 00 81 00 01"),
            {text("reply 1 00 []"), text("foreign 2 00 [00 81 00 01]")});
        row("nothing expected: frames are foreign", Expectation{}, text("01 83 02 C0 F1 FE"),
            {text("foreign 1 00 [] exception 2"), text("noise 1")});
        row("half a reply", read, text("01 03 10 00"), {text("wait 4")});
        row("reason 0 is no exception", read, framed("01 83 00") + u' ' + reply,
            {text("noise 5"), feedbackText});
        row("station 0 does not answer", broadcastPing, framed("00 11 03 00 00 00"),
            {text("noise 1"), text("wait 7")});
    }

    void scans()
    {
        QFETCH(const Expectation, expected);
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(modbusCodec(), hex(bytes), expected, false), said);
    }

    void atDeadlineNothingIsPending_data()
    {
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QStringList>("said");
        QTest::newRow("half a reply")
            << QStringLiteral("01 03 10 00") << QStringList{QStringLiteral("noise 4")};
        QTest::newRow("a station")
            << QStringLiteral("01") << QStringList{QStringLiteral("noise 1")};
        QTest::newRow("foreign behind a false beginning")
            << QStringLiteral("09 03 F0 FE 01 83 02 C0 F1")
            << QStringList{QStringLiteral("noise 4"), QStringLiteral("reply 1 00 [] exception 2")};
    }

    void atDeadlineNothingIsPending()
    {
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(modbusCodec(), hex(bytes), expectFor(feedback), true), said);
    }

    void splitAtEveryByte_data()
    {
        QTest::addColumn<Expectation>("expected");
        QTest::addColumn<QString>("frame");
        QTest::newRow("read") << expectFor(feedback) << feedbackReply();
        QTest::newRow("write") << expectFor(torqueOn) << QStringLiteral("01 06 00 81 00 01 18 22");
        QTest::newRow("exception") << expectFor(feedback) << QStringLiteral("01 83 02 C0 F1");
        QTest::newRow("who is there")
            << expectFor(pingRequest) << QStringLiteral("01 11 03 01 00 00 AC 4D");
    }

    void splitAtEveryByte()
    {
        QFETCH(const Expectation, expected);
        QFETCH(const QString, frame);
        const Bytes bytes = hex(frame);
        for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
            const base::ByteView front = base::ByteView(bytes).first(cut);
            QCOMPARE(modbusCodec().scan(front, expected).kind, ScanKind::Incomplete);
        }
        QCOMPARE(modbusCodec().scan(bytes, expected).kind, ScanKind::Reply);
    }

    void idWriteIsAcknowledgedFromEitherStation_data()
    {
        QTest::addColumn<int>("from");
        QTest::addColumn<ScanKind>("kind");
        QTest::newRow("old") << 1 << ScanKind::Reply;
        QTest::newRow("new") << 5 << ScanKind::Reply;
        QTest::newRow("third") << 6 << ScanKind::Foreign;
    }

    void idWriteIsAcknowledgedFromEitherStation()
    {
        QFETCH(const int, from);
        QFETCH(const ScanKind, kind);
        Request request = Request::write(1, 2 * 10, {0, 5}, Repeat::Never);
        request.alternateReplyId = 5;
        const Bytes frame = encodeModbusReply(from, 6, hex("00 0A 00 05"));
        const ScanResult result = modbusCodec().scan(frame, expectFor(request));
        QCOMPARE(result.kind, kind);
        QCOMPARE(result.part.id, from);
    }

    void randomLines_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    /// Noise, half frames and foreign frames ahead of one good reply, delivered in pieces: the
    /// reply is found with the right data, and nothing else is taken for it.
    void randomLines()
    {
        QFETCH(const quint32, seed);
        std::mt19937 random(seed);
        const auto below = [&](unsigned limit) { return unsigned(random() % limit); };
        for (int round = 0; round < 300; ++round) {
            const int station = 1 + int(below(247));
            const int count = 2 * int(1 + below(8));
            const auto words = [&](int bytes) {
                Bytes made{std::uint8_t(bytes)};
                while (int(made.size()) <= bytes)
                    made.push_back(below(4) == 0 ? std::uint8_t(station) : std::uint8_t(random()));
                return made;
            };
            Bytes line;
            const auto append = [&](const Bytes& more) {
                line.insert(line.end(), more.begin(), more.end());
            };
            for (unsigned piece = below(4); piece > 0; --piece) {
                Bytes frame = encodeModbusReply(below(2) ? station : 1 + (station % 247), 3,
                                                words(count + 2));
                frame.resize(below(unsigned(frame.size()) + 1));
                append(below(2) ? frame : words(int(below(20))));
            }
            const Bytes content = words(count);
            append(encodeModbusReply(station, 3, content));

            const Expectation expected = expectFor(Request::read(station, 0, count));
            Bytes buffer;
            std::vector<Reply> replies;
            for (std::size_t at = 0; at < line.size();) {
                const std::size_t chunk = std::min<std::size_t>(1 + below(20), line.size() - at);
                const auto from = line.begin() + std::ptrdiff_t(at);
                buffer.insert(buffer.end(), from, from + std::ptrdiff_t(chunk));
                at += chunk;
                while (!buffer.empty()) {
                    const ScanResult result = modbusCodec().scan(buffer, expected);
                    if (result.kind == ScanKind::Incomplete)
                        break;
                    QVERIFY(result.consumed > 0 && result.consumed <= buffer.size());
                    buffer.erase(buffer.begin(), buffer.begin() + std::ptrdiff_t(result.consumed));
                    if (result.kind == ScanKind::Reply)
                        replies.push_back(result.part);
                }
            }
            const QByteArray shown = base::toHex(line).toLatin1();
            QVERIFY2(replies.size() == 1, shown.constData());
            QVERIFY2(replies.front().data == Bytes(content.begin() + 1, content.end()) &&
                         replies.front().id == station,
                     shown.constData());
        }
    }

    void requestsAsAStationReceivesThem_data()
    {
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const QString& bytes, const char* said) {
            QTest::newRow(name) << bytes << QString::fromLatin1(said);
        };
        const auto text = [](const char* words) { return QString::fromLatin1(words); };
        row("read", text("01 03 01 00 00 08 45 F0"), "8: reply 1 03 [01 00 00 08]");
        row("write one", text("01 06 00 81 00 01 18 22"), "8: reply 1 06 [00 81 00 01]");
        row("write four", text("01 10 00 80 00 04 08 08 00 00 01 00 0A 00 32 29 B5"),
            "17: reply 1 10 [00 80 00 04 08 08 00 00 01 00 0A 00 32]");
        row("report", text("00 11 C1 BC"), "4: reply 254 11 []");
        row("reboot", text("01 41 C0 10"), "4: reply 1 41 []");
        row("unknown function", framed("01 05 00 00 FF 00"), "8: reply 1 05 [00 00 FF 00]");
        row("unknown function, half", text("01 05 00 00 FF"), "0: wait");
        row("half", text("01 03 01 00 00 08 45"), "0: wait");
        row("half a write", text("01 10 00 80 00 04"), "0: wait");
        row("nothing", QString(), "0: wait");
        row("bad CRC", text("01 03 01 00 00 08 45 F1"), "8: bad");
        row("another station's reply", feedbackReply(2), "21: noise");
        row("another station's exception", text("01 83 02 C0 F1"), "5: noise");
        row("Feetech", text("FF FF 01 02 01 FB"), "1: noise");
    }

    void requestsAsAStationReceivesThem()
    {
        QFETCH(const QString, bytes);
        QFETCH(const QString, said);
        const RequestScan scan = scanModbusRequest(hex(bytes));
        QString words = QStringLiteral("%1: ").arg(scan.consumed) + kindName(scan.kind);
        if (scan.kind == ScanKind::Reply)
            words += QStringLiteral(" %1 %2 [%3]")
                         .arg(scan.id)
                         .arg(scan.instruction, 2, 16, QLatin1Char('0'))
                         .arg(base::toHex(scan.params));
        QCOMPARE(words, said);
    }

    void repliesOfAStation_data()
    {
        QTest::addColumn<int>("function");
        QTest::addColumn<QString>("data");
        QTest::addColumn<QString>("frame");
        QTest::newRow("write one")
            << 0x06 << QStringLiteral("00 81 00 01") << QStringLiteral("01 06 00 81 00 01 18 22");
        QTest::newRow("write four")
            << 0x10 << QStringLiteral("00 80 00 04") << QStringLiteral("01 10 00 80 00 04 C0 22");
        QTest::newRow("report") << 0x11 << QStringLiteral("03 01 00 00")
                                << QStringLiteral("01 11 03 01 00 00 AC 4D");
        QTest::newRow("exception")
            << 0x83 << QStringLiteral("02") << QStringLiteral("01 83 02 C0 F1");
    }

    void repliesOfAStation()
    {
        QFETCH(const int, function);
        QFETCH(const QString, data);
        QFETCH(const QString, frame);
        QCOMPARE(base::toHex(encodeModbusReply(1, std::uint8_t(function), hex(data))), frame);
    }
};

SERVODESK_GUILESS_TEST(TestModbusScan)
#include "tst_modbus_scan.moc"

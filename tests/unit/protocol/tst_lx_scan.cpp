// SPDX-License-Identifier: GPL-3.0-or-later
// LX bytes to replies. Good frames are those computed from the maker's rules; everything around
// them is what a bad line makes of them.
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using namespace protocol;
using base::Bytes;

namespace {
Expectation reading(int id, int code, int count)
{
    return lxCodec().expect(Request::read(id, 8 * code, count));
}

const auto lxReply1 = QStringLiteral("55 55 01 05 1C FD FF E1 ");
const auto lxReply1Text = QStringLiteral("reply 1 00 [FD FF]");
} // namespace

class TestLxScan : public QObject {
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
        const Expectation position = reading(1, 28, 2);
        const Expectation broadcastPing = lxCodec().expect(Request::ping(254));

        row("position -3", position, lxReply1, {lxReply1Text});
        row("voltage 7400 mV", reading(1, 27, 2), text("55 55 01 05 1B E8 1C DA"),
            {text("reply 1 00 [E8 1C]")});
        row("offset -125", reading(1, 19, 1), text("55 55 01 04 13 83 64"),
            {text("reply 1 00 [83]")});
        row("who is there", broadcastPing, text("55 55 07 04 0E 07 DF"), {text("reply 7 00 [07]")});
        row("ping", lxCodec().expect(Request::ping(7)), text("55 55 07 04 0E 07 DF"),
            {text("reply 7 00 [07]")});

        row("late reply of another command, same length", reading(1, 27, 2), lxReply1,
            {text("foreign 1 00 [FD FF]")});
        row("late reply, then the answer", position, text("55 55 01 05 1B E8 1C DA ") + lxReply1,
            {text("foreign 1 00 [E8 1C]"), lxReply1Text});
        row("short reply", position, text("55 55 01 04 1C FD E1"), {text("foreign 1 00 [FD]")});
        row("long reply", position, text("55 55 01 06 1C FD FF 00 E0"),
            {text("foreign 1 00 [FD FF 00]")});
        row("foreign ID", position, text("55 55 02 05 1C FD FF E0"),
            {text("foreign 2 00 [FD FF]")});
        row("foreign, then the reply", position, text("55 55 02 05 1C FD FF E0 ") + lxReply1,
            {text("foreign 2 00 [FD FF]"), lxReply1Text});
        row("echo of the request", position, text("55 55 01 03 1C DF ") + lxReply1,
            {text("foreign 1 00 []"), lxReply1Text});
        row("echo of who is there", broadcastPing, text("55 55 FE 03 0E F0 55 55 07 04 0E 07 DF"),
            {text("foreign 254 00 []"), text("reply 7 00 [07]")});

        row("bad sum", position, text("55 55 01 05 1C FD FF E2"), {text("bad 8")});
        row("bad sum, then good", position, text("55 55 01 05 1C FC FF E1 ") + lxReply1,
            {text("bad 8"), lxReply1Text});
        row("bad sum of a foreign frame", position, text("55 55 02 05 1C FD FF E1"),
            {text("noise 8")});
        row("noise before", position, text("00 AA ") + lxReply1, {text("noise 2"), lxReply1Text});
        row("noise after", position, lxReply1 + text("00"), {lxReply1Text, text("noise 1")});
        row("one 55 before", position, text("55 ") + lxReply1, {text("noise 1"), lxReply1Text});
        row("many 55 before", position, text("55 55 55 55 55 ") + lxReply1,
            {text("noise 5"), lxReply1Text});
        row("false header", position, text("55 55 09 07 11 ") + lxReply1,
            {text("noise 5"), lxReply1Text});
        row("false header, reply not there yet", position, text("55 55 09 0B 11 55 55 01"),
            {text("wait 8")});
        row("LEN too small", position, text("55 55 01 02 FC ") + lxReply1,
            {text("noise 5"), lxReply1Text});
        row("LEN too large", position, text("55 55 01 0C ") + lxReply1,
            {text("noise 4"), lxReply1Text});
        row("cut short, then the reply", position, text("55 55 01 05 1C FD ") + lxReply1,
            {text("bad 6"), lxReply1Text});
        row("two at once", position, lxReply1 + text("55 55 01 05 1B E8 1C DA"),
            {lxReply1Text, text("foreign 1 00 [E8 1C]")});
        row("data that look like a header", reading(1, 21, 4),
            text("55 55 01 07 15 55 55 01 07 30"), {text("reply 1 00 [55 55 01 07]")});
        row("both readings valid: the expected one counts", lxCodec().expect(Request::ping(1)),
            text("55 55 05 0A 1C 55 55 01 04 0E 01 EB 2F"),
            {text("noise 5"), text("reply 1 00 [01]"), text("noise 1")});
        row("the reply may have begun inside a frame", position, text("55 55 05 05 28 55 55 23"),
            {text("foreign 5 00 [55 55]")});
        row("the reply may have begun at the end of a frame", position,
            text("55 55 02 05 1C 00 87 55"), {text("wait 8")});
        row("two servos of one ID: collision", position, text("55 55 01 05 1C FF FF E1"),
            {text("bad 8")});
        row("Feetech frame before", position, text("FF FF 01 02 00 FC ") + lxReply1,
            {text("noise 6"), lxReply1Text});
        row("nothing expected: frames are foreign", Expectation{}, lxReply1 + text("00"),
            {text("foreign 1 00 [FD FF]"), text("noise 1")});
        row("half a frame", position, text("55 55 01 05 1C"), {text("wait 5")});
        row("half a header", position, text("55"), {text("wait 1")});
    }

    void scans()
    {
        QFETCH(const Expectation, expected);
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(lxCodec(), hex(bytes), expected, false), said);
    }

    void atDeadlineNothingIsPending_data()
    {
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QStringList>("said");
        QTest::newRow("half a frame")
            << QStringLiteral("55 55 01 05 1C") << QStringList{QStringLiteral("noise 5")};
        QTest::newRow("half a header")
            << QStringLiteral("55") << QStringList{QStringLiteral("noise 1")};
        QTest::newRow("foreign behind a false header")
            << QStringLiteral("55 55 09 0B 11 55 55 02 04 0E 02 E9")
            << QStringList{QStringLiteral("noise 5"), QStringLiteral("foreign 2 00 [02]")};
        QTest::newRow("foreign with the beginning of a header at its end")
            << QStringLiteral("55 55 02 05 1C 00 87 55")
            << QStringList{QStringLiteral("foreign 2 00 [00 87]")};
    }

    void atDeadlineNothingIsPending()
    {
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(lxCodec(), hex(bytes), reading(1, 28, 2), true), said);
    }

    void splitAtEveryByte()
    {
        const Expectation expected = reading(1, 21, 4);
        const Bytes frame = hex("55 55 01 07 15 55 55 01 07 30");
        for (std::size_t cut = 1; cut < frame.size(); ++cut) {
            const base::ByteView front = base::ByteView(frame).first(cut);
            QCOMPARE(lxCodec().scan(front, expected).kind, ScanKind::Incomplete);
        }
        QCOMPARE(lxCodec().scan(frame, expected).kind, ScanKind::Reply);
    }

    void randomLines_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    /// Noise, half frames, foreign frames and late replies of other commands ahead of one good
    /// reply, delivered in pieces: the reply is found, and nothing else is taken for it.
    void randomLines()
    {
        QFETCH(const quint32, seed);
        std::mt19937 random(seed);
        const auto below = [&](unsigned limit) { return unsigned(random() % limit); };
        const auto bytes = [&](unsigned count) {
            Bytes made(count);
            for (auto& byte : made)
                byte = below(4) == 0 ? 0x55 : std::uint8_t(random());
            return made;
        };
        for (int round = 0; round < 500; ++round) {
            const int id = int(below(254));
            const int code = 2 + int(below(34));
            const Bytes data = bytes(1 + below(4));
            Bytes line;
            const auto append = [&](const Bytes& more) {
                line.insert(line.end(), more.begin(), more.end());
            };
            for (unsigned piece = below(4); piece > 0; --piece) {
                // Half a frame of another command: one of the very shape passes an 8-bit sum
                // 1 time in 256.
                Bytes frame = encodeLxReply(id, std::uint8_t(code + 1), bytes(1 + below(4)));
                if (below(2))
                    frame.resize(below(unsigned(frame.size())));
                append(below(2) ? frame : bytes(below(20)));
            }
            append(encodeLxReply(id, std::uint8_t(code), data));

            const Expectation expected = reading(id, code, int(data.size()));
            Bytes buffer;
            std::vector<Reply> replies;
            for (std::size_t at = 0; at < line.size();) {
                const std::size_t chunk = std::min<std::size_t>(1 + below(20), line.size() - at);
                const auto from = line.begin() + std::ptrdiff_t(at);
                buffer.insert(buffer.end(), from, from + std::ptrdiff_t(chunk));
                at += chunk;
                while (!buffer.empty()) {
                    const ScanResult result = lxCodec().scan(buffer, expected);
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
            QVERIFY2(replies.front().data == data && replies.front().id == id, shown.constData());
        }
    }

    void requestsAsAServoReceivesThem()
    {
        Bytes line = hex("00 55 55 55 01 07 01 F4 01 E8 03 16 55 55 FE 03 0B F3 "
                         "55 55 01 03 1C DE 55 55 01");
        const auto next = [&] {
            const RequestScan scan = scanLxRequest(line);
            line.erase(line.begin(), line.begin() + std::ptrdiff_t(scan.consumed));
            return scan;
        };
        const RequestScan noise = next();
        QCOMPARE(noise.kind, ScanKind::Noise);
        QCOMPARE(noise.consumed, std::size_t(2));
        const RequestScan move = next();
        QCOMPARE(move.kind, ScanKind::Reply);
        QCOMPARE(move.id, 1);
        QCOMPARE(int(move.instruction), 1);
        QCOMPARE(base::toHex(move.params), QStringLiteral("F4 01 E8 03"));
        const RequestScan start = next();
        QCOMPARE(start.kind, ScanKind::Reply);
        QCOMPARE(start.id, 254);
        QCOMPARE(next().kind, ScanKind::BadChecksum);
        QCOMPARE(next().kind, ScanKind::Incomplete);
        QCOMPARE(line.size(), std::size_t(3));
    }

    void repliesOfAServo()
    {
        QCOMPARE(base::toHex(encodeLxReply(1, 28, hex("FD FF"))), lxReply1.trimmed());
        QCOMPARE(base::toHex(encodeLxReply(7, 14, hex("07"))),
                 QStringLiteral("55 55 07 04 0E 07 DF"));
    }
};

SERVODESK_GUILESS_TEST(TestLxScan)
#include "tst_lx_scan.moc"

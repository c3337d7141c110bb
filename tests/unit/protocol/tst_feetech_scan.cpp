// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes to replies. Good frames are the vendor's worked examples; everything around them is what
// a bad line makes of them.
#include "support/test_main.h"
#include "unit/protocol/scan_text.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using namespace protocol;
using base::Bytes;

namespace {
Expectation expectFrom(std::vector<int> ids, int dataBytes)
{
    Expectation expected;
    expected.ids = std::move(ids);
    expected.dataBytes = dataBytes;
    expected.replyBytes = 6 + dataBytes;
    return expected;
}

const auto reply1 = QStringLiteral("FF FF 01 04 00 18 05 DD ");
const auto reply1Text = QStringLiteral("reply 1 00 [18 05]");
} // namespace

class TestFeetechScan : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void scans_data()
    {
        QTest::addColumn<Expectation>("expected");
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QStringList>("said");
        const Expectation read2 = expectFrom({1}, 2);
        const Expectation ack = expectFrom({1}, 0);
        const Expectation nothing;
        const auto row = [](const char* name, const Expectation& expected, const QString& bytes,
                            const QStringList& said) {
            QTest::newRow(name) << expected << bytes << said;
        };
        const auto text = [](const char* words) { return QString::fromLatin1(words); };

        row("ping reply", ack, text("FF FF 01 02 00 FC"), {text("reply 1 00 []")});
        row("read reply 1304", read2, reply1, {reply1Text});
        row("error byte is data", ack, text("FF FF 01 02 20 DC"), {text("reply 1 20 []")});
        row("sync read replies", expectFrom({1, 2}, 8),
            text("FF FF 01 0A 00 00 08 00 00 00 00 79 1E 55 "
                 "FF FF 02 0A 00 FF 07 00 00 00 00 77 23 53"),
            {text("reply 1 00 [00 08 00 00 00 00 79 1E]"),
             text("reply 2 00 [FF 07 00 00 00 00 77 23]")});
        row("sync read, out of order", expectFrom({2, 1}, 8),
            text("FF FF 01 0A 00 00 08 00 00 00 00 79 1E 55"),
            {text("reply 1 00 [00 08 00 00 00 00 79 1E]")});
        row("anybody", expectFrom({254}, 0), text("FF FF 7B 02 00 82"), {text("reply 123 00 []")});

        row("bad sum", read2, text("FF FF 01 04 00 18 05 DE"), {text("bad 8")});
        row("bad sum, then good", read2, text("FF FF 01 04 00 19 05 DD ") + reply1,
            {text("bad 8"), reply1Text});
        row("short reply of the same ID", read2, text("FF FF 01 02 00 FC"),
            {text("foreign 1 00 []")});
        row("long reply of the same ID", read2, text("FF FF 01 05 00 18 05 00 DC"),
            {text("foreign 1 00 [18 05 00]")});
        row("foreign ID", read2, text("FF FF 02 04 00 18 05 DC"), {text("foreign 2 00 [18 05]")});
        row("foreign, then the reply", read2, text("FF FF 02 02 00 FB ") + reply1,
            {text("foreign 2 00 []"), reply1Text});
        row("echo of the request first", read2, text("FF FF 01 04 02 38 02 BE "),
            {text("reply 1 02 [38 02]")});
        row("echo of a longer request", expectFrom({1}, 15), text("FF FF 01 04 02 38 0F B1"),
            {text("foreign 1 02 [38 0f]").replace(QLatin1String("0f"), QLatin1String("0F"))});

        row("noise before", read2, text("00 55 AA ") + reply1, {text("noise 3"), reply1Text});
        row("noise after", read2, reply1 + text("00 55"), {reply1Text, text("noise 2")});
        row("one FF before", read2, text("FF ") + reply1, {text("noise 1"), reply1Text});
        row("many FF before", read2, text("FF FF FF FF FF ") + reply1,
            {text("noise 5"), reply1Text});
        row("noise with a false header", read2, text("12 FF FF 01 04 ") + reply1,
            {text("noise 1"), text("bad 4"), reply1Text});
        row("false header of a long frame", read2, text("FF FF 09 F0 11 ") + reply1,
            {text("noise 5"), reply1Text});
        row("false header, reply not there yet", read2, text("FF FF 09 F0 11 FF FF 01"),
            {text("wait 8")});
        row("LEN too small", read2, text("FF FF 01 01 FD ") + reply1,
            {text("noise 5"), reply1Text});
        row("LEN over the cap", read2, text("FF FF 01 F7 ") + reply1,
            {text("noise 4"), reply1Text});
        row("cut short, then the next servo", expectFrom({1, 2}, 2),
            text("FF FF 01 04 00 18 FF FF 02 04 00 19 05 DB"),
            {text("bad 6"), text("reply 2 00 [19 05]")});
        row("cut within the header, then the next", expectFrom({1, 2}, 2),
            text("FF FF 01 FF FF 02 04 00 19 05 DB"),
            {text("noise 3"), text("reply 2 00 [19 05]")});
        row("two at once", expectFrom({1, 2}, 2), reply1 + text("FF FF 02 04 00 19 05 DB"),
            {reply1Text, text("reply 2 00 [19 05]")});
        row("data that looks like headers", expectFrom({1}, 6),
            text("FF FF 01 08 00 FF FF 01 08 FF FF F1"), {text("reply 1 00 [FF FF 01 08 FF FF]")});
        row("both readings valid: the expected one counts", ack,
            text("FF FF 05 08 00 FF FF 01 02 00 FC F5"),
            {text("noise 5"), text("reply 1 00 []"), text("noise 1")});

        row("the reply may have begun inside a frame", ack, text("FF FF 05 04 F9 FF FF FF"),
            {text("wait 8")});
        row("nothing expected: frames are foreign", nothing, reply1 + text("00"),
            {text("foreign 1 00 [18 05]"), text("noise 1")});
        row("half a frame", read2, text("FF FF 01 04 00 18"), {text("wait 6")});
        row("half a header", read2, text("FF"), {text("wait 1")});
        row("noise, half a header", read2, text("33 FF"), {text("noise 1"), text("wait 1")});
    }

    void scans()
    {
        QFETCH(const Expectation, expected);
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(feetechCodec(), hex(bytes), expected, false), said);
    }

    void atDeadlineNothingIsPending_data()
    {
        QTest::addColumn<QString>("bytes");
        QTest::addColumn<QStringList>("said");
        QTest::newRow("half a frame")
            << QStringLiteral("FF FF 01 04 00 18") << QStringList{QStringLiteral("noise 6")};
        QTest::newRow("half a header")
            << QStringLiteral("FF") << QStringList{QStringLiteral("noise 1")};
        QTest::newRow("foreign behind a false header")
            << QStringLiteral("FF FF 09 F0 11 FF FF 02 02 00 FB")
            << QStringList{QStringLiteral("noise 5"), QStringLiteral("foreign 2 00 []")};
        QTest::newRow("bad reply behind a false header")
            << QStringLiteral("FF FF 09 F0 11 FF FF 01 04 00 18 05 DE")
            << QStringList{QStringLiteral("noise 5"), QStringLiteral("bad 8")};
    }

    void atDeadlineNothingIsPending()
    {
        QFETCH(const QString, bytes);
        QFETCH(const QStringList, said);
        QCOMPARE(verdicts(feetechCodec(), hex(bytes), expectFrom({1}, 2), true), said);
    }

    void splitAtEveryByte()
    {
        const Expectation expected = expectFrom({1}, 8);
        const Bytes frame = hex(QStringLiteral("FF FF 01 0A 00 00 08 00 00 FF FF 79 1E 57"));
        for (std::size_t cut = 1; cut < frame.size(); ++cut) {
            const base::ByteView front = base::ByteView(frame).first(cut);
            QCOMPARE(feetechCodec().scan(front, expected).kind, ScanKind::Incomplete);
        }
        QCOMPARE(feetechCodec().scan(frame, expected).kind, ScanKind::Reply);
    }

    void idWriteIsAcknowledgedFromEitherId_data()
    {
        QTest::addColumn<int>("from");
        QTest::addColumn<bool>("accepted");
        QTest::newRow("old") << 1 << true;
        QTest::newRow("new") << 5 << true;
        QTest::newRow("third") << 6 << false;
    }

    void idWriteIsAcknowledgedFromEitherId()
    {
        QFETCH(const int, from);
        QFETCH(const bool, accepted);
        Request request = Request::write(1, 5, {5}, Repeat::Never);
        request.alternateReplyId = 5;
        const Bytes frame = encodeFeetechStatus(from, 0, {});
        const ScanResult result = feetechCodec().scan(frame, feetechCodec().expect(request));
        QCOMPARE(result.kind == ScanKind::Reply, accepted);
        QCOMPARE(result.part.id, from);
    }

    void randomLines_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 20; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    /// Noise, half frames and foreign frames ahead of one good reply, delivered in pieces: the
    /// reply is found with the right data, and nothing else is taken for it. The half frames are
    /// of another length: half a frame of the very shape passes an 8-bit checksum 1 time in 256.
    void randomLines()
    {
        QFETCH(const quint32, seed);
        std::mt19937 random(seed);
        const auto below = [&](unsigned limit) { return unsigned(random() % limit); };
        const auto bytes = [&](unsigned count) {
            Bytes made(count);
            for (auto& byte : made)
                byte = below(4) == 0 ? 0xFF : std::uint8_t(random());
            return made;
        };
        for (int round = 0; round < 500; ++round) {
            const int id = int(below(254));
            const Bytes data = bytes(below(16));
            const Expectation expected = expectFrom({id}, int(data.size()));
            Bytes line;
            const auto append = [&](const Bytes& more) {
                line.insert(line.end(), more.begin(), more.end());
            };
            for (unsigned piece = below(4); piece > 0; --piece) {
                const int other = (id + 1 + int(below(252))) % 254;
                Bytes frame = encodeFeetechStatus(below(2) ? id : other, 0,
                                                  bytes(unsigned(data.size()) + 1 + below(8)));
                switch (below(3)) {
                case 0:
                    append(bytes(below(30)));
                    break;
                case 1:
                    append(encodeFeetechStatus(other, 0, bytes(below(16))));
                    break;
                case 2:
                    frame.resize(below(unsigned(frame.size())));
                    append(frame);
                    break;
                }
            }
            const std::uint8_t status = std::uint8_t(below(64));
            append(encodeFeetechStatus(id, status, data));

            Bytes buffer;
            std::vector<Reply> replies;
            for (std::size_t at = 0; at < line.size();) {
                const std::size_t chunk = std::min<std::size_t>(1 + below(20), line.size() - at);
                buffer.insert(buffer.end(), line.begin() + std::ptrdiff_t(at),
                              line.begin() + std::ptrdiff_t(at + chunk));
                at += chunk;
                while (!buffer.empty()) {
                    const ScanResult result = feetechCodec().scan(buffer, expected);
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
            QVERIFY2(replies.front().data == data && replies.front().status == status &&
                         replies.front().id == id,
                     shown.constData());
        }
    }

    void requestsAsAServoReceivesThem()
    {
        Bytes line = hex(QStringLiteral("00 FF FF FF 01 04 02 38 0F B1 FF FF 01 02 0D EF "
                                        "FF FF 01 02 01 FA FF FF 01"));
        const auto next = [&] {
            const RequestScan scan = scanFeetechRequest(line);
            line.erase(line.begin(), line.begin() + std::ptrdiff_t(scan.consumed));
            return scan;
        };
        QCOMPARE(next().kind, ScanKind::Noise);
        const RequestScan read = next();
        QCOMPARE(read.kind, ScanKind::Reply);
        QCOMPARE(read.id, 1);
        QCOMPARE(int(read.instruction), 2);
        QCOMPARE(read.params, (Bytes{56, 15}));
        const RequestScan unknown = next();
        QCOMPARE(unknown.kind, ScanKind::Reply);
        QCOMPARE(int(unknown.instruction), 0x0D);
        QCOMPARE(next().kind, ScanKind::BadChecksum);
        QCOMPARE(next().kind, ScanKind::Incomplete);
        QCOMPARE(line.size(), std::size_t(3));
    }

    void statusPackets_data()
    {
        QTest::addColumn<int>("id");
        QTest::addColumn<QString>("data");
        QTest::addColumn<QString>("frame");
        QTest::newRow("ping") << 1 << QString() << QStringLiteral("FF FF 01 02 00 FC");
        QTest::newRow("1304") << 1 << QStringLiteral("18 05")
                              << QStringLiteral("FF FF 01 04 00 18 05 DD");
        QTest::newRow("sync read") << 2 << QStringLiteral("FF 07 00 00 00 00 77 23")
                                   << QStringLiteral("FF FF 02 0A 00 FF 07 00 00 00 00 77 23 53");
    }

    void statusPackets()
    {
        QFETCH(const int, id);
        QFETCH(const QString, data);
        QFETCH(const QString, frame);
        QCOMPARE(base::toHex(encodeFeetechStatus(id, 0, hex(data))), frame);
    }
};

SERVODESK_GUILESS_TEST(TestFeetechScan)
#include "tst_feetech_scan.moc"

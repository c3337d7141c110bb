// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-sim as any program sees it: a client of raw system calls sends the published worked
// frames and compares bytes. Nothing of our own protocol code is used here.
#include "integration/raw_client.h"
#include "support/test_main.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using raw::bytes;
using raw::Client;
using raw::Simulator;

namespace {
// Acknowledgement of ID 1, no alarm: the published reply to PING 1.
const char* const pingOne = "FFFF010201FB";
const QByteArray fine = bytes("FFFF010200FC");

QStringList list(const char* arguments)
{
    return QString::fromLatin1(arguments).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

QStringList stsWithState(const QString& file)
{
    return list("--servos sts3215@1,scs15@2 --eprom-ms 1 --state") << file;
}

bool hasValidChecksum(const QByteArray& frame)
{
    unsigned sum = 0;
    for (qsizetype i = 2; i + 1 < frame.size(); ++i)
        sum += static_cast<unsigned char>(frame[i]);
    return frame.size() >= 6 &&
           static_cast<unsigned char>(frame.back()) == static_cast<unsigned char>(~sum);
}
} // namespace

class TestServodeskSim : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void announcesItsPortFirst()
    {
        Simulator simulator({});
        QVERIFY(QRegularExpression(QStringLiteral("^port: /dev/\\S+\\n$"))
                    .match(simulator.firstLine())
                    .hasMatch());
        QVERIFY(QFile::exists(simulator.port()));
        Client client(simulator.port());
        QCOMPARE(client.ask(pingOne, 6), fine);
        QCOMPARE(simulator.end(), 0);
    }

    void answersThePublishedFrames()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2,sts3215@3,sts3215@4 --eprom-ms 1"));
        Client client(simulator.port());
        QVERIFY(client.isOpen());
        QCOMPARE(client.ask(pingOne, 6), fine);
        // Identity: firmware 3.10, little-endian, model 9.3.
        QCOMPARE(client.ask("FFFF0104020005F3", 11), bytes("FFFF010700030A000903DE"));
        // Position 2048, time 0, speed 1000 at once, and read back.
        QCOMPARE(client.ask("FFFF0109032A00080000E803D5", 6), fine);
        QCOMPARE(client.ask("FFFF0104022A06C8", 12), bytes("FFFF0108000008 0000E80303"));
        // The same held and carried out later: flag 64 tells.
        QCOMPARE(client.ask("FFFF0105032A1805AF", 6), fine);
        QCOMPARE(client.ask("FFFF0109042A00080000E803D4", 6), fine);
        QCOMPARE(client.ask("FFFF0104024001B7", 7), bytes("FFFF01030001FA"));
        QCOMPARE(client.ask("FFFF0104022A02CC", 8), bytes("FFFF0104001805DD"));
        client.send(bytes("FFFFFE0205FA"));
        QCOMPARE(client.ask("FFFF0104024001B7", 7), bytes("FFFF01030000FB"));
        QCOMPARE(client.ask("FFFF0104022A02CC", 8), bytes("FFFF0104000008F2"));
        // SYNC WRITE to four servos, unanswered.
        client.send(bytes("FFFFFE20832A0601000800 00E80302000800 00E80303000800 00E80304000800 "
                          "00E80358"));
        QCOMPARE(client.ask("FFFF0404022A02C9", 8), bytes("FFFF0404000008EF"));
        // STS burst: acceleration 50, position -1000, speed 2400.
        QCOMPARE(client.ask("FFFF010A032932E883000060 09C2", 6), fine);
        QCOMPARE(client.ask("FFFF0104022907C8", 13), bytes("FFFF01090032E883000060 09EF"));
        // State reset and calibration, plain and with a value.
        QCOMPARE(client.ask("FFFF01020AF2", 6), fine);
        QCOMPARE(client.requestUntilReply("FFFF01020BF1", 6), fine);
        QCOMPARE(client.requestUntilReply("FFFF01040B0004EB", 6), fine);
        QCOMPARE(client.requestUntilReply(pingOne, 6), fine);
    }

    void syncReadIsAnsweredInOrder()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2"));
        Client client(simulator.port());
        const QByteArray replies = client.ask("FFFFFE068238080102 36", 28);
        QCOMPARE(replies.size(), 28);
        for (const int id : {1, 2}) {
            const QByteArray reply = replies.mid((id - 1) * 14, 14);
            QVERIFY(reply.startsWith(bytes(id == 1 ? "FFFF010A00" : "FFFF020A00")));
            QVERIFY2(hasValidChecksum(reply), reply.toHex().constData());
        }
    }

    void speedAndPwmCarryTheirSignBits()
    {
        Simulator simulator(list("--servos sts3215@1 --eprom-ms 1"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF0105032EE8835D", 6), fine);
        QCOMPARE(client.ask("FFFF0104022E02C8", 8), bytes("FFFF010400E8838F"));
        QCOMPARE(client.ask("FFFF0105032CC804FE", 6), fine);
        QCOMPARE(client.ask("FFFF0104022C02CA", 8), bytes("FFFF010400C8042E"));
    }

    void scsIsBigEndian()
    {
        Simulator simulator(list("--servos scs15@1 --eprom-ms 1"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF0104020005F3", 11), bytes("FFFF0107000004 01050FDE"));
        // Position 512 in 1000 ms.
        QCOMPARE(client.ask("FFFF0109032A020003E80000DB", 6), fine);
        QCOMPARE(client.ask("FFFF0104022A06C8", 12), bytes("FFFF010800020003E8000009"));
        // Its lock is 48.
        QCOMPARE(client.ask("FFFF0104033000C7", 6), fine);
        QCOMPARE(client.ask("FFFF0104023001C7", 7), bytes("FFFF01030000FB"));
        QCOMPARE(client.ask("FFFF0104033001C6", 6), fine);
        QCOMPARE(client.ask("FFFF0104023001C7", 7), bytes("FFFF01030001FA"));
    }

    void anIdChangeTakesEffectAtOnce_data()
    {
        QTest::addColumn<QString>("servo");
        QTest::addColumn<QByteArray>("acknowledgement");
        QTest::newRow("the old ID acknowledges") << QStringLiteral("sts3215@1") << fine;
        QTest::newRow("the new ID acknowledges")
            << QStringLiteral("sts3215@1+new-id-reply=1") << bytes("FFFF050200F8");
    }
    void anIdChangeTakesEffectAtOnce()
    {
        QFETCH(QString, servo);
        QFETCH(QByteArray, acknowledgement);
        Simulator simulator({QStringLiteral("--servos"), servo});
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF01040337 00C0", 6), fine);
        QCOMPARE(client.ask("FFFF0104030505ED", 6), acknowledgement);
        QCOMPARE(client.ask("FFFF050201F7", 6), bytes("FFFF050200F8"));
        QCOMPARE(client.ask("FFFF05040337 01BB", 6), bytes("FFFF050200F8"));
        // The old ID is silent: the next answer heard is the new one's.
        client.send(bytes(pingOne));
        QCOMPARE(client.ask("FFFF050201F7", 6), bytes("FFFF050200F8"));
        // Broadcast write of the ID, unanswered.
        client.send(bytes("FFFFFE04030501F4"));
        QCOMPARE(client.requestUntilReply(pingOne, 6), fine);
    }

    void aRebootIsNotAnswered()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF01040328 01CE", 6), fine);
        client.send(bytes("FFFF010208F4"));
        QCOMPARE(client.ask("FFFF020201FA", 6), bytes("FFFF020200FB"));
        QCOMPARE(client.requestUntilReply(pingOne, 6), fine);
        QCOMPARE(client.ask("FFFF0104022801CF", 7), bytes("FFFF01030000FB"));
    }

    void theStateFileHoldsTheEpromOverAPowerCycle()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("bench.json"));
        {
            Simulator simulator(stsWithState(file));
            Client client(simulator.port());
            // P := 40 unlocked, D := 50 locked again.
            QCOMPARE(client.ask("FFFF01040337 00C0", 6), fine);
            QCOMPARE(client.ask("FFFF0104031528BA", 6), fine);
            QCOMPARE(client.requestUntilReply(pingOne, 6), fine);
            QCOMPARE(client.ask("FFFF01040337 01BF", 6), fine);
            QCOMPARE(client.ask("FFFF0104031632AF", 6), fine);
            QCOMPARE(client.requestUntilReply("FFFF0104021502E1", 8), bytes("FFFF0104002832A0"));
            QCOMPARE(simulator.end(), 0);
        }
        Simulator simulator(stsWithState(file));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF0104021502E1", 8), bytes("FFFF0104002820B2"));
        // The lock is closed again, torque is off.
        QCOMPARE(client.ask("FFFF0104023701C0", 7), bytes("FFFF01030001FA"));
        QCOMPARE(client.ask("FFFF0104022801CF", 7), bytes("FFFF01030000FB"));
    }

    // ID 254 must never be stored; a rate or mode that is in no list is not taken either. The write
    // is acknowledged, since no bit says "rejected", and reading tells.
    void invalidServosAreRefused()
    {
        Simulator simulator(list("--servos sts3215@1"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF01040305FEF4", 6), fine);
        QCOMPARE(client.ask("FFFF0104030608E9", 6), fine);
        QCOMPARE(client.ask("FFFF010403214D89", 6), fine);
        QCOMPARE(client.ask("FFFF0104020502F1", 8), bytes("FFFF0104000100F9"));
        QCOMPARE(client.ask("FFFF0104022101D6", 7), bytes("FFFF01030000FB"));
    }

    // As lerobot's broadcast_ping counts on it: every servo in a time of its own.
    void aBroadcastPingMayBeAnsweredInTurn()
    {
        Simulator simulator(list("--servos sts3215@1+staggered-ping=1,sts3215@2+staggered-ping=1,"
                                 "sts3215@6+staggered-ping=1"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFFFE0201FE", 18), bytes("FFFF010200FC FFFF020200FB FFFF060200F7"));
    }

    void presetOptionsApplyToAllServos()
    {
        Simulator simulator(list("--preset sweep+staggered-ping=1"));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFFFE0201FE", 18), bytes("FFFF010200FC FFFF020200FB FFFF030200FA"));
    }

    // Killed without a warning, as by a power failure: what was written a moment ago is kept.
    void theStateIsOnDiskSoonAfterAChange()
    {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("bench.json"));
        {
            Simulator simulator(stsWithState(file));
            QFile state(file);
            QVERIFY(state.open(QIODevice::ReadOnly));
            const QByteArray before = state.readAll();
            Client client(simulator.port());
            QCOMPARE(client.ask("FFFF01040337 00C0", 6), fine);
            QCOMPARE(client.ask("FFFF0104031528BA", 6), fine);
            const auto changed = [&] {
                QFile now(file);
                return now.open(QIODevice::ReadOnly) && now.readAll() != before;
            };
            QTRY_VERIFY(changed());
            simulator.end(SIGKILL);
        }
        Simulator simulator(stsWithState(file));
        Client client(simulator.port());
        QCOMPARE(client.ask("FFFF0104021501E2", 7), bytes("FFFF01030028D3"));
    }

    void refusesAnUnknownStateFile_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("text") << QByteArray("shopping list");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("other JSON") << QByteArray("{\"format\":\"playlist\",\"version\":1}");
        QTest::newRow("newer") << QByteArray(
            "{\"format\":\"servodesk-sim-eprom\",\"version\":2,\"servos\":[]}");
        QTest::newRow("other number of servos")
            << QByteArray("{\"format\":\"servodesk-sim-eprom\",\"version\":1,\"servos\":[]}");
        QTest::newRow("other models")
            << QByteArray("{\"format\":\"servodesk-sim-eprom\",\"version\":1,\"servos\":["
                          "{\"model\":\"SCS15\",\"eprom\":\"00\"},"
                          "{\"model\":\"STS3215\",\"eprom\":\"00\"}]}");
        QTest::newRow("short image")
            << QByteArray("{\"format\":\"servodesk-sim-eprom\",\"version\":1,\"servos\":["
                          "{\"model\":\"STS3215\",\"eprom\":\"00\"},"
                          "{\"model\":\"SCS15\",\"eprom\":\"00\"}]}");
    }
    void refusesAnUnknownStateFile()
    {
        QFETCH(QByteArray, content);
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("bench.json"));
        QFile state(file);
        QVERIFY(state.open(QIODevice::WriteOnly));
        state.write(content);
        state.close();
        Simulator simulator(stsWithState(file));
        QCOMPARE(simulator.wait(), 5);
        QVERIFY(simulator.firstLine().isEmpty());
        QVERIFY(simulator.complaint().contains(file));
        QVERIFY(state.open(QIODevice::ReadOnly));
        QCOMPARE(state.readAll(), content);
    }

    void refusesAStateFileInAMissingFolder()
    {
        QTemporaryDir folder;
        Simulator simulator(stsWithState(folder.filePath(QStringLiteral("no/such/folder.json"))));
        QCOMPARE(simulator.wait(), 5);
        QVERIFY(!simulator.complaint().isEmpty());
    }

    void clientsComeAndGo()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2"));
        for (int round = 0; round < 20; ++round) {
            Client client(simulator.port());
            QVERIFY(client.isOpen());
            QCOMPARE(client.ask(pingOne, 6), fine);
        }
    }

    // As on a port that was closed: what the last client did not read is gone.
    void aClientGetsNoBytesOfThePreviousOne()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2"));
        {
            Client client(simulator.port());
            client.send(bytes(pingOne));
            QVERIFY(client.readable(raw::timeoutMs));
        }
        const auto clean = [&] { return !Client(simulator.port()).readable(0); };
        QTRY_VERIFY(clean());
        Client client(simulator.port());
        // The simulator may still be emptying the line after the client before; that takes what
        // comes meanwhile with it.
        QCOMPARE(client.requestUntilReply("FFFF020201FA", 6), bytes("FFFF020200FB"));
    }

    void theClientsRateCounts()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2:115200"));
        Client client(simulator.port(), B115200);
        client.send(bytes(pingOne));
        QCOMPARE(client.ask("FFFF020201FA", 6), bytes("FFFF020200FB"));
        client.setRate(B1000000);
        QCOMPARE(client.requestUntilReply(pingOne, 6), fine);
    }

    void oneRateForAllServos()
    {
        Simulator simulator(list("--preset demo --baud 57600"));
        Client client(simulator.port(), B57600);
        QCOMPARE(client.ask(pingOne, 6), fine);
    }

    void anEchoComesBackFirst()
    {
        Simulator simulator(list("--servos sts3215@1 --echo"));
        Client client(simulator.port());
        QCOMPARE(client.ask(pingOne, 12), bytes(pingOne) + fine);
    }

    void aMutedServoStaysMuted()
    {
        Simulator simulator(list("--servos sts3215@1,sts3215@2 --fault mute=1"));
        Client client(simulator.port());
        client.send(bytes(pingOne));
        QCOMPARE(client.ask("FFFF020201FA", 6), bytes("FFFF020200FB"));
    }

    void repliesTakeWireTime_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("atLeastMicroseconds");
        // 8 and 21 bytes of 10 bits at 38400 baud.
        QTest::newRow("on the wire") << list("--baud 38400 --wire-time") << 7552;
        QTest::newRow("in the adapter") << list("--baud 38400 --latency-ms 50") << 50'000 + 7552;
        QTest::newRow("when late") << list("--baud 38400 --fault late=1,late-ms=60") << 60'000;
    }
    void repliesTakeWireTime()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, atLeastMicroseconds);
        Simulator simulator(list("--servos sts3215@1") + arguments);
        Client client(simulator.port(), B38400);
        const auto start = std::chrono::steady_clock::now();
        const QByteArray reply = client.ask("FFFF010402380FB1", 21);
        const auto took = std::chrono::steady_clock::now() - start;
        QVERIFY(reply.startsWith(bytes("FFFF011100")));
        QVERIFY(hasValidChecksum(reply));
        QVERIFY(took >= std::chrono::microseconds(atLeastMicroseconds));
    }

    void theSymlinkPointsToThePortAndIsRemoved()
    {
        QTemporaryDir folder;
        const QString link = folder.filePath(QStringLiteral("servo"));
        // Left over from a run that was killed.
        QVERIFY(QFile::link(QStringLiteral("/dev/pts/none"), link));
        Simulator simulator(list("--servos sts3215@1 --link") << link);
        QCOMPARE(QFileInfo(link).symLinkTarget(), simulator.port());
        {
            Client client(link);
            QCOMPARE(client.ask(pingOne, 6), fine);
        }
        QCOMPARE(simulator.end(SIGINT), 0);
        QVERIFY(!QFileInfo(link).isSymLink());
    }

    void theSymlinkReplacesNoFile()
    {
        QTemporaryDir folder;
        const QString name = folder.filePath(QStringLiteral("precious"));
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("data");
        file.close();
        Simulator simulator(list("--link") << name);
        QCOMPARE(simulator.wait(), 3);
        QVERIFY(simulator.complaint().contains(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("data"));
    }

    void endsByItself()
    {
        QTemporaryDir folder;
        const QString link = folder.filePath(QStringLiteral("servo"));
        Simulator simulator(list("--seconds 0.3 --link") << link);
        QVERIFY(simulator.firstLine().startsWith(QStringLiteral("port: ")));
        QCOMPARE(simulator.wait(), 0);
        QVERIFY(!QFileInfo(link).isSymLink());
    }

    void refusesBadArguments_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("culprit");
        const auto row = [](const char* name, const char* arguments, const char* culprit) {
            QTest::newRow(name) << list(arguments) << QString::fromLatin1(culprit);
        };
        row("unknown option", "--colour red", "--colour");
        row("stray word", "demo", "demo");
        row("unknown preset", "--preset party", "party");
        row("unknown model", "--servos sts9999@1", "sts9999");
        row("bad ID", "--servos sts3215@254", "254");
        row("preset and servos", "--preset demo --servos sts3215@1", "--servos");
        row("unknown fault", "--fault melt=1", "melt");
        row("bad probability", "--fault drop=2", "drop=2");
        row("bad rate", "--baud fast", "fast");
        row("rate no servo has", "--servos sts3215@1 --baud 9601", "9601");
        row("negative time", "--seconds -1", "--seconds");
        row("negative latency", "--latency-ms -1", "--latency-ms");
        row("no value", "--state", "--state");
    }
    void refusesBadArguments()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, culprit);
        Simulator simulator(arguments);
        QCOMPARE(simulator.wait(), 2);
        QVERIFY(simulator.firstLine().isEmpty());
        const QString complaint = simulator.complaint();
        QVERIFY2(complaint.contains(culprit), qPrintable(complaint));
    }

    void printsHelp()
    {
        Simulator simulator({QStringLiteral("--help")});
        QCOMPARE(simulator.wait(), 0);
        QVERIFY(!simulator.firstLine().isEmpty());
        QVERIFY(!simulator.firstLine().startsWith(QStringLiteral("port:")));
    }
};

SERVODESK_GUILESS_TEST(TestServodeskSim)
#include "tst_servodesk_sim.moc"

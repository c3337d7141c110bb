// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli firmware: versions and the servos that differ from the others of their model; the
// update with its checks, and the rescue.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::words;

namespace {
constexpr int imageSize = 1500;

QString makeImage(const CliProgram& cli, const QString& name = {})
{
    QFile file(cli.dataFolder() + u'/' +
               (name.isEmpty() ? QStringLiteral("SCServo21-GD32-TTL-250306.bin") : name));
    if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray(imageSize, 'x')) != imageSize)
        qFatal("no image");
    return file.fileName();
}
} // namespace

class TestCliFirmware : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void theOddOneIsNamed()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@2+firmware-minor=9,sts3215@3,scs15@4"));
        const auto result = cli.run(words("firmware list --json"));
        QCOMPARE(result.exit, 0);
        QCOMPARE(result.json()[QLatin1String("same_firmware")].toBool(true), false);
        const QJsonArray servos = result.json()[QLatin1String("servos")].toArray();
        QCOMPARE(servos.size(), 4);
        const QStringList versions{QStringLiteral("3.10"), QStringLiteral("3.9"),
                                   QStringLiteral("3.10"), QStringLiteral("0.4")};
        for (int i = 0; i < 4; ++i) {
            const QJsonObject servo = servos[i].toObject();
            QCOMPARE(servo[QLatin1String("id")].toInt(), i + 1);
            QCOMPARE(servo[QLatin1String("firmware")].toString(), versions[i]);
            QCOMPARE(servo[QLatin1String("differs")].toBool(), i == 1);
        }
        const QJsonValue newer = servos[1].toObject()[QLatin1String("newer")];
        QCOMPARE(newer[QLatin1String("version")].toString(), QStringLiteral("3.10"));
        QCOMPARE(newer[QLatin1String("date")].toString(), QStringLiteral("2025-03-06"));
        QVERIFY(servos[0].toObject()[QLatin1String("newer")].isNull());
        const QString text = cli.run(words("firmware list")).out;
        QVERIFY2(text.contains(QStringLiteral("differs from the others")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("3.10 (2025-03)")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("LeRobot refuses")), qPrintable(text));
    }

    void equalVersionsNeedNoWord()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@2"));
        const QString text = cli.run(words("firmware list")).out;
        QVERIFY2(text.contains(QStringLiteral("3.10")), qPrintable(text));
        QVERIFY2(!text.contains(QStringLiteral("LeRobot")), qPrintable(text));
        QVERIFY(
            cli.run(words("firmware list --json")).json()[QLatin1String("same_firmware")].toBool());
    }

    void anUpdateEndsWithTheNewVersion()
    {
        CliProgram cli;
        const QString image = makeImage(cli);
        cli.setServos(QStringLiteral("sts3215@1"));
        const auto result = cli.run({QStringLiteral("firmware"), QStringLiteral("update"), image,
                                     QStringLiteral("1"), QStringLiteral("--json")});
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        const QJsonObject servo = result.json()[QLatin1String("servos")][0].toObject();
        QCOMPARE(servo[QLatin1String("firmware_before")].toString(), QStringLiteral("3.10"));
        QCOMPARE(servo[QLatin1String("outcome")].toString(), QStringLiteral("updated"));
        QCOMPARE(servo[QLatin1String("update")][QLatin1String("firmware")].toString(),
                 QStringLiteral("3.11"));
        QCOMPARE(servo[QLatin1String("checks")].toArray().size(), 6);
        QCOMPARE(servo[QLatin1String("changed")][0][QLatin1String("key")].toString(),
                 QStringLiteral("protection_time"));
        QVERIFY(QFile::exists(servo[QLatin1String("snapshot")].toString()));
        QCOMPARE(cli.run(words("info 1")).exit, 0); // the port is as it was

        // The old values, with the command that was named.
        const QString text = cli.run({QStringLiteral("firmware"), QStringLiteral("update"), image,
                                      QStringLiteral("1")})
                                 .out;
        QVERIFY2(text.contains(QStringLiteral("2 settings changed with the firmware")),
                 qPrintable(text));
        static const QRegularExpression command(
            QStringLiteral("servodesk-cli (snapshot restore 1 .*)\n"));
        const QString restore = command.match(text).captured(1);
        QCOMPARE(cli.run(QProcess::splitCommand(restore)).exit, 0);
    }

    void aFailedCheckIsAcceptedOneByOne()
    {
        CliProgram cli;
        const QString image = makeImage(cli, QStringLiteral("new.bin"));
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@2"));
        const QStringList update{QStringLiteral("firmware"), QStringLiteral("update"), image,
                                 QStringLiteral("1")};
        const auto refused = cli.run(update);
        QCOMPARE(refused.exit, 1);
        QVERIFY2(refused.out.contains(QStringLiteral("Not started")), qPrintable(refused.out));
        QVERIFY2(refused.out.contains(QStringLiteral("ID 2")), qPrintable(refused.out));
        QCOMPARE(cli.run(update + words("--accept other-servos")).exit, 1);
        QCOMPARE(cli.run(update + words("--accept supplies")).exit, 2);
        const auto done = cli.run(update + words("--accept other-servos,file-name --json"));
        QVERIFY2(done.exit == 0, qPrintable(done.out + done.err));
        const auto both = cli.run(update + words("2 --accept all --json"));
        QVERIFY2(both.exit == 0, qPrintable(both.out + both.err));
        QCOMPARE(both.json()[QLatin1String("servos")].toArray().size(), 2);
    }

    /// The first failure ends a list of servos.
    void aListEndsWithTheFirstFailure()
    {
        CliProgram cli;
        const QString image = makeImage(cli);
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@3"));
        const auto result = cli.run({QStringLiteral("firmware"), QStringLiteral("update"), image,
                                     QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3"),
                                     QStringLiteral("--accept"), QStringLiteral("other-servos"),
                                     QStringLiteral("--json")});
        QCOMPARE(result.exit, 4);
        const QJsonArray servos = result.json()[QLatin1String("servos")].toArray();
        QCOMPARE(servos.size(), 3);
        QCOMPARE(servos[0][QLatin1String("outcome")].toString(), QStringLiteral("updated"));
        QCOMPARE(servos[1][QLatin1String("error")][QLatin1String("code")].toString(),
                 QStringLiteral("no-answer"));
        for (const int later : {1, 2})
            QCOMPARE(servos[later][QLatin1String("outcome")].toString(),
                     QStringLiteral("not-started"));
    }

    void otherFilesAreRefused()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:sts3215@1"));
        const QString modbus = makeImage(cli, QStringLiteral("SMServo3.40-485-MODBUS.mbin"));
        const auto result = cli.run(
            {QStringLiteral("firmware"), QStringLiteral("update"), modbus, QStringLiteral("1")});
        QVERIFY(result.exit != 0);
        QVERIFY2(result.err.contains(QStringLiteral("bin")), qPrintable(result.err));
        QCOMPARE(cli.run(words("firmware update missing.bin 1")).exit, 5);
        QCOMPARE(cli.run(words("firmware rescue missing.bin")).exit, 5);
    }

    void aServoWithoutFirmwareIsRescued()
    {
        CliProgram cli;
        const QString image = makeImage(cli);
        support::SimProgram sim(words("--servos sts3215@4+firmware-lost=1 --baud 500000"));
        cli.setPort(sim.port());
        QVERIFY(cli.run(words("info 4 --baud 500000")).exit != 0);
        const auto result = cli.run({QStringLiteral("firmware"), QStringLiteral("rescue"), image,
                                     QStringLiteral("--json")});
        QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
        QVERIFY2(result.err.contains(QStringLiteral("supply")), qPrintable(result.err));
        QCOMPARE(result.json()[QLatin1String("outcome")].toString(), QStringLiteral("updated"));
        QCOMPARE(result.json()[QLatin1String("id")].toInt(), 4);
        QCOMPARE(result.json()[QLatin1String("baud")].toInt(), 500'000);
        QCOMPARE(cli.run(words("info 4 --baud 500000")).exit, 0);
    }

    void anEmptyBusIsNoReply()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:sts3215@1,sts3215@2:500000"));
        QCOMPARE(cli.run(words("firmware list --bauds 250000")).exit, 4);
        const auto all = cli.run(words("firmware list --bauds 500000,1000000 --json"));
        QCOMPARE(all.json()[QLatin1String("servos")].toArray().size(), 2);
        const auto none = cli.run(words("firmware list --bauds 250000 --json"));
        QCOMPARE(none.json()[QLatin1String("same_firmware")].toBool(true), false);
        QVERIFY(
            cli.run(words("firmware list --bauds 250000")).out.contains(QStringLiteral("power")));
        QCOMPARE(cli.run(words("firmware list --bauds 7")).exit, 2);
    }
};

SERVODESK_GUILESS_TEST(TestCliFirmware)
#include "tst_cli_firmware.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli firmware list: versions, the servos that differ from the others of their model, and
// the newer version of the vendor's catalog.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::words;

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

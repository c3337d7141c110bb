// SPDX-License-Identifier: GPL-3.0-or-later
// The command that sets servos up one after the other, as a user runs it: with simulated servos, as
// JSON lines, stopped with Ctrl-C and resumed, and what it refuses.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;

class TestCliCommission : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void aBatchIsCommissioned()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:line"));
        const QString csv = cli.dataFolder() + QStringLiteral("/batch.csv");
        const auto result =
            cli.run(support::words("commission --auto --first-id 5 --count 2 --json "
                                   "--to-baud 500000 --batch")
                    << csv);
        QCOMPARE(result.exit, 0);
        const QStringList lines = result.out.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        for (int i = 0; i < 2; ++i) {
            const QJsonObject row = QJsonDocument::fromJson(lines[i].toUtf8()).object();
            QCOMPARE(row.value(QStringLiteral("verdict")).toString(), QStringLiteral("good"));
            QCOMPARE(row.value(QStringLiteral("id")).toInt(), 5 + i);
            QCOMPARE(row.value(QStringLiteral("baud")).toInt(), 500'000);
            QCOMPARE(row.value(QStringLiteral("was_id")).toInt(), 1);
            QVERIFY(QFile::exists(row.value(QStringLiteral("snapshot")).toString()));
            QVERIFY(row.value(QStringLiteral("simulated")).toBool());
        }
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().count('\n'), 3);
    }

    void ctrlCEndsItAndItResumes()
    {
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:line"));
        const QStringList line = support::words("commission --auto --first-id 5 --batch")
                                 << cli.dataFolder() + QStringLiteral("/batch.csv");
        cli.start(line);
        QVERIFY(cli.waitForOutput("ID 5"));
        cli.signal(SIGINT);
        const auto stopped = cli.finish();
        QVERIFY2(stopped.exit == 0 || stopped.exit == 1, qPrintable(stopped.err));
        // The next start knows the assigned IDs.
        cli.start(line);
        QVERIFY(cli.waitForOutput("ID 6") || cli.waitForOutput("ID 7"));
        cli.signal(SIGINT);
        const auto again = cli.finish();
        QVERIFY(!again.out.contains(QStringLiteral("ID 5 ")));
    }

    void refusedArguments_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("exit");
        QTest::newRow("no batch") << QStringLiteral("commission --auto") << 2;
        QTest::newRow("two ways of IDs")
            << QStringLiteral("commission --auto --batch b.csv --first-id 1 --id-list 1-3") << 2;
        QTest::newRow("no such ID")
            << QStringLiteral("commission --auto --batch b.csv --first-id 254") << 2;
        QTest::newRow("no template")
            << QStringLiteral("commission --auto --batch b.csv --template /nowhere.json") << 5;
        QTest::newRow("nowhere to keep it")
            << QStringLiteral("commission --auto --count 1 --batch /nowhere/b.csv") << 5;
    }
    void refusedArguments()
    {
        QFETCH(QString, line);
        QFETCH(int, exit);
        CliProgram cli;
        cli.setPort(QStringLiteral("sim:line"));
        const auto result = cli.run(support::words(line.toLatin1().constData()));
        QCOMPARE(result.exit, exit);
        QVERIFY(!result.err.isEmpty());
        QVERIFY(result.out.isEmpty());
    }
};

SERVODESK_GUILESS_TEST(TestCliCommission)
#include "tst_cli_commission.moc"

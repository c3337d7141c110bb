// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli against servodesk-sim, two programs joined by a pseudo-terminal: power cycles, slow
// adapters, disturbed wires, rates, and ports that others use.
#include "support/cli_program.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::Ran;
using support::SimProgram;
using support::words;

namespace {
qint64 raw(CliProgram& cli, int id, const char* key)
{
    const Ran ran =
        cli.json(qPrintable(QStringLiteral("read %1 %2").arg(id).arg(QLatin1String(key))));
    return ran.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInteger(-999);
}

QString errorCode(const Ran& ran)
{
    return ran.json()[QLatin1String("error")][QLatin1String("code")].toString();
}
} // namespace

class TestCliWire : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void keptSurvivesAPowerCycleAndTemporaryDoesNot();
    void newIdSurvivesAPowerCycle();
    void limitsForTheWayBackSurviveARestart();
    void slowAdapterLosesNobody();
    void disturbedWireReadsRightOrNotAtAll();
    void wrongRateIsNoAnswerAndAutoFindsIt();
    void newRateIsFollowed();
    void echoingAdapterIsUnderstood();
    void busyPortNamesWhoHasIt();
    void unpluggedPortEndsTheWatch();
    void silentServoTriesAsOftenAsAsked();
};

void TestCliWire::keptSurvivesAPowerCycleAndTemporaryDoesNot()
{
    CliProgram cli;
    const QStringList arguments = words("--servos sts3215@1,scs15@2 --state")
                                  << cli.dataFolder() + QStringLiteral("/eproms");
    {
        SimProgram sim(arguments);
        cli.setPort(sim.port());
        QCOMPARE(cli.run("write 1 max_temperature=61").exit, 0);
        QCOMPARE(cli.run("write 1 position_p=20 --temporary").exit, 0);
        QCOMPARE(cli.run("write 2 max_temperature=62").exit, 0);
        QCOMPARE(raw(cli, 1, "position_p"), 20);
    }
    SimProgram sim(arguments);
    cli.setPort(sim.port());
    QCOMPARE(raw(cli, 1, "max_temperature"), 61);
    QCOMPARE(raw(cli, 1, "position_p"), 32);
    QCOMPARE(raw(cli, 2, "max_temperature"), 62);
    QCOMPARE(raw(cli, 1, "lock"), 1);
    QCOMPARE(raw(cli, 2, "lock"), 1);
}

void TestCliWire::newIdSurvivesAPowerCycle()
{
    CliProgram cli;
    const QStringList arguments = words("--servos sts3215@1 --state")
                                  << cli.dataFolder() + QStringLiteral("/eproms");
    {
        SimProgram sim(arguments);
        cli.setPort(sim.port());
        QCOMPARE(cli.run("set-id 1 12").exit, 0);
    }
    SimProgram sim(arguments);
    cli.setPort(sim.port());
    QCOMPARE(raw(cli, 12, "id"), 12);
    QCOMPARE(cli.run("info 1").exit, 4);
}

void TestCliWire::limitsForTheWayBackSurviveARestart()
{
    CliProgram cli;
    SimProgram sim(words("--servos scs15@1"));
    cli.setPort(sim.port());
    QCOMPARE(cli.run("write 1 min_angle_limit=100 max_angle_limit=900").exit, 0);
    QCOMPARE(cli.run("mode 1 motor").exit, 0);
    QCOMPARE(raw(cli, 1, "max_angle_limit"), 0);
    QCOMPARE(cli.run("mode 1 position").exit, 0);
    QCOMPARE(raw(cli, 1, "min_angle_limit"), 100);
    QCOMPARE(raw(cli, 1, "max_angle_limit"), 900);
}

void TestCliWire::slowAdapterLosesNobody()
{
    CliProgram cli;
    SimProgram sim(words("--preset demo --latency-ms 16"));
    cli.setPort(sim.port());
    const Ran scan = cli.json("scan");
    QCOMPARE(scan.exit, 0);
    QCOMPARE(scan.json()[QLatin1String("found")].toArray().size(), 6);
    // Equal lengths, alternating: a late answer would show as the other register's value.
    for (int i = 0; i < 3; ++i) {
        const Ran ran = cli.json("read 1 min_angle_limit max_torque position_p position_d");
        const QJsonArray rows = ran.json()[QLatin1String("registers")].toArray();
        QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 0);
        QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1000);
    }
}

void TestCliWire::disturbedWireReadsRightOrNotAtAll()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --fault drop=0.05,corrupt=0.02,garbage=0.1 --seed 7"));
    cli.setPort(sim.port());
    int good = 0;
    for (int i = 0; i < 15; ++i) {
        const Ran ran = cli.json("read 1 max_angle_limit max_torque");
        if (ran.exit == 0) {
            const QJsonArray rows = ran.json()[QLatin1String("registers")].toArray();
            QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 4095);
            QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1000);
            ++good;
        } else {
            QCOMPARE(ran.exit, 4);
        }
    }
    QVERIFY(good > 10);
}

void TestCliWire::wrongRateIsNoAnswerAndAutoFindsIt()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --baud 115200"));
    cli.setPort(sim.port());
    const Ran wrong = cli.json("info 1");
    QCOMPARE(wrong.exit, 4);
    const Ran right = cli.json("info 1 --baud auto");
    QCOMPARE(right.exit, 0);
    QCOMPARE(right.json()[QLatin1String("baud")].toInt(), 115200);
    const Ran scan = cli.json("scan --ids 1-3 --bauds 1000000,115200");
    QCOMPARE(scan.json()[QLatin1String("found")][0][QLatin1String("baud")].toInt(), 115200);
}

void TestCliWire::newRateIsFollowed()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1"));
    cli.setPort(sim.port());
    const Ran ran = cli.json("set-baud 1 250000");
    QCOMPARE(ran.exit, 0);
    QCOMPARE(ran.json()[QLatin1String("lock")].toString(), QStringLiteral("closed"));
    QCOMPARE(ran.json()[QLatin1String("baud")].toInt(), 250000);
    QCOMPARE(cli.run("info 1").exit, 4);
    QCOMPARE(cli.run("info 1 --baud 250000").exit, 0);
}

void TestCliWire::echoingAdapterIsUnderstood()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --echo"));
    cli.setPort(sim.port());
    const Ran scan = cli.json("scan --ids 0-5");
    QCOMPARE(scan.json()[QLatin1String("found")].toArray().size(), 1);
    QCOMPARE(cli.run("write 1 max_temperature=60").exit, 0);
}

void TestCliWire::busyPortNamesWhoHasIt()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram first;
    first.setPort(sim.port());
    first.start(words("watch 1"));
    QVERIFY(first.waitForOutput("time[s]"));
    CliProgram second;
    second.setPort(sim.port());
    const Ran ran = second.json("info 1");
    QCOMPARE(ran.exit, 3);
    QCOMPARE(errorCode(ran), QStringLiteral("port-busy"));
    const QString message = ran.json()[QLatin1String("error")][QLatin1String("message")].toString();
    QVERIFY2(message.contains(QStringLiteral("servodesk-cli")), qPrintable(message));
    first.signal(SIGINT);
    QCOMPARE(first.finish().exit, 0);
}

void TestCliWire::unpluggedPortEndsTheWatch()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram cli;
    cli.setPort(sim.port());
    cli.start(words("watch 1 --json"));
    QVERIFY(cli.waitForOutput("time_us"));
    sim.end();
    const Ran ran = cli.finish();
    QCOMPARE(ran.exit, 3);
    QCOMPARE(errorCode(ran), QStringLiteral("link-lost"));
}

void TestCliWire::silentServoTriesAsOftenAsAsked()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram cli;
    cli.setPort(sim.port());
    const Ran ran = cli.run("info 9 --retries 4 --timeout 5");
    QCOMPARE(ran.exit, 4);
    QVERIFY2(ran.err.contains(QStringLiteral("5")), qPrintable(ran.err));
}

QTEST_GUILESS_MAIN(TestCliWire)
#include "tst_cli_wire.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli with servodesk-sim, connected by a pseudo-terminal: power cycles, slow adapters,
// disturbed wires, baud rates, and ports in use by other programs.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
qint64 raw(CliProgram& cli, int id, const char* key)
{
    const ProgramResult result =
        cli.json(qPrintable(QStringLiteral("read %1 %2").arg(id).arg(QLatin1String(key))));
    return result.json()[QLatin1String("registers")][0][QLatin1String("raw")].toInteger(-999);
}
} // namespace

class TestCliBus : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void savedSurvivesAPowerCycleAndTemporaryDoesNot();
    void newIdSurvivesAPowerCycle();
    void rememberedLimitsSurviveARestart();
    void slowAdapterMissesNoServo();
    void noisyWireReadsRightOrFails();
    void wrongRateIsNoAnswerAndAutoFindsIt();
    void newRateIsUsed();
    void findNamesThePortOfTheServos();
    void echoingAdapterIsSupported();
    void busyPortNamesItsOwner();
    void unpluggedPortEndsTheWatch();
    void silentServoIsRetriedAsRequested();
};

void TestCliBus::savedSurvivesAPowerCycleAndTemporaryDoesNot()
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

void TestCliBus::newIdSurvivesAPowerCycle()
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

void TestCliBus::rememberedLimitsSurviveARestart()
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

void TestCliBus::slowAdapterMissesNoServo()
{
    CliProgram cli;
    SimProgram sim(words("--preset demo --latency-ms 16"));
    cli.setPort(sim.port());
    const ProgramResult scan = cli.json("scan");
    QCOMPARE(scan.exit, 0);
    QCOMPARE(scan.json()[QLatin1String("found")].toArray().size(), 6);
    // Alternating registers of equal length: a late reply would give the value of the other one.
    for (int i = 0; i < 3; ++i) {
        const ProgramResult result =
            cli.json("read 1 min_angle_limit max_torque position_p position_d");
        const QJsonArray rows = result.json()[QLatin1String("registers")].toArray();
        QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 0);
        QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1000);
    }
}

void TestCliBus::noisyWireReadsRightOrFails()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --fault drop=0.05,corrupt=0.02,garbage=0.1 --seed 7"));
    cli.setPort(sim.port());
    int good = 0;
    for (int i = 0; i < 15; ++i) {
        const ProgramResult result = cli.json("read 1 max_angle_limit max_torque");
        if (result.exit == 0) {
            const QJsonArray rows = result.json()[QLatin1String("registers")].toArray();
            QCOMPARE(rows[0][QLatin1String("raw")].toInt(), 4095);
            QCOMPARE(rows[1][QLatin1String("raw")].toInt(), 1000);
            ++good;
        } else {
            QCOMPARE(result.exit, 4);
        }
    }
    QVERIFY(good > 10);
}

void TestCliBus::wrongRateIsNoAnswerAndAutoFindsIt()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --baud 115200"));
    cli.setPort(sim.port());
    const ProgramResult wrong = cli.json("info 1");
    QCOMPARE(wrong.exit, 4);
    const ProgramResult right = cli.json("info 1 --baud auto");
    QCOMPARE(right.exit, 0);
    QCOMPARE(right.json()[QLatin1String("baud")].toInt(), 115200);
    const ProgramResult scan = cli.json("scan --ids 1-3 --bauds 1000000,115200");
    QCOMPARE(scan.json()[QLatin1String("found")][0][QLatin1String("baud")].toInt(), 115200);
}

void TestCliBus::newRateIsUsed()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1"));
    cli.setPort(sim.port());
    const ProgramResult result = cli.json("set-baud 1 250000");
    QCOMPARE(result.exit, 0);
    QCOMPARE(result.json()[QLatin1String("lock")].toString(), QStringLiteral("closed"));
    QCOMPARE(result.json()[QLatin1String("baud")].toInt(), 250000);
    QCOMPARE(cli.run("info 1").exit, 4);
    QCOMPARE(cli.run("info 1 --baud 250000").exit, 0);
}

/// At any rate, unless --baud names one; each port is closed again.
void TestCliBus::findNamesThePortOfTheServos()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1:500000,sts3215@2:500000,scs15@5:500000"));
    cli.setPort(sim.port());
    const QString missing = QStringLiteral("/dev/no-such-port");
    const ProgramResult result =
        cli.json(qPrintable(QStringLiteral("find %1 %2").arg(missing, sim.port())));
    QCOMPARE(result.exit, 0);
    const QJsonArray ports = result.json()[QLatin1String("ports")].toArray();
    QCOMPARE(ports.size(), 2);
    QCOMPARE(ports[0][QLatin1String("port")].toString(), missing);
    QCOMPARE(ports[0][QLatin1String("error")][QLatin1String("code")].toString(),
             QStringLiteral("port-missing"));
    QCOMPARE(ports[1][QLatin1String("port")].toString(), sim.port());
    const QJsonArray found = ports[1][QLatin1String("found")].toArray();
    QCOMPARE(found.size(), 3);
    QCOMPARE(found[2][QLatin1String("id")].toInt(), 5);
    QCOMPARE(found[2][QLatin1String("baud")].toInt(), 500'000);
    const ProgramResult text =
        cli.run(qPrintable(QStringLiteral("find %1 --protocol feetech").arg(sim.port())));
    QVERIFY2(text.out.contains(QStringLiteral("1–2, 5")), qPrintable(text.out));
    QCOMPARE(cli.run(qPrintable(QStringLiteral("find %1").arg(missing))).exit, 3);
    const QString atOneRate = QStringLiteral("find %1 --protocol feetech --baud ").arg(sim.port());
    QCOMPARE(cli.run(qPrintable(atOneRate + QStringLiteral("1000000"))).exit, 4);
    QCOMPARE(cli.run(qPrintable(atOneRate + QStringLiteral("500000"))).exit, 0);
}

void TestCliBus::echoingAdapterIsSupported()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --echo"));
    cli.setPort(sim.port());
    const ProgramResult scan = cli.json("scan --ids 0-5");
    QCOMPARE(scan.json()[QLatin1String("found")].toArray().size(), 1);
    QCOMPARE(cli.run("write 1 max_temperature=60").exit, 0);
}

void TestCliBus::busyPortNamesItsOwner()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram first;
    first.setPort(sim.port());
    first.start(words("watch 1"));
    QVERIFY(first.waitForOutput("time[s]"));
    CliProgram second;
    second.setPort(sim.port());
    const ProgramResult result = second.json("info 1");
    QCOMPARE(result.exit, 3);
    QCOMPARE(result.errorCode(), QStringLiteral("port-busy"));
    const QString message =
        result.json()[QLatin1String("error")][QLatin1String("message")].toString();
    QVERIFY2(message.contains(QStringLiteral("servodesk-cli")), qPrintable(message));
    first.signal(SIGINT);
    QCOMPARE(first.finish().exit, 0);
}

void TestCliBus::unpluggedPortEndsTheWatch()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram cli;
    cli.setPort(sim.port());
    cli.start(words("watch 1 --json"));
    QVERIFY(cli.waitForOutput("time_us"));
    sim.end();
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 3);
    QCOMPARE(result.errorCode(), QStringLiteral("link-lost"));
}

void TestCliBus::silentServoIsRetriedAsRequested()
{
    SimProgram sim(words("--servos sts3215@1"));
    CliProgram cli;
    cli.setPort(sim.port());
    const ProgramResult result = cli.run("info 9 --retries 4 --timeout 5");
    QCOMPARE(result.exit, 4);
    QVERIFY2(result.err.contains(QStringLiteral("5")), qPrintable(result.err));
}

SERVODESK_GUILESS_TEST(TestCliBus)
#include "tst_cli_bus.moc"

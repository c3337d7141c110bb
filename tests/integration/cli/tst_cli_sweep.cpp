// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli sweep as a user runs it: exit codes and its files. tst_sweep_metrics works the
// figures out again from the readings.
#include "results/sweep_json.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;

namespace {
QJsonObject loaded(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}
} // namespace

class TestCliSweep : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void goodAndBadServos();
    void reportsOfEveryKind_data();
    void reportsOfEveryKind();
    void usageErrorsAreReported_data();
    void usageErrorsAreReported();
    void tooShortADelayIsReported();
    void ctrlCEndsItSafely();
    void silenceInTheLastLegIsALostLink();
    void aSuspendedRunIsReported();
};

void TestCliSweep::tooShortADelayIsReported()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult coarseUpdates =
        cli.run("sweep 1 --from 1000 --to 3000 --delay 150 --cycles 1 --speed 3000");
    QVERIFY2(coarseUpdates.err.contains(utf8("reverses before it arrives")),
             qPrintable(coarseUpdates.err));
    const ProgramResult calm =
        cli.run("sweep 1 --from 2000 --to 2200 --delay 700 --cycles 1 --speed 3000");
    QVERIFY2(!calm.err.contains(utf8("reverses")), qPrintable(calm.err));
}

void TestCliSweep::goodAndBadServos()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1,sts3215@2+overshoot=10"));
    const char* good = "sweep 1 --from 1500 --to 2500 --dwell 200 --cycles 4 --speed 3000";
    const ProgramResult passed = cli.run(good);
    QVERIFY2(passed.exit == 0, qPrintable(passed.out + passed.err));
    QVERIFY(passed.out.contains(utf8("Verdict: Pass")));
    const ProgramResult failed =
        cli.json("sweep 2 --from 1500 --to 2500 --dwell 200 --cycles 4 --speed 3000");
    QCOMPARE(failed.exit, 1);
    QCOMPARE(failed.json()[utf8("verdict")].toString(), utf8("fail"));
    QCOMPARE(failed.json()[utf8("legs")].toArray().size(), 8);
    const auto decoded = results::decodeSweepRun(failed.out.toUtf8());
    QVERIFY2(decoded, decoded ? "" : qPrintable(decoded.error().detail));
    QVERIFY(decoded->simulated);
}

void TestCliSweep::reportsOfEveryKind_data()
{
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("html") << QByteArray("<!DOCTYPE html>");
    QTest::newRow("pdf") << QByteArray("%PDF-");
    QTest::newRow("json") << QByteArray("{");
    QTest::newRow("csv") << QByteArray("servo,leg,");
}

void TestCliSweep::reportsOfEveryKind()
{
    QFETCH(QByteArray, begins);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const QString path =
        cli.dataFolder() + utf8("/report.") + QLatin1String(QTest::currentDataTag());
    const ProgramResult result =
        cli.run(utf8("sweep 1 --from 1800 --to 2200 --delay 500 --cycles 3 --report ")
                    .split(QLatin1Char(' '), Qt::SkipEmptyParts)
                << path);
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith(begins));
    QVERIFY(QFile::exists(cli.dataFolder() + utf8("/report.readings.csv")));
}

void TestCliSweep::usageErrorsAreReported_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("word"); ///< a part of the message
    const auto row = [](const char* options, int exit, const char* word) {
        QTest::newRow(options) << utf8(options) << exit << utf8(word);
    };
    row("--from 1000 --to 1000 --delay 500", 2, "same position");
    row("--from 1000 --to 2000", 2, "--delay");
    row("--from 1000 --delay 500", 2, "--to");
    row("--from 1000 --to 2000 --delay 0", 2, "0");
    row("--from 1000 --to 2000 --delay 500 --dwell 5", 2, "--dwell");
    row("--from 1000 --to 2000 --delay 500 --step 5000", 2, "step");
    row("--from 1000 --to 5000 --delay 500", 2, "goal_position");
    row("--from 1000 --to 2000 --delay 500 --report /nowhere/report.html", 5, "/nowhere");
    row("--from 1000 --to 2000 --delay 500 --report report.doc", 2, ".html");
    row("--from 1000 --to 2000 --delay 500 --limits /nowhere.json", 5, "/nowhere.json");
    row("--points /nowhere.csv --delay 500", 5, "/nowhere.csv");
    row("--from 1000 --to 2000 --delay 500 --sine 2 --step 3", 2, "--sine");
    row("--from 1000 --to 2000 --delay 500 --step -5", 2,
        "--step \"-5\": specify a step greater than 0");
    row("--from 1000 --to 2000 --delay 500 --step -5deg", 2, "swap --from and --to");
    row("--from 1000 --to 2000 --sine 0", 2, "--sine \"0\": specify a number of seconds from 0.1");
    row("--from 1000 --to 2000 --sine nan", 2, "--sine \"nan\"");
    row("--from 1000 --to 2000 --sine 1e9", 2, "to 3600");
    row("--from 1000 --to 2000 --delay 500 --duration -1", 2, "--duration \"-1\"");
    row("--from 1000 --to 2000 --delay 500 --warm-up inf", 2, "--warm-up \"inf\"");
    row("--from 1000 --to 2000 --delay 500 --cycles 0", 2, "whole number from 1 to 1000000");
    row("--from 1000 --to 2000 --delay 500 --time -3", 2, "--time \"-3\"");
    row("--from 1000 --to 2000 --delay 500 --speed -100", 2,
        "--speed \"-100\": specify a value of 0 or more");
    row("--from 1000 --to 2000 --delay 500 --acceleration -1deg", 2, "--acceleration");
    row("--from 1000 --to 2000 --delay 500 --random -1", 2, "--random \"-1\"");
}

void TestCliSweep::usageErrorsAreReported()
{
    QFETCH(QString, options);
    QFETCH(int, exit);
    QFETCH(QString, word);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult result =
        cli.run(QStringList{utf8("sweep"), utf8("1")} + options.split(QLatin1Char(' ')));
    QVERIFY2(result.exit == exit, qPrintable(QString::number(result.exit) + result.err));
    QVERIFY2(result.err.contains(word), qPrintable(result.err));
}

void TestCliSweep::silenceInTheLastLegIsALostLink()
{
    support::SimProgram sim({utf8("--servos"), utf8("sts3215@1,sts3215@2")});
    support::CutCable cable(sim.port(), false);
    CliProgram cli;
    cli.setPort(cable.port());
    cli.start(utf8("sweep 1 2 --from 1500 --to 2500 --dwell 1500 --cycles 1 --json")
                  .split(QLatin1Char(' ')));
    QTRY_VERIFY(cable.writes() == 3); // to the start, there, and back
    QTest::qWait(200); // usually the goal has been read back by then; else it is lost a leg earlier
    cable.dropAll();
    const ProgramResult result = cli.finish();
    QVERIFY2(result.exit == 3, qPrintable(QString::number(result.exit) + result.out + result.err));
    QCOMPARE(result.json()[utf8("end")].toString(), utf8("link-lost"));
    QCOMPARE(result.json()[utf8("verdict")].toString(), utf8("not-measured"));
    for (const char* servo : {"After the test, [^\\n]*servo 1 ", "After the test, [^\\n]*servo 2 "})
        QVERIFY2(result.err.contains(QRegularExpression(utf8(servo))), qPrintable(result.err));
}

/// Ctrl-Z and fg: what the servo did meanwhile is unknown and must not count against it.
void TestCliSweep::aSuspendedRunIsReported()
{
    support::SimProgram sim({utf8("--servos"), utf8("sts3215@1")});
    CliProgram cli;
    cli.setPort(sim.port());
    cli.start(utf8("sweep 1 --from 1500 --to 2500 --dwell 200 --cycles 3").split(QLatin1Char(' ')));
    QVERIFY(cli.waitForError("cycle 2"));
    cli.signal(SIGSTOP);
    QTest::qWait(2000); // suspended for this time
    cli.signal(SIGCONT);
    const ProgramResult result = cli.finish();
    QVERIFY2(result.out.contains(utf8("Gaps in the readings: ")), qPrintable(result.out));
    QVERIFY2(!result.out.contains(utf8("stalled before reaching its goal")),
             qPrintable(result.out));
}

void TestCliSweep::ctrlCEndsItSafely()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const QString path = cli.dataFolder() + utf8("/report.json");
    cli.start(
        utf8("sweep 1 --from 1000 --to 3000 --delay 1500 --cycles 1000 --torque-off --report ")
            .split(QLatin1Char(' '), Qt::SkipEmptyParts)
        << path);
    QVERIFY(cli.waitForError("cycle 1"));
    cli.signal(SIGINT);
    const ProgramResult result = cli.finish();
    QCOMPARE(result.exit, 1);
    const QJsonObject report = loaded(path);
    QCOMPARE(report[utf8("end")].toString(), utf8("stopped"));
    QVERIFY(!report[utf8("legs")].toArray().isEmpty());
    QCOMPARE(report[utf8("verdict")].toString(), utf8("not-measured"));
    QCOMPARE(report[utf8("servos")][0][utf8("verdict")].toString(), utf8("not-measured"));
    QCOMPARE(report[utf8("servos")][0][utf8("no_verdict")].toString(), utf8("ended"));
    QVERIFY2(result.out.contains(utf8(" 1: No verdict")), qPrintable(result.out));
    QVERIFY2(result.out.contains(utf8("Verdict: No verdict")), qPrintable(result.out));
    const QJsonValue kept = cli.json("sweep-runs").json()[utf8("runs")][0];
    QCOMPARE(kept[utf8("servos")][0][utf8("verdict")].toString(), utf8("not-measured"));
    const ProgramResult reference = cli.run("sweep-reference 1");
    QCOMPARE(reference.exit, 1);
    QVERIFY2(reference.err.contains(utf8("did not finish")), qPrintable(reference.err));
    QFile readings(cli.dataFolder() + utf8("/report.readings.csv"));
    QVERIFY(readings.open(QIODevice::ReadOnly));
    QVERIFY(readings.readAll().count('\n') > 50);
}

SERVODESK_GUILESS_TEST(TestCliSweep)
#include "tst_cli_sweep.moc"

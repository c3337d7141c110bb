// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli step-response as a user runs it: exit codes, its files, and that recover restores
// the gains after the program was killed during a trial.
#include "results/step_json.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QJsonArray>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::contentOf;
using support::ProgramResult;
using support::SimProgram;
using support::utf8;

class TestCliStepResponse : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void oneRun();
    void beforeAndAfter();
    void reports_data();
    void reports();
    void usageErrorsAreReported_data();
    void usageErrorsAreReported();
    void modeIsSwitchedOnRequest();
    void recoverFindsAKilledTrial();
    void storedRunsAreListedReportedAndCompared();
    void unknownStoredRunsAreReported_data();
    void unknownStoredRunsAreReported();
};

void TestCliStepResponse::oneRun()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult result = cli.run("step-response 1 --size 300 --repeats 1 --hold 500");
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    QVERIFY(result.out.contains(utf8("Rise time")));
    QVERIFY(result.out.contains(utf8("position_p=32")));
}

void TestCliStepResponse::beforeAndAfter()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult result = cli.json("step-response 1 --size 300 --repeats 1 --hold 900 "
                                          "--try position_p=10,position_d=0");
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QJsonObject document = result.json();
    QCOMPARE(document[utf8("runs")].toArray().size(), 2);
    QVERIFY(!document[utf8("differences")].toArray().isEmpty());
    bool integralIncreased = false;
    for (const QJsonValue& advice : document[utf8("advice")].toArray())
        integralIncreased |= advice[utf8("key")].toString() == utf8("position_i") &&
                             advice[utf8("try")].toInt() == 1;
    QVERIFY(integralIncreased);
    const auto runs = results::decodeStepRuns(result.out.toUtf8());
    QVERIFY2(runs, runs ? "" : qPrintable(runs.error().detail));
    QVERIFY(runs->at(0).spec.trial.empty());
    QCOMPARE(runs->at(1).spec.trial.size(), std::size_t(2));
    QVERIFY(runs->at(1).isReverted);
    const ProgramResult shown = cli.run("step-response 1 --size 300 --repeats 1 --hold 900 "
                                        "--try position_p=10,position_d=0");
    QVERIFY(shown.out.contains(utf8("Before")) && shown.out.contains(utf8("Raise I")));
}

void TestCliStepResponse::reports_data()
{
    QTest::addColumn<QByteArray>("begins");
    QTest::newRow("html") << QByteArray("<!DOCTYPE html>");
    QTest::newRow("json") << QByteArray("{\n  \"format\": \"servodesk-step-response\"");
    QTest::newRow("csv") << QByteArray("run,response,t[ms]");
}

void TestCliStepResponse::reports()
{
    QFETCH(QByteArray, begins);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const QString path = cli.dataFolder() + utf8("/lab.") + utf8(QTest::currentDataTag());
    const ProgramResult result = cli.run(QStringList{
        utf8("step-response"), utf8("1"), utf8("--size"), utf8("300"), utf8("--repeats"), utf8("1"),
        utf8("--hold"), utf8("500"), utf8("--try"), utf8("position_p=40"), utf8("--report"), path});
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QByteArray file = contentOf(path);
    QVERIFY2(file.startsWith(begins), file.left(80).constData());
    if (path.endsWith(utf8("html"))) {
        QVERIFY(file.contains("<svg") && file.contains("阶跃响应"));
        QVERIFY(!file.contains("<script") && !file.contains("http://www.w3.org/1999/xlink"));
    }
}

void TestCliStepResponse::usageErrorsAreReported_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("says");
    QTest::newRow("no size") << utf8("--repeats 1") << 2 << utf8("--size");
    QTest::newRow("size 0") << utf8("--size 0") << 2 << utf8("the step is 0");
    QTest::newRow("size") << utf8("--size far") << 2 << QString();
    QTest::newRow("no room") << utf8("--size 9000") << 2 << utf8("4095");
    QTest::newRow("repeats") << utf8("--size 300 --repeats 51") << 2 << utf8("50");
    QTest::newRow("names the option")
        << utf8("--size 300 --repeats 0") << 2 << utf8("--repeats \"0\": specify a whole number");
    QTest::newRow("speed") << utf8("--size 300 --speed -5") << 2 << utf8("--speed \"-5\"");
    QTest::newRow("hold") << utf8("--size 300 --hold 10001") << 2 << utf8("10000");
    QTest::newRow("no such gain") << utf8("--size 300 --try speed=3") << 2 << QString();
    QTest::newRow("no gain") << utf8("--size 300 --try max_torque=3") << 2 << utf8("position_p");
    QTest::newRow("report") << utf8("--size 300 --report a.txt") << 2 << utf8(".html");
}

void TestCliStepResponse::usageErrorsAreReported()
{
    QFETCH(QString, options);
    QFETCH(int, exit);
    QFETCH(QString, says);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult result =
        cli.run(QStringList{utf8("step-response"), utf8("1")} + options.split(QLatin1Char(' ')));
    QVERIFY2(result.exit == exit, qPrintable(result.out + result.err));
    QVERIFY2(result.err.contains(says), qPrintable(result.err));
}

void TestCliStepResponse::modeIsSwitchedOnRequest()
{
    CliProgram cli;
    cli.setServos(utf8("sts3215@1"));
    QCOMPARE(cli.run("mode 1 speed").exit, 0);
    const ProgramResult refused = cli.run("step-response 1 --size 300 --repeats 1");
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.err.contains(utf8("--switch-mode")), qPrintable(refused.err));
    const ProgramResult done =
        cli.run("step-response 1 --size 300 --repeats 1 --hold 500 --switch-mode");
    QVERIFY2(done.exit == 0, qPrintable(done.out + done.err));
    QVERIFY(cli.run("read 1 operating_mode").out.contains(utf8("speed")));
}

void TestCliStepResponse::recoverFindsAKilledTrial()
{
    const SimProgram sim(support::words("--servos sts3215@1"));
    QVERIFY(!sim.port().isEmpty());
    CliProgram cli;
    cli.setPort(sim.port());
    cli.start(support::words("step-response 1 --size 300 --repeats 1 --hold 3000 "
                             "--try position_p=20"));
    QVERIFY(cli.waitForError("(trial): 50"));
    cli.signal(SIGKILL);
    (void)cli.finish();
    QVERIFY(cli.run("read 1 position_p").out.contains(utf8("20")));
    const ProgramResult found = cli.json("recover");
    const QJsonArray intents = found.json()[utf8("intents")].toArray();
    QCOMPARE(intents.size(), 1);
    QCOMPARE(intents[0][utf8("kind")].toString(), utf8("trial"));
    const ProgramResult undone = cli.run("recover --undo");
    QVERIFY2(undone.exit == 0, qPrintable(undone.out + undone.err));
    QVERIFY(cli.run("read 1 position_p").out.contains(utf8("32")));
    QVERIFY(cli.json("recover").json()[utf8("intents")].toArray().isEmpty());
}

void TestCliStepResponse::storedRunsAreListedReportedAndCompared()
{
    CliProgram cli;
    QVERIFY(cli.json("step-runs").json()[utf8("runs")].toArray().isEmpty());
    cli.setPort(utf8("sim:sts3215@1"));
    const QString both = cli.dataFolder() + utf8("/both.json");
    const ProgramResult measured = cli.run(
        QStringList{utf8("step-response"), utf8("1"), utf8("--size"), utf8("300"),
                    utf8("--repeats"), utf8("1"), utf8("--hold"), utf8("900"), utf8("--try"),
                    utf8("position_p=10,position_d=0"), utf8("--report"), both});
    QVERIFY2(measured.exit == 0, qPrintable(measured.out + measured.err));
    cli.setPort({}); // from here on no servo is needed

    const QJsonArray runs = cli.json("step-runs --model sts3215").json()[utf8("runs")].toArray();
    QCOMPARE(runs.size(), 2);
    QCOMPARE(runs[0][utf8("number")].toInt(), 2); // newest first
    QCOMPARE(runs[0][utf8("kind")].toString(), utf8("step"));
    QCOMPARE(runs[1][utf8("files")][0].toString(), both);
    QVERIFY(cli.run("step-runs").out.contains(utf8("Completed.")));
    QVERIFY(cli.run("step-runs --servo 7").out.contains(utf8("No matching test runs")));
    QVERIFY(cli.json("sweep-runs").json()[utf8("runs")].toArray().isEmpty());

    const QString one = cli.dataFolder() + utf8("/one.json");
    QCOMPARE(cli.run({utf8("step-report"), utf8("2"), one}).exit, 0);
    const auto stored = results::decodeStepRuns(contentOf(one));
    const auto original = results::decodeStepRuns(contentOf(both));
    QVERIFY(stored && original && stored->size() == 1);
    QVERIFY(stored->front() == original->back());
    const QString page = cli.dataFolder() + utf8("/one.html");
    QCOMPARE(cli.run({utf8("step-report"), both, page}).exit, 0);
    QVERIFY(contentOf(page).startsWith("<!DOCTYPE html>"));
    const QString paper = cli.dataFolder() + utf8("/one.pdf");
    QCOMPARE(cli.run({utf8("step-report"), both, paper}).exit, 0);
    QProcess reader;
    reader.start(utf8("pdftotext"), {utf8("-layout"), paper, utf8("-")});
    QVERIFY(reader.waitForFinished());
    const QString words = QString::fromUtf8(reader.readAllStandardOutput());
    for (const char* fact : {"Step response", "Before", "Overshoot", "STS3215"})
        QVERIFY2(words.contains(utf8(fact)), fact);

    // What the history has of both runs compares as it did when they were measured.
    const QString pair = cli.dataFolder() + utf8("/pair.csv");
    const ProgramResult compared = cli.run(
        {utf8("step-compare"), utf8("1"), utf8("2"), utf8("--report"), pair, utf8("--json")});
    QVERIFY2(compared.exit == 0, qPrintable(compared.out + compared.err));
    QCOMPARE(compared.out.toUtf8(), contentOf(both));
    QVERIFY(contentOf(pair).startsWith("run,response,t[ms]"));
    const ProgramResult shown = cli.run({utf8("step-compare"), utf8("1"), one});
    QVERIFY2(shown.out.contains(utf8("Before")) && shown.out.contains(utf8("Raise I")),
             qPrintable(shown.out + shown.err));
}

void TestCliStepResponse::unknownStoredRunsAreReported_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("says");
    QTest::newRow("report") << utf8("step-report 12 a.html") << 2
                            << utf8("\"step-runs\" lists all");
    QTest::newRow("ending") << utf8("step-report 12 a.txt") << 2 << utf8(".html");
    QTest::newRow("compare") << utf8("step-compare 12 13") << 2 << utf8("12");
    QTest::newRow("no file") << utf8("step-compare /nowhere.json 13") << 5 << utf8("/nowhere.json");
    QTest::newRow("compare ending")
        << utf8("step-compare 1 2 --report a.txt") << 2 << utf8(".html");
    QTest::newRow("servo") << utf8("step-runs --servo x") << 2 << QString();
}

void TestCliStepResponse::unknownStoredRunsAreReported()
{
    QFETCH(QString, command);
    QFETCH(int, exit);
    QFETCH(QString, says);
    CliProgram cli;
    const ProgramResult result = cli.run(command.split(QLatin1Char(' ')));
    QVERIFY2(result.exit == exit, qPrintable(result.out + result.err));
    QVERIFY2(result.err.contains(says), qPrintable(result.err));
}

SERVODESK_GUILESS_TEST(TestCliStepResponse)
#include "tst_cli_step_response.moc"

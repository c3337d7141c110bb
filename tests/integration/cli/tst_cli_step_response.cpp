// SPDX-License-Identifier: GPL-3.0-or-later
// servodesk-cli step-response as a user runs it: exit codes, its files, and that recover restores
// the gains after the program was killed during a trial.
#include "results/step_json.h"
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
} // namespace

class TestCliStepResponse : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

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
    cli.setPort(text("sim:sts3215@1"));
    const ProgramResult result = cli.run("step-response 1 --size 300 --repeats 1 --hold 500");
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    QVERIFY(result.out.contains(text("Rise time")));
    QVERIFY(result.out.contains(text("position_p=32")));
}

void TestCliStepResponse::beforeAndAfter()
{
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
    const ProgramResult result = cli.json("step-response 1 --size 300 --repeats 1 --hold 900 "
                                          "--try position_p=10,position_d=0");
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QJsonObject document = result.json();
    QCOMPARE(document[text("runs")].toArray().size(), 2);
    QVERIFY(!document[text("differences")].toArray().isEmpty());
    bool integralIncreased = false;
    for (const QJsonValue& advice : document[text("advice")].toArray())
        integralIncreased |= advice[text("key")].toString() == text("position_i") &&
                             advice[text("try")].toInt() == 1;
    QVERIFY(integralIncreased);
    const auto runs = results::decodeStepRuns(result.out.toUtf8());
    QVERIFY2(runs, runs ? "" : qPrintable(runs.error().detail));
    QVERIFY(runs->at(0).spec.trial.empty());
    QCOMPARE(runs->at(1).spec.trial.size(), std::size_t(2));
    QVERIFY(runs->at(1).isReverted);
    const ProgramResult shown = cli.run("step-response 1 --size 300 --repeats 1 --hold 900 "
                                        "--try position_p=10,position_d=0");
    QVERIFY(shown.out.contains(text("Before")) && shown.out.contains(text("Raise I")));
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
    cli.setPort(text("sim:sts3215@1"));
    const QString path = cli.dataFolder() + text("/lab.") + text(QTest::currentDataTag());
    const ProgramResult result = cli.run(QStringList{
        text("step-response"), text("1"), text("--size"), text("300"), text("--repeats"), text("1"),
        text("--hold"), text("500"), text("--try"), text("position_p=40"), text("--report"), path});
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QByteArray file = contents(path);
    QVERIFY2(file.startsWith(begins), file.left(80).constData());
    if (path.endsWith(text("html"))) {
        QVERIFY(file.contains("<svg") && file.contains("阶跃响应"));
        QVERIFY(!file.contains("<script") && !file.contains("http://www.w3.org/1999/xlink"));
    }
}

void TestCliStepResponse::usageErrorsAreReported_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("says");
    QTest::newRow("no size") << text("--repeats 1") << 2 << text("--size");
    QTest::newRow("size 0") << text("--size 0") << 2 << text("the step is 0");
    QTest::newRow("size") << text("--size far") << 2 << QString();
    QTest::newRow("no room") << text("--size 9000") << 2 << text("4095");
    QTest::newRow("repeats") << text("--size 300 --repeats 51") << 2 << text("50");
    QTest::newRow("names the option")
        << text("--size 300 --repeats 0") << 2 << text("--repeats \"0\": specify a whole number");
    QTest::newRow("speed") << text("--size 300 --speed -5") << 2 << text("--speed \"-5\"");
    QTest::newRow("hold") << text("--size 300 --hold 10001") << 2 << text("10000");
    QTest::newRow("no such gain") << text("--size 300 --try speed=3") << 2 << QString();
    QTest::newRow("no gain") << text("--size 300 --try max_torque=3") << 2 << text("position_p");
    QTest::newRow("report") << text("--size 300 --report a.txt") << 2 << text(".html");
}

void TestCliStepResponse::usageErrorsAreReported()
{
    QFETCH(QString, options);
    QFETCH(int, exit);
    QFETCH(QString, says);
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
    const ProgramResult result =
        cli.run(QStringList{text("step-response"), text("1")} + options.split(QLatin1Char(' ')));
    QVERIFY2(result.exit == exit, qPrintable(result.out + result.err));
    QVERIFY2(result.err.contains(says), qPrintable(result.err));
}

void TestCliStepResponse::modeIsSwitchedOnRequest()
{
    const SimProgram sim(support::words("--servos sts3215@1"));
    QVERIFY(!sim.port().isEmpty());
    CliProgram cli;
    cli.setPort(sim.port());
    QCOMPARE(cli.run("mode 1 speed").exit, 0);
    const ProgramResult refused = cli.run("step-response 1 --size 300 --repeats 1");
    QCOMPARE(refused.exit, 2);
    QVERIFY2(refused.err.contains(text("--switch-mode")), qPrintable(refused.err));
    const ProgramResult done =
        cli.run("step-response 1 --size 300 --repeats 1 --hold 500 --switch-mode");
    QVERIFY2(done.exit == 0, qPrintable(done.out + done.err));
    QVERIFY(cli.run("read 1 operating_mode").out.contains(text("speed")));
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
    QVERIFY(cli.run("read 1 position_p").out.contains(text("20")));
    const ProgramResult found = cli.json("recover");
    const QJsonArray intents = found.json()[text("intents")].toArray();
    QCOMPARE(intents.size(), 1);
    QCOMPARE(intents[0][text("kind")].toString(), text("trial"));
    const ProgramResult undone = cli.run("recover --undo");
    QVERIFY2(undone.exit == 0, qPrintable(undone.out + undone.err));
    QVERIFY(cli.run("read 1 position_p").out.contains(text("32")));
    QVERIFY(cli.json("recover").json()[text("intents")].toArray().isEmpty());
}

void TestCliStepResponse::storedRunsAreListedReportedAndCompared()
{
    CliProgram cli;
    QVERIFY(cli.json("step-runs").json()[text("runs")].toArray().isEmpty());
    cli.setPort(text("sim:sts3215@1"));
    const QString both = cli.dataFolder() + text("/both.json");
    const ProgramResult measured = cli.run(
        QStringList{text("step-response"), text("1"), text("--size"), text("300"),
                    text("--repeats"), text("1"), text("--hold"), text("900"), text("--try"),
                    text("position_p=10,position_d=0"), text("--report"), both});
    QVERIFY2(measured.exit == 0, qPrintable(measured.out + measured.err));
    cli.setPort({}); // from here on no servo is needed

    const QJsonArray runs = cli.json("step-runs --model sts3215").json()[text("runs")].toArray();
    QCOMPARE(runs.size(), 2);
    QCOMPARE(runs[0][text("number")].toInt(), 2); // newest first
    QCOMPARE(runs[0][text("kind")].toString(), text("step"));
    QCOMPARE(runs[1][text("files")][0].toString(), both);
    QVERIFY(cli.run("step-runs").out.contains(text("Completed.")));
    QVERIFY(cli.run("step-runs --servo 7").out.contains(text("No matching test runs")));
    QVERIFY(cli.json("sweep-runs").json()[text("runs")].toArray().isEmpty());

    const QString one = cli.dataFolder() + text("/one.json");
    QCOMPARE(cli.run({text("step-report"), text("2"), one}).exit, 0);
    const auto stored = results::decodeStepRuns(contents(one));
    const auto original = results::decodeStepRuns(contents(both));
    QVERIFY(stored && original && stored->size() == 1);
    QVERIFY(stored->front() == original->back());
    const QString page = cli.dataFolder() + text("/one.html");
    QCOMPARE(cli.run({text("step-report"), both, page}).exit, 0);
    QVERIFY(contents(page).startsWith("<!DOCTYPE html>"));
    const QString paper = cli.dataFolder() + text("/one.pdf");
    QCOMPARE(cli.run({text("step-report"), both, paper}).exit, 0);
    QProcess reader;
    reader.start(text("pdftotext"), {text("-layout"), paper, text("-")});
    QVERIFY(reader.waitForFinished());
    const QString words = QString::fromUtf8(reader.readAllStandardOutput());
    for (const char* fact : {"Step response", "Before", "Overshoot", "STS3215"})
        QVERIFY2(words.contains(text(fact)), fact);

    // What the history has of both runs compares as it did when they were measured.
    const QString pair = cli.dataFolder() + text("/pair.csv");
    const ProgramResult compared = cli.run(
        {text("step-compare"), text("1"), text("2"), text("--report"), pair, text("--json")});
    QVERIFY2(compared.exit == 0, qPrintable(compared.out + compared.err));
    QCOMPARE(compared.out.toUtf8(), contents(both));
    QVERIFY(contents(pair).startsWith("run,response,t[ms]"));
    const ProgramResult shown = cli.run({text("step-compare"), text("1"), one});
    QVERIFY2(shown.out.contains(text("Before")) && shown.out.contains(text("Raise I")),
             qPrintable(shown.out + shown.err));
}

void TestCliStepResponse::unknownStoredRunsAreReported_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("says");
    QTest::newRow("report") << text("step-report 12 a.html") << 2
                            << text("\"step-runs\" lists all");
    QTest::newRow("ending") << text("step-report 12 a.txt") << 2 << text(".html");
    QTest::newRow("compare") << text("step-compare 12 13") << 2 << text("12");
    QTest::newRow("no file") << text("step-compare /nowhere.json 13") << 5 << text("/nowhere.json");
    QTest::newRow("compare ending")
        << text("step-compare 1 2 --report a.txt") << 2 << text(".html");
    QTest::newRow("servo") << text("step-runs --servo x") << 2 << QString();
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

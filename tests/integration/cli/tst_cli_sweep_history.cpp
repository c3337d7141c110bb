// SPDX-License-Identifier: GPL-3.0-or-later
// Sweep tests in the history, as a user of servodesk-cli sees them: they are listed, compared, one
// is the reference, and without a usable history neither the verdict nor the run is lost.
#include "results/sweep_json.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;

namespace {
// Enough legs for a verdict even if a busy machine misses some arrivals.
const char* const shortTest = "sweep 1 --from 1800 --to 2200 --dwell 100 --cycles 4 --speed 3000";

QJsonObject rowOf(const QJsonArray& rows, const char* name, const char* value)
{
    for (const QJsonValue& row : rows) {
        if (row[QLatin1String(name)].toString() == utf8(value))
            return row.toObject();
    }
    return {};
}
} // namespace

class TestCliSweepHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void saveListCompareAndMark();
    void anUnusableHistoryBreaksNothingElse();
    void usageErrorsAreReported_data();
    void usageErrorsAreReported();
};

void TestCliSweepHistory::saveListCompareAndMark()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1,sts3215@2+static-error=6"));
    const ProgramResult none = cli.json("sweep-runs");
    QCOMPARE(none.exit, 0);
    QVERIFY(none.json()[utf8("runs")].toArray().isEmpty());
    QVERIFY(!QFile::exists(cli.dataFolder() + utf8("/history.sqlite")));

    const QString report = cli.dataFolder() + utf8("/one.json");
    const ProgramResult first =
        cli.run(utf8(shortTest).split(QLatin1Char(' '))
                << utf8("--report") << report << utf8("--note") << utf8("先行"));
    QVERIFY2(first.exit == 0, qPrintable(first.out + first.err));
    QVERIFY2(first.out.contains(utf8("test run 1")), qPrintable(first.out));
    const ProgramResult both =
        cli.run("sweep 1 2 --from 1500 --to 2200 --dwell 100 --cycles 4 --speed 3000");
    QVERIFY2(both.out.contains(utf8("test run 2")), qPrintable(both.out + both.err));

    const QJsonArray runs = cli.json("sweep-runs --model sts3215").json()[utf8("runs")].toArray();
    QCOMPARE(runs.size(), 2);
    QCOMPARE(runs[0][utf8("number")].toInt(), 2); // newest first
    QCOMPARE(runs[0][utf8("servos")].toArray().size(), 2);
    QCOMPARE(runs[1][utf8("note")].toString(), utf8("先行"));
    QCOMPARE(runs[1][utf8("verdict")].toString(), utf8("pass"));
    QCOMPARE(runs[1][utf8("files")][0].toString(), report);
    QVERIFY(QFile::exists(runs[1][utf8("files")][1].toString()));
    QCOMPARE(cli.json("sweep-runs --servo 2").json()[utf8("runs")].toArray().size(), 1);
    QVERIFY(cli.run("sweep-runs --model HLS3606").out.contains(utf8("No matching test runs")));

    // The report file and the run in the history are the same test.
    const ProgramResult same = cli.json("sweep-compare 1 one.json");
    QCOMPARE(same.exit, 5); // not in this folder
    const ProgramResult equal =
        cli.run({utf8("sweep-compare"), utf8("#1"), report, utf8("--json")});
    QVERIFY2(equal.exit == 0, qPrintable(equal.out + equal.err));
    QVERIFY(equal.json()[utf8("comparable")].toBool());
    QVERIFY(equal.json()[utf8("tests")].toArray().isEmpty());
    QVERIFY(equal.json()[utf8("settings")].toArray().isEmpty());
    for (const QJsonValue& row : equal.json()[utf8("figures")].toArray())
        QVERIFY(row[utf8("difference")].toDouble() == 0.0);

    const QString page = cli.dataFolder() + utf8("/compare.html");
    const ProgramResult pair = cli.run(
        {utf8("sweep-compare"), utf8("2:1"), utf8("2:2"), utf8("--report"), page, utf8("--json")});
    QVERIFY2(pair.exit == 0, qPrintable(pair.out + pair.err));
    const QJsonObject error =
        rowOf(pair.json()[utf8("figures")].toArray(), "metric", "steady_error");
    QVERIFY(error[utf8("b")].toDouble() > 4);
    QCOMPARE(error[utf8("better")].toString(), utf8("a"));
    QFile file(page);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("<!DOCTYPE html>"));
    const ProgramResult other = cli.run("sweep-compare 1 2:1");
    QVERIFY2(other.out.contains(utf8("cannot be compared")), qPrintable(other.out));
    QVERIFY(other.out.contains(utf8("1500 … 2200")));

    QCOMPARE(cli.run("sweep-reference 2:1").exit, 0);
    QCOMPARE(cli.run("sweep-reference 1").exit, 0);
    const auto marked = [&] {
        QStringList found;
        const QJsonArray all = cli.json("sweep-runs").json()[utf8("runs")].toArray();
        for (const QJsonValue& run : all) {
            for (const QJsonValue& servo : run[utf8("servos")].toArray()) {
                if (servo[utf8("reference")].toBool())
                    found << QString::number(run[utf8("number")].toInt());
            }
        }
        return found;
    };
    QCOMPARE(marked(), QStringList(utf8("1")));
    QCOMPARE(cli.run("sweep-reference 1 --clear").exit, 0);
    QCOMPARE(marked(), QStringList());
}

void TestCliSweepHistory::anUnusableHistoryBreaksNothingElse()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QVERIFY(QDir().mkpath(cli.dataFolder() + utf8("/history.sqlite")));
    const ProgramResult result = cli.run(shortTest);
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    QVERIFY(result.out.contains(utf8("Pass")));
    QVERIFY2(result.err.contains(utf8("history")), qPrintable(result.err));
    const QStringList left = QDir(cli.dataFolder()).entryList({utf8("sweep-*.json")});
    QCOMPARE(left.size(), 1);
    QVERIFY(result.err.contains(left[0]));
    QVERIFY(results::loadSweepRun(cli.dataFolder() + QLatin1Char('/') + left[0]));
    QCOMPARE(cli.run("sweep-runs").exit, 5);
}

void TestCliSweepHistory::usageErrorsAreReported_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("exit");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* command, int exit, const char* word) {
        QTest::newRow(command) << utf8(command) << exit << utf8(word);
    };
    row("sweep-compare 12 13", 2, "12");
    row("sweep-compare /nowhere.json 13", 5, "/nowhere.json");
    row("sweep-compare 12", 2, "B");
    row("sweep-compare 12 13 --report x.pdf", 2, ".html");
    row("sweep-compare 12:300 13", 2, "300");
    row("sweep-reference 12", 2, "12");
    row("sweep-reference run.json", 2, "history");
    row("sweep-runs --servo x", 2, "x");
}

void TestCliSweepHistory::usageErrorsAreReported()
{
    QFETCH(QString, command);
    QFETCH(int, exit);
    QFETCH(QString, word);
    CliProgram cli;
    const ProgramResult result = cli.run(command.split(QLatin1Char(' ')));
    QCOMPARE(result.exit, exit);
    QVERIFY2(result.err.contains(word), qPrintable(result.err));
}

SERVODESK_GUILESS_TEST(TestCliSweepHistory)
#include "tst_cli_sweep_history.moc"

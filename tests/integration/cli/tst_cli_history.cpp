// SPDX-License-Identifier: GPL-3.0-or-later
// The history as a user of servodesk-cli sees it: every command that writes saves the table first
// and prints the file; all entries can be listed, labeled, exported and saved as files.
#include "history/history_file.h"
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

#include <csignal>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::utf8;
using support::words;

namespace {
/// As the window writes it.
bool markAsUndo(const CliProgram& cli, const char* key)
{
    const auto file = history::HistoryFile::open(cli.historyFile(), std::chrono::seconds(1));
    return file &&
           (*file)->run(utf8("UPDATE intents SET kind = ? WHERE number = (SELECT MAX(intent) "
                             "FROM writes WHERE key = ?)"),
                        {utf8("undo"), utf8(key)});
}

QStringList savedSnapshots(const CliProgram& cli)
{
    return QDir(cli.dataFolder() + utf8("/snapshots")).entryList({utf8("*.servo.json")});
}

QJsonArray rows(CliProgram& cli, const char* kind, const char* more = "")
{
    const ProgramResult result =
        cli.run(words("history --json --kind") << utf8(kind) << words(more));
    return result.json()[utf8(kind)].toArray();
}
} // namespace

class TestCliHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void writingCommandsSaveASnapshotFirst_data();
    void writingCommandsSaveASnapshotFirst();
    void readingCommandsSaveNothing_data();
    void readingCommandsSaveNothing();
    void recoveryCommandsSaveASnapshotFirst();
    void anAlarmDoesNotPreventSaving();
    void alarmsSeenWhileWatchingAreRecorded();
    void noWriteWithoutASnapshot();
    void listLabelAndExtract();
    void savedFilesAreInTheHistoryToo();
    void exports();
    void readingCreatesNoHistory();
    void usageErrorsAreReported_data();
    void usageErrorsAreReported();
};

void TestCliHistory::writingCommandsSaveASnapshotFirst_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"write 1 position_p=40", "write 1 position_p=40 --temporary", "set-id 1 9",
          "set-baud 1 500000", "center 1", "mode 1 speed", "restore-defaults 1", "identify 1"})
        QTest::newRow(line) << utf8(line);
}

void TestCliHistory::writingCommandsSaveASnapshotFirst()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    const ProgramResult result = cli.run(line.split(QLatin1Char(' ')) << utf8("--json"));
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QString place = result.json()[utf8("snapshot")].toString();
    QVERIFY2(QFile::exists(place), qPrintable(result.out));
    QCOMPARE(savedSnapshots(cli).size(), 1);
    const QJsonArray kept = rows(cli, "snapshots");
    QCOMPARE(kept.size(), 1);
    QCOMPARE(kept[0][utf8("file")].toString(), place);
    QCOMPARE(kept[0][utf8("reason")].toString(), utf8("automatic"));
    QVERIFY(!rows(cli, "writes").isEmpty());

    const ProgramResult inText = cli.run(line.split(QLatin1Char(' ')));
    QVERIFY2(inText.err.contains(cli.dataFolder() + utf8("/snapshots/")), qPrintable(inText.err));
    QCOMPARE(savedSnapshots(cli).size(), 2);
}

void TestCliHistory::readingCommandsSaveNothing_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line : {"info 1", "read 1 position_p", "scan", "torque 1 on", "move 1=2100",
                             "recover", "clear-alarm 1", "write 1 nonsense=1"})
        QTest::newRow(line) << utf8(line);
}

void TestCliHistory::readingCommandsSaveNothing()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    cli.run(line.split(QLatin1Char(' ')));
    QVERIFY(savedSnapshots(cli).isEmpty());
    QVERIFY(rows(cli, "writes").isEmpty());
}

void TestCliHistory::recoveryCommandsSaveASnapshotFirst()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1 --latency-ms 16"));
    cli.setPort(sim.port());
    cli.start(words("write 1 max_temperature=60 max_voltage=85 position_p=20 overload_torque=70"));
    QTRY_VERIFY(!savedSnapshots(cli).isEmpty());
    const auto begun = [&] {
        CliProgram& own = cli;
        QFile wal(own.historyFile() + utf8("-wal"));
        return wal.open(QIODevice::ReadOnly) && wal.readAll().contains("overload_torque");
    };
    QTRY_VERIFY(begun());
    cli.signal(SIGKILL);
    cli.finish();
    QCOMPARE(savedSnapshots(cli).size(), 1);
    const QJsonArray open = cli.json("recover").json()[utf8("intents")].toArray();
    QCOMPARE(open.size(), 1);
    QCOMPARE(savedSnapshots(cli).size(), 1); // reading saves nothing
    QVERIFY(rows(cli, "writes")[0][utf8("outcome")].toString().isEmpty());
    const ProgramResult settled = cli.json("recover --finish");
    QVERIFY2(settled.exit == 0, qPrintable(settled.out + settled.err));
    QVERIFY(QFile::exists(settled.json()[utf8("snapshot")].toString()));
    QCOMPARE(savedSnapshots(cli).size(), 2);
    QVERIFY(rows(cli, "writes", "--problems").isEmpty());
}

/// An overloaded servo replies, so its table is saved like that of any other.
void TestCliHistory::anAlarmDoesNotPreventSaving()
{
    CliProgram cli;
    cli.setPort(utf8("sim:trouble"));
    const QJsonArray found = cli.json("scan").json()[utf8("found")].toArray();
    int alarmedId = -1;
    for (const QJsonValue& servo : found) {
        if (!servo[utf8("status")].toArray().isEmpty())
            alarmedId = servo[utf8("id")].toInt();
    }
    QVERIFY2(alarmedId >= 0, "the simulated trouble has no alarm");
    const ProgramResult result =
        cli.run(words("write --json") << QString::number(alarmedId) << utf8("max_temperature=71"));
    QVERIFY2(result.json().contains(utf8("snapshot")), qPrintable(result.out + result.err));
}

void TestCliHistory::alarmsSeenWhileWatchingAreRecorded()
{
    CliProgram cli;
    cli.setPort(utf8("sim:trouble"));
    cli.run("scan");
    QVERIFY(rows(cli, "alarms").isEmpty());
    const auto watched = [&cli] {
        cli.run("watch 4 5 --duration 0.3"); // 5 is jammed, 4 has nothing
        return rows(cli, "alarms");
    };
    const QJsonArray kept = watched();
    QCOMPARE(kept.size(), 1);
    QCOMPARE(kept[0][utf8("id")].toInt(), 5);
    QCOMPARE(kept[0][utf8("alarm")].toString(), utf8("overload"));
    QVERIFY(kept[0][utf8("went")].isNull());
    QCOMPARE(watched(), kept); // the same one, not gone yet
}

void TestCliHistory::noWriteWithoutASnapshot()
{
    CliProgram cli;
    cli.setServos(utf8("sts3215@1"));
    QFile blockingFile(cli.dataFolder() + utf8("/snapshots"));
    QVERIFY(blockingFile.open(QIODevice::WriteOnly));
    const ProgramResult result = cli.run("write 1 position_p=40");
    QCOMPARE(result.exit, 5);
    QVERIFY2(result.err.contains(utf8("nothing was written")), qPrintable(result.err));
    const ProgramResult after = cli.json("read 1 position_p");
    QCOMPARE(after.json()[utf8("registers")][0][utf8("raw")].toInt(), 32);
    QVERIFY(rows(cli, "writes").isEmpty());
}

void TestCliHistory::listLabelAndExtract()
{
    CliProgram cli;
    cli.setServos(utf8("sts3215@1,sts3215@2"));
    QCOMPARE(cli.run("write 1 position_p=40 position_d=20").exit, 0);
    QCOMPARE(cli.run("write 2 position_p=41").exit, 0);
    QCOMPARE(rows(cli, "writes").size(), 3);
    QCOMPARE(rows(cli, "writes", "--id 1").size(), 2);
    QCOMPARE(rows(cli, "writes", "--id 1 --register position_d").size(), 1);
    QCOMPARE(rows(cli, "writes", "--model sts3215 --limit 2").size(), 2);
    QCOMPARE(rows(cli, "writes", "--since 1h").size(), 3);
    QVERIFY(rows(cli, "writes", "--until 2020-01-01").isEmpty());
    QVERIFY(rows(cli, "writes", "--problems").isEmpty());
    const QJsonArray servos = rows(cli, "servos", "--id 1");
    QCOMPARE(servos.size(), 1);
    const QString number = QString::number(servos[0][utf8("number")].toInt());
    QVERIFY(cli.run("history --kind servos").out.contains(utf8("no serial number")));
    QCOMPARE(cli.run({utf8("history"), utf8("label"), number, utf8("left knee")}).exit, 0);
    // With the number as printed.
    const QString shownNumber = QLatin1Char('#') + number;
    const ProgramResult unnamed = cli.run({utf8("history"), utf8("label"), shownNumber, QString()});
    QVERIFY2(unnamed.out.contains(utf8("no longer has a label")), qPrintable(unnamed.out));
    QCOMPARE(cli.run({utf8("history"), utf8("label"), shownNumber, utf8("left knee")}).exit, 0);
    const ProgramResult labeled = cli.run({utf8("history"), utf8("--servo"), utf8("left knee")});
    QVERIFY2(labeled.out.contains(utf8("left knee")), qPrintable(labeled.out + labeled.err));

    const ProgramResult shown = cli.json("history show 1");
    QCOMPARE(shown.json()[utf8("writes")].toArray().size(), 2);
    QCOMPARE(shown.json()[utf8("label")].toString(), utf8("left knee"));

    // A snapshot from the history and the present table, both for snapshot restore.
    const QString before = cli.dataFolder() + utf8("/before.servo.json");
    const QString now = cli.dataFolder() + utf8("/now.servo.json");
    QCOMPARE(cli.run({utf8("history"), utf8("snapshot"), utf8("1"), before}).exit, 0);
    const ProgramResult table = cli.run({utf8("history"), utf8("table"), utf8("left knee"),
                                         utf8("2100-01-01"), now, utf8("--json")});
    QCOMPARE(table.exit, 0);
    QCOMPARE(table.json()[utf8("replayed")].toArray().size(), 2);
    const auto gain = [&](const QString& file) {
        const ProgramResult result =
            cli.run({utf8("snapshot"), utf8("show"), file, utf8("--json")});
        for (const QJsonValue& row : result.json()[utf8("registers")].toArray()) {
            if (row[utf8("key")].toString() == utf8("position_p"))
                return row[utf8("raw")].toInt();
        }
        return -1;
    };
    QCOMPARE(gain(before), 32);
    QCOMPARE(gain(now), 40);

    // Another servo with the same ID: its history begins now.
    QCOMPARE(
        cli.run({utf8("history"), utf8("label"), number, utf8("spare"), utf8("--another")}).exit,
        0);
    QCOMPARE(cli.run("write 1 position_p=42").exit, 0);
    QCOMPARE(rows(cli, "writes", "--label spare").size(), 1);
    QCOMPARE(rows(cli, "writes", "--id 1").size(), 3);
    // The saved table contains the label.
    QCOMPARE(rows(cli, "snapshots", "--label spare").size(), 1);
    QCOMPARE(rows(cli, "snapshots", "--label spare")[0][utf8("label")].toString(), utf8("spare"));

    // Values with their units, and the kind of the write.
    QCOMPARE(cli.run("write 1 max_voltage=85").exit, 0);
    QVERIFY(markAsUndo(cli, "max_voltage"));
    const ProgramResult listed = cli.run("history --register max_voltage");
    QVERIFY2(listed.out.contains(utf8("85 · 8.5 V")), qPrintable(listed.out));
    QVERIFY2(listed.out.contains(utf8("undo")), qPrintable(listed.out));
    QVERIFY2(listed.out.contains(utf8("sim:sts3215@1,sts3215@2")), qPrintable(listed.out));
    const ProgramResult one = cli.run("history show 5");
    QVERIFY2(one.out.startsWith(utf8("undo: ")), qPrintable(one.out));
    QVERIFY2(one.out.contains(utf8("85 · 8.5 V")), qPrintable(one.out));
}

void TestCliHistory::savedFilesAreInTheHistoryToo()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1,sts3215@2"));
    const QString one = cli.dataFolder() + utf8("/one.servo.json");
    const QString all = cli.dataFolder() + utf8("/all.bundle.json");
    QCOMPARE(
        cli.run({utf8("snapshot"), utf8("save"), utf8("1"), one, utf8("--label"), utf8("good")})
            .exit,
        0);
    QCOMPARE(cli.run({utf8("bundle"), utf8("save"), all}).exit, 0);
    const QJsonArray kept = rows(cli, "snapshots");
    QCOMPARE(kept.size(), 3);
    int labeled = 0;
    for (const QJsonValue& row : kept)
        labeled += row[utf8("label")].toString() == utf8("good") ? 1 : 0;
    QCOMPARE(labeled, 1);
}

void TestCliHistory::exports()
{
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 position_p=40 position_d=20").exit, 0);
    const QString csv = cli.dataFolder() + utf8("/w.csv");
    const QString json = cli.dataFolder() + utf8("/w.json");
    QCOMPARE(cli.run({utf8("history"), utf8("--csv"), csv}).exit, 0);
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().count('\n'), 3);
    QCOMPARE(
        cli.run({utf8("history"), utf8("--kind"), utf8("snapshots"), utf8("--export"), json}).exit,
        0);
    QFile document(json);
    QVERIFY(document.open(QIODevice::ReadOnly));
    QCOMPARE(
        QJsonDocument::fromJson(document.readAll()).object()[utf8("snapshots")].toArray().size(),
        1);
    QCOMPARE(cli.run({utf8("history"), utf8("--csv"), utf8("/nowhere/at/all.csv")}).exit, 5);
}

void TestCliHistory::readingCreatesNoHistory()
{
    CliProgram cli;
    QCOMPARE(cli.run("history").exit, 0);
    QVERIFY(rows(cli, "servos").isEmpty());
    QVERIFY(!QFile::exists(cli.historyFile()));
}

void TestCliHistory::usageErrorsAreReported_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"history --kind dogs", "history --since yesterday", "history --until 2026-13-01",
          "history --limit 0", "history --id 255", "history --servo nobody", "history show 99",
          "history show x", "history label 99 a", "history snapshot 99 f",
          "history table 1 never f", "history table 1 2020-01-01 f", "history --csv a --export b",
          "history show"})
        QTest::newRow(line) << utf8(line);
}

void TestCliHistory::usageErrorsAreReported()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(utf8("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 position_p=40").exit, 0);
    const ProgramResult result = cli.run(line.split(QLatin1Char(' ')));
    QCOMPARE(result.exit, 2);
    QVERIFY(!result.err.isEmpty());
}

SERVODESK_GUILESS_TEST(TestCliHistory)
#include "tst_cli_history.moc"

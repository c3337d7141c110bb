// SPDX-License-Identifier: GPL-3.0-or-later
// The history as a user of servodesk-cli sees it: every command that writes saves the table first
// and prints the file; all entries can be listed, labeled, exported and saved as files.
#include "history/history_file.h"
#include "support/cli_program.h"
#include "support/test_main.h"

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
using support::words;

namespace {
QString text(const char* utf8)
{
    return QString::fromUtf8(utf8);
}

/// As the window writes it.
bool markAsUndo(const CliProgram& cli, const char* key)
{
    const auto file = history::HistoryFile::open(cli.dataFolder() + text("/history.sqlite"),
                                                 std::chrono::seconds(1));
    return file &&
           (*file)->run(text("UPDATE intents SET kind = ? WHERE number = (SELECT MAX(intent) "
                             "FROM writes WHERE key = ?)"),
                        {text("undo"), text(key)});
}

QStringList savedSnapshots(const CliProgram& cli)
{
    return QDir(cli.dataFolder() + text("/snapshots")).entryList({text("*.servo.json")});
}

QJsonArray rows(CliProgram& cli, const char* kind, const char* more = "")
{
    const ProgramResult result =
        cli.run(words("history --json --kind") << text(kind) << words(more));
    return result.json()[text(kind)].toArray();
}
} // namespace

class TestCliHistory : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

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
        QTest::newRow(line) << text(line);
}

void TestCliHistory::writingCommandsSaveASnapshotFirst()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
    const ProgramResult result = cli.run(line.split(QLatin1Char(' ')) << text("--json"));
    QVERIFY2(result.exit == 0, qPrintable(result.out + result.err));
    const QString place = result.json()[text("snapshot")].toString();
    QVERIFY2(QFile::exists(place), qPrintable(result.out));
    QCOMPARE(savedSnapshots(cli).size(), 1);
    const QJsonArray kept = rows(cli, "snapshots");
    QCOMPARE(kept.size(), 1);
    QCOMPARE(kept[0][text("file")].toString(), place);
    QCOMPARE(kept[0][text("reason")].toString(), text("automatic"));
    QVERIFY(!rows(cli, "writes").isEmpty());

    const ProgramResult inText = cli.run(line.split(QLatin1Char(' ')));
    QVERIFY2(inText.err.contains(cli.dataFolder() + text("/snapshots/")), qPrintable(inText.err));
    QCOMPARE(savedSnapshots(cli).size(), 2);
}

void TestCliHistory::readingCommandsSaveNothing_data()
{
    QTest::addColumn<QString>("line");
    for (const char* line : {"info 1", "read 1 position_p", "scan", "torque 1 on", "move 1=2100",
                             "recover", "clear-alarm 1", "write 1 nonsense=1"})
        QTest::newRow(line) << text(line);
}

void TestCliHistory::readingCommandsSaveNothing()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
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
        QFile wal(own.dataFolder() + text("/history.sqlite-wal"));
        return wal.open(QIODevice::ReadOnly) && wal.readAll().contains("overload_torque");
    };
    QTRY_VERIFY(begun());
    cli.signal(SIGKILL);
    cli.finish();
    QCOMPARE(savedSnapshots(cli).size(), 1);
    const QJsonArray open = cli.json("recover").json()[text("intents")].toArray();
    QCOMPARE(open.size(), 1);
    QCOMPARE(savedSnapshots(cli).size(), 1); // reading saves nothing
    QVERIFY(rows(cli, "writes")[0][text("outcome")].toString().isEmpty());
    const ProgramResult settled = cli.json("recover --finish");
    QVERIFY2(settled.exit == 0, qPrintable(settled.out + settled.err));
    QVERIFY(QFile::exists(settled.json()[text("snapshot")].toString()));
    QCOMPARE(savedSnapshots(cli).size(), 2);
    QVERIFY(rows(cli, "writes", "--problems").isEmpty());
}

/// An overloaded servo replies, so its table is saved like that of any other.
void TestCliHistory::anAlarmDoesNotPreventSaving()
{
    CliProgram cli;
    cli.setPort(text("sim:trouble"));
    const QJsonArray found = cli.json("scan").json()[text("found")].toArray();
    int alarmedId = -1;
    for (const QJsonValue& servo : found) {
        if (!servo[text("status")].toArray().isEmpty())
            alarmedId = servo[text("id")].toInt();
    }
    QVERIFY2(alarmedId >= 0, "the simulated trouble has no alarm");
    const ProgramResult result =
        cli.run(words("write --json") << QString::number(alarmedId) << text("max_temperature=71"));
    QVERIFY2(result.json().contains(text("snapshot")), qPrintable(result.out + result.err));
}

void TestCliHistory::alarmsSeenWhileWatchingAreRecorded()
{
    CliProgram cli;
    cli.setPort(text("sim:trouble"));
    cli.run("scan");
    QVERIFY(rows(cli, "alarms").isEmpty());
    const auto watched = [&cli] {
        cli.run("watch 4 5 --duration 0.3"); // 5 is jammed, 4 has nothing
        return rows(cli, "alarms");
    };
    const QJsonArray kept = watched();
    QCOMPARE(kept.size(), 1);
    QCOMPARE(kept[0][text("id")].toInt(), 5);
    QCOMPARE(kept[0][text("alarm")].toString(), text("overload"));
    QVERIFY(kept[0][text("went")].isNull());
    QCOMPARE(watched(), kept); // the same one, not gone yet
}

void TestCliHistory::noWriteWithoutASnapshot()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1"));
    cli.setPort(sim.port());
    QFile blockingFile(cli.dataFolder() + text("/snapshots"));
    QVERIFY(blockingFile.open(QIODevice::WriteOnly));
    const ProgramResult result = cli.run("write 1 position_p=40");
    QCOMPARE(result.exit, 5);
    QVERIFY2(result.err.contains(text("nothing was written")), qPrintable(result.err));
    const ProgramResult after = cli.json("read 1 position_p");
    QCOMPARE(after.json()[text("registers")][0][text("raw")].toInt(), 32);
    QVERIFY(rows(cli, "writes").isEmpty());
}

void TestCliHistory::listLabelAndExtract()
{
    CliProgram cli;
    SimProgram sim(words("--servos sts3215@1,sts3215@2"));
    cli.setPort(sim.port());
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
    const QString number = QString::number(servos[0][text("number")].toInt());
    QVERIFY(cli.run("history --kind servos").out.contains(text("no serial number")));
    QCOMPARE(cli.run({text("history"), text("label"), number, text("left knee")}).exit, 0);
    // With the number as printed.
    const QString shownNumber = QLatin1Char('#') + number;
    const ProgramResult unnamed = cli.run({text("history"), text("label"), shownNumber, QString()});
    QVERIFY2(unnamed.out.contains(text("no longer has a label")), qPrintable(unnamed.out));
    QCOMPARE(cli.run({text("history"), text("label"), shownNumber, text("left knee")}).exit, 0);
    const ProgramResult labeled = cli.run({text("history"), text("--servo"), text("left knee")});
    QVERIFY2(labeled.out.contains(text("left knee")), qPrintable(labeled.out + labeled.err));

    const ProgramResult shown = cli.json("history show 1");
    QCOMPARE(shown.json()[text("writes")].toArray().size(), 2);
    QCOMPARE(shown.json()[text("label")].toString(), text("left knee"));

    // A snapshot from the history and the present table, both for snapshot restore.
    const QString before = cli.dataFolder() + text("/before.servo.json");
    const QString now = cli.dataFolder() + text("/now.servo.json");
    QCOMPARE(cli.run({text("history"), text("snapshot"), text("1"), before}).exit, 0);
    const ProgramResult table = cli.run({text("history"), text("table"), text("left knee"),
                                         text("2100-01-01"), now, text("--json")});
    QCOMPARE(table.exit, 0);
    QCOMPARE(table.json()[text("replayed")].toArray().size(), 2);
    const auto gain = [&](const QString& file) {
        const ProgramResult result =
            cli.run({text("snapshot"), text("show"), file, text("--json")});
        for (const QJsonValue& row : result.json()[text("registers")].toArray()) {
            if (row[text("key")].toString() == text("position_p"))
                return row[text("raw")].toInt();
        }
        return -1;
    };
    QCOMPARE(gain(before), 32);
    QCOMPARE(gain(now), 40);

    // Another servo with the same ID: its history begins now.
    QCOMPARE(
        cli.run({text("history"), text("label"), number, text("spare"), text("--another")}).exit,
        0);
    QCOMPARE(cli.run("write 1 position_p=42").exit, 0);
    QCOMPARE(rows(cli, "writes", "--label spare").size(), 1);
    QCOMPARE(rows(cli, "writes", "--id 1").size(), 3);
    // The saved table contains the label.
    QCOMPARE(rows(cli, "snapshots", "--label spare").size(), 1);
    QCOMPARE(rows(cli, "snapshots", "--label spare")[0][text("label")].toString(), text("spare"));

    // Values with their units, and the kind of the write.
    QCOMPARE(cli.run("write 1 max_voltage=85").exit, 0);
    QVERIFY(markAsUndo(cli, "max_voltage"));
    const ProgramResult listed = cli.run("history --register max_voltage");
    QVERIFY2(listed.out.contains(text("85 · 8.5 V")), qPrintable(listed.out));
    QVERIFY2(listed.out.contains(text("undo")), qPrintable(listed.out));
    QVERIFY2(listed.out.contains(sim.port()), qPrintable(listed.out));
    const ProgramResult one = cli.run("history show 5");
    QVERIFY2(one.out.startsWith(text("undo: ")), qPrintable(one.out));
    QVERIFY2(one.out.contains(text("85 · 8.5 V")), qPrintable(one.out));
}

void TestCliHistory::savedFilesAreInTheHistoryToo()
{
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1,sts3215@2"));
    const QString one = cli.dataFolder() + text("/one.servo.json");
    const QString all = cli.dataFolder() + text("/all.bundle.json");
    QCOMPARE(
        cli.run({text("snapshot"), text("save"), text("1"), one, text("--label"), text("good")})
            .exit,
        0);
    QCOMPARE(cli.run({text("bundle"), text("save"), all}).exit, 0);
    const QJsonArray kept = rows(cli, "snapshots");
    QCOMPARE(kept.size(), 3);
    int labeled = 0;
    for (const QJsonValue& row : kept)
        labeled += row[text("label")].toString() == text("good") ? 1 : 0;
    QCOMPARE(labeled, 1);
}

void TestCliHistory::exports()
{
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 position_p=40 position_d=20").exit, 0);
    const QString csv = cli.dataFolder() + text("/w.csv");
    const QString json = cli.dataFolder() + text("/w.json");
    QCOMPARE(cli.run({text("history"), text("--csv"), csv}).exit, 0);
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().count('\n'), 3);
    QCOMPARE(
        cli.run({text("history"), text("--kind"), text("snapshots"), text("--export"), json}).exit,
        0);
    QFile document(json);
    QVERIFY(document.open(QIODevice::ReadOnly));
    QCOMPARE(
        QJsonDocument::fromJson(document.readAll()).object()[text("snapshots")].toArray().size(),
        1);
    QCOMPARE(cli.run({text("history"), text("--csv"), text("/nowhere/at/all.csv")}).exit, 5);
}

void TestCliHistory::readingCreatesNoHistory()
{
    CliProgram cli;
    QCOMPARE(cli.run("history").exit, 0);
    QVERIFY(rows(cli, "servos").isEmpty());
    QVERIFY(!QFile::exists(cli.dataFolder() + text("/history.sqlite")));
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
        QTest::newRow(line) << text(line);
}

void TestCliHistory::usageErrorsAreReported()
{
    QFETCH(const QString, line);
    CliProgram cli;
    cli.setPort(text("sim:sts3215@1"));
    QCOMPARE(cli.run("write 1 position_p=40").exit, 0);
    const ProgramResult result = cli.run(line.split(QLatin1Char(' ')));
    QCOMPARE(result.exit, 2);
    QVERIFY(!result.err.isEmpty());
}

SERVODESK_GUILESS_TEST(TestCliHistory)
#include "tst_cli_history.moc"

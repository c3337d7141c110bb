// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, templates and bundles from the command line, as a user runs it: saved, compared,
// restored, written to others, with dry runs that write nothing and with their exit codes.
#include "support/cli_program.h"
#include "support/test_main.h"

#include <QDir>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;
using support::SimProgram;
using support::words;

namespace {
QString text(const char* word)
{
    return QString::fromUtf8(word);
}

QStringList keysOf(const QJsonArray& rows)
{
    QStringList keys;
    for (const QJsonValue& row : rows)
        keys << row[text("key")].toString();
    return keys;
}
} // namespace

class TestCliSnapshot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(text(".*")));
        m_simulator = std::make_unique<SimProgram>(
            words("--servos sts3215@1,sts3215@2,scs15@3 --baud 1000000"));
        m_cli = std::make_unique<CliProgram>();
        m_cli->setPort(m_simulator->port());
        m_folder = std::make_unique<QTemporaryDir>();
    }
    void cleanup() { m_cli.reset(); }

    void saveChangeCompareRestore();
    void aRefusedWriteLeavesNone();
    void aDryRunWritesNothing();
    void consentIsRequested();
    void limitsOfAnotherModelAreReported();
    void identityNeedsConsent();
    void aFileHasLabelNoteAndCsv();
    void factoryDefaultsAreAColumn();
    void templatesForSeveralServos();
    void skippedRowsAreReportedAndCounted();
    void bundlesAreRestoredById();
    void badFilesAreFileErrors_data();
    void badFilesAreFileErrors();
    void badArgumentsAreUsageErrors_data();
    void badArgumentsAreUsageErrors();

private:
    QString path(const char* name) const { return m_folder->filePath(text(name)); }
    ProgramResult run(const char* line)
    {
        return m_cli->run(QStringList(
            words(text(line).replace(text("@"), m_folder->path() + u'/').toUtf8().constData())));
    }
    ProgramResult json(const char* line) { return run(qPrintable(text(line) + text(" --json"))); }
    int raw(int id, const char* key)
    {
        const ProgramResult programResult =
            json(qPrintable(text("read %1 %2").arg(id).arg(text(key))));
        return programResult.json()[text("registers")].toArray().at(0)[text("raw")].toInt(-1);
    }
    int snapshots() const
    {
        return int(QDir(m_cli->dataFolder() + text("/snapshots"))
                       .entryList({text("*.servo.json")}, QDir::Files)
                       .size());
    }

    std::unique_ptr<SimProgram> m_simulator;
    std::unique_ptr<CliProgram> m_cli;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCliSnapshot::saveChangeCompareRestore()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_p=50 min_angle_limit=300").exit, 0);
    const ProgramResult diff = json("snapshot diff 1 @a.servo.json");
    QCOMPARE(diff.exit, 0);
    QCOMPARE(diff.json()[text("different")].toInt(), 2);
    const QJsonArray rows = diff.json()[text("rows")].toArray();
    QCOMPARE(keysOf(rows).mid(0, 2), (QStringList{text("min_angle_limit"), text("position_p")}));
    QCOMPARE(rows[1][text("cells")][0][text("raw")].toInt(), 50);
    QCOMPARE(rows[1][text("cells")][1][text("raw")].toInt(), 32);

    const int before = snapshots();
    const ProgramResult restored = json("snapshot restore 1 @a.servo.json --result @r.csv");
    QVERIFY2(restored.exit == 0, qPrintable(restored.out + restored.err));
    QCOMPARE(restored.json()[text("verdict")].toString(), text("done"));
    QCOMPARE(keysOf(restored.json()[text("results")].toArray()),
             (QStringList{text("min_angle_limit"), text("position_p")}));
    QCOMPARE(restored.json()[text("lock")].toString(), text("closed"));
    const QString place = restored.json()[text("snapshot")].toString();
    QVERIFY2(QFile::exists(place), qPrintable(place));
    QVERIFY(snapshots() > before);
    QCOMPARE(raw(1, "position_p"), 32);
    QFile result(path("r.csv"));
    QVERIFY(result.open(QIODevice::ReadOnly));
    QCOMPARE(result.readAll().trimmed().count('\n'), 2);

    const ProgramResult again = json("snapshot restore 1 @a.servo.json");
    QCOMPARE(again.exit, 0);
    QCOMPARE(again.json()[text("verdict")].toString(), text("already-so"));
    QVERIFY(!again.json().contains(text("snapshot")));
    QCOMPARE(json("snapshot diff 1 @a.servo.json").json()[text("different")].toInt(-1), 0);
}

/// The table is saved before the first change, not before one that is refused.
void TestCliSnapshot::aRefusedWriteLeavesNone()
{
    const QDir saved(m_cli->dataFolder() + text("/snapshots"));
    const ProgramResult refused = m_cli->run("write 1 max_temperature=250");
    QVERIFY(refused.exit != 0);
    QCOMPARE(saved.entryList(QDir::Files), QStringList());
    QVERIFY2(refused.err.contains(text("deleted")), qPrintable(refused.err));
    QCOMPARE(m_cli->json("history --kind snapshots").json()[text("snapshots")].toArray().size(), 0);
    QCOMPARE(m_cli->run("write 1 max_temperature=61").exit, 0);
    QCOMPARE(saved.entryList(QDir::Files).size(), qsizetype(1));
}

void TestCliSnapshot::aDryRunWritesNothing()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_p=50").exit, 0);
    const int before = snapshots();
    const ProgramResult dry = json("snapshot restore 1 @a.servo.json --dry-run");
    QCOMPARE(dry.exit, 0);
    QCOMPARE(dry.json()[text("dry_run")].toBool(), true);
    QCOMPARE(keysOf(dry.json()[text("writes")].toArray()), QStringList{text("position_p")});
    QStringList steps;
    for (const QJsonValue& step : dry.json()[text("steps")].toArray())
        steps << step[text("step")].toString();
    QCOMPARE(steps, (QStringList{text("torque-off"), text("unlock"), text("write"), text("lock")}));
    QVERIFY(!dry.json().contains(text("verdict")));
    QCOMPARE(raw(1, "position_p"), 50);
    QCOMPARE(snapshots(), before);
    const ProgramResult textOutput = run("snapshot restore 1 @a.servo.json --dry-run");
    QVERIFY2(textOutput.out.contains(text("50")) && textOutput.out.contains(text("lock the EPROM")),
             qPrintable(textOutput.out));
}

void TestCliSnapshot::consentIsRequested()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_offset=40 --dangerous").exit, 0);
    const ProgramResult without = json("snapshot restore 1 @a.servo.json");
    QCOMPARE(without.exit, 0);
    const QJsonArray left = without.json()[text("left_out")].toArray();
    QCOMPARE(keysOf(left), QStringList{text("position_offset")});
    QVERIFY(left[0][text("reasons")].toArray().contains(text("needs-consent")));
    QVERIFY(left[0][text("reasons")].toArray().contains(text("moves-shaft")));
    QVERIFY(run("snapshot restore 1 @a.servo.json").out.contains(text("requires confirmation")));
    QCOMPARE(raw(1, "position_offset"), 40);
    QCOMPARE(run("snapshot restore 1 @a.servo.json --dangerous").exit, 0);
    QCOMPARE(raw(1, "position_offset"), 0);
}

/// A snapshot of an 8 V servo must not cause an alarm on a 12 V servo.
void TestCliSnapshot::limitsOfAnotherModelAreReported()
{
    m_simulator = std::make_unique<SimProgram>(words("--servos sts3215@1,sts3250@4"));
    m_cli->setPort(m_simulator->port());
    QCOMPARE(run("write 1 max_voltage=80 position_p=50").exit, 0);
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    const int before = raw(4, "max_voltage");
    const ProgramResult dry = json("snapshot restore 4 @a.servo.json --dry-run --dangerous");
    QCOMPARE(dry.exit, 0);
    QVERIFY(dry.json()[text("other_model")].toBool());
    QVERIFY(!keysOf(dry.json()[text("writes")].toArray()).contains(text("max_voltage")));
    const QJsonArray alarms = dry.json()[text("alarms")].toArray();
    QCOMPARE(keysOf(alarms), QStringList{text("max_voltage")});
    QCOMPARE(alarms[0][text("alarm")].toString(), text("voltage"));
    QCOMPARE(alarms[0][text("selected")].toBool(true), false);
    const ProgramResult textOutput = run("snapshot restore 4 @a.servo.json --dry-run");
    QVERIFY2(textOutput.out.contains(
                 text("would cause a voltage alarm now: limit 8.0 V, present voltage 1")),
             qPrintable(textOutput.out));
    QVERIFY2(textOutput.out.contains(text("--only KEY --dangerous")), qPrintable(textOutput.out));

    (void)run("snapshot restore 4 @a.servo.json --dangerous");
    QCOMPARE(raw(4, "position_p"), 50);
    QCOMPARE(raw(4, "max_voltage"), before);
    (void)run("snapshot restore 4 @a.servo.json --only max_voltage");
    QCOMPARE(raw(4, "max_voltage"), before);
    const ProgramResult named =
        run("snapshot restore 4 @a.servo.json --only max_voltage --dangerous");
    QVERIFY2(named.out.contains(text("! max_voltage: would cause a voltage alarm now")),
             qPrintable(named.out));
    QCOMPARE(raw(4, "max_voltage"), 80);
}

void TestCliSnapshot::identityNeedsConsent()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("set-id 1 9").exit, 0);
    QCOMPARE(json("snapshot restore 9 @a.servo.json").json()[text("new_id")].toInt(), 9);
    const ProgramResult with = json("snapshot restore 9 @a.servo.json --identity");
    QVERIFY2(with.exit == 0, qPrintable(with.out + with.err));
    QCOMPARE(with.json()[text("new_id")].toInt(), 1);
    QCOMPARE(raw(1, "id"), 1);
    // An ID that is in use is not changed, and the result says so.
    const ProgramResult taken = json("snapshot restore 2 @a.servo.json --identity");
    QCOMPARE(taken.exit, 1);
    QCOMPARE(taken.json()[text("verdict")].toString(), text("failed"));
    QCOMPARE(taken.json()[text("results")][0][text("error")].toString(), text("id-in-use"));
}

void TestCliSnapshot::aFileHasLabelNoteAndCsv()
{
    QCOMPARE(m_cli
                 ->run({text("snapshot"), text("save"), text("1"), path("a.servo.json"),
                        text("--label"), text("left knee"), text("--note"), text("左膝, new")})
                 .exit,
             0);
    const ProgramResult shown = json("snapshot show @a.servo.json");
    QCOMPARE(shown.json()[text("label")].toString(), text("left knee"));
    QCOMPARE(shown.json()[text("note")].toString(), text("左膝, new"));
    QVERIFY(run("snapshot show @a.servo.json").out.contains(text("左膝, new")));
    const ProgramResult csv = run("snapshot show @a.servo.json --csv");
    QVERIFY(csv.out.startsWith(text("id,model,firmware,map,label,time,key,")));
    QCOMPARE(csv.out.count(u'\n'), shown.json()[text("registers")].toArray().size() + 1);
}

void TestCliSnapshot::factoryDefaultsAreAColumn()
{
    QCOMPARE(run("snapshot save 2 @b.servo.json").exit, 0);
    QCOMPARE(run("write 2 position_p=50").exit, 0);
    const ProgramResult diff = json("snapshot diff 2 @b.servo.json default 1");
    QVERIFY2(diff.exit == 0, qPrintable(diff.out + diff.err));
    const QJsonArray columns = diff.json()[text("columns")].toArray();
    QCOMPARE(columns.size(), 4);
    QCOMPARE(columns[2][text("source")].toString(), text("default"));
    const QJsonArray rows = diff.json()[text("rows")].toArray();
    QVERIFY(keysOf(rows).contains(text("position_p")));
    for (const QJsonValue& row : rows) {
        if (row[text("key")].toString() == text("max_voltage"))
            QCOMPARE(row[text("verdict")].toString(), text("unknown"));
    }
    const ProgramResult alone = json("snapshot diff @b.servo.json default");
    QCOMPARE(alone.exit, 0); // needs no servo
    const ProgramResult textOutput = run("snapshot diff 2 @b.servo.json");
    QVERIFY2(textOutput.out.contains(text("≠")) && textOutput.out.contains(text("1 different")),
             qPrintable(textOutput.out));
}

void TestCliSnapshot::templatesForSeveralServos()
{
    QCOMPARE(run("write 1 position_p=44 max_temperature=61").exit, 0);
    QCOMPARE(run("template make 1 @t.servo.json position_p max_temperature").exit, 0);
    QVERIFY(json("snapshot show @t.servo.json").json()[text("template")].toBool());
    QCOMPARE(run("template make 1 @i.servo.json id").exit, 2);
    QVERIFY(!QFile::exists(path("i.servo.json")));
    const ProgramResult dry = json("template apply @t.servo.json 1-3 --dry-run");
    QVERIFY2(dry.exit == 0, qPrintable(dry.out + dry.err));
    const QJsonArray planned = dry.json()[text("servos")].toArray();
    QCOMPARE(planned[0][text("verdict")].toString(), text("already-so"));
    QCOMPARE(planned[1][text("verdict")].toString(), text("planned"));
    QCOMPARE(raw(2, "position_p"), 32);
    const ProgramResult applied = json("template apply @t.servo.json 1,2,9 --result @r.json");
    QCOMPARE(applied.exit, 1); // one of them is missing
    const QJsonArray servos = applied.json()[text("servos")].toArray();
    QCOMPARE(servos[1][text("verdict")].toString(), text("done"));
    QCOMPARE(servos[2][text("verdict")].toString(), text("no-answer"));
    QCOMPARE(raw(2, "position_p"), 44);
    QVERIFY(QFile::exists(path("r.json")));
    QCOMPARE(run("template apply @t.servo.json 9").exit, 4);
    QCOMPARE(run("template apply @t.servo.json 1,2").exit, 0);
}

void TestCliSnapshot::skippedRowsAreReportedAndCounted()
{
    // Rows that the other family does not have: nothing is sent, and the result is not a success.
    QCOMPARE(run("template make 1 @t.servo.json speed_p protection_time overload_torque").exit, 0);
    const ProgramResult lacks = json("template apply @t.servo.json 3");
    QCOMPARE(lacks.exit, 1);
    const QJsonValue servo = lacks.json()[text("servos")].toArray().at(0);
    QCOMPARE(servo[text("verdict")].toString(), text("already-so"));
    const QJsonArray left = servo[text("left_out")].toArray();
    QVERIFY(!left.isEmpty());
    for (const QJsonValue& row : left)
        QVERIFY(row[text("asked")].toBool() && !row[text("reasons")].toArray().isEmpty());
    const ProgramResult textOutput = run("template apply @t.servo.json 3");
    QCOMPARE(textOutput.exit, 1);
    QVERIFY2(textOutput.out.contains(text("skipped: ")) &&
                 textOutput.out.contains(text("this servo has no such register")),
             qPrintable(textOutput.out));
    QVERIFY2(!(textOutput.out + textOutput.err).contains(text("already set")),
             qPrintable(textOutput.err));
    QCOMPARE(run("template apply @t.servo.json 3 --dry-run").exit, 0);
    QCOMPARE(run("template apply @t.servo.json 2").exit, 0);

    // Without consent: a remark for a whole snapshot, a failure for a register named with --only.
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_offset=40 --dangerous").exit, 0);
    const ProgramResult whole = run("snapshot restore 1 @a.servo.json");
    QCOMPARE(whole.exit, 0);
    QVERIFY2(whole.out.contains(text("1 row skipped: position_offset (")), qPrintable(whole.out));
    QVERIFY2(!(whole.out + whole.err).contains(text("already set")), qPrintable(whole.err));
    QCOMPARE(run("snapshot restore 1 @a.servo.json --only position_offset").exit, 1);
    QCOMPARE(run("snapshot restore 1 @a.servo.json --only position_offset --dangerous").exit, 0);
    const ProgramResult so = run("snapshot restore 1 @a.servo.json");
    QCOMPARE(so.exit, 0);
    QVERIFY2(!so.out.contains(text("skipped")), qPrintable(so.out));
    QVERIFY2((so.out + so.err).contains(text("already set")), qPrintable(so.err));
}

void TestCliSnapshot::bundlesAreRestoredById()
{
    const ProgramResult saved = json("bundle save @all.bundle.json");
    QVERIFY2(saved.exit == 0, qPrintable(saved.out + saved.err));
    QCOMPARE(saved.json()[text("servos")].toArray().size(), 3);
    QCOMPARE(run("write 2 position_p=50").exit, 0);
    QCOMPARE(run("write 3 position_p=20").exit, 0);
    const ProgramResult dry = json("bundle restore @all.bundle.json --dry-run");
    QCOMPARE(dry.exit, 0);
    QCOMPARE(raw(2, "position_p"), 50);
    const ProgramResult restored = json("bundle restore @all.bundle.json");
    QVERIFY2(restored.exit == 0, qPrintable(restored.out + restored.err));
    QStringList verdicts;
    for (const QJsonValue& servo : restored.json()[text("servos")].toArray())
        verdicts << servo[text("verdict")].toString();
    QCOMPARE(verdicts, (QStringList{text("already-so"), text("done"), text("done")}));
    QCOMPARE(raw(2, "position_p"), 32);
    // Only some registers, then a list without any.
    QCOMPARE(run("bundle save @two.bundle.json 1-2").exit, 0);
    QCOMPARE(run("bundle save @none.bundle.json 7").exit, 4);
    QVERIFY(!QFile::exists(path("none.bundle.json")));
}

void TestCliSnapshot::badFilesAreFileErrors_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("missing") << text("snapshot restore 1 @no.servo.json");
    QTest::newRow("broken") << text("snapshot restore 1 @broken.json");
    QTest::newRow("broken, for several") << text("template apply @broken.json 1,2");
    QTest::newRow("broken bundle") << text("bundle restore @broken.json");
    QTest::newRow("broken beside a servo") << text("snapshot diff @broken.json 1");
    QTest::newRow("no such folder") << text("bundle save @no/such/folder.json 1");
}

void TestCliSnapshot::badFilesAreFileErrors()
{
    QFETCH(const QString, line);
    QFile broken(path("broken.json"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\": \"servodesk-snapshot\", \"version\": 99}");
    broken.close();
    const ProgramResult programResult = run(qPrintable(line));
    QCOMPARE(programResult.exit, 5);
    QVERIFY(programResult.err.contains(text(".json")));
}

void TestCliSnapshot::badArgumentsAreUsageErrors_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("one table") << text("snapshot diff @a.servo.json");
    QTest::newRow("default alone") << text("snapshot diff default default");
    QTest::newRow("no such ID") << text("snapshot diff 999 @a.servo.json");
    QTest::newRow("unknown key") << text("snapshot restore 1 @a.servo.json --only positionp");
    QTest::newRow("no key") << text("snapshot restore 1 @a.servo.json --only ,");
    QTest::newRow("read-only row") << text("template make 1 @x.json present_position");
    QTest::newRow("no rows") << text("template make 1 @x.json");
    QTest::newRow("no servos") << text("template apply @a.servo.json");
}

void TestCliSnapshot::badArgumentsAreUsageErrors()
{
    QFETCH(const QString, line);
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    const ProgramResult programResult = run(qPrintable(line));
    QVERIFY2(programResult.exit == 2, qPrintable(programResult.out + programResult.err));
    QVERIFY(!QFile::exists(path("x.json")));
}

SERVODESK_GUILESS_TEST(TestCliSnapshot)
#include "tst_cli_snapshot.moc"

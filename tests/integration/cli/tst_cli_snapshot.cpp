// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, templates and bundles from the command line, as a user runs it: saved, compared,
// restored, written to others, with dry runs that write nothing and with their exit codes.
#include "support/cli_program.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QDir>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>

using support::CliProgram;
using support::ProgramResult;
using support::utf8;
using support::words;

namespace {
QStringList keysOf(const QJsonArray& rows)
{
    QStringList keys;
    for (const QJsonValue& row : rows)
        keys << row[utf8("key")].toString();
    return keys;
}
} // namespace

class TestCliSnapshot : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        m_cli = std::make_unique<CliProgram>();
        m_cli->setServos(utf8("sts3215@1,sts3215@2,scs15@3"));
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
    QString path(const char* name) const { return m_folder->filePath(utf8(name)); }
    ProgramResult run(const char* line)
    {
        return m_cli->run(QStringList(
            words(utf8(line).replace(utf8("@"), m_folder->path() + u'/').toUtf8().constData())));
    }
    ProgramResult json(const char* line) { return run(qPrintable(utf8(line) + utf8(" --json"))); }
    int raw(int id, const char* key)
    {
        const ProgramResult programResult =
            json(qPrintable(utf8("read %1 %2").arg(id).arg(utf8(key))));
        return programResult.json()[utf8("registers")].toArray().at(0)[utf8("raw")].toInt(-1);
    }
    int snapshots() const
    {
        return int(QDir(m_cli->dataFolder() + utf8("/snapshots"))
                       .entryList({utf8("*.servo.json")}, QDir::Files)
                       .size());
    }

    std::unique_ptr<CliProgram> m_cli;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCliSnapshot::saveChangeCompareRestore()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_p=50 min_angle_limit=300").exit, 0);
    const ProgramResult diff = json("snapshot diff 1 @a.servo.json");
    QCOMPARE(diff.exit, 0);
    QCOMPARE(diff.json()[utf8("different")].toInt(), 2);
    const QJsonArray rows = diff.json()[utf8("rows")].toArray();
    QCOMPARE(keysOf(rows).mid(0, 2), (QStringList{utf8("min_angle_limit"), utf8("position_p")}));
    QCOMPARE(rows[1][utf8("cells")][0][utf8("raw")].toInt(), 50);
    QCOMPARE(rows[1][utf8("cells")][1][utf8("raw")].toInt(), 32);

    const int before = snapshots();
    const ProgramResult restored = json("snapshot restore 1 @a.servo.json --result @r.csv");
    QVERIFY2(restored.exit == 0, qPrintable(restored.out + restored.err));
    QCOMPARE(restored.json()[utf8("verdict")].toString(), utf8("done"));
    QCOMPARE(keysOf(restored.json()[utf8("results")].toArray()),
             (QStringList{utf8("min_angle_limit"), utf8("position_p")}));
    QCOMPARE(restored.json()[utf8("lock")].toString(), utf8("closed"));
    const QString place = restored.json()[utf8("snapshot")].toString();
    QVERIFY2(QFile::exists(place), qPrintable(place));
    QVERIFY(snapshots() > before);
    QCOMPARE(raw(1, "position_p"), 32);
    QFile result(path("r.csv"));
    QVERIFY(result.open(QIODevice::ReadOnly));
    QCOMPARE(result.readAll().trimmed().count('\n'), 2);

    const ProgramResult again = json("snapshot restore 1 @a.servo.json");
    QCOMPARE(again.exit, 0);
    QCOMPARE(again.json()[utf8("verdict")].toString(), utf8("already-so"));
    QVERIFY(!again.json().contains(utf8("snapshot")));
    QCOMPARE(json("snapshot diff 1 @a.servo.json").json()[utf8("different")].toInt(-1), 0);
}

/// The table is saved before the first change, not before one that is refused.
void TestCliSnapshot::aRefusedWriteLeavesNone()
{
    const QDir saved(m_cli->dataFolder() + utf8("/snapshots"));
    const ProgramResult refused = m_cli->run("write 1 max_temperature=250");
    QVERIFY(refused.exit != 0);
    QCOMPARE(saved.entryList(QDir::Files), QStringList());
    QVERIFY2(refused.err.contains(utf8("deleted")), qPrintable(refused.err));
    QCOMPARE(m_cli->json("history --kind snapshots").json()[utf8("snapshots")].toArray().size(), 0);
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
    QCOMPARE(dry.json()[utf8("dry_run")].toBool(), true);
    QCOMPARE(keysOf(dry.json()[utf8("writes")].toArray()), QStringList{utf8("position_p")});
    QStringList steps;
    for (const QJsonValue& step : dry.json()[utf8("steps")].toArray())
        steps << step[utf8("step")].toString();
    QCOMPARE(steps, (QStringList{utf8("torque-off"), utf8("unlock"), utf8("write"), utf8("lock")}));
    QVERIFY(!dry.json().contains(utf8("verdict")));
    QCOMPARE(raw(1, "position_p"), 50);
    QCOMPARE(snapshots(), before);
    const ProgramResult textOutput = run("snapshot restore 1 @a.servo.json --dry-run");
    QVERIFY2(textOutput.out.contains(utf8("50")) && textOutput.out.contains(utf8("lock the EPROM")),
             qPrintable(textOutput.out));
}

void TestCliSnapshot::consentIsRequested()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_offset=40 --dangerous").exit, 0);
    const ProgramResult without = json("snapshot restore 1 @a.servo.json");
    QCOMPARE(without.exit, 0);
    const QJsonArray left = without.json()[utf8("left_out")].toArray();
    QCOMPARE(keysOf(left), QStringList{utf8("position_offset")});
    QVERIFY(left[0][utf8("reasons")].toArray().contains(utf8("needs-consent")));
    QVERIFY(left[0][utf8("reasons")].toArray().contains(utf8("moves-shaft")));
    QVERIFY(run("snapshot restore 1 @a.servo.json").out.contains(utf8("requires confirmation")));
    QCOMPARE(raw(1, "position_offset"), 40);
    QCOMPARE(run("snapshot restore 1 @a.servo.json --dangerous").exit, 0);
    QCOMPARE(raw(1, "position_offset"), 0);
}

/// A snapshot of an 8 V servo must not cause an alarm on a 12 V servo.
void TestCliSnapshot::limitsOfAnotherModelAreReported()
{
    m_cli->setServos(utf8("sts3215@1,sts3250@4"));
    QCOMPARE(run("write 1 max_voltage=80 position_p=50").exit, 0);
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    const int before = raw(4, "max_voltage");
    const ProgramResult dry = json("snapshot restore 4 @a.servo.json --dry-run --dangerous");
    QCOMPARE(dry.exit, 0);
    QVERIFY(dry.json()[utf8("other_model")].toBool());
    QVERIFY(!keysOf(dry.json()[utf8("writes")].toArray()).contains(utf8("max_voltage")));
    const QJsonArray alarms = dry.json()[utf8("alarms")].toArray();
    QCOMPARE(keysOf(alarms), QStringList{utf8("max_voltage")});
    QCOMPARE(alarms[0][utf8("alarm")].toString(), utf8("voltage"));
    QCOMPARE(alarms[0][utf8("selected")].toBool(true), false);
    const ProgramResult textOutput = run("snapshot restore 4 @a.servo.json --dry-run");
    QVERIFY2(textOutput.out.contains(
                 utf8("would cause a voltage alarm now: limit 8.0 V, present voltage 1")),
             qPrintable(textOutput.out));
    QVERIFY2(textOutput.out.contains(utf8("--only KEY --dangerous")), qPrintable(textOutput.out));

    (void)run("snapshot restore 4 @a.servo.json --dangerous");
    QCOMPARE(raw(4, "position_p"), 50);
    QCOMPARE(raw(4, "max_voltage"), before);
    (void)run("snapshot restore 4 @a.servo.json --only max_voltage");
    QCOMPARE(raw(4, "max_voltage"), before);
    const ProgramResult named =
        run("snapshot restore 4 @a.servo.json --only max_voltage --dangerous");
    QVERIFY2(named.out.contains(utf8("! max_voltage: would cause a voltage alarm now")),
             qPrintable(named.out));
    QCOMPARE(raw(4, "max_voltage"), 80);
}

void TestCliSnapshot::identityNeedsConsent()
{
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("set-id 1 9").exit, 0);
    QCOMPARE(json("snapshot restore 9 @a.servo.json").json()[utf8("new_id")].toInt(), 9);
    const ProgramResult with = json("snapshot restore 9 @a.servo.json --identity");
    QVERIFY2(with.exit == 0, qPrintable(with.out + with.err));
    QCOMPARE(with.json()[utf8("new_id")].toInt(), 1);
    QCOMPARE(raw(1, "id"), 1);
    // An ID that is in use is not changed, and the result says so.
    const ProgramResult taken = json("snapshot restore 2 @a.servo.json --identity");
    QCOMPARE(taken.exit, 1);
    QCOMPARE(taken.json()[utf8("verdict")].toString(), utf8("failed"));
    QCOMPARE(taken.json()[utf8("results")][0][utf8("error")][utf8("code")].toString(),
             utf8("id-in-use"));
}

void TestCliSnapshot::aFileHasLabelNoteAndCsv()
{
    QCOMPARE(m_cli
                 ->run({utf8("snapshot"), utf8("save"), utf8("1"), path("a.servo.json"),
                        utf8("--label"), utf8("left knee"), utf8("--note"), utf8("左膝, new")})
                 .exit,
             0);
    const ProgramResult shown = json("snapshot show @a.servo.json");
    QCOMPARE(shown.json()[utf8("label")].toString(), utf8("left knee"));
    QCOMPARE(shown.json()[utf8("note")].toString(), utf8("左膝, new"));
    QVERIFY(run("snapshot show @a.servo.json").out.contains(utf8("左膝, new")));
    const ProgramResult csv = run("snapshot show @a.servo.json --csv");
    QVERIFY(csv.out.startsWith(utf8("id,model,firmware,map,label,time,key,")));
    QCOMPARE(csv.out.count(u'\n'), shown.json()[utf8("registers")].toArray().size() + 1);
}

void TestCliSnapshot::factoryDefaultsAreAColumn()
{
    QCOMPARE(run("snapshot save 2 @b.servo.json").exit, 0);
    QCOMPARE(run("write 2 position_p=50").exit, 0);
    const ProgramResult diff = json("snapshot diff 2 @b.servo.json default 1");
    QVERIFY2(diff.exit == 0, qPrintable(diff.out + diff.err));
    const QJsonArray columns = diff.json()[utf8("columns")].toArray();
    QCOMPARE(columns.size(), 4);
    QCOMPARE(columns[2][utf8("source")].toString(), utf8("default"));
    const QJsonArray rows = diff.json()[utf8("rows")].toArray();
    QVERIFY(keysOf(rows).contains(utf8("position_p")));
    for (const QJsonValue& row : rows) {
        if (row[utf8("key")].toString() == utf8("max_voltage"))
            QCOMPARE(row[utf8("verdict")].toString(), utf8("unknown"));
    }
    const ProgramResult alone = json("snapshot diff @b.servo.json default");
    QCOMPARE(alone.exit, 0); // needs no servo
    const ProgramResult textOutput = run("snapshot diff 2 @b.servo.json");
    QVERIFY2(textOutput.out.contains(utf8("≠")) && textOutput.out.contains(utf8("1 different")),
             qPrintable(textOutput.out));
}

void TestCliSnapshot::templatesForSeveralServos()
{
    QCOMPARE(run("write 1 position_p=44 max_temperature=61").exit, 0);
    QCOMPARE(run("template make 1 @t.servo.json position_p max_temperature").exit, 0);
    QVERIFY(json("snapshot show @t.servo.json").json()[utf8("template")].toBool());
    QCOMPARE(run("template make 1 @i.servo.json id").exit, 2);
    QVERIFY(!QFile::exists(path("i.servo.json")));
    const ProgramResult dry = json("template apply @t.servo.json 1-3 --dry-run");
    QVERIFY2(dry.exit == 0, qPrintable(dry.out + dry.err));
    const QJsonArray planned = dry.json()[utf8("servos")].toArray();
    QCOMPARE(planned[0][utf8("verdict")].toString(), utf8("already-so"));
    QCOMPARE(planned[1][utf8("verdict")].toString(), utf8("planned"));
    QCOMPARE(raw(2, "position_p"), 32);
    const ProgramResult applied = json("template apply @t.servo.json 1,2,9 --result @r.json");
    QCOMPARE(applied.exit, 1); // one of them is missing
    const QJsonArray servos = applied.json()[utf8("servos")].toArray();
    QCOMPARE(servos[1][utf8("verdict")].toString(), utf8("done"));
    QCOMPARE(servos[2][utf8("verdict")].toString(), utf8("no-answer"));
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
    const QJsonValue servo = lacks.json()[utf8("servos")].toArray().at(0);
    QCOMPARE(servo[utf8("verdict")].toString(), utf8("already-so"));
    const QJsonArray left = servo[utf8("left_out")].toArray();
    QVERIFY(!left.isEmpty());
    for (const QJsonValue& row : left)
        QVERIFY(row[utf8("asked")].toBool() && !row[utf8("reasons")].toArray().isEmpty());
    const ProgramResult textOutput = run("template apply @t.servo.json 3");
    QCOMPARE(textOutput.exit, 1);
    QVERIFY2(textOutput.out.contains(utf8("skipped: ")) &&
                 textOutput.out.contains(utf8("this servo has no such register")),
             qPrintable(textOutput.out));
    QVERIFY2(!(textOutput.out + textOutput.err).contains(utf8("already set")),
             qPrintable(textOutput.err));
    QCOMPARE(run("template apply @t.servo.json 3 --dry-run").exit, 0);
    QCOMPARE(run("template apply @t.servo.json 2").exit, 0);

    // Without consent: a remark for a whole snapshot, a failure for a register named with --only.
    QCOMPARE(run("snapshot save 1 @a.servo.json").exit, 0);
    QCOMPARE(run("write 1 position_offset=40 --dangerous").exit, 0);
    const ProgramResult whole = run("snapshot restore 1 @a.servo.json");
    QCOMPARE(whole.exit, 0);
    QVERIFY2(whole.out.contains(utf8("1 row skipped: position_offset (")), qPrintable(whole.out));
    QVERIFY2(!(whole.out + whole.err).contains(utf8("already set")), qPrintable(whole.err));
    QCOMPARE(run("snapshot restore 1 @a.servo.json --only position_offset").exit, 1);
    QCOMPARE(run("snapshot restore 1 @a.servo.json --only position_offset --dangerous").exit, 0);
    const ProgramResult so = run("snapshot restore 1 @a.servo.json");
    QCOMPARE(so.exit, 0);
    QVERIFY2(!so.out.contains(utf8("skipped")), qPrintable(so.out));
    QVERIFY2((so.out + so.err).contains(utf8("already set")), qPrintable(so.err));
}

void TestCliSnapshot::bundlesAreRestoredById()
{
    const ProgramResult saved = json("bundle save @all.bundle.json");
    QVERIFY2(saved.exit == 0, qPrintable(saved.out + saved.err));
    QCOMPARE(saved.json()[utf8("servos")].toArray().size(), 3);
    QCOMPARE(run("write 2 position_p=50").exit, 0);
    QCOMPARE(run("write 3 position_p=20").exit, 0);
    const ProgramResult dry = json("bundle restore @all.bundle.json --dry-run");
    QCOMPARE(dry.exit, 0);
    QCOMPARE(raw(2, "position_p"), 50);
    const ProgramResult restored = json("bundle restore @all.bundle.json");
    QVERIFY2(restored.exit == 0, qPrintable(restored.out + restored.err));
    QStringList verdicts;
    for (const QJsonValue& servo : restored.json()[utf8("servos")].toArray())
        verdicts << servo[utf8("verdict")].toString();
    QCOMPARE(verdicts, (QStringList{utf8("already-so"), utf8("done"), utf8("done")}));
    QCOMPARE(raw(2, "position_p"), 32);
    // Only some registers, then a list without any.
    QCOMPARE(run("bundle save @two.bundle.json 1-2").exit, 0);
    QCOMPARE(run("bundle save @none.bundle.json 7").exit, 4);
    QVERIFY(!QFile::exists(path("none.bundle.json")));
}

void TestCliSnapshot::badFilesAreFileErrors_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("missing") << utf8("snapshot restore 1 @no.servo.json");
    QTest::newRow("broken") << utf8("snapshot restore 1 @broken.json");
    QTest::newRow("broken, for several") << utf8("template apply @broken.json 1,2");
    QTest::newRow("broken bundle") << utf8("bundle restore @broken.json");
    QTest::newRow("broken beside a servo") << utf8("snapshot diff @broken.json 1");
    QTest::newRow("no such folder") << utf8("bundle save @no/such/folder.json 1");
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
    QVERIFY(programResult.err.contains(utf8(".json")));
}

void TestCliSnapshot::badArgumentsAreUsageErrors_data()
{
    QTest::addColumn<QString>("line");
    QTest::newRow("one table") << utf8("snapshot diff @a.servo.json");
    QTest::newRow("default alone") << utf8("snapshot diff default default");
    QTest::newRow("no such ID") << utf8("snapshot diff 999 @a.servo.json");
    QTest::newRow("unknown key") << utf8("snapshot restore 1 @a.servo.json --only positionp");
    QTest::newRow("no key") << utf8("snapshot restore 1 @a.servo.json --only ,");
    QTest::newRow("read-only row") << utf8("template make 1 @x.json present_position");
    QTest::newRow("no rows") << utf8("template make 1 @x.json");
    QTest::newRow("no servos") << utf8("template apply @a.servo.json");
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

// SPDX-License-Identifier: GPL-3.0-or-later
// What happened to servos, in the history: found by servo, time and register, page by page; told
// apart by label, since servos carry no serial number; as a table of any moment; as changes for a
// copy; as files. A database of the first schema is brought up to date with all its runs.
#include "catalog/catalog.h"
#include "history/history.h"
#include "history/history_changes.h"
#include "history/history_export.h"
#include "history/history_file.h"
#include "history/history_journal.h"
#include "history/history_table.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "support/text.h"
#include "unit/history/intent_example.h"
#include "unit/results/sweep_example.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <thread>

using base::IntentKind;
using history::ChangedRow;
using history::HistoryFilter;
using history::HistoryWrite;
using history::SnapshotReason;
using intent_example::exampleServo;
using support::utf8;
using namespace std::chrono_literals;

namespace {
const QString programName = QStringLiteral("servodesk test");

snapshot::Snapshot snapshotOf(int id, std::int64_t p = 32, std::int64_t minimum = 0)
{
    using catalog::Access;
    using catalog::Area;
    snapshot::Snapshot snapshot;
    snapshot.program = programName;
    snapshot.at = QDateTime::currentDateTimeUtc();
    snapshot.port = utf8("/dev/ttyUSB0");
    snapshot.baud = 1000000;
    snapshot.servo = {id,           utf8("STS3215"), utf8("9.3"),
                      utf8("3.10"), utf8("sts-sms"), utf8("feetech")};
    snapshot.registers = {
        {utf8("id"), 5, id, double(id), {}, Area::Eprom, Access::ReadWrite},
        {utf8("min_angle_limit"), 9, minimum, 360.0 * double(minimum) / 4096, utf8("deg"),
         Area::Eprom, Access::ReadWrite},
        {utf8("position_p"), 21, p, double(p), {}, Area::Eprom, Access::ReadWrite},
        {utf8("position_offset"), 31, 85, 7.47, utf8("deg"), Area::Eprom, Access::ReadWrite},
        {utf8("present_voltage"), 62, 120, 12.0, utf8("V"), Area::Feedback, Access::ReadOnly}};
    return snapshot;
}

base::Intent intentOf(int id, const char* key, std::int64_t from, std::int64_t to,
                      IntentKind kind = IntentKind::Write)
{
    base::Intent intent;
    intent.kind = kind;
    intent.servo = exampleServo(id);
    intent.servo.model = utf8("STS3215");
    intent.items = {{utf8(key), 21, from, to}};
    return intent;
}

std::vector<std::int64_t> newValues(const std::vector<HistoryWrite>& writes)
{
    std::vector<std::int64_t> values;
    for (const HistoryWrite& write : writes)
        values.push_back(write.newRaw.value());
    return values;
}
using Values = std::vector<std::int64_t>;

const snapshot::SnapshotRegister& rowOf(const snapshot::Snapshot& table, const char* key)
{
    return *std::find_if(table.registers.begin(), table.registers.end(),
                         [&](const auto& row) { return row.key == utf8(key); });
}

/// A servo whose table was saved once, and what the history says of it at a moment.
struct ServoHistoryFixture {
    explicit ServoHistoryFixture(std::unique_ptr<history::History> opened)
        : history(std::move(opened))
        , log(history->log())
    {
        log.addSnapshot(snapshotOf(1), SnapshotReason::Automatic).value();
        number = log.of(exampleServo(1)).value()->number;
    }
    auto at(const QDateTime& when) const
    {
        return history::tableAt(history->file(), catalog, number, when).value();
    }

    const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    const std::unique_ptr<history::History> history;
    const history::HistoryLog log;
    qint64 number = 0;
};
} // namespace

class TestHistoryLog : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<history::History> open() const
    {
        auto history = history::History::open(m_path);
        return history ? std::move(*history) : nullptr;
    }
    /// A write that ended like this.
    void write(int id, const char* key, std::int64_t from, std::int64_t to,
               const char* outcome = "kept", IntentKind kind = IntentKind::Write)
    {
        history::HistoryJournal journal(m_path, programName);
        const QString uuid = journal.begin(intentOf(id, key, from, to, kind)).value();
        const bool good = qstrcmp(outcome, "kept") == 0;
        QVERIFY(journal.end(uuid, {good ? utf8("done") : utf8("failed"),
                                   {},
                                   {{utf8(key), good ? to : from, utf8(outcome)}}}));
    }
    /// So that what follows is later.
    static QDateTime pass()
    {
        const QDateTime now = QDateTime::currentDateTimeUtc();
        [&] { QTRY_VERIFY(QDateTime::currentDateTimeUtc() > now.addMSecs(1)); }();
        return now.addMSecs(1);
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    QString m_path;

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(utf8(".*")));
        m_dir = std::make_unique<QTemporaryDir>();
        m_path = m_dir->filePath(utf8("history.sqlite"));
    }

    void writesAreFound();
    void servoChosenValuesAreThoseRead();
    void pagesAreContiguous();
    void aServoIsIdentifiedByItsLabel();
    void theLabelFollowsTheNewId();
    void simulatedServosAreSeparate();
    void snapshotsRoundTrip();
    void alarmsAreRaisedAndCleared();
    void recordingsAreFound();
    void stepRunsAreStored();
    void theTableAtAnyTime();
    void unrecordedRegistersHaveNoValue();
    void pastEntriesAreUnchanged();
    void missingRegistersAreReported();
    void aServoBackAtItsIdKeepsItsHistory();
    void changesForACopy();
    void concurrentChangesAreCopied();
    void exportedAsCsv();
    void exportedAsJson();
    void theFirstSchemaIsMigrated();
    void aMigrationThatFailsChangesNothing();
};

void TestHistoryLog::writesAreFound()
{
    write(1, "position_p", 32, 1);
    write(2, "position_p", 32, 2);
    write(1, "min_angle_limit", 0, 3);
    const QDateTime middle = pass();
    write(1, "position_p", 1, 4, "mismatch");
    const auto history = open();
    const auto log = history->log();
    QCOMPARE(newValues(log.writes().value()), (Values{4, 3, 2, 1}));
    HistoryFilter one;
    one.id = 1;
    QCOMPARE(newValues(log.writes(one).value()), (Values{4, 3, 1}));
    one.key = utf8("position_p");
    QCOMPARE(newValues(log.writes(one).value()), (Values{4, 1}));
    one.until = middle;
    QCOMPARE(newValues(log.writes(one).value()), (Values{1}));
    HistoryFilter late;
    late.from = middle;
    QCOMPARE(newValues(log.writes(late).value()), (Values{4}));
    HistoryFilter trouble;
    trouble.onlyProblems = true;
    QCOMPARE(newValues(log.writes(trouble).value()), (Values{4}));
    HistoryFilter model;
    model.model = utf8("sts3215");
    QCOMPARE(log.countWrites(model).value(), 4);
    model.model = utf8("SCS15");
    QVERIFY(log.writes(model).value().empty());
    QCOMPARE(log.writtenKeys().value(), QStringList({utf8("min_angle_limit"), utf8("position_p")}));
    const auto two = log.of(exampleServo(2)).value();
    QVERIFY(two);
    QCOMPARE(log.writtenKeys(two->number).value(), QStringList{utf8("position_p")});
    QCOMPARE(two->identity.port, utf8("/dev/ttyUSB0"));
    QVERIFY(two->lastWrite.isValid());
    QVERIFY(!log.of(exampleServo(9)).value());
    QCOMPARE(log.write(3).value().key, utf8("min_angle_limit"));
    QCOMPARE(int(log.write(99).error().code), int(base::ErrorCode::BadArgument));
}

/// Whatever the filter: all pages together are the list, each row once.
void TestHistoryLog::servoChosenValuesAreThoseRead()
{
    history::HistoryJournal journal(m_path, programName);
    const auto end = [&](std::int64_t old, IntentKind kind, std::optional<std::int64_t> readBack) {
        const char* key = kind == IntentKind::Calibrate ? "position_offset" : "position_p";
        const QString uuid = journal.begin(intentOf(1, key, old, old, kind)).value();
        base::IntentResult done{utf8("done"), {}, {}};
        if (readBack)
            done.items = {{utf8(key), readBack, utf8("done")}};
        QVERIFY(journal.end(uuid, done));
    };
    end(0, IntentKind::Calibrate, -549);
    pass();
    end(60, IntentKind::Restore, 32);
    pass();
    end(60, IntentKind::Restore, {}); // by an earlier version
    const auto writes = open()->log().writes().value();
    QCOMPARE(writes.size(), std::size_t(3));
    QVERIFY(!writes[0].newRaw && writes[0].ownDefaults);
    QCOMPARE(writes[1].newRaw, std::optional<std::int64_t>(32));
    QVERIFY(writes[1].ownDefaults);
    QCOMPARE(writes[2].newRaw, std::optional<std::int64_t>(-549));
    QCOMPARE(writes[2].oldRaw, 0);
}

void TestHistoryLog::pagesAreContiguous()
{
    for (int i = 0; i < 25; ++i)
        write(1 + i % 3, i % 2 == 0 ? "position_p" : "min_angle_limit", 0, i);
    const auto history = open();
    HistoryFilter all;
    HistoryFilter two;
    two.id = 2;
    HistoryFilter model;
    model.model = utf8("STS3215");
    model.key = utf8("min_angle_limit");
    for (HistoryFilter filter : {all, two, model}) {
        const auto whole = newValues(history->log().writes(filter).value());
        Values joined;
        filter.limit = 4;
        for (;;) {
            const auto page = history->log().writes(filter).value();
            if (page.empty())
                break;
            QVERIFY(page.size() <= 4);
            for (const std::int64_t value : newValues(page))
                joined.push_back(value);
            filter.after = history::PageCursor{page.back().at, page.back().number};
        }
        QCOMPARE(joined, whole);
    }
}

void TestHistoryLog::aServoIsIdentifiedByItsLabel()
{
    history::HistoryJournal journal(m_path, programName);
    const QString limits = utf8("limits");
    write(1, "position_p", 32, 1);
    QVERIFY(journal.saveServoValues(exampleServo(1), limits, {5, 6}));
    const auto history = open();
    const auto log = history->log();
    const auto left = log.of(exampleServo(1)).value().value();
    QVERIFY(left.label.isEmpty());
    QVERIFY(log.setLabel(left.number, utf8("left")));

    // Another of the kind is plugged in under the same ID, and the user says so.
    const auto right = log.assignToOther(left.number, utf8("right")).value();
    QVERIFY(right.number != left.number);
    write(1, "position_p", 32, 2);
    HistoryFilter filter;
    filter.servo = right.number;
    QCOMPARE(newValues(log.writes(filter).value()), (Values{2}));
    filter.servo = left.number;
    QCOMPARE(newValues(log.writes(filter).value()), (Values{1}));
    QVERIFY(!journal.servoValues(exampleServo(1), limits).value()); // the limits of the other one
    QCOMPARE(journal.entriesFor(exampleServo(1), 10).value().size(), std::size_t(1));

    // The first one again.
    QCOMPARE(log.assignToOther(right.number, utf8("left")).value().number, left.number);
    QCOMPARE(log.of(exampleServo(1)).value()->label, utf8("left"));
    QVERIFY(journal.servoValues(exampleServo(1), limits).value());
    QCOMPARE(log.setLabel(left.number, utf8("right")).error().detail, utf8("label-in-use"));
    QVERIFY(log.setLabel(left.number, utf8("left")));
    QCOMPARE(int(log.setLabel(99, utf8("x")).error().code), int(base::ErrorCode::BadArgument));
    HistoryFilter named;
    named.label = utf8("right");
    QCOMPARE(log.servos(named).value().size(), std::size_t(1));
}

void TestHistoryLog::theLabelFollowsTheNewId()
{
    const auto history = open();
    const auto log = history->log();
    const auto before = log.findOrAdd(exampleServo(1)).value();
    QVERIFY(log.setLabel(before.number, utf8("wrist")));
    write(1, "id", 1, 7, "kept", IntentKind::SetId);
    QCOMPARE(log.of(exampleServo(7)).value()->label, utf8("wrist"));
    write(7, "id", 7, 9, "mismatch", IntentKind::SetId);
    QVERIFY(!log.of(exampleServo(9)).value());
}

void TestHistoryLog::simulatedServosAreSeparate()
{
    const QString limits = utf8("limits");
    base::ServoIdentity played = exampleServo(1);
    played.port = utf8("sim:demo");
    history::HistoryJournal journal(m_path, programName);
    QVERIFY(journal.saveServoValues(played, limits, {1, 2}));
    QVERIFY(!journal.servoValues(exampleServo(1), limits).value());
    base::Intent intent = intentOf(1, "position_p", 32, 40);
    intent.servo = played;
    journal.begin(intent).value();
    QVERIFY(journal.entriesFor(exampleServo(1), 10).value().empty());
    write(1, "position_p", 32, 41);
    const auto history = open();
    const auto log = history->log();
    const auto one = log.of(played).value().value();
    const auto other = log.of(exampleServo(1)).value().value();
    QVERIFY(one.number != other.number);
    QVERIFY(log.setLabel(one.number, utf8("same")));
    QVERIFY(log.setLabel(other.number, utf8("same")));
    snapshot::Snapshot snapshot = snapshotOf(1);
    snapshot.port = utf8("sim:demo");
    log.addSnapshot(snapshot, SnapshotReason::Automatic).value();
    const auto catalog = catalog::Catalog::load().catalog;
    QVERIFY(history::tableAt(history->file(), catalog, one.number, pass()));
    QVERIFY(!history::tableAt(history->file(), catalog, other.number, pass()));
    QVERIFY(log.assignToOther(one.number, utf8("new")));
    QCOMPARE(log.of(played).value()->label, utf8("new"));
    QCOMPARE(log.of(exampleServo(1)).value()->label, utf8("same"));
}

void TestHistoryLog::snapshotsRoundTrip()
{
    const auto history = open();
    const auto log = history->log();
    snapshot::Snapshot snapshot = snapshotOf(1);
    snapshot.note = utf8("before the repair\n左膝");
    const auto number =
        log.addSnapshot(snapshot, SnapshotReason::Automatic, utf8("/tmp/a.servo.json")).value();
    log.addSnapshot(snapshotOf(2), SnapshotReason::Manual).value();
    QCOMPARE(snapshot::encodeSnapshot(log.snapshot(number).value()),
             snapshot::encodeSnapshot(snapshot));
    HistoryFilter one;
    one.id = 1;
    const auto rows = log.snapshots(one).value();
    QCOMPARE(rows.size(), std::size_t(1));
    QCOMPARE(rows[0].model, utf8("STS3215"));
    QCOMPARE(rows[0].firmware, utf8("3.10"));
    QCOMPARE(int(rows[0].reason), int(SnapshotReason::Automatic));
    QCOMPARE(rows[0].file, utf8("/tmp/a.servo.json"));
    QCOMPARE(rows[0].registers, 5);
    HistoryFilter asked;
    asked.reason = SnapshotReason::Manual;
    QCOMPARE(log.snapshots(asked).value().size(), std::size_t(1));
    QVERIFY(log.setSnapshotNote(number, utf8("knee"), utf8("good")));
    QCOMPARE(log.snapshot(number)->label, utf8("knee"));
    QCOMPARE(log.snapshotRow(number)->note, utf8("good"));
    // The same servo to the journal and to a snapshot.
    write(1, "position_p", 32, 1);
    QCOMPARE(log.servos().value().size(), std::size_t(2));
    QVERIFY(log.removeSnapshot(number));
    QVERIFY(!log.removeSnapshot(number));
    QVERIFY(!log.snapshot(number));
}

void TestHistoryLog::alarmsAreRaisedAndCleared()
{
    const auto history = open();
    const auto log = history->log();
    const QDateTime at = QDateTime::currentDateTimeUtc();
    const QString overload = utf8("overload");
    QVERIFY(log.recordAlarmStart(exampleServo(1), overload, false, at));
    QVERIFY(log.recordAlarmStart(exampleServo(1), overload, false, at.addSecs(1))); // still there
    QVERIFY(log.recordAlarmStart(exampleServo(2), overload, true, at.addSecs(2)));
    QVERIFY(log.recordAlarmEnd(exampleServo(1), overload, at.addSecs(5)));
    QVERIFY(log.recordAlarmEnd(exampleServo(1), overload, at.addSecs(6))); // gone already
    const auto alarms = log.alarms().value();
    QCOMPARE(alarms.size(), std::size_t(2));
    QCOMPARE(alarms[1].at.toMSecsSinceEpoch(), at.toMSecsSinceEpoch());
    QCOMPARE(alarms[1].clearedAt.toMSecsSinceEpoch(), at.addSecs(5).toMSecsSinceEpoch());
    QVERIFY(alarms[0].derived);
    HistoryFilter open;
    open.onlyProblems = true;
    QCOMPARE(log.alarms(open).value().size(), std::size_t(1));
    QVERIFY(log.recordAlarmStart(exampleServo(1), overload, false, at.addSecs(9)));
    QCOMPARE(log.alarms().value().size(), std::size_t(3));
}

void TestHistoryLog::recordingsAreFound()
{
    const auto history = open();
    const auto log = history->log();
    history::HistoryRecording recording;
    recording.at = QDateTime::currentDateTimeUtc();
    recording.length = 90s;
    recording.file = utf8("/tmp/运行.csv");
    recording.rows = 18000;
    const auto number = log.addRecording(recording, {exampleServo(1), exampleServo(2)}).value();
    recording.at = recording.at.addSecs(1);
    log.addRecording(recording, {exampleServo(2)}).value();
    HistoryFilter one;
    one.id = 1;
    const auto found = log.recordings(one).value();
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].length, base::Duration(90s));
    QCOMPARE(found[0].servos.size(), std::size_t(2));
    QCOMPARE(found[0].servos[1].id, 2);
    QVERIFY(log.removeRecording(number));
    QCOMPARE(log.recordings().value().size(), std::size_t(1));
}

void TestHistoryLog::stepRunsAreStored()
{
    results::StepRun run;
    run.program = programName;
    run.at = QDateTime({2026, 1, 2}, {3, 4, 5}, Qt::UTC);
    run.port = utf8("sim:demo");
    run.simulated = true;
    run.parameters = snapshotOf(3);
    run.spec.note = utf8("stiff");
    results::StepResponse response;
    response.number = 1;
    response.samples = {{0us, 100.0, {}, {}, {}}, {500ms, 300.0, {}, {}, {}}};
    run.responses = {response};
    const history::SavedRun kept = history::saveRun(m_path, run);
    QVERIFY(!kept.trouble);
    const auto history = open();
    history::RunFilter steps;
    steps.kind = utf8("step");
    const auto heads = history->runs(steps).value();
    QCOMPARE(heads.size(), std::size_t(1));
    QCOMPARE(heads[0].servos[0].id, 3);
    QCOMPARE(heads[0].length, base::Duration(500ms));
    QCOMPARE(heads[0].note, utf8("stiff"));
    QVERIFY(history->setNote(kept.number, utf8("soft")));
    const auto back = history->step(kept.number).value();
    QCOMPARE(back.spec.note, utf8("soft"));
    QVERIFY(back.responses == run.responses);
    QVERIFY(!history->sweep(kept.number));
}

void TestHistoryLog::theTableAtAnyTime()
{
    const auto catalog = catalog::Catalog::load().catalog;
    const auto history = open();
    const auto log = history->log();
    log.addSnapshot(snapshotOf(1), SnapshotReason::Automatic).value();
    const QDateTime atFirst = pass();
    write(1, "position_p", 32, 40);
    write(1, "min_angle_limit", 0, 1024);
    const QDateTime afterTwo = pass();
    write(1, "position_p", 40, 50, "temporary");
    write(1, "min_angle_limit", 1024, 99, "refused");
    write(2, "position_p", 1, 2);
    const QDateTime afterMore = pass();
    log.addSnapshot(snapshotOf(1, 77), SnapshotReason::Manual).value();
    const QDateTime atLast = pass();
    const auto servo = log.of(exampleServo(1)).value()->number;
    const auto at = [&](const QDateTime& when) {
        return history::tableAt(history->file(), catalog, servo, when);
    };
    QCOMPARE(at(atFirst.addDays(-1)).error().detail, utf8("no-snapshot"));
    QVERIFY(at(atFirst)->replayed.isEmpty());
    QCOMPARE(rowOf(at(atFirst)->table, "position_p").raw, std::int64_t(32));
    const auto two = at(afterTwo).value();
    QCOMPARE(two.replayed, QStringList({utf8("position_p"), utf8("min_angle_limit")}));
    QCOMPARE(rowOf(two.table, "position_p").raw, std::int64_t(40));
    QCOMPARE(rowOf(two.table, "min_angle_limit").raw, std::int64_t(1024));
    QCOMPARE(rowOf(two.table, "min_angle_limit").value.value_or(-1), 90.0); // in its unit
    QVERIFY(two.unknown.isEmpty());
    const auto more =
        at(afterMore).value(); // temporary and refused ones changed nothing that stays
    QCOMPARE(rowOf(more.table, "position_p").raw, std::int64_t(40));
    QCOMPARE(rowOf(more.table, "min_angle_limit").raw, std::int64_t(1024));
    QVERIFY(more.unknown.isEmpty());
    QCOMPARE(rowOf(at(atLast)->table, "position_p").raw, std::int64_t(77));
}

void TestHistoryLog::unrecordedRegistersHaveNoValue()
{
    const ServoHistoryFixture past(open());
    const auto now = [&] { return past.at(pass()); };
    history::HistoryJournal journal(m_path, programName);
    const QString cut = journal.begin(intentOf(1, "position_p", 32, 40)).value();
    QCOMPARE(now().unknown, QStringList{utf8("position_p")});
    QVERIFY(!rowOf(now().table, "position_p").raw);
    QVERIFY(journal.end(cut, {utf8("undone"), {}}));
    QCOMPARE(rowOf(now().table, "position_p").raw, std::int64_t(32));
    write(1, "position_offset", 85, 85, "kept", IntentKind::Calibrate);
    QCOMPARE(now().unknown, QStringList{utf8("position_offset")});
    write(1, "position_offset", 12, 20); // written since: known again
    QCOMPARE(rowOf(now().table, "position_offset").raw, std::int64_t(20));
    write(1, "position_p", 32, 48, "kept",
          IntentKind::Restore); // of a snapshot: every row is known
    QCOMPARE(rowOf(now().table, "position_p").raw, std::int64_t(48));
    QVERIFY(now().unknown.isEmpty());
    write(1, "position_p", 48, 48, "kept", IntentKind::Restore); // what it had stored itself
    const auto restored = now();
    for (const char* key : {"id", "min_angle_limit", "position_p", "position_offset"})
        QVERIFY(restored.unknown.contains(utf8(key)));
    QVERIFY(rowOf(restored.table, "present_voltage").raw); // as it was read
}

/// What a moment says does not change with what is done later.
void TestHistoryLog::pastEntriesAreUnchanged()
{
    const ServoHistoryFixture past(open());
    const auto at = [&](const QDateTime& when) { return past.at(when); };
    history::HistoryJournal journal(m_path, programName);
    pass();
    const QString cut = journal.begin(intentOf(1, "position_p", 32, 90)).value();
    const QDateTime open = pass();
    const QString forgotten = journal.begin(intentOf(1, "min_angle_limit", 0, 9)).value();
    pass();
    past.log.addSnapshot(snapshotOf(1, 90), SnapshotReason::Manual).value();
    const QDateTime read = pass();
    QVERIFY(journal.end(cut, {utf8("undone"), {}}));
    QVERIFY(journal.end(forgotten, {utf8("abandoned"), {}}));
    const QDateTime after = pass();
    QCOMPARE(at(open).unknown, QStringList{utf8("position_p")});
    QVERIFY(at(open).replayed.isEmpty());
    QCOMPARE(rowOf(at(read).table, "position_p").raw, std::int64_t(90)); // as it was read
    QCOMPARE(rowOf(at(after).table, "position_p").raw, std::int64_t(32));
    // What a later write has replaced is not put back.
    const QString old = journal.begin(intentOf(1, "position_p", 32, 40)).value();
    pass();
    write(1, "position_p", 40, 50);
    QVERIFY(journal.end(old, {utf8("undone"), {}}));
    QCOMPARE(rowOf(at(pass()).table, "position_p").raw, std::int64_t(50));
    QVERIFY(at(after).unknown.isEmpty()); // given up after it was read: nothing was written
}

void TestHistoryLog::missingRegistersAreReported()
{
    const ServoHistoryFixture past(open());
    const auto now = [&] { return past.at(pass()); };
    history::HistoryJournal journal(m_path, programName);
    base::Intent trial = intentOf(1, "position_p", 32, 50, IntentKind::Trial);
    trial.temporary = true;
    QVERIFY(journal.end(journal.begin(trial).value(),
                        {utf8("failed"), {}, {{utf8("position_p"), {}, utf8("not-sent")}}}));
    QVERIFY(now().temporary.isEmpty());
    write(1, "position_p", 32, 50, "temporary");
    QCOMPARE(now().temporary, QStringList{utf8("position_p")});
    QVERIFY(!now().changedId);
    write(1, "position_p", 32, 60);
    QVERIFY(now().temporary.isEmpty());
    write(1, "id", 1, 7, "kept", IntentKind::SetId);
    QVERIFY(now().changedId.has_value());
    QCOMPARE(now().changedId->id, 7);
    QCOMPARE(rowOf(now().table, "id").raw, std::int64_t(7));
}

void TestHistoryLog::aServoBackAtItsIdKeepsItsHistory()
{
    const ServoHistoryFixture past(open());
    const auto at = [&](const QDateTime& when) { return past.at(when); };
    pass();
    write(5, "position_p", 32, 90); // another servo's
    write(1, "id", 1, 5, "kept", IntentKind::SetId);
    const QDateTime away = pass();
    write(5, "position_p", 32, 48);
    write(5, "id", 5, 7, "kept", IntentKind::SetId);
    const QDateTime further = pass();
    write(7, "min_angle_limit", 0, 1024);
    write(7, "id", 7, 1, "mismatch", IntentKind::SetId);
    const QDateTime stillThere = pass();
    write(7, "id", 7, 1, "kept", IntentKind::SetId);
    write(7, "position_p", 32, 91); // another servo's
    const QDateTime back = pass();
    write(1, "position_p", 48, 60);

    QCOMPARE(at(away).changedId->id, 5);
    QCOMPARE(at(further).changedId->id, 7);
    QCOMPARE(rowOf(at(further).table, "id").raw, std::int64_t(7));
    QCOMPARE(rowOf(at(further).table, "position_p").raw, std::int64_t(32));
    QCOMPARE(at(stillThere).changedId->id, 7);
    QVERIFY(!at(back).changedId);
    QCOMPARE(rowOf(at(back).table, "id").raw, std::int64_t(1));
    QCOMPARE(rowOf(at(back).table, "position_p").raw, std::int64_t(48));
    QCOMPARE(rowOf(at(back).table, "min_angle_limit").raw, std::int64_t(1024));
    QVERIFY(at(back).unknown.isEmpty());
    QCOMPARE(rowOf(at(pass()).table, "position_p").raw, std::int64_t(60));
    QVERIFY(!at(pass()).changedId);
}

void TestHistoryLog::changesForACopy()
{
    const auto history = open();
    const history::HistoryChanges changes(history->file());
    const QString bench = changes.bench().value();
    QVERIFY(!bench.isEmpty());
    QCOMPARE(changes.revision().value(), 0);
    QVERIFY(changes.after(0).value().empty());

    write(1, "position_p", 32, 40);
    const auto run = history->add(sweep_example::run(), {utf8("/tmp/r.html")}).value();
    const auto snapshot = history->log().addSnapshot(snapshotOf(1), SnapshotReason::Manual).value();
    const auto first = changes.after(0).value();
    QStringList tables;
    for (const ChangedRow& row : first)
        tables << row.table;
    QCOMPARE(tables,
             QStringList({utf8("servos"), utf8("intents"), utf8("runs"), utf8("snapshots")}));
    QCOMPARE(changes.pendingCount(0).value(), 4);
    const ChangedRow& intent = first[1];
    QCOMPARE(intent.values[utf8("servo_uuid")].toString(), first[0].uuid);
    QCOMPARE(intent.values[utf8("outcome")].toString(), utf8("done"));
    const auto writes = intent.children[utf8("writes")];
    QCOMPARE(writes.size(), 1);
    QCOMPARE(writes[0][utf8("key")].toString(), utf8("position_p"));
    QCOMPARE(writes[0][utf8("servo_uuid")].toString(), first[0].uuid);
    QCOMPARE(first[2].children[utf8("run_servos")].size(), 2);
    QCOMPARE(first[2].children[utf8("run_files")].size(), 1);
    QVERIFY(!first[2].children[utf8("run_texts")].isEmpty());
    QVERIFY(!first[3].values[utf8("data")].toByteArray().isEmpty());

    // Only what changed since, and what was deleted as such.
    const std::int64_t seen = changes.revision().value();
    QCOMPARE(first.back().revision, seen);
    QVERIFY(history->log().setLabel(1, utf8("left")));
    QVERIFY(history->setLabel(run, 5, utf8("knee")));
    QVERIFY(history->log().removeSnapshot(snapshot));
    const auto next = changes.after(seen).value();
    QCOMPARE(next.size(), std::size_t(3));
    QCOMPARE(next[0].values[utf8("label")].toString(), utf8("left"));
    QCOMPARE(next[1].uuid, first[2].uuid);
    QCOMPARE(next[1].children[utf8("run_servos")][0][utf8("label")].toString(), utf8("knee"));
    QVERIFY(next[2].removed);
    QCOMPARE(next[2].uuid, first[3].uuid);
    QCOMPARE(next[2].table, utf8("snapshots"));
    // From the beginning: each row once, as it is now; what is gone is not there.
    QCOMPARE(changes.after(0).value().size(), std::size_t(4));
    QCOMPARE(changes.after(0, 2).value().size(), std::size_t(2));
    QCOMPARE(changes.after(0, 500, 1).value().size(), std::size_t(3)); // up to the first blob
    QCOMPARE(history::HistoryChanges(open()->file()).bench().value(), bench);
}

/// A copy that follows while two write gets every row.
void TestHistoryLog::concurrentChangesAreCopied()
{
    constexpr int each = 60;
    (void)open();
    std::vector<std::thread> writers;
    for (int i = 0; i < 2; ++i) {
        writers.emplace_back([this, i] {
            // Both write without a pause: that is about loss, not about patience.
            history::HistoryJournal journal(m_path, programName, std::chrono::seconds(5));
            for (int n = 0; n < each; ++n) {
                const auto uuid = journal.begin(intentOf(1 + i, "position_p", 0, n));
                if (uuid)
                    (void)journal.end(*uuid, {utf8("done"), {}});
            }
        });
    }
    const auto history = open();
    const history::HistoryChanges changes(history->file());
    QMap<QString, ChangedRow> copy;
    std::int64_t seen = 0;
    const auto follow = [&] {
        const auto rows = changes.after(seen, 7).value();
        for (const ChangedRow& row : rows) {
            QVERIFY(row.revision > seen);
            seen = row.revision;
            copy[row.uuid] = row;
        }
    };
    while (copy.size() < each)
        follow();
    for (std::thread& programName : writers)
        programName.join();
    while (changes.pendingCount(seen).value() > 0)
        follow();
    QCOMPARE(copy.size(), qsizetype(2 * each + 2)); // and two servos
    for (const ChangedRow& row : std::as_const(copy)) {
        if (row.table == utf8("intents"))
            QCOMPARE(row.values[utf8("outcome")].toString(), utf8("done"));
    }
}

void TestHistoryLog::exportedAsCsv()
{
    write(1, "position_p", 32, 40);
    write(2, "min_angle_limit", -5, 7);
    const auto history = open();
    QVERIFY(history->log().setLabel(1, utf8("=left, \"upper\"")));
    const QString path = m_dir->filePath(utf8("w.csv"));
    HistoryFilter filter;
    filter.limit = 1; // no limit for a file
    QCOMPARE(
        history::exportHistoryCsv(*history, history::HistoryKind::Writes, filter, path).value(), 2);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    QCOMPARE(lines.size(), 4);
    QCOMPARE(lines[0].split(',').size(), lines[1].split(',').size());
    QVERIFY(lines[0].startsWith("number,")); // for programs: no byte order mark
    QVERIFY(lines[1].contains(",min_angle_limit,21,-5,7,7,kept,"));
    QVERIFY(lines[2].contains(",\"'=left, \"\"upper\"\"\","));
    for (const auto kind : {history::HistoryKind::Servos, history::HistoryKind::Snapshots,
                            history::HistoryKind::Alarms, history::HistoryKind::Recordings,
                            history::HistoryKind::Runs})
        QVERIFY(history::exportHistoryCsv(*history, kind, {}, path));
    QVERIFY(!history::exportHistoryCsv(*history, history::HistoryKind::Runs, {},
                                       m_dir->filePath(utf8("no/such/folder.csv"))));
}

void TestHistoryLog::exportedAsJson()
{
    for (int i = 0; i < 5; ++i)
        write(1 + i % 2, "position_p", 0, i);
    const auto history = open();
    history->log().addSnapshot(snapshotOf(1), SnapshotReason::Manual).value();
    history->add(sweep_example::run()).value();
    const QString path = m_dir->filePath(utf8("all.json"));
    HistoryFilter one;
    one.id = 1;
    const auto rows =
        history::exportHistoryJson(*history,
                                   {history::HistoryKind::Servos, history::HistoryKind::Writes,
                                    history::HistoryKind::Snapshots, history::HistoryKind::Runs},
                                   one, path);
    QCOMPARE(rows.value(), 5);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(document[utf8("format")].toString(), utf8("servodesk-history"));
    QCOMPARE(document[utf8("servos")].toArray().size(), 1);
    QCOMPARE(document[utf8("writes")].toArray().size(), 3);
    QCOMPARE(document[utf8("writes")][0][utf8("new")].toInt(), 4);
    QCOMPARE(document[utf8("snapshots")].toArray().size(), 1);
    QVERIFY(document[utf8("runs")].toArray().isEmpty()); // of servos 5 and 6
}

/// The statements by which the first published version made its file, and rows it had put in.
void TestHistoryLog::theFirstSchemaIsMigrated()
{
    QVERIFY(QFile::copy(utf8(TEST_DATA_DIR "/history/history-1.sqlite"), m_path));
    QVERIFY(QFile::setPermissions(m_path, QFile::ReadOwner | QFile::WriteOwner));
    // Several at once.
    std::vector<std::thread> starters;
    std::atomic<int> fine{0};
    for (int i = 0; i < 4; ++i)
        starters.emplace_back([&] { fine += history::History::open(m_path) ? 1 : 0; });
    for (std::thread& starter : starters)
        starter.join();
    QCOMPARE(fine, 4);
    const auto history = open();
    const auto runs = history->runs().value();
    QCOMPARE(runs.size(), std::size_t(2));
    QCOMPARE(runs[1].note, sweep_example::hostileNote);
    QCOMPARE(runs[1].servos[0].label, sweep_example::hostileLabel);
    QVERIFY(history->sweep(runs[1].number).value() == sweep_example::firstVersionRun());
    QVERIFY(history->reference(runs[0].servos[0].model).value());
    const auto changes = history::HistoryChanges(history->file());
    QCOMPARE(changes.after(0).value().size(), std::size_t(2));
    write(1, "position_p", 32, 40);
    QCOMPARE(changes.after(0).value().size(), std::size_t(4));
    QVERIFY(history->add(sweep_example::run()).value() > runs[0].number);
}

/// No room half-way: the file is of the first schema still, with all that is in it.
void TestHistoryLog::aMigrationThatFailsChangesNothing()
{
    QVERIFY(QFile::copy(utf8(TEST_DATA_DIR "/history/history-1.sqlite"), m_path));
    QVERIFY(QFile::setPermissions(m_path, QFile::ReadOwner | QFile::WriteOwner));
    const auto holder = QDir(m_dir->path()).entryList(QDir::Files);
    QCOMPARE(holder.size(), 1);
    {
        // Somebody else has it to himself: it is not migrated, and nobody waits for ever.
        const auto first = history::HistoryFile::open(m_dir->filePath(utf8("other.sqlite")), 1s);
        QVERIFY(first);
        const auto attached = (*first)->run(QStringLiteral("ATTACH DATABASE ? AS held"), {m_path});
        QVERIFY(attached);
        QVERIFY((*first)->run(QStringLiteral("BEGIN IMMEDIATE")));
        QVERIFY((*first)->run(QStringLiteral("UPDATE held.runs SET note = note")));
        QVERIFY(!history::History::open(m_path, 20ms));
        QVERIFY((*first)->run(QStringLiteral("ROLLBACK")));
    }
    QCOMPARE(open()->runs().value().size(), std::size_t(2));
}

SERVODESK_GUILESS_TEST(TestHistoryLog)
#include "tst_history_log.moc"

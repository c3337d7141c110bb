// SPDX-License-Identifier: GPL-3.0-or-later
// The ways back of a restore: one that was broken off and fails to be finished, one that is undone,
// one whose way back is broken off as well, at every write. Every row comes back, also where the
// servo held what no sheet allows; the lock closes, the journal ends the rows as undone, and the
// history on disk leads from the table before to what the servo has now.
#include "history/history.h"
#include "history/history_journal.h"
#include "history/history_table.h"
#include "integration/restore_faults.h"
#include "jobs/recover/recover.h"
#include "jobs/restore/restore.h"
#include "jobs/restore/take_snapshot.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using jobs::OnFailure;
using jobs::RecoveryAction;
using jobs::RestoreVerdict;
using support::SimFixture;
using support::TableValues;
using support::utf8;

namespace {
constexpr int rowCount = 7;
constexpr int framesUntilFourthRow = 4;

enum class UndoFailure { OtherValue, Silence };
enum class InitialTable { Default, OutsideDocumentedRange };

/// A servo with seven rows to restore, and a history on disk that knows its table before.
class RestoreUndoFixture {
public:
    explicit RestoreUndoFixture(InitialTable before = InitialTable::Default)
    {
        wanted = jobs::snapshotOf(support::identifyWithTable(sim), utf8("test 1"));
        wanted.at = QDateTime::currentDateTimeUtc();
        support::changeSevenRegisters(sim);
        if (before == InitialTable::OutsideDocumentedRange) {
            support::pokePersistent(sim, utf8("max_temperature"), 140);
            support::pokePersistent(sim, utf8("max_torque"), 1023);
            support::pokePersistent(sim, utf8("min_angle_limit"), 3000);
            support::pokePersistent(sim, utf8("max_angle_limit"), 200);
        }
        first = support::held(sim);
        snapshot::Snapshot now = jobs::snapshotOf(support::identifyWithTable(sim), utf8("test 1"));
        now.at = QDateTime::currentDateTimeUtc();
        if (!open()->log().addSnapshot(now, history::SnapshotReason::Automatic))
            qFatal("no history");
    }

    device::Context context()
    {
        const device::Context plain = sim.context();
        return {plain.bus, plain.catalog, journal, plain.stop, plain.notices};
    }

    /// Nullopt: it ended with an error.
    std::optional<jobs::RestoreOutcome> restore(OnFailure onFailure = OnFailure::Stop)
    {
        const std::vector<base::Protocol> feetech{base::Protocol::Feetech};
        auto servo = device::identifyAmong(context(), 1, feetech);
        if (!servo || !device::readAll(context(), *servo))
            return std::nullopt;
        const auto plan = jobs::planRestore(*servo, wanted);
        const auto outcome = jobs::restore(context(), *servo, plan, {{}, onFailure, {}});
        return outcome ? std::optional(*outcome) : std::nullopt;
    }

    /// The link is cut before the fourth row.
    void interruptRestore()
    {
        support::cutAtWrite(sim, framesUntilFourthRow + 1);
        const auto outcome = restore();
        if (!outcome || outcome->verdict != RestoreVerdict::Failed)
            qFatal("it was not broken off");
        restoreLink();
        if (journal.open()->size() != 1)
            qFatal("no intent is open");
    }

    /// What is still to be written of the open restore.
    base::JournalItem nextPendingItem()
    {
        const base::Intent intent = journal.open()->front();
        for (const base::JournalItem& item : intent.items) {
            if (sim.raw(1, item.key) != item.newRaw)
                return item;
        }
        qFatal("nothing is missing");
    }

    void trouble(UndoFailure kind)
    {
        const base::JournalItem missing = nextPendingItem();
        if (kind == UndoFailure::OtherValue)
            support::overwriteAfterWrite(sim, std::uint8_t(missing.address), missing.key,
                                         missing.newRaw + 1, 1);
        else
            support::muteFromWrite(sim, 3); // the lock, a row, and then
    }

    /// The cable is back, the servo answers again.
    void restoreLink()
    {
        sim.tap().onWrite = nullptr;
        sim.wireConfig().faults.muteIds.clear();
        sim.reconnect(1'000'000);
    }

    base::Result<std::vector<jobs::RecoveryResult>> recover(RecoveryAction action)
    {
        return jobs::recover(context(), action);
    }

    std::unique_ptr<history::History> open() const
    {
        auto history = history::History::open(journal.path());
        if (!history)
            qFatal("no history");
        return std::move(*history);
    }

    /// Nothing is open, the lock is closed, the table is the one before, also after a power-off.
    QString findLeftovers()
    {
        if (!journal.open()->empty())
            return utf8("an intent is open");
        for (const char* when : {"", " after a power-off"}) {
            if (support::isLockOpen(sim))
                return utf8("the lock is open") + utf8(when);
            for (const auto& [key, raw] : support::held(sim)) {
                if (first.at(key) != raw)
                    return QStringLiteral("%1: %2, it was %3%4")
                        .arg(key)
                        .arg(raw)
                        .arg(first.at(key))
                        .arg(utf8(when));
            }
            sim.powerCycle();
            sim.runFor(std::chrono::seconds(3));
        }
        return historyMismatch();
    }

    /// The history's table of this moment against the servo's.
    QString historyMismatch()
    {
        const auto history = open();
        const auto servos = history->log().servos();
        if (!servos || servos->size() != 1)
            return utf8("not one servo in the history");
        const auto point =
            history::tableAt(history->file(), support::builtInCatalog(), servos->front().number,
                             QDateTime::currentDateTimeUtc());
        if (!point)
            return utf8("no table");
        for (const auto& [key, raw] : support::held(sim)) {
            const snapshot::SnapshotRegister* row = point->table.find(key);
            if (row == nullptr || row->raw != raw)
                return QStringLiteral("history: %1 is %2, the servo has %3")
                    .arg(key)
                    .arg(row != nullptr && row->raw ? *row->raw : -9999)
                    .arg(raw);
        }
        return {};
    }

    /// The end of the restore that was begun first: undone, with every row that was touched.
    QString undoErrors(int touched)
    {
        const auto entries = journal.entries();
        const base::JournalEntry& restore = entries->front();
        if (!restore.end || restore.end->outcome != utf8("undone"))
            return utf8("the restore ended as ") +
                   (restore.end ? restore.end->outcome : utf8("nothing"));
        int undone = 0;
        for (const base::JournalItem& item : restore.intent.items) {
            const auto& ends = restore.end->items;
            const auto end = std::find_if(ends.begin(), ends.end(),
                                          [&](const auto& one) { return one.key == item.key; });
            if (end == ends.end())
                return utf8("nothing is said of ") + item.key;
            if (end->outcome == utf8("refused") || end->outcome == utf8("not-sent"))
                continue;
            if (end->outcome != utf8("undone") || end->readBack != item.oldRaw)
                return item.key + utf8(" ended as ") + end->outcome;
            ++undone;
        }
        return undone == touched ? QString() : QStringLiteral("%1 rows are undone").arg(undone);
    }

    SimFixture sim{utf8("sts3215@1")};
    const QTemporaryDir folder;
    history::HistoryJournal journal{folder.filePath(utf8("history.sqlite")), utf8("test 1")};
    snapshot::Snapshot wanted;
    TableValues first;
};
} // namespace

class TestRestoreUndo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void anInterruptedRestoreIsUndone_data();
    void anInterruptedRestoreIsUndone();
    void aFailedCompletionIsRolledBack_data();
    void aFailedCompletionIsRolledBack();
    void aFailedCompletionIsUndone_data();
    void aFailedCompletionIsUndone();
    void anInterruptedRollbackIsCompleted_data();
    void anInterruptedRollbackIsCompleted();
    void stoppingMidwayRollsBack();
    void onlyTheRollbackIsOpen_data();
    void onlyTheRollbackIsOpen();
    void laterForeignWritesAreKept_data();
    void laterForeignWritesAreKept();
    void theLatestIsUndoneFirst();
    void anAlreadyMatchingRowIsIncluded();
    void unknownValuesAreRefused();
};

void TestRestoreUndo::anInterruptedRestoreIsUndone_data()
{
    QTest::addColumn<int>("before");
    QTest::newRow("usual values") << int(InitialTable::Default);
    QTest::newRow("outside the sheet") << int(InitialTable::OutsideDocumentedRange);
}

void TestRestoreUndo::anInterruptedRestoreIsUndone()
{
    QFETCH(const int, before);
    RestoreUndoFixture fixture{InitialTable(before)};
    fixture.interruptRestore();
    const auto items = fixture.journal.open()->front().items.size();
    const auto undone = fixture.recover(RecoveryAction::Undo);
    QVERIFY(undone && undone->size() == 1);
    QVERIFY2(undone->front().done,
             undone->front().error ? qPrintable(base::errorName(undone->front().error->code)) : "");
    QVERIFY(undone->front().torqueIsOff);
    QCOMPARE(fixture.undoErrors(int(items)), QString());
    QCOMPARE(fixture.findLeftovers(), QString());
}

void TestRestoreUndo::aFailedCompletionIsRolledBack_data()
{
    QTest::addColumn<int>("trouble");
    QTest::addColumn<int>("before");
    for (const auto& [name, before] :
         {std::pair{"", InitialTable::Default},
          std::pair{", outside the sheet", InitialTable::OutsideDocumentedRange}}) {
        QTest::addRow("a row shows another value%s", name)
            << int(UndoFailure::OtherValue) << int(before);
        QTest::addRow("the servo falls silent%s", name) << int(UndoFailure::Silence) << int(before);
    }
}

void TestRestoreUndo::aFailedCompletionIsRolledBack()
{
    QFETCH(const int, trouble);
    QFETCH(const int, before);
    RestoreUndoFixture fixture{InitialTable(before)};
    fixture.interruptRestore();
    fixture.trouble(UndoFailure(trouble));
    const auto outcome = fixture.restore(OnFailure::RollBack);
    fixture.restoreLink();
    QVERIFY(outcome);
    QCOMPARE(outcome->verdict, RestoreVerdict::RolledBack);
    QCOMPARE(outcome->lock, device::LockState::Closed);
    int touched = 0;
    for (const jobs::RestoreRowResult& row : outcome->rows) {
        const bool isTouched = !device::isUntouched(row.write.outcome);
        QCOMPARE(row.rolledBack, isTouched);
        if (isTouched)
            QCOMPARE(row.write.readBack, row.write.oldRaw);
        touched += isTouched ? 1 : 0;
    }
    // Those of the first try are among them.
    QVERIFY(touched > framesUntilFourthRow - 1);
    QCOMPARE(fixture.undoErrors(touched), QString());
    QCOMPARE(fixture.findLeftovers(), QString());
}

void TestRestoreUndo::aFailedCompletionIsUndone_data()
{
    aFailedCompletionIsRolledBack_data();
}

void TestRestoreUndo::aFailedCompletionIsUndone()
{
    QFETCH(const int, trouble);
    QFETCH(const int, before);
    RestoreUndoFixture fixture{InitialTable(before)};
    fixture.interruptRestore();
    const auto items = fixture.journal.open()->front().items.size();
    fixture.trouble(UndoFailure(trouble));
    const auto finished = fixture.recover(RecoveryAction::Finish);
    fixture.restoreLink();
    QVERIFY(finished && finished->size() == 1);
    QVERIFY(!finished->front().done);
    QVERIFY(finished->front().error);
    QVERIFY(!fixture.journal.open()->empty());

    const auto undone = fixture.recover(RecoveryAction::Undo);
    QVERIFY(undone);
    for (const jobs::RecoveryResult& one : *undone)
        QVERIFY2(one.done, one.error ? qPrintable(base::errorName(one.error->code)) : "");
    QCOMPARE(fixture.undoErrors(int(items)), QString());
    QCOMPARE(fixture.findLeftovers(), QString());
}

void TestRestoreUndo::anInterruptedRollbackIsCompleted_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("before");
    for (const auto& [name, action] :
         {std::pair{"finish", RecoveryAction::Finish}, std::pair{"undo", RecoveryAction::Undo}}) {
        QTest::addRow("%s", name) << int(action) << int(InitialTable::Default);
        QTest::addRow("%s, outside the sheet", name)
            << int(action) << int(InitialTable::OutsideDocumentedRange);
    }
}

void TestRestoreUndo::anInterruptedRollbackIsCompleted()
{
    QFETCH(const int, action);
    QFETCH(const int, before);
    int brokenOff = 0;
    for (int cut = 1;; ++cut) {
        RestoreUndoFixture fixture{InitialTable(before)};
        // The third row falls silent, so the restore stays open; the cable fails during the
        // rollback.
        bool fired = false;
        support::muteFromWrite(fixture.sim, framesUntilFourthRow,
                               [&, left = cut](const base::Bytes& frame) mutable {
                                   if (fired || !support::isWrite(frame) || --left > 0)
                                       return;
                                   fired = true;
                                   fixture.sim.cutLink();
                               });
        const auto outcome = fixture.restore(OnFailure::RollBack);
        fixture.restoreLink();
        QVERIFY(outcome);
        const QByteArray where = QByteArray::number(cut);
        if (!fired) {
            QCOMPARE(outcome->verdict, RestoreVerdict::RolledBack);
            QCOMPARE(fixture.findLeftovers(), QString());
            break;
        }
        QVERIFY2(outcome->verdict == RestoreVerdict::Failed, where);
        for (const jobs::RestoreRowResult& row : outcome->rows) {
            const bool reported = row.rolledBack || outcome->notReverted.contains(row.write.key);
            QVERIFY2(reported || device::isUntouched(row.write.outcome), where);
        }
        const bool somethingOpen =
            !outcome->notReverted.isEmpty() || outcome->lock != device::LockState::Closed;
        QVERIFY2(somethingOpen, where);
        const auto open = *fixture.journal.open();
        QVERIFY2(open.size() == 2, where);
        ++brokenOff;

        const auto ended = fixture.recover(RecoveryAction(action));
        QVERIFY2(ended && ended->size() == 2, where);
        for (const jobs::RecoveryResult& one : *ended) {
            QVERIFY2(one.done, where + (one.error ? base::errorName(one.error->code).toLatin1()
                                                  : QByteArray()));
            const bool isRestore = one.before.intent.uuid == open.front().uuid;
            QVERIFY2(one.action == (isRestore ? RecoveryAction::Undo : RecoveryAction::Finish),
                     where);
        }
        const QString end = fixture.undoErrors(int(open.front().items.size()));
        QVERIFY2(end.isEmpty(), where + ": " + end.toUtf8());
        const QString differs = fixture.findLeftovers();
        QVERIFY2(differs.isEmpty(), where + ": " + differs.toUtf8());
    }
    // Unlocking, two rows and locking at least.
    QVERIFY(brokenOff >= 4);
}

/// Ctrl-C in the middle, with rolling back requested.
void TestRestoreUndo::stoppingMidwayRollsBack()
{
    RestoreUndoFixture fixture;
    fixture.sim.tap().onWrite = [&, left = framesUntilFourthRow](const base::Bytes& frame) mutable {
        if (support::isWrite(frame) && --left == 0)
            fixture.sim.stop().request();
    };
    const auto outcome = fixture.restore(OnFailure::RollBack);
    QVERIFY(outcome && outcome->verdict == RestoreVerdict::RolledBack);
    QVERIFY(outcome->notReverted.isEmpty());
    fixture.restoreLink();
    QCOMPARE(fixture.findLeftovers(), QString());
}

void TestRestoreUndo::onlyTheRollbackIsOpen_data()
{
    anInterruptedRollbackIsCompleted_data();
}

/// A row that shows another value ends the restore as failed; only its rollback remains.
void TestRestoreUndo::onlyTheRollbackIsOpen()
{
    QFETCH(const int, action);
    QFETCH(const int, before);
    RestoreUndoFixture fixture{InitialTable(before)};
    constexpr std::uint8_t address = 21;
    int writes = 0;
    fixture.sim.tap().onWrite = [&, pending = false](const base::Bytes& frame) mutable {
        if (std::exchange(pending, support::isWrite(frame) && frame[5] == address) && writes == 0) {
            fixture.sim.poke(1, utf8("position_p"), 99);
            writes = 1;
        }
        // Locked, unlocked, the first row, and in the middle of the second it is cut.
        constexpr int secondRowBack = 5;
        if (writes > 0 && support::isWrite(frame) && ++writes == secondRowBack)
            fixture.sim.cutLink();
    };
    const auto outcome = fixture.restore(OnFailure::RollBack);
    fixture.restoreLink();
    QVERIFY(outcome && outcome->verdict == RestoreVerdict::Failed);
    const auto open = *fixture.journal.open();
    QCOMPARE(open.size(), std::size_t(1));
    QCOMPARE(fixture.journal.entries()->front().end->outcome, utf8("failed"));

    const auto ended = fixture.recover(RecoveryAction(action));
    QVERIFY(ended && ended->size() == 1);
    QVERIFY2(ended->front().done,
             ended->front().error ? qPrintable(base::errorName(ended->front().error->code)) : "");
    QVERIFY(!support::isLockOpen(fixture.sim));
    QVERIFY(fixture.journal.open()->empty());
    for (const base::JournalItem& item : open.front().items) {
        const bool back = RecoveryAction(action) == RecoveryAction::Finish;
        QCOMPARE(fixture.sim.raw(1, item.key), back ? item.newRaw : item.oldRaw);
    }
    QCOMPARE(fixture.historyMismatch(), QString());
    if (RecoveryAction(action) == RecoveryAction::Finish)
        QCOMPARE(fixture.findLeftovers(), QString());
}

void TestRestoreUndo::laterForeignWritesAreKept_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoveryAction::Finish);
    QTest::newRow("undo") << int(RecoveryAction::Undo);
}

/// The other rows are finished.
void TestRestoreUndo::laterForeignWritesAreKept()
{
    QFETCH(int, action);
    RestoreUndoFixture fixture;
    fixture.interruptRestore();
    const base::JournalItem missing = fixture.nextPendingItem();
    device::Servo servo = support::identifyWithTable(fixture.sim);
    const auto written =
        device::write(fixture.context(), servo, {{missing.key, missing.newRaw + 1}}, {});
    QVERIFY(written && written->isSuccessful());
    const auto open = *fixture.journal.open();
    QCOMPARE(open.size(), std::size_t(1));
    const auto one = fixture.recover(RecoveryAction(action));
    QVERIFY(one && one->size() == 1 && one->front().done);
    QCOMPARE(one->front().before.replaced, QStringList{missing.key});
    QVERIFY(fixture.journal.open()->empty());
    for (const base::JournalItem& item : open.front().items) {
        const bool back = RecoveryAction(action) == RecoveryAction::Undo;
        const std::int64_t settled = back ? item.oldRaw : item.newRaw;
        QCOMPARE(fixture.sim.raw(1, item.key),
                 item.key == missing.key ? missing.newRaw + 1 : settled);
    }
}

void TestRestoreUndo::theLatestIsUndoneFirst()
{
    RestoreUndoFixture fixture;
    const device::Servo servo = support::identifyWithTable(fixture.sim);
    const catalog::Register& reg = *servo.profile->find(utf8("position_p"));
    const std::int64_t before = fixture.first.at(reg.key);
    base::Intent intent;
    intent.servo = servo.identity();
    for (const std::int64_t old : {before, before + 1}) {
        intent.items = {{reg.key, reg.address, old, old + 1}};
        QVERIFY(fixture.journal.begin(intent));
    }
    support::pokePersistent(fixture.sim, reg.key, before + 2);
    const auto undone = fixture.recover(RecoveryAction::Undo);
    QVERIFY(undone && undone->size() == 2);
    QVERIFY(undone->front().done && undone->back().done);
    QCOMPARE(fixture.findLeftovers(), QString());
}

/// Only the servo's own restore (0x06) has no new values, and leaves the history without them.
void TestRestoreUndo::anAlreadyMatchingRowIsIncluded()
{
    RestoreUndoFixture fixture;
    device::Servo servo = support::identifyWithTable(fixture.sim);
    device::WriteOptions options;
    options.kind = base::IntentKind::Restore;
    const device::WriteItem so{utf8("position_p"), fixture.first.at(utf8("position_p"))};
    QVERIFY(device::write(fixture.context(), servo, {so, {utf8("max_torque"), 800}}, options));
    QCOMPARE(fixture.historyMismatch(), QString());
    QVERIFY(device::write(fixture.context(), servo, {so}, options));
    QCOMPARE(fixture.historyMismatch(), QString());
}

/// Finishing is no way around the sheet.
void TestRestoreUndo::unknownValuesAreRefused()
{
    RestoreUndoFixture fixture;
    device::Servo servo = support::identifyWithTable(fixture.sim);
    base::Intent intent;
    intent.kind = base::IntentKind::Restore;
    intent.servo = servo.identity();
    const catalog::Register& reg = *servo.profile->find(utf8("max_torque"));
    intent.items = {{reg.key, reg.address, 900, 1023}};
    QVERIFY(fixture.journal.begin(intent));
    fixture.sim.clearFrames();
    const auto refused = fixture.recover(RecoveryAction::Finish);
    QVERIFY(refused && refused->size() == 1 && !refused->front().done);
    QCOMPARE(refused->front().error->code, base::ErrorCode::OutOfRange);
    QVERIFY(fixture.sim.onlyReadsSent());

    // Once it was found with that value, it may have it again.
    base::Intent earlier = intent;
    earlier.items = {{reg.key, reg.address, 1023, 900}};
    const auto uuid = fixture.journal.begin(earlier);
    QVERIFY(uuid && fixture.journal.end(*uuid, {utf8("done"), {}, {}}));
    const auto finished = fixture.recover(RecoveryAction::Finish);
    QVERIFY(finished && finished->size() == 1 && finished->front().done);
    QCOMPARE(fixture.sim.raw(1, utf8("max_torque")), 1023);
}

SERVODESK_GUILESS_TEST(TestRestoreUndo)
#include "tst_restore_undo.moc"

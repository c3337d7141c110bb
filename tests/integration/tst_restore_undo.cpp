// SPDX-License-Identifier: GPL-3.0-or-later
// The ways back of a restore: one that was broken off and fails to be finished, one that is undone,
// one whose way back is broken off as well, at every write. Every row comes back, also where the
// servo held what no sheet allows; the lock closes, the journal ends the rows as undone, and the
// history on disk leads from the table before to what the servo has now.
#include "integration/restore_trouble.h"
#include "jobs/recover.h"
#include "jobs/restore.h"
#include "jobs/snapshot.h"
#include "record/history.h"
#include "record/history_journal.h"
#include "record/history_point.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using jobs::OnFailure;
using jobs::RecoverAction;
using jobs::RestoreVerdict;
using support::SimBench;
using support::TableValues;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

constexpr int rowCount = 7;
constexpr int unlockAndThreeRows = 4;

enum class Trouble { OtherValue, Silence };
enum class Before { Usual, OutsideTheSheet };

/// A servo with seven rows to restore, and a history on disk that knows its table before.
class UndoBench {
public:
    explicit UndoBench(Before before = Before::Usual)
    {
        wanted = jobs::snapshotOf(support::wholeServo(bench), text("test 1"));
        wanted.at = QDateTime::currentDateTimeUtc();
        support::disturb(bench);
        if (before == Before::OutsideTheSheet) {
            support::pokeKept(bench, text("max_temperature"), 140);
            support::pokeKept(bench, text("max_torque"), 1023);
            support::pokeKept(bench, text("min_angle_limit"), 3000);
            support::pokeKept(bench, text("max_angle_limit"), 200);
        }
        first = support::held(bench);
        record::Snapshot now = jobs::snapshotOf(support::wholeServo(bench), text("test 1"));
        now.at = QDateTime::currentDateTimeUtc();
        if (!open()->log().addSnapshot(now, record::SnapshotReason::Automatic))
            qFatal("no history");
    }

    device::Context context()
    {
        const device::Context plain = bench.context();
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
        const auto outcome = jobs::restore(context(), *servo, plan, {false, onFailure, {}});
        return outcome ? std::optional(*outcome) : std::nullopt;
    }

    /// The link is cut before the fourth row.
    void breakOff()
    {
        support::cutAtWrite(bench, unlockAndThreeRows + 1);
        const auto outcome = restore();
        if (!outcome || outcome->verdict != RestoreVerdict::Failed)
            qFatal("it was not broken off");
        mend();
        if (journal.open()->size() != 1)
            qFatal("no intent is open");
    }

    /// What is still to be written of the open restore.
    base::JournalItem nextMissing()
    {
        const base::Intent intent = journal.open()->front();
        for (const base::JournalItem& item : intent.items) {
            if (bench.raw(1, item.key) != item.newRaw)
                return item;
        }
        qFatal("nothing is missing");
    }

    void trouble(Trouble kind)
    {
        const base::JournalItem missing = nextMissing();
        if (kind == Trouble::OtherValue)
            support::meddle(bench, std::uint8_t(missing.address), missing.key, missing.newRaw + 1,
                            1);
        else
            support::fallSilent(bench, 3); // the lock, a row, and then
    }

    /// The cable is back, the servo answers again.
    void mend()
    {
        bench.tap().onWrite = nullptr;
        bench.wireConfig().faults.muteIds.clear();
        bench.reconnect(1'000'000);
    }

    base::Result<std::vector<jobs::Recovered>> recover(RecoverAction action)
    {
        return jobs::recover(context(), action);
    }

    std::unique_ptr<record::History> open() const
    {
        auto history = record::History::open(journal.path());
        if (!history)
            qFatal("no history");
        return std::move(*history);
    }

    /// Nothing is open, the lock is closed, the table is the one before, also after a power-off.
    QString notAsBefore()
    {
        if (!journal.open()->empty())
            return text("an intent is open");
        for (const char* when : {"", " after a power-off"}) {
            if (support::lockIsOpen(bench))
                return text("the lock is open") + text(when);
            for (const auto& [key, raw] : support::held(bench)) {
                if (first.at(key) != raw)
                    return QStringLiteral("%1: %2, it was %3%4")
                        .arg(key)
                        .arg(raw)
                        .arg(first.at(key))
                        .arg(text(when));
            }
            bench.powerCycle();
            bench.letTimePass(std::chrono::seconds(3));
        }
        return historyLies();
    }

    /// The history's table of this moment against the servo's.
    QString historyLies()
    {
        const auto history = open();
        const auto servos = history->log().servos();
        if (!servos || servos->size() != 1)
            return text("not one servo in the history");
        const auto point = record::tableAt(history->file(), support::builtInCatalog(),
                                           servos->front().number, QDateTime::currentDateTimeUtc());
        if (!point)
            return text("no table");
        for (const auto& [key, raw] : support::held(bench)) {
            const record::SnapshotRegister* row = point->table.find(key);
            if (row == nullptr || row->raw != raw)
                return QStringLiteral("history: %1 is %2, the servo has %3")
                    .arg(key)
                    .arg(row != nullptr && row->raw ? *row->raw : -9999)
                    .arg(raw);
        }
        return {};
    }

    /// The end of the restore that was begun first: undone, with every row that was touched.
    QString notUndone(int touched)
    {
        const auto entries = journal.entries();
        const base::JournalEntry& restore = entries->front();
        if (!restore.end || restore.end->outcome != text("undone"))
            return text("the restore ended as ") +
                   (restore.end ? restore.end->outcome : text("nothing"));
        int undone = 0;
        for (const base::JournalItem& item : restore.intent.items) {
            const auto& ends = restore.end->items;
            const auto end = std::find_if(ends.begin(), ends.end(),
                                          [&](const auto& one) { return one.key == item.key; });
            if (end == ends.end())
                return text("nothing is said of ") + item.key;
            if (end->outcome == text("refused") || end->outcome == text("not-sent"))
                continue;
            if (end->outcome != text("undone") || end->readBack != item.oldRaw)
                return item.key + text(" ended as ") + end->outcome;
            ++undone;
        }
        return undone == touched ? QString() : QStringLiteral("%1 rows are undone").arg(undone);
    }

    SimBench bench{text("sts3215@1")};
    const QTemporaryDir folder;
    record::HistoryJournal journal{folder.filePath(text("history.sqlite")), text("test 1")};
    record::Snapshot wanted;
    TableValues first;
};
} // namespace

class TestRestoreUndo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void aBrokenOffRestoreIsUndone_data();
    void aBrokenOffRestoreIsUndone();
    void aFinishingThatFailsIsRolledBack_data();
    void aFinishingThatFailsIsRolledBack();
    void aFinishingThatFailedIsUndone_data();
    void aFinishingThatFailedIsUndone();
    void aWayBackBrokenOffIsGoneToItsEnd_data();
    void aWayBackBrokenOffIsGoneToItsEnd();
    void endingItOnTheWayPutsBack();
    void onlyTheWayBackIsOpen_data();
    void onlyTheWayBackIsOpen();
    void whatSomebodyWroteSinceIsLeftAlone_data();
    void whatSomebodyWroteSinceIsLeftAlone();
    void theLatestIsUndoneFirst();
    void aRowThatIsSoAlreadyIsNotForgotten();
    void whatNobodyHeldIsRefused();
};

void TestRestoreUndo::aBrokenOffRestoreIsUndone_data()
{
    QTest::addColumn<int>("before");
    QTest::newRow("usual values") << int(Before::Usual);
    QTest::newRow("outside the sheet") << int(Before::OutsideTheSheet);
}

void TestRestoreUndo::aBrokenOffRestoreIsUndone()
{
    QFETCH(const int, before);
    UndoBench bench{Before(before)};
    bench.breakOff();
    const auto items = bench.journal.open()->front().items.size();
    const auto undone = bench.recover(RecoverAction::Undo);
    QVERIFY(undone && undone->size() == 1);
    QVERIFY2(undone->front().done,
             undone->front().error ? qPrintable(base::errorName(undone->front().error->code)) : "");
    QVERIFY(undone->front().torqueIsOff);
    QCOMPARE(bench.notUndone(int(items)), QString());
    QCOMPARE(bench.notAsBefore(), QString());
}

void TestRestoreUndo::aFinishingThatFailsIsRolledBack_data()
{
    QTest::addColumn<int>("trouble");
    QTest::addColumn<int>("before");
    for (const auto& [name, before] : {std::pair{"", Before::Usual},
                                       std::pair{", outside the sheet", Before::OutsideTheSheet}}) {
        QTest::addRow("a row shows another value%s", name)
            << int(Trouble::OtherValue) << int(before);
        QTest::addRow("the servo falls silent%s", name) << int(Trouble::Silence) << int(before);
    }
}

void TestRestoreUndo::aFinishingThatFailsIsRolledBack()
{
    QFETCH(const int, trouble);
    QFETCH(const int, before);
    UndoBench bench{Before(before)};
    bench.breakOff();
    bench.trouble(Trouble(trouble));
    const auto outcome = bench.restore(OnFailure::RollBack);
    bench.mend();
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
    QVERIFY(touched > unlockAndThreeRows - 1);
    QCOMPARE(bench.notUndone(touched), QString());
    QCOMPARE(bench.notAsBefore(), QString());
}

void TestRestoreUndo::aFinishingThatFailedIsUndone_data()
{
    aFinishingThatFailsIsRolledBack_data();
}

void TestRestoreUndo::aFinishingThatFailedIsUndone()
{
    QFETCH(const int, trouble);
    QFETCH(const int, before);
    UndoBench bench{Before(before)};
    bench.breakOff();
    const auto items = bench.journal.open()->front().items.size();
    bench.trouble(Trouble(trouble));
    const auto finished = bench.recover(RecoverAction::Finish);
    bench.mend();
    QVERIFY(finished && finished->size() == 1);
    QVERIFY(!finished->front().done);
    QVERIFY(finished->front().error);
    QVERIFY(!bench.journal.open()->empty());

    const auto undone = bench.recover(RecoverAction::Undo);
    QVERIFY(undone);
    for (const jobs::Recovered& one : *undone)
        QVERIFY2(one.done, one.error ? qPrintable(base::errorName(one.error->code)) : "");
    QCOMPARE(bench.notUndone(int(items)), QString());
    QCOMPARE(bench.notAsBefore(), QString());
}

void TestRestoreUndo::aWayBackBrokenOffIsGoneToItsEnd_data()
{
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("before");
    for (const auto& [name, action] :
         {std::pair{"finish", RecoverAction::Finish}, std::pair{"undo", RecoverAction::Undo}}) {
        QTest::addRow("%s", name) << int(action) << int(Before::Usual);
        QTest::addRow("%s, outside the sheet", name) << int(action) << int(Before::OutsideTheSheet);
    }
}

void TestRestoreUndo::aWayBackBrokenOffIsGoneToItsEnd()
{
    QFETCH(const int, action);
    QFETCH(const int, before);
    int brokenOff = 0;
    for (int cut = 1;; ++cut) {
        UndoBench bench{Before(before)};
        // The third row falls silent, so the restore stays open; on the way back the cable goes.
        bool fired = false;
        support::fallSilent(bench.bench, unlockAndThreeRows,
                            [&, left = cut](const base::Bytes& frame) mutable {
                                if (fired || !support::isWrite(frame) || --left > 0)
                                    return;
                                fired = true;
                                bench.bench.cutLink();
                            });
        const auto outcome = bench.restore(OnFailure::RollBack);
        bench.mend();
        QVERIFY(outcome);
        const QByteArray where = QByteArray::number(cut);
        if (!fired) {
            QCOMPARE(outcome->verdict, RestoreVerdict::RolledBack);
            QCOMPARE(bench.notAsBefore(), QString());
            break;
        }
        QVERIFY2(outcome->verdict == RestoreVerdict::Failed, where);
        for (const jobs::RestoreRowResult& row : outcome->rows) {
            const bool told = row.rolledBack || outcome->notPutBack.contains(row.write.key);
            QVERIFY2(told || device::isUntouched(row.write.outcome), where);
        }
        const bool somethingOpen =
            !outcome->notPutBack.isEmpty() || outcome->lock != device::LockState::Closed;
        QVERIFY2(somethingOpen, where);
        const auto open = *bench.journal.open();
        QVERIFY2(open.size() == 2, where);
        ++brokenOff;

        const auto ended = bench.recover(RecoverAction(action));
        QVERIFY2(ended && ended->size() == 2, where);
        for (const jobs::Recovered& one : *ended) {
            QVERIFY2(one.done, where + (one.error ? base::errorName(one.error->code).toLatin1()
                                                  : QByteArray()));
            const bool isRestore = one.before.intent.uuid == open.front().uuid;
            QVERIFY2(one.action == (isRestore ? RecoverAction::Undo : RecoverAction::Finish),
                     where);
        }
        const QString end = bench.notUndone(int(open.front().items.size()));
        QVERIFY2(end.isEmpty(), where + ": " + end.toUtf8());
        const QString differs = bench.notAsBefore();
        QVERIFY2(differs.isEmpty(), where + ": " + differs.toUtf8());
    }
    // Unlocking, two rows and locking at least.
    QVERIFY(brokenOff >= 4);
}

/// Ctrl-C in the middle, rolling back asked for.
void TestRestoreUndo::endingItOnTheWayPutsBack()
{
    UndoBench bench;
    bench.bench.tap().onWrite = [&, left = unlockAndThreeRows](const base::Bytes& frame) mutable {
        if (support::isWrite(frame) && --left == 0)
            bench.bench.stop().request();
    };
    const auto outcome = bench.restore(OnFailure::RollBack);
    QVERIFY(outcome && outcome->verdict == RestoreVerdict::RolledBack);
    QVERIFY(outcome->notPutBack.isEmpty());
    bench.mend();
    QCOMPARE(bench.notAsBefore(), QString());
}

void TestRestoreUndo::onlyTheWayBackIsOpen_data()
{
    aWayBackBrokenOffIsGoneToItsEnd_data();
}

/// A row that shows another value ends the restore as failed; only its way back is then owed.
void TestRestoreUndo::onlyTheWayBackIsOpen()
{
    QFETCH(const int, action);
    QFETCH(const int, before);
    UndoBench bench{Before(before)};
    constexpr std::uint8_t address = 21;
    int writes = 0;
    bench.bench.tap().onWrite = [&, pending = false](const base::Bytes& frame) mutable {
        if (std::exchange(pending, support::isWrite(frame) && frame[5] == address) && writes == 0) {
            bench.bench.poke(1, text("position_p"), 99);
            writes = 1;
        }
        // Locked, unlocked, the first row, and in the middle of the second it is cut.
        constexpr int secondRowBack = 5;
        if (writes > 0 && support::isWrite(frame) && ++writes == secondRowBack)
            bench.bench.cutLink();
    };
    const auto outcome = bench.restore(OnFailure::RollBack);
    bench.mend();
    QVERIFY(outcome && outcome->verdict == RestoreVerdict::Failed);
    const auto open = *bench.journal.open();
    QCOMPARE(open.size(), std::size_t(1));
    QCOMPARE(bench.journal.entries()->front().end->outcome, text("failed"));

    const auto ended = bench.recover(RecoverAction(action));
    QVERIFY(ended && ended->size() == 1);
    QVERIFY2(ended->front().done,
             ended->front().error ? qPrintable(base::errorName(ended->front().error->code)) : "");
    QVERIFY(!support::lockIsOpen(bench.bench));
    QVERIFY(bench.journal.open()->empty());
    for (const base::JournalItem& item : open.front().items) {
        const bool back = RecoverAction(action) == RecoverAction::Finish;
        QCOMPARE(bench.bench.raw(1, item.key), back ? item.newRaw : item.oldRaw);
    }
    QCOMPARE(bench.historyLies(), QString());
    if (RecoverAction(action) == RecoverAction::Finish)
        QCOMPARE(bench.notAsBefore(), QString());
}

void TestRestoreUndo::whatSomebodyWroteSinceIsLeftAlone_data()
{
    QTest::addColumn<int>("action");
    QTest::newRow("finish") << int(RecoverAction::Finish);
    QTest::newRow("undo") << int(RecoverAction::Undo);
}

/// The other rows are settled.
void TestRestoreUndo::whatSomebodyWroteSinceIsLeftAlone()
{
    QFETCH(int, action);
    UndoBench bench;
    bench.breakOff();
    const base::JournalItem missing = bench.nextMissing();
    device::Servo servo = support::wholeServo(bench.bench);
    const auto written =
        device::write(bench.context(), servo, {{missing.key, missing.newRaw + 1}}, {});
    QVERIFY(written && written->allGood());
    const auto open = *bench.journal.open();
    QCOMPARE(open.size(), std::size_t(1));
    const auto one = bench.recover(RecoverAction(action));
    QVERIFY(one && one->size() == 1 && one->front().done);
    QCOMPARE(one->front().before.replaced, QStringList{missing.key});
    QVERIFY(bench.journal.open()->empty());
    for (const base::JournalItem& item : open.front().items) {
        const bool back = RecoverAction(action) == RecoverAction::Undo;
        const std::int64_t settled = back ? item.oldRaw : item.newRaw;
        QCOMPARE(bench.bench.raw(1, item.key),
                 item.key == missing.key ? missing.newRaw + 1 : settled);
    }
}

void TestRestoreUndo::theLatestIsUndoneFirst()
{
    UndoBench bench;
    const device::Servo servo = support::wholeServo(bench.bench);
    const catalog::Register& reg = *servo.profile->find(text("position_p"));
    const std::int64_t before = bench.first.at(reg.key);
    base::Intent intent;
    intent.servo = servo.identity();
    for (const std::int64_t old : {before, before + 1}) {
        intent.items = {{reg.key, reg.address, old, old + 1}};
        QVERIFY(bench.journal.begin(intent));
    }
    support::pokeKept(bench.bench, reg.key, before + 2);
    const auto undone = bench.recover(RecoverAction::Undo);
    QVERIFY(undone && undone->size() == 2);
    QVERIFY(undone->front().done && undone->back().done);
    QCOMPARE(bench.notAsBefore(), QString());
}

/// Only the servo's own restore (0x06) has no new values, and leaves the history without them.
void TestRestoreUndo::aRowThatIsSoAlreadyIsNotForgotten()
{
    UndoBench bench;
    device::Servo servo = support::wholeServo(bench.bench);
    device::WriteOptions options;
    options.kind = base::IntentKind::Restore;
    const device::WriteItem so{text("position_p"), bench.first.at(text("position_p"))};
    QVERIFY(device::write(bench.context(), servo, {so, {text("max_torque"), 800}}, options));
    QCOMPARE(bench.historyLies(), QString());
    QVERIFY(device::write(bench.context(), servo, {so}, options));
    QCOMPARE(bench.historyLies(), QString());
}

/// Finishing is no way around the sheet.
void TestRestoreUndo::whatNobodyHeldIsRefused()
{
    UndoBench bench;
    device::Servo servo = support::wholeServo(bench.bench);
    base::Intent intent;
    intent.kind = base::IntentKind::Restore;
    intent.servo = servo.identity();
    const catalog::Register& reg = *servo.profile->find(text("max_torque"));
    intent.items = {{reg.key, reg.address, 900, 1023}};
    QVERIFY(bench.journal.begin(intent));
    bench.bench.forgetFrames();
    const auto refused = bench.recover(RecoverAction::Finish);
    QVERIFY(refused && refused->size() == 1 && !refused->front().done);
    QCOMPARE(refused->front().error->code, base::ErrorCode::OutOfRange);
    QVERIFY(bench.bench.onlyAsked());

    // Once it was found with that value, it may have it again.
    base::Intent earlier = intent;
    earlier.items = {{reg.key, reg.address, 1023, 900}};
    const auto uuid = bench.journal.begin(earlier);
    QVERIFY(uuid && bench.journal.end(*uuid, {text("done"), {}, {}}));
    const auto finished = bench.recover(RecoverAction::Finish);
    QVERIFY(finished && finished->size() == 1 && finished->front().done);
    QCOMPARE(bench.bench.raw(1, text("max_torque")), 1023);
}

QTEST_GUILESS_MAIN(TestRestoreUndo)
#include "tst_restore_undo.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes in the window: found by reading only, offered, never done unasked; finished,
// undone, forgotten or left for later, each by itself.
#include "gui/five_rows.h"
#include "gui/tasks_bench.h"
#include "session/paths.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "ui/app/event_words.h"
#include "ui/dialogs/intents_dialog.h"

#include <QAbstractItemModelTester>
#include <QRegularExpression>
#include <QTableView>

using gui::TasksBench;
using ui::Command;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

QTableView* table(QDialog* dialog)
{
    return dialog->findChild<QTableView*>(text("intents"));
}

QString cell(QDialog* dialog, int row, ui::IntentColumn column)
{
    const QAbstractItemModel* model = table(dialog)->model();
    return model->index(row, static_cast<int>(column)).data().toString();
}

/// The servo falls silent while its lock is open and the second of five registers is written.
bool interrupt(TasksBench& bench)
{
    bench.withWire([](sim::VirtualBus& wire) {
        wire.config().faults.muteWhen = gui::secondOfFiveRowsIsWritten;
    });
    bench.desk.write(bench.selection.current(), gui::fiveRows());
    const bool ended = bench.settled();
    bench.withWire([](sim::VirtualBus& wire) { wire.config().faults = {}; });
    return ended && bench.session.journal().open()->size() == 1;
}

/// As an earlier session left it: nothing of it was written.
QString leaveOpen(TasksBench& bench, const QString& port = {})
{
    base::Intent intent;
    intent.kind = base::IntentKind::Write;
    intent.lockOpened = true;
    intent.servo = bench.entry().servo.identity();
    if (!port.isEmpty())
        intent.servo.port = port;
    const auto before = bench.entry().servo.raw(text("max_temperature")).value_or(0);
    intent.items = {{text("max_temperature"), 13, before, 61}};
    return bench.session.journal().begin(intent).value_or(QString());
}
/// Closing the window would ask nothing.
bool nothingUnfinished(TasksBench& bench)
{
    std::optional<session::UnfinishedWrites> unfinished;
    QObject::connect(&bench.desk, &session::Desk::unfinishedFound, &bench.window,
                     [&](const session::UnfinishedWrites& found) { unfinished = found; });
    bench.desk.findUnfinished();
    const bool told = QTest::qWaitFor([&] { return unfinished.has_value(); }, 20000);
    return told && unfinished->ids.empty() && unfinished->unlocked.empty();
}
} // namespace

class TestIntentsDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void aCutWriteIsOfferedAndUndone();
    void aCutWriteIsFinished();
    void aServoIsFollowed_data();
    void aServoIsFollowed();
    void aServoThatHasMovedAlreadyIsFollowed_data() { aServoIsFollowed_data(); }
    void aServoThatHasMovedAlreadyIsFollowed();
    void isOfferedAfterTheFirstSearch();
    void laterIsNotAskedTwice();
    void forgettingAsksFirst();
    void theOneChosenIsSettledAlone();
    void aTrialIsPutBackAndSaysSo();
    void undoTakesBackAllOfAFinishedWrite();
    void nobodyThereCannotBeSettled();
    void nothingOpenSaysSo();
    void anotherPortIsNamedAtTheFirstConnection();
    void anAdapterUnderAnotherNameIsLookedAt();
    void aPortThatIsThereIsNotLookedForHere();
    void whatIsUnderWayElsewhereIsLeftToIt();
    void aSettlementThatBreaksOffSaysWhy_data();
    void aSettlementThatBreaksOffSaysWhy();
    void whatCouldNotBeRecordedIsSaid();
    void theMarkOfARestartIsPutBack();
    void whatHasAnotherValueStaysAndIsSaid();
    void anotherServoIsNotCalledDone();
};

void TestIntentsDialog::aCutWriteIsOfferedAndUndone()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    const std::int64_t before = bench.raw(1, "min_angle_limit");
    QVERIFY(interrupt(bench));
    QCOMPARE(bench.raw(1, "lock"), 0);
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QAbstractItemModelTester tester(table(dialog)->model());
    QCOMPARE(table(dialog)->model()->rowCount(), 1);
    QVERIFY(cell(dialog, 0, ui::IntentColumn::Servo).contains(text("STS3215")));
    QVERIFY(cell(dialog, 0, ui::IntentColumn::Change).contains(text("500")));
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Lock), text("open"));
    QCOMPARE(bench.raw(1, "lock"), 0); // looking wrote nothing
    gui::click(dialog, "intentUndo");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 0);
    QCOMPARE(bench.raw(1, "min_angle_limit"), before);
    QCOMPARE(bench.raw(1, "lock"), 1);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestIntentsDialog::aCutWriteIsFinished()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(interrupt(bench));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QTest::keyClick(gui::button(dialog, "intentFinish"), Qt::Key_Space);
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(bench.session.journal().open()->empty());
    QCOMPARE(bench.raw(1, "overload_torque"), 70);
    QCOMPARE(bench.raw(1, "lock"), 1);
    // The table follows by itself.
    QTRY_COMPARE(bench.entry().servo.raw(text("overload_torque")), std::optional<std::int64_t>(70));
}

void TestIntentsDialog::aServoIsFollowed_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("baud");
    QTest::newRow("new ID") << int(base::IntentKind::SetId) << text("id") << 9 << 9 << 1'000'000;
    QTest::newRow("new rate") << int(base::IntentKind::SetBaud) << text("baud_rate") << 1 << 1
                              << 500'000;
}

/// Finishing a change of ID or rate takes the servo elsewhere; it stays selected.
void TestIntentsDialog::aServoIsFollowed()
{
    QFETCH(int, kind);
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(int, id);
    QFETCH(int, baud);
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind(kind);
    intent.servo = bench.entry().servo.identity();
    intent.items = {{key, 5, bench.raw(1, key.toLatin1().constData()), value}};
    QVERIFY(bench.session.journal().begin(intent));
    const session::ServoRef ref = bench.selection.current();
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QVERIFY(bench.settled());
    QCOMPARE(bench.selection.current(), ref);
    QCOMPARE(bench.entry().servo.id, id);
    QCOMPARE(bench.entry().servo.baud, baud);
    QVERIFY(!bench.entry().readError);
}

/// The cable was cut right after the write of the ID or the rate, with the lock open.
void TestIntentsDialog::aServoThatHasMovedAlreadyIsFollowed()
{
    QFETCH(int, kind);
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(int, id);
    QFETCH(int, baud);
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    const session::ServoRef ref = bench.selection.current();
    base::Intent intent;
    intent.kind = base::IntentKind(kind);
    intent.lockOpened = true;
    intent.servo = bench.entry().servo.identity();
    intent.items = {{key, 5, bench.raw(1, key.toLatin1().constData()), value}};
    QVERIFY(bench.session.journal().begin(intent));
    bench.withWire([&](sim::VirtualBus& wire) {
        sim::VirtualServo* servo = wire.servo(1);
        servo->poke(text("lock"), 0);
        servo->poke(key, value);
    });
    bench.desk.readTable(ref);
    bench.desk.loadHistory(ref);
    QVERIFY(bench.settled());
    QTRY_VERIFY(bench.entry().silent && bench.entry().lockOpenedByUs);
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(id, "lock"), 1);
    QCOMPARE(bench.desk.servos(), std::vector{ref});
    QCOMPARE(bench.entry().servo.id, id);
    QCOMPARE(bench.entry().servo.baud, baud);
    QTRY_VERIFY(!bench.entry().silent && !bench.entry().lockOpenedByUs);
    QTRY_COMPARE(bench.entry().lockOpen(), std::optional(false));
    QVERIFY(nothingUnfinished(bench));
}

void TestIntentsDialog::isOfferedAfterTheFirstSearch()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    const std::int64_t before = bench.raw(1, "max_temperature");
    QVERIFY(!leaveOpen(bench).isEmpty());
    bench.desk.disconnectFrom();
    QTRY_COMPARE(bench.desk.state(), session::LinkState::Off);
    QVERIFY(bench.connectTo("sim:sts3215@1"));
    QVERIFY(bench.search(1, 1));
    QDialog* dialog = bench.dialog("intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("the old values"));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "max_temperature"), before);
    QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
}

void TestIntentsDialog::laterIsNotAskedTwice()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpen(bench).isEmpty());
    QPointer<QDialog> dialog(bench.open(Command::OpenIntents, "intentsDialog"));
    QVERIFY(dialog);
    gui::click(dialog, "intentLater");
    QTRY_VERIFY(!dialog);
    QSignalSpy found(&bench.desk, &session::Desk::openIntents);
    bench.desk.lookForIntents(); // nobody's wish: as after another search
    QVERIFY(found.wait());
    QCOMPARE(bench.window.findChildren<QDialog*>().size(), 0);
    QVERIFY(bench.open(Command::OpenIntents, "intentsDialog"));
}

void TestIntentsDialog::forgettingAsksFirst()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpen(bench).isEmpty());
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentForget");
    QDialog* question = bench.dialog("question");
    QVERIFY(question);
    QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
    gui::click(question, "questionYes");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 0);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestIntentsDialog::theOneChosenIsSettledAlone()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    const QString first = leaveOpen(bench);
    const QString second = leaveOpen(bench);
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 2);
    table(dialog)->selectRow(1);
    gui::click(dialog, "intentUndo");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    const auto open = bench.session.journal().open();
    QCOMPARE(open->size(), std::size_t(1));
    QCOMPARE(open->front().uuid, first);
    QVERIFY(second != first);
}

/// Finishing a test's settings puts them back: no word of a change that was finished.
void TestIntentsDialog::aTrialIsPutBackAndSaysSo()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind::Trial;
    intent.temporary = true;
    intent.servo = bench.entry().servo.identity();
    const std::int64_t before = bench.raw(1, "position_p");
    intent.items = {{text("position_p"), 21, before, before + 28}};
    QVERIFY(bench.session.journal().begin(intent));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("the old values"));
    QCOMPARE(gui::button(dialog, "intentFinish")->text(), text("Put back"));
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).contains(text("settings from before the test")));
    QVERIFY(!gui::resultOf(dialog).contains(text("finished")));
    QCOMPARE(bench.raw(1, "position_p"), before);
    QVERIFY(bench.session.journal().open()->empty());
}

/// Of an interrupted write what had been changed in this session would be undone alone, and leave a
/// mixture behind.
void TestIntentsDialog::undoTakesBackAllOfAFinishedWrite()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(interrupt(bench));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(bench.desk.nextUndo() != nullptr);
    QCOMPARE(bench.desk.nextUndo()->before.size(), std::size_t(5));
    QVERIFY(bench.settled());
    bench.desk.undo();
    QVERIFY(bench.settled());
    QTRY_COMPARE(bench.raw(1, "overload_torque"), 80);
    QCOMPARE(bench.raw(1, "max_temperature"), 70);
    QCOMPARE(bench.raw(1, "min_angle_limit"), 0);
    QVERIFY(bench.desk.nextUndo() == nullptr); // nothing of it is left over
}

void TestIntentsDialog::nobodyThereCannotBeSettled()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpen(bench).isEmpty());
    bench.withWire([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("it does not answer"));
    QVERIFY(!gui::button(dialog, "intentFinish")->isEnabled());
    QVERIFY(!gui::button(dialog, "intentUndo")->isEnabled());
    QVERIFY(gui::button(dialog, "intentForget")->isEnabled());
}

void TestIntentsDialog::nothingOpenSaysSo()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(text("No change was left open")));
    QVERIFY(!gui::textOf(dialog, "explanation").contains(text("Choose what to do")));
    QCOMPARE(gui::button(dialog, "intentLater")->text(), text("Close"));
    QVERIFY(!gui::button(dialog, "intentForget")->isEnabled());
}

void TestIntentsDialog::anotherPortIsNamedAtTheFirstConnection()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpen(bench, text("/dev/ttyUSB7")).isEmpty());
    bench.desk.disconnectFrom();
    QTRY_COMPARE(bench.desk.state(), session::LinkState::Off);
    QVERIFY(bench.connectTo("sim:sts3215@1"));
    QVERIFY(bench.search(1, 1));
    QDialog* dialog = bench.dialog("intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    const QString named = gui::textOf(dialog, "intentsElsewhere");
    QVERIFY2(named.contains(text("/dev/ttyUSB7")), qPrintable(named));
    QVERIFY2(named.contains(text("STS3215")), qPrintable(named));
    QVERIFY(!gui::resultOf(dialog).contains(text("No change was left open")));
    // A simulated servo is never the one that was left.
    QVERIFY(!gui::button(dialog, "intentsLookHere")->isVisible());
}

void TestIntentsDialog::anAdapterUnderAnotherNameIsLookedAt()
{
    TasksBench bench;
    support::SimProgram sim({text("--servos"), text("sts3215@1")});
    QVERIFY(bench.connectTo(sim.port()) && bench.search(1, 1) && bench.choose(1));
    QVERIFY(!leaveOpen(bench, text("/dev/ttyUSB7")).isEmpty());
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    gui::click(dialog, "intentsLookHere");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("the old values"));
    QVERIFY(gui::textOf(dialog, "intentsElsewhere").isEmpty());
    table(dialog)->selectRow(0);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(bench.session.journal().open()->empty());
}

/// Its own servo may still be connected there; what answers here may be its twin.
void TestIntentsDialog::aPortThatIsThereIsNotLookedForHere()
{
    TasksBench bench;
    support::SimProgram other({text("--servos"), text("sts3215@1")});
    support::SimProgram sim({text("--servos"), text("sts3215@1")});
    QVERIFY(bench.connectTo(sim.port()) && bench.search(1, 1) && bench.choose(1));
    QVERIFY(!leaveOpen(bench, other.port()).isEmpty());
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    const QString named = gui::textOf(dialog, "intentsElsewhere");
    QVERIFY2(named.contains(text("Connect to that port")) && named.contains(other.port()),
             qPrintable(named));
    QVERIFY(!gui::button(dialog, "intentsLookHere")->isVisible());
    QSignalSpy found(&bench.desk, &session::Desk::openIntents);
    bench.desk.lookForIntents(true);
    QTRY_COMPARE(found.size(), 1);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
}

void TestIntentsDialog::whatIsUnderWayElsewhereIsLeftToIt()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    auto other = std::make_unique<record::HistoryJournal>(session::historyFile(), text("other"));
    base::Intent intent;
    intent.servo = bench.entry().servo.identity();
    const auto before = bench.entry().servo.raw(text("max_temperature")).value_or(0);
    intent.items = {{text("max_temperature"), 13, before, 61}};
    const auto uuid = other->begin(intent);
    QVERIFY(uuid);
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("still under way in another program"));
    const auto explanation = [&] { return gui::textOf(dialog, "explanation"); };
    QVERIFY2(explanation().contains(text("still running")), qPrintable(explanation()));
    QVERIFY2(!explanation().contains(text("cable")), qPrintable(explanation()));
    for (const char* name : {"intentFinish", "intentUndo", "intentForget"})
        QVERIFY2(!gui::button(dialog, name)->isEnabled(), name);
    bench.desk.forgetIntent(*uuid);
    QVERIFY(bench.settled());
    QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
    other.reset(); // as if it had been killed
    bench.desk.lookForIntents();
    QTRY_COMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("the old values"));
    QVERIFY(gui::button(dialog, "intentUndo")->isEnabled());
    QVERIFY2(explanation().contains(text("a cable was pulled")), qPrintable(explanation()));
}

void TestIntentsDialog::aSettlementThatBreaksOffSaysWhy_data()
{
    QTest::addColumn<bool>("cut"); ///< after the second of five values; or: a test is running
    QTest::newRow("cable cut") << true;
    QTest::newRow("test running") << false;
}

/// Not that nothing was written, and a list that could not be read is not an empty one.
void TestIntentsDialog::aSettlementThatBreaksOffSaysWhy()
{
    QFETCH(bool, cut);
    support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
    support::CutCable cable(simulator.port(), false);
    TasksBench bench;
    QVERIFY(bench.ready(qPrintable(cable.port()), 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind::Write;
    intent.servo = bench.entry().servo.identity();
    for (const device::WriteItem& item : gui::fiveRows().items) {
        const catalog::Register* reg = bench.entry().servo.profile->find(item.key);
        intent.items.push_back(
            {item.key, reg->offset, bench.entry().servo.raw(*reg).value_or(0), item.raw});
    }
    const auto uuid = bench.session.journal().begin(intent);
    QVERIFY(uuid);
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    const auto offered = [&] { // a busy machine may make the servo's answers late
        if (!bench.desk.busy() && !gui::button(dialog, "intentFinish")->isEnabled())
            bench.desk.lookForIntents();
        return !bench.desk.busy() && gui::button(dialog, "intentFinish")->isEnabled();
    };
    QTRY_VERIFY_WITH_TIMEOUT(offered(), 30'000);
    constexpr int unlockAndTwo = 3;
    const int before = cable.writes();
    if (cut) {
        cable.cutAtWrite(unlockAndTwo + 1);
    } else {
        session::Task test;
        test.name = text("sweep");
        test.lasting = true;
        test.work = [](session::TaskContext& context) -> base::Result<void> {
            while (!context.stop.requested())
                QThread::msleep(5);
            return {};
        };
        bench.desk.perform(bench.selection.current(), test);
        QTRY_VERIFY(bench.desk.testing());
    }
    QSignalSpy found(&bench.desk, &session::Desk::openIntents);
    gui::click(dialog, "intentFinish");
    const auto working = [&] { return gui::resultOf(dialog).contains(text("Working")); };
    QTRY_VERIFY_WITH_TIMEOUT(!working(), 60'000);
    bench.desk.stopTest();
    QVERIFY(bench.settled());
    const QString said = gui::resultOf(dialog);
    QVERIFY2(said.startsWith(QStringLiteral("✗")), qPrintable(said));
    QVERIFY2(!said.contains(text("Nothing was written")), qPrintable(said));
    QVERIFY2(said.contains(text("stays open")), qPrintable(said));
    QCOMPARE(cable.writes() - before >= unlockAndTwo, cut);
    QCOMPARE(found.size(), 0);
    QCOMPARE(table(dialog)->model()->rowCount(), 1);
    const auto open = bench.session.journal().open();
    QVERIFY(std::any_of(open->begin(), open->end(),
                        [&](const base::Intent& one) { return one.uuid == *uuid; }));
}

void TestIntentsDialog::whatCouldNotBeRecordedIsSaid()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    session::Event event;
    event.kind = session::Event::Kind::Written;
    event.servo = bench.selection.current();
    event.report.emplace();
    event.report->id = 1;
    event.report->writes = {{text("position_p"), 21, 32, 20, 20, device::WriteOutcome::Kept, {}}};
    event.notices = {{base::NoticeCode::NotRecorded, 1, text("history.sqlite: disk full")}};
    const ui::EventWords words = ui::describe(event, bench.desk);
    QVERIFY2(words.line.contains(text("20, kept")), qPrintable(words.line));
    QVERIFY2(words.line.contains(text("NOT RECORDED")), qPrintable(words.line));
    QVERIFY(words.more.join(QLatin1Char('\n')).contains(text("disk full")));
}

namespace {
/// The mark of a restart, as a program that was killed in between has left it.
bool leaveMark(TasksBench& bench, std::int64_t standing)
{
    base::Intent intent;
    intent.kind = base::IntentKind::Trial;
    intent.temporary = true;
    intent.servo = bench.entry().servo.identity();
    intent.items = {{text("torque_limit"), 48, 1000, 999}};
    bench.withWire(
        [standing](sim::VirtualBus& wire) { wire.servo(1)->poke(text("torque_limit"), standing); });
    return bench.session.journal().begin(intent).has_value();
}
} // namespace

void TestIntentsDialog::theMarkOfARestartIsPutBack()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(leaveMark(bench, 999));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("the new values"));
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).contains(text("have been put back")));
    QCOMPARE(bench.raw(1, "torque_limit"), 1000);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestIntentsDialog::whatHasAnotherValueStaysAndIsSaid()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(leaveMark(bench, 700));
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), text("other values since, which stay"));
    gui::click(dialog, "intentUndo");
    QTRY_VERIFY(gui::resultOf(dialog).contains(text("Nothing was written")));
    QVERIFY2(gui::resultOf(dialog).contains(text("Torque limit")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(bench.raw(1, "torque_limit"), 700);
    QVERIFY(bench.session.journal().open()->empty());
}

/// Exchanged while the list is open: nothing is written, and the status line says no other thing.
void TestIntentsDialog::anotherServoIsNotCalledDone()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1,sts3250@7", 1, 7, 1));
    QVERIFY(!leaveOpen(bench).isEmpty());
    QDialog* dialog = bench.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    bench.withWire([](sim::VirtualBus& wire) {
        wire.servo(1)->poke(text("id"), 20);
        wire.servo(7)->poke(text("id"), 1);
    });
    std::optional<session::Event> task;
    connect(&bench.desk, &session::Desk::happened, dialog, [&task](const session::Event& event) {
        if (event.kind == session::Event::Kind::Task && event.task == text("recover"))
            task = event;
    });
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(task);
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✗")));
    const ui::EventWords words = ui::describe(*task, bench.desk);
    QCOMPARE(words.sign, QStringLiteral("✗"));
    QVERIFY2(!words.line.contains(text("done")), qPrintable(words.line));
    QCOMPARE(bench.session.journal().open()->size(), std::size_t(1));
}

QTEST_MAIN(TestIntentsDialog)
#include "tst_intents_dialog.moc"

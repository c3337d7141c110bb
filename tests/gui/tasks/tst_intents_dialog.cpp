// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes in the window: found by reading only, offered, never done without a request;
// finished, undone, forgotten or left for later, each by itself.
#include "gui/five_register_write.h"
#include "gui/servo_tasks_fixture.h"
#include "session/paths.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/real_time.h"
#include "support/test_main.h"
#include "support/text.h"
#include "ui/app/event_text.h"
#include "ui/tasks/intents_dialog.h"

#include <QAbstractItemModelTester>
#include <QRegularExpression>
#include <QTableView>

using gui::ServoTasksFixture;
using support::utf8;
using ui::Command;

namespace {
QTableView* table(QDialog* dialog)
{
    return dialog->findChild<QTableView*>(utf8("intents"));
}

QString cell(QDialog* dialog, int row, ui::IntentColumn column)
{
    const QAbstractItemModel* model = table(dialog)->model();
    return model->index(row, static_cast<int>(column)).data().toString();
}

/// The servo falls silent while its lock is open and the second of five registers is written.
bool interrupt(ServoTasksFixture& fixture)
{
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.config().faults.muteWhen = gui::isSecondRegisterWritten;
    });
    fixture.workbench.writes().write(fixture.selection.current(), gui::fiveRegisterWrite());
    const bool ended = fixture.waitUntilIdle();
    fixture.withBus([](sim::VirtualBus& wire) { wire.config().faults = {}; });
    return ended && fixture.session.journal().open()->size() == 1;
}

/// As an earlier session left it: nothing of it was written.
QString leaveOpenIntent(ServoTasksFixture& fixture, const QString& port = {})
{
    base::Intent intent;
    intent.kind = base::IntentKind::Write;
    intent.lockOpened = true;
    intent.servo = fixture.entry().servo.identity();
    if (!port.isEmpty())
        intent.servo.port = port;
    const auto before = fixture.entry().servo.raw(utf8("max_temperature")).value_or(0);
    intent.items = {{utf8("max_temperature"), 13, before, 61}};
    return fixture.session.journal().begin(intent).value_or(QString());
}
/// Closing the window would ask nothing.
bool hasNoOpenWrites(ServoTasksFixture& fixture)
{
    std::optional<session::OpenWrites> unfinished;
    QObject::connect(&fixture.workbench.closing(), &session::CloseSequence::openWritesFound,
                     &fixture.window,
                     [&](const session::OpenWrites& found) { unfinished = found; });
    fixture.workbench.closing().findOpenWrites();
    const bool detected = support::waitFor([&] { return unfinished.has_value(); });
    return detected && unfinished->ids.empty() && unfinished->unlocked.empty();
}
} // namespace

class TestIntentsDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void anInterruptedWriteIsOfferedAndUndone();
    void anInterruptedWriteIsFinished();
    void aRenumberedServoIsFollowed_data();
    void aRenumberedServoIsFollowed();
    void aServoAlreadyAtItsNewIdIsFollowed_data() { aRenumberedServoIsFollowed_data(); }
    void aServoAlreadyAtItsNewIdIsFollowed();
    void isOfferedAfterTheFirstSearch();
    void laterSuppressesTheQuestion();
    void discardingAsksFirst();
    void onlyTheSelectedIntentIsRecovered();
    void aTrialIsRevertedAndReported();
    void undoRevertsAllOfAFinishedWrite();
    void missingServoCannotBeRecovered();
    void emptyListShowsAMessage();
    void anotherPortIsReportedOnTheFirstConnection();
    void anAdapterUnderAnotherNameIsChecked();
    void aPresentPortIsNotCheckedHere();
    void intentsInProgressElsewhereAreSkipped();
    void anInterruptedRecoveryReportsWhy_data();
    void anInterruptedRecoveryReportsWhy();
    void unrecordedResultIsReported();
    void theRestartMarkIsRestored();
    void otherValuesAreKeptAndReported();
    void anotherServoIsNotReportedDone();
};

void TestIntentsDialog::anInterruptedWriteIsOfferedAndUndone()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    const std::int64_t before = fixture.raw(1, "min_angle_limit");
    QVERIFY(interrupt(fixture));
    QCOMPARE(fixture.raw(1, "lock"), 0);
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QAbstractItemModelTester tester(table(dialog)->model());
    QCOMPARE(table(dialog)->model()->rowCount(), 1);
    QVERIFY(cell(dialog, 0, ui::IntentColumn::Servo).contains(utf8("STS3215")));
    QVERIFY(cell(dialog, 0, ui::IntentColumn::Change).contains(utf8("500")));
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Lock), utf8("unlocked"));
    QCOMPARE(fixture.raw(1, "lock"), 0); // looking wrote nothing
    gui::click(dialog, "intentUndo");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 0);
    QCOMPARE(fixture.raw(1, "min_angle_limit"), before);
    QCOMPARE(fixture.raw(1, "lock"), 1);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestIntentsDialog::anInterruptedWriteIsFinished()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(interrupt(fixture));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QTest::keyClick(gui::button(dialog, "intentFinish"), Qt::Key_Space);
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(fixture.session.journal().open()->empty());
    QCOMPARE(fixture.raw(1, "overload_torque"), 70);
    QCOMPARE(fixture.raw(1, "lock"), 1);
    // The table follows by itself.
    QTRY_COMPARE(fixture.entry().servo.raw(utf8("overload_torque")),
                 std::optional<std::int64_t>(70));
}

void TestIntentsDialog::aRenumberedServoIsFollowed_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("baud");
    QTest::newRow("new ID") << int(base::IntentKind::SetId) << utf8("id") << 9 << 9 << 1'000'000;
    QTest::newRow("new rate") << int(base::IntentKind::SetBaud) << utf8("baud_rate") << 1 << 1
                              << 500'000;
}

/// Finishing a change of ID or rate takes the servo elsewhere; it stays selected.
void TestIntentsDialog::aRenumberedServoIsFollowed()
{
    QFETCH(int, kind);
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(int, id);
    QFETCH(int, baud);
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind(kind);
    intent.servo = fixture.entry().servo.identity();
    intent.items = {{key, 5, fixture.raw(1, key.toLatin1().constData()), value}};
    QVERIFY(fixture.session.journal().begin(intent));
    const session::ServoRef ref = fixture.selection.current();
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.selection.current(), ref);
    QCOMPARE(fixture.entry().servo.id, id);
    QCOMPARE(fixture.entry().servo.baud, baud);
    QVERIFY(!fixture.entry().readError);
}

/// The cable was cut right after the write of the ID or the rate, with the lock open.
void TestIntentsDialog::aServoAlreadyAtItsNewIdIsFollowed()
{
    QFETCH(int, kind);
    QFETCH(QString, key);
    QFETCH(int, value);
    QFETCH(int, id);
    QFETCH(int, baud);
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    const session::ServoRef ref = fixture.selection.current();
    base::Intent intent;
    intent.kind = base::IntentKind(kind);
    intent.lockOpened = true;
    intent.servo = fixture.entry().servo.identity();
    intent.items = {{key, 5, fixture.raw(1, key.toLatin1().constData()), value}};
    QVERIFY(fixture.session.journal().begin(intent));
    fixture.withBus([&](sim::VirtualBus& wire) {
        sim::VirtualServo* servo = wire.servo(1);
        servo->poke(utf8("lock"), 0);
        servo->poke(key, value);
    });
    fixture.workbench.writes().readTable(ref);
    fixture.workbench.writes().loadHistory(ref);
    QVERIFY(fixture.waitUntilIdle());
    QTRY_VERIFY(fixture.entry().silent && fixture.entry().lockOpenedByUs);
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(id, "lock"), 1);
    QCOMPARE(fixture.workbench.registry().order(), std::vector{ref});
    QCOMPARE(fixture.entry().servo.id, id);
    QCOMPARE(fixture.entry().servo.baud, baud);
    QTRY_VERIFY(!fixture.entry().silent && !fixture.entry().lockOpenedByUs);
    QTRY_COMPARE(fixture.entry().isLockOpen(), std::optional(false));
    QVERIFY(hasNoOpenWrites(fixture));
}

void TestIntentsDialog::isOfferedAfterTheFirstSearch()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    const std::int64_t before = fixture.raw(1, "max_temperature");
    QVERIFY(!leaveOpenIntent(fixture).isEmpty());
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QVERIFY(fixture.connectTo("sim:sts3215@1"));
    QVERIFY(fixture.search(1, 1));
    QDialog* dialog = fixture.dialog("intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("the old values"));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "max_temperature"), before);
    QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
}

void TestIntentsDialog::laterSuppressesTheQuestion()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpenIntent(fixture).isEmpty());
    QPointer<QDialog> dialog(fixture.open(Command::OpenIntents, "intentsDialog"));
    QVERIFY(dialog);
    gui::click(dialog, "intentLater");
    QTRY_VERIFY(!dialog);
    QSignalSpy found(&fixture.workbench.recovery(), &session::RecoveryService::openIntentsFound);
    fixture.workbench.recovery().findOpenIntents(); // without a request: as after another search
    QVERIFY(found.wait());
    QCOMPARE(fixture.window.findChildren<QDialog*>().size(), 0);
    QVERIFY(fixture.open(Command::OpenIntents, "intentsDialog"));
}

void TestIntentsDialog::discardingAsksFirst()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpenIntent(fixture).isEmpty());
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentForget");
    QDialog* question = fixture.dialog("question");
    QVERIFY(question);
    QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
    gui::click(question, "questionYes");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 0);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestIntentsDialog::onlyTheSelectedIntentIsRecovered()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    const QString first = leaveOpenIntent(fixture);
    const QString second = leaveOpenIntent(fixture);
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 2);
    table(dialog)->selectRow(1);
    gui::click(dialog, "intentUndo");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    const auto open = fixture.session.journal().open();
    QCOMPARE(open->size(), std::size_t(1));
    QCOMPARE(open->front().uuid, first);
    QVERIFY(second != first);
}

/// Finishing the settings of a test restores them: the result does not claim a finished change.
void TestIntentsDialog::aTrialIsRevertedAndReported()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind::Trial;
    intent.temporary = true;
    intent.servo = fixture.entry().servo.identity();
    const std::int64_t before = fixture.raw(1, "position_p");
    intent.items = {{utf8("position_p"), 21, before, before + 28}};
    QVERIFY(fixture.session.journal().begin(intent));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("the old values"));
    QCOMPARE(gui::button(dialog, "intentFinish")->text(), utf8("Restore"));
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).contains(utf8("settings from before the test")));
    QVERIFY(!gui::resultOf(dialog).contains(utf8("finished")));
    QCOMPARE(fixture.raw(1, "position_p"), before);
    QVERIFY(fixture.session.journal().open()->empty());
}

/// Of an interrupted write what had been changed in this session would be undone alone, and leave a
/// mixture behind.
void TestIntentsDialog::undoRevertsAllOfAFinishedWrite()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(interrupt(fixture));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(fixture.workbench.writes().undoStep() != nullptr);
    QCOMPARE(fixture.workbench.writes().undoStep()->oldItems.size(), std::size_t(5));
    QVERIFY(fixture.waitUntilIdle());
    fixture.workbench.writes().undo();
    QVERIFY(fixture.waitUntilIdle());
    QTRY_COMPARE(fixture.raw(1, "overload_torque"), 80);
    QCOMPARE(fixture.raw(1, "max_temperature"), 70);
    QCOMPARE(fixture.raw(1, "min_angle_limit"), 0);
    QVERIFY(fixture.workbench.writes().undoStep() == nullptr); // nothing of it is left over
}

void TestIntentsDialog::missingServoCannotBeRecovered()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpenIntent(fixture).isEmpty());
    fixture.withBus([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("no reply"));
    QVERIFY(!gui::button(dialog, "intentFinish")->isEnabled());
    QVERIFY(!gui::button(dialog, "intentUndo")->isEnabled());
    QVERIFY(gui::button(dialog, "intentForget")->isEnabled());
}

void TestIntentsDialog::emptyListShowsAMessage()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(utf8("No unfinished changes")));
    QVERIFY(!gui::textOf(dialog, "explanation").contains(utf8("Choose what to do")));
    QCOMPARE(gui::button(dialog, "intentLater")->text(), utf8("Close"));
    QVERIFY(!gui::button(dialog, "intentForget")->isEnabled());
}

void TestIntentsDialog::anotherPortIsReportedOnTheFirstConnection()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(!leaveOpenIntent(fixture, utf8("/dev/ttyUSB7")).isEmpty());
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QVERIFY(fixture.connectTo("sim:sts3215@1"));
    QVERIFY(fixture.search(1, 1));
    QDialog* dialog = fixture.dialog("intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    const QString named = gui::textOf(dialog, "intentsElsewhere");
    QVERIFY2(named.contains(utf8("/dev/ttyUSB7")), qPrintable(named));
    QVERIFY2(named.contains(utf8("STS3215")), qPrintable(named));
    QVERIFY(!gui::resultOf(dialog).contains(utf8("No unfinished changes")));
    // A simulated servo is never the one with the interrupted change.
    QVERIFY(!gui::button(dialog, "intentsLookHere")->isVisible());
}

void TestIntentsDialog::anAdapterUnderAnotherNameIsChecked()
{
    const support::RealTime realTime; // no simulated port
    ServoTasksFixture fixture;
    support::SimProgram sim({utf8("--servos"), utf8("sts3215@1")});
    QVERIFY(fixture.connectTo(sim.port()) && fixture.search(1, 1) && fixture.choose(1));
    QVERIFY(!leaveOpenIntent(fixture, utf8("/dev/ttyUSB7")).isEmpty());
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    gui::click(dialog, "intentsLookHere");
    QTRY_COMPARE(table(dialog)->model()->rowCount(), 1);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("the old values"));
    QVERIFY(gui::textOf(dialog, "intentsElsewhere").isEmpty());
    table(dialog)->selectRow(0);
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✓")));
    QTRY_VERIFY(fixture.session.journal().open()->empty());
}

/// The servo itself may still be connected there; the one here may be an identical one.
void TestIntentsDialog::aPresentPortIsNotCheckedHere()
{
    const support::RealTime realTime; // no simulated port
    ServoTasksFixture fixture;
    support::SimProgram other({utf8("--servos"), utf8("sts3215@1")});
    support::SimProgram sim({utf8("--servos"), utf8("sts3215@1")});
    QVERIFY(fixture.connectTo(sim.port()) && fixture.search(1, 1) && fixture.choose(1));
    QVERIFY(!leaveOpenIntent(fixture, other.port()).isEmpty());
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    const QString named = gui::textOf(dialog, "intentsElsewhere");
    QVERIFY2(named.contains(utf8("connect to its port")) && named.contains(other.port()),
             qPrintable(named));
    QVERIFY(!gui::button(dialog, "intentsLookHere")->isVisible());
    QSignalSpy found(&fixture.workbench.recovery(), &session::RecoveryService::openIntentsFound);
    fixture.workbench.recovery().findOpenIntents(true);
    QTRY_COMPARE(found.size(), 1);
    QCOMPARE(table(dialog)->model()->rowCount(), 0);
    QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
}

void TestIntentsDialog::intentsInProgressElsewhereAreSkipped()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    auto other = std::make_unique<history::HistoryJournal>(session::historyFile(), utf8("other"));
    base::Intent intent;
    intent.servo = fixture.entry().servo.identity();
    const auto before = fixture.entry().servo.raw(utf8("max_temperature")).value_or(0);
    intent.items = {{utf8("max_temperature"), 13, before, 61}};
    const auto uuid = other->begin(intent);
    QVERIFY(uuid);
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found),
             utf8("still in progress in another program"));
    const auto explanation = [&] { return gui::textOf(dialog, "explanation"); };
    QVERIFY2(explanation().contains(utf8("Another program is still making")),
             qPrintable(explanation()));
    QVERIFY2(!explanation().contains(utf8("cable")), qPrintable(explanation()));
    for (const char* name : {"intentFinish", "intentUndo", "intentForget"})
        QVERIFY2(!gui::button(dialog, name)->isEnabled(), name);
    fixture.workbench.recovery().discardIntent(*uuid);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
    other.reset(); // as if it had been killed
    fixture.workbench.recovery().findOpenIntents();
    QTRY_COMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("the old values"));
    QVERIFY(gui::button(dialog, "intentUndo")->isEnabled());
    QVERIFY2(explanation().contains(utf8("a cable was pulled")), qPrintable(explanation()));
}

void TestIntentsDialog::anInterruptedRecoveryReportsWhy_data()
{
    QTest::addColumn<bool>("cut"); ///< after the second of five values; or: a test is running
    QTest::newRow("cable cut") << true;
    QTest::newRow("test running") << false;
}

/// Not that nothing was written, and a list that could not be read is not an empty one.
void TestIntentsDialog::anInterruptedRecoveryReportsWhy()
{
    QFETCH(bool, cut);
    const support::RealTime realTime; // no simulated port
    support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
    support::CutCable cable(simulator.port(), false);
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready(qPrintable(cable.port()), 1, 1, 1));
    base::Intent intent;
    intent.kind = base::IntentKind::Write;
    intent.servo = fixture.entry().servo.identity();
    for (const device::WriteItem& item : gui::fiveRegisterWrite().items) {
        const catalog::Register* reg = fixture.entry().servo.profile->find(item.key);
        intent.items.push_back(
            {item.key, reg->offset, fixture.entry().servo.raw(*reg).value_or(0), item.raw});
    }
    const auto uuid = fixture.session.journal().begin(intent);
    QVERIFY(uuid);
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    const auto offered = [&] { // a busy machine may make the servo's answers late
        if (!fixture.workbench.tasks().isBusy() &&
            !gui::button(dialog, "intentFinish")->isEnabled())
            fixture.workbench.recovery().findOpenIntents();
        return !fixture.workbench.tasks().isBusy() &&
               gui::button(dialog, "intentFinish")->isEnabled();
    };
    QTRY_VERIFY(offered());
    constexpr int framesUntilThirdRow = 3;
    const int before = cable.writes();
    if (cut) {
        cable.cutAtWrite(framesUntilThirdRow + 1);
    } else {
        session::Task test;
        test.name = utf8("sweep");
        test.isLongRunning = true;
        test.work = [](session::TaskContext& context) -> base::Result<void> {
            while (!context.stop.isRequested())
                QThread::msleep(5);
            return {};
        };
        fixture.workbench.tasks().perform(fixture.selection.current(), test);
        QTRY_VERIFY(fixture.workbench.tasks().isTesting());
    }
    QSignalSpy found(&fixture.workbench.recovery(), &session::RecoveryService::openIntentsFound);
    gui::click(dialog, "intentFinish");
    const auto working = [&] { return gui::resultOf(dialog).contains(utf8("Working")); };
    QTRY_VERIFY(!working());
    fixture.workbench.tasks().stopTest();
    QVERIFY(fixture.waitUntilIdle());
    const QString message = gui::resultOf(dialog);
    QVERIFY2(message.startsWith(QStringLiteral("✗")), qPrintable(message));
    QVERIFY2(!message.contains(utf8("Nothing was written")), qPrintable(message));
    QVERIFY2(message.contains(utf8("still unfinished")), qPrintable(message));
    QCOMPARE(cable.writes() - before >= framesUntilThirdRow, cut);
    QCOMPARE(found.size(), 0);
    QCOMPARE(table(dialog)->model()->rowCount(), 1);
    const auto open = fixture.session.journal().open();
    QVERIFY(std::any_of(open->begin(), open->end(),
                        [&](const base::Intent& one) { return one.uuid == *uuid; }));
}

void TestIntentsDialog::unrecordedResultIsReported()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    session::Event event;
    event.kind = session::Event::Kind::Written;
    event.servo = fixture.selection.current();
    event.report.emplace();
    event.report->id = 1;
    event.report->writes = {{utf8("position_p"), 21, 32, 20, 20, device::WriteOutcome::Kept, {}}};
    event.notices = {{base::NoticeCode::NotRecorded, 1, utf8("history.sqlite: disk full")}};
    const ui::EventText words = ui::describe(event, fixture.workbench.registry());
    QVERIFY2(words.message.contains(utf8("20, kept")), qPrintable(words.message));
    QVERIFY2(words.message.contains(utf8("NOT RECORDED")), qPrintable(words.message));
    QVERIFY(words.details.join(QLatin1Char('\n')).contains(utf8("disk full")));
}

namespace {
/// The mark of a restart, as a program that was killed in between has left it.
bool leaveRestartMarker(ServoTasksFixture& fixture, std::int64_t standing)
{
    base::Intent intent;
    intent.kind = base::IntentKind::Trial;
    intent.temporary = true;
    intent.servo = fixture.entry().servo.identity();
    intent.items = {{utf8("torque_limit"), 48, 1000, 999}};
    fixture.withBus(
        [standing](sim::VirtualBus& wire) { wire.servo(1)->poke(utf8("torque_limit"), standing); });
    return fixture.session.journal().begin(intent).has_value();
}
} // namespace

void TestIntentsDialog::theRestartMarkIsRestored()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(leaveRestartMarker(fixture, 999));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found), utf8("the new values"));
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(gui::resultOf(dialog).contains(utf8("have been restored")));
    QCOMPARE(fixture.raw(1, "torque_limit"), 1000);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestIntentsDialog::otherValuesAreKeptAndReported()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QVERIFY(leaveRestartMarker(fixture, 700));
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    QCOMPARE(cell(dialog, 0, ui::IntentColumn::Found),
             utf8("value has changed in the meantime; left as is"));
    gui::click(dialog, "intentUndo");
    QTRY_VERIFY(gui::resultOf(dialog).contains(utf8("Nothing was written")));
    QVERIFY2(gui::resultOf(dialog).contains(utf8("Torque limit")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(fixture.raw(1, "torque_limit"), 700);
    QVERIFY(fixture.session.journal().open()->empty());
}

/// Exchanged while the list is open: nothing is written, and the status line agrees.
void TestIntentsDialog::anotherServoIsNotReportedDone()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1,sts3250@7", 1, 7, 1));
    QVERIFY(!leaveOpenIntent(fixture).isEmpty());
    QDialog* dialog = fixture.open(Command::OpenIntents, "intentsDialog");
    QVERIFY(dialog);
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.servo(1)->poke(utf8("id"), 20);
        wire.servo(7)->poke(utf8("id"), 1);
    });
    std::optional<session::Event> task;
    connect(&fixture.workbench, &session::Workbench::eventOccurred, dialog,
            [&task](const session::Event& event) {
                if (event.kind == session::Event::Kind::Task && event.task == utf8("recover"))
                    task = event;
            });
    gui::click(dialog, "intentFinish");
    QTRY_VERIFY(task);
    QTRY_VERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✗")));
    const ui::EventText words = ui::describe(*task, fixture.workbench.registry());
    QCOMPARE(words.symbol, QStringLiteral("✗"));
    QVERIFY2(!words.message.contains(utf8("done")), qPrintable(words.message));
    QCOMPARE(fixture.session.journal().open()->size(), std::size_t(1));
}

SERVODESK_TEST(TestIntentsDialog)
#include "tst_intents_dialog.moc"

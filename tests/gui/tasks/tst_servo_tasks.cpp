// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of the servo menu by mouse and keyboard on simulated servos: the texts before, what the
// servo really holds afterwards, and the result that is shown.
#include "gui/servo_tasks_fixture.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/real_time.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"
#include "ui/widgets/servo_row.h"

#include <QComboBox>
#include <QFile>
#include <QListWidget>
#include <QSpinBox>

using gui::ServoTasksFixture;
using support::utf8;
using ui::Command;

namespace {
QSpinBox* newId(QDialog* dialog)
{
    return dialog->findChild<QSpinBox*>(utf8("newId"));
}

QStringList lines(QDialog* dialog)
{
    QStringList all;
    const auto* list = dialog->findChild<QListWidget*>(utf8("idList"));
    for (int row = 0; row < list->count(); ++row)
        all << list->item(row)->text();
    return all;
}
} // namespace

class TestServoTasks : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void idByKeyboardKeepsTheServoSelected();
    void idByMouseFromTheSuggestions();
    void aTakenIdIsNotOffered();
    void anUndiscoveredTakenIdIsRefused();
    void baudRateChangeIsFollowed();
    void anInterruptedRateChangeNamesBothRates();
    void aFixedRateIsReported();
    void centeringShowsBeforeAndAfter();
    void centeringIsNotAvailableEverywhere();
    void restoringShowsTheSnapshotPath();
    void restartWaitsForTheServo();
    void anIgnoredRestartIsNotReportedDone();
    void lxHasNoRestart();
    void identifyRestoresTheLed();
    void closingEndsTheBlinking();
    void closingThePortEndsTheBlinking();
    void modbusCannotBlink();
    void closesWithItsServo();
    void everyWidgetIsNamed_data();
    void everyWidgetIsNamed();
};

void TestServoTasks::idByKeyboardKeepsTheServoSelected()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    const session::ServoRef ref = fixture.selection.current();
    QDialog* dialog = fixture.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(newId(dialog)->value(), 7);
    QVERIFY(newId(dialog)->hasFocus() || !dialog->isActiveWindow());
    newId(dialog)->selectAll();
    QTest::keyClicks(newId(dialog), utf8("42"));
    QTest::keyClick(newId(dialog), Qt::Key_Return);
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::resultOf(dialog).contains(utf8("ID 42")));
    QVERIFY(gui::resultOf(dialog).contains(utf8("locked")));
    QCOMPARE(fixture.selection.current(), ref);
    QCOMPARE(fixture.entry().servo.id, 42);
    QCOMPARE(fixture.raw(42, "lock"), 1);
    QVERIFY(gui::textOf(dialog, "who").contains(utf8("ID 42")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled()); // it has this ID now
    QVERIFY(!fixture.entry().snapshotPath.isEmpty());
}

void TestServoTasks::idByMouseFromTheSuggestions()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 3));
    QDialog* dialog = fixture.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    const auto* list = dialog->findChild<QListWidget*>(utf8("idList"));
    QTRY_VERIFY(lines(dialog).contains(QStringLiteral("9 — free")));
    QVERIFY(lines(dialog).contains(QStringLiteral("3 — this servo (STS3250)")));
    QVERIFY(lines(dialog).contains(QStringLiteral("5 — taken by SCS15")));
    const int row = static_cast<int>(lines(dialog).indexOf(QStringLiteral("9 — free")));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(row)).center());
    QCOMPARE(newId(dialog)->value(), 9);
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    QCOMPARE(fixture.entry().servo.id, 9);
    QVERIFY(lines(dialog).contains(QStringLiteral("9 — this servo (STS3250)")));
}

void TestServoTasks::aTakenIdIsNotOffered()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = fixture.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    newId(dialog)->setValue(5);
    QVERIFY(gui::textOf(dialog, "idState").contains(utf8("SCS15")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
    QTest::keyClick(newId(dialog), Qt::Key_Return);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.entry().servo.id, 1);
}

/// The search did not reach it, so the job has to find out.
void TestServoTasks::anUndiscoveredTakenIdIsRefused()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 1, 1, 1));
    QDialog* dialog = fixture.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    // The quick look noticed them all the same.
    QTRY_COMPARE(newId(dialog)->value(), 7);
    newId(dialog)->setValue(5);
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    const QString message = gui::resultOf(dialog);
    QVERIFY2(message.startsWith(QStringLiteral("✗")), qPrintable(message));
    QVERIFY2(message.contains(utf8("Remedy:")), qPrintable(message));
    QCOMPARE(fixture.entry().servo.id, 1);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestServoTasks::baudRateChangeIsFollowed()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 2));
    const session::ServoRef ref = fixture.selection.current();
    QDialog* dialog = fixture.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    auto* rates = dialog->findChild<QComboBox*>(utf8("newBaud"));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
    QTest::keyClick(rates, Qt::Key_Down); // 500 000
    const QString state = gui::textOf(dialog, "baudState");
    QVERIFY2(state.contains(utf8("5 other servo(s) stay at")), qPrintable(state));
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(fixture.entry().servo.baud, 500'000);
    QCOMPARE(fixture.selection.current(), ref);
    fixture.workbench.writes().readTable(ref);
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(!fixture.entry().readError);
    QCOMPARE(fixture.raw(2, "lock"), 1);
}

/// It never answered again, so no ID and baud rate are shown for it.
void TestServoTasks::anInterruptedRateChangeNamesBothRates()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    QDialog* dialog = fixture.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    QTest::keyClick(dialog->findChild<QComboBox*>(utf8("newBaud")), Qt::Key_Down); // 500 000
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.config().faults.muteWhen = [](const sim::VirtualServo& servo) {
            return servo.baud() == 500'000; // has obeyed, but is not heard any more
        };
    });
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    const QString message = gui::resultOf(dialog);
    QVERIFY2(message.startsWith(QStringLiteral("✗")), qPrintable(message));
    QVERIFY2(!message.contains(utf8("The servo answers as")), qPrintable(message));
    QVERIFY2(message.contains(utf8("1 000 000")) || message.contains(utf8("1000000")),
             qPrintable(message));
    QVERIFY2(message.contains(utf8("search at both baud rates")), qPrintable(message));
    QVERIFY2(message.contains(utf8("EPROM lock: not confirmed")), qPrintable(message));
    const QString row =
        ui::servoRow(fixture.entry(), std::nullopt, fixture.workbench.now()).toolTipText();
    QVERIFY2(row.contains(utf8("EPROM lock not confirmed")), qPrintable(row));
}

void TestServoTasks::aFixedRateIsReported()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:lx", 1, 3, 1));
    QDialog* dialog = fixture.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(utf8("fixed baud rate")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.session.journal().entries()->empty());
}

void TestServoTasks::centeringShowsBeforeAndAfter()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 2));
    QDialog* dialog = fixture.open(Command::Center, "centerDialog");
    QVERIFY(dialog);
    QVERIFY(gui::textOf(dialog, "explanation").contains(utf8("stays off")));
    QTRY_VERIFY(gui::textOf(dialog, "positionBefore").startsWith(utf8("15"))); // 135°
    QCOMPARE(gui::textOf(dialog, "positionAfter"), QStringLiteral("–"));
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::textOf(dialog, "positionAfter").startsWith(utf8("20"))); // 2048
    QVERIFY(gui::textOf(dialog, "positionBefore").startsWith(utf8("15")));
    QVERIFY(gui::resultOf(dialog).contains(utf8("Torque stays off")));
    QCOMPARE(fixture.raw(2, "torque_switch"), 0);
    QCOMPARE(fixture.raw(2, "lock"), 1);
}

void TestServoTasks::centeringIsNotAvailableEverywhere()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 5)); // SCS15
    QDialog* dialog = fixture.open(Command::Center, "centerDialog");
    QVERIFY(dialog);
    QVERIFY(!gui::resultOf(dialog).isEmpty());
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
}

void TestServoTasks::restoringShowsTheSnapshotPath()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    fixture.workbench.writes().write(
        fixture.selection.current(),
        {{{utf8("max_temperature"), 61}}, false, device::Consent::confirmed()});
    QVERIFY(fixture.waitUntilIdle());
    QDialog* dialog = fixture.open(Command::RestoreDefaults, "restoreDialog");
    QVERIFY(dialog);
    QVERIFY(gui::textOf(dialog, "restoreWhat").contains(utf8("ID")));
    QVERIFY(gui::textOf(dialog, "restoreWhat").contains(utf8("Baud rate")));
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    const QString message = gui::resultOf(dialog);
    QVERIFY2(message.startsWith(QStringLiteral("✓")), qPrintable(message));
    QVERIFY(message.contains(utf8("Maximum temperature")));
    static const QRegularExpression file(utf8("(/\\S+\\.servo\\.json)"));
    const QString path = file.match(message).captured(1);
    QFile saved(path);
    QVERIFY2(saved.open(QIODevice::ReadOnly), qPrintable(message));
    QVERIFY(saved.readAll().contains("\"raw\": 61")); // as it was just before
}

void TestServoTasks::restartWaitsForTheServo()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = fixture.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    gui::click(dialog, "taskAction");
    QVERIFY(gui::button(dialog, "taskStop")->isVisible());
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::resultOf(dialog).contains(utf8(" ms")));
}

void TestServoTasks::anIgnoredRestartIsNotReportedDone()
{
    const support::RealTime realTime; // no simulated port
    support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
    support::CutCable cable(simulator.port(), false);
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready(qPrintable(cable.port()), 0, 10, 1));
    cable.dropInstruction(support::Reboot);
    QDialog* dialog = fixture.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    gui::click(dialog, "taskAction");
    QVERIFY(gui::ended(dialog));
    const QString message = gui::resultOf(dialog);
    QVERIFY2(message.startsWith(QStringLiteral("✗")), qPrintable(message));
    QVERIFY2(message.contains(utf8("did not reboot")), qPrintable(message));
    QVERIFY2(!message.contains(utf8("replies again")), qPrintable(message));
}

void TestServoTasks::lxHasNoRestart()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:lx", 1, 3, 1));
    QDialog* dialog = fixture.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(utf8("supply off and on")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
}

void TestServoTasks::identifyRestoresTheLed()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    const std::int64_t before = fixture.raw(1, "led_alarm_condition");
    QDialog* dialog = fixture.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    const auto ledOn = [&] {
        return fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->ledOn(); });
    };
    for (int blink = 0; blink < 2; ++blink) {
        QTRY_VERIFY(!ledOn());
        QTRY_VERIFY(ledOn());
    }
    gui::click(dialog, "taskStop");
    QVERIFY(gui::ended(dialog));
    QVERIFY(gui::resultOf(dialog).contains(utf8("has been restored")));
    QVERIFY(gui::resultOf(dialog).contains(utf8("LED alarm condition"))); // not its key
    QCOMPARE(fixture.raw(1, "led_alarm_condition"), before);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestServoTasks::closingEndsTheBlinking()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:lx", 1, 3, 1));
    const std::int64_t before = fixture.raw(1, "led");
    QDialog* dialog = fixture.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    QTRY_VERIFY(fixture.raw(1, "led") != before);
    QPointer<QDialog> watched(dialog);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!watched);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "led"), before);
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestServoTasks::closingThePortEndsTheBlinking()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 3, 1));
    QVERIFY(fixture.open(Command::Identify, "identifyDialog"));
    QTRY_COMPARE(fixture.raw(1, "led_alarm_condition"), 0);
    QElapsedTimer clock;
    clock.start();
    fixture.workbench.closing().disconnectFrom();
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QVERIFY2(clock.elapsed() < 1500, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(fixture.session.journal().open()->empty());
}

void TestServoTasks::modbusCannotBlink()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:modbus", 1, 2, 1));
    QDialog* dialog = fixture.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    QVERIFY(gui::ended(dialog));
    QVERIFY(gui::resultOf(dialog).contains(utf8("factory values")));
    QVERIFY(fixture.session.journal().entries()->empty());
}

void TestServoTasks::closesWithItsServo()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    QPointer<QDialog> dialog(fixture.open(Command::SetId, "setIdDialog"));
    QVERIFY(dialog);
    fixture.withBus([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
    QVERIFY(fixture.search(0, 3));
    QTRY_VERIFY(!dialog);
}

void TestServoTasks::everyWidgetIsNamed_data()
{
    QTest::addColumn<int>("command");
    QTest::addColumn<QByteArray>("name");
    const std::pair<Command, const char*> all[] = {
        {Command::SetId, "setIdDialog"},     {Command::SetBaud, "setBaudDialog"},
        {Command::Center, "centerDialog"},   {Command::RestoreDefaults, "restoreDialog"},
        {Command::Reboot, "rebootDialog"},   {Command::Identify, "identifyDialog"},
        {Command::ClearAlarm, "alarmDialog"}};
    for (const auto& [command, name] : all)
        QTest::newRow(name) << int(command) << QByteArray(name);
}

void TestServoTasks::everyWidgetIsNamed()
{
    QFETCH(int, command);
    QFETCH(QByteArray, name);
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = fixture.open(Command(command), name.constData());
    QVERIFY(dialog);
    for (const QWidget* widget : dialog->findChildren<QWidget*>()) {
        const bool own = widget->parentWidget() == dialog && widget->focusPolicy() != Qt::NoFocus;
        if (!own)
            continue;
        QVERIFY2(!widget->objectName().isEmpty(), widget->metaObject()->className());
        QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
        QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
        if (widget->isVisible())
            QVERIFY2(widget->width() >= widget->minimumSizeHint().width(),
                     qPrintable(widget->objectName()));
    }
    QVERIFY(!dialog->windowTitle().isEmpty());
}

SERVODESK_TEST(TestServoTasks)
#include "tst_servo_tasks.moc"

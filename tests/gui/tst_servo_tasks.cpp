// SPDX-License-Identifier: GPL-3.0-or-later
// The one-click tasks by mouse and keyboard on simulated servos: what is said beforehand, what the
// servo really holds afterwards, and what is said about it.
#include "gui/tasks_bench.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"
#include "support/sim_bench.h"
#include "ui/models/servo_row.h"

#include <QComboBox>
#include <QFile>
#include <QListWidget>
#include <QSpinBox>

using gui::TasksBench;
using ui::Command;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

QSpinBox* newId(QDialog* dialog)
{
    return dialog->findChild<QSpinBox*>(text("newId"));
}

QStringList lines(QDialog* dialog)
{
    QStringList all;
    const auto* list = dialog->findChild<QListWidget*>(text("idList"));
    for (int row = 0; row < list->count(); ++row)
        all << list->item(row)->text();
    return all;
}
} // namespace

class TestServoTasks : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void idByKeyboardKeepsTheServoSelected();
    void idByMouseFromTheProposals();
    void aTakenIdIsNotOffered();
    void aTakenIdNobodyKnewOfIsRefused();
    void baudIsFollowed();
    void aCutRateChangeNamesBothRates();
    void aFixedRateSaysSo();
    void centringShowsBeforeAndAfter();
    void centringIsNotForEverybody();
    void restoringShowsWhereTheTableIs();
    void restartWaitsForTheServo();
    void aRestartThatIsIgnoredIsNotClaimed();
    void lxHasNoRestart();
    void identifyPutsTheLedBack();
    void closingEndsTheBlinking();
    void closingThePortEndsTheBlinking();
    void modbusCannotBlink();
    void closesWithItsServo();
    void everyWidgetIsNamed_data();
    void everyWidgetIsNamed();
};

void TestServoTasks::idByKeyboardKeepsTheServoSelected()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    const session::ServoRef ref = bench.selection.current();
    QDialog* dialog = bench.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(newId(dialog)->value(), 7);
    QVERIFY(newId(dialog)->hasFocus() || !dialog->isActiveWindow());
    newId(dialog)->selectAll();
    QTest::keyClicks(newId(dialog), text("42"));
    QTest::keyClick(newId(dialog), Qt::Key_Return);
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::resultOf(dialog).contains(text("ID 42")));
    QVERIFY(gui::resultOf(dialog).contains(text("closed")));
    QCOMPARE(bench.selection.current(), ref);
    QCOMPARE(bench.entry().servo.id, 42);
    QCOMPARE(bench.raw(42, "lock"), 1);
    QVERIFY(gui::textOf(dialog, "who").contains(text("ID 42")));
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled()); // it has this ID now
    QVERIFY(!bench.entry().snapshotPath.isEmpty());
}

void TestServoTasks::idByMouseFromTheProposals()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 3));
    QDialog* dialog = bench.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    const auto* list = dialog->findChild<QListWidget*>(text("idList"));
    QTRY_VERIFY(lines(dialog).contains(QStringLiteral("9 — free")));
    QVERIFY(lines(dialog).contains(QStringLiteral("3 — this servo (STS3250)")));
    QVERIFY(lines(dialog).contains(QStringLiteral("5 — taken by SCS15")));
    const int row = static_cast<int>(lines(dialog).indexOf(QStringLiteral("9 — free")));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(row)).center());
    QCOMPARE(newId(dialog)->value(), 9);
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    QCOMPARE(bench.entry().servo.id, 9);
    QVERIFY(lines(dialog).contains(QStringLiteral("9 — this servo (STS3250)")));
}

void TestServoTasks::aTakenIdIsNotOffered()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = bench.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    newId(dialog)->setValue(5);
    QVERIFY(gui::textOf(dialog, "idState").contains(text("SCS15")));
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled());
    QTest::keyClick(newId(dialog), Qt::Key_Return);
    QVERIFY(bench.settled());
    QCOMPARE(bench.entry().servo.id, 1);
}

/// The search did not reach it, so the job has to find out.
void TestServoTasks::aTakenIdNobodyKnewOfIsRefused()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 1, 1, 1));
    QDialog* dialog = bench.open(Command::SetId, "setIdDialog");
    QVERIFY(dialog);
    // The quick look noticed them all the same.
    QTRY_COMPARE(newId(dialog)->value(), 7);
    newId(dialog)->setValue(5);
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    const QString said = gui::resultOf(dialog);
    QVERIFY2(said.startsWith(QStringLiteral("✗")), qPrintable(said));
    QVERIFY2(said.contains(text("What to do:")), qPrintable(said));
    QCOMPARE(bench.entry().servo.id, 1);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestServoTasks::baudIsFollowed()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 2));
    const session::ServoRef ref = bench.selection.current();
    QDialog* dialog = bench.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    auto* rates = dialog->findChild<QComboBox*>(text("newBaud"));
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled());
    QTest::keyClick(rates, Qt::Key_Down);                            // 500 000
    QVERIFY(gui::textOf(dialog, "baudState").contains(text(": 5"))); // others stay behind
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(bench.entry().servo.baud, 500'000);
    QCOMPARE(bench.selection.current(), ref);
    bench.desk.readTable(ref);
    QVERIFY(bench.settled());
    QVERIFY(!bench.entry().readError);
    QCOMPARE(bench.raw(2, "lock"), 1);
}

/// It never answered again, so it is not said where it answers.
void TestServoTasks::aCutRateChangeNamesBothRates()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:sts3215@1", 1, 1, 1));
    QDialog* dialog = bench.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    QTest::keyClick(dialog->findChild<QComboBox*>(text("newBaud")), Qt::Key_Down); // 500 000
    bench.withWire([](sim::VirtualBus& wire) {
        wire.config().faults.muteWhen = [](const sim::VirtualServo& servo) {
            return servo.baud() == 500'000; // has obeyed, but is not heard any more
        };
    });
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    const QString said = gui::resultOf(dialog);
    QVERIFY2(said.startsWith(QStringLiteral("✗")), qPrintable(said));
    QVERIFY2(!said.contains(text("The servo answers as")), qPrintable(said));
    QVERIFY2(said.contains(text("1 000 000")) || said.contains(text("1000000")), qPrintable(said));
    QVERIFY2(said.contains(text("either baud rate")), qPrintable(said));
    QVERIFY2(said.contains(text("EPROM lock: not proven closed")), qPrintable(said));
    const QString row = ui::servoRow(bench.entry(), std::nullopt, bench.desk.now()).everything();
    QVERIFY2(row.contains(text("EPROM lock not proven closed")), qPrintable(row));
}

void TestServoTasks::aFixedRateSaysSo()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:lx", 1, 3, 1));
    QDialog* dialog = bench.open(Command::SetBaud, "setBaudDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(text("one rate")));
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled());
    QVERIFY(bench.settled());
    QVERIFY(bench.session.journal().entries()->empty());
}

void TestServoTasks::centringShowsBeforeAndAfter()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 2));
    QDialog* dialog = bench.open(Command::Center, "centerDialog");
    QVERIFY(dialog);
    QVERIFY(gui::textOf(dialog, "explanation").contains(text("stays off")));
    QTRY_VERIFY(gui::textOf(dialog, "positionBefore").startsWith(text("15"))); // 135°
    QCOMPARE(gui::textOf(dialog, "positionAfter"), QStringLiteral("–"));
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::textOf(dialog, "positionAfter").startsWith(text("20"))); // 2048
    QVERIFY(gui::textOf(dialog, "positionBefore").startsWith(text("15")));
    QVERIFY(gui::resultOf(dialog).contains(text("Torque stays off")));
    QCOMPARE(bench.raw(2, "torque_switch"), 0);
    QCOMPARE(bench.raw(2, "lock"), 1);
}

void TestServoTasks::centringIsNotForEverybody()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 5)); // SCS15
    QDialog* dialog = bench.open(Command::Center, "centerDialog");
    QVERIFY(dialog);
    QVERIFY(!gui::resultOf(dialog).isEmpty());
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled());
}

void TestServoTasks::restoringShowsWhereTheTableIs()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    bench.desk.write(bench.selection.current(), {{{text("max_temperature"), 61}}, false, true});
    QVERIFY(bench.settled());
    QDialog* dialog = bench.open(Command::RestoreDefaults, "restoreDialog");
    QVERIFY(dialog);
    QVERIFY(gui::textOf(dialog, "restoreWhat").contains(text("ID")));
    QVERIFY(gui::textOf(dialog, "restoreWhat").contains(text("Baud rate")));
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    const QString said = gui::resultOf(dialog);
    QVERIFY2(said.startsWith(QStringLiteral("✓")), qPrintable(said));
    QVERIFY(said.contains(text("Maximum temperature")));
    static const QRegularExpression file(text("(/\\S+\\.servo\\.json)"));
    const QString path = file.match(said).captured(1);
    QFile saved(path);
    QVERIFY2(saved.open(QIODevice::ReadOnly), qPrintable(said));
    QVERIFY(saved.readAll().contains("\"raw\": 61")); // as it was just before
}

void TestServoTasks::restartWaitsForTheServo()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = bench.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::button(dialog, "taskStop")->isVisible());
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).startsWith(QStringLiteral("✓")),
             qPrintable(gui::resultOf(dialog)));
    QVERIFY(gui::resultOf(dialog).contains(text(" ms")));
}

void TestServoTasks::aRestartThatIsIgnoredIsNotClaimed()
{
    support::SimProgram simulator(support::words("--servos sts3215@1 --baud 1000000"));
    support::CutCable cable(simulator.port(), false);
    TasksBench bench;
    QVERIFY(bench.ready(qPrintable(cable.port()), 0, 10, 1));
    cable.lose(support::Reboot);
    QDialog* dialog = bench.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    gui::click(dialog, "taskDeed");
    QVERIFY(gui::ended(dialog));
    const QString said = gui::resultOf(dialog);
    QVERIFY2(said.startsWith(QStringLiteral("✗")), qPrintable(said));
    QVERIFY2(said.contains(text("did not restart")), qPrintable(said));
    QVERIFY2(!said.contains(text("answers again")), qPrintable(said));
}

void TestServoTasks::lxHasNoRestart()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:lx", 1, 3, 1));
    QDialog* dialog = bench.open(Command::Reboot, "rebootDialog");
    QVERIFY(dialog);
    QVERIFY(gui::resultOf(dialog).contains(text("supply off and on")));
    QVERIFY(!gui::button(dialog, "taskDeed")->isEnabled());
}

void TestServoTasks::identifyPutsTheLedBack()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    const std::int64_t before = bench.raw(1, "led_alarm_condition");
    QDialog* dialog = bench.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    const auto ledOn = [&] {
        return bench.withWire([](sim::VirtualBus& wire) { return wire.servo(1)->ledOn(); });
    };
    for (int blink = 0; blink < 2; ++blink) {
        QTRY_VERIFY(!ledOn());
        QTRY_VERIFY(ledOn());
    }
    gui::click(dialog, "taskStop");
    QVERIFY(gui::ended(dialog, 1000));
    QVERIFY(gui::resultOf(dialog).contains(text("as it was before")));
    QVERIFY(gui::resultOf(dialog).contains(text("LED alarm condition"))); // not its key
    QCOMPARE(bench.raw(1, "led_alarm_condition"), before);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestServoTasks::closingEndsTheBlinking()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:lx", 1, 3, 1));
    const std::int64_t before = bench.raw(1, "led");
    QDialog* dialog = bench.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    QTRY_VERIFY(bench.raw(1, "led") != before);
    QPointer<QDialog> watched(dialog);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!watched);
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "led"), before);
    QVERIFY(bench.session.journal().open()->empty());
}

void TestServoTasks::closingThePortEndsTheBlinking()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 3, 1));
    QVERIFY(bench.open(Command::Identify, "identifyDialog"));
    QTRY_COMPARE(bench.raw(1, "led_alarm_condition"), 0);
    QElapsedTimer clock;
    clock.start();
    bench.desk.disconnectFrom();
    QTRY_COMPARE(bench.desk.state(), session::LinkState::Off);
    QVERIFY2(clock.elapsed() < 1500, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(bench.session.journal().open()->empty());
}

void TestServoTasks::modbusCannotBlink()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:modbus", 1, 2, 1));
    QDialog* dialog = bench.open(Command::Identify, "identifyDialog");
    QVERIFY(dialog);
    QVERIFY(gui::ended(dialog));
    QVERIFY(gui::resultOf(dialog).contains(text("factory values")));
    QVERIFY(bench.session.journal().entries()->empty());
}

void TestServoTasks::closesWithItsServo()
{
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    QPointer<QDialog> dialog(bench.open(Command::SetId, "setIdDialog"));
    QVERIFY(dialog);
    bench.withWire([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {1}; });
    QVERIFY(bench.search(0, 3));
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
    TasksBench bench;
    QVERIFY(bench.ready("sim:demo", 0, 10, 1));
    QDialog* dialog = bench.open(Command(command), name.constData());
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

QTEST_MAIN(TestServoTasks)
#include "tst_servo_tasks.moc"

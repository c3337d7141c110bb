// SPDX-License-Identifier: GPL-3.0-or-later
// Clearing alarms in the window: the cause with its value and limit, nothing moves before consent,
// and where only waiting helps nothing is written until it is over.
#include "gui/servo_tasks_fixture.h"
#include "support/test_main.h"
#include "support/text.h"
#include "ui/widgets/question_dialog.h"

#include <QRegularExpression>
#include <QTableWidget>

using gui::ServoTasksFixture;
using support::utf8;
using ui::Command;

namespace {
QString cell(QDialog* dialog, int row, int column)
{
    const auto* table = dialog->findChild<QTableWidget*>(utf8("alarms"));
    const QTableWidgetItem* item = table->item(row, column);
    return item != nullptr ? item->text() : QString();
}

int rows(QDialog* dialog)
{
    return dialog->findChild<QTableWidget*>(utf8("alarms"))->rowCount();
}
} // namespace

class TestAlarmDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void overloadIsReleasedOnlyAfterConsent();
    void overcurrentIsReleasedOnlyAfterConsent();
    void voltageIsShownUntilItReturns();
    void lxHeatIsShownUntilItReturns();
    void modbusIsReset();
    void noAlarmOffersNothing();
    void aServoThatStopsAnsweringShowsNoValues();
    void questionsDefaultToNo_data();
    void questionsDefaultToNo();
    void aQuestionEmitsItsAnswerOnce();
    void aQuestionClosesWithItsGuard();
};

void TestAlarmDialog::overloadIsReleasedOnlyAfterConsent()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:trouble", 5, 5, 5));
    QVERIFY(fixture.raw(5, "servo_status") & 32);
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(cell(dialog, 0, 0), utf8("overload"));
    QVERIFY(gui::textOf(dialog, "release").contains(utf8("back from the stalled position")));

    gui::click(dialog, "taskAction");
    QDialog* question = fixture.dialog("question");
    QVERIFY(question);
    QVERIFY(gui::textOf(question, "questionRisk").contains(utf8("fingers")));
    QTest::keyClick(question, Qt::Key_Escape);
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.raw(5, "servo_status") & 32);
    QVERIFY(fixture.session.journal().entries()->empty());
    const std::int64_t before = fixture.raw(5, "present_position");

    QTRY_VERIFY(gui::button(dialog, "taskAction")->isEnabled());
    gui::click(dialog, "taskAction");
    question = fixture.dialog("question");
    QVERIFY(question);
    gui::click(question, "questionYes");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).contains(utf8("The alarm has cleared")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(fixture.raw(5, "servo_status"), 0);
    const std::int64_t turned = before - fixture.raw(5, "present_position");
    QVERIFY2(turned > 20 && turned < 90, qPrintable(QString::number(turned)));
    QTRY_VERIFY(!gui::button(dialog, "taskAction")->isEnabled());
}

void TestAlarmDialog::overcurrentIsReleasedOnlyAfterConsent()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:sts3215@1", 1, 1, 1));
    fixture.withBus([](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(1);
        servo.load().coulombFriction = 100; // rusted in
        servo.poke(utf8("protection_current"), 100);
        servo.poke(utf8("overcurrent_time"), 10);
        servo.poke(utf8("unload_condition"), 8);
        servo.poke(utf8("goal_position"), 3000);
    });
    QTRY_COMPARE(fixture.raw(1, "servo_status"), 8);
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(cell(dialog, 0, 0), utf8("overcurrent"));
    QVERIFY(cell(dialog, 0, 3).startsWith(utf8("100 (650")));
    gui::click(dialog, "taskAction");
    QDialog* question = fixture.dialog("question");
    QVERIFY(question);
    QCOMPARE(fixture.raw(1, "torque_switch"), 0);
    gui::click(question, "questionYes");
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).contains(utf8("The alarm has cleared")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(fixture.raw(1, "torque_switch"), 1);
}

void TestAlarmDialog::voltageIsShownUntilItReturns()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 6, 6, 6));
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(cell(dialog, 0, 0), utf8("voltage"));
    QVERIFY(cell(dialog, 0, 1).contains(utf8("8.6 V")));
    QVERIFY(cell(dialog, 0, 3).contains(utf8("8.0 V")));
    QVERIFY(gui::textOf(dialog, "release").contains(utf8("Nothing is written")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
    // Live: still too much, then right.
    const auto supply = [&](double volts) {
        fixture.withBus(
            [&](sim::VirtualBus& wire) { wire.servo(6)->environment().supplyVolts = volts; });
    };
    supply(8.3);
    QTRY_VERIFY(cell(dialog, 0, 1).contains(utf8("8.3 V")));
    supply(6.0);
    QTRY_COMPARE(rows(dialog), 0);
    QVERIFY(gui::resultOf(dialog).contains(utf8("The alarm has cleared")));
    QVERIFY(fixture.session.journal().entries()->empty());
}

void TestAlarmDialog::lxHeatIsShownUntilItReturns()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:lx", 3, 3, 3));
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(cell(dialog, 0, 0), utf8("temperature"));
    QVERIFY(gui::textOf(dialog, "release").contains(utf8("does not report alarms")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
    fixture.withBus([](sim::VirtualBus& wire) {
        wire.servo(3)->environment().ambientCelsius = 25;
        wire.servo(3)->setTemperature(40);
    });
    QTRY_COMPARE(rows(dialog), 0);
    QVERIFY(gui::resultOf(dialog).contains(utf8("The alarm has cleared")));
    QVERIFY(fixture.session.journal().entries()->empty());
}

void TestAlarmDialog::modbusIsReset()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:modbus", 1, 1, 1));
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(2); });
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(cell(dialog, 0, 0), utf8("sensor"));
    QTRY_VERIFY(gui::button(dialog, "taskAction")->isEnabled());
    gui::click(dialog, "taskAction"); // nothing moves, so there is no question
    QVERIFY(gui::ended(dialog));
    QVERIFY2(gui::resultOf(dialog).contains(utf8("The alarm has cleared")),
             qPrintable(gui::resultOf(dialog)));
    QCOMPARE(fixture.raw(1, "servo_status") & 2, 0);
}

void TestAlarmDialog::noAlarmOffersNothing()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 1, 1, 1));
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_VERIFY(gui::textOf(dialog, "release").contains(utf8("No alarms")));
    QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
}

void TestAlarmDialog::aServoThatStopsAnsweringShowsNoValues()
{
    ServoTasksFixture fixture;
    QVERIFY(fixture.ready("sim:demo", 6, 6, 6));
    QDialog* dialog = fixture.open(Command::ClearAlarm, "alarmDialog");
    QVERIFY(dialog);
    QTRY_COMPARE(rows(dialog), 1);
    fixture.withBus([](sim::VirtualBus& wire) { wire.config().faults.muteIds = {6}; });
    QTRY_COMPARE(rows(dialog), 0);
    QVERIFY(gui::resultOf(dialog).startsWith(QStringLiteral("✗")));
    QVERIFY(!gui::resultOf(dialog).contains(utf8("gone")));
}

void TestAlarmDialog::questionsDefaultToNo_data()
{
    QTest::addColumn<bool>("harmless");
    QTest::addColumn<int>("key");
    QTest::addColumn<bool>("yes");
    QTest::newRow("Enter") << false << int(Qt::Key_Return) << false;
    QTest::newRow("Esc") << false << int(Qt::Key_Escape) << false;
    QTest::newRow("Enter, harmless") << true << int(Qt::Key_Return) << true;
    QTest::newRow("Esc, harmless") << true << int(Qt::Key_Escape) << false;
}

void TestAlarmDialog::questionsDefaultToNo()
{
    QFETCH(bool, harmless);
    QFETCH(int, key);
    QFETCH(bool, yes);
    ServoTasksFixture fixture;
    int agreed = 0;
    int refused = 0;
    ui::Question question;
    question.title = utf8("Really?");
    question.risk = utf8("It may break.");
    question.acceptText = utf8("Do it");
    question.acceptIsDefault = harmless;
    question.rejected = [&] { ++refused; };
    ui::ask(&fixture.window, question, [&] { ++agreed; });
    QDialog* dialog = fixture.dialog("question");
    QVERIFY(dialog);
    QCOMPARE(gui::textOf(dialog, "questionRisk"), utf8("It may break."));
    QTest::keyClick(dialog, Qt::Key(key));
    QTRY_COMPARE(agreed + refused, 1);
    QCOMPARE(agreed == 1, yes);
}

void TestAlarmDialog::aQuestionEmitsItsAnswerOnce()
{
    ServoTasksFixture fixture;
    int agreed = 0;
    ui::Question question;
    question.title = utf8("Really?");
    question.acceptText = utf8("Do it");
    ui::ask(&fixture.window, question, [&] { ++agreed; });
    QPointer<QDialog> dialog(fixture.dialog("question"));
    QVERIFY(dialog);
    gui::click(dialog, "questionYes");
    QTRY_VERIFY(!dialog);
    QCOMPARE(agreed, 1);
}

void TestAlarmDialog::aQuestionClosesWithItsGuard()
{
    ServoTasksFixture fixture;
    int answers = 0;
    auto guard = std::make_unique<QWidget>();
    ui::Question question;
    question.title = utf8("Really?");
    question.acceptText = utf8("Do it");
    question.guard = guard.get();
    question.rejected = [&] { ++answers; };
    ui::ask(&fixture.window, question, [&] { ++answers; });
    QPointer<QDialog> dialog(fixture.dialog("question"));
    QVERIFY(dialog);
    guard.reset();
    QTRY_VERIFY(!dialog);
    QCOMPARE(answers, 0);
}

SERVODESK_TEST(TestAlarmDialog)
#include "tst_alarm_dialog.moc"

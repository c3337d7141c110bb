// SPDX-License-Identifier: GPL-3.0-or-later
// The control panel as a technician uses it: nothing moves without a request, limits and refusals,
// dragging, write methods, torque on at the present position, and faults in the middle of all that.
#include "gui/control_panel_fixture.h"
#include "session/motion/motion_controller.h"
#include "support/test_main.h"
#include "support/text.h"

using gui::ControlPanelFixture;
using session::LinkState;
using support::utf8;

namespace {
// Its firmware runs to an old goal when torque is switched on, so the window must not let it.
const QString sts = QStringLiteral("sim:sts3215@1+run-to-goal=1");
} // namespace

class TestControlPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::initProgram(); }
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(QStringLiteral("^(?!This plugin does not support )")));
    }

    void aSliderWithoutAScaleSendsNothing();
    void nothingMovesUnrequested();
    void emptyPanelExplainsItself();
    void hintBeforeTheFirstTorque();
    void theHintsActionStaysInItsMode_data();
    void theHintsActionStaysInItsMode();
    void aStopDiscardsTheHintsAction();
    void torqueOnHoldsThePresentPosition_data();
    void torqueOnHoldsThePresentPosition();
    void torqueOnAfterThreeTurns();
    void goalsOutsideTheLimitsAreRefused();
    void draggingSendsTheLatestGoal();
    void wheelMovesOnlyAfterAClick();
    void keysMoveToTheLimits();
    void speedAndAccelerationAreApplied();
    void aTypedFieldIsNotOverwritten();
    void aRefusedGoalStaysInTheField();
    void messagesClearOnTheNextMove();
    void servoDisappearsMidDrag();
    void modeChangedByAnotherProgram();
    void storedGoalsWaitForExecute();
    void aStoredGoalDoesNotSurviveAModeSwitch();
    void severalServosMoveTogether();
    void oneOfSeveralOutOfItsLimits();
    void severalServosGetTheDisplayedSpeed();
    void torqueLimit_data();
    void torqueLimit();
    void torqueLimitByArrowsAndNotches();
    void stopBlocksUntilTorqueIsOn();
};

void TestControlPanel::nothingMovesUnrequested()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(utf8("sim:demo")));
    QVERIFY(fixture.search(1, 6));
    std::vector<double> before;
    for (int id = 1; id <= 6; ++id)
        before.push_back(fixture.degrees(id));
    for (int id = 1; id <= 6; ++id) {
        QVERIFY(fixture.choose({id}));
        QVERIFY(fixture.raw(id, "torque_switch") == 0 || id == 6);
    }
    QVERIFY(fixture.session.journal().entries()->empty());
    for (int id = 1; id <= 6; ++id)
        QVERIFY(std::abs(fixture.degrees(id) - before[std::size_t(id - 1)]) < 0.5 || id == 6);
}

void TestControlPanel::emptyPanelExplainsItself()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.text("controlEmpty").contains(utf8("Select a servo")));
    QVERIFY(!fixture.has("controlGoal"));
    QVERIFY(fixture.ready(sts, {1}));
    QVERIFY(fixture.text("controlEmpty").isEmpty());
    QVERIFY(fixture.has("controlGoal"));
    QVERIFY(fixture.text("controlTitle").contains(utf8("ID 1")));
}

void TestControlPanel::hintBeforeTheFirstTorque()
{
    ControlPanelFixture fixture;
    fixture.settings.setPageValue(utf8("operate/no_torque_hint"), false);
    QVERIFY(fixture.ready(sts, {1}));
    fixture.click("torqueSwitch");
    QVERIFY(fixture.has("torqueHint"));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    fixture.click("torqueHintCancel");
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    fixture.click("torqueSwitch");
    fixture.click("torqueHintGo");
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(fixture.shown() && fixture.torque()); // off again
    QVERIFY(fixture.torque());                    // and on, without a word
    QVERIFY(!fixture.has("torqueHint"));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(1));
}

void TestControlPanel::theHintsActionStaysInItsMode_data()
{
    QTest::addColumn<bool>("byAnother");
    QTest::newRow("switched here") << false;
    QTest::newRow("by another program") << true;
}

/// 3000 is a place in one mode and a speed in another.
void TestControlPanel::theHintsActionStaysInItsMode()
{
    QFETCH(bool, byAnother);
    ControlPanelFixture fixture;
    fixture.settings.setPageValue(utf8("operate/no_torque_hint"), false);
    QVERIFY(fixture.ready(sts, {1}));
    const std::int64_t speed =
        byAnother ? fixture.raw(1, "goal_speed") : 0; // a switch here ends it
    fixture.type("goal", utf8("3000"));
    fixture.click("setGoal");
    QVERIFY(fixture.has("torqueHint"));
    if (byAnother) {
        fixture.poke(1, "operating_mode", 1);
        QVERIFY(fixture.read());
    } else {
        QVERIFY(fixture.switchModeByTile("speed"));
    }
    QVERIFY(!fixture.has("torqueHint"));
    // Even an answer that was on its way already does nothing.
    fixture.find<QPushButton>("torqueHintGo")->click();
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_speed"), speed);
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
}

void TestControlPanel::aStopDiscardsTheHintsAction()
{
    ControlPanelFixture fixture;
    fixture.settings.setPageValue(utf8("operate/no_torque_hint"), false);
    QVERIFY(fixture.ready(utf8("sim:sts3215@1,sts3215@2"), {1}));
    fixture.click("torqueSwitch");
    QVERIFY(fixture.has("torqueHint"));
    fixture.workbench.emergencyStop().trigger();
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(!fixture.has("torqueHint"));
    fixture.click("torqueSwitch");
    QVERIFY(fixture.has("torqueHint"));
    QVERIFY(fixture.choose({2}));
    QVERIFY(!fixture.has("torqueHint"));
    fixture.find<QPushButton>("torqueHintGo")->click();
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QCOMPARE(fixture.raw(2, "torque_switch"), std::int64_t(0));
}

void TestControlPanel::torqueOnHoldsThePresentPosition_data()
{
    QTest::addColumn<int>("factor");
    QTest::addColumn<int>("oldGoal");
    QTest::newRow("turned by 90°") << 1 << 1024;
    QTest::newRow("factor 2") << 2 << 200;
}

void TestControlPanel::torqueOnHoldsThePresentPosition()
{
    QFETCH(int, factor);
    QFETCH(int, oldGoal);
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(sts)); // it stands at 180°
    fixture.poke(1, "angle_resolution", factor);
    fixture.poke(1, "goal_position", oldGoal);
    fixture.poke(1, "torque_switch", 0);
    QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.torque());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - before) <= 2 * 360.0 / 4096 * factor);
}

void TestControlPanel::torqueOnAfterThreeTurns()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    QVERIFY(fixture.switchModeByTile("multiturn"));
    QVERIFY(fixture.go(QString::number(2048 + 3 * 4096)));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(fixture.shown() && fixture.torque()); // off
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.torque());
    QVERIFY(fixture.isAtRest(1));
    const bool moved = std::abs(fixture.degrees(1) - before) > 2 * 360.0 / 4096;
    const bool refused = fixture.raw(1, "torque_switch") == 0 && !fixture.complaint().isEmpty();
    QVERIFY2(!moved && (refused || fixture.raw(1, "torque_switch") == 1),
             qPrintable(fixture.complaint()));
}

void TestControlPanel::goalsOutsideTheLimitsAreRefused()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(sts));
    fixture.poke(1, "min_angle_limit", 1000);
    fixture.poke(1, "max_angle_limit", 3000);
    QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
    QCOMPARE(fixture.slider()->scale().min, std::int64_t(1000));
    QCOMPARE(fixture.slider()->scale().max, std::int64_t(3000));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("3500")));
    QVERIFY2(fixture.complaint().contains(utf8("1000 … 3000")), qPrintable(fixture.complaint()));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - before) < 0.5);
    // The slider cannot be drawn there.
    QTest::mouseClick(fixture.slider(), Qt::LeftButton, {}, fixture.slider()->pointOf(3900));
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_position"), std::int64_t(3000));
}

/// Before the page knows the servo's range.
void TestControlPanel::aSliderWithoutAScaleSendsNothing()
{
    ui::ControlSlider slider(nullptr);
    slider.resize(320, 40);
    slider.show();
    QSignalSpy moved(&slider, &ui::ControlSlider::moved);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {100, 14});
    QTest::mouseMove(&slider, {200, 14});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {200, 14});
    QCOMPARE(moved.count(), 0);
    slider.setScale({0, 4095, 0, 4095});
    QTest::mousePress(&slider, Qt::LeftButton, {}, {100, 14});
    QCOMPARE(moved.count(), 1);
}

void TestControlPanel::draggingSendsTheLatestGoal()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    ui::ControlSlider* slider = fixture.slider();
    QSignalSpy sent(&fixture.drive, &session::MotionController::moveSent);
    QTest::mousePress(slider, Qt::LeftButton, {}, slider->pointOf(2100));
    for (int goal = 2100; goal <= 3000; goal += 10)
        QTest::mouseMove(slider, slider->pointOf(goal));
    QTRY_VERIFY(sent.count() >= 2); // on the way, and the last one
    QTest::mouseRelease(slider, Qt::LeftButton, {}, slider->pointOf(3000));
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(sent.count() < 40); // ninety moves of the mouse, but no queue
    QVERIFY(std::abs(fixture.raw(1, "goal_position") - 3000) < 20);
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - double(fixture.raw(1, "goal_position")) * 360 / 4096) <
            2);
}

void TestControlPanel::wheelMovesOnlyAfterAClick()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    ui::ControlSlider* slider = fixture.slider();
    const auto turn = [&](Qt::KeyboardModifiers with) {
        const QPointF middle = slider->rect().center();
        QWheelEvent event(middle, slider->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, with,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider, &event);
        return fixture.waitUntilIdle();
    };
    fixture.box("goal")->setFocus();
    QVERIFY(turn({}));
    slider->setFocus(Qt::TabFocusReason); // reached with the keyboard while the page is scrolled
    QVERIFY(turn({}));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QTest::mouseClick(slider, Qt::LeftButton, {}, slider->pointOf(2500));
    QVERIFY(fixture.waitUntilIdle() && fixture.shown());
    const std::int64_t from = *slider->value();
    QVERIFY(turn({}));
    QVERIFY(turn(Qt::ControlModifier));
    QCOMPARE(fixture.raw(1, "goal_position"), from + 11);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(slider, &leave);
    QVERIFY(slider->hasFocus());
    QVERIFY(turn({}));
    QCOMPARE(fixture.raw(1, "goal_position"), from + 11);
}

void TestControlPanel::keysMoveToTheLimits()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(sts));
    fixture.poke(1, "min_angle_limit", 1500);
    fixture.poke(1, "max_angle_limit", 2500);
    QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
    ui::ControlSlider* slider = fixture.slider();
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_position"), std::int64_t(2500));
    QTest::keyClick(slider, Qt::Key_Right); // no further
    QTest::keyClick(slider, Qt::Key_Left);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_position"), std::int64_t(2499));
    QTest::keyClick(slider, Qt::Key_Home);
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_position"), std::int64_t(1500));
}

/// A quarter of a turn at 500 steps a second takes two seconds.
void TestControlPanel::speedAndAccelerationAreApplied()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    fixture.type("speed", utf8("500"));
    fixture.type("acceleration", utf8("0"));
    QVERIFY(fixture.go(utf8("2048")));
    QVERIFY(fixture.isAtRest(1));
    QCOMPARE(fixture.raw(1, "goal_speed"), std::int64_t(500));
    const base::Duration start = fixture.workbench.now();
    ui::ControlSlider* slider = fixture.slider();
    slider->setFocus();
    QTest::mouseClick(slider, Qt::LeftButton, {}, slider->pointOf(3072));
    QVERIFY(fixture.waitUntilIdle());
    std::int64_t fastest = 0;
    QTRY_VERIFY((fastest = std::max(fastest, fixture.raw(1, "present_speed")),
                 std::abs(fixture.degrees(1) - 270) < 2));
    const double seconds = double((fixture.workbench.now() - start).count()) / 1e6;
    QVERIFY2(seconds > 1.8, qPrintable(QString::number(seconds)));
    QVERIFY2(fastest > 400 && fastest < 600, qPrintable(QString::number(fastest)));
    QVERIFY(fixture.isAtRest(1));
    // Slowly from rest: v² = 2·a·s, with some room for the servo's own control.
    fixture.type("acceleration", utf8("2")); // 200 step/s²
    QVERIFY(fixture.go(utf8("2048")));
    QTRY_VERIFY(fixture.degrees(1) < 268.5);
    const auto [speed, way] = fixture.withBus([](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(1);
        return std::pair{double(servo.raw(QStringLiteral("present_speed"))),
                         (270 - servo.shaftDegrees()) * 4096 / 360};
    });
    const QString seen = QStringLiteral("%1 step/s after %2 steps at acceleration %3")
                             .arg(speed)
                             .arg(way)
                             .arg(fixture.raw(1, "acceleration"));
    QVERIFY2(speed * speed < 2 * 200 * way * 2, qPrintable(seen));
}

void TestControlPanel::aTypedFieldIsNotOverwritten()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    fixture.type("speed", utf8("123"));
    fixture.poke(1, "goal_speed", 777);
    QVERIFY(fixture.read());
    QCOMPARE(fixture.box("speed")->text(), utf8("123"));
    QVERIFY(fixture.go(utf8("2100")));
    QCOMPARE(fixture.raw(1, "goal_speed"), std::int64_t(123));
    fixture.poke(1, "goal_speed", 888);
    QVERIFY(fixture.read());
    QCOMPARE(fixture.box("speed")->text(), utf8("888")); // typed no more: what it has
}

void TestControlPanel::aRefusedGoalStaysInTheField()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(sts));
    fixture.poke(1, "max_angle_limit", 3000);
    QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
    QVERIFY(fixture.shown());
    const auto stands = fixture.slider()->value();
    QVERIFY(fixture.go(utf8("5000")));
    QVERIFY(!fixture.complaint().isEmpty());
    QVERIFY(fixture.shown());
    QCOMPARE(fixture.box("goal")->findChild<QLineEdit*>()->text(), utf8("5000"));
    QCOMPARE(fixture.slider()->value(), stands);
    // A typed value stays when something else fails.
    fixture.type("goal", utf8("2345"));
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    QSignalSpy failed(&fixture.drive, &session::MotionController::failed);
    fixture.click("mode_speed");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(fixture.waitUntilIdle() && fixture.shown());
    QCOMPARE(fixture.box("goal")->findChild<QLineEdit*>()->text(), utf8("2345"));
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
    fixture.click("setGoal");
    QVERIFY(fixture.waitUntilIdle());
    QTRY_COMPARE(fixture.raw(1, "goal_position"), std::int64_t(2345));
}

void TestControlPanel::messagesClearOnTheNextMove()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    QVERIFY(fixture.torque());
    QVERIFY(!fixture.text("controlSaid").isEmpty());
    QVERIFY(fixture.go(utf8("2100")));
    QVERIFY2(fixture.text("controlSaid").isEmpty(), qPrintable(fixture.text("controlSaid")));
}

void TestControlPanel::servoDisappearsMidDrag()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    ui::ControlSlider* slider = fixture.slider();
    QSignalSpy failed(&fixture.drive, &session::MotionController::failed);
    QTest::mousePress(slider, Qt::LeftButton, {}, slider->pointOf(2100));
    QVERIFY(fixture.waitUntilIdle());
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    for (int goal = 2110; goal <= 2500; goal += 10) {
        QTest::mouseMove(slider, slider->pointOf(goal));
        QVERIFY(fixture.waitUntilIdle());
    }
    QCOMPARE(failed.count(), 1); // reported once
    QVERIFY(!fixture.complaint().isEmpty());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, slider->pointOf(2500));
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
    QVERIFY(fixture.go(utf8("2200"))); // and all is well when it is back
    QTRY_VERIFY(fixture.raw(1, "goal_position") == 2200);
}

void TestControlPanel::modeChangedByAnotherProgram()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    fixture.poke(1, "min_angle_limit", 0);
    fixture.poke(1, "max_angle_limit", 0);
    fixture.poke(1, "operating_mode", 3);
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("2500"))); // would be more than half a turn from here
    QVERIFY2(fixture.complaint().contains(utf8("mode")), qPrintable(fixture.complaint()));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - before) < 0.5);
    QVERIFY(fixture.shown());
    QVERIFY(fixture.has("stepPlus")); // the panel shows the mode it found
}

void TestControlPanel::storedGoalsWaitForExecute()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1,sts3215@2"), {1, 2}));
    fixture.click("howAsync");
    QVERIFY(!fixture.find<QPushButton>("execute")->isEnabled());
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("2600")));
    QVERIFY(fixture.shown() && fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - before) < 0.5);
    QVERIFY(fixture.find<QPushButton>("execute")->isEnabled());
    fixture.click("execute");
    QVERIFY(fixture.waitUntilIdle());
    for (const int id : {1, 2}) {
        QVERIFY(fixture.isAtRest(id));
        QVERIFY(std::abs(fixture.degrees(id) - 2600.0 * 360 / 4096) < 2);
    }
    QVERIFY(fixture.shown());
    QVERIFY(!fixture.find<QPushButton>("execute")->isEnabled());
}

void TestControlPanel::aStoredGoalDoesNotSurviveAModeSwitch()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    fixture.click("howAsync");
    QVERIFY(fixture.go(utf8("2600")));
    QVERIFY(fixture.read());
    QCOMPARE(fixture.entry().servo.raw(catalog::Role::AsyncFlag), std::int64_t(1));
    QVERIFY(fixture.switchModeByTile("step"));
    QVERIFY(fixture.read());
    QCOMPARE(fixture.entry().servo.raw(catalog::Role::AsyncFlag), std::int64_t(0));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QCOMPARE(fixture.drive.heldCount(), 0);
}

void TestControlPanel::severalServosMoveTogether()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1,sts3215@2,sts3215@3"), {1, 2, 3}));
    QVERIFY2(fixture.text("controlTitle").contains(utf8("+ 2 more")),
             qPrintable(fixture.text("controlTitle")));
    QVERIFY(fixture.find<QAbstractButton>("howSync")->isChecked());
    QVERIFY(fixture.go(utf8("1500")));
    for (const int id : {1, 2, 3}) {
        QVERIFY(fixture.isAtRest(id));
        QVERIFY(std::abs(fixture.degrees(id) - 1500.0 * 360 / 4096) < 2);
    }
}

void TestControlPanel::oneOfSeveralOutOfItsLimits()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(utf8("sim:sts3215@1,sts3215@2")));
    fixture.poke(2, "min_angle_limit", 1800);
    QVERIFY(fixture.search(1, 3) && fixture.choose({1, 2}));
    QVERIFY(fixture.go(utf8("1500")));
    QVERIFY2(fixture.complaint().contains(utf8("1800")), qPrintable(fixture.complaint()));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0)); // no servo moves
    QCOMPARE(fixture.raw(2, "torque_switch"), std::int64_t(0));
}

/// The others may stand at speed 0, which is the fastest.
void TestControlPanel::severalServosGetTheDisplayedSpeed()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(utf8("sim:sts3215@1,sts3215@2")));
    fixture.poke(1, "goal_speed", 321);
    fixture.poke(1, "acceleration", 20);
    fixture.poke(2, "goal_speed", 0);
    fixture.poke(2, "acceleration", 0);
    QVERIFY(fixture.search(1, 3) && fixture.choose({1, 2}));
    QCOMPARE(fixture.box("speed")->findChild<QLineEdit*>()->text(), utf8("321"));
    QVERIFY(fixture.go(utf8("2300")));
    QCOMPARE(fixture.complaint(), QString());
    for (const int id : {1, 2}) {
        QCOMPARE(fixture.raw(id, "goal_position"), std::int64_t(2300));
        QCOMPARE(fixture.raw(id, "goal_speed"), std::int64_t(321));
        QCOMPARE(fixture.raw(id, "acceleration"), std::int64_t(20));
    }
}

void TestControlPanel::torqueLimit_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QByteArray>("key");
    QTest::newRow("STS") << sts << QByteArray("torque_limit");
    QTest::newRow("SCS, until power-off") << utf8("sim:scs15@1") << QByteArray("max_torque");
}

void TestControlPanel::torqueLimit()
{
    QFETCH(QString, port);
    QFETCH(QByteArray, key);
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(port, {1}));
    fixture.click("torqueLimitMore");
    fixture.enter("stallTorque", utf8("30"));
    fixture.enter("torqueLimitPercent", utf8("40"));
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, key.constData()), std::int64_t(400));
    QCOMPARE(fixture.raw(1, "lock"), std::int64_t(1));
    QVERIFY(fixture.shown());
    QVERIFY2(fixture.text("torqueLimitForce").contains(utf8("12.0")),
             qPrintable(fixture.text("torqueLimitForce")));
    if (key == "max_torque") {
        fixture.withBus([](sim::VirtualBus& wire) { wire.powerCycle(); });
        QCOMPARE(fixture.raw(1, "max_torque"), std::int64_t(1000));
    }
}

void TestControlPanel::torqueLimitByArrowsAndNotches()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    const std::int64_t from = fixture.raw(1, "torque_limit");
    QCOMPARE(from, std::int64_t(1000));
    QAbstractSpinBox* box = fixture.box("torqueLimitPercent");
    QSignalSpy written(&fixture.workbench, &session::Workbench::eventOccurred);
    const auto writes = [&] {
        return std::count_if(written.begin(), written.end(), [](const QList<QVariant>& one) {
            return one.first().value<session::Event>().kind == session::Event::Kind::Written;
        });
    };
    box->setFocus();
    box->stepDown(); // as the arrow does
    QTest::keyClick(box, Qt::Key_Down);
    QVERIFY(fixture.read()); // a reading meanwhile takes nothing away
    QCOMPARE(fixture.raw(1, "torque_limit"), from);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(fixture.waitUntilIdle() && fixture.shown());
    QCOMPARE(fixture.raw(1, "torque_limit"), from - 20);
    QCOMPARE(writes(), std::ptrdiff_t(1));
    fixture.box("goal")->setFocus(); // leaving the box sends nothing more
    QVERIFY(fixture.waitUntilIdle() && fixture.shown());
    QCOMPARE(writes(), std::ptrdiff_t(1));
    fixture.click("torqueLimitMore");
    auto* slider = fixture.find<ui::ControlSlider>("torqueLimitSlider");
    for (int notch = 0; notch < 5; ++notch) {
        QTest::keyClick(slider, Qt::Key_PageDown);
        QVERIFY(fixture.shown()); // while the first one is on its way
    }
    QTRY_COMPARE(fixture.raw(1, "torque_limit"), from - 20 - 250);
    QVERIFY(fixture.waitUntilIdle() && fixture.shown());
    QCOMPARE(*slider->value(), from - 20 - 250);
}

void TestControlPanel::stopBlocksUntilTorqueIsOn()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(sts, {1}));
    fixture.type("speed", utf8("200"));
    QVERIFY(fixture.go(utf8("3500")));
    fixture.workbench.emergencyStop().trigger();
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.shown());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(!fixture.text("controlStopped").isEmpty());
    QVERIFY(!fixture.find<QWidget>("controlGoal")->isEnabled());
    fixture.drive.move({utf8("2100")}); // also for requests from elsewhere
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(fixture.torque());
    QVERIFY(fixture.text("controlStopped").isEmpty());
    QVERIFY(fixture.find<QWidget>("controlGoal")->isEnabled());
}

SERVODESK_TEST(TestControlPanel)
#include "tst_control_panel.moc"

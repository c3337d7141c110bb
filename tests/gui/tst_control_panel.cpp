// SPDX-License-Identifier: GPL-3.0-or-later
// The control panel as a technician meets it: nothing moves unasked, limits and reasons, dragging,
// write kinds, torque on where the shaft stands, and trouble in the middle of all that.
#include "gui/control_bench.h"

using gui::ControlBench;
using session::LinkState;

namespace {
QString text(const char* words)
{
    return QString::fromUtf8(words);
}

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

    void nothingMovesUnasked();
    void emptyPanelSaysWhy();
    void hintBeforeTheFirstTorque();
    void theHintsDeedStaysInItsMode_data();
    void theHintsDeedStaysInItsMode();
    void aStopForgetsTheHintsDeed();
    void torqueOnHoldsWhereItStands_data();
    void torqueOnHoldsWhereItStands();
    void torqueOnAfterThreeTurns();
    void goalsOutsideTheLimitsAreRefused();
    void draggingSendsTheLatestGoal();
    void wheelMovesOnlyAfterAClick();
    void keysMoveToTheLimits();
    void speedAndAccelerationAreHonoured();
    void aTypedFieldIsNotOverwritten();
    void aRefusedGoalStaysToBeCorrected();
    void whatWasSaidGoesWithTheNextMove();
    void servoVanishesMidDrag();
    void modeChangedByAnotherProgram();
    void heldGoalsWaitForExecute();
    void aHeldGoalDoesNotSurviveAModeSwitch();
    void severalMoveTogether();
    void oneOfSeveralOutOfItsLimits();
    void severalGetTheSpeedThatIsShown();
    void torqueLimit_data();
    void torqueLimit();
    void torqueLimitByArrowsAndNotches();
    void stopBlocksUntilTorqueIsOn();
};

void TestControlPanel::nothingMovesUnasked()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(text("sim:demo")));
    QVERIFY(bench.search(1, 6));
    std::vector<double> before;
    for (int id = 1; id <= 6; ++id)
        before.push_back(bench.degrees(id));
    for (int id = 1; id <= 6; ++id) {
        QVERIFY(bench.choose({id}));
        QVERIFY(bench.raw(id, "torque_switch") == 0 || id == 6);
    }
    QVERIFY(bench.session.journal().entries()->empty());
    for (int id = 1; id <= 6; ++id)
        QVERIFY(std::abs(bench.degrees(id) - before[std::size_t(id - 1)]) < 0.5 || id == 6);
}

void TestControlPanel::emptyPanelSaysWhy()
{
    ControlBench bench;
    QVERIFY(bench.text("controlEmpty").contains(text("Choose a servo")));
    QVERIFY(!bench.has("controlGoal"));
    QVERIFY(bench.ready(sts, {1}));
    QVERIFY(bench.text("controlEmpty").isEmpty());
    QVERIFY(bench.has("controlGoal"));
    QVERIFY(bench.text("controlTitle").contains(text("ID 1")));
}

void TestControlPanel::hintBeforeTheFirstTorque()
{
    ControlBench bench;
    bench.settings.setChoice(text("operate/no_torque_hint"), false);
    QVERIFY(bench.ready(sts, {1}));
    bench.click("torqueSwitch");
    QVERIFY(bench.has("torqueHint"));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    bench.click("torqueHintCancel");
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    bench.click("torqueSwitch");
    bench.click("torqueHintGo");
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(bench.shown() && bench.torque()); // off again
    QVERIFY(bench.torque());                  // and on, without a word
    QVERIFY(!bench.has("torqueHint"));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(1));
}

void TestControlPanel::theHintsDeedStaysInItsMode_data()
{
    QTest::addColumn<bool>("byAnother");
    QTest::newRow("switched here") << false;
    QTest::newRow("by another program") << true;
}

/// 3000 is a place in one mode and a speed in another.
void TestControlPanel::theHintsDeedStaysInItsMode()
{
    QFETCH(bool, byAnother);
    ControlBench bench;
    bench.settings.setChoice(text("operate/no_torque_hint"), false);
    QVERIFY(bench.ready(sts, {1}));
    const std::int64_t speed = byAnother ? bench.raw(1, "goal_speed") : 0; // a switch here ends it
    bench.type("goal", text("3000"));
    bench.click("setGoal");
    QVERIFY(bench.has("torqueHint"));
    if (byAnother) {
        bench.poke(1, "operating_mode", 1);
        QVERIFY(bench.read());
    } else {
        QVERIFY(bench.switchTo("speed"));
    }
    QVERIFY(!bench.has("torqueHint"));
    // Even an answer that was on its way already does nothing.
    bench.find<QPushButton>("torqueHintGo")->click();
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_speed"), speed);
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
}

void TestControlPanel::aStopForgetsTheHintsDeed()
{
    ControlBench bench;
    bench.settings.setChoice(text("operate/no_torque_hint"), false);
    QVERIFY(bench.ready(text("sim:sts3215@1,sts3215@2"), {1}));
    bench.click("torqueSwitch");
    QVERIFY(bench.has("torqueHint"));
    bench.desk.emergencyStop();
    QVERIFY(bench.settled());
    QVERIFY(!bench.has("torqueHint"));
    bench.click("torqueSwitch");
    QVERIFY(bench.has("torqueHint"));
    QVERIFY(bench.choose({2}));
    QVERIFY(!bench.has("torqueHint"));
    bench.find<QPushButton>("torqueHintGo")->click();
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QCOMPARE(bench.raw(2, "torque_switch"), std::int64_t(0));
}

void TestControlPanel::torqueOnHoldsWhereItStands_data()
{
    QTest::addColumn<int>("factor");
    QTest::addColumn<int>("oldGoal");
    QTest::newRow("turned by 90°") << 1 << 1024;
    QTest::newRow("factor 2") << 2 << 200;
}

void TestControlPanel::torqueOnHoldsWhereItStands()
{
    QFETCH(int, factor);
    QFETCH(int, oldGoal);
    ControlBench bench;
    QVERIFY(bench.connectTo(sts)); // it stands at 180°
    bench.poke(1, "angle_resolution", factor);
    bench.poke(1, "goal_position", oldGoal);
    bench.poke(1, "torque_switch", 0);
    QVERIFY(bench.search(1, 2) && bench.choose({1}));
    const double before = bench.degrees(1);
    QVERIFY(bench.torque());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - before) <= 2 * 360.0 / 4096 * factor);
}

void TestControlPanel::torqueOnAfterThreeTurns()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    QVERIFY(bench.switchTo("multiturn"));
    QVERIFY(bench.go(QString::number(2048 + 3 * 4096)));
    QVERIFY(bench.atRest(1));
    QVERIFY(bench.shown() && bench.torque()); // off
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    const double before = bench.degrees(1);
    QVERIFY(bench.torque());
    QVERIFY(bench.atRest(1));
    const bool moved = std::abs(bench.degrees(1) - before) > 2 * 360.0 / 4096;
    const bool refused = bench.raw(1, "torque_switch") == 0 && !bench.complaint().isEmpty();
    QVERIFY2(!moved && (refused || bench.raw(1, "torque_switch") == 1),
             qPrintable(bench.complaint()));
}

void TestControlPanel::goalsOutsideTheLimitsAreRefused()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(sts));
    bench.poke(1, "min_angle_limit", 1000);
    bench.poke(1, "max_angle_limit", 3000);
    QVERIFY(bench.search(1, 2) && bench.choose({1}));
    QCOMPARE(bench.slider()->scale().min, std::int64_t(1000));
    QCOMPARE(bench.slider()->scale().max, std::int64_t(3000));
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("3500")));
    QVERIFY2(bench.complaint().contains(text("1000 … 3000")), qPrintable(bench.complaint()));
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - before) < 0.5);
    // The slider cannot be drawn there.
    QTest::mouseClick(bench.slider(), Qt::LeftButton, {}, bench.slider()->placeOf(3900));
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_position"), std::int64_t(3000));
}

void TestControlPanel::draggingSendsTheLatestGoal()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    ui::ControlSlider* slider = bench.slider();
    QSignalSpy sent(&bench.drive, &session::Drive::sent);
    QTest::mousePress(slider, Qt::LeftButton, {}, slider->placeOf(2100));
    for (int goal = 2100; goal <= 3000; goal += 10)
        QTest::mouseMove(slider, slider->placeOf(goal));
    QTRY_VERIFY(sent.count() >= 2); // on the way, and the last one
    QTest::mouseRelease(slider, Qt::LeftButton, {}, slider->placeOf(3000));
    QVERIFY(bench.settled());
    QVERIFY(sent.count() < 40); // ninety moves of the mouse, but no queue
    QVERIFY(std::abs(bench.raw(1, "goal_position") - 3000) < 20);
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - double(bench.raw(1, "goal_position")) * 360 / 4096) < 2);
}

void TestControlPanel::wheelMovesOnlyAfterAClick()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    ui::ControlSlider* slider = bench.slider();
    const auto turn = [&](Qt::KeyboardModifiers with) {
        const QPointF middle = slider->rect().center();
        QWheelEvent event(middle, slider->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, with,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider, &event);
        return bench.settled();
    };
    bench.box("goal")->setFocus();
    QVERIFY(turn({}));
    slider->setFocus(Qt::TabFocusReason); // reached with the keyboard while the page is scrolled
    QVERIFY(turn({}));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QTest::mouseClick(slider, Qt::LeftButton, {}, slider->placeOf(2500));
    QVERIFY(bench.settled() && bench.shown());
    const std::int64_t from = *slider->value();
    QVERIFY(turn({}));
    QVERIFY(turn(Qt::ControlModifier));
    QCOMPARE(bench.raw(1, "goal_position"), from + 11);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(slider, &leave);
    QVERIFY(slider->hasFocus());
    QVERIFY(turn({}));
    QCOMPARE(bench.raw(1, "goal_position"), from + 11);
}

void TestControlPanel::keysMoveToTheLimits()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(sts));
    bench.poke(1, "min_angle_limit", 1500);
    bench.poke(1, "max_angle_limit", 2500);
    QVERIFY(bench.search(1, 2) && bench.choose({1}));
    ui::ControlSlider* slider = bench.slider();
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_position"), std::int64_t(2500));
    QTest::keyClick(slider, Qt::Key_Right); // no further
    QTest::keyClick(slider, Qt::Key_Left);
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_position"), std::int64_t(2499));
    QTest::keyClick(slider, Qt::Key_Home);
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_position"), std::int64_t(1500));
}

/// A quarter of a turn at 500 steps a second takes two seconds.
void TestControlPanel::speedAndAccelerationAreHonoured()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    bench.type("speed", text("500"));
    bench.type("acceleration", text("0"));
    QVERIFY(bench.go(text("2048")));
    QVERIFY(bench.atRest(1));
    QCOMPARE(bench.raw(1, "goal_speed"), std::int64_t(500));
    const base::Duration start = bench.desk.now();
    ui::ControlSlider* slider = bench.slider();
    slider->setFocus();
    QTest::mouseClick(slider, Qt::LeftButton, {}, slider->placeOf(3072));
    QVERIFY(bench.settled());
    std::int64_t fastest = 0;
    QTRY_VERIFY_WITH_TIMEOUT((fastest = std::max(fastest, bench.raw(1, "present_speed")),
                              std::abs(bench.degrees(1) - 270) < 2),
                             10000);
    const double seconds = double((bench.desk.now() - start).count()) / 1e6;
    QVERIFY2(seconds > 1.8, qPrintable(QString::number(seconds)));
    QVERIFY2(fastest > 400 && fastest < 600, qPrintable(QString::number(fastest)));
    QVERIFY(bench.atRest(1));
    // Slowly from rest: v² = 2·a·s, with some room for the servo's own control.
    bench.type("acceleration", text("2")); // 200 step/s²
    QVERIFY(bench.go(text("2048")));
    QTRY_VERIFY(bench.degrees(1) < 268.5);
    const auto [speed, way] = bench.withWire([](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(1);
        return std::pair{double(servo.raw(QStringLiteral("present_speed"))),
                         (270 - servo.shaftDegrees()) * 4096 / 360};
    });
    const QString seen = QStringLiteral("%1 step/s after %2 steps at acceleration %3")
                             .arg(speed)
                             .arg(way)
                             .arg(bench.raw(1, "acceleration"));
    QVERIFY2(speed * speed < 2 * 200 * way * 2, qPrintable(seen));
}

void TestControlPanel::aTypedFieldIsNotOverwritten()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    bench.type("speed", text("123"));
    bench.poke(1, "goal_speed", 777);
    QVERIFY(bench.read());
    QCOMPARE(bench.box("speed")->text(), text("123"));
    QVERIFY(bench.go(text("2100")));
    QCOMPARE(bench.raw(1, "goal_speed"), std::int64_t(123));
    bench.poke(1, "goal_speed", 888);
    QVERIFY(bench.read());
    QCOMPARE(bench.box("speed")->text(), text("888")); // typed no more: what it has
}

void TestControlPanel::aRefusedGoalStaysToBeCorrected()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(sts));
    bench.poke(1, "max_angle_limit", 3000);
    QVERIFY(bench.search(1, 2) && bench.choose({1}));
    QVERIFY(bench.go(text("5000")));
    QVERIFY(!bench.complaint().isEmpty());
    QVERIFY(bench.shown());
    QCOMPARE(bench.box("goal")->findChild<QLineEdit*>()->text(), text("5000"));
    QCOMPARE(*bench.slider()->value(), std::int64_t(2048)); // where it stands
    // What is being typed outlives whatever else fails.
    bench.type("goal", text("2345"));
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    QSignalSpy failed(&bench.drive, &session::Drive::failed);
    bench.click("mode_speed");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(bench.settled() && bench.shown());
    QCOMPARE(bench.box("goal")->findChild<QLineEdit*>()->text(), text("2345"));
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
    bench.click("setGoal");
    QVERIFY(bench.settled());
    QTRY_COMPARE(bench.raw(1, "goal_position"), std::int64_t(2345));
}

void TestControlPanel::whatWasSaidGoesWithTheNextMove()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    QVERIFY(bench.torque());
    QVERIFY(!bench.text("controlSaid").isEmpty());
    QVERIFY(bench.go(text("2100")));
    QVERIFY2(bench.text("controlSaid").isEmpty(), qPrintable(bench.text("controlSaid")));
}

void TestControlPanel::servoVanishesMidDrag()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    ui::ControlSlider* slider = bench.slider();
    QSignalSpy failed(&bench.drive, &session::Drive::failed);
    QTest::mousePress(slider, Qt::LeftButton, {}, slider->placeOf(2100));
    QVERIFY(bench.settled());
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    for (int goal = 2110; goal <= 2500; goal += 10) {
        QTest::mouseMove(slider, slider->placeOf(goal));
        QVERIFY(bench.settled());
    }
    QCOMPARE(failed.count(), 1); // told once
    QVERIFY(!bench.complaint().isEmpty());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, slider->placeOf(2500));
    bench.withWire([](sim::VirtualBus& wire) { wire.servo(1)->powerOn(); });
    QVERIFY(bench.go(text("2200"))); // and all is well when it is back
    QTRY_VERIFY(bench.raw(1, "goal_position") == 2200);
}

void TestControlPanel::modeChangedByAnotherProgram()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    bench.poke(1, "min_angle_limit", 0);
    bench.poke(1, "max_angle_limit", 0);
    bench.poke(1, "operating_mode", 3);
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("2500"))); // would be more than half a turn from here
    QVERIFY2(bench.complaint().contains(text("mode")), qPrintable(bench.complaint()));
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - before) < 0.5);
    QVERIFY(bench.shown());
    QVERIFY(bench.has("stepPlus")); // the panel shows the mode it found
}

void TestControlPanel::heldGoalsWaitForExecute()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1,sts3215@2"), {1, 2}));
    bench.click("howAsync");
    QVERIFY(!bench.find<QPushButton>("execute")->isEnabled());
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("2600")));
    QVERIFY(bench.shown() && bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - before) < 0.5);
    QVERIFY(bench.find<QPushButton>("execute")->isEnabled());
    bench.click("execute");
    QVERIFY(bench.settled());
    for (const int id : {1, 2}) {
        QVERIFY(bench.atRest(id));
        QVERIFY(std::abs(bench.degrees(id) - 2600.0 * 360 / 4096) < 2);
    }
    QVERIFY(bench.shown());
    QVERIFY(!bench.find<QPushButton>("execute")->isEnabled());
}

void TestControlPanel::aHeldGoalDoesNotSurviveAModeSwitch()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    bench.click("howAsync");
    QVERIFY(bench.go(text("2600")));
    QVERIFY(bench.read());
    QCOMPARE(bench.entry().servo.raw(catalog::Role::AsyncFlag), std::int64_t(1));
    QVERIFY(bench.switchTo("step"));
    QVERIFY(bench.read());
    QCOMPARE(bench.entry().servo.raw(catalog::Role::AsyncFlag), std::int64_t(0));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QCOMPARE(bench.drive.held(), 0);
}

void TestControlPanel::severalMoveTogether()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1,sts3215@2,sts3215@3"), {1, 2, 3}));
    QVERIFY2(bench.text("controlTitle").contains(text("+ 2 more")),
             qPrintable(bench.text("controlTitle")));
    QVERIFY(bench.find<QToolButton>("howSync")->isChecked());
    QVERIFY(bench.go(text("1500")));
    for (const int id : {1, 2, 3}) {
        QVERIFY(bench.atRest(id));
        QVERIFY(std::abs(bench.degrees(id) - 1500.0 * 360 / 4096) < 2);
    }
}

void TestControlPanel::oneOfSeveralOutOfItsLimits()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(text("sim:sts3215@1,sts3215@2")));
    bench.poke(2, "min_angle_limit", 1800);
    QVERIFY(bench.search(1, 3) && bench.choose({1, 2}));
    QVERIFY(bench.go(text("1500")));
    QVERIFY2(bench.complaint().contains(text("1800")), qPrintable(bench.complaint()));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0)); // nobody moves
    QCOMPARE(bench.raw(2, "torque_switch"), std::int64_t(0));
}

/// The others may stand at speed 0, which is the fastest.
void TestControlPanel::severalGetTheSpeedThatIsShown()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(text("sim:sts3215@1,sts3215@2")));
    bench.poke(1, "goal_speed", 321);
    bench.poke(1, "acceleration", 20);
    bench.poke(2, "goal_speed", 0);
    bench.poke(2, "acceleration", 0);
    QVERIFY(bench.search(1, 3) && bench.choose({1, 2}));
    QCOMPARE(bench.box("speed")->findChild<QLineEdit*>()->text(), text("321"));
    QVERIFY(bench.go(text("2300")));
    QCOMPARE(bench.complaint(), QString());
    for (const int id : {1, 2}) {
        QCOMPARE(bench.raw(id, "goal_position"), std::int64_t(2300));
        QCOMPARE(bench.raw(id, "goal_speed"), std::int64_t(321));
        QCOMPARE(bench.raw(id, "acceleration"), std::int64_t(20));
    }
}

void TestControlPanel::torqueLimit_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QByteArray>("key");
    QTest::newRow("STS") << sts << QByteArray("torque_limit");
    QTest::newRow("SCS, until power-off") << text("sim:scs15@1") << QByteArray("max_torque");
}

void TestControlPanel::torqueLimit()
{
    QFETCH(QString, port);
    QFETCH(QByteArray, key);
    ControlBench bench;
    QVERIFY(bench.ready(port, {1}));
    bench.enter("stallTorque", text("30"));
    bench.enter("torqueLimitPercent", text("40"));
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, key.constData()), std::int64_t(400));
    QCOMPARE(bench.raw(1, "lock"), std::int64_t(1));
    QVERIFY(bench.shown());
    QVERIFY2(bench.text("torqueLimitForce").contains(text("12.0")),
             qPrintable(bench.text("torqueLimitForce")));
    if (key == "max_torque") {
        bench.withWire([](sim::VirtualBus& wire) { wire.powerCycle(); });
        QCOMPARE(bench.raw(1, "max_torque"), std::int64_t(1000));
    }
}

void TestControlPanel::torqueLimitByArrowsAndNotches()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    const std::int64_t from = bench.raw(1, "torque_limit");
    QCOMPARE(from, std::int64_t(1000));
    QAbstractSpinBox* box = bench.box("torqueLimitPercent");
    QSignalSpy written(&bench.desk, &session::Desk::happened);
    const auto writes = [&] {
        return std::count_if(written.begin(), written.end(), [](const QList<QVariant>& one) {
            return one.first().value<session::Event>().kind == session::Event::Kind::Written;
        });
    };
    box->setFocus();
    box->stepDown(); // as the arrow does
    QTest::keyClick(box, Qt::Key_Down);
    QVERIFY(bench.read()); // a reading meanwhile takes nothing away
    QCOMPARE(bench.raw(1, "torque_limit"), from);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(bench.settled() && bench.shown());
    QCOMPARE(bench.raw(1, "torque_limit"), from - 20);
    QCOMPARE(writes(), std::ptrdiff_t(1));
    bench.box("goal")->setFocus(); // leaving the box sends nothing more
    QVERIFY(bench.settled() && bench.shown());
    QCOMPARE(writes(), std::ptrdiff_t(1));
    auto* slider = bench.find<ui::ControlSlider>("torqueLimitSlider");
    for (int notch = 0; notch < 5; ++notch) {
        QTest::keyClick(slider, Qt::Key_PageDown);
        QVERIFY(bench.shown()); // while the first one is on its way
    }
    QTRY_COMPARE(bench.raw(1, "torque_limit"), from - 20 - 250);
    QVERIFY(bench.settled() && bench.shown());
    QCOMPARE(*slider->value(), from - 20 - 250);
}

void TestControlPanel::stopBlocksUntilTorqueIsOn()
{
    ControlBench bench;
    QVERIFY(bench.ready(sts, {1}));
    bench.type("speed", text("200"));
    QVERIFY(bench.go(text("3500")));
    bench.desk.emergencyStop();
    QVERIFY(bench.settled());
    QVERIFY(bench.shown());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(!bench.text("controlStopped").isEmpty());
    QVERIFY(!bench.find<QWidget>("controlGoal")->isEnabled());
    bench.drive.move({text("2100")}); // whoever asks
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(bench.torque());
    QVERIFY(bench.text("controlStopped").isEmpty());
    QVERIFY(bench.find<QWidget>("controlGoal")->isEnabled());
}

QTEST_MAIN(TestControlPanel)
#include "tst_control_panel.moc"

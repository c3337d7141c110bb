// SPDX-License-Identifier: GPL-3.0-or-later
// Every mode of every family through the widgets of the panel: the servo moves as its data sheet
// says, in the direction the panel shows, and a change of mode starts nothing.
#include "gui/control_panel_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

using gui::ControlPanelFixture;
using support::utf8;

namespace {
constexpr double stepDegrees = 360.0 / 4096;
} // namespace

class TestControlModes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::initProgram(); }
    void init()
    {
        QTest::failOnWarning(
            QRegularExpression(QStringLiteral("^(?!This plugin does not support )")));
    }

    void positionGoesToItsGoal_data();
    void positionGoesToItsGoal();
    void multiTurnMakesTwoTurns();
    void stepsRepeatAQuarterTurn();
    void stepsEndAtSevenAndAHalfTurns();
    void speedTurnsClockwise();
    void pwmTurnsTheOtherWay_data();
    void pwmTurnsTheOtherWay();
    void scsMotorAndBack();
    void limitsComeBackAfterARestart();
    void lxMotorTurnsBothWays();
    void hlsPushesWithACurrent();
    void modbusSteps();
    void switchingStartsNothing_data();
    void switchingStartsNothing();
    void resolutionFactorIsApplied();
};

void TestControlModes::positionGoesToItsGoal_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<double>("degrees");
    QTest::newRow("STS") << utf8("sim:sts3215@1") << utf8("1024") << 90.0;
    QTest::newRow("STS in degrees") << utf8("sim:sts3215@1") << utf8("135deg") << 135.0;
    QTest::newRow("SMS") << utf8("sim:sm40blhv@1") << utf8("3000") << 3000 * stepDegrees;
    QTest::newRow("HLS") << utf8("sim:hls3625@1") << utf8("2500") << 2500 * stepDegrees;
    QTest::newRow("LX") << utf8("sim:lx-16a@1") << utf8("700") << 168.0;
    QTest::newRow("Modbus") << utf8("sim:smsmb@1") << utf8("1500") << 1500 * stepDegrees;
}

void TestControlModes::positionGoesToItsGoal()
{
    QFETCH(QString, port);
    QFETCH(QString, goal);
    QFETCH(double, degrees);
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(port, {1}));
    QVERIFY(fixture.go(goal));
    QCOMPARE(fixture.complaint(), QString());
    QVERIFY(fixture.isAtRest(1));
    QVERIFY2(std::abs(fixture.degrees(1) - degrees) < 1.5,
             qPrintable(QString::number(fixture.degrees(1))));
}

void TestControlModes::multiTurnMakesTwoTurns()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1"), {1}));
    QVERIFY(fixture.switchModeByTile("multiturn"));
    QVERIFY2(fixture.confirmationText.contains(utf8("will be saved and then restored")),
             qPrintable(fixture.confirmationText));
    const double before = fixture.degrees(1);
    const std::int64_t from = fixture.entry().servo.raw(catalog::Role::PresentPosition).value();
    QVERIFY(fixture.go(QString::number(from + 8192)));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY2(std::abs(fixture.degrees(1) - before - 720) < 2,
             qPrintable(QString::number(fixture.degrees(1) - before)));
}

void TestControlModes::stepsRepeatAQuarterTurn()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1"), {1}));
    QVERIFY(fixture.switchModeByTile("step"));
    QVERIFY(!fixture.find<QPushButton>("stepAgain")->isEnabled());
    QVERIFY(fixture.find<QPushButton>("stepPlus")->text().startsWith(utf8("↻")));
    const double before = fixture.degrees(1);
    fixture.click("stepPlus"); // a quarter of a turn to begin with
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - before - 90) < 2); // clockwise
    for (int quarter = 2; quarter <= 4; ++quarter) {
        QVERIFY(fixture.shown());
        fixture.click("stepAgain");
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(fixture.isAtRest(1));
        QVERIFY2(std::abs(fixture.degrees(1) - before - 90 * quarter) < 2,
                 qPrintable(QString::number(fixture.degrees(1) - before)));
    }
    QVERIFY(fixture.shown());
    QVERIFY(fixture.text("stepsLeft").contains(utf8("4096")));
    QVERIFY(fixture.text("stepsLeft").contains(QString::number(30719 - 4096)));
}

void TestControlModes::stepsEndAtSevenAndAHalfTurns()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1"), {1}));
    QVERIFY(fixture.switchModeByTile("step"));
    fixture.type("goal", utf8("30000"));
    fixture.click("stepMinus");
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.complaint(), QString());
    QVERIFY(fixture.shown());
    const std::int64_t goal = fixture.raw(1, "goal_position");
    fixture.click("stepAgain");
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY2(fixture.complaint().contains(utf8("7.5 turns")), qPrintable(fixture.complaint()));
    QCOMPARE(fixture.raw(1, "goal_position"), goal);
    QCOMPARE(fixture.drive.totalSteps(fixture.selection.current()), std::int64_t(-30000));
}

void TestControlModes::speedTurnsClockwise()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:sts3215@1"), {1}));
    QVERIFY(fixture.switchModeByTile("speed"));
    QVERIFY(fixture.text("goalWay").contains(utf8("+ ↻")));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("1000")));
    QTRY_VERIFY(fixture.degrees(1) > before + 90);
    QTRY_VERIFY(std::abs(fixture.raw(1, "present_speed") - 1000) < 60);
    QVERIFY(fixture.go(utf8("-1000")));
    QTRY_VERIFY(std::abs(fixture.raw(1, "present_speed") + 1000) < 60);
    fixture.click("goalStop");
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.isAtRest(1));
    QCOMPARE(fixture.raw(1, "goal_speed"), std::int64_t(0));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(1)); // held, not let go
}

void TestControlModes::pwmTurnsTheOtherWay_data()
{
    QTest::addColumn<QString>("port");
    QTest::newRow("STS") << utf8("sim:sts3215@1");
    QTest::newRow("SMS") << utf8("sim:sm40blhv@1");
}

void TestControlModes::pwmTurnsTheOtherWay()
{
    QFETCH(QString, port);
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(port, {1}));
    QVERIFY(fixture.switchModeByTile("pwm"));
    QVERIFY(fixture.text("goalWay").contains(utf8("+ ↺")));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("200")));
    QTRY_VERIFY(fixture.degrees(1) < before - 30); // counter-clockwise
    QVERIFY(fixture.raw(1, "present_speed") < 0);
    QVERIFY(fixture.raw(1, "present_load") > 0);
    QVERIFY(fixture.go(utf8("-200")));
    const double turned = fixture.degrees(1);
    QTRY_VERIFY(fixture.degrees(1) > turned + 30);
    QVERIFY(fixture.raw(1, "present_speed") > 0);
    fixture.click("goalStop");
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.isAtRest(1));
}

void TestControlModes::scsMotorAndBack()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:scs15@1"), {1}));
    const std::int64_t min = fixture.raw(1, "min_angle_limit");
    const std::int64_t max = fixture.raw(1, "max_angle_limit");
    QVERIFY(min != 0 || max != 0);
    QVERIFY(fixture.switchModeByTile("motor"));
    QCOMPARE(fixture.raw(1, "max_angle_limit"), std::int64_t(0));
    QVERIFY(!fixture.has("speedField") && !fixture.has("timeField"));
    QVERIFY(fixture.go(utf8("-200")));
    QTRY_VERIFY(fixture.raw(1, "present_speed") > 0);
    QVERIFY(fixture.raw(1, "present_load") < 0);
    QVERIFY(fixture.switchModeByTile("position"));
    QVERIFY2(fixture.confirmationText.contains(utf8("are restored")),
             qPrintable(fixture.confirmationText));
    QCOMPARE(fixture.raw(1, "min_angle_limit"), min);
    QCOMPARE(fixture.raw(1, "max_angle_limit"), max);
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
}

/// The limits are remembered in the journal, not in the program.
void TestControlModes::limitsComeBackAfterARestart()
{
    const support::TemporaryDataFolder both;
    constexpr std::int64_t min = 300;
    constexpr std::int64_t max = 3333;
    {
        ControlPanelFixture fixture(both.path());
        QVERIFY(fixture.connectTo(utf8("sim:sts3215@1")));
        fixture.poke(1, "min_angle_limit", min);
        fixture.poke(1, "max_angle_limit", max);
        QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
        QVERIFY(fixture.switchModeByTile("multiturn"));
    }
    // A simulated servo forgets with its connection; a real one would have kept this.
    ControlPanelFixture fixture(both.path());
    QVERIFY(fixture.connectTo(utf8("sim:sts3215@1")));
    fixture.poke(1, "min_angle_limit", 0);
    fixture.poke(1, "max_angle_limit", 0);
    QVERIFY(fixture.search(1, 2) && fixture.choose({1}));
    QVERIFY(fixture.switchModeByTile("position"));
    QCOMPARE(fixture.raw(1, "min_angle_limit"), min);
    QCOMPARE(fixture.raw(1, "max_angle_limit"), max);
}

void TestControlModes::lxMotorTurnsBothWays()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:lx-16a@1"), {1}));
    QVERIFY(fixture.has("timeField"));
    QVERIFY(!fixture.has("speedField") && !fixture.has("accelerationField"));
    QVERIFY(fixture.switchModeByTile("motor"));
    QVERIFY(!fixture.has("timeField"));
    QVERIFY(fixture.text("goalWay").contains(utf8("reverse")));
    double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("500")));
    QTRY_VERIFY(fixture.degrees(1) > before + 20);
    QVERIFY(fixture.go(utf8("-500")));
    before = fixture.degrees(1);
    QTRY_VERIFY(fixture.degrees(1) < before - 20);
    fixture.click("goalStop");
    QVERIFY(fixture.waitUntilIdle());
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(fixture.switchModeByTile("position"));
    QVERIFY(fixture.isAtRest(1));
}

void TestControlModes::hlsPushesWithACurrent()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:hls3625@1"), {1}));
    QVERIFY(fixture.has("currentField") && fixture.has("speedField"));
    fixture.type("current", utf8("80"));
    QVERIFY(fixture.go(utf8("2600")));
    QCOMPARE(fixture.raw(1, "goal_current"), std::int64_t(80)); // the limit of this move
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(fixture.switchModeByTile("current"));
    QVERIFY(!fixture.has("currentField"));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.go(utf8("60")));
    QTRY_VERIFY(std::abs(fixture.degrees(1) - before) > 20);
    fixture.click("goalStop");
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.raw(1, "goal_current"), std::int64_t(0));
    QVERIFY(fixture.switchModeByTile("position"));
    QVERIFY(fixture.raw(1, "goal_current") > 0); // a limit again, not no torque at all
}

void TestControlModes::modbusSteps()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(utf8("sim:smsmb@1"), {1}));
    QVERIFY(!fixture.has("howSync") && !fixture.has("howAsync"));
    QVERIFY(fixture.switchModeByTile("step"));
    const double before = fixture.degrees(1);
    fixture.click("stepMinus");
    QVERIFY(fixture.waitUntilIdle());
    QCOMPARE(fixture.complaint(), QString());
    QVERIFY(fixture.isAtRest(1));
    QVERIFY2(std::abs(fixture.degrees(1) - before + 90) < 2,
             qPrintable(QString::number(fixture.degrees(1) - before)));
}

void TestControlModes::switchingStartsNothing_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QByteArray>("mode");
    QTest::newRow("SCS with a time") << utf8("sim:scs15@1+run-to-goal=1") << QByteArray("goal_time")
                                     << 1000 << QByteArray("motor");
    QTest::newRow("STS with a speed, to speed")
        << utf8("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_speed") << 2500
        << QByteArray("speed");
    QTest::newRow("STS with a PWM") << utf8("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_pwm")
                                    << 300 << QByteArray("pwm");
    QTest::newRow("STS with a goal, to step")
        << utf8("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_position") << 2048
        << QByteArray("step");
    QTest::newRow("HLS") << utf8("sim:hls3625@1+run-to-goal=1") << QByteArray("goal_speed") << 40
                         << QByteArray("speed");
}

void TestControlModes::switchingStartsNothing()
{
    QFETCH(QString, port);
    QFETCH(QByteArray, key);
    QFETCH(int, raw);
    QFETCH(QByteArray, mode);
    ControlPanelFixture fixture;
    QVERIFY(fixture.ready(port, {1}));
    fixture.poke(1, key.constData(), raw);
    QVERIFY(fixture.torque()); // holds where it is
    QVERIFY(fixture.isAtRest(1));
    const double before = fixture.degrees(1);
    QVERIFY(fixture.switchModeByTile(mode.constData()));
    QVERIFY(fixture.confirmationText.contains(utf8("Torque is turned off")));
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(fixture.torque());
    QCOMPARE(fixture.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(fixture.isAtRest(1));
    QVERIFY2(std::abs(fixture.degrees(1) - before) < 1,
             qPrintable(QString::number(fixture.degrees(1) - before)));
}

/// The panel counts in units of the goal, each of which is several steps.
void TestControlModes::resolutionFactorIsApplied()
{
    ControlPanelFixture fixture;
    QVERIFY(fixture.connectTo(utf8("sim:sts3215@1")));
    fixture.poke(1, "angle_resolution", 2);
    QVERIFY(fixture.search(1, 2));
    QVERIFY(fixture.choose({1}));
    QCOMPARE(fixture.slider()->scale().max, std::int64_t(4095 / 2));
    QVERIFY(fixture.go(utf8("600")));
    QCOMPARE(fixture.complaint(), QString());
    QVERIFY(fixture.isAtRest(1));
    QVERIFY(std::abs(fixture.degrees(1) - 1200 * stepDegrees) < 1.5);
    QVERIFY2(fixture.text("goalPhysical").startsWith(utf8("105")),
             qPrintable(fixture.text("goalPhysical") + fixture.box("goal")->text()));
}

SERVODESK_TEST(TestControlModes)
#include "tst_control_modes.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Every mode of every family through the panel's own widgets: it moves as its sheet says, in the
// direction the panel shows, and a switch of the mode starts nothing.
#include "gui/control_bench.h"

using gui::ControlBench;

namespace {
constexpr double stepDegrees = 360.0 / 4096;

QString text(const char* words)
{
    return QString::fromUtf8(words);
}
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
    void resolutionFactorIsHonoured();
};

void TestControlModes::positionGoesToItsGoal_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<double>("degrees");
    QTest::newRow("STS") << text("sim:sts3215@1") << text("1024") << 90.0;
    QTest::newRow("STS in degrees") << text("sim:sts3215@1") << text("135deg") << 135.0;
    QTest::newRow("SMS") << text("sim:sm40blhv@1") << text("3000") << 3000 * stepDegrees;
    QTest::newRow("HLS") << text("sim:hls3625@1") << text("2500") << 2500 * stepDegrees;
    QTest::newRow("LX") << text("sim:lx-16a@1") << text("700") << 168.0;
    QTest::newRow("Modbus") << text("sim:smsmb@1") << text("1500") << 1500 * stepDegrees;
}

void TestControlModes::positionGoesToItsGoal()
{
    QFETCH(QString, port);
    QFETCH(QString, goal);
    QFETCH(double, degrees);
    ControlBench bench;
    QVERIFY(bench.ready(port, {1}));
    QVERIFY(bench.go(goal));
    QCOMPARE(bench.complaint(), QString());
    QVERIFY(bench.atRest(1));
    QVERIFY2(std::abs(bench.degrees(1) - degrees) < 1.5,
             qPrintable(QString::number(bench.degrees(1))));
}

void TestControlModes::multiTurnMakesTwoTurns()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1"), {1}));
    QVERIFY(bench.switchTo("multiturn"));
    QVERIFY2(bench.planText.contains(text("remembered")), qPrintable(bench.planText));
    const double before = bench.degrees(1);
    const std::int64_t from = bench.entry().servo.raw(catalog::Role::PresentPosition).value();
    QVERIFY(bench.go(QString::number(from + 8192)));
    QVERIFY(bench.atRest(1));
    QVERIFY2(std::abs(bench.degrees(1) - before - 720) < 2,
             qPrintable(QString::number(bench.degrees(1) - before)));
}

void TestControlModes::stepsRepeatAQuarterTurn()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1"), {1}));
    QVERIFY(bench.switchTo("step"));
    QVERIFY(!bench.find<QPushButton>("stepAgain")->isEnabled());
    QVERIFY(bench.find<QPushButton>("stepPlus")->text().startsWith(text("↻")));
    const double before = bench.degrees(1);
    bench.click("stepPlus"); // a quarter of a turn to begin with
    QVERIFY(bench.settled());
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - before - 90) < 2); // clockwise
    for (int quarter = 2; quarter <= 4; ++quarter) {
        QVERIFY(bench.shown());
        bench.click("stepAgain");
        QVERIFY(bench.settled());
        QVERIFY(bench.atRest(1));
        QVERIFY2(std::abs(bench.degrees(1) - before - 90 * quarter) < 2,
                 qPrintable(QString::number(bench.degrees(1) - before)));
    }
    QVERIFY(bench.shown());
    QVERIFY(bench.text("stepsLeft").contains(text("4096")));
    QVERIFY(bench.text("stepsLeft").contains(QString::number(30719 - 4096)));
}

void TestControlModes::stepsEndAtSevenAndAHalfTurns()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1"), {1}));
    QVERIFY(bench.switchTo("step"));
    bench.type("goal", text("30000"));
    bench.click("stepMinus");
    QVERIFY(bench.settled());
    QCOMPARE(bench.complaint(), QString());
    QVERIFY(bench.shown());
    const std::int64_t goal = bench.raw(1, "goal_position");
    bench.click("stepAgain");
    QVERIFY(bench.settled());
    QVERIFY2(bench.complaint().contains(text("7.5 turns")), qPrintable(bench.complaint()));
    QCOMPARE(bench.raw(1, "goal_position"), goal);
    QCOMPARE(bench.drive.stepSum(bench.selection.current()), std::int64_t(-30000));
}

void TestControlModes::speedTurnsClockwise()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:sts3215@1"), {1}));
    QVERIFY(bench.switchTo("speed"));
    QVERIFY(bench.text("goalWay").contains(text("+ ↻")));
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("1000")));
    QTRY_VERIFY(bench.degrees(1) > before + 90);
    QTRY_VERIFY(std::abs(bench.raw(1, "present_speed") - 1000) < 60);
    QVERIFY(bench.go(text("-1000")));
    QTRY_VERIFY(std::abs(bench.raw(1, "present_speed") + 1000) < 60);
    bench.click("goalStop");
    QVERIFY(bench.settled());
    QVERIFY(bench.atRest(1));
    QCOMPARE(bench.raw(1, "goal_speed"), std::int64_t(0));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(1)); // held, not let go
}

void TestControlModes::pwmTurnsTheOtherWay_data()
{
    QTest::addColumn<QString>("port");
    QTest::newRow("STS") << text("sim:sts3215@1");
    QTest::newRow("SMS") << text("sim:sm40blhv@1");
}

void TestControlModes::pwmTurnsTheOtherWay()
{
    QFETCH(QString, port);
    ControlBench bench;
    QVERIFY(bench.ready(port, {1}));
    QVERIFY(bench.switchTo("pwm"));
    QVERIFY(bench.text("goalWay").contains(text("+ ↺")));
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("200")));
    QTRY_VERIFY(bench.degrees(1) < before - 30); // counter-clockwise
    QVERIFY(bench.raw(1, "present_speed") < 0);
    QVERIFY(bench.raw(1, "present_load") > 0);
    QVERIFY(bench.go(text("-200")));
    const double turned = bench.degrees(1);
    QTRY_VERIFY(bench.degrees(1) > turned + 30);
    QVERIFY(bench.raw(1, "present_speed") > 0);
    bench.click("goalStop");
    QVERIFY(bench.settled());
    QVERIFY(bench.atRest(1));
}

void TestControlModes::scsMotorAndBack()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:scs15@1"), {1}));
    const std::int64_t min = bench.raw(1, "min_angle_limit");
    const std::int64_t max = bench.raw(1, "max_angle_limit");
    QVERIFY(min != 0 || max != 0);
    QVERIFY(bench.switchTo("motor"));
    QCOMPARE(bench.raw(1, "max_angle_limit"), std::int64_t(0));
    QVERIFY(!bench.has("speedField") && !bench.has("timeField"));
    QVERIFY(bench.go(text("-200")));
    QTRY_VERIFY(bench.raw(1, "present_speed") > 0);
    QVERIFY(bench.raw(1, "present_load") < 0);
    QVERIFY(bench.switchTo("position"));
    QVERIFY2(bench.planText.contains(text("come back")), qPrintable(bench.planText));
    QCOMPARE(bench.raw(1, "min_angle_limit"), min);
    QCOMPARE(bench.raw(1, "max_angle_limit"), max);
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
}

/// The limits are remembered in the journal, not in the program.
void TestControlModes::limitsComeBackAfterARestart()
{
    const support::OwnDataFolder both;
    constexpr std::int64_t min = 300;
    constexpr std::int64_t max = 3333;
    {
        ControlBench bench(both.path());
        QVERIFY(bench.connectTo(text("sim:sts3215@1")));
        bench.poke(1, "min_angle_limit", min);
        bench.poke(1, "max_angle_limit", max);
        QVERIFY(bench.search(1, 2) && bench.choose({1}));
        QVERIFY(bench.switchTo("multiturn"));
    }
    // A simulated servo forgets with its connection; a real one would have kept this.
    ControlBench bench(both.path());
    QVERIFY(bench.connectTo(text("sim:sts3215@1")));
    bench.poke(1, "min_angle_limit", 0);
    bench.poke(1, "max_angle_limit", 0);
    QVERIFY(bench.search(1, 2) && bench.choose({1}));
    QVERIFY(bench.switchTo("position"));
    QCOMPARE(bench.raw(1, "min_angle_limit"), min);
    QCOMPARE(bench.raw(1, "max_angle_limit"), max);
}

void TestControlModes::lxMotorTurnsBothWays()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:lx-16a@1"), {1}));
    QVERIFY(bench.has("timeField"));
    QVERIFY(!bench.has("speedField") && !bench.has("accelerationField"));
    QVERIFY(bench.switchTo("motor"));
    QVERIFY(!bench.has("timeField"));
    QVERIFY(bench.text("goalWay").contains(text("reverse")));
    double before = bench.degrees(1);
    QVERIFY(bench.go(text("500")));
    QTRY_VERIFY(bench.degrees(1) > before + 20);
    QVERIFY(bench.go(text("-500")));
    before = bench.degrees(1);
    QTRY_VERIFY(bench.degrees(1) < before - 20);
    bench.click("goalStop");
    QVERIFY(bench.settled());
    QVERIFY(bench.atRest(1));
    QVERIFY(bench.switchTo("position"));
    QVERIFY(bench.atRest(1));
}

void TestControlModes::hlsPushesWithACurrent()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:hls3625@1"), {1}));
    QVERIFY(bench.has("currentField") && bench.has("speedField"));
    bench.type("current", text("80"));
    QVERIFY(bench.go(text("2600")));
    QCOMPARE(bench.raw(1, "goal_current"), std::int64_t(80)); // the limit of this move
    QVERIFY(bench.atRest(1));
    QVERIFY(bench.switchTo("current"));
    QVERIFY(!bench.has("currentField"));
    const double before = bench.degrees(1);
    QVERIFY(bench.go(text("60")));
    QTRY_VERIFY(std::abs(bench.degrees(1) - before) > 20);
    bench.click("goalStop");
    QVERIFY(bench.settled());
    QCOMPARE(bench.raw(1, "goal_current"), std::int64_t(0));
    QVERIFY(bench.switchTo("position"));
    QVERIFY(bench.raw(1, "goal_current") > 0); // a limit again, not no torque at all
}

void TestControlModes::modbusSteps()
{
    ControlBench bench;
    QVERIFY(bench.ready(text("sim:smsmb@1"), {1}));
    QVERIFY(!bench.has("howSync") && !bench.has("howAsync"));
    QVERIFY(bench.switchTo("step"));
    const double before = bench.degrees(1);
    bench.click("stepMinus");
    QVERIFY(bench.settled());
    QCOMPARE(bench.complaint(), QString());
    QVERIFY(bench.atRest(1));
    QVERIFY2(std::abs(bench.degrees(1) - before + 90) < 2,
             qPrintable(QString::number(bench.degrees(1) - before)));
}

void TestControlModes::switchingStartsNothing_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QByteArray>("mode");
    QTest::newRow("SCS with a time") << text("sim:scs15@1+run-to-goal=1") << QByteArray("goal_time")
                                     << 1000 << QByteArray("motor");
    QTest::newRow("STS with a speed, to speed")
        << text("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_speed") << 2500
        << QByteArray("speed");
    QTest::newRow("STS with a PWM") << text("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_pwm")
                                    << 300 << QByteArray("pwm");
    QTest::newRow("STS with a goal, to step")
        << text("sim:sts3215@1+run-to-goal=1") << QByteArray("goal_position") << 2048
        << QByteArray("step");
    QTest::newRow("HLS") << text("sim:hls3625@1+run-to-goal=1") << QByteArray("goal_speed") << 40
                         << QByteArray("speed");
}

void TestControlModes::switchingStartsNothing()
{
    QFETCH(QString, port);
    QFETCH(QByteArray, key);
    QFETCH(int, raw);
    QFETCH(QByteArray, mode);
    ControlBench bench;
    QVERIFY(bench.ready(port, {1}));
    bench.poke(1, key.constData(), raw);
    QVERIFY(bench.torque()); // holds where it is
    QVERIFY(bench.atRest(1));
    const double before = bench.degrees(1);
    QVERIFY(bench.switchTo(mode.constData()));
    QVERIFY(bench.planText.contains(text("Torque goes off")));
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(0));
    QVERIFY(bench.torque());
    QCOMPARE(bench.raw(1, "torque_switch"), std::int64_t(1));
    QVERIFY(bench.atRest(1));
    QVERIFY2(std::abs(bench.degrees(1) - before) < 1,
             qPrintable(QString::number(bench.degrees(1) - before)));
}

/// One count of the goal is so many steps; the panel counts as the goal does.
void TestControlModes::resolutionFactorIsHonoured()
{
    ControlBench bench;
    QVERIFY(bench.connectTo(text("sim:sts3215@1")));
    bench.poke(1, "angle_resolution", 2);
    QVERIFY(bench.search(1, 2));
    QVERIFY(bench.choose({1}));
    QCOMPARE(bench.slider()->scale().max, std::int64_t(4095 / 2));
    QVERIFY(bench.go(text("600")));
    QCOMPARE(bench.complaint(), QString());
    QVERIFY(bench.atRest(1));
    QVERIFY(std::abs(bench.degrees(1) - 1200 * stepDegrees) < 1.5);
    QVERIFY2(bench.text("goalPhysical").startsWith(text("105")),
             qPrintable(bench.text("goalPhysical") + bench.box("goal")->text()));
}

QTEST_MAIN(TestControlModes)
#include "tst_control_modes.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Operating modes, directions, torque switch, and what a goal means. Directions as the vendor's
// tutorial shows them: clockwise is towards larger positions.
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

using fixture::key;
using fixture::Servo;

class TestServoModes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void directions_data();
    void directions();
    void aGoalEnergises_data();
    void aGoalEnergises();
    void modeSwitchTakesTorqueOffAndKeepsCommands();
    void torqueOnGoesToTheStoredGoal();
    void invalidTorqueValuesSwitchOff_data();
    void invalidTorqueValuesSwitchOff();
    void dampingBrakes();
    void goalsAreHeldWithinTheLimits_data();
    void goalsAreHeldWithinTheLimits();
    void multiTurnShowsOneTurnUnlessPhaseBit4_data();
    void multiTurnShowsOneTurnUnlessPhaseBit4();
    void stepModeAddsEveryTimeItIsSent();
    void stepModeShowsTheRemainingDifference();
    void stepModeNeedsOpenLimits();
    void stepModeEndsAtSevenAndAHalfTurns();
    void resolutionMultipliesTheGoalOnly();
    void offsetShiftsThePosition_data();
    void offsetShiftsThePosition();
    void offsetCodingOfNewerSts_data();
    void offsetCodingOfNewerSts();
    void reversedServoTurnsTheOtherWay();
    void speedUnitFollowsPhase_data();
    void speedUnitFollowsPhase();
    void goalSpeedZero_data();
    void goalSpeedZero();
    void speedAndAccelerationShapeTheMove();
    void aNewGoalOnTheWayTurnsRound();
    void scsRunningTimeIsMilliseconds();
    void scsMotorModeTurnsOnAndOn();
    void movingFlagFollowsTheMove();
    void movingFlagStaysDownForTheSameGoal();
    void activeGoalFollowsTheMotion();
    void dutyOfThePwmModeIsTheLoad();
    void torqueOffLetsTheShaftFall();
};

namespace {
/// 9 = 11 = 0 in one write.
void openLimits(Servo& servo)
{
    servo.write({9, 0, 0, 0, 0});
}

void enterMode(Servo& servo, int mode)
{
    servo.set("operating_mode", mode);
}
} // namespace

void TestServoModes::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestServoModes::directions_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("mode"); // −1: SCS motor mode
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("shaft"); // +1 clockwise
    QTest::addColumn<int>("speedSign");
    QTest::addColumn<int>("loadSign"); // 0: the tutorial does not say
    const QString sts = QStringLiteral("STS3215");
    const QString sms = QStringLiteral("SM40BLHV");
    const QString scs = QStringLiteral("SCS15");
    const QString speed = QStringLiteral("goal_speed");
    const QString pwm = QStringLiteral("goal_pwm");
    const QString goal = QStringLiteral("goal_position");
    QTest::newRow("STS speed +1000") << sts << 1 << speed << 1000 << 1 << 1 << 0;
    QTest::newRow("STS speed -1000") << sts << 1 << speed << -1000 << -1 << -1 << 0;
    QTest::newRow("SMS speed +1000") << sms << 1 << speed << 1000 << 1 << 1 << 0;
    QTest::newRow("STS PWM +200") << sts << 2 << pwm << 200 << -1 << -1 << 1;
    QTest::newRow("STS PWM -200") << sts << 2 << pwm << -200 << 1 << 1 << -1;
    QTest::newRow("SMS PWM +200") << sms << 2 << pwm << 200 << -1 << -1 << 1;
    QTest::newRow("STS position up") << sts << 0 << goal << 4000 << 1 << 1 << 0;
    QTest::newRow("STS position down") << sts << 0 << goal << 100 << -1 << -1 << 0;
    QTest::newRow("SCS motor -200")
        << scs << -1 << QStringLiteral("goal_time") << -200 << 1 << 1 << -1;
    QTest::newRow("SCS motor +200")
        << scs << -1 << QStringLiteral("goal_time") << 200 << -1 << -1 << 1;
}

void TestServoModes::directions()
{
    QFETCH(QString, model);
    QFETCH(int, mode);
    QFETCH(QString, command);
    QFETCH(int, value);
    QFETCH(int, shaft);
    QFETCH(int, speedSign);
    QFETCH(int, loadSign);
    Servo servo(model);
    if (mode < 0) {
        openLimits(servo);
    } else {
        enterMode(servo, mode);
    }
    const double start = servo.shaftDegrees();
    servo.poke(command, value);
    servo.run(250);
    QVERIFY(shaft * (servo.shaftDegrees() - start) > 5.0);
    QVERIFY(speedSign * servo.at("present_speed") > 100);
    if (loadSign != 0) {
        QCOMPARE(servo.at("present_load"), loadSign * 200);
    }
}

void TestServoModes::aGoalEnergises_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("mode");
    QTest::addColumn<QString>("command");
    QTest::addColumn<bool>("energises");
    const QString sts = QStringLiteral("STS3215");
    QTest::newRow("position") << sts << 0 << QStringLiteral("goal_position") << true;
    QTest::newRow("speed") << sts << 1 << QStringLiteral("goal_speed") << true;
    QTest::newRow("PWM") << sts << 2 << QStringLiteral("goal_pwm") << true;
    QTest::newRow("step") << sts << 3 << QStringLiteral("goal_position") << true;
    QTest::newRow("speed of a position move") << sts << 0 << QStringLiteral("goal_speed") << false;
    QTest::newRow("PWM in position mode") << sts << 0 << QStringLiteral("goal_pwm") << false;
    QTest::newRow("position in speed mode") << sts << 1 << QStringLiteral("goal_position") << false;
    QTest::newRow("SCS position") << QStringLiteral("SCS15") << -1
                                  << QStringLiteral("goal_position") << true;
    QTest::newRow("SCS time alone")
        << QStringLiteral("SCS15") << -1 << QStringLiteral("goal_time") << false;
}

void TestServoModes::aGoalEnergises()
{
    QFETCH(QString, model);
    QFETCH(int, mode);
    QFETCH(QString, command);
    QFETCH(bool, energises);
    Servo servo(model);
    if (mode >= 0) {
        enterMode(servo, mode);
    }
    QCOMPARE(servo.at("torque_switch"), 0);
    servo.poke(command, 300);
    QCOMPARE(servo.at("torque_switch"), energises ? 1 : 0);
}

void TestServoModes::modeSwitchTakesTorqueOffAndKeepsCommands()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.write({42, 0, 8, 0xE8, 3, 0, 2}); // a "running time" of 1000 left in 44
    servo.run(100);
    QCOMPARE(servo.at("torque_switch"), 1);
    servo.set("operating_mode", 2);
    QCOMPARE(servo.at("torque_switch"), 0);
    QCOMPARE(servo.at("goal_pwm"), 1000); // nothing is zeroed: the trap the host has to avoid
    servo.run(50);
    QCOMPARE(servo.at("present_load"), 0);
    servo.set("torque_switch", 1);
    servo.run(200);
    QCOMPARE(servo.at("present_load"), 1000);
    QVERIFY(servo.at("present_speed") < -2000);
}

void TestServoModes::torqueOnGoesToTheStoredGoal()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("torque_switch", 1); // 42 is 0 after power-on
    servo.run(2000);
    QVERIFY(std::abs(servo.at("present_position")) <= 8);
}

void TestServoModes::invalidTorqueValuesSwitchOff_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("becomes");
    QTest::newRow("STS damping") << QStringLiteral("STS3215") << 2 << 2;
    QTest::newRow("SMS has no damping") << QStringLiteral("SM40BLHV") << 2 << 0;
    QTest::newRow("SCS damping") << QStringLiteral("SCS15") << 2 << 2;
    QTest::newRow("STS 3") << QStringLiteral("STS3215") << 3 << 0;
}

void TestServoModes::invalidTorqueValuesSwitchOff()
{
    QFETCH(QString, model);
    QFETCH(int, value);
    QFETCH(int, becomes);
    Servo servo(model);
    servo.write({40, std::uint8_t(value)});
    QCOMPARE(servo.at("torque_switch"), becomes);
}

void TestServoModes::dampingBrakes()
{
    // A heavy arm falls from the side: freely, damped, damped with a third of the strength.
    const auto fallTime = [](int torqueSwitch, int torqueLimit) {
        auto config = fixture::configOf(QStringLiteral("STS3215"));
        config.load.gravityTorque = 1.0;
        config.initialDegrees = 270;
        Servo servo(QStringLiteral("STS3215"), config);
        servo.set("torque_limit", torqueLimit);
        servo.set("torque_switch", torqueSwitch);
        int ms = 0;
        while (servo.shaftDegrees() > 200 && ms < 5000) {
            servo.run(1);
            ++ms;
        }
        return ms;
    };
    const int free = fallTime(0, 1000);
    const int weak = fallTime(2, 300);
    const int damped = fallTime(2, 1000);
    QVERIFY(free < 5000);
    QVERIFY(weak > free);
    QVERIFY(damped > weak);
    QVERIFY(damped > 2 * free);
}

void TestServoModes::goalsAreHeldWithinTheLimits_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("goal");
    QTest::addColumn<int>("ends");
    QTest::newRow("STS above") << QStringLiteral("STS3215") << 4000 << 3000;
    QTest::newRow("STS below") << QStringLiteral("STS3215") << 10 << 1000;
    QTest::newRow("STS negative") << QStringLiteral("STS3215") << -500 << 1000;
    QTest::newRow("STS within") << QStringLiteral("STS3215") << 1500 << 1500;
    QTest::newRow("SCS above") << QStringLiteral("SCS15") << 1000 << 900;
    QTest::newRow("SCS below") << QStringLiteral("SCS15") << 5 << 100;
}

void TestServoModes::goalsAreHeldWithinTheLimits()
{
    QFETCH(QString, model);
    QFETCH(int, goal);
    QFETCH(int, ends);
    Servo servo(model);
    const bool scs = model == QLatin1String("SCS15");
    servo.set("min_angle_limit", scs ? 100 : 1000);
    servo.set("max_angle_limit", scs ? 900 : 3000);
    servo.set("goal_position", goal);
    QCOMPARE(servo.at("goal_position"), goal); // stored as sent
    servo.run(2000);
    QVERIFY(std::abs(servo.at("present_position") - ends) <= 8);
}

void TestServoModes::multiTurnShowsOneTurnUnlessPhaseBit4_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<int>("shown");
    QTest::newRow("single turn feedback") << 12 << 8192 + 500 - 2 * 4096;
    QTest::newRow("full angle feedback") << 12 + 16 << 8192 + 500;
}

void TestServoModes::multiTurnShowsOneTurnUnlessPhaseBit4()
{
    QFETCH(int, phase);
    QFETCH(int, shown);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", phase);
    openLimits(servo);
    const double start = servo.shaftSteps();
    servo.set("goal_position", 8192 + 500);
    servo.run(4000);
    QVERIFY(std::abs(servo.at("present_position") - shown) <= 8);
    QVERIFY(std::abs(servo.shaftSteps() - start - (8692 - 2048)) <= 8);
}

void TestServoModes::stepModeAddsEveryTimeItIsSent()
{
    Servo servo(QStringLiteral("STS3215"));
    openLimits(servo);
    enterMode(servo, 3);
    const double start = servo.shaftDegrees();
    for (int turn = 1; turn <= 3; ++turn) {
        servo.set("goal_position", 1024); // the same value each time
        servo.run(1500);
        QVERIFY(std::abs(servo.shaftDegrees() - start - turn * 90.0) < 1.0);
    }
    servo.set("goal_position", -1024);
    servo.run(1500);
    QVERIFY(std::abs(servo.shaftDegrees() - start - 180.0) < 1.0);
}

void TestServoModes::stepModeShowsTheRemainingDifference()
{
    Servo servo(QStringLiteral("STS3215"));
    openLimits(servo);
    enterMode(servo, 3);
    servo.set("goal_speed", 500);
    servo.set("goal_position", -1000);
    servo.run(1);
    QVERIFY(std::abs(servo.at("present_position") + 1000) <= 5);
    const double before = servo.shaftSteps();
    servo.run(1000);
    const double remaining = -1000 - (servo.shaftSteps() - before);
    QVERIFY(std::abs(servo.at("present_position") - remaining) <= 6);
    servo.run(3000);
    QVERIFY(std::abs(servo.at("present_position")) <= 8);
}

void TestServoModes::stepModeNeedsOpenLimits()
{
    Servo servo(QStringLiteral("STS3215"));
    enterMode(servo, 3);
    const double start = servo.shaftDegrees();
    servo.set("goal_position", 1024);
    servo.run(1000);
    QVERIFY(std::abs(servo.shaftDegrees() - start) < 0.5);
}

void TestServoModes::stepModeEndsAtSevenAndAHalfTurns()
{
    Servo servo(QStringLiteral("STS3215"));
    openLimits(servo);
    enterMode(servo, 3);
    for (int i = 0; i < 4; ++i) {
        servo.set("goal_position", 10000);
    }
    servo.run(15000);
    QVERIFY(std::abs(servo.shaftSteps() - 30719) <= 8);
}

void TestServoModes::resolutionMultipliesTheGoalOnly()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", 12 + 16);
    servo.set("angle_resolution", 3);
    openLimits(servo);
    servo.set("goal_position", 2000);
    servo.run(4000);
    QVERIFY(std::abs(servo.at("present_position") - 6000) <= 8);
    QVERIFY(std::abs(servo.shaftSteps() - 6000) <= 8);
}

void TestServoModes::offsetShiftsThePosition_data()
{
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("shown");
    QTest::newRow("none") << 0 << 2048;
    QTest::newRow("positive") << 300 << 1748;
    QTest::newRow("negative") << -300 << 2348;
    QTest::newRow("past the seam") << -2047 << 4095;
    QTest::newRow("over the seam") << 2047 << 1;
}

void TestServoModes::offsetShiftsThePosition()
{
    QFETCH(int, offset);
    QFETCH(int, shown);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("position_offset", offset);
    servo.run(5);
    QVERIFY(std::abs(servo.at("present_position") - shown) <= 1);
}

void TestServoModes::offsetCodingOfNewerSts_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("low");
    QTest::addColumn<int>("high");
    QTest::addColumn<int>("shown"); // of the sensor's step 2100
    QTest::newRow("STS +100") << QStringLiteral("STS3215") << 0x64 << 0x00 << 2000;
    QTest::newRow("STS -100") << QStringLiteral("STS3215") << 0x64 << 0x08 << 2200;
    QTest::newRow("STS +2048+10") << QStringLiteral("STS3215") << 0x0A << 0x10 << 42;
    QTest::newRow("STS -2048-10") << QStringLiteral("STS3215") << 0x0A << 0x18 << 62;
    QTest::newRow("SMS has no bit 12") << QStringLiteral("SM40BLHV") << 0x64 << 0x10 << 2000;
}

void TestServoModes::offsetCodingOfNewerSts()
{
    QFETCH(QString, model);
    QFETCH(int, low);
    QFETCH(int, high);
    QFETCH(int, shown);
    auto config = fixture::configOf(model);
    config.initialDegrees = 2100 * 360.0 / 4096;
    Servo servo(model, config);
    servo.write({31, std::uint8_t(low), std::uint8_t(high)});
    servo.run(5);
    QVERIFY(std::abs(servo.at("present_position") - shown) <= 1);
}

void TestServoModes::reversedServoTurnsTheOtherWay()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", 12 + 128 + 1);
    servo.run(5);
    const int before = servo.at("present_position");
    const double start = servo.shaftDegrees();
    servo.set("goal_position", before + 500);
    servo.run(1500);
    QVERIFY(std::abs(servo.at("present_position") - (before + 500)) <= 8);
    QVERIFY(std::abs(servo.shaftDegrees() - start + 500 * 360.0 / 4096) < 1.0);
}

void TestServoModes::speedUnitFollowsPhase_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<int>("command");
    QTest::newRow("1 step/s") << 12 << 1000;
    QTest::newRow("50 step/s") << 8 << 20;
}

void TestServoModes::speedUnitFollowsPhase()
{
    QFETCH(int, phase);
    QFETCH(int, command);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", phase);
    enterMode(servo, 1);
    servo.set("goal_speed", command);
    servo.run(800);
    const double start = servo.shaftSteps();
    servo.run(1000);
    QVERIFY(std::abs(servo.shaftSteps() - start - 1000) < 30);
    QVERIFY(std::abs(servo.at("present_speed") - command) <= command / 20);
}

void TestServoModes::goalSpeedZero_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("moves");
    QTest::newRow("phase bit 3: maximum") << 12 << true;
    QTest::newRow("no bit 3: stop") << 4 << false;
}

void TestServoModes::goalSpeedZero()
{
    QFETCH(int, phase);
    QFETCH(bool, moves);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", phase);
    servo.set("goal_speed", 0);
    servo.set("goal_position", 3000);
    servo.run(1500);
    QVERIFY(std::abs(servo.at("present_position") - (moves ? 3000 : 2048)) <= 8);
}

void TestServoModes::speedAndAccelerationShapeTheMove()
{
    // 10 units of acceleration reach 1000 step/s after one second (register sheet).
    Servo servo(QStringLiteral("STS3215"));
    servo.set("acceleration", 10);
    servo.set("goal_speed", 1000);
    servo.set("goal_position", 4000);
    int fastest = 0;
    servo.run(500, [&] { fastest = std::max(fastest, servo.at("present_speed")); });
    QVERIFY(fastest >= 400 && fastest <= 600);
    servo.run(1000, [&] { fastest = std::max(fastest, servo.at("present_speed")); });
    QVERIFY(fastest >= 950 && fastest <= 1100);
    // 1952 steps: one second up, one second down, 952 steps in between at 1000 step/s.
    servo.run(1300);
    QVERIFY(servo.at("present_position") < 3995);
    servo.run(400);
    QVERIFY(std::abs(servo.at("present_position") - 4000) <= 8);
}

void TestServoModes::aNewGoalOnTheWayTurnsRound()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("acceleration", 20);
    servo.set("goal_position", 4000);
    servo.run(800);
    QVERIFY(servo.at("present_speed") > 1000);
    servo.set("goal_position", 2100); // behind it: it has to brake first
    double furthest = 0;
    servo.run(4000, [&] { furthest = std::max(furthest, servo.shaftSteps()); });
    QVERIFY(furthest > 2700 && furthest < 3900);
    QVERIFY(std::abs(servo.at("present_position") - 2100) <= 8);
    QCOMPARE(servo.at("moving"), 0);
}

void TestServoModes::scsRunningTimeIsMilliseconds()
{
    // Worked frame: position 512 in 1000 ms, speed 0.
    auto config = fixture::configOf(QStringLiteral("SCS15"));
    config.initialDegrees = 800 * 220.0 / 1024;
    Servo servo(QStringLiteral("SCS15"), config);
    QVERIFY(servo.write({42, 2, 0, 3, 0xE8, 0, 0}));
    servo.run(500);
    QVERIFY(std::abs(servo.at("present_position") - 656) < 40);
    servo.run(700);
    QVERIFY(std::abs(servo.at("present_position") - 512) <= 8);

    // A speed makes the time meaningless.
    QVERIFY(servo.write({42, 3, 0x20, 0x13, 0x88, 3, 0xE8}));
    servo.run(600);
    QVERIFY(std::abs(servo.at("present_position") - 800) <= 8);
}

void TestServoModes::scsMotorModeTurnsOnAndOn()
{
    Servo servo(QStringLiteral("SCS15"));
    openLimits(servo);
    // Worked frame: PWM −200.
    QVERIFY(servo.write({44, 0x04, 0xC8}));
    const double start = servo.shaftDegrees();
    servo.run(12000);
    QVERIFY(servo.shaftDegrees() - start > 720);
    const int position = servo.at("present_position");
    QVERIFY(position >= 0 && position <= 1023);
    servo.set("max_torque", 90); // 16 limits at once: SCS has no torque limit of its own
    servo.run(50);
    QCOMPARE(servo.at("present_load"), -90);
    servo.write({44, 0, 0});
    servo.run(500);
    QCOMPARE(servo.at("present_speed"), 0);
}

void TestServoModes::movingFlagFollowsTheMove()
{
    Servo servo(QStringLiteral("STS3215"));
    QCOMPARE(servo.at("moving"), 0);
    servo.set("goal_speed", 500);
    servo.set("goal_position", 3048);
    servo.run(1);
    QCOMPARE(servo.at("moving"), 1);
    servo.run(1000);
    QCOMPARE(servo.at("moving"), 1);
    servo.run(1500);
    QCOMPARE(servo.at("moving"), 0);
    QVERIFY(std::abs(servo.at("present_position") - 3048) <= 8);

    servo.set("operating_mode", 1);
    servo.set("goal_speed", 500);
    servo.run(300);
    QCOMPARE(servo.at("moving"), 1);
    servo.set("goal_speed", 0);
    servo.run(500);
    QCOMPARE(servo.at("moving"), 0);
}

void TestServoModes::movingFlagStaysDownForTheSameGoal()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("goal_position", 2500);
    servo.run(1500);
    int raised = 0;
    servo.set("goal_position", 2500);
    servo.run(200, [&] { raised += servo.at("moving"); });
    QCOMPARE(raised, 0);
}

void TestServoModes::activeGoalFollowsTheMotion()
{
    Servo servo(QStringLiteral("STS3215"));
    QVERIFY(std::abs(servo.at("active_goal_position") - 2048) <= 1);
    servo.set("goal_speed", 1000);
    servo.set("goal_position", 3048);
    servo.run(500);
    QVERIFY(std::abs(servo.at("active_goal_position") - 2548) <= 10);
    servo.run(700);
    QCOMPARE(servo.at("active_goal_position"), 3048);
}

void TestServoModes::dutyOfThePwmModeIsTheLoad()
{
    // The tutorial shows about −750 step/s for 200 on an STS3215.
    Servo servo(QStringLiteral("STS3215"));
    enterMode(servo, 2);
    servo.set("goal_pwm", 200);
    servo.run(1000);
    QCOMPARE(servo.at("present_load"), 200);
    QVERIFY(servo.at("present_speed") <= -500 && servo.at("present_speed") >= -850);
    servo.set("torque_limit", 100);
    servo.run(500);
    QCOMPARE(servo.at("present_load"), 100);
}

void TestServoModes::torqueOffLetsTheShaftFall()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.load.gravityTorque = 1.0;
    config.initialDegrees = 260;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.set("goal_position", 3072);
    servo.run(1500);
    QVERIFY(servo.shaftDegrees() > 260);
    servo.write({40, 0});
    servo.run(3000);
    QVERIFY(std::abs(servo.shaftDegrees() - 180) < 15); // hangs
}

QTEST_GUILESS_MAIN(TestServoModes)
#include "tst_servo_modes.moc"

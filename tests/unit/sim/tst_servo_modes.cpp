// SPDX-License-Identifier: GPL-3.0-or-later
// Operating modes, directions, torque switch, and what a goal means. Directions as the vendor's
// tutorial shows them: clockwise is towards larger positions.
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

using fixture::Servo;

class TestServoModes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void directions_data();
    void directions();
    void aGoalSwitchesTorqueOn_data();
    void aGoalSwitchesTorqueOn();
    void modeSwitchReleasesTorqueAndKeepsCommands();
    void torqueOnGoesToTheStoredGoal();
    void invalidTorqueValuesSwitchOff_data();
    void invalidTorqueValuesSwitchOff();
    void dampingBrakes();
    void multiTurnShowsOneTurnUnlessPhaseBit4_data();
    void multiTurnShowsOneTurnUnlessPhaseBit4();
    void stepModeAddsEveryTimeItIsSent();
    void stepModeShowsTheRemainingDifference();
    void stepModeNeedsOpenLimits();
    void stepModeEndsAtSevenAndAHalfTurns();
    void scsMotorModeTurnsContinuously();
    void dutyOfThePwmModeIsTheLoad();
    void torqueOffReleasesTheShaft();
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
    QTest::addColumn<int>("loadSign"); // 0: not stated in the tutorial
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

void TestServoModes::aGoalSwitchesTorqueOn_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("mode");
    QTest::addColumn<QString>("command");
    QTest::addColumn<bool>("energizes");
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

void TestServoModes::aGoalSwitchesTorqueOn()
{
    QFETCH(QString, model);
    QFETCH(int, mode);
    QFETCH(QString, command);
    QFETCH(bool, energizes);
    Servo servo(model);
    if (mode >= 0) {
        enterMode(servo, mode);
    }
    QCOMPARE(servo.at("torque_switch"), 0);
    servo.poke(command, 300);
    QCOMPARE(servo.at("torque_switch"), energizes ? 1 : 0);
}

void TestServoModes::modeSwitchReleasesTorqueAndKeepsCommands()
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
    servo.behavior().runsToOldGoal = true;
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

void TestServoModes::scsMotorModeTurnsContinuously()
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

void TestServoModes::torqueOffReleasesTheShaft()
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

SERVODESK_GUILESS_TEST(TestServoModes)
#include "tst_servo_modes.moc"

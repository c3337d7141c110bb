// SPDX-License-Identifier: GPL-3.0-or-later
// What a goal means: limits, resolution, offset, direction, speed, time, and the flags of the
// move.
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

using fixture::Servo;

class TestServoGoals : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void goalsAreClampedToTheLimits_data();
    void goalsAreClampedToTheLimits();
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
    void aNewGoalMidwayReverses();
    void scsRunningTimeIsMilliseconds();
    void movingFlagFollowsTheMove();
    void movingFlagStaysDownForTheSameGoal();
    void activeGoalFollowsTheMotion();
    void torqueOnWithoutAGoal_data();
    void torqueOnWithoutAGoal();
};

void TestServoGoals::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestServoGoals::goalsAreClampedToTheLimits_data()
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

void TestServoGoals::goalsAreClampedToTheLimits()
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

void TestServoGoals::resolutionMultipliesTheGoalOnly()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", 12 + 16);
    servo.set("angle_resolution", 3);
    servo.write({9, 0, 0, 0, 0}); // both limits 0
    servo.set("goal_position", 2000);
    servo.run(4000);
    QVERIFY(std::abs(servo.at("present_position") - 6000) <= 8);
    QVERIFY(std::abs(servo.shaftSteps() - 6000) <= 8);
}

void TestServoGoals::offsetShiftsThePosition_data()
{
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("shown");
    QTest::newRow("none") << 0 << 2048;
    QTest::newRow("positive") << 300 << 1748;
    QTest::newRow("negative") << -300 << 2348;
    QTest::newRow("past the seam") << -2047 << 4095;
    QTest::newRow("over the seam") << 2047 << 1;
}

void TestServoGoals::offsetShiftsThePosition()
{
    QFETCH(int, offset);
    QFETCH(int, shown);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("position_offset", offset);
    servo.run(5);
    QVERIFY(std::abs(servo.at("present_position") - shown) <= 1);
}

void TestServoGoals::offsetCodingOfNewerSts_data()
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

void TestServoGoals::offsetCodingOfNewerSts()
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

void TestServoGoals::reversedServoTurnsTheOtherWay()
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

void TestServoGoals::speedUnitFollowsPhase_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<int>("command");
    QTest::newRow("1 step/s") << 12 << 1000;
    QTest::newRow("50 step/s") << 8 << 20;
}

void TestServoGoals::speedUnitFollowsPhase()
{
    QFETCH(int, phase);
    QFETCH(int, command);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", phase);
    servo.set("operating_mode", 1);
    servo.set("goal_speed", command);
    servo.run(800);
    const double start = servo.shaftSteps();
    servo.run(1000);
    QVERIFY(std::abs(servo.shaftSteps() - start - 1000) < 30);
    QVERIFY(std::abs(servo.at("present_speed") - command) <= command / 20);
}

void TestServoGoals::goalSpeedZero_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("moves");
    QTest::newRow("phase bit 3: maximum") << 12 << true;
    QTest::newRow("no bit 3: stop") << 4 << false;
}

void TestServoGoals::goalSpeedZero()
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

void TestServoGoals::speedAndAccelerationShapeTheMove()
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

void TestServoGoals::aNewGoalMidwayReverses()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("acceleration", 20);
    servo.set("goal_position", 4000);
    servo.run(800);
    QVERIFY(servo.at("present_speed") > 1000);
    servo.set("goal_position", 2100); // behind it: it has to brake first
    double maxDeflection = 0;
    servo.run(4000, [&] { maxDeflection = std::max(maxDeflection, servo.shaftSteps()); });
    QVERIFY(maxDeflection > 2700 && maxDeflection < 3900);
    QVERIFY(std::abs(servo.at("present_position") - 2100) <= 8);
    QCOMPARE(servo.at("moving"), 0);
}

void TestServoGoals::scsRunningTimeIsMilliseconds()
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

void TestServoGoals::movingFlagFollowsTheMove()
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

void TestServoGoals::movingFlagStaysDownForTheSameGoal()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("goal_position", 2500);
    servo.run(1500);
    int raised = 0;
    servo.set("goal_position", 2500);
    servo.run(200, [&] { raised += servo.at("moving"); });
    QCOMPARE(raised, 0);
}

void TestServoGoals::activeGoalFollowsTheMotion()
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

// LeRobot switches torque on without a goal at every start, and its arms stay where they are.
void TestServoGoals::torqueOnWithoutAGoal_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<bool>("multiTurn");
    QTest::addColumn<bool>("runs");
    for (const bool runs : {false, true}) {
        for (const char* model : {"STS3215", "SM40BLHV", "SCS15", "HLS3606", "SMSMB"})
            QTest::addRow("%s %s", model, runs ? "runs" : "holds")
                << QString::fromLatin1(model) << false << runs;
        QTest::addRow("STS multi-turn %s", runs ? "runs" : "holds")
            << QStringLiteral("STS3215") << true << runs;
    }
}

void TestServoGoals::torqueOnWithoutAGoal()
{
    QFETCH(QString, model);
    QFETCH(bool, multiTurn);
    QFETCH(bool, runs);
    auto config = fixture::configOf(model);
    config.initialDegrees = 120;
    config.behavior.runsToOldGoal = runs;
    Servo servo(model, config);
    if (multiTurn) {
        servo.keep("min_angle_limit", 0);
        servo.keep("max_angle_limit", 0);
    }
    const auto turned = [&](double from) { return std::abs(servo.shaftDegrees() - from); };
    for (const bool afterAMove : {false, true}) {
        servo.powerCycle();
        const double startAngle = servo.shaftDegrees();
        const int goalRead = servo.at("goal_position");
        servo.set("torque_switch", 1);
        servo.run(1500);
        QCOMPARE(servo.at("torque_switch"), 1);
        QVERIFY2((turned(startAngle) > 20) == runs,
                 qPrintable(QString::number(turned(startAngle))));
        QVERIFY(runs || turned(startAngle) < 1);
        QCOMPARE(servo.at("goal_position"), goalRead); // the register is as it was
        if (afterAMove)
            break;
        // From the first goal on the register rules, also when torque was off in between.
        servo.set("goal_position", model == QLatin1String("SCS15") ? 700 : 2500);
        servo.run(2500);
        const double there = servo.shaftDegrees();
        QVERIFY(runs || turned(startAngle) > 20);
        servo.set("torque_switch", 0);
        servo.run(300);
        servo.set("torque_switch", 1);
        servo.run(300);
        QVERIFY(turned(there) < 1);
    }
}

SERVODESK_GUILESS_TEST(TestServoGoals)
#include "tst_servo_goals.moc"

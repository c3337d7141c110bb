// SPDX-License-Identifier: GPL-3.0-or-later
// The protections: thresholds, times, what happens, what releases them, what 19 and 20 choose.
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

using fixture::Servo;

class TestServoProtection : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void overloadReducesTorqueAfterItsTime_data();
    void overloadReducesTorqueAfterItsTime();
    void overloadIsClearedByAnOppositeGoalOnly();
    void overloadOfTheOpenLoopModes_data();
    void overloadOfTheOpenLoopModes();
    void overloadTimerRestarts();
    void overloadNeedsItsBit();
    void overcurrentSwitchesTorqueOff();
    void overcurrentNeedsASensor_data();
    void overcurrentNeedsASensor();
    void currentTimerRestarts();
    void voltageShowsAndClears_data();
    void voltageShowsAndClears();
    void voltageSagsUnderLoad();
    void scsCanTurnVoltageOff();
    void temperatureUnloadsAndRecovers();
    void stallHeatsAndRestCools();
    void sensorFaultUnloadsIfConfigured_data();
    void sensorFaultUnloadsIfConfigured();
    void led_data();
    void led();
    void powerOffForgetsTrips();
};

namespace {
constexpr double radPerStep = 2.0 * 3.14159265358979 / 4096;

/// An STS3215 that will hit a hard stop at step 2500.
Servo blockedServo()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.load.stopHigh = 2500 * radPerStep;
    return Servo(QStringLiteral("STS3215"), config);
}

void stall(Servo& servo)
{
    servo.set("goal_position", 3500);
    servo.run(500);
}

constexpr int overload = 32;
constexpr int current = 8;
} // namespace

void TestServoProtection::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestServoProtection::overloadReducesTorqueAfterItsTime_data()
{
    QTest::addColumn<int>("time"); // 10 ms
    QTest::addColumn<int>("holdTorque");
    QTest::newRow("factory 2 s, 20 %") << 200 << 20;
    QTest::newRow("0.8 s, 40 %") << 80 << 40;
}

void TestServoProtection::overloadReducesTorqueAfterItsTime()
{
    QFETCH(int, time);
    QFETCH(int, holdTorque);
    Servo servo = blockedServo();
    servo.set("protection_time", time);
    servo.set("protection_torque", holdTorque);
    servo.set("goal_position", 3500);
    int above = 0;
    while (servo.at("servo_status") == 0 && above < 5000) {
        servo.run(1);
        above = std::abs(servo.at("present_load")) > 800 ? above + 1 : 0;
    }
    QVERIFY(std::abs(above - time * 10) <= 2);
    servo.run(5);
    QCOMPARE(std::abs(servo.at("present_load")), holdTorque * 10);
    QCOMPARE(int(servo.ask(0x01)->status), overload);
    QCOMPARE(servo.at("torque_switch"), 1);
}

void TestServoProtection::overloadIsClearedByAnOppositeGoalOnly()
{
    Servo servo = blockedServo();
    stall(servo);
    servo.run(2500);
    QCOMPARE(servo.at("servo_status"), overload);

    servo.set("goal_position", 3500);
    servo.run(20);
    QCOMPARE(servo.at("servo_status"), overload);
    servo.set("goal_position", 4000);
    servo.run(20);
    QCOMPARE(servo.at("servo_status"), overload);
    servo.set("torque_switch", 0);
    servo.run(500);
    servo.set("torque_switch", 1);
    servo.run(20);
    QCOMPARE(servo.at("servo_status"), overload);

    servo.set("goal_position", 2000);
    servo.run(1500);
    QCOMPARE(servo.at("servo_status"), 0);
    QVERIFY(std::abs(servo.at("present_position") - 2000) <= 8);
}

void TestServoProtection::overloadOfTheOpenLoopModes_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("into");
    QTest::addColumn<int>("away");
    QTest::newRow("speed") << 1 << QStringLiteral("goal_speed") << 2000 << -500;
    QTest::newRow("PWM") << 2 << QStringLiteral("goal_pwm") << -900 << 300;
}

void TestServoProtection::overloadOfTheOpenLoopModes()
{
    QFETCH(int, mode);
    QFETCH(QString, command);
    QFETCH(int, into);
    QFETCH(int, away);
    Servo servo = blockedServo();
    servo.set("operating_mode", mode);
    servo.poke(command, into);
    servo.run(4000);
    QCOMPARE(servo.at("servo_status"), overload);
    QCOMPARE(std::abs(servo.at("present_load")), 200);
    servo.poke(command, 0);
    servo.run(20);
    QCOMPARE(servo.at("servo_status"), overload);
    servo.poke(command, away);
    servo.run(200);
    QCOMPARE(servo.at("servo_status"), 0);
    QVERIFY(servo.at("present_position") < 2490);
}

void TestServoProtection::overloadTimerRestarts()
{
    Servo servo = blockedServo();
    stall(servo);
    for (int i = 0; i < 3; ++i) {
        servo.run(1400);
        QCOMPARE(servo.at("servo_status"), 0);
        servo.set("torque_limit", 500);
        servo.run(5);
        servo.set("torque_limit", 1000);
    }
    servo.run(2100);
    QCOMPARE(servo.at("servo_status"), overload);
}

void TestServoProtection::overloadNeedsItsBit()
{
    Servo servo = blockedServo();
    servo.set("unload_condition", 4 + 8);
    stall(servo);
    servo.run(4000);
    QVERIFY(std::abs(servo.at("present_load")) > 900); // nothing is weakened
    QCOMPARE(servo.at("servo_status"), overload);      // but it is reported
    servo.set("torque_limit", 500);
    servo.run(10);
    QCOMPARE(servo.at("servo_status"), 0);
}

void TestServoProtection::overcurrentSwitchesTorqueOff()
{
    Servo servo = blockedServo();
    servo.set("protection_current", 150);
    servo.set("overcurrent_time", 50);
    servo.set("unload_condition", current);
    servo.set("goal_position", 3500);
    servo.run(400);
    QVERIFY(std::abs(servo.at("present_current")) > 150);
    QCOMPARE(servo.at("torque_switch"), 1);
    servo.run(700);
    QCOMPARE(servo.at("servo_status"), current);
    QCOMPARE(servo.at("torque_switch"), 0);
    QCOMPARE(servo.at("present_load"), 0);
    QCOMPARE(servo.at("present_current"), 0);

    servo.set("torque_switch", 1); // only a new position clears it
    servo.run(20);
    QCOMPARE(servo.at("torque_switch"), 0);
    QCOMPARE(servo.at("servo_status"), current);

    servo.set("goal_position", 2200);
    QCOMPARE(servo.at("torque_switch"), 1);
    servo.run(1000);
    QCOMPARE(servo.at("servo_status"), 0);
    QVERIFY(std::abs(servo.at("present_position") - 2200) <= 8);
}

void TestServoProtection::overcurrentNeedsASensor_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("senses");
    QTest::newRow("STS with current feedback") << QStringLiteral("STS3215") << 12 << true;
    QTest::newRow("STS, phase bit 5: none") << QStringLiteral("STS3215") << 44 << false;
    QTest::newRow("SMS, bit 5 is its divider") << QStringLiteral("SM40BLHV") << 44 << true;
    QTest::newRow("SCS15 has none") << QStringLiteral("SCS15") << 8 << false;
    QTest::newRow("SCS40 has one") << QStringLiteral("SCS40") << 8 << true;
}

void TestServoProtection::overcurrentNeedsASensor()
{
    QFETCH(QString, model);
    QFETCH(int, phase);
    QFETCH(bool, senses);
    auto config = fixture::configOf(model);
    config.load.coulombFriction = 100; // rusted in
    Servo servo(model, config);
    servo.set("phase", phase);
    servo.set("protection_current", 100);
    servo.set("overcurrent_time", 10);
    servo.set("goal_position", 50);
    servo.run(80);
    QCOMPARE(servo.at("present_current") > 100, senses);
    servo.run(200);
    const bool protects = senses && !model.startsWith(QLatin1String("SCS"));
    QCOMPARE(servo.at("servo_status"), protects ? current : 0);
    QCOMPARE(servo.at("torque_switch"), protects ? 0 : 1);
}

void TestServoProtection::currentTimerRestarts()
{
    Servo servo = blockedServo();
    servo.set("protection_current", 200);
    servo.set("overcurrent_time", 100);
    servo.set("unload_condition", current);
    stall(servo);
    for (int i = 0; i < 3; ++i) {
        servo.run(600);
        QCOMPARE(servo.at("servo_status"), 0);
        servo.set("torque_limit", 300);
        servo.run(5);
        servo.set("torque_limit", 1000);
    }
    servo.run(1100);
    QCOMPARE(servo.at("servo_status"), current);
}

void TestServoProtection::voltageShowsAndClears_data()
{
    QTest::addColumn<double>("supply");
    QTest::addColumn<bool>("unloads");
    QTest::newRow("too high, shown only") << 9.0 << false;
    QTest::newRow("too low, shown only") << 3.5 << false;
    QTest::newRow("too high, unloads") << 9.0 << true;
    QTest::newRow("too low, unloads") << 3.5 << true;
}

void TestServoProtection::voltageShowsAndClears()
{
    QFETCH(double, supply);
    QFETCH(bool, unloads);
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.load.gravityTorque = 0.3;
    config.initialDegrees = 260;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.set("unload_condition", unloads ? 1 : 44);
    servo.set("goal_position", 3000);
    servo.run(1000);
    QVERIFY(servo.at("present_load") != 0);

    servo.environment().supplyVolts = supply;
    servo.run(300);
    QCOMPARE(servo.at("servo_status"), 1);
    QVERIFY(std::abs(servo.at("present_voltage") - int(supply * 10)) <= 1);
    QCOMPARE(servo.at("present_load") == 0, unloads);

    servo.environment().supplyVolts = 7.4;
    servo.run(1500);
    QCOMPARE(servo.at("servo_status"), 0);
    QVERIFY(servo.at("present_load") != 0); // it holds again
}

void TestServoProtection::voltageSagsUnderLoad()
{
    Servo servo = blockedServo();
    servo.environment().supplyOhms = 1.0;
    QCOMPARE(servo.at("present_voltage"), 74);
    stall(servo);
    const int sagging = servo.at("present_voltage");
    QVERIFY(sagging < 65);
    QVERIFY(std::abs(74 - sagging - std::abs(servo.at("present_current")) * 0.065) < 3);
    servo.set("torque_switch", 0);
    servo.run(300);
    QCOMPARE(servo.at("present_voltage"), 74);
}

void TestServoProtection::scsCanTurnVoltageOff()
{
    Servo servo(QStringLiteral("SCS15"));
    servo.environment().supplyVolts = 12;
    servo.run(200);
    QCOMPARE(servo.at("servo_status"), 1);
    servo.set("max_voltage", 0);
    servo.set("min_voltage", 0);
    servo.run(20);
    QCOMPARE(servo.at("servo_status"), 0);
    QCOMPARE(servo.at("present_voltage"), 0);
}

void TestServoProtection::temperatureUnloadsAndRecovers()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.load.gravityTorque = 0.3;
    config.initialDegrees = 260;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.set("goal_position", 3000);
    servo.run(1000);
    servo.setTemperature(75); // limit 70
    servo.run(5);
    QCOMPARE(servo.at("present_temperature"), 75);
    QCOMPARE(servo.at("servo_status"), 4);
    QCOMPARE(servo.at("present_load"), 0);
    // It cools down by itself, without any write.
    int seconds = 0;
    while (servo.at("servo_status") != 0 && seconds < 600) {
        servo.run(1000);
        ++seconds;
    }
    QVERIFY(seconds > 5 && seconds < 600);
    servo.run(1500);
    QVERIFY(std::abs(servo.at("present_position") - 3000) <= 30);
}

void TestServoProtection::stallHeatsAndRestCools()
{
    Servo servo = blockedServo();
    servo.set("unload_condition", 0);
    QCOMPARE(servo.at("present_temperature"), 25);
    stall(servo);
    servo.run(20000);
    const int warm = servo.at("present_temperature");
    QVERIFY(warm > 30);
    servo.run(120000);
    QVERIFY(servo.at("present_temperature") > 70);
    QVERIFY((servo.at("servo_status") & 4) != 0);
    servo.set("torque_switch", 0);
    servo.run(1800000);
    QCOMPARE(servo.at("present_temperature"), 25);
}

void TestServoProtection::sensorFaultUnloadsIfConfigured_data()
{
    QTest::addColumn<int>("condition");
    QTest::addColumn<bool>("unloads");
    QTest::newRow("19 without bit 1") << 44 << false;
    QTest::newRow("19 with bit 1") << 46 << true;
}

void TestServoProtection::sensorFaultUnloadsIfConfigured()
{
    QFETCH(int, condition);
    QFETCH(bool, unloads);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("unload_condition", condition);
    servo.injectStatus(2);
    servo.set("goal_position", 2600);
    servo.run(1000);
    QCOMPARE(servo.at("servo_status"), 2);
    QCOMPARE(std::abs(servo.at("present_position") - 2048) < 5, unloads);
}

void TestServoProtection::led_data()
{
    QTest::addColumn<int>("condition");
    QTest::addColumn<int>("fault");
    QTest::addColumn<bool>("seenOn");
    QTest::addColumn<bool>("seenOff");
    QTest::newRow("no fault, 45: on") << 45 << 0 << true << false;
    QTest::newRow("no fault, 0: off") << 0 << 0 << false << true;
    QTest::newRow("fault in 20: blinks") << 45 << 1 << true << true;
    QTest::newRow("fault not in 20: on") << 44 << 1 << true << false;
    QTest::newRow("fault, 0: off") << 0 << 1 << false << true;
}

void TestServoProtection::led()
{
    QFETCH(int, condition);
    QFETCH(int, fault);
    QFETCH(bool, seenOn);
    QFETCH(bool, seenOff);
    Servo servo(QStringLiteral("STS3215"));
    servo.set("led_alarm_condition", condition);
    servo.injectStatus(std::uint8_t(fault));
    bool on = false;
    bool off = false;
    servo.run(2000, [&] { (servo.ledOn() ? on : off) = true; });
    QCOMPARE(on, seenOn);
    QCOMPARE(off, seenOff);
    servo.powerOff();
    QVERIFY(!servo.ledOn());
}

void TestServoProtection::powerOffForgetsTrips()
{
    Servo servo = blockedServo();
    stall(servo);
    servo.run(2500);
    QCOMPARE(servo.at("servo_status"), overload);
    servo.powerCycle();
    QCOMPARE(servo.at("servo_status"), 0);
    QCOMPARE(servo.at("present_load"), 0);
}

SERVODESK_GUILESS_TEST(TestServoProtection)
#include "tst_servo_protection.moc"

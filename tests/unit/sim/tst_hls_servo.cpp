// SPDX-License-Identifier: GPL-3.0-or-later
// What HLS servos do differently from STS: 44 is a current, 46 = 0 stops, calibration is 0x0B,
// there is no overload protection, gains act from RAM, and mode 4 knows one turn only.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "servo_fixture.h"

namespace {
using fixture::Servo;

sim::ServoConfig turned(double degrees)
{
    sim::ServoConfig config;
    config.initialDegrees = degrees;
    return config;
}

class Hls : public Servo {
public:
    explicit Hls(const sim::ServoConfig& config = turned(180))
        : Servo(QStringLiteral("HLS3625"), config)
    {}
    void mode(int value) { set("operating_mode", value); }
    bool isAtPosition(int steps, int tolerance = 12) const
    {
        return std::abs(at("present_position") - steps) <= tolerance;
    }
};
} // namespace

class TestHlsServo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void startValuesComeFromTheEprom_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        const auto row = [](const char* from, const char* to) {
            QTest::newRow(to) << QString::fromLatin1(from) << QString::fromLatin1(to);
        };
        row("protection_current", "goal_current");
        row("max_torque", "torque_limit");
        row("position_p", "kp");
        row("position_d", "kd");
        row("position_i", "ki");
    }
    void startValuesComeFromTheEprom()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        Hls servo;
        QCOMPARE(servo.raw(to), servo.raw(from));
        servo.set("lock", 0);
        servo.poke(from, 77);
        QVERIFY(servo.raw(to) != 77);
        servo.powerCycle();
        QCOMPARE(servo.raw(to), 77);
    }

    void speedModeLoadsTheSpeedGains()
    {
        Hls servo;
        servo.set("speed_p", 21);
        servo.set("speed_i", 23);
        servo.mode(1);
        QCOMPARE(servo.at("kp"), 21);
        QCOMPARE(servo.at("ki"), 23);
        servo.mode(0);
        QCOMPARE(servo.at("kp"), servo.at("position_p"));
    }

    void aMoveNeedsCurrentAndSpeed_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("current");
        QTest::addColumn<int>("speed");
        QTest::addColumn<bool>("moves");
        QTest::newRow("position") << 0 << 300 << 40 << true;
        QTest::newRow("position, no current") << 0 << 0 << 40 << false;
        QTest::newRow("position, speed 0") << 0 << 300 << 0 << false;
        QTest::newRow("speed mode, no current") << 1 << 0 << 40 << false;
        QTest::newRow("position PD") << 4 << 300 << 40 << true;
        QTest::newRow("position PD, speed 0") << 4 << 300 << 0 << false;
    }
    void aMoveNeedsCurrentAndSpeed()
    {
        QFETCH(int, mode);
        QFETCH(int, current);
        QFETCH(int, speed);
        QFETCH(bool, moves);
        Hls servo;
        servo.mode(mode);
        servo.set("goal_current", current);
        servo.set("goal_speed", speed);
        servo.set("goal_position", 3000);
        servo.run(2500);
        QCOMPARE(servo.isAtPosition(3000), moves);
        QCOMPARE(servo.isAtPosition(2048), !moves);
        servo.set("torque_switch", 1);
        servo.run(500);
        QCOMPARE(servo.isAtPosition(3000), moves);
    }

    void theCurrentLimitHolds_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("position") << 0;
        QTest::newRow("speed") << 1;
    }
    void theCurrentLimitHolds()
    {
        QFETCH(int, mode);
        sim::ServoConfig config = turned(180);
        config.load.stopHigh = 3.3;
        Hls servo(config);
        servo.mode(mode);
        servo.set("goal_current", 100);
        servo.set("goal_speed", 40);
        servo.set("goal_position", 3500);
        servo.set("torque_switch", 1);
        servo.run(1500);
        QVERIFY(std::abs(servo.at("present_current")) <= 101);
        QVERIFY(std::abs(servo.at("present_current")) >= 90);
        servo.set("goal_current", 200);
        servo.run(100);
        QVERIFY(std::abs(servo.at("present_current")) >= 190);
    }

    void aConstantCurrentActsBothWays_data()
    {
        QTest::addColumn<int>("current");
        QTest::newRow("one way") << 150;
        QTest::newRow("the other") << -150;
    }
    void aConstantCurrentActsBothWays()
    {
        QFETCH(int, current);
        sim::ServoConfig config = turned(180);
        config.load.stopHigh = 3.3;
        config.load.stopLow = 3.0;
        Hls servo(config);
        servo.mode(2);
        servo.set("goal_current", current);
        servo.run(1500);
        QVERIFY(std::abs(servo.at("present_current") - current) <= 4);
    }

    void pwmHasItsSignInBitTen_data()
    {
        QTest::addColumn<int>("word");
        QTest::addColumn<int>("load");
        QTest::newRow("300") << 300 << 300;
        QTest::newRow("-300") << (0x400 | 300) << -300;
    }
    void pwmHasItsSignInBitTen()
    {
        QFETCH(int, word);
        QFETCH(int, load);
        Hls servo;
        servo.mode(3);
        servo.write({44, std::uint8_t(word), std::uint8_t(word >> 8)});
        servo.run(1000);
        QCOMPARE(servo.at("present_load"), load);
        QVERIFY(servo.at("present_speed") * load < 0);
    }

    void modeFourIsSingleTurn_data()
    {
        QTest::addColumn<int>("goal");
        QTest::addColumn<int>("reached");
        QTest::newRow("beyond the turn") << 6000 << 4095;
        QTest::newRow("below zero") << -500 << 0;
        QTest::newRow("the long way round") << 4000 << 4000;
    }
    void modeFourIsSingleTurn()
    {
        QFETCH(int, goal);
        QFETCH(int, reached);
        Hls servo(turned(10));
        servo.mode(4);
        const double before = servo.shaftSteps();
        servo.set("goal_position", goal);
        servo.run(4000);
        QVERIFY(std::abs(servo.shaftSteps() - reached) < 30);
        QVERIFY((servo.shaftSteps() - before) * (reached - before) > 0);
    }

    void bothLimitsZeroIsMultiTurn()
    {
        Hls servo;
        servo.set("min_angle_limit", 0);
        servo.set("max_angle_limit", 0);
        const double before = servo.shaftSteps();
        servo.set("goal_position", 2048 + 8192);
        servo.run(8000);
        QVERIFY(std::abs(servo.shaftSteps() - before - 8192) < 16);
    }

    void calibratesByInstructionOnly()
    {
        Hls servo(turned(100));
        const int before = servo.at("present_position");
        servo.set("lock", 0);
        servo.write({40, 128});
        QCOMPARE(servo.at("present_position"), before);
        QCOMPARE(servo.at("position_offset"), 0);
        QVERIFY(servo.ask(0x0B));
        QVERIFY(servo.isAtPosition(2048, 1));
        servo.run(20);
        QVERIFY(servo.ask(0x0B, {0x00, 0x04}));
        QVERIFY(servo.isAtPosition(1024, 1));
        servo.powerCycle();
        QVERIFY(servo.isAtPosition(1024, 1));
    }

    void anOffsetHasItsSignInBitFifteen()
    {
        Hls servo;
        servo.write({31, 0xB8, 0x8B}); // −3000
        QCOMPARE(servo.at("position_offset"), -3000);
        QVERIFY(servo.isAtPosition((2048 + 3000) % 4096, 1));
    }

    void hasNoOverloadProtection()
    {
        sim::ServoConfig config = turned(180);
        config.load.stopHigh = 3.3;
        Hls servo(config);
        servo.set("unload_condition", 255);
        servo.set("protection_current", 2047);
        servo.set("goal_current", 2047);
        servo.set("goal_position", 3500);
        servo.run(6000);
        QCOMPARE(servo.at("servo_status"), 0);
        QVERIFY(std::abs(servo.at("present_load")) > 800);
    }

    void anOvercurrentSwitchesOff()
    {
        sim::ServoConfig config = turned(180);
        config.load.stopHigh = 3.3;
        Hls servo(config);
        servo.set("unload_condition", 8);
        servo.set("protection_current", 100);
        servo.set("goal_current", 300);
        servo.set("goal_position", 3500);
        servo.run(4000);
        QCOMPARE(servo.at("servo_status"), 8);
        QCOMPARE(servo.at("torque_switch"), 0);
        servo.set("goal_position", 1500);
        servo.run(3000);
        QCOMPARE(servo.at("servo_status"), 0);
        QVERIFY(servo.isAtPosition(1500));
    }

    void movingHasTwoFlags()
    {
        Hls servo;
        QCOMPARE(servo.at("moving"), 0);
        servo.set("goal_position", 3500);
        servo.run(200);
        QCOMPARE(servo.at("moving"), 3);
        servo.run(4000);
        QCOMPARE(servo.at("moving"), 0);
        sim::ServoConfig blocked = turned(180);
        blocked.load.stopHigh = 3.2;
        Hls held(blocked);
        held.set("goal_speed", 5);
        held.set("goal_position", 3500);
        held.run(3000);
        QCOMPARE(held.at("moving"), 2);
    }

    void theSecondaryIdFollowsTheId()
    {
        Hls servo;
        servo.keep("id", 12);
        QCOMPARE(servo.at("secondary_id"), 12);
        servo.powerCycle();
        QCOMPARE(servo.at("secondary_id"), 12);
        servo.keep("secondary_id", 30);
        QCOMPARE(servo.id(), 12);
        servo.set("id", 13);
        servo.powerCycle();
        QCOMPARE(servo.at("secondary_id"), 30);
    }

    void theHd1910StartsInModeFour()
    {
        Servo servo(QStringLiteral("HD-1910"), turned(180));
        QCOMPARE(servo.at("operating_mode"), 4);
        QCOMPARE(Hls().at("operating_mode"), 0);
    }
};

SERVODESK_GUILESS_TEST(TestHlsServo)
#include "tst_hls_servo.moc"

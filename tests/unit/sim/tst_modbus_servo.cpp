// SPDX-License-Identifier: GPL-3.0-or-later
// The SMSMB servo driven with Modbus functions: what it refuses, what it keeps under which lock,
// what its start values, modes and fault reset do. Register numbers are the sheet's.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "servo_fixture.h"

using base::Bytes;

namespace {
constexpr int id = 10;
constexpr int offset = 15;
constexpr int mode = 16;
constexpr int goal = 128;
constexpr int torque = 129;
constexpr int lock = 133;
constexpr int reset = 134;
constexpr int status = 256;
constexpr int position = 257;
constexpr int phase = 392;

std::uint8_t high(int value)
{
    return std::uint8_t(value >> 8);
}
std::uint8_t low(int value)
{
    return std::uint8_t(value);
}

class Station : public fixture::Servo {
public:
    Station()
        : Station(fixture::configOf(QStringLiteral("SMSMB")))
    {}
    explicit Station(const sim::ServoConfig& config)
        : Servo(QStringLiteral("SMSMB"), config)
    {}

    std::optional<sim::ServoReply> call(std::uint8_t function, const Bytes& params,
                                        bool broadcast = false)
    {
        return handle({broadcast, function, params, -1});
    }
    /// The register, signed; a refusal fails the test through its odd value.
    int get(int number)
    {
        const auto answer = call(0x03, {high(number), low(number), 0, 1});
        if (!answer || answer->function != 0x03 || answer->data.size() != 3) {
            return 99999;
        }
        return std::int16_t(answer->data[1] << 8 | answer->data[2]);
    }
    bool put(int number, int value)
    {
        const Bytes params{high(number), low(number), high(value), low(value)};
        const auto answer = call(0x06, params);
        run(20);
        return answer && answer->function == 0x06 && answer->data == params;
    }
    void unlockFactory() { put(lock, 128); }
    void factory(int number, int value)
    {
        unlockFactory();
        put(number, value);
        put(lock, 1);
    }
};

/// Blocked against a stop until a protection answers.
sim::ServoConfig jammed()
{
    sim::ServoConfig config = fixture::configOf(QStringLiteral("SMSMB"));
    config.load.stopHigh = 3.3;
    return config;
}
} // namespace

class TestModbusServo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void refuses_data()
    {
        QTest::addColumn<int>("function");
        QTest::addColumn<Bytes>("params");
        QTest::addColumn<int>("reason");
        const auto row = [](const char* name, int function, const Bytes& params, int reason) {
            QTest::newRow(name) << function << params << reason;
        };
        row("function 1", 0x01, {0, 0, 0, 1}, 1);
        row("function 4", 0x04, {0, 0, 0, 1}, 1);
        row("read of a hole", 0x03, {0, 4, 0, 1}, 2);
        row("read that ends in a hole", 0x03, {0, 0, 0, 5}, 2);
        row("read behind the table", 0x03, {1, 152, 0, 1}, 2);
        row("read of the highest register", 0x03, {255, 255, 0, 1}, 2);
        row("read of nothing", 0x03, {0, 0, 0, 0}, 3);
        row("read of 126", 0x03, {0, 0, 0, 126}, 3);
        row("write of a reading", 0x06, {1, 1, 0, 5}, 2);
        row("write of the identity", 0x06, {0, 0, 0, 5}, 2);
        row("write of a hole", 0x06, {0, 100, 0, 5}, 2);
        row("block into a hole", 0x10, {0, 134, 0, 2, 4, 0, 0, 0, 0}, 2);
        row("block of nothing", 0x10, {0, 128, 0, 0, 0}, 3);
        row("byte count too small", 0x10, {0, 128, 0, 2, 2, 0, 0}, 3);
        row("byte count too large", 0x10, {0, 128, 0, 1, 4, 0, 0, 0, 0}, 3);
        row("station 0", 0x06, {0, 10, 0, 0}, 3);
        row("station 248", 0x06, {0, 10, 0, 248}, 3);
        row("station 300", 0x06, {0, 10, 1, 44}, 3);
        row("rate 10", 0x06, {0, 11, 0, 10}, 3);
        row("rate 99", 0x06, {0, 11, 0, 99}, 3);
        row("reply delay 501", 0x06, {0, 12, 1, 245}, 3);
        row("maximum angle 4096", 0x06, {0, 14, 16, 0}, 3);
        row("offset 2048", 0x06, {0, 15, 8, 0}, 3);
        row("mode 5", 0x06, {0, 16, 0, 5}, 3);
        row("mode 77", 0x06, {0, 16, 0, 77}, 3);
        row("lock 2", 0x06, {0, 133, 0, 2}, 3);
        row("torque switch 128", 0x06, {0, 129, 0, 128}, 3);
        row("the last of a block", 0x10, {0, 128, 0, 2, 4, 12, 0, 0, 2}, 3);
        row("factory block behind its lock", 0x06, {1, 140, 0, 120}, 2);
    }
    void refuses()
    {
        QFETCH(int, function);
        QFETCH(Bytes, params);
        QFETCH(int, reason);
        Station servo;
        const auto answer = servo.call(std::uint8_t(function), params);
        QVERIFY(answer);
        QCOMPARE(int(answer->function), function | 0x80);
        QCOMPARE(answer->data, Bytes{std::uint8_t(reason)});
        QCOMPARE(servo.get(torque), 0);
        QVERIFY(!servo.call(std::uint8_t(function), params, true));
        QVERIFY2(servo.get(id) == 1 && servo.get(11) == 2 && servo.get(mode) == 0 &&
                     servo.get(goal) == 0 && servo.get(lock) == 1,
                 "nothing of it was taken");
    }

    void acceptsDocumentedRequests_data()
    {
        QTest::addColumn<int>("number");
        QTest::addColumn<int>("value");
        QTest::newRow("station 247") << int(id) << 247;
        QTest::newRow("rate 9") << 11 << 9;
        QTest::newRow("reply delay 500") << 12 << 500;
        QTest::newRow("offset -2047") << int(offset) << -2047;
        QTest::newRow("mode 4") << int(mode) << 4;
        QTest::newRow("goal -32768") << int(goal) << -32768;
        QTest::newRow("factory block, open") << 396 << 120;
    }
    void acceptsDocumentedRequests()
    {
        QFETCH(int, number);
        QFETCH(int, value);
        Station servo;
        servo.unlockFactory();
        QVERIFY(servo.put(number, value));
        QCOMPARE(servo.get(number), value);
    }

    void repliesAsDocumented_data()
    {
        QTest::addColumn<int>("function");
        QTest::addColumn<Bytes>("params");
        QTest::addColumn<Bytes>("reply");
        QTest::newRow("write one") << 0x06 << Bytes{0, 129, 0, 1} << Bytes{0, 129, 0, 1};
        QTest::newRow("write several")
            << 0x10 << Bytes{0, 128, 0, 4, 8, 8, 0, 0, 1, 0, 10, 0, 50} << Bytes{0, 128, 0, 4};
        QTest::newRow("read") << 0x03 << Bytes{0, 10, 0, 2} << Bytes{4, 0, 1, 0, 2};
        QTest::newRow("report ID") << 0x11 << Bytes{} << Bytes{3, 1, 0, 0};
    }
    void repliesAsDocumented()
    {
        QFETCH(int, function);
        QFETCH(Bytes, params);
        QFETCH(Bytes, reply);
        Station servo;
        const auto answer = servo.call(std::uint8_t(function), params);
        QVERIFY(answer);
        QCOMPARE(int(answer->function), function);
        QCOMPARE(answer->data, reply);
        QCOMPARE(answer->id, 1);
    }

    void broadcastIsExecutedWithoutReply()
    {
        Station servo;
        QVERIFY(!servo.call(0x06, {0, 129, 0, 1}, true));
        QCOMPARE(servo.get(torque), 1);
        QVERIFY(!servo.call(0x10, {0, 131, 0, 1, 2, 0, 77}, true));
        QCOMPARE(servo.get(131), 77);
        QVERIFY(!servo.call(0x03, {0, 0, 0, 4}, true));
        QVERIFY(servo.call(0x11, {}, true));
    }

    void rebootsWithoutReply_data()
    {
        QTest::addColumn<bool>("broadcast");
        QTest::newRow("alone") << false;
        QTest::newRow("all") << true;
    }
    void rebootsWithoutReply()
    {
        QFETCH(bool, broadcast);
        Station servo;
        servo.put(131, 33);
        QVERIFY(!servo.call(0x41, {}, broadcast));
        QVERIFY(!servo.call(0x03, {0, 0, 0, 1}));
        servo.run(2000);
        QVERIFY(servo.get(131) != 33);
    }

    void locksDecidePersistence_data()
    {
        QTest::addColumn<int>("lockLabel");
        QTest::addColumn<int>("number");
        QTest::addColumn<int>("value");
        QTest::addColumn<bool>("acts");
        QTest::addColumn<bool>("stays");
        QTest::newRow("EPROM, open") << 0 << 17 << 50 << true << true;
        QTest::newRow("EPROM, closed") << 1 << 17 << 50 << true << false;
        QTest::newRow("EPROM, open for the factory") << 128 << 17 << 50 << true << false;
        QTest::newRow("factory block, open") << 128 << 395 << 60 << true << true;
        QTest::newRow("factory block, EPROM open") << 0 << 395 << 60 << false << false;
        QTest::newRow("factory block, closed") << 1 << 395 << 60 << false << false;
        QTest::newRow("RAM") << 0 << 131 << 60 << true << false;
    }
    void locksDecidePersistence()
    {
        QFETCH(int, lockLabel);
        QFETCH(int, number);
        QFETCH(int, value);
        QFETCH(bool, acts);
        QFETCH(bool, stays);
        Station servo;
        const int before = servo.get(number);
        QVERIFY(before != value);
        servo.put(lock, lockLabel);
        QCOMPARE(servo.put(number, value), acts); // what does not act is refused
        QCOMPARE(servo.get(number), acts ? value : before);
        servo.powerCycle();
        QCOMPARE(servo.get(number), stays ? value : before);
        QCOMPARE(servo.get(lock), 1);
    }

    void startValuesComeFromTheFactoryBlock_data()
    {
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("to");
        QTest::newRow("torque limit") << 404 << 132;
        QTest::newRow("acceleration") << 405 << 130;
        QTest::newRow("speed") << 406 << 131;
    }
    void startValuesComeFromTheFactoryBlock()
    {
        QFETCH(int, from);
        QFETCH(int, to);
        Station servo;
        QCOMPARE(servo.get(to), servo.get(from));
        servo.factory(from, 44);
        QVERIFY(servo.get(to) != 44);
        servo.powerCycle();
        QCOMPARE(servo.get(to), 44);
    }

    void stationAndRateChangeAtOnce()
    {
        Station servo;
        servo.put(lock, 0);
        const auto answer = servo.call(0x06, {0, id, 0, 7});
        QVERIFY(answer);
        QCOMPARE(answer->id, 1);
        QCOMPARE(servo.id(), 7);
        servo.run(20);
        servo.put(11, 8);
        QCOMPARE(servo.baud(), 9600);
        servo.powerCycle();
        QCOMPARE(servo.id(), 7);
        QCOMPARE(servo.baud(), 9600);
    }

    void supportsItsRates_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("baud");
        const int rates[] = {256000, 128000, 115200, 57600, 56000, 38400, 19200, 14400, 9600, 4800};
        for (int code = 0; code < 10; ++code) {
            QTest::addRow("%d", code) << code << rates[code];
        }
    }
    void supportsItsRates()
    {
        QFETCH(int, code);
        QFETCH(int, baud);
        Station servo;
        QCOMPARE(servo.baud(), 115200);
        servo.put(11, code);
        QCOMPARE(servo.baud(), baud);
    }

    void theReplyDelayIsItsRegister()
    {
        Station servo;
        QCOMPARE(servo.replyDelay(), base::Duration(500));
        servo.put(12, 0);
        QCOMPARE(servo.replyDelay(), base::Duration(0));
    }

    void aGoalMovesItAndStatusShowsTorqueOn()
    {
        Station servo;
        QCOMPARE(servo.get(status), 0);
        QVERIFY(servo.put(goal, 3000));
        QCOMPARE(servo.get(status), 16);
        QCOMPARE(servo.get(262), 1);
        servo.run(3000);
        QVERIFY(std::abs(servo.get(position) - 3000) <= 4);
        QCOMPARE(servo.get(262), 0);
        servo.put(torque, 0);
        QCOMPARE(servo.get(status), 0);
    }

    void aBurstWriteSetsTorque()
    {
        Station servo;
        servo.call(0x10, {0, 128, 0, 2, 4, high(3000), low(3000), 0, 0});
        servo.run(500);
        QCOMPARE(servo.get(torque), 0);
        QVERIFY(std::abs(servo.get(position) - 2048) <= 2);
        servo.call(0x10, {0, 128, 0, 2, 4, high(3000), low(3000), 0, 1});
        servo.run(3000);
        QVERIFY(std::abs(servo.get(position) - 3000) <= 4);
    }

    void torqueByCommandOnly()
    {
        Station servo;
        servo.factory(phase, 4);
        servo.put(goal, 3000);
        servo.run(500);
        QCOMPARE(servo.get(torque), 0);
        servo.put(torque, 1);
        servo.run(3000);
        QVERIFY(std::abs(servo.get(position) - 3000) <= 4);
    }

    void valueFourCentersThePosition()
    {
        sim::ServoConfig config = fixture::configOf(QStringLiteral("SMSMB"));
        config.initialDegrees = 100;
        Station servo(config);
        const int before = servo.get(position);
        servo.put(lock, 0);
        QVERIFY(servo.put(reset, 4));
        QCOMPARE(servo.get(reset), 0);
        QVERIFY(std::abs(servo.get(position) - 2048) <= 1);
        QVERIFY(std::abs(servo.get(offset) - (before - 2048)) <= 1);
        servo.powerCycle();
        QVERIFY(std::abs(servo.get(position) - 2048) <= 1);
    }

    void speedModeTurnsBothWays_data()
    {
        QTest::addColumn<int>("speed");
        QTest::newRow("forward") << 20;
        QTest::newRow("back") << -20;
    }
    void speedModeTurnsBothWays()
    {
        QFETCH(int, speed);
        Station servo;
        servo.put(mode, 1);
        servo.put(131, speed);
        servo.run(1500);
        QVERIFY(std::abs(servo.get(258) - speed) <= 2);
    }

    void aSpeedIsUnsignedInPositionMode()
    {
        Station servo;
        servo.put(131, 0xFFFF);
        servo.put(goal, 3000);
        servo.run(3000);
        QVERIFY(std::abs(servo.get(position) - 3000) <= 4);
    }

    void pwmModeDrivesOpenLoop_data()
    {
        QTest::addColumn<int>("pwm");
        QTest::newRow("forward") << 300;
        QTest::newRow("back") << -300;
    }
    void pwmModeDrivesOpenLoop()
    {
        QFETCH(int, pwm);
        Station servo;
        servo.put(mode, 2);
        servo.put(131, pwm);
        servo.run(1500);
        QCOMPARE(servo.get(259), pwm);
        QVERIFY(std::abs(servo.get(258)) > 10);
    }

    void modeThreeReleasesTorqueAtTheGoal()
    {
        Station servo;
        servo.put(mode, 3);
        servo.put(goal, 2600);
        servo.run(100);
        QCOMPARE(servo.get(torque), 1);
        servo.run(3000);
        QCOMPARE(servo.get(torque), 0);
        QVERIFY(std::abs(servo.get(position) - 2600) <= 20);
    }

    void stepModeAddsUp()
    {
        Station servo;
        servo.put(mode, 4);
        const double before = servo.shaftSteps();
        servo.put(goal, 500);
        servo.run(2000);
        servo.put(goal, 500);
        servo.run(2000);
        servo.put(goal, -200);
        servo.run(2000);
        QVERIFY(std::abs(servo.shaftSteps() - before - 800) < 8);
    }

    void bothLimitsZeroIsMultiTurn()
    {
        Station servo;
        servo.put(13, 0);
        servo.put(14, 0);
        const double before = servo.shaftSteps();
        servo.put(goal, 2048 + 8192);
        servo.run(8000);
        QVERIFY(std::abs(servo.shaftSteps() - before - 8192) < 8);
    }

    void limitsHoldAGoal()
    {
        Station servo;
        servo.put(14, 2500);
        servo.put(goal, 3500);
        servo.run(3000);
        QVERIFY(std::abs(servo.get(position) - 2500) <= 4);
    }

    void anOverloadReducesTorqueUntilCleared_data()
    {
        QTest::addColumn<int>("phaseWord");
        QTest::addColumn<int>("number");
        QTest::addColumn<int>("value");
        QTest::addColumn<bool>("releases");
        QTest::newRow("turning back") << 0 << goal << 1500 << true;
        QTest::newRow("further the same way") << 0 << goal << 3500 << false;
        QTest::newRow("torque off") << 0 << torque << 0 << true;
        QTest::newRow("reset bit") << 0 << reset << 1 << true;
        QTest::newRow("wrong reset bit") << 0 << reset << 2 << false;
        QTest::newRow("by command: turning back") << 8 << goal << 1500 << false;
        QTest::newRow("by command: torque off") << 8 << torque << 0 << false;
        QTest::newRow("by command: reset bit") << 8 << reset << 1 << true;
    }
    void anOverloadReducesTorqueUntilCleared()
    {
        QFETCH(int, phaseWord);
        QFETCH(int, number);
        QFETCH(int, value);
        QFETCH(bool, releases);
        Station servo(jammed());
        servo.factory(phase, phaseWord);
        servo.factory(393, 32);
        servo.put(goal, 3000);
        servo.run(4000);
        QVERIFY((servo.get(status) & 32) != 0);
        QCOMPARE(std::abs(servo.get(259)), servo.get(400));
        servo.put(number, value);
        servo.run(50);
        QCOMPARE((servo.get(status) & 32) == 0, releases);
    }

    void anOvercurrentReleasesTorque()
    {
        Station servo(jammed());
        servo.factory(393, 8);
        servo.factory(398, 100);
        servo.put(goal, 3000);
        servo.run(4000);
        QVERIFY((servo.get(status) & 8) != 0);
        QCOMPARE(servo.get(259), 0);
        QCOMPARE(servo.get(torque), 1);
        servo.put(goal, 1500);
        servo.run(3000);
        QCOMPARE(servo.get(status), 16);
        QVERIFY(std::abs(servo.get(position) - 1500) <= 4);
    }

    void otherFaultsUnload_data()
    {
        QTest::addColumn<int>("bit");
        QTest::addColumn<int>("resetBit");
        QTest::newRow("voltage") << 1 << 32;
        QTest::newRow("temperature") << 4 << 64;
        QTest::newRow("encoder") << 2 << 128;
    }
    void otherFaultsUnload()
    {
        QFETCH(int, bit);
        QFETCH(int, resetBit);
        Station servo;
        const auto provoke = [&](bool on) {
            if (bit == 1) {
                servo.environment().supplyVolts = on ? 20.0 : 12.0;
            } else if (bit == 4) {
                servo.setTemperature(on ? 90.0 : 25.0);
            } else if (on) {
                servo.injectStatus(2);
            }
            servo.run(300);
        };
        servo.factory(phase, 8);
        servo.put(goal, 2100);
        servo.run(500);
        provoke(true);
        QVERIFY((servo.get(status) & bit) != 0);
        QCOMPARE(servo.get(259), 0);
        provoke(false);
        QVERIFY2((servo.get(status) & bit) != 0, "a fault stays until it is cleared");
        servo.put(reset, resetBit);
        servo.run(50);
        QCOMPARE(servo.get(status) & bit, 0);
        QCOMPARE(servo.get(reset), 0);
    }

    void anAutomaticResetNeedsNoCommand()
    {
        Station servo;
        servo.setTemperature(90);
        servo.run(100);
        QVERIFY((servo.get(status) & 4) != 0);
        servo.setTemperature(25);
        servo.run(100);
        QCOMPARE(servo.get(status), 0);
    }

    void theImageRestoresBothBlocks()
    {
        Station servo;
        servo.put(lock, 0);
        servo.put(17, 77);
        servo.factory(395, 61);
        Station again;
        QVERIFY(again.setEpromImage(servo.epromImage()));
        QCOMPARE(again.get(17), 77);
        QCOMPARE(again.get(395), 61);
        QVERIFY(!again.setEpromImage(fixture::Servo(QStringLiteral("SM40BLHV")).epromImage()));
    }
};

SERVODESK_GUILESS_TEST(TestModbusServo)
#include "tst_modbus_servo.moc"

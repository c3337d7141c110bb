// SPDX-License-Identifier: GPL-3.0-or-later
// LX servos driven with the commands of the sheet: what each keeps, what is ignored, how moves,
// motor mode and offset turn the shaft, and what heat and voltage do. Parameters are written out as
// bytes, low byte first.
#include "support/test_main.h"

#include <QRegularExpression>
#include <QTest>

#include "servo_fixture.h"

using base::Bytes;

namespace {
enum Command : std::uint8_t {
    Move = 1,
    ReadMove = 2,
    Wait = 7,
    ReadWait = 8,
    Start = 11,
    Stop = 12,
    WriteId = 13,
    ReadId = 14,
    TryOffset = 17,
    SaveOffset = 18,
    ReadOffset = 19,
    WriteAngles = 20,
    ReadAngles = 21,
    WriteVolts = 22,
    ReadVolts = 23,
    WriteLimit = 24,
    ReadLimit = 25,
    ReadTemperature = 26,
    ReadVin = 27,
    ReadPosition = 28,
    WriteMode = 29,
    ReadMode = 30,
    WriteLoad = 31,
    ReadLoad = 32,
    WriteLed = 33,
    ReadLed = 34,
    WriteMask = 35,
    ReadMask = 36,
};

Bytes words(int first, int second)
{
    return {std::uint8_t(first), std::uint8_t(first >> 8), std::uint8_t(second),
            std::uint8_t(second >> 8)};
}

class Lx : public fixture::Servo {
public:
    explicit Lx(const char* model = "LX-16A")
        : Servo(QString::fromLatin1(model))
    {}
    Lx(const char* model, const sim::ServoConfig& config)
        : Servo(QString::fromLatin1(model), config)
    {}

    /// What the servo answers; nothing for silence.
    std::optional<Bytes> tell(std::uint8_t command, const Bytes& params = {},
                              bool broadcast = false)
    {
        const auto answer = handle({broadcast, command, params, -1});
        if (!answer) {
            run(10); // an EPROM write
            return std::nullopt;
        }
        return answer->function == command ? std::optional(answer->data) : std::nullopt;
    }
    int word(std::uint8_t command)
    {
        const auto data = tell(command);
        return data && data->size() == 2 ? std::int16_t((*data)[0] | (*data)[1] << 8) : 99999;
    }
    int position() { return word(ReadPosition); }
    void load() { tell(WriteLoad, {1}); }
    void move(int angle, int time = 0) { tell(Move, words(angle, time)); }
};

/// 0.24° a step, from the zero of the sensor.
double steps(const Lx& servo)
{
    return servo.shaftDegrees() / 0.24;
}

sim::ServoConfig at(double degrees)
{
    sim::ServoConfig config = fixture::configOf(QStringLiteral("LX-16A"));
    config.initialDegrees = degrees;
    return config;
}
} // namespace

class TestLxServo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyReadReturnsItsDefault_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<Bytes>("reply");
        const auto row = [](const char* name, int command, const Bytes& reply) {
            QTest::newRow(name) << command << reply;
        };
        row("move", ReadMove, {0, 0, 0, 0});
        row("ID", ReadId, {1});
        row("offset", ReadOffset, {0});
        row("angle limits", ReadAngles, {0x00, 0x00, 0xE8, 0x03});
        row("voltage limits", ReadVolts, {0x64, 0x19, 0xE0, 0x2E});
        row("temperature limit", ReadLimit, {85});
        row("temperature", ReadTemperature, {25});
        row("mode and speed", ReadMode, {0, 0, 0, 0});
        row("load", ReadLoad, {0});
        row("LED", ReadLed, {0});
        row("fault mask", ReadMask, {7});
    }
    void everyReadReturnsItsDefault()
    {
        QFETCH(int, command);
        QFETCH(Bytes, reply);
        Lx servo;
        QCOMPARE(servo.tell(std::uint8_t(command)).value_or(Bytes{}), reply);
        const bool answersAll = command == ReadId;
        QCOMPARE(servo.tell(std::uint8_t(command), {}, true).has_value(), answersAll);
    }

    void measures()
    {
        Lx servo("LX-16A", at(120));
        QVERIFY(std::abs(servo.position() - 500) <= 1);
        QVERIFY(std::abs(servo.word(ReadVin) - 7400) <= 10);
    }

    void unknownCommandsStaySilent()
    {
        Lx servo;
        for (const int command : {0, 3, 5, 9, 10, 15, 37, 92, 255}) {
            QVERIFY(!servo.tell(std::uint8_t(command)));
            QVERIFY(!servo.tell(std::uint8_t(command), {1}));
        }
    }

    void theStoredMoveIsReadWhereImplemented_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<bool>("answers");
        QTest::newRow("LX-16A") << QStringLiteral("LX-16A") << false;
        QTest::newRow("LX-224") << QStringLiteral("LX-224") << true;
        QTest::newRow("HTS-35H") << QStringLiteral("HTS-35H") << true;
    }
    void theStoredMoveIsReadWhereImplemented()
    {
        QFETCH(QString, model);
        QFETCH(bool, answers);
        Lx servo(qPrintable(model));
        servo.tell(Wait, words(300, 500));
        QCOMPARE(servo.tell(ReadWait), answers ? std::optional(words(300, 500)) : std::nullopt);
    }

    void powerOffKeepsPersistentParameters_data()
    {
        QTest::addColumn<int>("write");
        QTest::addColumn<int>("read");
        QTest::addColumn<Bytes>("value");
        QTest::addColumn<bool>("kept");
        const auto row = [](const char* name, int write, int read, const Bytes& value, bool kept) {
            QTest::newRow(name) << write << read << value << kept;
        };
        row("ID", WriteId, ReadId, {7}, true);
        row("offset, tried", TryOffset, ReadOffset, {0xE2}, false);
        row("angle limits", WriteAngles, ReadAngles, words(100, 900), true);
        row("voltage limits", WriteVolts, ReadVolts, words(6000, 9000), true);
        row("temperature limit", WriteLimit, ReadLimit, {70}, true);
        row("mode and speed", WriteMode, ReadMode, {1, 0, 0x0C, 0xFE}, false);
        row("load", WriteLoad, ReadLoad, {1}, false);
        row("LED", WriteLed, ReadLed, {1}, true);
        row("fault mask", WriteMask, ReadMask, {5}, true);
        row("move", Move, ReadMove, words(300, 500), false);
    }
    void powerOffKeepsPersistentParameters()
    {
        QFETCH(int, write);
        QFETCH(int, read);
        QFETCH(Bytes, value);
        QFETCH(bool, kept);
        Lx servo;
        const auto before = servo.tell(std::uint8_t(read));
        QVERIFY(!servo.tell(std::uint8_t(write), value));
        QCOMPARE(servo.tell(std::uint8_t(read)).value_or(Bytes{}), value);
        servo.powerCycle();
        QCOMPARE(servo.tell(std::uint8_t(read)).value_or(Bytes{}), kept ? value : *before);
    }

    void anOffsetStaysAfterTheSave()
    {
        Lx servo;
        servo.tell(TryOffset, {0xE2});
        servo.tell(SaveOffset);
        servo.tell(TryOffset, {10});
        servo.powerCycle();
        QCOMPARE(servo.tell(ReadOffset), std::optional(Bytes{0xE2}));
    }

    void broadcastRenumbersAll()
    {
        Lx servo;
        QVERIFY(!servo.tell(WriteId, {9}, true));
        QCOMPARE(servo.id(), 9);
    }

    void invalidFramesAreIgnored_data()
    {
        QTest::addColumn<int>("write");
        QTest::addColumn<int>("read");
        QTest::addColumn<Bytes>("value");
        const auto row = [](const char* name, int write, int read, const Bytes& value) {
            QTest::newRow(name) << write << read << value;
        };
        row("ID 254", WriteId, ReadId, {254});
        row("offset 126", TryOffset, ReadOffset, {126});
        row("offset -126", TryOffset, ReadOffset, {0x82});
        row("angle above 1000", WriteAngles, ReadAngles, words(0, 1001));
        row("angles crossed", WriteAngles, ReadAngles, words(900, 100));
        row("angles equal", WriteAngles, ReadAngles, words(500, 500));
        row("voltage too low", WriteVolts, ReadVolts, words(4499, 9000));
        row("voltage too high", WriteVolts, ReadVolts, words(6000, 14001));
        row("voltages crossed", WriteVolts, ReadVolts, words(9000, 6000));
        row("49 degrees", WriteLimit, ReadLimit, {49});
        row("101 degrees", WriteLimit, ReadLimit, {101});
        row("mode 2", WriteMode, ReadMode, {2, 0, 0, 0});
        row("speed 1001", WriteMode, ReadMode, {1, 0, 0xE9, 0x03});
        row("load 2", WriteLoad, ReadLoad, {2});
        row("LED 2", WriteLed, ReadLed, {2});
        row("mask 8", WriteMask, ReadMask, {8});
        row("move to 1001", Move, ReadMove, words(1001, 0));
        row("move for 30001 ms", Move, ReadMove, words(500, 30001));
        row("too short", WriteAngles, ReadAngles, {100, 0, 200});
        row("too long", WriteLimit, ReadLimit, {60, 0});
    }
    void invalidFramesAreIgnored()
    {
        QFETCH(int, write);
        QFETCH(int, read);
        QFETCH(Bytes, value);
        Lx servo;
        const auto before = servo.tell(std::uint8_t(read));
        servo.tell(std::uint8_t(write), value);
        QCOMPARE(servo.tell(std::uint8_t(read)), before);
    }

    void aMoveTakesItsTime()
    {
        Lx servo("LX-16A", at(60));
        servo.load();
        servo.move(750, 2000);
        servo.run(1000);
        QVERIFY(std::abs(servo.position() - 500) <= 15);
        servo.run(1200);
        QVERIFY(std::abs(servo.position() - 750) <= 5);
        QCOMPARE(servo.tell(ReadMove), std::optional(words(750, 2000)));
    }

    void timeZeroIsFullSpeed()
    {
        Lx servo("LX-16A", at(60));
        servo.load();
        servo.move(750);
        servo.run(800);
        QVERIFY(std::abs(servo.position() - 750) <= 5);
    }

    void anUnloadedMotorStaysWhereItIs()
    {
        Lx servo("LX-16A", at(60));
        servo.move(750);
        servo.run(500);
        QVERIFY(std::abs(servo.position() - 250) <= 2);
        servo.load();
        servo.run(500);
        QVERIFY2(std::abs(servo.position() - 250) <= 2, "loading holds, it does not catch up");
        QCOMPARE(servo.tell(ReadLoad), std::optional(Bytes{1}));
    }

    void limitsHoldAMove_data()
    {
        QTest::addColumn<int>("angle");
        QTest::addColumn<int>("reached");
        QTest::newRow("below") << 100 << 300;
        QTest::newRow("above") << 900 << 700;
        QTest::newRow("between") << 600 << 600;
    }
    void limitsHoldAMove()
    {
        QFETCH(int, angle);
        QFETCH(int, reached);
        Lx servo;
        servo.tell(WriteAngles, words(300, 700));
        servo.load();
        servo.move(angle);
        servo.run(1500);
        QVERIFY(std::abs(servo.position() - reached) <= 5);
        QCOMPARE(servo.tell(ReadMove), std::optional(words(angle, 0)));
    }

    void aStoredMoveWaitsForTheStart()
    {
        Lx servo("LX-16A", at(60));
        servo.load();
        servo.tell(Wait, words(750, 1000));
        servo.run(1500);
        QVERIFY(std::abs(servo.position() - 250) <= 2);
        servo.tell(Start, {}, true);
        servo.run(1500);
        QVERIFY(std::abs(servo.position() - 750) <= 5);
        QCOMPARE(servo.tell(ReadMove), std::optional(words(750, 1000)));
        servo.move(250);
        servo.run(1500);
        servo.tell(Start);
        servo.run(1500);
        QVERIFY2(std::abs(servo.position() - 250) <= 5, "a start without a stored move");
    }

    void stopHoldsWhereItIs()
    {
        Lx servo("LX-16A", at(60));
        servo.load();
        servo.move(750, 2000);
        servo.run(1000);
        servo.tell(Stop);
        const int stopped = servo.position();
        servo.run(2000);
        QVERIFY(std::abs(servo.position() - stopped) <= 8);
        QCOMPARE(servo.tell(ReadLoad), std::optional(Bytes{1}));
        QCOMPARE(servo.tell(ReadMove), std::optional(words(750, 2000)));
    }

    void motorModeTurnsUntilSpeedZero_data()
    {
        QTest::addColumn<int>("speed");
        QTest::newRow("forward") << 500;
        QTest::newRow("reverse") << -500;
    }
    void motorModeTurnsUntilSpeedZero()
    {
        QFETCH(int, speed);
        Lx servo;
        const auto motor = [&](int value) {
            servo.tell(WriteMode, {1, 0, std::uint8_t(value), std::uint8_t(value >> 8)});
        };
        servo.load();
        const double before = steps(servo);
        motor(speed);
        servo.run(2000);
        const double turned = steps(servo) - before;
        QVERIFY2(turned * speed > 0 && std::abs(turned) > 500, qPrintable(QString::number(turned)));
        servo.tell(Stop);
        servo.run(500);
        QVERIFY2(std::abs(steps(servo) - before) > std::abs(turned) + 50, "stop is for moves");
        motor(0);
        servo.run(300);
        const double rest = steps(servo);
        servo.run(500);
        QVERIFY(std::abs(steps(servo) - rest) < 1);
    }

    void motorModeNeedsALoadedMotor()
    {
        Lx servo;
        const double before = steps(servo);
        servo.tell(WriteMode, {1, 0, 0xF4, 0x01});
        servo.run(500);
        QVERIFY(std::abs(steps(servo) - before) < 1);
    }

    void movesNeedPositionMode()
    {
        Lx servo;
        servo.load();
        servo.tell(WriteMode, {1, 0, 0, 0});
        const double before = steps(servo);
        servo.move(800);
        servo.run(1000);
        QVERIFY(std::abs(steps(servo) - before) < 2);
        servo.tell(WriteMode, {0, 0, 0, 0});
        servo.run(1000);
        QVERIFY2(std::abs(steps(servo) - before) < 2, "coming back to position mode holds");
    }

    void positionsWrapAroundAFullTurn_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<int>("position");
        QTest::newRow("in range") << 24.0 << 100;
        QTest::newRow("below 0") << -12.0 << -50;
        QTest::newRow("far below 0") << 312.0 << -200;
        QTest::newRow("above 1000") << 264.0 << 1100;
    }
    void positionsWrapAroundAFullTurn()
    {
        QFETCH(double, degrees);
        QFETCH(int, position);
        Lx servo("LX-16A", at(degrees));
        QVERIFY(std::abs(servo.position() - position) <= 1);
    }

    void anOffsetTurnsTheShaftAtOnce()
    {
        Lx servo;
        servo.load();
        servo.move(500);
        servo.run(1000);
        const double before = steps(servo);
        servo.tell(TryOffset, {50});
        servo.run(1000);
        QVERIFY(std::abs(steps(servo) - before - 50) < 5);
        QVERIFY(std::abs(servo.position() - 500) <= 4);
    }

    void heatUnloadsUntilItHasCooled()
    {
        Lx servo;
        servo.load();
        servo.move(800);
        servo.run(1000);
        servo.setTemperature(90);
        servo.run(100);
        servo.move(200);
        servo.run(1000);
        QVERIFY2(std::abs(servo.position() - 800) <= 5, "no torque while it is too hot");
        servo.setTemperature(60);
        servo.run(1500);
        QVERIFY2(std::abs(servo.position() - 200) <= 5, "resumes by itself");
    }

    void voltageOutsideItsLimitsUnloads_data()
    {
        QTest::addColumn<double>("volts");
        QTest::addColumn<bool>("moves");
        QTest::newRow("too low") << 6.2 << false;
        QTest::newRow("too high") << 12.5 << false;
        QTest::newRow("right") << 7.4 << true;
    }
    void voltageOutsideItsLimitsUnloads()
    {
        QFETCH(double, volts);
        QFETCH(bool, moves);
        Lx servo;
        servo.load();
        servo.run(200);
        servo.environment().supplyVolts = volts;
        servo.run(500);
        servo.move(700);
        servo.run(1500);
        QCOMPARE(std::abs(servo.position() - 700) <= 10, moves);
    }

    void highVoltageModelsTakeTheirSupply()
    {
        Lx servo("LX-224HV");
        QCOMPARE(servo.tell(ReadVolts), std::optional(words(6500, 14000)));
        servo.load();
        servo.move(700);
        servo.run(1500);
        QVERIFY(std::abs(servo.position() - 700) <= 5);
    }

    void theLedShowsFaults_data()
    {
        QTest::addColumn<int>("led");
        QTest::addColumn<int>("mask");
        QTest::addColumn<bool>("hot");
        QTest::addColumn<bool>("everOn");
        QTest::addColumn<bool>("everOff");
        QTest::newRow("0 is on") << 0 << 7 << false << true << false;
        QTest::newRow("1 is off") << 1 << 7 << false << false << true;
        QTest::newRow("blinks whatever the LED is") << 1 << 1 << true << true << true;
        QTest::newRow("another fault's bit") << 1 << 6 << true << false << true;
    }
    void theLedShowsFaults()
    {
        QFETCH(int, led);
        QFETCH(int, mask);
        QFETCH(bool, hot);
        QFETCH(bool, everOn);
        QFETCH(bool, everOff);
        Lx servo;
        servo.tell(WriteLed, {std::uint8_t(led)});
        servo.tell(WriteMask, {std::uint8_t(mask)});
        servo.setTemperature(hot ? 95 : 25);
        servo.run(100);
        bool on = false;
        bool off = false;
        servo.run(1000, [&] { (servo.ledOn() ? on : off) = true; });
        QCOMPARE(on, everOn);
        QCOMPARE(off, everOff);
    }

    void aStallBlinksButKeepsTorque()
    {
        sim::ServoConfig config = at(120);
        config.load.stopHigh = 2.3;
        Lx servo("LX-16A", config);
        servo.tell(WriteLed, {1});
        servo.tell(WriteMask, {4});
        servo.load();
        servo.move(900);
        servo.run(3000);
        bool on = false;
        servo.run(1000, [&] { on = on || servo.ledOn(); });
        QVERIFY(on);
        QCOMPARE(servo.tell(ReadLoad), std::optional(Bytes{1}));
    }

    void theImageRestoresPersistentValues()
    {
        Lx servo;
        servo.tell(WriteId, {42});
        servo.tell(TryOffset, {0xE2});
        servo.tell(SaveOffset);
        Lx again;
        QVERIFY(again.setEpromImage(servo.epromImage()));
        QCOMPARE(again.id(), 42);
        QCOMPARE(again.tell(ReadOffset), std::optional(Bytes{0xE2}));
        QVERIFY(!again.setEpromImage(fixture::Servo(QStringLiteral("STS3215")).epromImage()));
    }
};

SERVODESK_GUILESS_TEST(TestLxServo)
#include "tst_lx_servo.moc"

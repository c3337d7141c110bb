// SPDX-License-Identifier: GPL-3.0-or-later
// Who answers what, and what the instructions do.
#include "support/test_main.h"
#include "unit/sim/servo_fixture.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

using fixture::Servo;

class TestServoRequests : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void answers_data();
    void answers();
    void malformedIsNotAnswered_data();
    void malformedIsNotAnswered();
    void readReturnsTheTable();
    void errorByteIsTheLiveStatus();
    void newIdTakesEffectAtOnce_data();
    void newIdTakesEffectAtOnce();
    void newRateTakesEffectAtOnceOrAfterRestart_data();
    void newRateTakesEffectAtOnceOrAfterRestart();
    void ratesByCode_data();
    void ratesByCode();
    void refusesInvalidIdentity_data();
    void refusesInvalidIdentity();
    void broadcastPingInTurn();
    void rebootIsSilentAndReloads();
    void storedWriteWaitsForAction();
    void syncWriteExtractsItsOwnPart();
    void syncReadNeedsTheFamily_data();
    void syncReadNeedsTheFamily();
    void replyDelay_data();
    void replyDelay();
    void calibration_data();
    void calibration();
    void olderFirmwareCannotCalibrate();
    void centeringBy128_data();
    void centeringBy128();
    void calibrationPersistsOnlyUnlocked();
    void stateResetClearsTheTurns();
    void poweredOffReceivesNothing();
    void broadcastIdWriteRenumbers();
    void noRequestCrashes_data();
    void noRequestCrashes();
};

void TestServoRequests::init()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
}

void TestServoRequests::answers_data()
{
    QTest::addColumn<int>("instruction");
    QTest::addColumn<base::Bytes>("params");
    QTest::addColumn<bool>("level1");
    QTest::addColumn<bool>("level0");
    QTest::addColumn<bool>("broadcast");
    const auto row = [](const char* name, int code, base::Bytes params, bool one, bool zero,
                        bool broadcast) {
        QTest::newRow(name) << code << params << one << zero << broadcast;
    };
    row("ping", 0x01, {}, true, true, true);
    row("read", 0x02, {56, 2}, true, true, false);
    row("write", 0x03, {41, 10}, true, false, false);
    row("reg write", 0x04, {41, 10}, true, false, false);
    row("action", 0x05, {}, true, false, false);
    row("restore", 0x06, {}, true, false, false);
    row("back-up", 0x09, {}, true, false, false);
    row("state reset", 0x0A, {}, true, false, false);
    row("calibration", 0x0B, {}, true, false, false);
    row("calibration to a value", 0x0B, {0, 4}, true, false, false);
    row("reboot", 0x08, {}, false, false, false);
    row("PWM firmware entry, unknown here", 0x0D, {}, false, false, false);
    row("unknown", 0x55, {1, 2}, false, false, false);
}

void TestServoRequests::answers()
{
    QFETCH(int, instruction);
    QFETCH(base::Bytes, params);
    QFETCH(bool, level1);
    QFETCH(bool, level0);
    QFETCH(bool, broadcast);
    const auto answered = [&](int level, bool toAll) {
        Servo servo(QStringLiteral("STS3215"));
        servo.set("response_level", level);
        const auto answer = servo.handle({toAll, std::uint8_t(instruction), params, -1});
        return answer.has_value();
    };
    QCOMPARE(answered(1, false), level1);
    QCOMPARE(answered(0, false), level0);
    QCOMPARE(answered(1, true), broadcast);
}

void TestServoRequests::malformedIsNotAnswered_data()
{
    QTest::addColumn<int>("instruction");
    QTest::addColumn<base::Bytes>("params");
    QTest::newRow("ping with a parameter") << 0x01 << base::Bytes{1};
    QTest::newRow("read without count") << 0x02 << base::Bytes{56};
    QTest::newRow("read with too much") << 0x02 << base::Bytes{56, 2, 0};
    QTest::newRow("read past the table") << 0x02 << base::Bytes{250, 20};
    QTest::newRow("read longer than a packet") << 0x02 << base::Bytes{0, 254};
    QTest::newRow("write without data") << 0x03 << base::Bytes{41};
    QTest::newRow("write of nothing") << 0x03 << base::Bytes{};
    QTest::newRow("reg write without data") << 0x04 << base::Bytes{41};
    QTest::newRow("action with a parameter") << 0x05 << base::Bytes{1};
    QTest::newRow("calibration with one byte") << 0x0B << base::Bytes{1};
    QTest::newRow("reboot with a parameter") << 0x08 << base::Bytes{1};
}

void TestServoRequests::malformedIsNotAnswered()
{
    QFETCH(int, instruction);
    QFETCH(base::Bytes, params);
    Servo servo(QStringLiteral("STS3215"));
    const base::Bytes before = servo.read(0, 86);
    QVERIFY(!servo.handle({false, std::uint8_t(instruction), params, -1}));
    QVERIFY(!servo.isDeaf());
    QCOMPARE(servo.read(0, 86), before);
}

void TestServoRequests::readReturnsTheTable()
{
    // Worked frame of the vendor: READ 56, 2 of a servo at 1304 → 18 05.
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.initialDegrees = 1304 * 360.0 / 4096;
    Servo servo(QStringLiteral("STS3215"), config);
    const auto answer = servo.ask(0x02, {56, 2});
    QVERIFY(answer);
    QCOMPARE(answer->id, 1);
    QCOMPARE(int(answer->status), 0);
    QCOMPARE(answer->data, (base::Bytes{0x18, 0x05}));
}

void TestServoRequests::errorByteIsTheLiveStatus()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.environment().supplyVolts = 9.5; // register 14: 8.0 V
    servo.run(200);
    QCOMPARE(int(servo.ask(0x01)->status), 1);
    QCOMPARE(servo.at("servo_status"), 1);
    servo.injectStatus(2);
    QCOMPARE(int(servo.write({41, 0})->status), 3);
    servo.environment().supplyVolts = 7.4;
    servo.run(200);
    QCOMPARE(int(servo.ask(0x01)->status), 2);
    servo.powerCycle();
    QCOMPARE(int(servo.ask(0x01)->status), 0);
}

void TestServoRequests::newIdTakesEffectAtOnce_data()
{
    QTest::addColumn<bool>("answersNew");
    QTest::addColumn<int>("answerId");
    QTest::newRow("acknowledged with the old ID, as LeRobot expects") << false << 1;
    QTest::newRow("acknowledged with the new ID") << true << 5;
}

void TestServoRequests::newIdTakesEffectAtOnce()
{
    QFETCH(bool, answersNew);
    QFETCH(int, answerId);
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.behavior.acknowledgesWithNewId = answersNew;
    Servo servo(QStringLiteral("STS3215"), config);
    const auto answer = servo.write({5, 5});
    QVERIFY(answer);
    QCOMPARE(answer->id, answerId);
    QCOMPARE(servo.id(), 5);
    QCOMPARE(servo.ask(0x01)->id, 5);
    servo.powerCycle(); // it was written behind the lock
    QCOMPARE(servo.id(), 1);
}

void TestServoRequests::newRateTakesEffectAtOnceOrAfterRestart_data()
{
    QTest::addColumn<bool>("afterRestart");
    QTest::newRow("at once") << false;
    QTest::newRow("after a restart") << true;
}

void TestServoRequests::newRateTakesEffectAtOnceOrAfterRestart()
{
    QFETCH(bool, afterRestart);
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.behavior.baudAfterRestart = afterRestart;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.keep("baud_rate", 4);
    QCOMPARE(servo.baud(), afterRestart ? 1000000 : 115200);
    servo.powerCycle();
    QCOMPARE(servo.baud(), 115200);
}

void TestServoRequests::ratesByCode_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("baud");
    const int rates[] = {1000000, 500000, 250000, 128000, 115200, 76800,
                         57600,   38400,  19200,  14400,  9600,   4800};
    for (int code = 0; code < 12; ++code) {
        QTest::addRow("%d", code) << code << rates[code];
    }
    QTest::newRow("no such code: stays") << 12 << 115200;
    QTest::newRow("the largest byte: stays") << 255 << 115200;
}

void TestServoRequests::ratesByCode()
{
    QFETCH(int, code);
    QFETCH(int, baud);
    Servo servo(QStringLiteral("SM40BLHV"));
    QVERIFY(servo.write({6, std::uint8_t(code)}));
    QCOMPARE(servo.baud(), baud);
    QCOMPARE(servo.at("baud_rate"), code < 12 ? code : 4);
}

void TestServoRequests::refusesInvalidIdentity_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("value");
    QTest::addColumn<bool>("taken");
    const auto row = [](const char* name, const char* model, int address, int value, bool taken) {
        QTest::newRow(name) << QString::fromLatin1(model) << address << value << taken;
    };
    row("ID 253", "STS3215", 5, 253, true);
    row("ID 254, the broadcast address", "STS3215", 5, 254, false);
    row("ID 255, the header byte", "STS3215", 5, 255, false);
    row("ID 254 of SCS", "SCS15", 5, 254, false);
    row("STS rate 7", "STS3215", 6, 7, true);
    row("STS rate 8, of SMS only", "STS3215", 6, 8, false);
    row("mode 3", "STS3215", 33, 3, true);
    row("mode 4, of HLS only", "STS3215", 33, 4, false);
    row("mode 77", "STS3215", 33, 77, false);
}

void TestServoRequests::refusesInvalidIdentity()
{
    QFETCH(QString, model);
    QFETCH(int, address);
    QFETCH(int, value);
    QFETCH(bool, taken);
    const auto present = [&](Servo& servo) { return int(servo.read(std::uint8_t(address), 1)[0]); };
    Servo servo(model);
    const int before = present(servo);
    const auto answer = servo.write({std::uint8_t(address), std::uint8_t(value)});
    QVERIFY(answer); // there is no error bit for "rejected"
    QCOMPARE(int(answer->status), 0);
    QCOMPARE(present(servo), taken ? value : before);
    QCOMPARE(servo.id(), address == 5 && taken ? value : 1);

    // Held, and carried out later.
    Servo other(model);
    QVERIFY(other.ask(0x04, {std::uint8_t(address), std::uint8_t(value)}));
    QVERIFY(other.ask(0x05));
    QCOMPARE(present(other), taken ? value : before);
}

void TestServoRequests::broadcastPingInTurn()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.id = 5;
    Servo servo(QStringLiteral("STS3215"), config);
    QCOMPARE(servo.sendBroadcast(0x01)->wait, base::Duration());
    servo.behavior().staggersBroadcastPing = true;
    QCOMPARE(servo.sendBroadcast(0x01)->wait, base::Duration(15'000)); // 3 ms for each ID
    QCOMPARE(servo.ask(0x01)->wait, base::Duration());
}

void TestServoRequests::rebootIsSilentAndReloads()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.rebootTime = fixture::milliseconds(0); // even the quickest one is a restart
    Servo quick(QStringLiteral("STS3215"), config);
    quick.write({41, 20});
    QVERIFY(!quick.ask(0x08));
    quick.run(1);
    QCOMPARE(quick.read(41, 1), base::Bytes{0});

    config.rebootTime = fixture::milliseconds(800);
    Servo servo(QStringLiteral("STS3215"), config);
    servo.write({13, 61});
    servo.write({41, 20, 0x00, 0x0C});
    QVERIFY(!servo.ask(0x08));
    servo.run(700);
    QVERIFY(servo.isDeaf());
    QVERIFY(!servo.ask(0x01));
    servo.run(150);
    QVERIFY(servo.ask(0x01));
    QCOMPARE(servo.at("max_temperature"), 70);
    QCOMPARE(servo.at("acceleration"), 0);
    QCOMPARE(servo.at("torque_switch"), 0);
}

void TestServoRequests::storedWriteWaitsForAction()
{
    Servo servo(QStringLiteral("STS3215"));
    QVERIFY(servo.ask(0x04, {42, 0x00, 0x09}));
    QCOMPARE(servo.at("async_write_flag"), 1);
    servo.run(50);
    QCOMPARE(servo.at("goal_position"), 0);
    QCOMPARE(servo.at("torque_switch"), 0);
    servo.sendBroadcast(0x05);
    QCOMPARE(servo.at("goal_position"), 0x900);
    QCOMPARE(servo.at("torque_switch"), 1);
    QCOMPARE(servo.at("async_write_flag"), 0);
    servo.ask(0x04, {42, 0x00, 0x0A});
    servo.powerCycle();
    QCOMPARE(servo.at("async_write_flag"), 0);
    servo.ask(0x05);
    QCOMPARE(servo.at("goal_position"), 0);
}

void TestServoRequests::syncWriteExtractsItsOwnPart()
{
    // Worked frame: position 2048, time 0, speed 1000 for IDs 1 to 4.
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.id = 3;
    Servo servo(QStringLiteral("STS3215"), config);
    const base::Bytes params{42, 6, 1, 0, 1, 0, 0,    0xE8, 3, 2, 0, 2, 0, 0,    0xE8,
                             3,  3, 0, 8, 0, 0, 0xE8, 3,    4, 0, 4, 0, 0, 0xE8, 3};
    QVERIFY(!servo.handle({true, 0x83, params, -1}));
    QCOMPARE(servo.at("goal_position"), 2048);
    QCOMPARE(servo.at("goal_speed"), 1000);

    QVERIFY(!servo.sendBroadcast(0x83, {42, 2, 9, 0, 1})); // for another servo
    QVERIFY(!servo.sendBroadcast(0x83, {42, 2, 3, 0}));    // cut short
    QVERIFY(!servo.sendBroadcast(0x83, {42, 0, 3}));
    QCOMPARE(servo.at("goal_position"), 2048);
}

void TestServoRequests::syncReadNeedsTheFamily_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<bool>("answers");
    QTest::newRow("STS") << QStringLiteral("STS3215") << true;
    QTest::newRow("SCS does not know it") << QStringLiteral("SCS15") << false;
}

void TestServoRequests::syncReadNeedsTheFamily()
{
    QFETCH(QString, model);
    QFETCH(bool, answers);
    Servo servo(model);
    const auto answer = servo.handle({true, 0x82, {56, 8, 2, 1}, 1});
    QCOMPARE(answer.has_value(), answers);
    if (answers) {
        QCOMPARE(answer->id, 1);
        QCOMPARE(answer->data.size(), std::size_t(8));
    }
}

void TestServoRequests::replyDelay_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("raw");
    QTest::addColumn<int>("least");
    QTest::addColumn<int>("most");
    QTest::newRow("SMS 250 = 500 us") << QStringLiteral("SM40BLHV") << 250 << 500 << 500;
    QTest::newRow("SMS 254 = 508 us") << QStringLiteral("SM40BLHV") << 254 << 508 << 508;
    QTest::newRow("SMS 50 = 100 us") << QStringLiteral("SM40BLHV") << 50 << 100 << 100;
    QTest::newRow("SMS 1 acts like 50") << QStringLiteral("SM40BLHV") << 1 << 100 << 100;
    QTest::newRow("SMS 0 is the shortest") << QStringLiteral("SM40BLHV") << 0 << 20 << 50;
    QTest::newRow("STS has no delay") << QStringLiteral("STS3215") << 250 << 20 << 50;
}

void TestServoRequests::replyDelay()
{
    QFETCH(QString, model);
    QFETCH(int, raw);
    QFETCH(int, least);
    QFETCH(int, most);
    auto config = fixture::configOf(model);
    config.returnDelayRaw = raw;
    const Servo servo(model, config);
    QVERIFY(servo.replyDelay().count() >= least);
    QVERIFY(servo.replyDelay().count() <= most);
}

void TestServoRequests::calibration_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<base::Bytes>("params");
    QTest::addColumn<bool>("answered");
    QTest::addColumn<int>("position");
    QTest::newRow("STS to the middle")
        << QStringLiteral("STS3215") << base::Bytes{} << true << 2048;
    // Worked frame: 0x0B to 1024.
    QTest::newRow("STS to 1024") << QStringLiteral("STS3215") << base::Bytes{0, 4} << true << 1024;
    QTest::newRow("SMS does not know it")
        << QStringLiteral("SM40BLHV") << base::Bytes{} << false << 700;
    QTest::newRow("SCS does not know it")
        << QStringLiteral("SCS15") << base::Bytes{} << false << 700;
}

void TestServoRequests::calibration()
{
    QFETCH(QString, model);
    QFETCH(base::Bytes, params);
    QFETCH(bool, answered);
    QFETCH(int, position);
    auto config = fixture::configOf(model);
    const double step = model.startsWith(QLatin1String("SCS")) ? 220.0 / 1024 : 360.0 / 4096;
    config.initialDegrees = 700 * step;
    Servo servo(model, config);
    QCOMPARE(servo.handle({false, 0x0B, params, -1}).has_value(), answered);
    servo.run(10);
    QVERIFY(std::abs(servo.at("present_position") - position) <= 1);
}

void TestServoRequests::olderFirmwareCannotCalibrate()
{
    const catalog::ModelEntry* model = fixture::models().model(QStringLiteral("STS3215"));
    sim::VirtualServo servo(fixture::models().profileFor(*model, 3, 9), {});
    QVERIFY(!servo.handle({false, 0x0B, {}, -1}));
    QVERIFY(servo.handle({false, 0x01, {}, -1}));
}

void TestServoRequests::centeringBy128_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("centers");
    QTest::newRow("STS") << QStringLiteral("STS3215") << 12 << true;
    QTest::newRow("STS, reversed") << QStringLiteral("STS3215") << 12 + 128 + 1 << true;
    QTest::newRow("SMS") << QStringLiteral("SM40BLHV") << 44 << true;
    QTest::newRow("SCS has none") << QStringLiteral("SCS15") << 8 << false;
}

void TestServoRequests::centeringBy128()
{
    QFETCH(QString, model);
    QFETCH(int, phase);
    QFETCH(bool, centers);
    auto config = fixture::configOf(model);
    config.initialDegrees = 100; // step 1138 of 4096
    Servo servo(model, config);
    servo.set("phase", phase);
    const int before = servo.at("present_position");
    QVERIFY(servo.write({40, 128}));
    servo.run(10);
    QCOMPARE(servo.at("torque_switch"), 0);
    QVERIFY(std::abs(servo.at("present_position") - (centers ? 2048 : before)) <= 1);
    QVERIFY(std::abs(servo.shaftDegrees() - 100) < 0.2); // nothing turned
    if (centers) {
        // present = sensor − offset
        QVERIFY(std::abs(servo.at("position_offset") - (before - 2048)) <= 1);
    }
}

void TestServoRequests::calibrationPersistsOnlyUnlocked()
{
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.initialDegrees = 100;
    config.behavior.deafWhileWriting = true;
    Servo servo(QStringLiteral("STS3215"), config);
    servo.write({40, 128});
    QVERIFY(!servo.isDeaf());
    servo.powerCycle();
    QCOMPARE(servo.at("position_offset"), 0);
    servo.write({55, 0});
    servo.write({40, 128});
    QVERIFY(servo.isDeaf());
    servo.powerCycle();
    QVERIFY(std::abs(servo.at("present_position") - 2048) <= 1);
}

void TestServoRequests::stateResetClearsTheTurns()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.set("phase", 12 + 16);
    servo.write({9, 0, 0, 0, 0});
    servo.set("goal_position", 9000);
    servo.run(4000);
    servo.write({40, 0});
    servo.run(10);
    QVERIFY(std::abs(servo.at("present_position") - 9000) <= 8);
    QVERIFY(servo.ask(0x0A));
    QVERIFY(std::abs(servo.at("present_position") - 9000 % 4096) <= 8);
}

void TestServoRequests::poweredOffReceivesNothing()
{
    Servo servo(QStringLiteral("STS3215"));
    servo.powerOff();
    QVERIFY(!servo.powered());
    QVERIFY(servo.isDeaf());
    QVERIFY(!servo.ask(0x01));
    QVERIFY(!servo.write({13, 50}));
    servo.powerOn();
    QVERIFY(servo.ask(0x01));
    QCOMPARE(servo.at("max_temperature"), 70);
}

void TestServoRequests::broadcastIdWriteRenumbers()
{
    // Worked frame: broadcast write ID = 1.
    auto config = fixture::configOf(QStringLiteral("STS3215"));
    config.id = 44;
    Servo servo(QStringLiteral("STS3215"), config);
    QVERIFY(!servo.sendBroadcast(0x03, {5, 1}));
    QCOMPARE(servo.id(), 1);
}

void TestServoRequests::noRequestCrashes_data()
{
    QTest::addColumn<QString>("model");
    for (const char* model : {"STS3215", "SM40BLHV", "SCS15"}) {
        QTest::newRow(model) << QString::fromLatin1(model);
    }
}

void TestServoRequests::noRequestCrashes()
{
    QFETCH(QString, model);
    Servo servo(model);
    std::mt19937 random(4711);
    const auto byte = [&] { return std::uint8_t(random()); };
    constexpr std::uint8_t codes[] = {0x01, 0x02, 0x03, 0x03, 0x03, 0x04, 0x05, 0x06,
                                      0x09, 0x0A, 0x0B, 0x82, 0x83, 0x08, 0xFF};
    for (int i = 0; i < 20000; ++i) {
        sim::ServoRequest request{
            byte() < 20, codes[random() % std::size(codes)], {}, int(byte() % 3) - 1};
        request.params.resize(random() % 12);
        std::generate(request.params.begin(), request.params.end(), byte);
        if (!request.params.empty()) {
            request.params[0] %= 70; // mostly where registers are
        }
        const bool deaf = servo.isDeaf();
        const auto answer = servo.handle(request);
        QVERIFY(!(deaf && answer));
        servo.run(int(random() % 3));
        QVERIFY(std::isfinite(servo.shaftDegrees()));
    }
    // After a power cycle with its identity written, it works as a new one.
    servo.powerOff();
    servo.powerOn();
    QCOMPARE(servo.ask(0x01).has_value(), true);
    QCOMPARE(servo.read(3, 2), Servo(model).read(3, 2));
    QCOMPARE(servo.at("lock"), 1);
}

SERVODESK_GUILESS_TEST(TestServoRequests)
#include "tst_servo_requests.moc"

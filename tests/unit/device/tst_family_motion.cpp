// SPDX-License-Identifier: GPL-3.0-or-later
// Torque, modes, moves and halts in every family: nothing moves by surprise, and what a family
// lacks is refused before the wire.
#include "device/motion/motion.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QTest>

#include "fake_bus.h"

using base::ErrorCode;
using catalog::Role;
using device::MoveCommand;
using device::MoveMethod;
using device::NoticeCode;
using device::Torque;
using fake::DeviceFixture;
using protocol::Op;
using support::utf8;
using namespace std::chrono_literals;

namespace {
/// The requests besides reads: "W16:F4 01 00 00" = write at offset 16; H halt, A action.
QStringList requests(const DeviceFixture& fixture)
{
    QStringList words;
    for (const protocol::Request& request : fixture.bus.requests) {
        if (request.op == Op::Write)
            words << QStringLiteral("W%1:%2").arg(request.address).arg(base::toHex(request.data));
        else if (request.op == Op::SyncWrite)
            words << QStringLiteral("S%1x%2").arg(request.address).arg(request.targets.size());
        else if (request.op == Op::Halt)
            words << utf8("H");
        else if (request.op == Op::Action)
            words << QStringLiteral("A%1").arg(request.id);
        else if (request.op == Op::RegWrite)
            words << QStringLiteral("R%1").arg(request.address);
    }
    return words;
}

MoveCommand order(device::Servo& servo, const char* goal)
{
    return {&servo, utf8(goal)};
}

base::Result<std::vector<device::MovePlan>> planned(DeviceFixture& fixture,
                                                    const std::vector<MoveCommand>& orders)
{
    std::vector<device::MovePlan> plans;
    for (const MoveCommand& one : orders) {
        auto plan = device::planMove(fixture.context(), one);
        if (!plan)
            return tl::unexpected(plan.error());
        plans.push_back(*plan);
    }
    fixture.bus.requests.clear();
    return plans;
}

base::Result<void> moved(DeviceFixture& fixture, const std::vector<MoveCommand>& orders,
                         MoveMethod how = MoveMethod::Write)
{
    auto plans = planned(fixture, orders);
    if (!plans)
        return tl::unexpected(plans.error());
    return device::sendMoves(fixture.context(), *plans, how);
}
} // namespace

class TestFamilyMotion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void torqueOnHolds_data();
    void torqueOnHolds();
    void torqueOnOutsideTheScaleIsRefused();
    void torqueOnInMotorModeDoesNotMove();
    void anEmergencyEndsTorqueOn_data();
    void anEmergencyEndsTorqueOn();
    void noDampingWhereThereIsNone_data();
    void noDampingWhereThereIsNone();
    void missingCurrentIsReported();
    void currentIsRestored_data();
    void currentIsRestored();
    void currentIsRestoredAfterAnInterruptedSwitch();
    void speedIsAlwaysRestored();
    void staleReadingsAreNoAlarm();
    void modbusModesTakeEffect();
    void refusedTorqueOffIsReported();
    void lxModeSwitchesDoNotMove();
    void framesOfAMove_data();
    void framesOfAMove();
    void aMoveSwitchesTorqueOnFirst();
    void motorSpeeds_data();
    void motorSpeeds();
    void refusedMoves_data();
    void refusedMoves();
    void storedMovesStartTogether();
    void oneStoredMoveStartsAlone();
    void aCanceledMoveIsCleared();
    void aTornStoredMoveIsStoredAgain();
    void syncMoveOnlyWhereSupported();
    void familiesMoveTogether();
    void lostGoalsAreWrittenAgain();
    void haltEndsTheMotion_data();
    void haltEndsTheMotion();
    void aMovingShaftIsHeld();
    void haltOfAnUnloadedServoSendsNothing();
    void haltInStepModeReleasesTorque();
    void arrivalWithoutAFlag_data();
    void arrivalWithoutAFlag();
    void cancelingTheWaitReportsPendingMoves();
};

void TestFamilyMotion::torqueOnHolds_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("stands");
    QTest::addColumn<QStringList>("frames");
    QTest::newRow("HLS") << "HLS" << 1000 << QStringList{utf8("W42:E8 03")};
    QTest::newRow("SMCL") << "SMCL" << 1000 << QStringList{utf8("W42:E8 03")};
    QTest::newRow("SCS-2") << "SCS2" << 512 << QStringList{utf8("W42:02 00")};
    QTest::newRow("Modbus") << "SMSMB" << 1000 << QStringList{utf8("W256:03 E8")};
    // Before, and again when it is loaded and listens.
    QTest::newRow("LX") << "LX" << 500
                        << QStringList{utf8("W8:F4 01 00 00"), utf8("W248:01"),
                                       utf8("W8:F4 01 00 00")};
    QTest::newRow("LX, just below its scale")
        << "LX" << -3
        << QStringList{utf8("W8:00 00 00 00"), utf8("W248:01"), utf8("W8:00 00 00 00")};
}

void TestFamilyMotion::torqueOnHolds()
{
    QFETCH(QString, family);
    QFETCH(int, stands);
    QFETCH(QStringList, frames);
    DeviceFixture fixture(family);
    const catalog::Register& position = *fixture.fake().profile->byRole(Role::PresentPosition);
    fixture.fake().poke(position.key, stands);
    device::Servo servo = fixture.servo();
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::On));
    QCOMPARE(requests(fixture), frames);
    QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(1));
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 1);
    fixture.bus.requests.clear();
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::Off));
    QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(0));
}

void TestFamilyMotion::torqueOnOutsideTheScaleIsRefused()
{
    for (const int stands : {-11, 1011}) {
        DeviceFixture fixture(utf8("LX"));
        fixture.fake().poke(utf8("position"), stands);
        device::Servo servo = fixture.servo();
        const auto on = device::setTorque(fixture.context(), servo, Torque::On);
        QVERIFY(!on);
        QCOMPARE(on.error().code, ErrorCode::OutOfRange);
        QCOMPARE(fixture.bus.writes(), 0);
        // A goal inside leads it back, or it could be turned by hand only.
        QVERIFY(moved(fixture, {order(servo, "500")}));
        QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(1));
        QCOMPARE(fixture.fake().raw(Role::GoalPosition), std::int64_t(500));
        QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 0);
    }
}

void TestFamilyMotion::torqueOnInMotorModeDoesNotMove()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("mode"), 1);
    fixture.fake().poke(utf8("motor_speed"), 700);
    device::Servo servo = fixture.servo();
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::On));
    QCOMPARE(requests(fixture),
             (QStringList{utf8("W232:01 00 00 00"), utf8("W248:01"), utf8("W232:01 00 00 00")}));
}

void TestFamilyMotion::anEmergencyEndsTorqueOn_data()
{
    QTest::addColumn<QString>("family");
    for (const char* family : {"STS", "HLS", "SMCL", "SMSMB", "LX"})
        QTest::newRow(family) << family;
}

/// Whichever request the emergency stop meets, nothing afterwards switches torque on again.
void TestFamilyMotion::anEmergencyEndsTorqueOn()
{
    QFETCH(QString, family);
    for (int passed = 0;; ++passed) {
        DeviceFixture fixture(family);
        fixture.fake().goalEnergizes = false;
        fixture.fake().poke(fixture.fake().profile->byRole(Role::PresentPosition)->key, 500);
        device::Servo servo = fixture.servo();
        int left = passed;
        bool met = false;
        fixture.bus.onRequest = [&](const protocol::Request&) {
            fixture.bus.emergencyPending = !met && left-- == 0;
            met |= fixture.bus.emergencyPending;
        };
        const auto on = device::setTorque(fixture.context(), servo, Torque::On);
        if (!met)
            break;
        QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(0));
        // Evidence about alarms is read after the work is done.
        if (!on)
            QCOMPARE(base::errorName(on.error().code), base::errorName(ErrorCode::Preempted));
    }
}

void TestFamilyMotion::noDampingWhereThereIsNone_data()
{
    QTest::addColumn<QString>("family");
    for (const char* family : {"SMCL", "SMSMB", "LX"})
        QTest::newRow(family) << family;
}

void TestFamilyMotion::noDampingWhereThereIsNone()
{
    QFETCH(QString, family);
    DeviceFixture fixture(family);
    device::Servo servo = fixture.servo();
    const auto damped = device::setTorque(fixture.context(), servo, Torque::Damp);
    QVERIFY(!damped);
    QCOMPARE(damped.error().code, ErrorCode::NotSupported);
    QCOMPARE(damped.error().detail, utf8("damp"));
    QVERIFY(fixture.bus.requests.empty());
}

/// HLS 44 at 0 is no torque at all; and no move ever writes there.
void TestFamilyMotion::missingCurrentIsReported()
{
    DeviceFixture fixture(utf8("HLS"));
    fixture.fake().poke(utf8("goal_current"), 0);
    device::Servo servo = fixture.servo();
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::On));
    QCOMPARE(fixture.noticeCount(NoticeCode::CurrentLimitZero), 1);
    fixture.notices.clear();
    MoveCommand fast = order(servo, "2000");
    fast.speed = utf8("100");
    fast.acceleration = utf8("50");
    for (const MoveMethod how : {MoveMethod::Write, MoveMethod::Sync, MoveMethod::Async})
        QVERIFY(moved(fixture, {fast}, how));
    QCOMPARE(fixture.noticeCount(NoticeCode::CurrentLimitZero), 3);
    fixture.fake().poke(utf8("goal_current"), 500);
    fixture.notices.clear();
    QVERIFY(moved(fixture, {fast}));
    QCOMPARE(fixture.noticeCount(NoticeCode::CurrentLimitZero), 0);
    QCOMPARE(fixture.fake().raw(utf8("goal_current")), std::int64_t(500));
    QCOMPARE(requests(fixture), (QStringList{utf8("W46:64 00"), utf8("W41:32 D0 07")}));
}

void TestFamilyMotion::currentIsRestored_data()
{
    QTest::addColumn<QString>("through");
    QTest::addColumn<QString>("to");
    QTest::newRow("current and back") << "current"
                                      << "position";
    QTest::newRow("PWM and back") << "pwm"
                                  << "position";
    QTest::newRow("current to speed") << "current"
                                      << "speed";
}

void TestFamilyMotion::currentIsRestored()
{
    QFETCH(QString, through);
    QFETCH(QString, to);
    DeviceFixture fixture(utf8("HLS"));
    fixture.fake().setPersistent(utf8("protection_current"), 400);
    fixture.fake().poke(utf8("goal_current"), 400);
    device::Servo servo = fixture.servo();
    const auto there = device::switchMode(fixture.context(), servo, through);
    QVERIFY(there && there->isSuccessful());
    QCOMPARE(fixture.fake().raw(utf8("goal_current")), std::int64_t(0)); // nothing pushes
    QCOMPARE(fixture.noticeCount(NoticeCode::CommandZeroed), 1);
    fixture.notices.clear();
    const auto back = device::switchMode(fixture.context(), servo, to);
    QVERIFY(back && back->isSuccessful());
    QCOMPARE(fixture.fake().raw(utf8("goal_current")), std::int64_t(400));
    QCOMPARE(fixture.noticeCount(NoticeCode::CurrentRestored), 1);
    QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(0));
}

void TestFamilyMotion::currentIsRestoredAfterAnInterruptedSwitch()
{
    DeviceFixture fixture(utf8("HLS"));
    fixture.fake().setPersistent(utf8("protection_current"), 400);
    fixture.fake().poke(utf8("goal_current"), 0);
    device::Servo servo = fixture.servo();
    QVERIFY(device::torqueOffAndZero(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("goal_current")), std::int64_t(400));
    QCOMPARE(fixture.noticeCount(NoticeCode::CurrentRestored), 1);
}

/// Also when another mode lay between the one that zeroed it and the position mode.
void TestFamilyMotion::speedIsAlwaysRestored()
{
    DeviceFixture fixture(utf8("HLS"));
    fixture.fake().poke(utf8("goal_speed"), 60);
    device::Servo servo = fixture.servo();
    for (const char* mode : {"speed", "current", "position"}) {
        const auto there = device::switchMode(fixture.context(), servo, utf8(mode));
        QVERIFY(there && there->isSuccessful());
    }
    QCOMPARE(fixture.fake().raw(utf8("goal_speed")), std::int64_t(60));
    QCOMPARE(fixture.noticeCount(NoticeCode::SpeedRestored), 1);
}

void TestFamilyMotion::staleReadingsAreNoAlarm()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("temperature"), 99);
    fixture.fake().poke(utf8("vin"), 7400);
    device::Servo servo = fixture.servo();
    device::addAlarmNotices(fixture.context(), servo);
    QCOMPARE(fixture.noticeCount(NoticeCode::DerivedTemperature), 1);
    fixture.notices.clear();
    fixture.bus.cutAfter = 0;
    device::addAlarmNotices(fixture.context(), servo);
    QVERIFY(fixture.notices.empty());
}

void TestFamilyMotion::modbusModesTakeEffect()
{
    DeviceFixture fixture(utf8("SMSMB"));
    fixture.fake().poke(utf8("goal_speed"), 60);
    fixture.fake().poke(utf8("torque_switch"), 1);
    device::Servo servo = fixture.servo();
    const auto speed = device::switchMode(fixture.context(), servo, utf8("speed"));
    QVERIFY(speed && speed->isSuccessful());
    QCOMPARE(fixture.fake().persistentRaw(utf8("operating_mode")), std::int64_t(1));
    QCOMPARE(fixture.fake().raw(utf8("goal_speed")), std::int64_t(0));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    const auto back = device::switchMode(fixture.context(), servo, utf8("position"));
    QVERIFY(back && back->isSuccessful());
    QCOMPARE(fixture.fake().raw(utf8("goal_speed")), std::int64_t(60));
    const auto turns = device::switchMode(fixture.context(), servo, utf8("multiturn"));
    QVERIFY(turns && turns->isSuccessful());
    QCOMPARE(fixture.fake().raw(utf8("max_angle_limit")), std::int64_t(0));
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("position")));
    QCOMPARE(fixture.fake().raw(utf8("max_angle_limit")), std::int64_t(4095));
}

/// No notice about torque that is still on.
void TestFamilyMotion::refusedTorqueOffIsReported()
{
    DeviceFixture fixture(utf8("SMSMB"));
    fake::Servo& servo = fixture.fake();
    const catalog::Register& torque = *servo.profile->byRole(Role::TorqueSwitch);
    servo.poke(torque.key, 1);
    device::Servo known = fixture.servo();
    servo.exceptions[torque.writeOffset] = 3;
    const auto report = device::switchMode(fixture.context(), known, utf8("speed"));
    QVERIFY(report);
    QVERIFY(!report->isSuccessful());
    QCOMPARE(servo.raw(torque.key), 1);
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueStaysOff), 0);
}

void TestFamilyMotion::lxModeSwitchesDoNotMove()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("load"), 1);
    device::Servo servo = fixture.servo();
    const auto motor = device::switchMode(fixture.context(), servo, utf8("motor"));
    QVERIFY(motor && motor->isSuccessful());
    QCOMPARE(requests(fixture), (QStringList{utf8("W248:00"), utf8("W232:01 00 00 00")}));
    fixture.fake().poke(utf8("motor_speed"), 500);
    fixture.fake().poke(utf8("load"), 1);
    fixture.bus.requests.clear();
    const auto position = device::switchMode(fixture.context(), servo, utf8("position"));
    QVERIFY(position && position->isSuccessful());
    QCOMPARE(requests(fixture), (QStringList{utf8("W248:00"), utf8("W232:00 00 00 00")}));
    QCOMPARE(fixture.openIntents(), std::size_t(0));
    const auto none = device::switchMode(fixture.context(), servo, utf8("step"));
    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::NotSupported);
    QCOMPARE(none.error().detail, utf8("position, motor"));
}

void TestFamilyMotion::framesOfAMove_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("speed");
    QTest::addColumn<QString>("acceleration");
    QTest::addColumn<QString>("time");
    QTest::addColumn<QStringList>("frames");
    const auto row = [](const char* name, const char* family, const char* speed,
                        const char* acceleration, const char* time, QStringList frames) {
        QTest::newRow(name) << family << speed << acceleration << time << frames;
    };
    row("Modbus, one register", "SMSMB", "", "", "", {utf8("W256:01 F4")});
    row("Modbus, neighbours in one", "SMSMB", "50", "10", "",
        {utf8("W260:00 0A 00 32"), utf8("W256:01 F4")});
    row("LX, as fast as it can", "LX", "", "", "", {utf8("W8:F4 01 00 00")});
    row("LX in a second", "LX", "", "", "1000", {utf8("W8:F4 01 E8 03")});
    row("HLS, goal only", "HLS", "", "", "", {utf8("W42:F4 01")});
    row("SMCL with speed", "SMCL", "50", "", "", {utf8("W46:32 00"), utf8("W42:F4 01")});
    row("SCS-2, high byte first", "SCS2", "50", "", "", {utf8("W46:00 32"), utf8("W42:01 F4")});
}

void TestFamilyMotion::framesOfAMove()
{
    QFETCH(QString, family);
    QFETCH(QString, speed);
    QFETCH(QString, acceleration);
    QFETCH(QString, time);
    QFETCH(QStringList, frames);
    DeviceFixture fixture(family);
    fixture.fake().poke(fixture.fake().profile->byRole(Role::TorqueSwitch)->key, 1);
    device::Servo servo = fixture.servo();
    MoveCommand go = order(servo, "500");
    if (!speed.isEmpty())
        go.speed = speed;
    if (!acceleration.isEmpty())
        go.acceleration = acceleration;
    if (!time.isEmpty())
        go.time = time;
    QVERIFY(moved(fixture, {go}));
    QCOMPARE(requests(fixture), frames);
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOn), 0);
}

void TestFamilyMotion::aMoveSwitchesTorqueOnFirst()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("position"), 300);
    device::Servo servo = fixture.servo();
    QVERIFY(moved(fixture, {order(servo, "120deg")}));
    QCOMPARE(requests(fixture), (QStringList{utf8("W8:2C 01 00 00"), utf8("W248:01"),
                                             utf8("W8:2C 01 00 00"), utf8("W8:F4 01 00 00")}));
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOn), 1);
    QCOMPARE(fixture.fake().raw(utf8("load")), std::int64_t(1));
}

void TestFamilyMotion::motorSpeeds_data()
{
    QTest::addColumn<QString>("goal");
    QTest::addColumn<QString>("frame");
    QTest::newRow("forward") << "300"
                             << "W232:01 00 2C 01";
    QTest::newRow("backward") << "-500"
                              << "W232:01 00 0C FE"; // the sheet's worked frame
    QTest::newRow("standstill") << "0"
                                << "W232:01 00 00 00";
}

/// The unit is not documented, so a plain number is all there is.
void TestFamilyMotion::motorSpeeds()
{
    QFETCH(QString, goal);
    QFETCH(QString, frame);
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("mode"), 1);
    fixture.fake().poke(utf8("load"), 1);
    device::Servo servo = fixture.servo();
    QVERIFY(moved(fixture, {{&servo, goal}}));
    QCOMPARE(requests(fixture), QStringList{frame});
}

void TestFamilyMotion::refusedMoves_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("mode");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<QString>("extra"); ///< "speed=50"
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<QString>("detail");
    const auto row = [](const char* name, const char* family, int mode, const char* goal,
                        const char* extra, ErrorCode code, const char* detail) {
        QTest::newRow(name) << family << mode << goal << extra << code << detail;
    };
    row("LX has no speed", "LX", 0, "500", "speed=50", ErrorCode::NotSupported, "speed-by-time");
    row("LX has no acceleration", "LX", 0, "500", "acceleration=5", ErrorCode::NotSupported,
        "acceleration");
    row("LX above its scale", "LX", 0, "1001", "", ErrorCode::OutOfRange, "0…1000, 0.0° … 240.0°");
    row("LX below its scale", "LX", 0, "-1", "", ErrorCode::OutOfRange, "0…1000, 0.0° … 240.0°");
    row("LX time", "LX", 0, "500", "time=30001", ErrorCode::OutOfRange, "0…30000");
    row("LX motor has no time", "LX", 1, "500", "time=100", ErrorCode::NotSupported, "motor");
    row("LX motor speed", "LX", 1, "1001", "", ErrorCode::OutOfRange, "-1000…1000");
    row("Modbus has no time", "SMSMB", 0, "500", "time=100", ErrorCode::NotSupported, "position");
    row("Modbus outside its limits", "SMSMB", 0, "4096", "", ErrorCode::OutOfRange, "0 … 4095");
    row("Modbus speed needs a unit", "SMSMB", 1, "500", "", ErrorCode::BadArgument, "unit rpm");
    row("HLS current needs a unit", "HLS", 2, "500", "", ErrorCode::BadArgument, "unit mA");
    row("SCS-2 above its scale", "SCS2", 0, "1024", "", ErrorCode::OutOfRange, "0…1023");
}

void TestFamilyMotion::refusedMoves()
{
    QFETCH(QString, family);
    QFETCH(int, mode);
    QFETCH(QString, goal);
    QFETCH(QString, extra);
    QFETCH(ErrorCode, code);
    QFETCH(QString, detail);
    DeviceFixture fixture(family);
    if (fixture.fake().has(Role::OperatingMode))
        fixture.fake().poke(fixture.fake().profile->byRole(Role::OperatingMode)->key, mode);
    device::Servo servo = fixture.servo();
    MoveCommand go{&servo, goal};
    const QString value = extra.section(QLatin1Char('='), 1);
    if (extra.startsWith(utf8("speed")))
        go.speed = value;
    else if (extra.startsWith(utf8("acc")))
        go.acceleration = value;
    else if (extra.startsWith(utf8("time")))
        go.time = value;
    const auto plan = device::planMove(fixture.context(), go);
    QVERIFY(!plan);
    QCOMPARE(base::errorName(plan.error().code), base::errorName(code));
    QCOMPARE(plan.error().detail, detail);
    QCOMPARE(fixture.bus.writes(), 0);
}

/// Each is addressed: others on the line may hold a move of another program.
void TestFamilyMotion::storedMovesStartTogether()
{
    for (const bool tells : {true, false}) {
        for (const MoveMethod how : {MoveMethod::Sync, MoveMethod::Async}) {
            DeviceFixture fixture{{"LX", 1}, {"LX", 2}};
            for (fake::Servo& servo : fixture.bus.servos) {
                servo.poke(utf8("load"), 1);
                servo.repliesStoredMove = tells;
            }
            device::Servo first = fixture.servo(0);
            device::Servo second = fixture.servo(1);
            MoveCommand slow = order(second, "1000");
            slow.time = utf8("30000");
            QVERIFY(moved(fixture, {order(first, "500"), slow}, how));
            QCOMPARE(requests(fixture),
                     (QStringList{utf8("W56:F4 01 00 00"), utf8("W56:E8 03 30 75"), utf8("A1"),
                                  utf8("A2"), utf8("A1"), utf8("A2"), utf8("A1"), utf8("A2")}));
        }
    }
}

void TestFamilyMotion::oneStoredMoveStartsAlone()
{
    DeviceFixture fixture{{"LX", 1}, {"LX", 2}};
    fixture.fake(0).poke(utf8("load"), 1);
    device::Servo servo = fixture.servo(0);
    QVERIFY(moved(fixture, {order(servo, "500")}, MoveMethod::Async));
    QCOMPARE(requests(fixture),
             (QStringList{utf8("W56:F4 01 00 00"), utf8("A1"), utf8("A1"), utf8("A1")}));
}

/// An emergency stop before the start: no later start command may find the move.
void TestFamilyMotion::aCanceledMoveIsCleared()
{
    DeviceFixture fixture{{"LX", 1}, {"LX", 2}};
    for (fake::Servo& servo : fixture.bus.servos) {
        servo.poke(utf8("load"), 1);
        servo.poke(utf8("position"), 300);
    }
    device::Servo first = fixture.servo(0);
    device::Servo second = fixture.servo(1);
    auto plans = planned(fixture, {order(first, "500"), order(second, "600")});
    QVERIFY(plans);
    bool met = false;
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        fixture.bus.emergencyPending = !met && request.op == Op::Write && request.id == 2;
        met |= fixture.bus.emergencyPending;
    };
    const auto sent = device::sendMoves(fixture.context(), *plans, MoveMethod::Sync);
    QVERIFY(!sent);
    QCOMPARE(sent.error().code, ErrorCode::Preempted);
    QVERIFY(requests(fixture).filter(utf8("A")).isEmpty());
    for (const fake::Servo& servo : fixture.bus.servos)
        QCOMPARE(servo.raw(utf8("wait_angle")), std::int64_t(300));
}

void TestFamilyMotion::aTornStoredMoveIsStoredAgain()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("load"), 1);
    device::Servo servo = fixture.servo();
    auto plans = planned(fixture, {order(servo, "500")});
    QVERIFY(plans);
    fixture.bus.lostWrites = 1;
    QVERIFY(device::sendMoves(fixture.context(), *plans, MoveMethod::Async));
    QCOMPARE(fixture.fake().raw(utf8("wait_angle")), std::int64_t(500));
    QCOMPARE(fixture.noticeCount(NoticeCode::Resent), 1);
}

void TestFamilyMotion::syncMoveOnlyWhereSupported()
{
    const std::pair<MoveMethod, const char*> ways[]{{MoveMethod::Sync, "no-sync"},
                                                    {MoveMethod::Async, "no-async"}};
    for (const auto& [how, detail] : ways) {
        DeviceFixture modbus{{"STS", 1}, {"SMSMB", 2}};
        device::Servo first = modbus.servo(0);
        device::Servo second = modbus.servo(1);
        const auto sent = moved(modbus, {order(first, "500"), order(second, "500")}, how);
        QVERIFY(!sent);
        QCOMPARE(sent.error().code, ErrorCode::NotSupported);
        QCOMPARE(sent.error().detail, utf8(detail));
        QCOMPARE(sent.error().id, 2);
        QVERIFY(modbus.bus.requests.empty());
        // A speed cannot be stored.
        DeviceFixture motor(utf8("LX"));
        motor.fake().poke(utf8("mode"), 1);
        device::Servo servo = motor.servo();
        const auto stored = moved(motor, {order(servo, "500")}, how);
        QVERIFY(!stored);
        QCOMPARE(stored.error().detail, utf8(detail));
        QCOMPARE(motor.bus.writes(), 0);
    }
}

/// One packet a family: neither byte order nor the meaning of 44 may be mixed.
void TestFamilyMotion::familiesMoveTogether()
{
    DeviceFixture fixture{{"STS", 1}, {"HLS", 2}, {"SMCL", 3}, {"SCS2", 4},
                          {"SCS", 5}, {"STS", 6}, {"LX", 1}};
    fixture.fake(6).poke(utf8("load"), 1);
    std::deque<device::Servo> servos;
    std::vector<MoveCommand> orders;
    for (std::size_t i = 0; i < fixture.bus.servos.size(); ++i) {
        servos.push_back(fixture.servo(i));
        orders.push_back(order(servos.back(), "500"));
    }
    QVERIFY(moved(fixture, orders, MoveMethod::Sync));
    for (fake::Servo& servo : fixture.bus.servos)
        QCOMPARE(servo.raw(servo.profile
                               ->byRole(servo.has(Role::StoredGoal) ? Role::StoredGoal
                                                                    : Role::GoalPosition)
                               ->key),
                 std::int64_t(500));
    const QStringList frames = requests(fixture);
    QCOMPARE(frames.filter(utf8("S42")).size(), 5);
    QCOMPARE(frames.filter(utf8("S42x2")).size(), 1);
    for (const protocol::Request& request : fixture.bus.requests) {
        if (request.op != Op::SyncWrite)
            continue;
        const bool mixes = request.targets.size() > 1 &&
                           (request.targets[0].id != 1 || request.targets[1].id != 6);
        QVERIFY(!mixes);
    }
}

void TestFamilyMotion::lostGoalsAreWrittenAgain()
{
    for (const char* family : {"HLS", "SMSMB", "LX"}) {
        DeviceFixture fixture{{family, 1}};
        fixture.fake().poke(fixture.fake().profile->byRole(Role::TorqueSwitch)->key, 1);
        device::Servo servo = fixture.servo();
        auto plans = planned(fixture, {order(servo, "500")});
        QVERIFY(plans);
        fixture.bus.lostWrites = 1;
        QVERIFY(device::sendMoves(fixture.context(), *plans, MoveMethod::Write));
        QCOMPARE(fixture.fake().raw(Role::GoalPosition), std::int64_t(500));
        QCOMPARE(fixture.noticeCount(NoticeCode::Resent) +
                     fixture.noticeCount(NoticeCode::ReplyLostResent),
                 1);
        DeviceFixture lost{{family, 1}};
        lost.bus.dropAcknowledgments = true;
        device::Servo other = lost.servo();
        QVERIFY(moved(lost, {order(other, "500")}));
        QCOMPARE(lost.fake().raw(Role::GoalPosition), std::int64_t(500));
    }
}

void TestFamilyMotion::haltEndsTheMotion_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("mode");
    QTest::addColumn<QStringList>("frames");
    QTest::newRow("STS") << "STS" << 0 << QStringList{utf8("W42:2C 01")};
    QTest::newRow("STS speed") << "STS" << 1 << QStringList{utf8("W46:00 00")};
    QTest::newRow("SCS-2") << "SCS2" << 0 << QStringList{utf8("W42:01 2C")};
    QTest::newRow("HLS current") << "HLS" << 2 << QStringList{utf8("W44:00 00")};
    QTest::newRow("Modbus") << "SMSMB" << 0 << QStringList{utf8("W256:01 2C")};
    QTest::newRow("Modbus speed") << "SMSMB" << 1 << QStringList{utf8("W262:00 00")};
    QTest::newRow("LX") << "LX" << 0 << QStringList{utf8("H"), utf8("H"), utf8("H")};
    // The stop command does not end motor mode.
    QTest::newRow("LX motor") << "LX" << 1 << QStringList{utf8("W232:01 00 00 00")};
}

void TestFamilyMotion::haltEndsTheMotion()
{
    QFETCH(QString, family);
    QFETCH(int, mode);
    QFETCH(QStringList, frames);
    DeviceFixture fixture(family);
    const catalog::Profile& profile = *fixture.fake().profile;
    if (fixture.fake().has(Role::OperatingMode))
        fixture.fake().poke(profile.byRole(Role::OperatingMode)->key, mode);
    fixture.fake().poke(profile.byRole(Role::TorqueSwitch)->key, 1);
    fixture.fake().poke(profile.byRole(Role::PresentPosition)->key, 300);
    if (mode != 0)
        fixture.fake().poke(fixture.servo().profile->byRole(fixture.servo().mode()->command)->key,
                            77);
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(requests(fixture), frames);
    QCOMPARE(fixture.fake().raw(Role::TorqueSwitch), std::int64_t(1));
}

/// The stop command is not acknowledged; the shaft shows that it was lost.
void TestFamilyMotion::aMovingShaftIsHeld()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("load"), 1);
    fixture.fake().poke(utf8("move_angle"), 900);
    device::Servo servo = fixture.servo();
    fixture.bus.onRequest = [&](const protocol::Request& request) {
        const int place = int((fixture.bus.time.now() / 1ms) % 1000);
        if (request.op == Op::Read && fixture.fake().raw(utf8("move_angle")) == 900)
            fixture.fake().poke(utf8("position"), place);
    };
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("move_angle")), fixture.fake().raw(utf8("position")));
    QCOMPARE(fixture.noticeCount(NoticeCode::HoldingAt), 1);
}

void TestFamilyMotion::haltOfAnUnloadedServoSendsNothing()
{
    for (const char* family : {"STS", "SMSMB", "LX"}) {
        DeviceFixture fixture{{family, 1}};
        device::Servo servo = fixture.servo();
        QVERIFY(device::halt(fixture.context(), servo));
        QCOMPARE(fixture.bus.writes(), 0);
        QCOMPARE(fixture.noticeCount(NoticeCode::AlreadySet), 1);
    }
}

void TestFamilyMotion::haltInStepModeReleasesTorque()
{
    DeviceFixture fixture(utf8("STS"));
    fixture.fake().poke(utf8("operating_mode"), 3);
    fixture.fake().poke(utf8("min_angle_limit"), 0);
    fixture.fake().poke(utf8("max_angle_limit"), 0);
    fixture.fake().poke(utf8("torque_switch"), 1);
    device::Servo servo = fixture.servo();
    QVERIFY(device::halt(fixture.context(), servo));
    QCOMPARE(fixture.fake().raw(utf8("torque_switch")), std::int64_t(0));
    QCOMPARE(fixture.noticeCount(NoticeCode::TorqueSwitchedOff), 1);
}

void TestFamilyMotion::arrivalWithoutAFlag_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<int>("startsAfter"); ///< ms
    QTest::addColumn<int>("travelTime");  ///< ms; 0: one step a millisecond
    QTest::addColumn<int>("sticksAt");    ///< −1: nowhere
    QTest::newRow("at once") << 0 << 500 << 0 << 0 << -1;
    QTest::newRow("a slow start") << 0 << 500 << 400 << 0 << -1;
    QTest::newRow("in its own time") << 0 << 500 << 0 << 2000 << -1;
    QTest::newRow("slower than the eye") << 500 << 510 << 0 << 25000 << -1;
    QTest::newRow("something in the way") << 0 << 500 << 0 << 0 << 200;
    QTest::newRow("already there") << 500 << 500 << 0 << 0 << -1;
}

void TestFamilyMotion::arrivalWithoutAFlag()
{
    QFETCH(int, from);
    QFETCH(int, to);
    QFETCH(int, startsAfter);
    QFETCH(int, travelTime);
    QFETCH(int, sticksAt);
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("position"), from);
    fixture.fake().poke(utf8("load"), 1);
    fixture.fake().poke(utf8("vin"), 7400);
    device::Servo servo = fixture.servo();
    MoveCommand go{&servo, QString::number(to)};
    if (travelTime > 0)
        go.time = QString::number(travelTime);
    auto plans = planned(fixture, {go});
    QVERIFY(plans);
    QVERIFY(device::sendMoves(fixture.context(), *plans, MoveMethod::Write));
    const base::Duration begin = fixture.bus.time.now() + std::chrono::milliseconds(startsAfter);
    const double whole = travelTime > 0 ? travelTime : std::max(1, std::abs(to - from));
    fixture.bus.onRequest = [&](const protocol::Request&) {
        const double passed =
            std::max(0.0, double((fixture.bus.time.now() - begin) / 1us) / 1000.0);
        const double share = std::min(1.0, passed / whole);
        const int place = from + int(std::lround((to - from) * share));
        fixture.fake().poke(utf8("position"), sticksAt >= 0 ? std::min(place, sticksAt) : place);
    };
    bool movedSeen = false;
    const auto arrived = device::waitForArrival(
        fixture.context(), *plans, 60s,
        [&](const device::MoveProgress& seen) { movedSeen = movedSeen || seen.moving; });
    QCOMPARE(arrived.has_value(), sticksAt < 0);
    if (arrived)
        QCOMPARE(fixture.fake().raw(utf8("position")), std::int64_t(to));
    else
        QCOMPARE(arrived.error().detail, QString::number(sticksAt - to));
    QCOMPARE(movedSeen, std::abs(to - from) > 1);
}

void TestFamilyMotion::cancelingTheWaitReportsPendingMoves()
{
    DeviceFixture fixture(utf8("LX"));
    fixture.fake().poke(utf8("load"), 1);
    device::Servo servo = fixture.servo();
    MoveCommand go = order(servo, "500");
    go.time = utf8("30000");
    auto plans = planned(fixture, {go});
    QVERIFY(plans);
    QVERIFY(device::sendMoves(fixture.context(), *plans, MoveMethod::Write));
    int samples = 0;
    const auto waited =
        device::waitForArrival(fixture.context(), *plans, 60s, [&](const device::MoveProgress&) {
            if (++samples == 10)
                fixture.stop.request();
        });
    QVERIFY(!waited);
    QCOMPARE(waited.error().code, ErrorCode::Stopped);
    QCOMPARE(fixture.noticeCount(NoticeCode::StillMoving), 1);
}

SERVODESK_GUILESS_TEST(TestFamilyMotion)
#include "tst_family_motion.moc"

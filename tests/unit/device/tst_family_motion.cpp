// SPDX-License-Identifier: GPL-3.0-or-later
// Torque, modes, moves and halts in every family: nothing moves by surprise, and what a family
// lacks is refused before the wire.
#include "device/motion.h"

#include <QTest>

#include "paper_bus.h"

using base::ErrorCode;
using catalog::Role;
using device::MoveHow;
using device::MoveOrder;
using device::NoticeCode;
using device::Torque;
using paper::Bench;
using protocol::Op;
using namespace std::chrono_literals;

namespace {
QString text(const char* word)
{
    return QString::fromLatin1(word);
}

/// What was said besides reading: "W16:F4 01 00 00" = write at offset 16; H halt, A action.
QStringList said(const Bench& bench)
{
    QStringList words;
    for (const protocol::Request& request : bench.bus.said) {
        if (request.op == Op::Write)
            words << QStringLiteral("W%1:%2").arg(request.address).arg(base::toHex(request.data));
        else if (request.op == Op::SyncWrite)
            words << QStringLiteral("S%1x%2").arg(request.address).arg(request.targets.size());
        else if (request.op == Op::Halt)
            words << text("H");
        else if (request.op == Op::Action)
            words << QStringLiteral("A%1").arg(request.id);
        else if (request.op == Op::RegWrite)
            words << QStringLiteral("R%1").arg(request.address);
    }
    return words;
}

MoveOrder order(device::Servo& servo, const char* goal)
{
    return {&servo, text(goal)};
}

base::Result<std::vector<device::MovePlan>> planned(Bench& bench,
                                                    const std::vector<MoveOrder>& orders)
{
    std::vector<device::MovePlan> plans;
    for (const MoveOrder& one : orders) {
        auto plan = device::planMove(bench.context(), one);
        if (!plan)
            return tl::unexpected(plan.error());
        plans.push_back(*plan);
    }
    bench.bus.said.clear();
    return plans;
}

base::Result<void> moved(Bench& bench, const std::vector<MoveOrder>& orders,
                         MoveHow how = MoveHow::Write)
{
    auto plans = planned(bench, orders);
    if (!plans)
        return tl::unexpected(plans.error());
    return device::sendMoves(bench.context(), *plans, how);
}
} // namespace

class TestFamilyMotion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void torqueOnHolds_data();
    void torqueOnHolds();
    void torqueOnOutsideTheScaleIsRefused();
    void torqueOnInMotorModeStandsStill();
    void anEmergencyEndsTorqueOn_data();
    void anEmergencyEndsTorqueOn();
    void noDampingWhereThereIsNone_data();
    void noDampingWhereThereIsNone();
    void noCurrentIsSaid();
    void currentComesBack_data();
    void currentComesBack();
    void currentComesBackAfterAnInterruptedSwitch();
    void speedComesBackByAnyWay();
    void oldEvidenceIsNoAlarm();
    void modbusModesSettle();
    void torqueOffThatIsRefusedIsSaid();
    void lxModesAreQuietBothWays();
    void framesOfAMove_data();
    void framesOfAMove();
    void aMoveLoadsFirst();
    void motorSpeeds_data();
    void motorSpeeds();
    void refusedMoves_data();
    void refusedMoves();
    void storedMovesStartTogether();
    void oneStoredMoveStartsAlone();
    void aMoveThatWasGivenUpIsForgotten();
    void aStoredMoveThatIsTornIsStoredAgain();
    void togetherOnlyWhereItExists();
    void familiesMoveTogether();
    void lostGoalsAreWrittenAgain();
    void haltEndsTheMotion_data();
    void haltEndsTheMotion();
    void aShaftThatMovesOnIsHeld();
    void haltOfAnUnloadedServoSaysNothing();
    void haltInStepModeLetsGo();
    void arrivalWithoutAFlag_data();
    void arrivalWithoutAFlag();
    void stoppingTheWaitSaysWhatIsUnderWay();
};

void TestFamilyMotion::torqueOnHolds_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("stands");
    QTest::addColumn<QStringList>("frames");
    QTest::newRow("HLS") << "HLS" << 1000 << QStringList{text("W42:E8 03")};
    QTest::newRow("SMCL") << "SMCL" << 1000 << QStringList{text("W42:E8 03")};
    QTest::newRow("SCS-2") << "SCS2" << 512 << QStringList{text("W42:02 00")};
    QTest::newRow("Modbus") << "SMSMB" << 1000 << QStringList{text("W256:03 E8")};
    // Before, and again when it is loaded and listens.
    QTest::newRow("LX") << "LX" << 500
                        << QStringList{text("W8:F4 01 00 00"), text("W248:01"),
                                       text("W8:F4 01 00 00")};
    QTest::newRow("LX, just below its scale")
        << "LX" << -3
        << QStringList{text("W8:00 00 00 00"), text("W248:01"), text("W8:00 00 00 00")};
}

void TestFamilyMotion::torqueOnHolds()
{
    QFETCH(QString, family);
    QFETCH(int, stands);
    QFETCH(QStringList, frames);
    Bench bench(family);
    const catalog::Register& position = *bench.paper().profile->byRole(Role::PresentPosition);
    bench.paper().poke(position.key, stands);
    device::Servo servo = bench.servo();
    QVERIFY(device::setTorque(bench.context(), servo, Torque::On));
    QCOMPARE(said(bench), frames);
    QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(1));
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 1);
    bench.bus.said.clear();
    QVERIFY(device::setTorque(bench.context(), servo, Torque::Off));
    QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(0));
}

void TestFamilyMotion::torqueOnOutsideTheScaleIsRefused()
{
    for (const int stands : {-11, 1011}) {
        Bench bench(text("LX"));
        bench.paper().poke(text("position"), stands);
        device::Servo servo = bench.servo();
        const auto on = device::setTorque(bench.context(), servo, Torque::On);
        QVERIFY(!on);
        QCOMPARE(on.error().code, ErrorCode::OutOfRange);
        QCOMPARE(bench.bus.writes(), 0);
        // A goal inside leads it back, or it could be turned by hand only.
        QVERIFY(moved(bench, {order(servo, "500")}));
        QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(1));
        QCOMPARE(bench.paper().raw(Role::GoalPosition), std::int64_t(500));
        QCOMPARE(bench.noted(NoticeCode::HoldingAt), 0);
    }
}

void TestFamilyMotion::torqueOnInMotorModeStandsStill()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("mode"), 1);
    bench.paper().poke(text("motor_speed"), 700);
    device::Servo servo = bench.servo();
    QVERIFY(device::setTorque(bench.context(), servo, Torque::On));
    QCOMPARE(said(bench),
             (QStringList{text("W232:01 00 00 00"), text("W248:01"), text("W232:01 00 00 00")}));
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
        Bench bench(family);
        bench.paper().goalEnergises = false;
        bench.paper().poke(bench.paper().profile->byRole(Role::PresentPosition)->key, 500);
        device::Servo servo = bench.servo();
        int left = passed;
        bool met = false;
        bench.bus.onRequest = [&](const protocol::Request&) {
            bench.bus.emergencyNow = !met && left-- == 0;
            met |= bench.bus.emergencyNow;
        };
        const auto on = device::setTorque(bench.context(), servo, Torque::On);
        if (!met)
            break;
        QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(0));
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
    Bench bench(family);
    device::Servo servo = bench.servo();
    const auto damped = device::setTorque(bench.context(), servo, Torque::Damp);
    QVERIFY(!damped);
    QCOMPARE(damped.error().code, ErrorCode::NotSupported);
    QCOMPARE(damped.error().detail, text("damp"));
    QVERIFY(bench.bus.said.empty());
}

/// HLS 44 at 0 is no torque at all; and no move ever writes there.
void TestFamilyMotion::noCurrentIsSaid()
{
    Bench bench(text("HLS"));
    bench.paper().poke(text("goal_current"), 0);
    device::Servo servo = bench.servo();
    QVERIFY(device::setTorque(bench.context(), servo, Torque::On));
    QCOMPARE(bench.noted(NoticeCode::NoCurrentAllowed), 1);
    bench.notices.clear();
    MoveOrder fast = order(servo, "2000");
    fast.speed = text("100");
    fast.acceleration = text("50");
    for (const MoveHow how : {MoveHow::Write, MoveHow::Sync, MoveHow::Async})
        QVERIFY(moved(bench, {fast}, how));
    QCOMPARE(bench.noted(NoticeCode::NoCurrentAllowed), 3);
    bench.paper().poke(text("goal_current"), 500);
    bench.notices.clear();
    QVERIFY(moved(bench, {fast}));
    QCOMPARE(bench.noted(NoticeCode::NoCurrentAllowed), 0);
    QCOMPARE(bench.paper().raw(text("goal_current")), std::int64_t(500));
    QCOMPARE(said(bench), (QStringList{text("W46:64 00"), text("W41:32 D0 07")}));
}

void TestFamilyMotion::currentComesBack_data()
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

void TestFamilyMotion::currentComesBack()
{
    QFETCH(QString, through);
    QFETCH(QString, to);
    Bench bench(text("HLS"));
    bench.paper().settle(text("protection_current"), 400);
    bench.paper().poke(text("goal_current"), 400);
    device::Servo servo = bench.servo();
    const auto there = device::switchMode(bench.context(), servo, through);
    QVERIFY(there && there->allGood());
    QCOMPARE(bench.paper().raw(text("goal_current")), std::int64_t(0)); // nothing pushes
    QCOMPARE(bench.noted(NoticeCode::CommandZeroed), 1);
    bench.notices.clear();
    const auto back = device::switchMode(bench.context(), servo, to);
    QVERIFY(back && back->allGood());
    QCOMPARE(bench.paper().raw(text("goal_current")), std::int64_t(400));
    QCOMPARE(bench.noted(NoticeCode::CurrentRestored), 1);
    QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(0));
}

void TestFamilyMotion::currentComesBackAfterAnInterruptedSwitch()
{
    Bench bench(text("HLS"));
    bench.paper().settle(text("protection_current"), 400);
    bench.paper().poke(text("goal_current"), 0);
    device::Servo servo = bench.servo();
    QVERIFY(device::quieten(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("goal_current")), std::int64_t(400));
    QCOMPARE(bench.noted(NoticeCode::CurrentRestored), 1);
}

/// Also when another mode lay between the one that zeroed it and the position mode.
void TestFamilyMotion::speedComesBackByAnyWay()
{
    Bench bench(text("HLS"));
    bench.paper().poke(text("goal_speed"), 60);
    device::Servo servo = bench.servo();
    for (const char* mode : {"speed", "current", "position"}) {
        const auto there = device::switchMode(bench.context(), servo, text(mode));
        QVERIFY(there && there->allGood());
    }
    QCOMPARE(bench.paper().raw(text("goal_speed")), std::int64_t(60));
    QCOMPARE(bench.noted(NoticeCode::SpeedRestored), 1);
}

void TestFamilyMotion::oldEvidenceIsNoAlarm()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("temperature"), 99);
    bench.paper().poke(text("vin"), 7400);
    device::Servo servo = bench.servo();
    device::noteAlarms(bench.context(), servo);
    QCOMPARE(bench.noted(NoticeCode::DerivedTemperature), 1);
    bench.notices.clear();
    bench.bus.cutAfter = 0;
    device::noteAlarms(bench.context(), servo);
    QVERIFY(bench.notices.empty());
}

void TestFamilyMotion::modbusModesSettle()
{
    Bench bench(text("SMSMB"));
    bench.paper().poke(text("goal_speed"), 60);
    bench.paper().poke(text("torque_switch"), 1);
    device::Servo servo = bench.servo();
    const auto speed = device::switchMode(bench.context(), servo, text("speed"));
    QVERIFY(speed && speed->allGood());
    QCOMPARE(bench.paper().keptRaw(text("operating_mode")), std::int64_t(1));
    QCOMPARE(bench.paper().raw(text("goal_speed")), std::int64_t(0));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(0));
    const auto back = device::switchMode(bench.context(), servo, text("position"));
    QVERIFY(back && back->allGood());
    QCOMPARE(bench.paper().raw(text("goal_speed")), std::int64_t(60));
    const auto turns = device::switchMode(bench.context(), servo, text("multiturn"));
    QVERIFY(turns && turns->allGood());
    QCOMPARE(bench.paper().raw(text("max_angle_limit")), std::int64_t(0));
    QVERIFY(device::switchMode(bench.context(), servo, text("position")));
    QCOMPARE(bench.paper().raw(text("max_angle_limit")), std::int64_t(4095));
}

/// Nothing is said of a torque that is still on.
void TestFamilyMotion::torqueOffThatIsRefusedIsSaid()
{
    Bench bench(text("SMSMB"));
    paper::Servo& servo = bench.paper();
    const catalog::Register& torque = *servo.profile->byRole(Role::TorqueSwitch);
    servo.poke(torque.key, 1);
    device::Servo known = bench.servo();
    servo.exceptions[torque.writeOffset] = 3;
    const auto report = device::switchMode(bench.context(), known, text("speed"));
    QVERIFY(report);
    QVERIFY(!report->allGood());
    QCOMPARE(servo.raw(torque.key), 1);
    QCOMPARE(bench.noted(NoticeCode::TorqueStaysOff), 0);
}

void TestFamilyMotion::lxModesAreQuietBothWays()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("load"), 1);
    device::Servo servo = bench.servo();
    const auto motor = device::switchMode(bench.context(), servo, text("motor"));
    QVERIFY(motor && motor->allGood());
    QCOMPARE(said(bench), (QStringList{text("W248:00"), text("W232:01 00 00 00")}));
    bench.paper().poke(text("motor_speed"), 500);
    bench.paper().poke(text("load"), 1);
    bench.bus.said.clear();
    const auto position = device::switchMode(bench.context(), servo, text("position"));
    QVERIFY(position && position->allGood());
    QCOMPARE(said(bench), (QStringList{text("W248:00"), text("W232:00 00 00 00")}));
    QCOMPARE(bench.openIntents(), std::size_t(0));
    const auto none = device::switchMode(bench.context(), servo, text("step"));
    QVERIFY(!none);
    QCOMPARE(none.error().code, ErrorCode::NotSupported);
    QCOMPARE(none.error().detail, text("position, motor"));
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
    row("Modbus, one register", "SMSMB", "", "", "", {text("W256:01 F4")});
    row("Modbus, neighbours in one", "SMSMB", "50", "10", "",
        {text("W260:00 0A 00 32"), text("W256:01 F4")});
    row("LX, as fast as it can", "LX", "", "", "", {text("W8:F4 01 00 00")});
    row("LX in a second", "LX", "", "", "1000", {text("W8:F4 01 E8 03")});
    row("HLS, goal only", "HLS", "", "", "", {text("W42:F4 01")});
    row("SMCL with speed", "SMCL", "50", "", "", {text("W46:32 00"), text("W42:F4 01")});
    row("SCS-2, high byte first", "SCS2", "50", "", "", {text("W46:00 32"), text("W42:01 F4")});
}

void TestFamilyMotion::framesOfAMove()
{
    QFETCH(QString, family);
    QFETCH(QString, speed);
    QFETCH(QString, acceleration);
    QFETCH(QString, time);
    QFETCH(QStringList, frames);
    Bench bench(family);
    bench.paper().poke(bench.paper().profile->byRole(Role::TorqueSwitch)->key, 1);
    device::Servo servo = bench.servo();
    MoveOrder go = order(servo, "500");
    if (!speed.isEmpty())
        go.speed = speed;
    if (!acceleration.isEmpty())
        go.acceleration = acceleration;
    if (!time.isEmpty())
        go.time = time;
    QVERIFY(moved(bench, {go}));
    QCOMPARE(said(bench), frames);
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOn), 0);
}

void TestFamilyMotion::aMoveLoadsFirst()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("position"), 300);
    device::Servo servo = bench.servo();
    QVERIFY(moved(bench, {order(servo, "120deg")}));
    QCOMPARE(said(bench), (QStringList{text("W8:2C 01 00 00"), text("W248:01"),
                                       text("W8:2C 01 00 00"), text("W8:F4 01 00 00")}));
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOn), 1);
    QCOMPARE(bench.paper().raw(text("load")), std::int64_t(1));
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
    Bench bench(text("LX"));
    bench.paper().poke(text("mode"), 1);
    bench.paper().poke(text("load"), 1);
    device::Servo servo = bench.servo();
    QVERIFY(moved(bench, {{&servo, goal}}));
    QCOMPARE(said(bench), QStringList{frame});
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
    Bench bench(family);
    if (bench.paper().has(Role::OperatingMode))
        bench.paper().poke(bench.paper().profile->byRole(Role::OperatingMode)->key, mode);
    device::Servo servo = bench.servo();
    MoveOrder go{&servo, goal};
    const QString value = extra.section(QLatin1Char('='), 1);
    if (extra.startsWith(text("speed")))
        go.speed = value;
    else if (extra.startsWith(text("acc")))
        go.acceleration = value;
    else if (extra.startsWith(text("time")))
        go.time = value;
    const auto plan = device::planMove(bench.context(), go);
    QVERIFY(!plan);
    QCOMPARE(base::errorName(plan.error().code), base::errorName(code));
    QCOMPARE(plan.error().detail, detail);
    QCOMPARE(bench.bus.writes(), 0);
}

/// Each is addressed: others on the line may hold a move of another program.
void TestFamilyMotion::storedMovesStartTogether()
{
    for (const bool tells : {true, false}) {
        for (const MoveHow how : {MoveHow::Sync, MoveHow::Async}) {
            Bench bench{{"LX", 1}, {"LX", 2}};
            for (paper::Servo& servo : bench.bus.servos) {
                servo.poke(text("load"), 1);
                servo.tellsStored = tells;
            }
            device::Servo first = bench.servo(0);
            device::Servo second = bench.servo(1);
            MoveOrder slow = order(second, "1000");
            slow.time = text("30000");
            QVERIFY(moved(bench, {order(first, "500"), slow}, how));
            QCOMPARE(said(bench),
                     (QStringList{text("W56:F4 01 00 00"), text("W56:E8 03 30 75"), text("A1"),
                                  text("A2"), text("A1"), text("A2"), text("A1"), text("A2")}));
        }
    }
}

void TestFamilyMotion::oneStoredMoveStartsAlone()
{
    Bench bench{{"LX", 1}, {"LX", 2}};
    bench.paper(0).poke(text("load"), 1);
    device::Servo servo = bench.servo(0);
    QVERIFY(moved(bench, {order(servo, "500")}, MoveHow::Async));
    QCOMPARE(said(bench),
             (QStringList{text("W56:F4 01 00 00"), text("A1"), text("A1"), text("A1")}));
}

/// An emergency stop before the start: no later start command may find the move.
void TestFamilyMotion::aMoveThatWasGivenUpIsForgotten()
{
    Bench bench{{"LX", 1}, {"LX", 2}};
    for (paper::Servo& servo : bench.bus.servos) {
        servo.poke(text("load"), 1);
        servo.poke(text("position"), 300);
    }
    device::Servo first = bench.servo(0);
    device::Servo second = bench.servo(1);
    auto plans = planned(bench, {order(first, "500"), order(second, "600")});
    QVERIFY(plans);
    bool met = false;
    bench.bus.onRequest = [&](const protocol::Request& request) {
        bench.bus.emergencyNow = !met && request.op == Op::Write && request.id == 2;
        met |= bench.bus.emergencyNow;
    };
    const auto sent = device::sendMoves(bench.context(), *plans, MoveHow::Sync);
    QVERIFY(!sent);
    QCOMPARE(sent.error().code, ErrorCode::Preempted);
    QVERIFY(said(bench).filter(text("A")).isEmpty());
    for (const paper::Servo& servo : bench.bus.servos)
        QCOMPARE(servo.raw(text("wait_angle")), std::int64_t(300));
}

void TestFamilyMotion::aStoredMoveThatIsTornIsStoredAgain()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("load"), 1);
    device::Servo servo = bench.servo();
    auto plans = planned(bench, {order(servo, "500")});
    QVERIFY(plans);
    bench.bus.deafWrites = 1;
    QVERIFY(device::sendMoves(bench.context(), *plans, MoveHow::Async));
    QCOMPARE(bench.paper().raw(text("wait_angle")), std::int64_t(500));
    QCOMPARE(bench.noted(NoticeCode::SentAgain), 1);
}

void TestFamilyMotion::togetherOnlyWhereItExists()
{
    const std::pair<MoveHow, const char*> ways[]{{MoveHow::Sync, "no-sync"},
                                                 {MoveHow::Async, "no-async"}};
    for (const auto& [how, detail] : ways) {
        Bench modbus{{"STS", 1}, {"SMSMB", 2}};
        device::Servo first = modbus.servo(0);
        device::Servo second = modbus.servo(1);
        const auto sent = moved(modbus, {order(first, "500"), order(second, "500")}, how);
        QVERIFY(!sent);
        QCOMPARE(sent.error().code, ErrorCode::NotSupported);
        QCOMPARE(sent.error().detail, text(detail));
        QCOMPARE(sent.error().id, 2);
        QVERIFY(modbus.bus.said.empty());
        // A speed cannot be stored.
        Bench motor(text("LX"));
        motor.paper().poke(text("mode"), 1);
        device::Servo servo = motor.servo();
        const auto stored = moved(motor, {order(servo, "500")}, how);
        QVERIFY(!stored);
        QCOMPARE(stored.error().detail, text(detail));
        QCOMPARE(motor.bus.writes(), 0);
    }
}

/// One packet a family: neither byte order nor the meaning of 44 may be mixed.
void TestFamilyMotion::familiesMoveTogether()
{
    Bench bench{{"STS", 1}, {"HLS", 2}, {"SMCL", 3}, {"SCS2", 4},
                {"SCS", 5}, {"STS", 6}, {"LX", 1}};
    bench.paper(6).poke(text("load"), 1);
    std::deque<device::Servo> servos;
    std::vector<MoveOrder> orders;
    for (std::size_t i = 0; i < bench.bus.servos.size(); ++i) {
        servos.push_back(bench.servo(i));
        orders.push_back(order(servos.back(), "500"));
    }
    QVERIFY(moved(bench, orders, MoveHow::Sync));
    for (paper::Servo& servo : bench.bus.servos)
        QCOMPARE(servo.raw(servo.profile
                               ->byRole(servo.has(Role::StoredGoal) ? Role::StoredGoal
                                                                    : Role::GoalPosition)
                               ->key),
                 std::int64_t(500));
    const QStringList frames = said(bench);
    QCOMPARE(frames.filter(text("S42")).size(), 5);
    QCOMPARE(frames.filter(text("S42x2")).size(), 1);
    for (const protocol::Request& request : bench.bus.said) {
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
        Bench bench{{family, 1}};
        bench.paper().poke(bench.paper().profile->byRole(Role::TorqueSwitch)->key, 1);
        device::Servo servo = bench.servo();
        auto plans = planned(bench, {order(servo, "500")});
        QVERIFY(plans);
        bench.bus.deafWrites = 1;
        QVERIFY(device::sendMoves(bench.context(), *plans, MoveHow::Write));
        QCOMPARE(bench.paper().raw(Role::GoalPosition), std::int64_t(500));
        QCOMPARE(bench.noted(NoticeCode::SentAgain) + bench.noted(NoticeCode::AnswerLostSentAgain),
                 1);
        Bench lost{{family, 1}};
        lost.bus.loseAcks = true;
        device::Servo other = lost.servo();
        QVERIFY(moved(lost, {order(other, "500")}));
        QCOMPARE(lost.paper().raw(Role::GoalPosition), std::int64_t(500));
    }
}

void TestFamilyMotion::haltEndsTheMotion_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("mode");
    QTest::addColumn<QStringList>("frames");
    QTest::newRow("STS") << "STS" << 0 << QStringList{text("W42:2C 01")};
    QTest::newRow("STS speed") << "STS" << 1 << QStringList{text("W46:00 00")};
    QTest::newRow("SCS-2") << "SCS2" << 0 << QStringList{text("W42:01 2C")};
    QTest::newRow("HLS current") << "HLS" << 2 << QStringList{text("W44:00 00")};
    QTest::newRow("Modbus") << "SMSMB" << 0 << QStringList{text("W256:01 2C")};
    QTest::newRow("Modbus speed") << "SMSMB" << 1 << QStringList{text("W262:00 00")};
    QTest::newRow("LX") << "LX" << 0 << QStringList{text("H"), text("H"), text("H")};
    // The stop command does not end motor mode.
    QTest::newRow("LX motor") << "LX" << 1 << QStringList{text("W232:01 00 00 00")};
}

void TestFamilyMotion::haltEndsTheMotion()
{
    QFETCH(QString, family);
    QFETCH(int, mode);
    QFETCH(QStringList, frames);
    Bench bench(family);
    const catalog::Profile& profile = *bench.paper().profile;
    if (bench.paper().has(Role::OperatingMode))
        bench.paper().poke(profile.byRole(Role::OperatingMode)->key, mode);
    bench.paper().poke(profile.byRole(Role::TorqueSwitch)->key, 1);
    bench.paper().poke(profile.byRole(Role::PresentPosition)->key, 300);
    if (mode != 0)
        bench.paper().poke(bench.servo().profile->byRole(bench.servo().mode()->command)->key, 77);
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(said(bench), frames);
    QCOMPARE(bench.paper().raw(Role::TorqueSwitch), std::int64_t(1));
}

/// The stop command is not acknowledged; the shaft shows that it was not heard.
void TestFamilyMotion::aShaftThatMovesOnIsHeld()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("load"), 1);
    bench.paper().poke(text("move_angle"), 900);
    device::Servo servo = bench.servo();
    bench.bus.onRequest = [&](const protocol::Request& request) {
        const int place = int((bench.bus.time.now() / 1ms) % 1000);
        if (request.op == Op::Read && bench.paper().raw(text("move_angle")) == 900)
            bench.paper().poke(text("position"), place);
    };
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("move_angle")), bench.paper().raw(text("position")));
    QCOMPARE(bench.noted(NoticeCode::HoldingAt), 1);
}

void TestFamilyMotion::haltOfAnUnloadedServoSaysNothing()
{
    for (const char* family : {"STS", "SMSMB", "LX"}) {
        Bench bench{{family, 1}};
        device::Servo servo = bench.servo();
        QVERIFY(device::halt(bench.context(), servo));
        QCOMPARE(bench.bus.writes(), 0);
        QCOMPARE(bench.noted(NoticeCode::AlreadySo), 1);
    }
}

void TestFamilyMotion::haltInStepModeLetsGo()
{
    Bench bench(text("STS"));
    bench.paper().poke(text("operating_mode"), 3);
    bench.paper().poke(text("min_angle_limit"), 0);
    bench.paper().poke(text("max_angle_limit"), 0);
    bench.paper().poke(text("torque_switch"), 1);
    device::Servo servo = bench.servo();
    QVERIFY(device::halt(bench.context(), servo));
    QCOMPARE(bench.paper().raw(text("torque_switch")), std::int64_t(0));
    QCOMPARE(bench.noted(NoticeCode::TorqueSwitchedOff), 1);
}

void TestFamilyMotion::arrivalWithoutAFlag_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<int>("startsAfter"); ///< ms
    QTest::addColumn<int>("ownTime");     ///< ms; 0: one step a millisecond
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
    QFETCH(int, ownTime);
    QFETCH(int, sticksAt);
    Bench bench(text("LX"));
    bench.paper().poke(text("position"), from);
    bench.paper().poke(text("load"), 1);
    bench.paper().poke(text("vin"), 7400);
    device::Servo servo = bench.servo();
    MoveOrder go{&servo, QString::number(to)};
    if (ownTime > 0)
        go.time = QString::number(ownTime);
    auto plans = planned(bench, {go});
    QVERIFY(plans);
    QVERIFY(device::sendMoves(bench.context(), *plans, MoveHow::Write));
    const base::Duration begin = bench.bus.time.now() + std::chrono::milliseconds(startsAfter);
    const double whole = ownTime > 0 ? ownTime : std::max(1, std::abs(to - from));
    bench.bus.onRequest = [&](const protocol::Request&) {
        const double passed = std::max(0.0, double((bench.bus.time.now() - begin) / 1us) / 1000.0);
        const double share = std::min(1.0, passed / whole);
        const int place = from + int(std::lround((to - from) * share));
        bench.paper().poke(text("position"), sticksAt >= 0 ? std::min(place, sticksAt) : place);
    };
    bool movedSeen = false;
    const auto arrived =
        device::waitForArrival(bench.context(), *plans, 60s, [&](const device::MoveProgress& seen) {
            movedSeen = movedSeen || seen.moving;
        });
    QCOMPARE(arrived.has_value(), sticksAt < 0);
    if (arrived)
        QCOMPARE(bench.paper().raw(text("position")), std::int64_t(to));
    else
        QCOMPARE(arrived.error().detail, QString::number(sticksAt - to));
    QCOMPARE(movedSeen, std::abs(to - from) > 1);
}

void TestFamilyMotion::stoppingTheWaitSaysWhatIsUnderWay()
{
    Bench bench(text("LX"));
    bench.paper().poke(text("load"), 1);
    device::Servo servo = bench.servo();
    MoveOrder go = order(servo, "500");
    go.time = text("30000");
    auto plans = planned(bench, {go});
    QVERIFY(plans);
    QVERIFY(device::sendMoves(bench.context(), *plans, MoveHow::Write));
    int samples = 0;
    const auto waited =
        device::waitForArrival(bench.context(), *plans, 60s, [&](const device::MoveProgress&) {
            if (++samples == 10)
                bench.stop.request();
        });
    QVERIFY(!waited);
    QCOMPARE(waited.error().code, ErrorCode::Stopped);
    QCOMPARE(bench.noted(NoticeCode::StillMoving), 1);
}

QTEST_GUILESS_MAIN(TestFamilyMotion)
#include "tst_family_motion.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Moves without surprises: torque-on holds, mode switches are guarded, fields not given are not
// written, and a relative move is never made twice.
#include "device/motion/motion.h"
#include "support/lost_acknowledgments.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <deque>

using base::ErrorCode;
using device::MoveCommand;
using device::MoveMethod;
using device::MovePlan;
using device::Torque;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
base::Result<void> move(SimFixture& fixture, device::Servo& servo, MoveCommand order,
                        MoveMethod how = MoveMethod::Write)
{
    order.servo = &servo;
    auto plan = device::planMove(fixture.context(), order);
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<MovePlan> plans{*plan};
    return device::sendMoves(fixture.context(), plans, how);
}

MoveCommand to(const char* goal)
{
    MoveCommand order;
    order.goal = utf8(goal);
    return order;
}

/// Addresses the host has written to `id`, byte by byte.
std::set<int> writtenAddresses(SimFixture& fixture, int id)
{
    std::set<int> addresses;
    for (const base::Bytes& frame : fixture.tap().written) {
        if (frame[2] != id || frame[4] != support::Write)
            continue;
        for (std::size_t i = 0; i + 7 < frame.size(); ++i)
            addresses.insert(frame[5] + int(i));
    }
    return addresses;
}
} // namespace

class TestMoves : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void torqueOnHolds_data();
    void torqueOnHolds();
    void torqueOnWithUnknownTurnsIsRefused();
    void torqueOnHoldsKnownTurns();
    void torqueOnWithResolutionFactor();
    void dampingOnlyWhereItExists();
    void onlySetFieldsAreWritten_data();
    void onlySetFieldsAreWritten();
    void moveReachesItsGoal_data();
    void moveReachesItsGoal();
    void motionIsDetectedWithoutTheFlag();
    void cancelingTheWaitDoesNotStopTheServo();
    void losingTheLinkDoesNotStopTheServos();
    void aSilentServoKeepsNoOtherMoving();
    void refusedMoves_data();
    void refusedMoves();
    void timeActsOnScs();
    void stepIsExecutedOnce_data();
    void stepIsExecutedOnce();
    void lostStepRequestIsResent();
    void servosMoveTogether_data();
    void servosMoveTogether();
    void otherLxServosKeepTheirStoredMove();
    void modeSwitchIsQuiet_data();
    void modeSwitchIsQuiet();
    void aTemporaryModeCanBeSaved();
    void limitsAreRestored_data();
    void limitsAreRestored();
    void editingTheModeRegisterIsTheSameProcedure();
    void speedIsRestored();
    void pwmNeedsAUnit();
    void alarmsShowTheirRemedy_data();
    void alarmsShowTheirRemedy();
};

void TestMoves::torqueOnHolds_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"position", "speed", "pwm", "step"})
        QTest::newRow(qPrintable(utf8("STS ") + utf8(mode))) << utf8("sts3215@1") << utf8(mode);
    QTest::newRow("SCS position") << utf8("scs15@1") << utf8("position");
    QTest::newRow("SCS motor") << utf8("scs15@1") << utf8("motor");
}

void TestMoves::torqueOnHolds()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    SimFixture fixture(servo);
    // Commands of another life, all of which would move it.
    fixture.poke(1, utf8("goal_speed"), 900);
    device::Servo one = fixture.servo(1);
    const auto switched = device::switchMode(fixture.context(), one, mode);
    QVERIFY(switched && switched->isSuccessful());
    const double before = fixture.shaft(1);
    const auto on = device::setTorque(fixture.context(), one, Torque::On);
    QVERIFY2(on, on ? "" : qPrintable(base::errorName(on.error().code)));
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1);
    fixture.runFor(1s);
    QVERIFY2(std::abs(fixture.shaft(1) - before) < 1.0,
             qPrintable(QString::number(fixture.shaft(1))));
}

void TestMoves::torqueOnWithUnknownTurnsIsRefused()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("phase"), fixture.raw(1, utf8("phase")) & ~16);
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("multiturn")));
    fixture.clearFrames();
    const auto on = device::setTorque(fixture.context(), servo, Torque::On);
    QVERIFY(!on);
    QCOMPARE(on.error().code, ErrorCode::TurnsUnknown);
    QVERIFY(fixture.onlyReadsSent());
}

void TestMoves::torqueOnHoldsKnownTurns()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("phase"), fixture.raw(1, utf8("phase")) | 16);
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("multiturn")));
    QVERIFY(move(fixture, servo, to("9000")));
    fixture.runFor(6s);
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::Off));
    const double before = fixture.shaft(1);
    QVERIFY(before > 700);
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::On));
    fixture.runFor(1s);
    QVERIFY(std::abs(fixture.shaft(1) - before) < 1.0);
}

void TestMoves::torqueOnWithResolutionFactor()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("angle_resolution"), 3);
    device::Servo servo = fixture.servo(1);
    const double before = fixture.shaft(1);
    QVERIFY(device::setTorque(fixture.context(), servo, Torque::On));
    fixture.runFor(1s);
    // A goal in steps of three can only hold to half of that.
    QVERIFY(std::abs(fixture.shaft(1) - before) < 1.0);
    QVERIFY(std::abs(fixture.raw(1, utf8("goal_position")) * 3 -
                     fixture.raw(1, utf8("present_position"))) <= 6);
}

void TestMoves::dampingOnlyWhereItExists()
{
    SimFixture fixture(utf8("sts3215@1,scs15@2,sm40blhv@3:1000000"));
    for (const int id : {1, 2}) {
        device::Servo servo = fixture.servo(id);
        QVERIFY(device::setTorque(fixture.context(), servo, Torque::Damp));
        QCOMPARE(fixture.raw(id, utf8("torque_switch")), 2);
    }
    device::Servo sms = fixture.servo(3);
    const auto damped = device::setTorque(fixture.context(), sms, Torque::Damp);
    QVERIFY(!damped);
    QCOMPARE(damped.error().code, ErrorCode::NotSupported);
}

void TestMoves::onlySetFieldsAreWritten_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("speed");
    QTest::addColumn<bool>("acceleration");
    QTest::addColumn<QList<int>>("addresses");
    QTest::newRow("goal alone") << utf8("sts3215@1") << false << false << QList<int>{42, 43};
    QTest::newRow("goal and speed, 44 untouched")
        << utf8("sts3215@1") << true << false << QList<int>{42, 43, 46, 47};
    QTest::newRow("goal and acceleration")
        << utf8("sts3215@1") << false << true << QList<int>{41, 42, 43};
    QTest::newRow("SCS: goal alone") << utf8("scs15@1") << false << false << QList<int>{42, 43};
    QTest::newRow("SCS: goal and speed")
        << utf8("scs15@1") << true << false << QList<int>{42, 43, 46, 47};
}

void TestMoves::onlySetFieldsAreWritten()
{
    QFETCH(QString, servo);
    QFETCH(bool, speed);
    QFETCH(bool, acceleration);
    QFETCH(QList<int>, addresses);
    SimFixture fixture(servo);
    fixture.poke(1, utf8("torque_switch"), 1);
    device::Servo one = fixture.servo(1);
    fixture.clearFrames();
    MoveCommand order = to("600");
    if (speed)
        order.speed = utf8("300");
    if (acceleration)
        order.acceleration = utf8("20");
    QVERIFY(move(fixture, one, order));
    QCOMPARE(writtenAddresses(fixture, 1), std::set<int>(addresses.begin(), addresses.end()));
}

void TestMoves::moveReachesItsGoal_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<double>("degrees");
    QTest::newRow("STS raw") << utf8("sts3215@1") << utf8("3072") << 270.0;
    QTest::newRow("STS degrees") << utf8("sts3215@1") << utf8("90deg") << 90.0;
    // SCS15 turns 220° over 1024 steps.
    QTest::newRow("SCS raw") << utf8("scs15@1") << utf8("512") << 110.0;
}

void TestMoves::moveReachesItsGoal()
{
    QFETCH(QString, servo);
    QFETCH(QString, goal);
    QFETCH(double, degrees);
    SimFixture fixture(servo);
    device::Servo one = fixture.servo(1);
    MoveCommand order;
    order.servo = &one;
    order.goal = goal;
    auto plan = device::planMove(fixture.context(), order);
    QVERIFY(plan);
    QVERIFY(plan->energizes);
    std::vector<MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    QVERIFY(fixture.hasNotice(device::NoticeCode::TorqueSwitchedOn));
    int samples = 0;
    const auto arrived = device::waitForArrival(fixture.context(), plans, 10s,
                                                [&](const device::MoveProgress&) { ++samples; });
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
    QVERIFY(samples > 5);
    QVERIFY2(std::abs(fixture.shaft(1) - degrees) < 2.0,
             qPrintable(QString::number(fixture.shaft(1))));
}

/// The goal register holds 0 after power-on; writing 0 again moves, but raises no moving flag.
void TestMoves::motionIsDetectedWithoutTheFlag()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    MoveCommand order = to("0");
    order.servo = &servo;
    order.speed = utf8("10rpm");
    std::vector<MovePlan> plans{*device::planMove(fixture.context(), order)};
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    const auto arrived = device::waitForArrival(fixture.context(), plans, 30s, {});
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
}

void TestMoves::cancelingTheWaitDoesNotStopTheServo()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    MoveCommand order = to("3072");
    order.servo = &servo;
    order.speed = utf8("100");
    std::vector<MovePlan> plans{*device::planMove(fixture.context(), order)};
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    fixture.runFor(500ms);
    const auto waited =
        device::waitForArrival(fixture.context(), plans, 10s,
                               [&](const device::MoveProgress&) { fixture.stop().request(); });
    QVERIFY(!waited);
    QCOMPARE(waited.error().code, ErrorCode::Stopped);
    QVERIFY(fixture.hasNotice(device::NoticeCode::StillMoving));
}

void TestMoves::losingTheLinkDoesNotStopTheServos()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::deque<device::Servo> servos;
    std::vector<MovePlan> plans;
    for (const int id : {1, 2}) {
        servos.push_back(fixture.servo(id));
        MoveCommand order = to("3072");
        order.servo = &servos.back();
        order.speed = utf8("100");
        plans.push_back(*device::planMove(fixture.context(), order));
    }
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Write));
    fixture.runFor(500ms);
    const auto waited =
        device::waitForArrival(fixture.context(), plans, 10s, [&](const device::MoveProgress&) {
            fixture.wireConfig().faults.muteIds = {1, 2};
        });
    QVERIFY(!waited);
    for (const int id : {1, 2}) {
        const auto& notices = fixture.notices();
        QVERIFY(std::any_of(notices.begin(), notices.end(), [id](const device::Notice& notice) {
            return notice.code == device::NoticeCode::StillMoving && notice.id == id &&
                   notice.a == 1;
        }));
    }
}

void TestMoves::refusedMoves_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<QString>("speed");
    QTest::addColumn<QString>("acceleration");
    QTest::addColumn<QString>("time");
    QTest::addColumn<base::ErrorCode>("code");
    const auto row = [](const char* name, const char* servo, const char* goal, const char* speed,
                        const char* acceleration, const char* time, ErrorCode code) {
        QTest::newRow(name) << utf8(servo) << utf8(goal) << utf8(speed) << utf8(acceleration)
                            << utf8(time) << code;
    };
    row("above the limit", "sts3215@1", "4096", "", "", "", ErrorCode::OutOfRange);
    row("below the limit", "scs15@1", "5", "", "", "", ErrorCode::OutOfRange);
    row("negative speed", "sts3215@1", "100", "-5", "", "", ErrorCode::OutOfRange);
    row("no number", "sts3215@1", "far", "", "", "", ErrorCode::BadArgument);
    row("time on STS", "sts3215@1", "100", "", "", "500", ErrorCode::NotSupported);
    row("time beside speed", "scs15@1", "100", "200", "", "500", ErrorCode::BadArgument);
    row("acceleration on SCS", "scs15@1", "100", "", "20", "", ErrorCode::NotSupported);
    row("acceleration too large", "sts3215@1", "100", "", "255", "", ErrorCode::OutOfRange);
}

void TestMoves::refusedMoves()
{
    QFETCH(QString, servo);
    QFETCH(QString, goal);
    QFETCH(QString, speed);
    QFETCH(QString, acceleration);
    QFETCH(QString, time);
    QFETCH(base::ErrorCode, code);
    SimFixture fixture(servo);
    device::Servo one = fixture.servo(1);
    MoveCommand order;
    order.goal = goal;
    if (!speed.isEmpty())
        order.speed = speed;
    if (!acceleration.isEmpty())
        order.acceleration = acceleration;
    if (!time.isEmpty())
        order.time = time;
    const auto moved = move(fixture, one, order);
    QVERIFY(!moved);
    QCOMPARE(moved.error().code, code);
    QVERIFY(fixture.onlyReadsSent());
}

void TestMoves::timeActsOnScs()
{
    SimFixture fixture(utf8("scs15@1"));
    QVERIFY(fixture.raw(1, utf8("goal_speed")) != 0);
    device::Servo servo = fixture.servo(1);
    MoveCommand order = to("512");
    order.time = utf8("2000");
    QVERIFY(move(fixture, servo, order));
    QVERIFY(fixture.hasNotice(device::NoticeCode::SpeedZeroedForTime));
    fixture.runFor(1s);
    const double halfway = fixture.shaft(1);
    fixture.runFor(2s);
    const double end = fixture.shaft(1);
    QVERIFY(std::abs(end - 110.0) < 2.0);
    QVERIFY(std::abs(halfway - end) > 10.0);
}

void TestMoves::stepIsExecutedOnce_data()
{
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    QTest::addColumn<device::MoveMethod>("how");
    for (const auto how : {MoveMethod::Write, MoveMethod::Sync, MoveMethod::Async}) {
        QTest::addRow("clean line, %d", int(how)) << false << 1 << how;
        QTest::addRow("every acknowledgement lost, %d", int(how)) << true << 1 << how;
        QTest::addRow("response level 0, %d", int(how)) << false << 0 << how;
    }
}

void TestMoves::stepIsExecutedOnce()
{
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    QFETCH(device::MoveMethod, how);
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("response_level"), level);
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("step")));
    if (acksLost)
        support::dropAcknowledgments(fixture);
    const double start = fixture.shaft(1);
    // The same quarter turn three times over: equal goals are the hard case.
    for (int i = 1; i <= 3; ++i) {
        const auto moved = move(fixture, servo, to("1024"), how);
        QVERIFY2(moved, moved ? "" : qPrintable(base::errorName(moved.error().code)));
        fixture.runFor(3s);
        QVERIFY2(std::abs(fixture.shaft(1) - start - 90.0 * i) < 4.0,
                 qPrintable(QString::number(fixture.shaft(1) - start)));
    }
}

void TestMoves::lostStepRequestIsResent()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("step")));
    const double start = fixture.shaft(1);
    int goals = 0;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        const bool goal = frame[4] == support::Write && frame[5] == 42;
        goals += goal ? 1 : 0;
        fixture.wireConfig().faults.dropRequest = goal && goals == 1 ? 1.0 : 0.0;
    };
    QVERIFY(move(fixture, servo, to("1024")));
    QCOMPARE(goals, 2);
    QVERIFY(fixture.hasNotice(device::NoticeCode::ReplyLostResent));
    fixture.runFor(3s);
    QVERIFY(std::abs(fixture.shaft(1) - start - 90.0) < 4.0);
}

void TestMoves::servosMoveTogether_data()
{
    QTest::addColumn<device::MoveMethod>("how");
    QTest::newRow("write") << MoveMethod::Write;
    QTest::newRow("sync") << MoveMethod::Sync;
    QTest::newRow("async") << MoveMethod::Async;
}

void TestMoves::servosMoveTogether()
{
    QFETCH(device::MoveMethod, how);
    SimFixture fixture(utf8("sts3215@1,sts3250@2,scs15@3"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2), fixture.servo(3)};
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        MoveCommand order = to("700");
        order.servo = &servo;
        order.speed = utf8("400");
        auto plan = device::planMove(fixture.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    fixture.clearFrames();
    QVERIFY(device::sendMoves(fixture.context(), plans, how));
    // Families of different byte order never share a packet: two kinds, two blocks each.
    QCOMPARE(fixture.frames(support::SyncWrite), how == MoveMethod::Sync ? 4 : 0);
    QCOMPARE(fixture.frames(support::Action), how == MoveMethod::Async ? 1 : 0);
    QVERIFY(device::waitForArrival(fixture.context(), plans, 20s, {}));
    QVERIFY(std::abs(fixture.shaft(1) - 700 * 360.0 / 4096) < 2.0);
    QVERIFY(std::abs(fixture.shaft(2) - 700 * 360.0 / 4096) < 2.0);
    QVERIFY(std::abs(fixture.shaft(3) - 700 * 220.0 / 1024) < 2.0);
}

/// A third servo holds a goal of another program: the start of two others does not move it.
void TestMoves::otherLxServosKeepTheirStoredMove()
{
    support::SimFixtureOptions options;
    options.baud = 115'200;
    SimFixture fixture(utf8("lx16a@1,lx16a@2,lx16a@3"), options);
    std::vector<device::Servo> servos;
    for (const int id : {1, 2, 3})
        servos.push_back(fixture.servo(id, base::Protocol::Lx));
    std::vector<double> start;
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        QVERIFY(device::setTorque(fixture.context(), servo, device::Torque::On));
        start.push_back(fixture.shaft(servo.id));
        MoveCommand order = to("300");
        order.servo = &servo;
        auto plan = device::planMove(fixture.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    const auto moved = [&](std::size_t place) {
        return std::abs(fixture.shaft(servos[place].id) - start[place]);
    };
    std::vector<MovePlan> held{plans.back()};
    plans.pop_back();
    QVERIFY(device::sendAsyncMoves(fixture.context(), held));
    QVERIFY(device::sendMoves(fixture.context(), plans, MoveMethod::Async));
    fixture.runFor(4s);
    QVERIFY(moved(0) > 20 && moved(1) > 20);
    QVERIFY2(moved(2) < 1, qPrintable(QString::number(moved(2))));
    QVERIFY(device::startAsyncMoves(fixture.context(), held));
    fixture.runFor(4s);
    QVERIFY2(moved(2) > 20, qPrintable(QString::number(moved(2))));
}

void TestMoves::modeSwitchIsQuiet_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::addColumn<QString>("command");
    QTest::newRow("speed") << utf8("sts3215@1") << utf8("speed") << utf8("goal_speed");
    QTest::newRow("PWM") << utf8("sts3215@1") << utf8("pwm") << utf8("goal_pwm");
    QTest::newRow("SCS motor") << utf8("scs15@1") << utf8("motor") << utf8("goal_time");
}

void TestMoves::modeSwitchIsQuiet()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    QFETCH(QString, command);
    SimFixture fixture(servo);
    fixture.poke(1, utf8("goal_position"), fixture.raw(1, utf8("present_position")));
    fixture.poke(1, utf8("torque_switch"), 1); // it holds while it is looked at
    fixture.poke(1, command, 1000); // full speed, full PWM, or an innocent second of travel time
    device::Servo one = fixture.servo(1);
    const double before = fixture.shaft(1);
    const auto switched = device::switchMode(fixture.context(), one, mode);
    QVERIFY(switched && switched->isSuccessful());
    QCOMPARE(fixture.raw(1, command), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QVERIFY(fixture.hasNotice(device::NoticeCode::TorqueStaysOff));
    // Somebody else's plain torque-on must be harmless too.
    fixture.poke(1, utf8("torque_switch"), 1);
    fixture.runFor(1s);
    QVERIFY(std::abs(fixture.shaft(1) - before) < 1.0);
}

void TestMoves::aTemporaryModeCanBeSaved()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo one = fixture.servo(1);
    device::WriteOptions options;
    options.temporary = true;
    options.consent = device::Consent::confirmed();
    QVERIFY(device::write(fixture.context(), one, {{utf8("operating_mode"), 1}}, options)
                ->isSuccessful());
    const auto switched = device::switchMode(fixture.context(), one, utf8("speed"));
    QVERIFY(switched && switched->isSuccessful());
    QCOMPARE(switched->writes.size(), std::size_t(1));
    QCOMPARE(switched->writes[0].outcome, device::WriteOutcome::Kept);
    QVERIFY(device::switchMode(fixture.context(), one, utf8("speed"))->writes.empty());
    fixture.powerCycle();
    QCOMPARE(fixture.raw(1, utf8("operating_mode")), 1);
}

void TestMoves::limitsAreRestored_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::newRow("multi-turn") << utf8("sts3215@1") << utf8("multiturn");
    QTest::newRow("step") << utf8("sts3215@1") << utf8("step");
    QTest::newRow("SCS motor") << utf8("scs15@1") << utf8("motor");
}

void TestMoves::limitsAreRestored()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    SimFixture fixture(servo);
    device::Servo one = fixture.servo(1);
    QVERIFY(device::write(fixture.context(), one,
                          {{utf8("min_angle_limit"), 200}, {utf8("max_angle_limit"), 900}}, {}));
    QVERIFY(device::switchMode(fixture.context(), one, mode));
    QCOMPARE(fixture.raw(1, utf8("min_angle_limit")), 0);
    QCOMPARE(fixture.raw(1, utf8("max_angle_limit")), 0);
    // A new program on the same journal, the servo freshly powered.
    fixture.powerCycle();
    fixture.reconnect(1'000'000);
    device::Servo again = fixture.servo(1);
    QCOMPARE(again.mode()->key, mode);
    QVERIFY(device::switchMode(fixture.context(), again, utf8("position")));
    QCOMPARE(fixture.raw(1, utf8("min_angle_limit")), 200);
    QCOMPARE(fixture.raw(1, utf8("max_angle_limit")), 900);
    QVERIFY(fixture.hasNotice(device::NoticeCode::LimitsRestored));
}

void TestMoves::editingTheModeRegisterIsTheSameProcedure()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("goal_pwm"), 1000);
    fixture.poke(1, utf8("torque_switch"), 1);
    device::Servo servo = fixture.servo(1);
    device::WriteOptions options;
    options.consent = device::Consent::confirmed();
    const auto report =
        device::write(fixture.context(), servo, {{utf8("operating_mode"), 2}}, options);
    QVERIFY(report && report->isSuccessful());
    QCOMPARE(fixture.raw(1, utf8("goal_pwm")), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestMoves::speedIsRestored()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("goal_speed"), 1234);
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("speed")));
    QCOMPARE(fixture.raw(1, utf8("goal_speed")), 0);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("position")));
    QCOMPARE(fixture.raw(1, utf8("goal_speed")), 1234);
}

void TestMoves::pwmNeedsAUnit()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    QVERIFY(device::switchMode(fixture.context(), servo, utf8("pwm")));
    fixture.clearFrames();
    const auto bare = move(fixture, servo, to("500"));
    QVERIFY(!bare);
    QCOMPARE(bare.error().code, ErrorCode::BadArgument);
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY(move(fixture, servo, to("20%")));
    QCOMPARE(fixture.raw(1, utf8("goal_pwm")), 200);
    fixture.runFor(1s);
    // Facts §6.1: +200 turns counter-clockwise, feedback speed negative, load positive.
    QVERIFY(fixture.raw(1, utf8("present_speed")) < 0);
    QVERIFY(fixture.raw(1, utf8("present_load")) > 0);
}

void TestMoves::alarmsShowTheirRemedy_data()
{
    QTest::addColumn<int>("bit");
    QTest::addColumn<base::NoticeCode>("notice");
    QTest::newRow("overload") << 32 << device::NoticeCode::OverloadActive;
    QTest::newRow("current") << 8 << device::NoticeCode::OvercurrentActive;
    QTest::newRow("voltage") << 1 << device::NoticeCode::VoltageAlarmActive;
    QTest::newRow("temperature") << 4 << device::NoticeCode::TemperatureAlarmActive;
    QTest::newRow("sensor") << 2 << device::NoticeCode::SensorAlarmActive;
}

void TestMoves::alarmsShowTheirRemedy()
{
    QFETCH(int, bit);
    QFETCH(base::NoticeCode, notice);
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    servo.status = std::uint8_t(bit);
    device::addAlarmNotices(fixture.context(), servo);
    QCOMPARE(fixture.notices().size(), std::size_t(1));
    QCOMPARE(fixture.notices()[0].code, notice);
}

/// Servos are stopped in turn; one that has lost its power is asked again after the others.
void TestMoves::aSilentServoKeepsNoOtherMoving()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    device::Servo one = fixture.servo(1);
    device::Servo two = fixture.servo(2);
    QVERIFY(device::switchMode(fixture.context(), two, utf8("speed")));
    QVERIFY(move(fixture, two, to("30rpm")));
    fixture.runFor(300ms);
    fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
    const base::Duration began = fixture.clock().now();
    std::optional<base::Duration> stopped;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (!stopped && frame.size() > 4 && frame[2] == 2 && frame[4] == support::Write)
            stopped = fixture.clock().now() - began;
    };
    const auto halted = device::haltAll(fixture.context(), {&one, &two});
    QVERIFY(!halted[0]);
    QVERIFY(halted[1]);
    QVERIFY(stopped);
    QVERIFY2(*stopped < 250ms, qPrintable(QString::number(*stopped / 1ms)));
    QCOMPARE(fixture.raw(2, utf8("goal_speed")), 0);
}

SERVODESK_GUILESS_TEST(TestMoves)
#include "tst_moves.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Moves without surprises: torque-on holds, mode switches are manoeuvres, fields not given are not
// written, and a relative move is never made twice.
#include "device/motion.h"
#include "support/deaf_acks.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <deque>

using base::ErrorCode;
using device::MoveHow;
using device::MoveOrder;
using device::MovePlan;
using device::Torque;
using support::SimBench;
using namespace std::chrono_literals;

namespace {
QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

double shaft(SimBench& bench, int id)
{
    return bench.withWire([id](sim::VirtualBus& wire) { return wire.servo(id)->shaftDegrees(); });
}

bool noted(SimBench& bench, device::NoticeCode code)
{
    for (const device::Notice& notice : bench.notices()) {
        if (notice.code == code)
            return true;
    }
    return false;
}

base::Result<void> move(SimBench& bench, device::Servo& servo, MoveOrder order,
                        MoveHow how = MoveHow::Write)
{
    order.servo = &servo;
    auto plan = device::planMove(bench.context(), order);
    if (!plan)
        return tl::unexpected(plan.error());
    std::vector<MovePlan> plans{*plan};
    return device::sendMoves(bench.context(), plans, how);
}

MoveOrder to(const char* goal)
{
    MoveOrder order;
    order.goal = text(goal);
    return order;
}

/// Addresses the host has written to `id`, byte by byte.
std::set<int> writtenAddresses(SimBench& bench, int id)
{
    std::set<int> addresses;
    for (const base::Bytes& frame : bench.tap().written) {
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
    void init() { QTest::failOnWarning(QRegularExpression(text(".*"))); }

    void torqueOnHolds_data();
    void torqueOnHolds();
    void torqueOnWithUnknownTurnsIsRefused();
    void torqueOnHoldsTurnsThatAreTold();
    void torqueOnWithResolutionFactor();
    void dampingOnlyWhereItExists();
    void onlyGivenFieldsAreWritten_data();
    void onlyGivenFieldsAreWritten();
    void moveArrives_data();
    void moveArrives();
    void motionWithoutTheFlagIsSeen();
    void stoppingTheWaitIsNotStoppingTheServo();
    void losingTheLinkIsNotStoppingTheServos();
    void refusedMoves_data();
    void refusedMoves();
    void timeActsOnScs();
    void stepIsMadeOnce_data();
    void stepIsMadeOnce();
    void lostStepRequestIsSentAgain();
    void servosMoveTogether_data();
    void servosMoveTogether();
    void otherLxServosKeepWhatTheyHold();
    void modeSwitchIsQuiet_data();
    void modeSwitchIsQuiet();
    void aTemporaryModeIsWrittenToBeKept();
    void limitsComeBack_data();
    void limitsComeBack();
    void editingTheModeRegisterIsTheSameManoeuvre();
    void speedForTheWayBack();
    void pwmNeedsAUnit();
    void alarmsNameTheirRelease_data();
    void alarmsNameTheirRelease();
};

void TestMoves::torqueOnHolds_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"position", "speed", "pwm", "step"})
        QTest::newRow(qPrintable(text("STS ") + text(mode))) << text("sts3215@1") << text(mode);
    QTest::newRow("SCS position") << text("scs15@1") << text("position");
    QTest::newRow("SCS motor") << text("scs15@1") << text("motor");
}

void TestMoves::torqueOnHolds()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    SimBench bench(servo);
    // Commands of another life, all of which would move it.
    bench.poke(1, text("goal_speed"), 900);
    device::Servo one = bench.servo(1);
    const auto switched = device::switchMode(bench.context(), one, mode);
    QVERIFY(switched && switched->allGood());
    const double before = shaft(bench, 1);
    const auto on = device::setTorque(bench.context(), one, Torque::On);
    QVERIFY2(on, on ? "" : qPrintable(base::errorName(on.error().code)));
    QCOMPARE(bench.raw(1, text("torque_switch")), 1);
    bench.letTimePass(1s);
    QVERIFY2(std::abs(shaft(bench, 1) - before) < 1.0,
             qPrintable(QString::number(shaft(bench, 1))));
}

void TestMoves::torqueOnWithUnknownTurnsIsRefused()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("phase"), bench.raw(1, text("phase")) & ~16);
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("multiturn")));
    bench.forgetFrames();
    const auto on = device::setTorque(bench.context(), servo, Torque::On);
    QVERIFY(!on);
    QCOMPARE(on.error().code, ErrorCode::TurnsUnknown);
    QVERIFY(bench.onlyAsked());
}

void TestMoves::torqueOnHoldsTurnsThatAreTold()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("phase"), bench.raw(1, text("phase")) | 16);
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("multiturn")));
    QVERIFY(move(bench, servo, to("9000")));
    bench.letTimePass(6s);
    QVERIFY(device::setTorque(bench.context(), servo, Torque::Off));
    const double before = shaft(bench, 1);
    QVERIFY(before > 700);
    QVERIFY(device::setTorque(bench.context(), servo, Torque::On));
    bench.letTimePass(1s);
    QVERIFY(std::abs(shaft(bench, 1) - before) < 1.0);
}

void TestMoves::torqueOnWithResolutionFactor()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("angle_resolution"), 3);
    device::Servo servo = bench.servo(1);
    const double before = shaft(bench, 1);
    QVERIFY(device::setTorque(bench.context(), servo, Torque::On));
    bench.letTimePass(1s);
    // A goal in steps of three can only hold to half of that.
    QVERIFY(std::abs(shaft(bench, 1) - before) < 1.0);
    QVERIFY(std::abs(bench.raw(1, text("goal_position")) * 3 -
                     bench.raw(1, text("present_position"))) <= 6);
}

void TestMoves::dampingOnlyWhereItExists()
{
    SimBench bench(text("sts3215@1,scs15@2,sm40blhv@3:1000000"));
    for (const int id : {1, 2}) {
        device::Servo servo = bench.servo(id);
        QVERIFY(device::setTorque(bench.context(), servo, Torque::Damp));
        QCOMPARE(bench.raw(id, text("torque_switch")), 2);
    }
    device::Servo sms = bench.servo(3);
    const auto damped = device::setTorque(bench.context(), sms, Torque::Damp);
    QVERIFY(!damped);
    QCOMPARE(damped.error().code, ErrorCode::NotSupported);
}

void TestMoves::onlyGivenFieldsAreWritten_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<bool>("speed");
    QTest::addColumn<bool>("acceleration");
    QTest::addColumn<QList<int>>("addresses");
    QTest::newRow("goal alone") << text("sts3215@1") << false << false << QList<int>{42, 43};
    QTest::newRow("goal and speed, 44 untouched")
        << text("sts3215@1") << true << false << QList<int>{42, 43, 46, 47};
    QTest::newRow("goal and acceleration")
        << text("sts3215@1") << false << true << QList<int>{41, 42, 43};
    QTest::newRow("SCS: goal alone") << text("scs15@1") << false << false << QList<int>{42, 43};
    QTest::newRow("SCS: goal and speed")
        << text("scs15@1") << true << false << QList<int>{42, 43, 46, 47};
}

void TestMoves::onlyGivenFieldsAreWritten()
{
    QFETCH(QString, servo);
    QFETCH(bool, speed);
    QFETCH(bool, acceleration);
    QFETCH(QList<int>, addresses);
    SimBench bench(servo);
    bench.poke(1, text("torque_switch"), 1);
    device::Servo one = bench.servo(1);
    bench.forgetFrames();
    MoveOrder order = to("600");
    if (speed)
        order.speed = text("300");
    if (acceleration)
        order.acceleration = text("20");
    QVERIFY(move(bench, one, order));
    QCOMPARE(writtenAddresses(bench, 1), std::set<int>(addresses.begin(), addresses.end()));
}

void TestMoves::moveArrives_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("goal");
    QTest::addColumn<double>("degrees");
    QTest::newRow("STS raw") << text("sts3215@1") << text("3072") << 270.0;
    QTest::newRow("STS degrees") << text("sts3215@1") << text("90deg") << 90.0;
    // SCS15 turns 220° over 1024 steps.
    QTest::newRow("SCS raw") << text("scs15@1") << text("512") << 110.0;
}

void TestMoves::moveArrives()
{
    QFETCH(QString, servo);
    QFETCH(QString, goal);
    QFETCH(double, degrees);
    SimBench bench(servo);
    device::Servo one = bench.servo(1);
    MoveOrder order;
    order.servo = &one;
    order.goal = goal;
    auto plan = device::planMove(bench.context(), order);
    QVERIFY(plan);
    QVERIFY(plan->energises);
    std::vector<MovePlan> plans{*plan};
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    QVERIFY(noted(bench, device::NoticeCode::TorqueSwitchedOn));
    int samples = 0;
    const auto arrived = device::waitForArrival(bench.context(), plans, 10s,
                                                [&](const device::MoveProgress&) { ++samples; });
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
    QVERIFY(samples > 5);
    QVERIFY2(std::abs(shaft(bench, 1) - degrees) < 2.0,
             qPrintable(QString::number(shaft(bench, 1))));
}

/// The goal register holds 0 after power-on; writing 0 again moves, but raises no moving flag.
void TestMoves::motionWithoutTheFlagIsSeen()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    MoveOrder order = to("0");
    order.servo = &servo;
    order.speed = text("10rpm");
    std::vector<MovePlan> plans{*device::planMove(bench.context(), order)};
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    const auto arrived = device::waitForArrival(bench.context(), plans, 30s, {});
    QVERIFY2(arrived, arrived ? "" : qPrintable(arrived.error().detail));
}

void TestMoves::stoppingTheWaitIsNotStoppingTheServo()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    MoveOrder order = to("3072");
    order.servo = &servo;
    order.speed = text("100");
    std::vector<MovePlan> plans{*device::planMove(bench.context(), order)};
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    bench.letTimePass(500ms);
    const auto waited = device::waitForArrival(
        bench.context(), plans, 10s, [&](const device::MoveProgress&) { bench.stop().request(); });
    QVERIFY(!waited);
    QCOMPARE(waited.error().code, ErrorCode::Stopped);
    QVERIFY(noted(bench, device::NoticeCode::StillMoving));
}

void TestMoves::losingTheLinkIsNotStoppingTheServos()
{
    SimBench bench(text("sts3215@1,sts3215@2"));
    std::deque<device::Servo> servos;
    std::vector<MovePlan> plans;
    for (const int id : {1, 2}) {
        servos.push_back(bench.servo(id));
        MoveOrder order = to("3072");
        order.servo = &servos.back();
        order.speed = text("100");
        plans.push_back(*device::planMove(bench.context(), order));
    }
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Write));
    bench.letTimePass(500ms);
    const auto waited =
        device::waitForArrival(bench.context(), plans, 10s, [&](const device::MoveProgress&) {
            bench.wireConfig().faults.muteIds = {1, 2};
        });
    QVERIFY(!waited);
    for (const int id : {1, 2}) {
        const auto& notices = bench.notices();
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
        QTest::newRow(name) << text(servo) << text(goal) << text(speed) << text(acceleration)
                            << text(time) << code;
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
    SimBench bench(servo);
    device::Servo one = bench.servo(1);
    MoveOrder order;
    order.goal = goal;
    if (!speed.isEmpty())
        order.speed = speed;
    if (!acceleration.isEmpty())
        order.acceleration = acceleration;
    if (!time.isEmpty())
        order.time = time;
    const auto moved = move(bench, one, order);
    QVERIFY(!moved);
    QCOMPARE(moved.error().code, code);
    QVERIFY(bench.onlyAsked());
}

void TestMoves::timeActsOnScs()
{
    SimBench bench(text("scs15@1"));
    QVERIFY(bench.raw(1, text("goal_speed")) != 0);
    device::Servo servo = bench.servo(1);
    MoveOrder order = to("512");
    order.time = text("2000");
    QVERIFY(move(bench, servo, order));
    QVERIFY(noted(bench, device::NoticeCode::SpeedZeroForTime));
    bench.letTimePass(1s);
    const double halfway = shaft(bench, 1);
    bench.letTimePass(2s);
    const double end = shaft(bench, 1);
    QVERIFY(std::abs(end - 110.0) < 2.0);
    QVERIFY(std::abs(halfway - end) > 10.0);
}

void TestMoves::stepIsMadeOnce_data()
{
    QTest::addColumn<bool>("acksLost");
    QTest::addColumn<int>("level");
    QTest::addColumn<device::MoveHow>("how");
    for (const auto how : {MoveHow::Write, MoveHow::Sync, MoveHow::Async}) {
        QTest::addRow("clean line, %d", int(how)) << false << 1 << how;
        QTest::addRow("every acknowledgement lost, %d", int(how)) << true << 1 << how;
        QTest::addRow("response level 0, %d", int(how)) << false << 0 << how;
    }
}

void TestMoves::stepIsMadeOnce()
{
    QFETCH(bool, acksLost);
    QFETCH(int, level);
    QFETCH(device::MoveHow, how);
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("response_level"), level);
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("step")));
    if (acksLost)
        support::loseAcknowledgements(bench);
    const double start = shaft(bench, 1);
    // The same quarter turn three times over: equal goals are the hard case.
    for (int i = 1; i <= 3; ++i) {
        const auto moved = move(bench, servo, to("1024"), how);
        QVERIFY2(moved, moved ? "" : qPrintable(base::errorName(moved.error().code)));
        bench.letTimePass(3s);
        QVERIFY2(std::abs(shaft(bench, 1) - start - 90.0 * i) < 4.0,
                 qPrintable(QString::number(shaft(bench, 1) - start)));
    }
}

void TestMoves::lostStepRequestIsSentAgain()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("step")));
    const double start = shaft(bench, 1);
    int goals = 0;
    bench.tap().onWrite = [&](const base::Bytes& frame) {
        const bool goal = frame[4] == support::Write && frame[5] == 42;
        goals += goal ? 1 : 0;
        bench.wireConfig().faults.dropRequest = goal && goals == 1 ? 1.0 : 0.0;
    };
    QVERIFY(move(bench, servo, to("1024")));
    QCOMPARE(goals, 2);
    QVERIFY(noted(bench, device::NoticeCode::AnswerLostSentAgain));
    bench.letTimePass(3s);
    QVERIFY(std::abs(shaft(bench, 1) - start - 90.0) < 4.0);
}

void TestMoves::servosMoveTogether_data()
{
    QTest::addColumn<device::MoveHow>("how");
    QTest::newRow("write") << MoveHow::Write;
    QTest::newRow("sync") << MoveHow::Sync;
    QTest::newRow("async") << MoveHow::Async;
}

void TestMoves::servosMoveTogether()
{
    QFETCH(device::MoveHow, how);
    SimBench bench(text("sts3215@1,sts3250@2,scs15@3"));
    std::vector<device::Servo> servos{bench.servo(1), bench.servo(2), bench.servo(3)};
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        MoveOrder order = to("700");
        order.servo = &servo;
        order.speed = text("400");
        auto plan = device::planMove(bench.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    bench.forgetFrames();
    QVERIFY(device::sendMoves(bench.context(), plans, how));
    // Families of different byte order never share a packet: two kinds, two blocks each.
    QCOMPARE(bench.frames(support::SyncWrite), how == MoveHow::Sync ? 4 : 0);
    QCOMPARE(bench.frames(support::Action), how == MoveHow::Async ? 1 : 0);
    QVERIFY(device::waitForArrival(bench.context(), plans, 20s, {}));
    QVERIFY(std::abs(shaft(bench, 1) - 700 * 360.0 / 4096) < 2.0);
    QVERIFY(std::abs(shaft(bench, 2) - 700 * 360.0 / 4096) < 2.0);
    QVERIFY(std::abs(shaft(bench, 3) - 700 * 220.0 / 1024) < 2.0);
}

/// A third servo holds a goal of another program: the start of two others does not move it.
void TestMoves::otherLxServosKeepWhatTheyHold()
{
    support::BenchOptions options;
    options.baud = 115'200;
    SimBench bench(text("lx16a@1,lx16a@2,lx16a@3"), options);
    std::vector<device::Servo> servos;
    for (const int id : {1, 2, 3})
        servos.push_back(bench.servo(id, base::Protocol::Lx));
    std::vector<double> start;
    std::vector<MovePlan> plans;
    for (device::Servo& servo : servos) {
        QVERIFY(device::setTorque(bench.context(), servo, device::Torque::On));
        start.push_back(shaft(bench, servo.id));
        MoveOrder order = to("300");
        order.servo = &servo;
        auto plan = device::planMove(bench.context(), order);
        QVERIFY(plan);
        plans.push_back(*plan);
    }
    const auto moved = [&](std::size_t place) {
        return std::abs(shaft(bench, servos[place].id) - start[place]);
    };
    std::vector<MovePlan> held{plans.back()};
    plans.pop_back();
    QVERIFY(device::holdMoves(bench.context(), held));
    QVERIFY(device::sendMoves(bench.context(), plans, MoveHow::Async));
    bench.letTimePass(4s);
    QVERIFY(moved(0) > 20 && moved(1) > 20);
    QVERIFY2(moved(2) < 1, qPrintable(QString::number(moved(2))));
    QVERIFY(device::startHeld(bench.context(), held));
    bench.letTimePass(4s);
    QVERIFY2(moved(2) > 20, qPrintable(QString::number(moved(2))));
}

void TestMoves::modeSwitchIsQuiet_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::addColumn<QString>("command");
    QTest::newRow("speed") << text("sts3215@1") << text("speed") << text("goal_speed");
    QTest::newRow("PWM") << text("sts3215@1") << text("pwm") << text("goal_pwm");
    QTest::newRow("SCS motor") << text("scs15@1") << text("motor") << text("goal_time");
}

void TestMoves::modeSwitchIsQuiet()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    QFETCH(QString, command);
    SimBench bench(servo);
    bench.poke(1, text("goal_position"), bench.raw(1, text("present_position")));
    bench.poke(1, text("torque_switch"), 1); // it holds while it is looked at
    bench.poke(1, command, 1000); // full speed, full PWM, or an innocent second of travel time
    device::Servo one = bench.servo(1);
    const double before = shaft(bench, 1);
    const auto switched = device::switchMode(bench.context(), one, mode);
    QVERIFY(switched && switched->allGood());
    QCOMPARE(bench.raw(1, command), 0);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
    QVERIFY(noted(bench, device::NoticeCode::TorqueStaysOff));
    // Somebody else's plain torque-on must be harmless too.
    bench.poke(1, text("torque_switch"), 1);
    bench.letTimePass(1s);
    QVERIFY(std::abs(shaft(bench, 1) - before) < 1.0);
}

void TestMoves::aTemporaryModeIsWrittenToBeKept()
{
    SimBench bench(text("sts3215@1"));
    device::Servo one = bench.servo(1);
    device::WriteOptions options;
    options.temporary = true;
    options.dangerous = true;
    QVERIFY(device::write(bench.context(), one, {{text("operating_mode"), 1}}, options)->allGood());
    const auto switched = device::switchMode(bench.context(), one, text("speed"));
    QVERIFY(switched && switched->allGood());
    QCOMPARE(switched->writes.size(), std::size_t(1));
    QCOMPARE(switched->writes[0].outcome, device::WriteOutcome::Kept);
    QVERIFY(device::switchMode(bench.context(), one, text("speed"))->writes.empty());
    bench.powerCycle();
    QCOMPARE(bench.raw(1, text("operating_mode")), 1);
}

void TestMoves::limitsComeBack_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("mode");
    QTest::newRow("multi-turn") << text("sts3215@1") << text("multiturn");
    QTest::newRow("step") << text("sts3215@1") << text("step");
    QTest::newRow("SCS motor") << text("scs15@1") << text("motor");
}

void TestMoves::limitsComeBack()
{
    QFETCH(QString, servo);
    QFETCH(QString, mode);
    SimBench bench(servo);
    device::Servo one = bench.servo(1);
    QVERIFY(device::write(bench.context(), one,
                          {{text("min_angle_limit"), 200}, {text("max_angle_limit"), 900}}, {}));
    QVERIFY(device::switchMode(bench.context(), one, mode));
    QCOMPARE(bench.raw(1, text("min_angle_limit")), 0);
    QCOMPARE(bench.raw(1, text("max_angle_limit")), 0);
    // A new program on the same journal, the servo freshly powered.
    bench.powerCycle();
    bench.reconnect(1'000'000);
    device::Servo again = bench.servo(1);
    QCOMPARE(again.mode()->key, mode);
    QVERIFY(device::switchMode(bench.context(), again, text("position")));
    QCOMPARE(bench.raw(1, text("min_angle_limit")), 200);
    QCOMPARE(bench.raw(1, text("max_angle_limit")), 900);
    QVERIFY(noted(bench, device::NoticeCode::LimitsRestored));
}

void TestMoves::editingTheModeRegisterIsTheSameManoeuvre()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("goal_pwm"), 1000);
    bench.poke(1, text("torque_switch"), 1);
    device::Servo servo = bench.servo(1);
    device::WriteOptions options;
    options.dangerous = true;
    const auto report =
        device::write(bench.context(), servo, {{text("operating_mode"), 2}}, options);
    QVERIFY(report && report->allGood());
    QCOMPARE(bench.raw(1, text("goal_pwm")), 0);
    QCOMPARE(bench.raw(1, text("torque_switch")), 0);
}

void TestMoves::speedForTheWayBack()
{
    SimBench bench(text("sts3215@1"));
    bench.poke(1, text("goal_speed"), 1234);
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("speed")));
    QCOMPARE(bench.raw(1, text("goal_speed")), 0);
    QVERIFY(device::switchMode(bench.context(), servo, text("position")));
    QCOMPARE(bench.raw(1, text("goal_speed")), 1234);
}

void TestMoves::pwmNeedsAUnit()
{
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    QVERIFY(device::switchMode(bench.context(), servo, text("pwm")));
    bench.forgetFrames();
    const auto bare = move(bench, servo, to("500"));
    QVERIFY(!bare);
    QCOMPARE(bare.error().code, ErrorCode::BadArgument);
    QVERIFY(bench.onlyAsked());
    QVERIFY(move(bench, servo, to("20%")));
    QCOMPARE(bench.raw(1, text("goal_pwm")), 200);
    bench.letTimePass(1s);
    // Facts §6.1: +200 turns counter-clockwise, feedback speed negative, load positive.
    QVERIFY(bench.raw(1, text("present_speed")) < 0);
    QVERIFY(bench.raw(1, text("present_load")) > 0);
}

void TestMoves::alarmsNameTheirRelease_data()
{
    QTest::addColumn<int>("bit");
    QTest::addColumn<base::NoticeCode>("notice");
    QTest::newRow("overload") << 32 << device::NoticeCode::OverloadHolds;
    QTest::newRow("current") << 8 << device::NoticeCode::OvercurrentHolds;
    QTest::newRow("voltage") << 1 << device::NoticeCode::VoltageHolds;
    QTest::newRow("temperature") << 4 << device::NoticeCode::TemperatureHolds;
    QTest::newRow("sensor") << 2 << device::NoticeCode::SensorHolds;
}

void TestMoves::alarmsNameTheirRelease()
{
    QFETCH(int, bit);
    QFETCH(base::NoticeCode, notice);
    SimBench bench(text("sts3215@1"));
    device::Servo servo = bench.servo(1);
    servo.status = std::uint8_t(bit);
    device::noteAlarms(bench.context(), servo);
    QCOMPARE(bench.notices().size(), std::size_t(1));
    QCOMPARE(bench.notices()[0].code, notice);
}

QTEST_GUILESS_MAIN(TestMoves)
#include "tst_moves.moc"

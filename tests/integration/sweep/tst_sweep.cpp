// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep test against simulated servos on a manual clock: what it drives, what it refuses, how
// it ends, and that it never touches EPROM.
#include "device/motion/stop_frames.h"
#include "integration/sweep_support.h"
#include "jobs/sweep/sweep_recording.h"
#include "session/sweep/sweep_report.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numeric>

using base::ErrorCode;
using results::Grade;
using results::SweepEnd;
using results::SweepShape;
using support::SimFixture;
using support::utf8;
using sweep_support::metric;
using sweep_support::run;
using namespace std::chrono_literals;

namespace {
results::SweepSpec sweepSpec(const char* from = "1000", const char* to = "3000")
{
    results::SweepSpec spec;
    spec.range = {utf8(from), utf8(to)};
    spec.pause = 2s;
    spec.cycles = 3;
    spec.speed = utf8("2000");
    spec.acceleration = utf8("50");
    return spec;
}

/// Bytes of EPROM (below 40 on STS and SCS) written since the last clearFrames().
int epromWrites(SimFixture& fixture)
{
    int found = 0;
    for (const base::Bytes& frame : fixture.tap().written) {
        const bool one =
            frame.size() > 5 && (frame[4] == support::Write || frame[4] == support::RegWrite ||
                                 frame[4] == support::SyncWrite);
        found += one && frame[5] < 40 ? 1 : 0;
    }
    return found;
}
} // namespace

class TestSweep : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void aGoodServoPasses_data();
    void aGoodServoPasses();
    void shapes_data();
    void shapes();
    void severalServosTogether();
    void aDelayShorterThanTheMoveMissesTheTarget();
    void testPreconditions_data();
    void testPreconditions();
    void otherModesAreRefused();
    void aJammedServoEndsTheTestWithoutTorque();
    void servoNotReachingTheStartIsReleased();
    void anAlarmEndsTheTest();
    void aSilentSecondIsAGap();
    void aSuspendedProgramFailsNoServo_data();
    void aSuspendedProgramFailsNoServo();
    void aLongSilenceEndsTheTest();
    void aSilenceAfterTheLastLegEndsTheTest_data();
    void aSilenceAfterTheLastLegEndsTheTest();
    void torqueLostInTheLastLegIsDetected();
    void unsafeServosAreReported_data();
    void unsafeServosAreReported();
    void replugIsAGap();
    void stopWhileUnpluggedReleasesLater();
    void aPermanentUnplugEndsTheTest();
    void torqueLostByUnplugStaysOff();
    void torqueLostBeforeMeasuringStaysOff_data();
    void torqueLostBeforeMeasuringStaysOff();
    void replugBeforeMeasuringCostsNothing_data();
    void replugBeforeMeasuringCostsNothing();
    void torqueLostInMotionIsNoStall_data();
    void torqueLostInMotionIsNoStall();
    void torqueLostAtTheStartOfASineStaysOff();
    void aReplacedServoEndsTheTest_data();
    void aReplacedServoEndsTheTest();
    void aReplacementAmidTheCheckEndsTheTest();
    void aGarbledReplyIsNoReplacement();
    void alarmsOfAReplacementServoAreIgnored();
    void missedTargetsOfAReplacementServoAreNoFailure();
    void torqueIsSwitchedOnAtTheStart();
    void stopWhileUnpluggedIsSentFirst();
    void noGoalIsShownBeforeTheFirst();
    void theUserCanStop();
    void theEmergencyStopEndsTheTest();
    void anEmergencyStopIsNoOrdinaryStop();
    void anHourWritesNoEprom();
    void warmUpIsNotMeasured();
    void limitsMoveDuringTheRun();
};

void TestSweep::aGoodServoPasses_data()
{
    QTest::addColumn<QString>("servo");
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("speed");
    QTest::addColumn<QString>("acceleration");
    QTest::addColumn<QString>("time");
    QTest::newRow("STS") << utf8("sts3215@1") << utf8("1000") << utf8("3000") << utf8("2000")
                         << utf8("50") << QString();
    QTest::newRow("STS by degrees") << utf8("sts3215@1") << utf8("90deg") << utf8("180deg")
                                    << utf8("20rpm") << utf8("50") << QString();
    QTest::newRow("SCS") << utf8("scs15@1:1000000") << utf8("300") << utf8("700") << utf8("500")
                         << QString() << QString();
    QTest::newRow("HLS") << utf8("hls3606@1") << utf8("1000") << utf8("3000") << utf8("40")
                         << utf8("50") << QString();
    QTest::newRow("SMCL") << utf8("sm60-360m@1:1000000") << utf8("1000") << utf8("2000")
                          << QString() << QString() << QString();
}

void TestSweep::aGoodServoPasses()
{
    QFETCH(QString, servo);
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, speed);
    QFETCH(QString, acceleration);
    QFETCH(QString, time);
    SimFixture fixture(servo);
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec;
    spec.range = {from, to};
    spec.speed = speed;
    spec.acceleration = acceleration;
    spec.time = time;
    spec.pace = results::SweepPace::Dwell;
    spec.pause = 400ms;
    spec.cycles = 2;
    fixture.clearFrames();
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY2(done,
             done ? "" : qPrintable(base::errorName(done.error().code) + done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    const results::SweepServo& one = done->servos.at(0);
    QCOMPARE(one.legs.size(), std::size_t(4));
    for (const results::SweepLeg& leg : one.legs) {
        QVERIFY(!leg.missed);
        QVERIFY(leg.timeToTarget && leg.reached && leg.steadyError);
        QVERIFY(std::abs(*leg.reached - leg.target) < 12);
        QVERIFY(leg.samples > 20);
    }
    QVERIFY2(done->verdict() != Grade::Fail, "a healthy servo");
    QCOMPARE(*metric(one, "missed_targets"), 0.0);
    QVERIFY(done->sampleRate > 50);
    QCOMPARE(epromWrites(fixture), 0);
    QVERIFY(!one.parameters.registers.empty());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1); // it holds at the end
}

void TestSweep::shapes_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<int>("legs"); ///< of one cycle
    QTest::newRow("sweep") << int(SweepShape::Sweep) << 2;
    QTest::newRow("stairs") << int(SweepShape::Stairs) << 8;
    QTest::newRow("both sides") << int(SweepShape::BothSides) << 4;
    QTest::newRow("random") << int(SweepShape::Random) << 2;
    QTest::newRow("sine") << int(SweepShape::Sine) << 2;
    QTest::newRow("points") << int(SweepShape::Points) << 3;
}

void TestSweep::shapes()
{
    QFETCH(int, shape);
    QFETCH(int, legs);
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.shape = SweepShape(shape);
    spec.step = utf8("500");
    spec.period = 4s;
    spec.points = {{utf8("1000")}, {utf8("2000")}, {utf8("1500")}};
    spec.cycles = 2;
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY2(done,
             done ? "" : qPrintable(base::errorName(done.error().code) + done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    const auto& found = done->servos.at(0).legs;
    QCOMPARE(int(found.size()), 2 * legs);
    for (const results::SweepLeg& leg : found) {
        QVERIFY(!leg.missed);
        QVERIFY(leg.target >= 990 && leg.target <= 3010);
    }
    const bool measuresHysteresis =
        spec.shape == SweepShape::Stairs || spec.shape == SweepShape::BothSides;
    if (measuresHysteresis)
        QVERIFY(metric(done->servos.at(0), "hysteresis").has_value());
    if (spec.shape == SweepShape::Sine)
        QVERIFY(metric(done->servos.at(0), "following_error").has_value());
    if (spec.shape == SweepShape::Sweep)
        QVERIFY(!metric(done->servos.at(0), "hysteresis").has_value());
}

void TestSweep::severalServosTogether()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2,sts3215@3"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2), fixture.servo(3)};
    results::SweepSpec spec = sweepSpec();
    spec.ranges[2] = {utf8("2000"), utf8("2500")};
    fixture.clearFrames();
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(fixture.frames(support::SyncWrite) >= 7);
    QCOMPARE(done->servos.size(), std::size_t(3));
    for (const results::SweepServo& servo : done->servos) {
        QCOMPARE(servo.legs.size(), std::size_t(6));
        QCOMPARE(servo.legs.front().target, servo.parameters.servo.id == 2 ? 2500.0 : 3000.0);
        QCOMPARE(servo.legs.front().at, done->servos.front().legs.front().at);
    }
}

/// The classic mistake: it turns round before it has arrived.
void TestSweep::aDelayShorterThanTheMoveMissesTheTarget()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.pause = 600ms; // 2000 steps at 2000 steps/s
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(*metric(done->servos.at(0), "missed_targets") >= 5);
    QCOMPARE(done->verdict(), Grade::Fail);
}

void TestSweep::testPreconditions_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("code");
    QTest::newRow("same ends") << utf8("same-ends") << int(ErrorCode::BadArgument);
    QTest::newRow("no delay") << utf8("no-pause") << int(ErrorCode::BadArgument);
    QTest::newRow("no end") << utf8("no-end") << int(ErrorCode::BadArgument);
    QTest::newRow("step 0") << utf8("no-step") << int(ErrorCode::BadArgument);
    QTest::newRow("step beyond") << utf8("step-too-long") << int(ErrorCode::BadArgument);
    QTest::newRow("one point") << utf8("no-points") << int(ErrorCode::BadArgument);
    QTest::newRow("no period") << utf8("no-period") << int(ErrorCode::BadArgument);
    QTest::newRow("limits") << QString() << int(ErrorCode::OutOfRange);
    QTest::newRow("no number") << QString() << int(ErrorCode::BadArgument);
}

void TestSweep::testPreconditions()
{
    QFETCH(QString, what);
    QFETCH(int, code);
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("min_angle_limit"), 500);
    fixture.poke(1, utf8("max_angle_limit"), 3500);
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    const QByteArray row = QTest::currentDataTag();
    if (row == "same ends")
        spec.range.to = spec.range.from;
    else if (row == "no delay")
        spec.pause = {};
    else if (row == "no end")
        spec.cycles = 0;
    else if (row.startsWith("step"))
        spec.shape = SweepShape::Stairs, spec.step = row == "step 0" ? utf8("0") : utf8("5000");
    else if (row == "one point")
        spec.shape = SweepShape::Points, spec.points = {{utf8("1000")}};
    else if (row == "no period")
        spec.shape = SweepShape::Sine;
    else if (row == "limits")
        spec.range.to = utf8("3600");
    else
        spec.range.to = utf8("three");
    fixture.clearFrames();
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(!done);
    QCOMPARE(int(done.error().code), code);
    if (!what.isEmpty())
        QCOMPARE(done.error().detail, what);
    QCOMPARE(done.error().id, 1);
    QVERIFY(fixture.onlyReadsSent());
}

void TestSweep::otherModesAreRefused()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("operating_mode"), 1);
    std::vector<device::Servo> servos{fixture.servo(1)};
    fixture.clearFrames();
    const auto done = run(fixture.context(), servos, sweepSpec());
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotSupported);
    QCOMPARE(done.error().detail, utf8("not-position"));
    QCOMPARE(done.error().reason, base::Reason::NotInPositionMode);
    QCOMPARE(done.error().registerKey, utf8("speed"));
    QVERIFY(fixture.onlyReadsSent());
}

void TestSweep::aJammedServoEndsTheTestWithoutTorque()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.stopOnAlarm = false; // what is asked here is whether it sees the stall itself
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            fixture.withBus([](sim::VirtualBus& wire) {
                // 2000 of 4096 steps
                wire.servo(1)->load().stopHigh = 2000.0 / 4096 * 2 * M_PI;
            });
    };
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Stall);
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::Fail);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

/// Nobody may go on pushing after the test has been called off.
void TestSweep::servoNotReachingTheStartIsReleased()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    fixture.withBus(
        [](sim::VirtualBus& wire) { wire.servo(1)->load().stopHigh = 2300.0 / 4096 * 2 * M_PI; });
    results::SweepSpec spec = sweepSpec("3000", "2500");
    spec.stopOnAlarm = false;
    spec.stopOnStall = false;
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(!done);
    QCOMPARE(done.error().detail, utf8("no-start"));
    QCOMPARE(done.error().id, 1);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestSweep::anAlarmEndsTheTest()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 1)
            fixture.withBus([](sim::VirtualBus& wire) { wire.servo(2)->injectStatus(4); });
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Alarm);
    QCOMPARE(done->endedBy, 2);
    QCOMPARE(done->verdict(), Grade::Fail);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1); // stopped where it was, and holds
    QVERIFY(done->servos.at(1).legs.back().alarms != 0);
}

void TestSweep::aSilentSecondIsAGap()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    base::Duration silentUntil{};
    fixture.tap().onWrite = [&](const base::Bytes&) {
        fixture.wireConfig().faults.dropRequest = fixture.clock().now() < silentUntil ? 1.0 : 0.0;
    };
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            silentUntil = fixture.clock().now() + 1500ms;
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->gaps.size(), std::size_t(1));
    const auto span = done->gaps[0].span;
    // A servo that has missed its turns is polled once a second.
    QVERIFY2(span > 1300ms && span < 1500ms + 1100ms, qPrintable(QString::number(span.count())));
    QCOMPARE(done->servos.at(0).legs.size(), std::size_t(6));
    QVERIFY(*metric(done->servos.at(0), "communication_errors") > 0);
}

void TestSweep::aSuspendedProgramFailsNoServo_data()
{
    QTest::addColumn<int>("afterMs"); ///< a goal
    for (const int after : {20, 100, 300, 600, 900})
        QTest::addRow("%d ms", after) << after;
}

/// Ctrl-Z, a laptop's lid: what the servo answered before is taken up 2 s later.
void TestSweep::aSuspendedProgramFailsNoServo()
{
    QFETCH(int, afterMs);
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    std::optional<base::Duration> suspendAt;
    fixture.tap().onWait = [&] {
        if (!suspendAt || fixture.clock().now() < *suspendAt)
            return;
        suspendAt.reset();
        fixture.clock().advance(2s);
    };
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == 3)
            suspendAt = at + std::chrono::milliseconds(afterMs);
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QVERIFY(!suspendAt);
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(done->verdict() == Grade::Pass || done->verdict() == Grade::Warn);
    QCOMPARE(done->gaps.size(), std::size_t(1));
    QVERIFY(done->gaps[0].span >= 1900ms);
}

void TestSweep::aLongSilenceEndsTheTest()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            fixture.wireConfig().faults.dropRequest = 1.0;
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::LinkLost);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QVERIFY(done->servos.at(0).legs.size() >= 2);
    QCOMPARE(done->servos.at(0).legs[0].number, 1);
}

void TestSweep::aSilenceAfterTheLastLegEndsTheTest_data()
{
    QTest::addColumn<int>("silentId"); ///< -1: the whole line
    QTest::addColumn<int>("afterMs");  ///< the last goal
    for (const int id : {-1, 2}) {
        for (const int after : {0, 100, 1900})
            QTest::addRow("%s, %d ms", id < 0 ? "line" : "one servo", after) << id << after;
    }
}

/// What falls silent in the last leg for good has not finished the test.
void TestSweep::aSilenceAfterTheLastLegEndsTheTest()
{
    QFETCH(int, silentId);
    QFETCH(int, afterMs);
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    base::Duration silentFrom = base::Duration::max();
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == 6)
            silentFrom = at + std::chrono::milliseconds(afterMs);
    };
    watch.onProgress = [&](const jobs::SweepProgress&) {
        if (fixture.clock().now() < silentFrom)
            return;
        if (silentId < 0)
            fixture.wireConfig().faults.dropRequest = 1.0;
        else
            fixture.withBus([&](sim::VirtualBus& wire) { wire.unplug(std::size_t(silentId - 1)); });
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::LinkLost);
    QCOMPARE(done->endedBy, silentId < 0 ? 1 : silentId);
    for (const results::SweepServo& servo : done->servos) {
        QCOMPARE(servo.legs.size(), std::size_t(6));
        QCOMPARE(servo.verdict, Grade::NotMeasured);
    }
}

void TestSweep::torqueLostInTheLastLegIsDetected()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    base::Duration replugAt = base::Duration::max();
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg != 6)
            return;
        fixture.wireConfig().faults.dropRequest = 1.0;
        replugAt = at + 3s; // after the last leg
    };
    watch.onProgress = [&](const jobs::SweepProgress&) {
        if (fixture.clock().now() < replugAt)
            return;
        replugAt = base::Duration::max();
        fixture.powerCycle();
        fixture.wireConfig().faults.dropRequest = 0;
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
}

void TestSweep::unsafeServosAreReported_data()
{
    QTest::addColumn<bool>("release");
    QTest::addColumn<bool>("unplugged"); ///< else the line is dumb
    for (const bool release : {false, true}) {
        for (const bool unplugged : {false, true})
            QTest::addRow("%s, %s", release ? "release" : "hold", unplugged ? "plug" : "line")
                << release << unplugged;
    }
}

void TestSweep::unsafeServosAreReported()
{
    QFETCH(bool, release);
    QFETCH(bool, unplugged);
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    results::SweepSpec spec = sweepSpec();
    spec.releaseAtEnd = release;
    std::vector<std::pair<int, bool>> left;
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration) {
        if (leg == 3 && unplugged)
            fixture.cutLink();
        else if (leg == 3)
            fixture.wireConfig().faults.dropRequest = 1.0;
    };
    watch.onUnreleasedTorque = [&](const jobs::UnreleasedTorque& one) {
        left.emplace_back(one.id, one.holding);
    };
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::LinkLost);
    // The one that ended it was to be without torque, the other one as the order says.
    const bool first = !release && unplugged; // the plug is of no servo
    QCOMPARE(left, (std::vector<std::pair<int, bool>>{{1, first}, {2, !release}}));
}

namespace {
/// Pulls the plug in leg 2 and puts it back after a while; `meanwhile` is what happens then.
jobs::SweepCallbacks unplugDuringRun(SimFixture& fixture, base::Duration after,
                                     std::function<void()> meanwhile = {})
{
    jobs::SweepCallbacks watch;
    const auto replugAt = std::make_shared<std::optional<base::Duration>>();
    watch.onGoal = [&fixture, replugAt, after](std::size_t, int leg, base::Duration) {
        if (leg != 2 || *replugAt)
            return;
        fixture.cutLink();
        *replugAt = fixture.clock().now() + after;
    };
    watch.onProgress = [&fixture, replugAt, meanwhile](const jobs::SweepProgress&) {
        if (!*replugAt || fixture.clock().now() < **replugAt)
            return;
        *replugAt = base::Duration::max();
        if (meanwhile)
            meanwhile();
        fixture.clearFrames();
        fixture.restoreLink();
    };
    return watch;
}
} // namespace

void TestSweep::replugIsAGap()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    const auto done = run(fixture.context(), servos, sweepSpec(), unplugDuringRun(fixture, 3s));
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->gaps.size(), std::size_t(1));
    QVERIFY(done->gaps[0].span >= 2900ms && done->gaps[0].span < 4500ms);
    for (const results::SweepServo& servo : done->servos) {
        QCOMPARE(servo.legs.size(), std::size_t(6));
        QVERIFY(servo.legs[1].lost > 0);
        const results::SweepLeg& unseen = servo.legs[1];
        QVERIFY(!unseen.missed && !unseen.timeToTarget && !unseen.settling); // nobody saw it
        QVERIFY(!unseen.meanSpeed && !unseen.topSpeed && !unseen.followingError);
        QVERIFY(!unseen.overshoot && !unseen.overshootSteps);
        const results::SweepLeg& seen = servo.legs[4];
        QVERIFY(seen.timeToTarget && seen.settling && seen.meanSpeed && seen.topSpeed);
        QVERIFY(seen.followingError);
        QCOMPARE(*metric(servo, "missed_targets"), 0.0);
        QVERIFY(!servo.legs[4].missed && servo.legs[4].lost == 0);
        QVERIFY(*metric(servo, "communication_errors") > 0);
    }
    QVERIFY(!fixture.bus().isReconnecting() && !fixture.bus().lost());
    // The patience was the test's: afterwards a pulled plug is a lost link again.
    fixture.cutLink();
    fixture.bus().listen(10ms);
    QVERIFY(fixture.bus().lost());
}

/// What the user stops is to be left safe, also when that can be said only later.
void TestSweep::stopWhileUnpluggedReleasesLater()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.releaseAtEnd = true;
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration) {
        if (leg != 2)
            return;
        fixture.cutLink();
        const base::Duration replugAt = fixture.clock().now() + 1s;
        fixture.tap().onOpen = [&fixture, replugAt] {
            if (fixture.clock().now() >= replugAt)
                fixture.restoreLink();
        };
        fixture.stop().request();
    };
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Stopped);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestSweep::aPermanentUnplugEndsTheTest()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    const auto done = run(fixture.context(), servos, sweepSpec(), unplugDuringRun(fixture, 60s));
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::LinkLost);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QVERIFY(done->length < 20s);
}

void TestSweep::torqueLostByUnplugStaysOff()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    const auto done = run(fixture.context(), servos, sweepSpec(),
                          unplugDuringRun(fixture, 2s, [&] { fixture.powerCycle(); }));
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 0);
    QCOMPARE(fixture.frames(support::SyncWrite), 0); // no goal went out
}

namespace {
/// Pulls the plug so long after the first goal, for 2 s; `meanwhile` is what happens then.
jobs::SweepCallbacks unplugEarly(SimFixture& fixture, base::Duration after,
                                 std::function<void()> meanwhile = {})
{
    jobs::SweepCallbacks watch;
    const auto at = std::make_shared<std::optional<base::Duration>>();
    const auto phase = std::make_shared<int>(0);
    watch.onProgress = [&fixture, at, phase, after,
                        meanwhile](const jobs::SweepProgress& progress) {
        const base::Duration now = fixture.clock().now();
        if (*phase == 0 && progress.warmingUp && fixture.frames(support::SyncWrite) > 0) {
            *at = now + after;
            *phase = 1;
        } else if (*phase == 1 && now >= **at) {
            fixture.cutLink();
            *at = now + 2s;
            *phase = 2;
        } else if (*phase == 2 && now >= **at) {
            if (meanwhile)
                meanwhile();
            fixture.clearFrames();
            fixture.restoreLink();
            *phase = 3;
        }
    };
    return watch;
}

void addEarlyPhases()
{
    QTest::addColumn<int>("after");
    QTest::addColumn<QString>("from");
    QTest::newRow("on the way to the start") << 100 << utf8("1000");
    QTest::newRow("at the start already") << 100 << utf8("2048");
    QTest::newRow("while warming up") << 5000 << utf8("1000");
    QTest::newRow("on the way back from it") << 11'900 << utf8("1000");
}

results::SweepSpec specWithWarmUp(const QString& from)
{
    results::SweepSpec spec = sweepSpec();
    spec.range.from = from;
    spec.warmUp = 10s;
    return spec;
}
} // namespace

void TestSweep::torqueLostBeforeMeasuringStaysOff_data()
{
    addEarlyPhases();
}

void TestSweep::torqueLostBeforeMeasuringStaysOff()
{
    QFETCH(int, after);
    QFETCH(QString, from);
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    fixture.clearFrames();
    const auto done =
        run(fixture.context(), servos, specWithWarmUp(from),
            unplugEarly(fixture, std::chrono::milliseconds(after), [&] { fixture.powerCycle(); }));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QVERIFY(done->servos.at(0).legs.empty());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 0);
    QCOMPARE(fixture.frames(support::SyncWrite), 0); // no goal went out
}

void TestSweep::replugBeforeMeasuringCostsNothing_data()
{
    addEarlyPhases();
}

void TestSweep::replugBeforeMeasuringCostsNothing()
{
    QFETCH(int, after);
    QFETCH(QString, from);
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    fixture.clearFrames();
    const auto done = run(fixture.context(), servos, specWithWarmUp(from),
                          unplugEarly(fixture, std::chrono::milliseconds(after)));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(done->gaps.empty());
    for (const results::SweepServo& servo : done->servos) {
        QCOMPARE(servo.legs.size(), std::size_t(6));
        QCOMPARE(*metric(servo, "missed_targets"), 0.0);
        QCOMPARE(*metric(servo, "communication_errors"), 0.0);
    }
}

/// A silence before its first goal says nothing of the torque: the test is to switch it on.
void TestSweep::torqueLostInMotionIsNoStall_data()
{
    QTest::addColumn<bool>("restarts"); ///< else another program switches it off
    QTest::addColumn<int>("inLeg");
    QTest::addColumn<int>("afterMs"); ///< its goal
    QTest::addColumn<bool>("dwells");
    for (const int after : {50, 600}) {
        for (const bool dwells : {false, true}) {
            const char* pace = dwells ? "dwell" : "delay";
            QTest::addRow("restarts, %s, %d ms", pace, after) << true << 3 << after << dwells;
            QTest::addRow("switched off, %s, %d ms", pace, after) << false << 3 << after << dwells;
            QTest::addRow("restarts in the last leg, %s, %d ms", pace, after)
                << true << 6 << after << dwells;
            QTest::addRow("switched off in the last leg, %s, %d ms", pace, after)
                << false << 6 << after << dwells;
        }
    }
    for (const int after : {1200, 1900}) {
        QTest::addRow("switched off at rest, %d ms", after) << false << 3 << after << false;
        QTest::addRow("restarts at rest, %d ms", after) << true << 3 << after << false;
    }
    QTest::newRow("switched off at the end") << false << 6 << 1900 << false;
}

void TestSweep::torqueLostInMotionIsNoStall()
{
    QFETCH(bool, restarts);
    QFETCH(int, inLeg);
    QFETCH(int, afterMs);
    QFETCH(bool, dwells);
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    std::optional<base::Duration> offAt;
    fixture.tap().onWait = [&] {
        if (!offAt || fixture.clock().now() < *offAt)
            return;
        offAt.reset();
        if (restarts)
            fixture.powerCycle();
        else
            fixture.poke(1, utf8("torque_switch"), 0);
    };
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == inLeg)
            offAt = at + std::chrono::milliseconds(afterMs);
    };
    results::SweepSpec spec = sweepSpec();
    if (dwells) {
        spec.pace = results::SweepPace::Dwell;
        spec.pause = 300ms;
    }
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(!offAt);
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);     // no goal has switched it on again
    QVERIFY(int(done->servos.front().legs.size()) < inLeg); // torque may have been off in that leg
}

void TestSweep::torqueLostAtTheStartOfASineStaysOff()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.shape = SweepShape::Sine;
    spec.period = 4s;
    bool off = false;
    jobs::SweepCallbacks watch;
    watch.onProgress = [&](const jobs::SweepProgress& progress) {
        const auto away = std::abs(fixture.raw(1, utf8("present_position")) - 1000);
        if (off || !progress.warmingUp || away > 10)
            return;
        off = true;
        fixture.poke(1, utf8("torque_switch"), 0);
    };
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(off);
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QVERIFY(done->servos.front().legs.empty());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

namespace {
/// An STS3215 that is exchanged for an STS3250 with its ID.
struct ReplacementFixture : SimFixture {
    ReplacementFixture()
        : SimFixture(utf8("sts3215@1,sts3250@1"))
    {
        withBus([](sim::VirtualBus& wire) { wire.unplug(1); });
        servos = {servo(1)};
        tap().onWait = [this] { step(); };
    }
    /// `silence` long nobody is on the line.
    void exchange(base::Duration at, base::Duration silence)
    {
        outAt = at;
        inAt = at + silence;
    }
    void step()
    {
        if (clock().now() >= outAt) {
            outAt = base::Duration::max();
            withBus([](sim::VirtualBus& wire) { wire.unplug(0); });
        }
        if (outAt == base::Duration::max() && clock().now() >= inAt) {
            inAt = base::Duration::max();
            clearFrames();
            withBus([this](sim::VirtualBus& wire) {
                wire.plug(1);
                if (onPlug)
                    onPlug(*wire.servos()[1]);
            });
        }
    }
    std::int64_t replacementTorque()
    {
        return withBus(
            [](sim::VirtualBus& wire) { return wire.servos()[1]->raw(utf8("torque_switch")); });
    }

    std::vector<device::Servo> servos;
    std::function<void(sim::VirtualServo&)> onPlug{};
    base::Duration outAt = base::Duration::max();
    base::Duration inAt = base::Duration::max();
};
} // namespace

void TestSweep::aReplacedServoEndsTheTest_data()
{
    QTest::addColumn<int>("inLeg"); ///< 0: before the first goal
    QTest::addColumn<int>("afterMs");
    QTest::addColumn<int>("silenceMs");
    QTest::addColumn<bool>("sine");
    for (const int silence : {0, 60, 1500}) {
        QTest::addRow("before the first goal, %d ms", silence) << 0 << 0 << silence << false;
        QTest::addRow("on its way, %d ms", silence) << 3 << 50 << silence << false;
        QTest::addRow("at rest, %d ms", silence) << 3 << 1900 << silence << false;
        QTest::addRow("at the end, %d ms", silence) << 6 << 1900 << silence << false;
    }
    QTest::newRow("in a sine, 200 ms") << 3 << 400 << 200 << true;
    QTest::newRow("in a sine, 1500 ms") << 3 << 400 << 1500 << true;
    QTest::newRow("in the last leg of a sine") << 6 << 400 << 0 << true;
}

void TestSweep::aReplacedServoEndsTheTest()
{
    QFETCH(int, inLeg);
    QFETCH(int, afterMs);
    QFETCH(int, silenceMs);
    QFETCH(bool, sine);
    ReplacementFixture fixture;
    const auto exchangeAt = [&](base::Duration at) {
        fixture.exchange(at + std::chrono::milliseconds(afterMs),
                         std::chrono::milliseconds(silenceMs));
    };
    jobs::SweepCallbacks watch;
    watch.onBegin = [&](const results::SweepRun&) -> std::optional<base::Error> {
        if (inLeg == 0)
            exchangeAt(fixture.clock().now());
        fixture.step();
        return {};
    };
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == inLeg)
            exchangeAt(at);
    };
    std::vector<int> left;
    watch.onUnreleasedTorque = [&](const jobs::UnreleasedTorque& one) { left.push_back(one.id); };
    results::SweepSpec spec = sweepSpec();
    spec.shape = sine ? SweepShape::Sine : SweepShape::Sweep;
    spec.period = 4s;
    const auto done = run(fixture.context(), fixture.servos, spec, watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(fixture.inAt, base::Duration::max()); // it has happened
    QCOMPARE(results::sweepEndName(done->end), utf8("exchanged"));
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(fixture.replacementTorque(), 0);
    QVERIFY(sine || fixture.onlyReadsSent());
    QCOMPARE(left, std::vector<int>{});
    QVERIFY(inLeg == 0 || int(done->servos.front().legs.size()) < inLeg);
}

/// After it has been asked who it is, before it is asked for its torque.
void TestSweep::aReplacementAmidTheCheckEndsTheTest()
{
    ReplacementFixture fixture;
    const base::Bytes readTorque{0xFF, 0xFF, 1, 4, 2, 40, 1, 0xCF};
    int reached = 0;
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration) { reached = leg; };
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        if (reached == 3 && frame == readTorque && fixture.outAt == base::Duration::max()) {
            fixture.exchange({}, {});
            fixture.step();
        }
    };
    const auto done = run(fixture.context(), fixture.servos, sweepSpec(), watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(results::sweepEndName(done->end), utf8("exchanged"));
    QCOMPARE(done->endedBy, 1);
    QCOMPARE(fixture.replacementTorque(), 0);
    QVERIFY(fixture.onlyReadsSent());
}

/// One that names another model, and has a check sum that fits.
void TestSweep::aGarbledReplyIsNoReplacement()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    int disturbed = 0;
    bool due = false;
    fixture.tap().replyOverride = [&](const base::Bytes& frame) -> std::optional<base::Bytes> {
        const bool isIdentityRead = frame[4] == support::Read && frame[5] == 0 && frame[6] == 9;
        if (!isIdentityRead || !std::exchange(due, false))
            return std::nullopt;
        ++disturbed;
        base::Bytes reply{0xFF, 0xFF, 1, 11, 0, 3, 10, 0, 9, 99, 1, 0, 0, 1};
        const int sum = std::accumulate(reply.begin() + 2, reply.end(), 0);
        reply.push_back(std::uint8_t(~sum));
        return reply;
    };
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int, base::Duration) { due = true; };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(disturbed, 6);
    QCOMPARE(done->servos.front().legs.size(), std::size_t(6));
}

void TestSweep::alarmsOfAReplacementServoAreIgnored()
{
    ReplacementFixture fixture;
    fixture.onPlug = [](sim::VirtualServo& servo) {
        servo.poke(utf8("max_voltage"), 50); // less than its supply
    };
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == 3)
            fixture.exchange(at + 100ms, 100ms);
    };
    const auto done = run(fixture.context(), fixture.servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::ServoReplaced);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
}

/// In a test that is to end at the first failure.
void TestSweep::missedTargetsOfAReplacementServoAreNoFailure()
{
    ReplacementFixture fixture;
    jobs::SweepCallbacks watch;
    watch.onGoal = [&](std::size_t, int leg, base::Duration at) {
        if (leg == 4)
            fixture.exchange(at + 20ms, 20ms);
    };
    results::SweepSpec spec = sweepSpec();
    spec.stopOnFailure = true;
    spec.stopOnStall = false;
    const auto done = run(fixture.context(), fixture.servos, spec, watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::ServoReplaced);
    QCOMPARE(done->verdict(), Grade::NotMeasured);
    QCOMPARE(done->servos.front().legs.size(), std::size_t(3));
}

void TestSweep::torqueIsSwitchedOnAtTheStart()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    jobs::SweepCallbacks watch;
    base::Duration replugAt{};
    watch.onBegin = [&](const results::SweepRun&) -> std::optional<base::Error> {
        fixture.wireConfig().faults.dropRequest = 1.0;
        replugAt = fixture.clock().now() + 1500ms;
        return {};
    };
    fixture.tap().onWrite = [&](const base::Bytes&) {
        if (replugAt > 0s && fixture.clock().now() >= replugAt)
            fixture.wireConfig().faults.dropRequest = 0;
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(fixture.clock().now() > replugAt);
}

void TestSweep::stopWhileUnpluggedIsSentFirst()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    const auto done = run(fixture.context(), servos, sweepSpec(),
                          unplugDuringRun(fixture, 1s, [&] { fixture.bus().emergency(); }));
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Emergency);
    fixture.bus().pauseUntil(fixture.clock().now() + 1s, nullptr);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 0);
    const auto frames = device::stopFrames({base::Protocol::Feetech}, servos);
    QVERIFY(!fixture.tap().written.empty());
    QCOMPARE(fixture.tap().written.front(), frames.front().bytes);
}

/// A 0 there would be a goal far outside of the range, and the charts would have to show it.
void TestSweep::noGoalIsShownBeforeTheFirst()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    const results::SweepSpec spec = sweepSpec();
    std::unique_ptr<jobs::SweepRecording> readings;
    jobs::SweepCallbacks watch;
    watch.onBegin = [&](const results::SweepRun& begun) -> std::optional<base::Error> {
        auto made = jobs::SweepRecording::start(begun, {});
        if (!made)
            return made.error();
        readings = std::move(*made);
        return std::nullopt;
    };
    watch.onSample = [&](std::size_t servo, const jobs::SweepSample& sample, double goal, int leg) {
        readings->add(servo, sample, goal, leg);
    };
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY(done);
    const recording::SampleStore& store = readings->store();
    const auto span = store.span();
    QVERIFY(span);
    const auto goals = store.range(readings->goals(0), *span);
    QVERIFY(goals);
    QCOMPARE(goals->first, spec.range.from.toDouble());
    QCOMPARE(goals->second, spec.range.to.toDouble());
    QVERIFY(store.span(readings->positions(0))->from < store.span(readings->goals(0))->from);

    const QTemporaryDir folder;
    const QString page = folder.filePath(utf8("sweep.html"));
    QVERIFY(session::saveSweepReport(*done, *readings, session::SweepFormat::Html, false, page));
    QFile file(page);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString html = QString::fromUtf8(file.readAll());
    const QRegularExpression start(utf8("<path d=\"M([0-9.]+) "));
    const auto goal = start.match(html); // the position is drawn above it
    QVERIFY(goal.hasMatch());
    const auto position = start.match(html, goal.capturedEnd());
    QVERIFY(position.hasMatch());
    QVERIFY(position.captured(1).toDouble() < goal.captured(1).toDouble());
}

void TestSweep::theUserCanStop()
{
    for (const bool release : {false, true}) {
        SimFixture fixture(utf8("sts3215@1"));
        std::vector<device::Servo> servos{fixture.servo(1)};
        results::SweepSpec spec = sweepSpec();
        spec.releaseAtEnd = release;
        jobs::SweepCallbacks watch;
        int samples = 0;
        watch.onSample = [&](std::size_t, const jobs::SweepSample&, double, int leg) {
            if (leg == 2 && ++samples == 50)
                fixture.stop().request();
        };
        const auto done = run(fixture.context(), servos, spec, watch);
        QVERIFY(done);
        QCOMPARE(done->end, SweepEnd::Stopped);
        QCOMPARE(done->verdict(), Grade::NotMeasured);
        QCOMPARE(fixture.raw(1, utf8("torque_switch")), release ? 0 : 1);
        const auto before = fixture.raw(1, utf8("present_position"));
        fixture.runFor(2s);
        QVERIFY(std::abs(fixture.raw(1, utf8("present_position")) - before) < 60); // it has stopped
    }
}

void TestSweep::theEmergencyStopEndsTheTest()
{
    SimFixture fixture(utf8("sts3215@1,sts3215@2"));
    std::vector<device::Servo> servos{fixture.servo(1), fixture.servo(2)};
    fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    jobs::SweepCallbacks watch;
    int samples = 0;
    watch.onSample = [&](std::size_t, const jobs::SweepSample&, double, int leg) {
        if (leg == 2 && ++samples == 50)
            fixture.bus().emergency();
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Emergency);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(2, utf8("torque_switch")), 0);
}

/// As the window does it: the job is asked to stop as well, here while it waits for the answer to a
/// read of the torque switch, which comes before every goal.
void TestSweep::anEmergencyStopIsNoOrdinaryStop()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    jobs::SweepCallbacks watch;
    int latestLeg = 0;
    watch.onSample = [&](std::size_t, const jobs::SweepSample&, double, int leg) {
        latestLeg = leg;
    };
    bool isStopped = false;
    fixture.tap().onWait = [&] {
        const base::Bytes& frame = fixture.tap().written.back();
        const bool readsTorque = frame.size() > 6 && frame[4] == 0x02 && frame[5] == 40;
        if (latestLeg < 2 || !readsTorque || std::exchange(isStopped, true))
            return;
        fixture.bus().requestEmergency();
        fixture.stop().request();
    };
    const auto done = run(fixture.context(), servos, sweepSpec(), watch);
    QVERIFY(isStopped);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Emergency);
}

void TestSweep::anHourWritesNoEprom()
{
    // A slow line has fewer readings to work out.
    SimFixture fixture(utf8("sts3215@1"), {.baud = 57'600, .servoBaud = 57'600});
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.cycles = 0;
    spec.length = 1h;
    fixture.clearFrames();
    const auto eprom =
        fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->epromImage(); });
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::Finished);
    QVERIFY(done->servos.at(0).legs.size() >= 1795);
    QCOMPARE(epromWrites(fixture), 0);
    const auto after =
        fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->epromImage(); });
    QVERIFY(eprom == after);
    // Delays do not add up with the time that sending takes.
    const auto& legs = done->servos.at(0).legs;
    QVERIFY(legs.back().at - legs.front().at < 2s * int(legs.size() - 1) + 100ms);
}

void TestSweep::warmUpIsNotMeasured()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    results::SweepSpec spec = sweepSpec();
    spec.warmUp = 10s;
    const base::Duration before = fixture.clock().now();
    const auto done = run(fixture.context(), servos, spec);
    QVERIFY(done);
    QCOMPARE(done->servos.at(0).legs.size(), std::size_t(6));
    QVERIFY(done->length < 12500ms);
    QVERIFY(fixture.clock().now() - before > 22s);
}

/// Another program narrows the limits: goals are refused, and the test says so.
void TestSweep::limitsMoveDuringTheRun()
{
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    jobs::SweepCallbacks watch;
    watch.onLeg = [&](std::size_t, const results::SweepLeg& leg) {
        if (leg.number == 2)
            fixture.poke(1, utf8("max_angle_limit"), 2000);
    };
    results::SweepSpec spec = sweepSpec();
    spec.stopOnStall = false;
    const auto done = run(fixture.context(), servos, spec, watch);
    QVERIFY(done);
    // The servo itself keeps to its new limit, so the targets beyond are missed.
    QCOMPARE(done->verdict(), Grade::Fail);
}

SERVODESK_GUILESS_TEST(TestSweep)
#include "tst_sweep.moc"

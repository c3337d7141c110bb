// SPDX-License-Identifier: GPL-3.0-or-later
// The step-response lab against simulated servos: its figures are those of a twin that is moved
// without a bus, gains act during a run and are back after it however it ends, the EPROM sees
// nothing, and the advice is that of the sheet.
#include "device/motion/motion.h"
#include "device/motion/stop_frames.h"
#include "jobs/recover/recover.h"
#include "jobs/step/step_advice.h"
#include "jobs/step/step_response.h"
#include "results/step_json.h"
#include "support/servo_plant.h"
#include "support/sim_fixture.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

using base::ErrorCode;
using results::SweepEnd;
using support::SimFixture;
using support::utf8;
using namespace std::chrono_literals;

namespace {
jobs::StepRequest order(const char* size = "400", std::vector<results::StepGain> trial = {})
{
    jobs::StepRequest order;
    order.spec.size = utf8(size);
    order.spec.repeats = 2;
    order.spec.trial = std::move(trial);
    return order;
}

base::Result<results::StepRun> run(SimFixture& fixture, const jobs::StepRequest& order,
                                   const jobs::StepCallbacks& watch = {})
{
    device::Servo servo = fixture.servo(1);
    return jobs::stepResponse(fixture.context(), servo, order, watch);
}

base::Bytes eprom(SimFixture& fixture)
{
    return fixture.withBus([](sim::VirtualBus& wire) { return wire.servo(1)->epromImage(); });
}

/// What the twin's shaft did on its way from here to there, by plain arithmetic on its encoder.
struct Truth {
    double rise = 0;           ///< ms
    double peakBeyondGoal = 0; ///< steps past the place of rest
    double restPosition = 0;
    int turns = 0; ///< by more than six steps, after it first was near
    double hertz = 0;
};

Truth groundTruth(const std::vector<results::StepGain>& gains, std::int64_t from, std::int64_t to)
{
    SimFixture fixture(utf8("sts3215@1"));
    for (const results::StepGain& gain : gains)
        fixture.poke(1, gain.key, gain.raw);
    return fixture.withBus([&](sim::VirtualBus& wire) {
        probe::ServoPlant plant(*wire.servo(1));
        wire.servo(1)->poke(utf8("acceleration"), 0);
        (void)plant.move(from, 2000ms);
        const probe::Move move = plant.move(to, 1500ms);
        Truth truth;
        truth.restPosition = move.restPosition();
        int low = 0;
        int high = 0;
        int arrived = 0;
        for (std::size_t i = 0; i < move.samples.size(); ++i) {
            const double gone = double(move.samples[i].reported - move.start) / move.way();
            const int ms = int(i) + 1;
            low = low == 0 && gone >= 0.1 ? ms : low;
            high = high == 0 && gone >= 0.9 ? ms : high;
            const double left = std::abs(double(move.samples[i].reported - move.goal));
            arrived = arrived == 0 && left <= 12 ? ms : arrived;
        }
        truth.rise = high - low;
        truth.peakBeyondGoal = std::max(
            0.0, move.peakBeyondGoal() - move.direction() * (move.restPosition() - double(to)));
        double extreme = -HUGE_VAL;
        double direction = move.direction();
        int at = 0;
        int first = 0;
        int last = 0;
        for (int i = arrived; i < int(move.samples.size()); ++i) {
            const double place = direction * double(move.samples[std::size_t(i)].reported);
            at = place > extreme ? i : at;
            extreme = std::max(extreme, place);
            if (extreme - place < 6)
                continue;
            ++truth.turns;
            first = first == 0 ? at : first;
            last = at;
            direction = -direction;
            extreme = -place;
            at = i;
        }
        truth.hertz = truth.turns > 2 ? (truth.turns - 1) / 2.0 / (last - first) * 1000 : 0;
        return truth;
    });
}

/// Where one servo has been between two goals, by what its register showed, past the wire.
struct StepLeg {
    std::int64_t goal = 0;
    std::int64_t low = 0;
    std::int64_t high = 0;

    double peakBeyondGoal(bool upwards) const { return double(upwards ? high - goal : goal - low); }
};

/// With every frame, so as often as anybody on the wire could.
void lookAt(std::vector<StepLeg>& legs, SimFixture& fixture)
{
    const std::int64_t goal = fixture.raw(1, utf8("goal_position"));
    const std::int64_t position = fixture.raw(1, utf8("present_position"));
    if (legs.empty() || legs.back().goal != goal)
        legs.push_back({goal, position, position});
    legs.back().low = std::min(legs.back().low, position);
    legs.back().high = std::max(legs.back().high, position);
}

bool advises(const std::vector<results::StepAdvice>& advice, results::StepRemedy remedy)
{
    return std::any_of(advice.begin(), advice.end(),
                       [remedy](const results::StepAdvice& one) { return one.remedy == remedy; });
}
} // namespace

class TestStepResponse : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void metricsMatchTheReferenceServo_data();
    void metricsMatchTheReferenceServo();
    void unsupportedMeasurementsAreOmitted();
    void startsWhereThereIsRoom_data();
    void startsWhereThereIsRoom();
    void speedAndAccelerationAreRestored();
    void gainsAreAlwaysRestored_data();
    void gainsAreAlwaysRestored();
    void aLostLinkIsFoundByRecovery();
    void aSilenceInTheLastResponseEndsIt_data();
    void aSilenceInTheLastResponseEndsIt();
    void unobservedValuesAreNotMeasured_data();
    void unobservedValuesAreNotMeasured();
    void replugCostsOneResponse();
    void servoRestartedByReplugStaysOffWithItsOwnGains_data();
    void servoRestartedByReplugStaysOffWithItsOwnGains();
    void nothingIsRestoredToAReplacedServo();
    void stopWhileUnpluggedRestoresGainsLater();
    void unplugWhileSettingGainsLeavesNothingBehind();
    void gainsLostBeforeTheFirstStepAreNoTrial();
    void interruptedTrialGainsAreNotTheBaseline();
    void modeIsSwitchedOnRequest();
    void preconditions_data();
    void preconditions();
    void adviceFollowsTheDataSheet_data();
    void adviceFollowsTheDataSheet();
    void aKnownOvershootIsMeasured();
    void aStationaryServoGetsNoGains();
    void aServoAtAHardStopGetsNoGains();
    void aRunRoundTripsThroughItsFile();
    void scatterIsNoDifference();
};

void TestStepResponse::metricsMatchTheReferenceServo_data()
{
    QTest::addColumn<int>("p");
    QTest::addColumn<int>("d");
    QTest::addColumn<int>("i");
    QTest::newRow("as it comes") << 32 << 32 << 0;
    QTest::newRow("weak") << 14 << 8 << 0;
    QTest::newRow("undamped") << 120 << 0 << 0;
    QTest::newRow("oscillating") << 200 << 0 << 0;
    QTest::newRow("too much I") << 32 << 32 << 20;
}

void TestStepResponse::metricsMatchTheReferenceServo()
{
    QFETCH(int, p);
    QFETCH(int, d);
    QFETCH(int, i);
    const std::vector<results::StepGain> gains{
        {utf8("position_p"), p}, {utf8("position_d"), d}, {utf8("position_i"), i}};
    support::SimFixtureOptions options;
    options.wire.identicalServos = true; // as in groundTruth()
    SimFixture fixture(utf8("sts3215@1"), options);
    jobs::StepRequest asked = order("400", gains);
    asked.spec.from = utf8("1800");
    asked.spec.hold = 1500ms;
    fixture.runFor(1ms); // the rise is found to one reading, by where the readings fall
    const auto before = eprom(fixture);
    std::vector<StepLeg> legs;
    fixture.tap().onWrite = [&](const base::Bytes&) { lookAt(legs, fixture); };
    const auto done = run(fixture, asked);
    fixture.tap().onWrite = nullptr;
    QVERIFY2(done,
             done ? "" : qPrintable(base::errorName(done.error().code) + done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->responses.size(), std::size_t(4));
    const auto first =
        std::find_if(legs.begin(), legs.end(), [](const StepLeg& leg) { return leg.goal == 2200; });
    QVERIFY(legs.end() - first >= 4);
    QVERIFY(before == eprom(fixture));
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    for (const results::StepResponse& response : done->responses) {
        const bool there = response.number % 2 == 1;
        const Truth truth = there ? groundTruth(gains, 1800, 2200) : groundTruth(gains, 2200, 1800);
        const results::StepFigures& found = response.figures;
        QCOMPARE(response.target, there ? 2200.0 : 1800.0);
        QVERIFY(found.riseTime && found.deadTime && found.peakSpeed && found.peakCurrent);
        QVERIFY2(std::abs(*found.riseTime - truth.rise) <= 4,
                 qPrintable(QStringLiteral("%1 %2").arg(*found.riseTime).arg(truth.rise)));
        QVERIFY(*found.deadTime > 0 && *found.deadTime < 60);
        QVERIFY(found.swings);
        QVERIFY2(std::abs(*found.swings - truth.turns) <=
                     (p == 200 ? 3 : 1), // noise decides when it ends
                 qPrintable(QStringLiteral("%1 %2").arg(*found.swings).arg(truth.turns)));
        QCOMPARE(found.swingFrequency.has_value(), *found.swings >= 3);
        if (found.swingFrequency && truth.turns >= 3)
            QVERIFY2(
                std::abs(*found.swingFrequency / truth.hertz - 1) < 0.15,
                qPrintable(QStringLiteral("%1 %2").arg(*found.swingFrequency).arg(truth.hertz)));
        if (found.steadyError)
            QVERIFY(std::abs(response.target + *found.steadyError - truth.restPosition) <= 2);
        if (found.overshootSteps && truth.peakBeyondGoal > 6) {
            // By its own way; and by that of any of its kind, unless it swings already when it is
            // sent off and goes as far as that happens to take it.
            const StepLeg& leg = first[response.number - 1];
            QCOMPARE(double(leg.goal), response.target);
            const double own =
                leg.peakBeyondGoal(there) - (there ? 1 : -1) * found.steadyError.value_or(0);
            QVERIFY2(std::abs(*found.overshootSteps - own) <= 2,
                     qPrintable(QStringLiteral("%1 %2").arg(*found.overshootSteps).arg(own)));
            const double kind = truth.peakBeyondGoal;
            QVERIFY2(p == 200 || std::abs(*found.overshootSteps - kind) <= 4,
                     qPrintable(QStringLiteral("%1 %2").arg(*found.overshootSteps).arg(kind)));
        }
    }
    QCOMPARE(done->gains.front().raw, p);
    QVERIFY(done->sampleRate > 300);
}

void TestStepResponse::unsupportedMeasurementsAreOmitted()
{
    SimFixture fixture(utf8("lx16a@1"), {.baud = 115'200});
    device::Servo servo = fixture.servo(1, base::Protocol::Lx);
    const auto done = jobs::stepResponse(fixture.context(), servo, order("100"), {});
    QVERIFY(done);
    QVERIFY(done->gains.empty());
    QVERIFY(!done->mean.peakCurrent && !done->mean.peakLoad);
    QVERIFY(done->mean.riseTime && done->mean.steadyError);
    QVERIFY(!done->mean.swingFrequency);
}

void TestStepResponse::startsWhereThereIsRoom_data()
{
    QTest::addColumn<int>("stands");
    QTest::addColumn<QString>("size");
    QTest::addColumn<int>("from");
    QTest::newRow("present position") << 2048 << utf8("300") << 2048;
    QTest::newRow("downwards") << 2048 << utf8("-300") << 2048;
    QTest::newRow("degrees") << 2048 << utf8("45deg") << 2048;
    QTest::newRow("no room above") << 2800 << utf8("500") << 2500;
    QTest::newRow("no room below") << 1100 << utf8("-500") << 1500;
}

void TestStepResponse::startsWhereThereIsRoom()
{
    QFETCH(int, stands);
    QFETCH(QString, size);
    QFETCH(int, from);
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("min_angle_limit"), 1000);
    fixture.poke(1, utf8("max_angle_limit"), 3000);
    fixture.poke(1, utf8("goal_position"), stands);
    fixture.runFor(2s);
    device::Servo servo = fixture.servo(1);
    fixture.clearFrames();
    jobs::StepRequest asked = order();
    asked.spec.size = size;
    const auto plan = jobs::planStep(fixture.context(), servo, asked.spec);
    QVERIFY(plan);
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY2(std::abs(plan->from - from) <= 4, qPrintable(QString::number(plan->from)));
    QVERIFY(plan->to >= 1000 && plan->to <= 3000);
    QVERIFY(plan->hold >= 500ms);
    asked.spec.hold = 60ms;
    asked.spec.speed = utf8("100");
    const auto hurried = jobs::planStep(fixture.context(), servo, asked.spec);
    QVERIFY(hurried && hurried->isHoldTooShort);
}

/// They are its own, though they are lost at power-off: the next move must not be a surprise.
void TestStepResponse::speedAndAccelerationAreRestored()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("goal_speed"), 321);
    fixture.poke(1, utf8("acceleration"), 7);
    QVERIFY(run(fixture, order()));
    QCOMPARE(fixture.raw(1, utf8("goal_speed")), 321);
    QCOMPARE(fixture.raw(1, utf8("acceleration")), 7);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1);
}

void TestStepResponse::gainsAreAlwaysRestored_data()
{
    QTest::addColumn<QString>("how");
    QTest::addColumn<int>("end");
    QTest::newRow("stop") << utf8("stop") << int(SweepEnd::Stopped);
    QTest::newRow("emergency") << utf8("emergency") << int(SweepEnd::Emergency);
    QTest::newRow("alarm") << utf8("alarm") << int(SweepEnd::Alarm);
}

void TestStepResponse::gainsAreAlwaysRestored()
{
    QFETCH(QString, how);
    QFETCH(int, end);
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<device::Servo> servos{fixture.servo(1)};
    fixture.bus().setStopFrames(device::stopFrames({base::Protocol::Feetech}, servos));
    const auto before = eprom(fixture);
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& response) {
        if (response.number != 1)
            return;
        QCOMPARE(fixture.raw(1, utf8("position_p")), 20);
        if (how == QLatin1StringView("stop"))
            fixture.stop().request();
        else if (how == QLatin1StringView("emergency"))
            fixture.bus().emergency();
        else
            fixture.withBus([](sim::VirtualBus& wire) { wire.servo(1)->injectStatus(4); });
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY(done);
    QCOMPARE(int(done->end), end);
    QVERIFY(done->isReverted);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QVERIFY(fixture.journal().open()->empty());
    QVERIFY(before == eprom(fixture));
    if (how != QLatin1StringView("stop"))
        QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
}

void TestStepResponse::aLostLinkIsFoundByRecovery()
{
    SimFixture fixture(utf8("sts3215@1"));
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& response) {
        if (response.number == 2)
            fixture.cutLink();
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY(done);
    QCOMPARE(done->end, SweepEnd::LinkLost);
    QVERIFY(!done->isReverted);
    QVERIFY(done->responses.size() >= 2);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
    fixture.reconnect(1'000'000);
    const auto settled = jobs::recover(fixture.context(), jobs::RecoveryAction::Undo);
    QVERIFY(settled && settled->front().done);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
}

void TestStepResponse::aSilenceInTheLastResponseEndsIt_data()
{
    QTest::addColumn<bool>("unplugged"); ///< else the line is dumb
    QTest::newRow("plug") << true;
    QTest::newRow("line") << false;
}

void TestStepResponse::aSilenceInTheLastResponseEndsIt()
{
    QFETCH(bool, unplugged);
    SimFixture fixture(utf8("sts3215@1"));
    std::vector<int> left;
    bool silent = false;
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& response) {
        silent = response.number == 3;
    };
    watch.onProgress = [&](const jobs::SweepProgress&) {
        if (silent && unplugged && !fixture.bus().isReconnecting() && !fixture.bus().lost())
            fixture.cutLink();
        else if (silent)
            fixture.wireConfig().faults.dropRequest = 1.0;
    };
    watch.onUnreleasedTorque = [&left](const jobs::UnreleasedTorque& one) {
        left.push_back(one.id);
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::LinkLost);
    QVERIFY(!done->isReverted);
    QCOMPARE(done->responses.size(), std::size_t(4));
    QCOMPARE(left, std::vector<int>{1});
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

namespace {
/// Pulls the plug a moment after response 1, for so long; `meanwhile` is what happens then.
jobs::StepCallbacks unplugDuringStep(SimFixture& fixture, base::Duration away,
                                     std::function<void()> meanwhile = {})
{
    jobs::StepCallbacks watch;
    const auto at = std::make_shared<std::optional<base::Duration>>();
    watch.onResponse = [&fixture, at, away](const results::StepResponse& response) {
        if (response.number != 1)
            return;
        fixture.cutLink();
        *at = fixture.clock().now() + away;
    };
    watch.onProgress = [&fixture, at, meanwhile](const jobs::SweepProgress&) {
        if (!*at || fixture.clock().now() < **at)
            return;
        *at = base::Duration::max();
        if (meanwhile)
            meanwhile();
        fixture.restoreLink();
    };
    return watch;
}
} // namespace

void TestStepResponse::unobservedValuesAreNotMeasured_data()
{
    QTest::addColumn<int>("afterMs"); ///< the goal
    QTest::addColumn<int>("spanMs");
    for (const int after : {5, 40, 90}) {
        for (const int span : {80, 150, 1000})
            QTest::addRow("%d ms, for %d ms", after, span) << after << span;
    }
}

/// Readings are missing in the motion of response 2: an adapter that held them back, a program that
/// stood still.
void TestStepResponse::unobservedValuesAreNotMeasured()
{
    QFETCH(int, afterMs);
    QFETCH(int, spanMs);
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const auto untouched = run(fixture, order());
    QVERIFY(untouched);
    std::optional<base::Duration> stillAt;
    fixture.tap().onWait = [&] {
        if (!stillAt || fixture.clock().now() < *stillAt)
            return;
        stillAt.reset();
        fixture.clock().advance(std::chrono::milliseconds(spanMs));
    };
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& response) {
        if (response.number == 1)
            stillAt = fixture.clock().now() + std::chrono::milliseconds(afterMs);
    };
    const auto done = run(fixture, order(), watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(!stillAt);
    for (const results::StepResponse& one : done->responses) {
        QCOMPARE(one.seen, one.number != 2);
        QCOMPARE(one.figures.riseTime.has_value(), one.seen);
        QCOMPARE(one.figures.timeToTarget.has_value(), one.seen);
        QCOMPARE(one.figures.peakSpeed.has_value(), one.seen);
    }
    QVERIFY(std::abs(*done->mean.riseTime - *untouched->mean.riseTime) < 2);
    QVERIFY(std::abs(*done->mean.timeToTarget - *untouched->mean.timeToTarget) < 4);
    const auto advice = jobs::adviseStep(*done, *servo.profile);
    QCOMPARE(advice.size(), std::size_t(1));
    QCOMPARE(advice[0].symptom, results::StepSymptom::NotSeen);
    const auto back = results::decodeStepRuns(results::encodeStepRuns({*done}, advice));
    QVERIFY(back && back->front().responses == done->responses);
}

/// Nobody saw what it did meanwhile; the others are as good as ever.
void TestStepResponse::replugCostsOneResponse()
{
    SimFixture fixture(utf8("sts3215@1"));
    jobs::StepRequest asked = order("400", {{utf8("position_p"), 20}});
    asked.spec.hold = 1s;
    const auto done = run(fixture, asked, unplugDuringStep(fixture, 2s));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(done->responses.size(), std::size_t(4));
    int seen = 0;
    for (const results::StepResponse& response : done->responses) {
        const results::StepFigures& found = response.figures;
        QVERIFY(!response.missed);
        if (found.riseTime) {
            ++seen;
            QVERIFY(found.deadTime && found.peakSpeed && found.timeToTarget);
            continue;
        }
        QVERIFY(!found.deadTime && !found.timeToTarget && !found.settling && !found.overshoot);
        QVERIFY(!found.overshootSteps && !found.swings && !found.swingFrequency);
        QVERIFY(!found.swingAmplitude && !found.peakSpeed);
    }
    QVERIFY(seen == 3 || seen == 2);
    QVERIFY(done->isReverted);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 1);
    QVERIFY(fixture.journal().open()->empty());
    // The patience was the run's.
    fixture.cutLink();
    fixture.bus().listen(10ms);
    QVERIFY(fixture.bus().lost());
}

void TestStepResponse::servoRestartedByReplugStaysOffWithItsOwnGains_data()
{
    QTest::addColumn<int>("mode");
    QTest::newRow("in its own mode") << 0;
    QTest::newRow("in another mode") << 1;
}

void TestStepResponse::servoRestartedByReplugStaysOffWithItsOwnGains()
{
    QFETCH(int, mode);
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("operating_mode"), mode);
    const auto before = eprom(fixture);
    jobs::StepRequest asked = order("400", {{utf8("position_p"), 20}});
    asked.switchMode = mode != 0;
    bool afterwards = false;
    const auto done = run(fixture, asked, unplugDuringStep(fixture, 2s, [&] {
                              QCOMPARE(fixture.raw(1, utf8("position_p")), 20);
                              fixture.powerCycle();
                              afterwards = true;
                          }));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(afterwards);
    QCOMPARE(done->end, SweepEnd::TorqueLost);
    QVERIFY(!done->responses.empty() && done->responses.front().figures.riseTime);
    // A servo without torque says nothing about its gains.
    for (const results::StepResponse& one : done->responses)
        QVERIFY(std::abs(one.samples.back().position - one.target) < 20);
    QVERIFY(done->isReverted);
    QVERIFY(!fixture.hasNotice(device::NoticeCode::SettingNotRestored));
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QCOMPARE(fixture.raw(1, utf8("operating_mode")), mode);
    QVERIFY(before == eprom(fixture));
    const auto stands = fixture.raw(1, utf8("present_position"));
    fixture.runFor(2s);
    QVERIFY(std::abs(fixture.raw(1, utf8("present_position")) - stands) < 3);
}

/// Gains, speed and acceleration are noted for the servo that was there before.
void TestStepResponse::nothingIsRestoredToAReplacedServo()
{
    SimFixture fixture(utf8("sts3215@1,sts3250@1"));
    fixture.withBus([](sim::VirtualBus& wire) { wire.unplug(1); });
    std::optional<base::Duration> swapAt;
    fixture.tap().onWait = [&] {
        if (!swapAt || fixture.clock().now() < *swapAt)
            return;
        swapAt.reset();
        fixture.withBus([](sim::VirtualBus& wire) {
            wire.unplug(0);
            wire.plug(1);
            wire.servos()[1]->poke(utf8("acceleration"), 17);
        });
    };
    const auto newcomer = [&fixture](const char* key) {
        return fixture.withBus([&](sim::VirtualBus& w) { return w.servos()[1]->raw(utf8(key)); });
    };
    const std::int64_t gain = newcomer("position_p");
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& one) {
        if (one.number == 2)
            swapAt = fixture.clock().now() + 300ms;
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(results::sweepEndName(done->end), utf8("exchanged"));
    QVERIFY(!done->isReverted);
    QCOMPARE(newcomer("torque_switch"), 0);
    QCOMPARE(newcomer("acceleration"), 17);
    QCOMPARE(newcomer("position_p"), gain);
    QCOMPARE(fixture.journal().open()->size(), std::size_t(1));
}

namespace {
void unplugFor(SimFixture& fixture, base::Duration span)
{
    fixture.cutLink();
    const base::Duration replugAt = fixture.clock().now() + span;
    fixture.tap().onOpen = [&fixture, replugAt] {
        if (fixture.clock().now() >= replugAt)
            fixture.restoreLink();
    };
}
} // namespace

void TestStepResponse::stopWhileUnpluggedRestoresGainsLater()
{
    SimFixture fixture(utf8("sts3215@1"));
    jobs::StepCallbacks watch;
    watch.onResponse = [&](const results::StepResponse& response) {
        if (response.number != 1)
            return;
        unplugFor(fixture, 1s);
        fixture.stop().request();
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Stopped);
    QVERIFY(done->isReverted);
    QVERIFY(!fixture.hasNotice(device::NoticeCode::SettingNotRestored));
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QVERIFY(fixture.journal().open()->empty());
}

void TestStepResponse::unplugWhileSettingGainsLeavesNothingBehind()
{
    SimFixture fixture(utf8("sts3215@1"));
    int gains = 0;
    fixture.tap().onWrite = [&](const base::Bytes& frame) {
        constexpr int addressOfP = 21;
        if (gains == 1) // the frame after it
            unplugFor(fixture, 1s);
        if (gains > 0 || (frame.size() > 5 && frame[4] == support::Write && frame[5] == addressOfP))
            ++gains;
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NoReply);
    QVERIFY(gains > 1);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QVERIFY(fixture.journal().open()->empty());
}

/// It restarts before it is driven: what is measured then is not what was asked for.
void TestStepResponse::interruptedTrialGainsAreNotTheBaseline()
{
    SimFixture fixture(utf8("sts3215@1"));
    const auto own = fixture.raw(1, utf8("position_p"));
    base::Intent trial;
    trial.kind = base::IntentKind::Trial;
    trial.temporary = true;
    trial.servo = fixture.servo(1).identity();
    trial.items = {{utf8("position_p"), 21, own, own + 28}};
    QVERIFY(fixture.journal().begin(trial));
    fixture.poke(1, utf8("position_p"), own + 28);
    const auto done = run(fixture, order());
    QVERIFY2(done, done ? "" : qPrintable(base::errorName(done.error().code)));
    const auto gain = std::find_if(done->gains.begin(), done->gains.end(),
                                   [](const auto& one) { return one.key == utf8("position_p"); });
    QCOMPARE(gain->raw, own);
    QCOMPARE(fixture.raw(1, utf8("position_p")), own);
    QVERIFY(fixture.journal().open()->empty());
    QCOMPARE(fixture.journal().entries()->front().end->outcome, utf8("undone"));
}

void TestStepResponse::gainsLostBeforeTheFirstStepAreNoTrial()
{
    SimFixture fixture(utf8("sts3215@1"));
    jobs::StepCallbacks watch;
    bool restarted = false;
    watch.onProgress = [&](const jobs::SweepProgress&) {
        if (!std::exchange(restarted, true))
            fixture.powerCycle();
    };
    const auto done = run(fixture, order("400", {{utf8("position_p"), 20}}), watch);
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Refused);
    QCOMPARE(done.error().detail, utf8("trial-lost"));
    QCOMPARE(done.error().registerKey, utf8("position_p"));
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QVERIFY(fixture.journal().open()->empty());
}

void TestStepResponse::modeIsSwitchedOnRequest()
{
    SimFixture fixture(utf8("sts3215@1"));
    fixture.poke(1, utf8("operating_mode"), 1);
    const auto before = eprom(fixture);
    const auto refused = run(fixture, order());
    QVERIFY(!refused);
    QCOMPARE(refused.error().detail, utf8("not-position"));
    jobs::StepRequest asked = order("400", {{utf8("position_p"), 20}});
    asked.switchMode = true;
    const auto done = run(fixture, asked);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->end, SweepEnd::Finished);
    QCOMPARE(fixture.raw(1, utf8("operating_mode")), 1);
    QCOMPARE(fixture.raw(1, utf8("goal_speed")), 0);
    QCOMPARE(fixture.raw(1, utf8("torque_switch")), 0);
    QCOMPARE(fixture.raw(1, utf8("position_p")), 32);
    QVERIFY(fixture.journal().open()->empty());
    QVERIFY(before == eprom(fixture));
}

void TestStepResponse::preconditions_data()
{
    QTest::addColumn<QString>("detail");
    QTest::addColumn<int>("code");
    QTest::newRow("size 0") << utf8("no-size") << int(ErrorCode::BadArgument);
    QTest::newRow("hold") << utf8("no-hold") << int(ErrorCode::BadArgument);
    QTest::newRow("repeats") << utf8("no-repeats") << int(ErrorCode::BadArgument);
    QTest::newRow("gain") << utf8("no-gain") << int(ErrorCode::BadArgument);
    QTest::newRow("gain out of range") << QString() << int(ErrorCode::OutOfRange);
    QTest::newRow("no room") << QString() << int(ErrorCode::OutOfRange);
    QTest::newRow("multi-turn") << QString() << int(ErrorCode::TurnsUnknown);
}

void TestStepResponse::preconditions()
{
    QFETCH(QString, detail);
    QFETCH(int, code);
    SimFixture fixture(utf8("sts3215@1"));
    jobs::StepRequest asked = order();
    const QByteArray row = QTest::currentDataTag();
    if (row == "size 0")
        asked.spec.size = utf8("0");
    else if (row == "hold")
        asked.spec.hold = 60s;
    else if (row == "repeats")
        asked.spec.repeats = 0;
    else if (row == "gain")
        asked.spec.trial = {{utf8("baud_rate"), 1}};
    else if (row == "gain out of range")
        asked.spec.trial = {{utf8("position_p"), 255}};
    else if (row == "no room")
        asked.spec.size = utf8("4096");
    else {
        fixture.poke(1, utf8("min_angle_limit"), 0);
        fixture.poke(1, utf8("max_angle_limit"), 0);
    }
    fixture.clearFrames();
    const auto done = run(fixture, asked);
    QVERIFY(!done);
    QCOMPARE(int(done.error().code), code);
    if (!detail.isEmpty())
        QCOMPARE(done.error().detail, detail);
    QVERIFY(fixture.onlyReadsSent());
    QVERIFY(fixture.journal().open()->empty());
}

void TestStepResponse::adviceFollowsTheDataSheet_data()
{
    using results::StepRemedy;
    QTest::addColumn<int>("p");
    QTest::addColumn<int>("d");
    QTest::addColumn<int>("remedy");
    QTest::newRow("lag") << 8 << 0 << int(StepRemedy::RaiseP);
    QTest::newRow("static error") << 14 << 8 << int(StepRemedy::RaiseI);
    QTest::newRow("oscillation") << 200 << 0 << int(StepRemedy::LowerP);
}

void TestStepResponse::adviceFollowsTheDataSheet()
{
    QFETCH(int, p);
    QFETCH(int, d);
    QFETCH(int, remedy);
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    const auto done =
        run(fixture, order("400", {{utf8("position_p"), p}, {utf8("position_d"), d}}));
    QVERIFY(done);
    const auto advice = jobs::adviseStep(*done, *servo.profile);
    QVERIFY(advises(advice, results::StepRemedy(remedy)));
    for (const results::StepAdvice& one : advice) {
        if (one.remedy == results::StepRemedy::LowerP)
            QCOMPARE(one.proposed, 32); // the stored one
        if (one.remedy == results::StepRemedy::RaiseI)
            QCOMPARE(one.proposed, 1);
        if (one.remedy == results::StepRemedy::RaiseP)
            QVERIFY(one.proposed > p && one.proposed <= p + std::max(1, p / 4));
    }
    // A good servo hears nothing.
    const auto good = run(fixture, order());
    QVERIFY(good);
    QVERIFY(jobs::adviseStep(*good, *servo.profile).empty());
}

void TestStepResponse::aKnownOvershootIsMeasured()
{
    SimFixture fixture(utf8("sts3215@1+overshoot=8"));
    device::Servo servo = fixture.servo(1);
    const auto done = run(fixture, order());
    QVERIFY(done);
    QVERIFY(std::abs(done->mean.overshoot.value_or(0) - 8) <= 1);
    QCOMPARE(done->mean.swings.value_or(0), 1.0);
    const auto advice = jobs::adviseStep(*done, *servo.profile);
    QVERIFY(advises(advice, results::StepRemedy::RaiseD));
    QVERIFY(!advises(advice, results::StepRemedy::RaiseI));
}

/// Half of its responses begin where they should end.
void TestStepResponse::aStationaryServoGetsNoGains()
{
    SimFixture fixture(utf8("sts3215@1"));
    device::Servo servo = fixture.servo(1);
    results::StepRun run;
    run.axis.tolerance = 3;
    run.gains = {{utf8("position_p"), 32}, {utf8("position_i"), 0}};
    for (int number = 1; number <= 4; ++number) {
        results::StepResponse one;
        one.number = number;
        one.start = 2048;
        one.target = number % 2 == 1 ? 2058 : 2048;
        one.missed = number % 2 == 1;
        one.figures.steadyError = number % 2 == 1 ? -10 : 0;
        for (int i = 0; i < 50; ++i)
            one.samples.push_back({i * 10ms, 2048.0 + i % 2});
        run.responses.push_back(one);
    }
    run.mean = results::meanOf(run.responses);
    const auto advice = jobs::adviseStep(run, *servo.profile);
    QCOMPARE(advice.size(), std::size_t(1));
    QCOMPARE(advice[0].symptom, results::StepSymptom::NoMotion);
    QVERIFY(advice[0].key.isEmpty());
    run.responses[2].samples.back().position = 2054; // it did move once
    QVERIFY(advises(jobs::adviseStep(run, *servo.profile), results::StepRemedy::RaiseP));
}

/// More P would only press harder.
void TestStepResponse::aServoAtAHardStopGetsNoGains()
{
    SimFixture fixture(utf8("sts3215@1+stop=200"));
    device::Servo servo = fixture.servo(1);
    jobs::StepRequest asked = order("400");
    asked.spec.from = utf8("2200");
    const auto done = run(fixture, asked);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    const auto advice = jobs::adviseStep(*done, *servo.profile);
    QCOMPARE(advice.size(), std::size_t(1));
    QCOMPARE(advice[0].symptom, results::StepSymptom::Blocked);
    QVERIFY(advice[0].key.isEmpty());
}

void TestStepResponse::aRunRoundTripsThroughItsFile()
{
    SimFixture fixture(utf8("sts3215@1"));
    const auto first = run(fixture, order());
    const auto second = run(fixture, order("400", {{utf8("position_p"), 40}}));
    QVERIFY(first && second);
    const std::vector<results::StepRun> runs{*first, *second};
    const QByteArray file = results::encodeStepRuns(runs, {});
    const auto back = results::decodeStepRuns(file);
    QVERIFY2(back, back ? "" : qPrintable(back.error().detail));
    QCOMPARE(back->size(), std::size_t(2));
    QCOMPARE(results::encodeStepRuns(*back, {}), file);
    QVERIFY(back->back().responses == second->responses);
    QVERIFY(back->back().spec == second->spec);
    QVERIFY(!results::decodeStepRuns("{}"));
    QVERIFY(
        !results::decodeStepRuns(QByteArray(file).replace("\"number\": 1", "\"number\": \"1\"")));
}

void TestStepResponse::scatterIsNoDifference()
{
    SimFixture fixture(utf8("sts3215@1"));
    const auto first = run(fixture, order());
    const auto second = run(fixture, order());
    const auto weak =
        run(fixture, order("400", {{utf8("position_p"), 10}, {utf8("position_d"), 0}}));
    QVERIFY(first && second && weak);
    const auto changeOf = [&](const results::StepRun& after, const char* key) {
        for (const results::StepDifference& row : results::compareSteps(*first, after)) {
            if (QLatin1StringView(row.figure.key) == QLatin1StringView(key))
                return row.change;
        }
        return results::StepChange::NotMeasured;
    };
    QCOMPARE(changeOf(*second, "overshoot"), results::StepChange::Same);
    QCOMPARE(changeOf(*weak, "rise_time"), results::StepChange::Worse);
    QCOMPARE(changeOf(*weak, "steady_error"), results::StepChange::Worse);
    QCOMPARE(changeOf(*weak, "peak_speed"), results::StepChange::Neither);
}

SERVODESK_GUILESS_TEST(TestStepResponse)
#include "tst_step_response.moc"

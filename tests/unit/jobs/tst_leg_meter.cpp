// SPDX-License-Identifier: GPL-3.0-or-later
// One leg, measured from noisy readings of a motion that is known exactly: every figure within 2
// steps, 1 percentage point or 2 %; what cannot be known is not said. Rest, targets that are not
// reached, nights; what happens while the servo moves is in tst_leg_motion.
#include "support/test_main.h"
#include "unit/jobs/simulated_leg.h"

#include <QtTest>

using jobs::LegMeter;
using jobs::SweepSample;
using results::SweepAxis;
using results::SweepLeg;
using simulated_leg::Motion;
using simulated_leg::Reading;
using std::chrono::milliseconds;

namespace {
#define VERIFY_TIME(value, truth, by)                                                              \
    VERIFY_NEAR(std::optional(simulated_leg::seconds(value)), truth, by)

Motion plain(double place)
{
    return [place](double) { return place; };
}

/// Rings about `place` for good.
Motion sustainedRinging(double place, double size, double frequency)
{
    return [=](double t) { return place + size * std::sin(2 * std::numbers::pi * frequency * t); };
}
} // namespace

class TestLegMeter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void stepResponse_data();
    void stepResponse();
    void staticErrorIsNoOvershoot_data();
    void staticErrorIsNoOvershoot();
    void noiseIsNeitherOvershootNorRinging();
    void creepsIntoTheBand();
    void ringsAtRestWithin();
    void ringsAtRestOutside();
    void leavesAgainAndStopsElsewhere();
    void aLegWithoutTravel();
    void missesItsTargetAndStops();
    void stopsJustOutsideWithNoiseInside();
    void theNextGoalComesTooEarly();
    void theNextGoalComesOnArrival();
    void fewReadings_data();
    void fewReadings();
    void lostReadings();
    void noReadings();
    void severalTurns();
    void aLongRest();
    void aLongRestWithALateEvent();
    void feedbackIsRecorded();
    void unmeasuredIsNotReported();
    void earlierReadingsAreIgnored();
};

void TestLegMeter::stepResponse_data()
{
    QTest::addColumn<double>("target");
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("noise");
    for (const double share : {0.05, 0.12, 0.3}) {
        for (const double rate : {60.0, 300.0, 700.0}) {
            for (const double noise : {0.0, 1.0, 2.0}) {
                for (const double target : {3000.0, -1000.0}) {
                    QTest::addRow("%g %% to %g at %g Hz, ±%g", share * 100, target, rate, noise)
                        << target << share << rate << noise;
                }
            }
        }
    }
}

void TestLegMeter::stepResponse()
{
    QFETCH(double, target);
    QFETCH(double, share);
    QFETCH(double, rate);
    QFETCH(double, noise);
    const double way = std::abs(target - 1000);
    const Motion motion =
        simulated_leg::later(simulated_leg::secondOrder(1000, target, 3, share), 0.015);
    const auto truth = simulated_leg::groundTruth(motion, target, 12, 2.5);
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1000, target, motion,
                                                    2.5, {rate, noise, 0, 0, seed});
        QVERIFY(!leg.missed);
        VERIFY_NEAR(leg.overshoot, share * 100, 1);
        VERIFY_NEAR(leg.overshootSteps, share * way, std::max(2.0, 0.01 * way));
        VERIFY_NEAR(leg.steadyError, 0, 1);
        VERIFY_NEAR(leg.reached, target, 1);
        // Readings that far apart cannot tell more: half of their distance.
        const double resolution = 0.5 / rate;
        VERIFY_TIME(leg.timeToTarget, truth.arrival, std::max(0.02 * truth.arrival, resolution));
        // Steps of noise at the edge are time, as fast as it goes there.
        const double slow = std::max(0.02 * truth.settling, 0.006 + 0.002 * noise + 2 * resolution);
        VERIFY_TIME(leg.settling, truth.settling, slow);
    }
}

void TestLegMeter::staticErrorIsNoOvershoot_data()
{
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("share");
    for (const double error : {-20.0, -8.0, 8.0, 20.0}) {
        for (const double share : {0.0, 0.05})
            QTest::addRow("%g steps, %g %%", error, share * 100) << error << share;
    }
}

void TestLegMeter::staticErrorIsNoOvershoot()
{
    QFETCH(double, error);
    QFETCH(double, share);
    const double rest = 2000 + error;
    const Motion motion = share > 0 ? simulated_leg::secondOrder(1000, rest, 3, share)
                                    : simulated_leg::trapezoid(1000, rest, 1500, 6000);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 2.5,
                                                    {300, 1.5, 0, 0, seed});
        VERIFY_NEAR(leg.steadyError, error, 1);
        VERIFY_NEAR(leg.reached, rest, 1);
        VERIFY_NEAR(leg.overshoot, share * 100, share > 0 ? 1 : 0);
        // What came by on its way beyond has been there.
        QCOMPARE(leg.missed, error == -20 && share == 0);
        QCOMPARE(leg.timeToTarget.has_value(), !leg.missed);
    }
}

/// 300 legs of ±2 steps of noise: overshoot 0 in each, settled at once.
void TestLegMeter::noiseIsNeitherOvershootNorRinging()
{
    for (unsigned seed = 1; seed <= 300; ++seed) {
        for (const double rate : {20.0, 300.0}) {
            const Motion motion = simulated_leg::trapezoid(1000, 1400, 2000, 9000);
            const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1000, 1400, motion,
                                                        2, {rate, 2, 0, 0, seed});
            VERIFY_NEAR(leg.overshoot, 0, 0);
            VERIFY_TIME(leg.settling, 0, 0);
            VERIFY_NEAR(leg.steadyError, 0, 2);
        }
        // At rest close to the edge of the tolerance, noise goes out of it now and then.
        const SweepLeg edge = simulated_leg::measure(
            simulated_leg::axis(), 1000, 1400, simulated_leg::trapezoid(1000, 1389.5, 2000, 9000),
            2, {300, 2, 0, 0, seed});
        VERIFY_TIME(edge.settling, 0, 0.03);
    }
}

void TestLegMeter::creepsIntoTheBand()
{
    // A second for the last steps: 12 of 1000 are left after 4.42 time constants.
    const Motion motion = simulated_leg::exponentialApproach(1000, 2000, 0.4);
    const double arrival = 0.4 * std::log(1000.0 / 12);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 5,
                                                    {300, 0.5, 0, 0, seed});
        VERIFY_TIME(leg.timeToTarget, arrival, 0.02 * arrival);
        VERIFY_TIME(leg.settling, 0, 0.03);
        VERIFY_NEAR(leg.steadyError, 0, 1);
        VERIFY_NEAR(leg.overshoot, 0, 0);
    }
}

void TestLegMeter::ringsAtRestWithin()
{
    const Motion motion = simulated_leg::plus(simulated_leg::trapezoid(1000, 2000, 3000, 20000),
                                              sustainedRinging(0, 7, 6));
    const SweepLeg leg =
        simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 3, {300, 1});
    VERIFY_TIME(leg.settling, 0, 0.001);
    VERIFY_NEAR(leg.steadyError, 0, 2);
    VERIFY_NEAR(leg.overshootSteps, 7, 2);
}

/// It never comes to rest: settling is as long as anybody looked, and there is no steady error.
void TestLegMeter::ringsAtRestOutside()
{
    for (const double until : {2.9, 3.0, 3.05, 3.1}) {
        const Motion motion = simulated_leg::plus(simulated_leg::trapezoid(1000, 2000, 3000, 20000),
                                                  sustainedRinging(0, 30, 4));
        const SweepLeg leg =
            simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, until, {300, 1});
        QVERIFY(!leg.missed);
        QVERIFY(simulated_leg::seconds(leg.settling) >
                until - simulated_leg::seconds(leg.timeToTarget) - 0.15);
        QVERIFY(!leg.steadyError);
        VERIFY_NEAR(leg.overshootSteps, 30, 2);
    }
}

void TestLegMeter::leavesAgainAndStopsElsewhere()
{
    const Motion away = [](double t) { return t < 1 ? 0 : std::max(-40.0, -200 * (t - 1)); };
    const Motion motion =
        simulated_leg::plus(simulated_leg::trapezoid(1000, 2000, 3000, 20000), away);
    const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 3);
    QVERIFY(!leg.missed);
    VERIFY_NEAR(leg.steadyError, -40, 1);
    VERIFY_TIME(leg.settling, 3 - simulated_leg::seconds(leg.timeToTarget), 0.001);

    // And if it comes back, that is when it settled.
    const Motion bump = [](double t) {
        return t > 1 && t < 1.5 ? -100 * std::sin((t - 1) * 2 * std::numbers::pi) : 0;
    };
    const Motion back =
        simulated_leg::plus(simulated_leg::trapezoid(1000, 2000, 3000, 20000), bump);
    const auto truth = simulated_leg::groundTruth(back, 2000, 12, 3);
    const SweepLeg pushed = simulated_leg::measure(simulated_leg::axis(), 1000, 2000, back, 3);
    VERIFY_TIME(pushed.settling, truth.settling, 0.01);
    VERIFY_NEAR(pushed.steadyError, 0, 1);
}

void TestLegMeter::aLegWithoutTravel()
{
    const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 1500, 1500, plain(1503), 2);
    VERIFY_TIME(leg.timeToTarget, 0, 0);
    VERIFY_TIME(leg.settling, 0, 0);
    VERIFY_NEAR(leg.steadyError, 3, 1);
    QVERIFY(!leg.missed);
    QVERIFY(!leg.overshoot && !leg.overshootSteps && !leg.meanSpeed && !leg.topSpeed);
    QVERIFY(!leg.followingError);
}

void TestLegMeter::missesItsTargetAndStops()
{
    for (const double rest : {1950.0, 1000.0}) { // a static error; blocked from the start
        const Motion motion = simulated_leg::trapezoid(1000, rest, 1500, 6000);
        const SweepLeg leg = simulated_leg::measure(
            simulated_leg::axis(), 1000, 2000, rest > 1000 ? motion : plain(1000), 3, {100, 2});
        QVERIFY(leg.missed && !leg.timeToTarget && !leg.settling);
        VERIFY_NEAR(leg.reached, rest, 1);
        VERIFY_NEAR(leg.steadyError, rest - 2000, 1);
        VERIFY_NEAR(leg.overshootSteps, 0, 0);
        QVERIFY(!leg.meanSpeed || rest > 1900);
    }
}

/// Single readings are within tolerance, the place of rest is not; whichever comes last.
void TestLegMeter::stopsJustOutsideWithNoiseInside()
{
    const Motion motion = simulated_leg::trapezoid(1000, 1985, 1500, 6000);
    for (const double tolerance : {12.0, 13.0}) {
        for (unsigned seed = 1; seed <= 50; ++seed) {
            const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(tolerance), 1000, 2000,
                                                        motion, 3, {300, 3, 0, 0, seed});
            VERIFY_NEAR(leg.steadyError, -15, 1);
            VERIFY_NEAR(leg.reached, 1985, 1);
        }
    }
}

/// The classic mistake: the servo turns round before it arrives.
void TestLegMeter::theNextGoalComesTooEarly()
{
    for (const double speed : {2000.0, 300.0, 20.0}) {
        for (const double rate : {30.0, 300.0}) {
            SweepAxis axis = simulated_leg::axis();
            axis.speed = speed;
            const double until = 0.7 * 1000 / speed;
            const Motion motion = simulated_leg::trapezoid(0, 1000, speed, 1e5);
            const SweepLeg leg = simulated_leg::measure(axis, 0, 1000, motion, until, {rate, 1});
            QVERIFY(leg.missed && !leg.timeToTarget && !leg.settling);
            VERIFY_NEAR(leg.reached, motion(until), 1.1 * speed / rate + 2);
            QVERIFY(!leg.steadyError && !leg.overshoot && !leg.meanSpeed);
        }
    }
}

/// Within tolerance for the last moment only: arrived, but nobody has seen it stay.
void TestLegMeter::theNextGoalComesOnArrival()
{
    const Motion motion = simulated_leg::trapezoid(0, 1000, 1000, 1e6);
    const SweepLeg leg =
        simulated_leg::measure(simulated_leg::axis(), 0, 1000, motion, 1.02, {300, 1});
    QVERIFY(!leg.missed);
    VERIFY_TIME(leg.timeToTarget, 0.989, 0.01);
    QVERIFY(!leg.settling && !leg.steadyError && !leg.overshoot);
}

void TestLegMeter::fewReadings_data()
{
    QTest::addColumn<double>("rate");
    QTest::newRow("10 Hz") << 10.0;
    QTest::newRow("25 Hz") << 25.0;
}

void TestLegMeter::fewReadings()
{
    QFETCH(double, rate);
    const Motion motion = simulated_leg::trapezoid(0, 2000, 1000, 5000); // takes 2.2 s
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 0, 2000, motion, 4,
                                                    {rate, 0.5, 0, 0, seed});
        VERIFY_TIME(leg.timeToTarget, 2.13, 0.5 / rate);
        VERIFY_NEAR(leg.steadyError, 0, 1);
        VERIFY_NEAR(leg.overshoot, 0, 0);
        VERIFY_NEAR(leg.meanSpeed, 1000, 20);
        VERIFY_NEAR(leg.topSpeed, 1000, 25); // of three or four readings
    }
}

/// A third of the readings is lost, then all for half a second across the arrival.
void TestLegMeter::lostReadings()
{
    const Motion motion = simulated_leg::trapezoid(0, 2000, 2000, 20000); // arrives at 1.064 s
    LegMeter meter = simulated_leg::meter(simulated_leg::axis(), 0, 2000);
    int lost = 0;
    int heard = 0;
    simulated_leg::read(motion, 3, {200, 1, 0.33}, [&](SweepSample sample) {
        const double at = simulated_leg::seconds(sample.at);
        sample.answered = sample.answered && !(at > 0.9 && at < 1.4);
        ++(sample.answered ? heard : lost);
        meter.add(sample);
    });
    const SweepLeg leg = meter.finish(simulated_leg::fromSeconds(3), {});
    QCOMPARE(leg.lost, lost);
    QCOMPARE(leg.samples, heard);
    // Not sooner than it was seen, and no speed across the hole.
    QVERIFY(simulated_leg::seconds(leg.timeToTarget) >= 1.4 &&
            simulated_leg::seconds(leg.timeToTarget) < 1.45);
    QVERIFY(!leg.meanSpeed && !leg.topSpeed);
    VERIFY_NEAR(leg.steadyError, 0, 1);
}

void TestLegMeter::noReadings()
{
    LegMeter meter = simulated_leg::meter(simulated_leg::axis(), 0, 2000);
    SweepSample silence;
    silence.at = milliseconds(10);
    meter.add(silence);
    const SweepLeg leg = meter.finish(milliseconds(20), {});
    QCOMPARE(leg.lost, 1);
    QVERIFY(leg.missed);
    QVERIFY(!leg.reached && !leg.steadyError && !leg.overshoot && !leg.flagWrong);
}

void TestLegMeter::severalTurns()
{
    const Motion motion = simulated_leg::secondOrder(-28672, 28672, 1, 0.05);
    const SweepLeg leg =
        simulated_leg::measure(simulated_leg::axis(), -28672, 28672, motion, 6, {300, 1});
    VERIFY_NEAR(leg.overshoot, 5, 0.1);
    VERIFY_NEAR(leg.steadyError, 0, 1);
}

/// Eight hours at 200 Hz say the same as the first ten seconds, in room that does not grow.
void TestLegMeter::aLongRest()
{
    const Motion motion = simulated_leg::secondOrder(1000, 2000, 3, 0.05);
    const SweepLeg brief =
        simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 10, {200, 1.5});
    const SweepLeg night =
        simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 8 * 3600, {200, 1.5});
    QCOMPARE(night.timeToTarget, brief.timeToTarget);
    QCOMPARE(night.settling, brief.settling);
    QCOMPARE(night.meanSpeed, brief.meanSpeed);
    QCOMPARE(night.topSpeed, brief.topSpeed);
    VERIFY_NEAR(night.overshoot, 5, 0.3);
    VERIFY_NEAR(night.steadyError, 0, 0.1);
    QVERIFY(night.samples > 5'700'000);

    jobs::LegTrace trace;
    double sum = 0;
    const int count = 3'000'000;
    for (int i = 0; i < count; ++i) {
        const double position = i % 1000 == 0 ? 3 : i % 2;
        sum += position;
        trace.add(milliseconds(i), position);
        if (trace.points().size() > jobs::LegTrace::capacity)
            QFAIL("grows");
    }
    double kept = 0;
    int stoppedCount = 0;
    double highest = 0;
    for (const jobs::LegPoint& point : trace.points()) {
        kept += point.sum;
        stoppedCount += point.count;
        highest = std::max(highest, point.position);
    }
    QCOMPARE(stoppedCount, count);
    QCOMPARE(kept, sum);
    QCOMPARE(highest, 3.0);
    for (std::size_t i = 1; i < trace.points().size(); ++i)
        QVERIFY(trace.points()[i].at > trace.points()[i - 1].at);
}

/// Pushed away for 50 ms after three hours: seen, and nearly to the moment.
void TestLegMeter::aLongRestWithALateEvent()
{
    const double at = 3 * 3600;
    const Motion pushed = [at](double t) { return t > at && t < at + 0.05 ? 50 : 0; };
    const Motion motion =
        simulated_leg::plus(simulated_leg::trapezoid(1000, 2000, 3000, 20000), pushed);
    const SweepLeg leg =
        simulated_leg::measure(simulated_leg::axis(), 1000, 2000, motion, 4 * 3600, {200, 1});
    VERIFY_TIME(leg.settling, at + 0.05 - simulated_leg::seconds(leg.timeToTarget), 1);
    VERIFY_NEAR(leg.steadyError, 0, 0.2);
    VERIFY_NEAR(leg.overshootSteps, 50, 2);
}

void TestLegMeter::feedbackIsRecorded()
{
    LegMeter meter(simulated_leg::axis(), 7, 4, milliseconds(5000), 0, 100);
    const double current[] = {100, -400, 250, 250};
    const double volts[] = {12, 11.2, 11.9, 12};
    const double celsius[] = {30, 30, 31, 30};
    for (int i = 0; i < 4; ++i) {
        SweepSample sample;
        sample.at = milliseconds(5000 + 10 * i);
        sample.answered = true;
        sample.position = 100;
        sample.current = current[i];
        sample.load = -current[i] / 10;
        sample.voltage = volts[i];
        sample.temperature = celsius[i];
        sample.status = i == 1 ? 32 : i == 2 ? 4 : 0;
        meter.add(sample);
    }
    const SweepLeg leg = meter.finish(milliseconds(6000), milliseconds(3000));
    QCOMPARE(leg.number, 7);
    QCOMPARE(leg.cycle, 4);
    QCOMPARE(leg.at, base::Duration(milliseconds(2000)));
    QCOMPARE(leg.span, base::Duration(milliseconds(1000)));
    VERIFY_NEAR(leg.currentPeak, 400, 0);
    VERIFY_NEAR(leg.currentMean, 250, 0);
    VERIFY_NEAR(leg.loadPeak, 40, 0);
    VERIFY_NEAR(leg.loadMean, 25, 0);
    VERIFY_NEAR(leg.voltageMin, 11.2, 0);
    VERIFY_NEAR(leg.temperatureMax, 31, 0);
    QCOMPARE(int(leg.alarms), 36);
    QCOMPARE(leg.samples, 4);
}

/// LX: no current, no load, no flag.
void TestLegMeter::unmeasuredIsNotReported()
{
    const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(3), 100, 800,
                                                simulated_leg::trapezoid(100, 800, 1000, 9000), 2);
    QVERIFY(!leg.currentPeak && !leg.currentMean && !leg.loadPeak && !leg.loadMean);
    QVERIFY(!leg.voltageMin && !leg.temperatureMax && !leg.flagWrong);
    QVERIFY(!leg.followingError); // the speed it was told is not known
    QVERIFY(leg.timeToTarget && leg.meanSpeed && leg.steadyError);
}

void TestLegMeter::earlierReadingsAreIgnored()
{
    LegMeter meter(simulated_leg::axis(), 1, 1, milliseconds(100), 0, 1000);
    SweepSample sample;
    sample.answered = true;
    sample.position = 1000; // still of the leg before
    sample.status = 1;
    sample.at = milliseconds(99);
    meter.add(sample);
    const SweepLeg leg = meter.finish(milliseconds(200), {});
    QVERIFY(leg.missed);
    QCOMPARE(leg.samples, 0);
    QCOMPARE(int(leg.alarms), 0);
}

SERVODESK_GUILESS_TEST(TestLegMeter)
#include "tst_leg_meter.moc"

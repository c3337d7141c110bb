// SPDX-License-Identifier: GPL-3.0-or-later
// What LegMeter says of a servo while it moves, and to the job while the leg lasts: speeds, lag
// behind the path, the moving flag, arrival, stall; and legs of a sine.
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
using std::chrono::seconds;

namespace {
SweepAxis limitsFor(double speed, std::optional<double> acceleration = {})
{
    SweepAxis axis = simulated_leg::axis();
    axis.speed = speed;
    axis.acceleration = acceleration;
    return axis;
}

/// When `question` was first answered yes; -1: never.
double firstTimeTrue(const Motion& motion, LegMeter meter, double until, const Reading& how,
                     const std::function<bool(const LegMeter&)>& question)
{
    double yes = -1;
    simulated_leg::read(motion, until, how, [&](const SweepSample& sample) {
        meter.add(sample);
        if (yes < 0 && question(meter))
            yes = simulated_leg::seconds(sample.at);
    });
    return yes;
}

double detectedStallTime(const SweepAxis& axis, double target, const Motion& motion, double until,
                         unsigned seed = 1, double rate = 200)
{
    return firstTimeTrue(motion, simulated_leg::meter(axis, 0, target), until,
                         {rate, 2, 0, 0, seed},
                         [](const LegMeter& meter) { return meter.isStalled(milliseconds(500)); });
}

using Flag = std::function<bool(double at)>;

std::optional<bool> flagWrong(const SweepAxis& axis, double target, const Motion& motion,
                              const Flag& flag, double rate = 200)
{
    LegMeter meter = simulated_leg::meter(axis, 0, target);
    simulated_leg::read(motion, 4, {rate, 1}, [&](SweepSample sample) {
        sample.moving = flag(simulated_leg::seconds(sample.at));
        meter.add(sample);
    });
    return meter.finish(seconds(4), {}).flagWrong;
}
} // namespace

class TestLegMotion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void speeds_data();
    void speeds();
    void meanIsTakenFromTheMiddle();
    void noiseIsNoSpeed();
    void lateReadingsKeepToTheDefinition();
    void stopsNearItsTarget();
    void tooLittleForASpeed();
    void lagsBehindItsPath_data();
    void lagsBehindItsPath();
    void theWireIsNoLag();
    void movingFlag();
    void movingFlagAtFewReadings();
    void arrives();
    void doesNotArriveInPassing();
    void stalls();
    void staticErrorIsNoStall();
    void slowIsNoStall();
    void silenceIsNoStall();
    void sine();
};

void TestLegMotion::speeds_data()
{
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("rate");
    QTest::newRow("fast") << 3000.0 << 3400.0 << 300.0;
    QTest::newRow("fast, every reading") << -3000.0 << 3400.0 << 700.0;
    QTest::newRow("usual") << 2000.0 << 1000.0 << 200.0;
    QTest::newRow("short") << -300.0 << 1000.0 << 300.0;
    QTest::newRow("slow") << 1000.0 << 100.0 << 50.0;
    QTest::newRow("crawling") << 200.0 << 10.0 << 300.0;
}

void TestLegMotion::speeds()
{
    QFETCH(double, way);
    QFETCH(double, speed);
    QFETCH(double, rate);
    const double until = 2 * std::abs(way) / speed + 1;
    const Motion motion =
        simulated_leg::later(simulated_leg::trapezoid(0, way, speed, 20 * speed), 0.01);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 0, way, motion, until,
                                                    {rate, 0.4, 0, 0, seed});
        VERIFY_NEAR(leg.meanSpeed, speed, 0.02 * speed);
        VERIFY_NEAR(leg.topSpeed, speed, 0.02 * speed);
    }
}

/// A triangle of speed: the middle 80 % of 1000 steps at 2000 steps/s² take √2 − 2·√0.1 s … .
void TestLegMotion::meanIsTakenFromTheMiddle()
{
    const double whole = 2 * std::sqrt(1000.0 / 2000);
    const double edge = std::sqrt(2 * 100.0 / 2000);
    const SweepLeg leg =
        simulated_leg::measure(simulated_leg::axis(), 0, 1000,
                               simulated_leg::trapezoid(0, 1000, 9999, 2000), 3, {300, 0.4});
    const double mean = 800 / (whole - 2 * edge);
    VERIFY_NEAR(leg.meanSpeed, mean, 0.02 * mean);
    const double top = std::sqrt(1000.0 * 2000);
    VERIFY_NEAR(leg.topSpeed, top, 0.02 * top);
}

/// The steepest of many slopes is the one that noise has made steep.
void TestLegMotion::noiseIsNoSpeed()
{
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const Motion motion = simulated_leg::trapezoid(0, 2800, 2050, 50000);
        const SweepLeg leg = simulated_leg::measure(simulated_leg::axis(), 0, 2800, motion, 2.5,
                                                    {350, 2.6, 0, 0, seed});
        VERIFY_NEAR(leg.topSpeed, 2050, 0.02 * 2050);
    }
}

/// A busy computer takes up some readings late. The top speed is what leg_parts.h says of it all
/// the same: here by trying every stretch.
void TestLegMotion::lateReadingsKeepToTheDefinition()
{
    struct Point {
        double s;
        double steps;
    };
    constexpr double way = 2800;
    const auto fitted = [](const std::vector<Point>& all, std::size_t from, std::size_t to) {
        const double n = double(to - from + 1);
        double meanTime = 0;
        double meanSteps = 0;
        for (std::size_t i = from; i <= to; ++i) {
            meanTime += all[i].s / n;
            meanSteps += all[i].steps / n;
        }
        double square = 0;
        double product = 0;
        double scatter = 0;
        for (std::size_t i = from; i <= to; ++i) {
            square += std::pow(all[i].s - meanTime, 2);
            product += (all[i].s - meanTime) * (all[i].steps - meanSteps);
            scatter += std::pow(all[i].steps - meanSteps, 2);
        }
        const double slope = product / square;
        return slope - std::sqrt(std::max(0.0, scatter - slope * product) / (n - 2) / square);
    };
    const Motion motion = simulated_leg::trapezoid(0, way, 2050, 50000);
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        std::vector<Point> all{{0, 0}}; // where it stood
        LegMeter meter = simulated_leg::meter(simulated_leg::axis(), 0, way);
        simulated_leg::read(motion, 2, {350, 1, 0, 0, seed}, [&](SweepSample sample) {
            const double at = simulated_leg::seconds(sample.at);
            if (random() % 12 == 0)
                sample.position = std::round(motion(at - double(random() % 30) / 1000));
            meter.add(sample);
            all.push_back({at, *sample.position});
        });
        double top = 0;
        std::size_t from = 0;
        const auto isLong = [&](std::size_t a, std::size_t b) {
            return all[b].s - all[a].s >= 0.04 && all[b].steps - all[a].steps >= way / 16;
        };
        for (std::size_t to = 0; to < all.size(); ++to) {
            while (to - from >= 3 && isLong(from + 1, to))
                ++from;
            if (to - from >= 2 && isLong(from, to))
                top = std::max(
                    top, std::min(fitted(all, from, to), (all[to].steps - all[from].steps + 8) /
                                                             (all[to].s - all[from].s)));
        }
        VERIFY_NEAR(meter.finish(seconds(2), {}).topSpeed, top, 1e-6 * top);
    }
}

void TestLegMotion::stopsNearItsTarget()
{
    const auto stands = [](double place, double until) {
        const SweepAxis axis = simulated_leg::axis();
        LegMeter meter = simulated_leg::meter(axis, 0, 1000);
        simulated_leg::read(simulated_leg::trapezoid(0, place, 2000, 50000), until, {300, 1},
                            [&](const jobs::SweepSample& sample) { meter.add(sample); });
        return meter.restsNearTarget(milliseconds(200));
    };
    QVERIFY(stands(1000, 1));
    QVERIFY(stands(980, 1)); // out of tolerance, but by no more than friction may leave
    QVERIFY(!stands(980, 0.6));
    QVERIFY(!stands(900, 1));
}

void TestLegMotion::tooLittleForASpeed()
{
    const auto measured = [](double way, double rate) {
        const SweepLeg leg =
            simulated_leg::measure(simulated_leg::axis(), 0, way,
                                   simulated_leg::trapezoid(0, way, 2000, 50000), 2, {rate, 1});
        return leg.meanSpeed || leg.topSpeed;
    };
    QVERIFY(!measured(15, 300)); // noise is as large
    QVERIFY(!measured(400, 10)); // it is there between two readings
    QVERIFY(measured(400, 100));
}

void TestLegMotion::lagsBehindItsPath_data()
{
    QTest::addColumn<double>("lag");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("rate");
    for (const double noise : {0.4, 2.0}) {
        for (const double rate : {50.0, 300.0}) {
            for (const double lag : {0.0, 15.0, 60.0})
                QTest::addRow("%g steps, ±%g, %g Hz", lag, noise, rate) << lag << noise << rate;
        }
    }
}

/// `lag` steps behind while it goes, on the target in the end.
void TestLegMotion::lagsBehindItsPath()
{
    QFETCH(double, lag);
    QFETCH(double, noise);
    QFETCH(double, rate);
    const SweepAxis axis = limitsFor(800, 8000);
    for (const double target : {2000.0, -2000.0}) {
        const Motion motion =
            simulated_leg::later(simulated_leg::trapezoid(0, target, 800, 8000), lag / 800);
        // Half a reading's distance and 5 ms at the most are put down to the wire.
        const double wire = 800 * std::min(1 / rate, 0.005);
        const SweepLeg leg = simulated_leg::measure(axis, 0, target, motion, 4, {rate, noise});
        QVERIFY(leg.followingError);
        QVERIFY(*leg.followingError <= lag + 2 + noise / 2);
        QVERIFY(*leg.followingError >= lag - wire - 2);
    }
}

/// Read as soon as it can be, and as old as the wire makes it: no lag, at any rate.
void TestLegMotion::theWireIsNoLag()
{
    for (const double rate : {700.0, 200.0}) {
        const Motion motion = simulated_leg::trapezoid(0, 2000, 3000, 30000);
        const SweepLeg leg = simulated_leg::measure(limitsFor(3000, 30000), 0, 2000, motion, 2,
                                                    {rate, 0.4, 0, 0.8 / rate});
        VERIFY_NEAR(leg.followingError, 0, 3);
    }
}

void TestLegMotion::movingFlag()
{
    const SweepAxis axis = limitsFor(1000, 10000);
    const Motion motion =
        simulated_leg::later(simulated_leg::trapezoid(0, 1500, 1000, 10000), 0.02); // 1.6 s
    const auto right = [](double at) { return at > 0.02 && at < 1.7; };
    QCOMPARE(flagWrong(axis, 1500, motion, right), std::optional(false));
    // It takes its time to rise and to fall.
    const auto late = [](double at) { return at > 0.09 && at < 2.0; };
    QCOMPARE(flagWrong(axis, 1500, motion, late), std::optional(false));
    QCOMPARE(flagWrong(axis, 1500, motion, [](double) { return true; }), std::optional(true));
    QCOMPARE(flagWrong(axis, 1500, motion, [](double) { return false; }), std::optional(true));
    const auto early = [](double at) { return at < 1.0; };
    QCOMPARE(flagWrong(axis, 1500, motion, early), std::optional(true));
    // A servo that slowly gets going is on its way.
    const SweepAxis lazy = limitsFor(50, 10);
    const Motion slow = simulated_leg::trapezoid(0, 60, 50, 10);
    const auto whole = [](double at) { return at < 5; };
    QCOMPARE(flagWrong(lazy, 60, slow, whole), std::optional(false));
}

void TestLegMotion::movingFlagAtFewReadings()
{
    const SweepAxis axis = limitsFor(1000, 10000);
    const Motion motion =
        simulated_leg::later(simulated_leg::trapezoid(0, 1500, 1000, 10000), 0.02);
    const auto right = [](double at) { return at > 0.02 && at < 1.7; };
    QCOMPARE(flagWrong(axis, 1500, motion, right, 10), std::optional(false));
    QCOMPARE(flagWrong(
                 axis, 1500, motion, [](double) { return true; }, 10),
             std::optional(true));
    QCOMPARE(flagWrong(
                 axis, 1500, motion, [](double) { return false; }, 10),
             std::optional(true));
}

void TestLegMotion::arrives()
{
    for (unsigned seed = 1; seed <= 50; ++seed) {
        // 12 steps before 1000 after 1.088 s, 4 before it after 1.096 s; a rest of 0.1 s.
        const Motion motion = simulated_leg::trapezoid(0, 1000, 1000, 10000);
        const double yes = firstTimeTrue(
            motion, simulated_leg::meter(limitsFor(1000, 10000), 0, 1000), 3, {200, 2, 0, 0, seed},
            [](const LegMeter& meter) { return meter.arrived(milliseconds(100)); });
        QVERIFY2(yes > 1.14 && yes < 1.25, QByteArray::number(yes).constData());
    }
    // Where it stood already.
    const double there = firstTimeTrue(
        [](double) { return 5; }, simulated_leg::meter(limitsFor(1000), 0, 5), 1, {200, 1},
        [](const LegMeter& meter) { return meter.arrived(milliseconds(100)); });
    QVERIFY(there >= 0.1 && there < 0.12);
    QVERIFY(!simulated_leg::meter(limitsFor(1000), 0, 5).arrived({}));
}

void TestLegMotion::doesNotArriveInPassing()
{
    const auto arrived = [](const LegMeter& meter) { return meter.arrived(milliseconds(100)); };
    const Motion through = simulated_leg::trapezoid(0, 2000, 800, 8000);
    QCOMPARE(
        firstTimeTrue(through, simulated_leg::meter(limitsFor(800), 0, 1000), 4, {300, 1}, arrived),
        -1.0);
    const Motion ringing = simulated_leg::secondOrder(0, 1000, 2, 0.3);
    const auto truth = simulated_leg::groundTruth(ringing, 1000, 12, 4);
    const double yes = firstTimeTrue(ringing, simulated_leg::meter(limitsFor(9999), 0, 1000), 4,
                                     {300, 1}, arrived);
    QVERIFY(yes > truth.arrival + truth.settling);
}

/// Blocked half way, or from the start: seen half a second after it could have moved, not before.
void TestLegMotion::stalls()
{
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const Motion halfWay = [](double t) { return std::min(500.0, 1000 * t); };
        const double seen = detectedStallTime(limitsFor(1000), 1000, halfWay, 3, seed);
        QVERIFY2(seen >= 0.98 && seen < 1.3, QByteArray::number(seen).constData());
    }
    const double stuck = detectedStallTime(
        limitsFor(1000, 100), 1000, [](double) { return 0; }, 3);
    QVERIFY2(stuck >= 0.5 && stuck < 0.9, QByteArray::number(stuck).constData());
    QVERIFY(detectedStallTime(
                limitsFor(1000), -1000, [](double) { return 0; }, 3) > 0);
}

void TestLegMotion::staticErrorIsNoStall()
{
    for (const double rest : {960.0, 1000.0, 1040.0}) {
        const Motion motion = simulated_leg::trapezoid(0, rest, 1000, 10000);
        QCOMPARE(detectedStallTime(limitsFor(1000, 10000), 1000, motion, 5), -1.0);
    }
}

void TestLegMotion::slowIsNoStall()
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        for (const double rate : {10.0, 200.0}) {
            const Motion slowMotion = simulated_leg::trapezoid(0, 300, 10, 100);
            QCOMPARE(detectedStallTime(limitsFor(10, 100), 300, slowMotion, 25, seed, rate), -1.0);
            const Motion lazy = simulated_leg::trapezoid(0, 3000, 1000, 20);
            QCOMPARE(detectedStallTime(limitsFor(1000, 20), 3000, lazy, 5, seed, rate), -1.0);
        }
    }
}

/// Nobody says of a servo that does not answer that it stands still.
void TestLegMotion::silenceIsNoStall()
{
    LegMeter meter = simulated_leg::meter(limitsFor(1000), 0, 1000);
    for (int ms = 5; ms < 5000; ms += 5) {
        SweepSample sample;
        sample.at = milliseconds(ms);
        sample.answered = ms < 100;
        if (sample.answered)
            sample.position = ms;
        meter.add(sample);
        QVERIFY(!meter.isStalled(milliseconds(500)));
    }
}

/// Half a period from 0 to 1000 in a second, the servo 30 ms behind: 47 steps where it is fastest.
void TestLegMotion::sine()
{
    const auto goal = [](double t) { return 500 - 500 * std::cos(std::numbers::pi * t); };
    LegMeter meter = simulated_leg::meter(limitsFor(3000), 0, 1000);
    meter.followPath([&](base::Duration since) { return goal(simulated_leg::seconds(since)); },
                     seconds(2));
    simulated_leg::read([&](double t) { return goal(t - 0.03); }, 1, {200, 0.4},
                        [&](SweepSample sample) {
                            sample.moving = true;
                            meter.add(sample);
                            QVERIFY(!meter.isStalled(milliseconds(200)));
                        });
    const SweepLeg leg = meter.finish(seconds(1), {});
    const double fastest = 500 * std::numbers::pi;
    VERIFY_NEAR(leg.followingError, 0.025 * fastest, 4); // 5 of the 30 ms may be the wire's
    VERIFY_NEAR(leg.phaseLag, 0.025 / 2 * 360, 0.5);
    VERIFY_NEAR(leg.topSpeed, fastest, 0.02 * fastest);
    QVERIFY(!leg.missed && !leg.timeToTarget && !leg.settling && !leg.steadyError);
    QVERIFY(!leg.overshoot);
    QCOMPARE(leg.flagWrong, std::optional(false));
}

SERVODESK_GUILESS_TEST(TestLegMotion)
#include "tst_leg_motion.moc"

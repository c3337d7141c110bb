// SPDX-License-Identifier: GPL-3.0-or-later
// Where a sweep goes, leg by leg, in every shape; and how long a move takes, held against a motion
// that is added up in small steps of time.
#include "jobs/sweep/sweep_path.h"
#include "support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>

using base::Duration;
using jobs::SweepPath;
using results::SweepAxis;
using results::SweepShape;
using results::SweepSpec;
using std::chrono::milliseconds;
using Targets = QVector<double>;

namespace {
SweepPath path(SweepShape shape, const SweepAxis& axis, std::uint32_t seed = 1)
{
    SweepSpec spec;
    spec.shape = shape;
    spec.seed = seed;
    return SweepPath(spec, axis);
}

SweepAxis between(double from, double to, double step = 0)
{
    SweepAxis axis;
    axis.from = from;
    axis.to = to;
    axis.step = step;
    return axis;
}

Targets targets(const SweepPath& path, int legs)
{
    Targets found{path.first()};
    for (int leg = 1; leg <= legs; ++leg)
        found.append(path.leg(leg).target);
    return found;
}

/// A motor that speeds up, and brakes when it must, a microsecond after the other.
struct MotorModel {
    double place = 0;
    double speed = 0;
    double at = 0;

    void step(double way, double top, double acceleration)
    {
        constexpr double tick = 1e-5;
        const bool brake = speed * speed / (2 * acceleration) >= way - place;
        speed = brake ? speed - acceleration * tick : std::min(top, speed + acceleration * tick);
        place += speed * tick;
        at += tick;
    }
};
} // namespace

class TestSweepPath : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void sweepGoesThereAndBack();
    void stepsGoUpAndDown_data();
    void stepsGoUpAndDown();
    void theMiddleIsApproachedFromBothSides();
    void aListIsDoneOnceACycle();
    void randomTargetsKeepApart_data();
    void randomTargetsKeepApart();
    void randomTargetsAreTheSameEverywhere();
    void manyLegsAreCheap_data();
    void manyLegsAreCheap();
    void sineSwingsBetweenTheEnds();
    void travelTimeMatchesTheMotion_data();
    void travelTimeMatchesTheMotion();
    void withoutSpeedThereIsNoPlan();
};

void TestSweepPath::sweepGoesThereAndBack()
{
    const SweepPath sweep = path(SweepShape::Sweep, between(3000, 1000));
    QCOMPARE(targets(sweep, 4), Targets({3000, 1000, 3000, 1000, 3000}));
    QCOMPARE(sweep.legsPerCycle(), 2);
    QCOMPARE(sweep.leg(2).cycle, 1);
    QCOMPARE(sweep.leg(3).cycle, 2);
}

void TestSweepPath::stepsGoUpAndDown_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("step");
    QTest::addColumn<Targets>("expected");
    QTest::newRow("even") << 0.0 << 30.0 << 10.0 << Targets{0, 10, 20, 30, 20, 10, 0, 10};
    QTest::newRow("shorter last") << 0.0 << 25.0 << 10.0 << Targets{0, 10, 20, 25, 20, 10, 0, 10};
    QTest::newRow("downwards") << 25.0 << 0.0 << 10.0 << Targets{25, 15, 5, 0, 5, 15, 25, 15};
    QTest::newRow("several turns")
        << -9000.0 << 9000.0 << 9000.0 << Targets{-9000, 0, 9000, 0, -9000, 0};
    QTest::newRow("too long") << 0.0 << 5.0 << 10.0 << Targets{0, 5, 0, 5};
    QTest::newRow("fractions") << 0.0 << 0.3 << 0.1 << Targets{0, 0.1, 0.2, 0.3, 0.2};
}

void TestSweepPath::stepsGoUpAndDown()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, step);
    QFETCH(Targets, expected);
    const SweepPath stairs = path(SweepShape::Stairs, between(from, to, step));
    const Targets found = targets(stairs, int(expected.size()) - 1);
    for (qsizetype i = 0; i < expected.size(); ++i)
        QVERIFY2(std::abs(found[i] - expected[i]) < 1e-9, qPrintable(QString::number(i)));
    const int up = int(std::max_element(expected.begin(), expected.end(),
                                        [&](double one, double other) {
                                            return std::abs(one - from) < std::abs(other - from);
                                        }) -
                       expected.begin());
    QCOMPARE(stairs.legsPerCycle(), 2 * up);
    QCOMPARE(stairs.leg(2 * up).cycle, 1);
    QCOMPARE(stairs.leg(2 * up + 1).cycle, 2);
}

void TestSweepPath::theMiddleIsApproachedFromBothSides()
{
    const SweepPath both = path(SweepShape::BothSides, between(1000, 3000));
    QCOMPARE(targets(both, 5), Targets({1000, 2000, 3000, 2000, 1000, 2000}));
    QCOMPARE(both.legsPerCycle(), 4);
    // No goal register takes half a step.
    QCOMPARE(path(SweepShape::BothSides, between(0, 5)).leg(1).target, 3.0);
}

void TestSweepPath::aListIsDoneOnceACycle()
{
    SweepSpec spec;
    spec.shape = SweepShape::Points;
    const QString any = QStringLiteral("0");
    spec.points = {{any, milliseconds(1)}, {any, {}}, {any, milliseconds(3)}};
    SweepAxis axis = between(10, 30);
    axis.points = {10, 30, 20};
    const SweepPath list(spec, axis);
    QCOMPARE(targets(list, 4), Targets({10, 30, 20, 10, 30}));
    QCOMPARE(list.legsPerCycle(), 3);
    QCOMPARE(list.leg(3).cycle, 1);
    QCOMPARE(list.leg(4).cycle, 2);
    QVERIFY(!list.leg(1).pause);
    QCOMPARE(list.leg(2).pause, std::optional<Duration>(milliseconds(3)));
    QCOMPARE(list.leg(3).pause, std::optional<Duration>(milliseconds(1)));

    const SweepPath none(spec, between(7, 9));
    QCOMPARE(targets(none, 2), Targets({7, 7, 7}));
}

void TestSweepPath::randomTargetsKeepApart_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::newRow("a turn") << 0.0 << 4095.0;
    QTest::newRow("downwards, several turns") << 28672.0 << -28672.0;
    QTest::newRow("few steps") << 500.0 << 521.0;
    QTest::newRow("two steps") << 0.0 << 2.0;
    QTest::newRow("one step") << 0.0 << 1.0;
}

void TestSweepPath::randomTargetsKeepApart()
{
    QFETCH(double, from);
    QFETCH(double, to);
    const double range = std::abs(to - from);
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const Targets found = targets(path(SweepShape::Random, between(from, to), seed), 2000);
        QCOMPARE(found.front(), from);
        for (qsizetype i = 1; i < found.size(); ++i) {
            QVERIFY(found[i] >= std::min(from, to) && found[i] <= std::max(from, to));
            QVERIFY(std::abs(found[i] - found[i - 1]) >= std::max(1.0, range / 20));
            QCOMPARE(std::floor(found[i] - from), found[i] - from);
        }
        if (range < 100)
            continue;
        // Both halves and both ends of the range get their share.
        const auto share = [&](double below) {
            return double(std::count_if(
                       found.begin(), found.end(),
                       [&](double target) { return std::abs(target - from) < below * range; })) /
                   double(found.size());
        };
        QVERIFY(std::abs(share(0.5) - 0.5) < 0.05);
        QVERIFY(share(0.1) > 0.06 && share(0.9) < 0.94);
    }
}

void TestSweepPath::randomTargetsAreTheSameEverywhere()
{
    const SweepPath one = path(SweepShape::Random, between(0, 4095), 7);
    const SweepPath again = path(SweepShape::Random, between(0, 4095), 7);
    const SweepPath other = path(SweepShape::Random, between(0, 4095), 8);
    QVERIFY(targets(one, 50) == targets(again, 50));
    QVERIFY(targets(one, 50) != targets(other, 50));
    // Worked out by an own small program; another library, compiler or machine must say the same.
    QCOMPARE(targets(one, 6), Targets({0, 1074, 3737, 3353, 803, 1381, 2045}));
}

void TestSweepPath::manyLegsAreCheap_data()
{
    QTest::addColumn<SweepShape>("shape");
    QTest::newRow("sweep") << SweepShape::Sweep;
    QTest::newRow("stairs") << SweepShape::Stairs;
    QTest::newRow("both sides") << SweepShape::BothSides;
    QTest::newRow("random") << SweepShape::Random;
    QTest::newRow("sine") << SweepShape::Sine;
}

/// Asked the other way round, and for the last leg there can be: the same, and nobody waits.
void TestSweepPath::manyLegsAreCheap()
{
    QFETCH(SweepShape, shape);
    const SweepPath shaped = path(shape, between(0, 4095, 100));
    const Targets forwards = targets(shaped, 100);
    const int last = std::numeric_limits<int>::max();
    for (int leg = 100; leg >= 1; --leg) {
        QVERIFY(shaped.leg(last - leg).target >= 0);
        QCOMPARE(shaped.leg(leg).target, forwards[leg]);
    }
    QVERIFY(shaped.leg(last).target <= 4095);
    QVERIFY(shaped.leg(last).cycle >= last / shaped.legsPerCycle());
}

void TestSweepPath::sineSwingsBetweenTheEnds()
{
    SweepSpec spec;
    spec.shape = SweepShape::Sine;
    spec.period = std::chrono::seconds(2);
    const SweepPath sine(spec, between(1000, 3000));
    QCOMPARE(sine.first(), 1000.0);
    QCOMPARE(sine.sineTarget(Duration(0)), 1000.0);
    QCOMPARE(sine.sineTarget(milliseconds(500)), 2000.0);
    QCOMPARE(sine.sineTarget(milliseconds(1000)), 3000.0);
    QCOMPARE(sine.sineTarget(milliseconds(1500)), 2000.0);
    QCOMPARE(sine.sineTarget(std::chrono::hours(10) + milliseconds(500)), 2000.0);
    QCOMPARE(targets(sine, 2), Targets({1000, 3000, 1000}));
    spec.period = {};
    QCOMPARE(SweepPath(spec, between(1000, 3000)).sineTarget(milliseconds(5)), 1000.0);
}

void TestSweepPath::travelTimeMatchesTheMotion_data()
{
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("acceleration");
    QTest::newRow("trapezoid") << 2000.0 << 1500.0 << 5000.0;
    QTest::newRow("just a triangle") << 450.0 << 1500.0 << 5000.0;
    QTest::newRow("triangle") << 100.0 << 3000.0 << 1000.0;
    QTest::newRow("several turns") << 28672.0 << 3400.0 << 20000.0;
}

void TestSweepPath::travelTimeMatchesTheMotion()
{
    QFETCH(double, way);
    QFETCH(double, speed);
    QFETCH(double, acceleration);
    SweepAxis axis;
    axis.speed = speed;
    axis.acceleration = acceleration;
    MotorModel mover;
    while (mover.place < way && mover.speed >= 0) {
        for (const double sign : {1.0, -1.0}) {
            const auto planned = jobs::plannedPosition(500, 500 + sign * way,
                                                       Duration(qRound64(mover.at * 1e6)), axis);
            QVERIFY(planned);
            QVERIFY(std::abs(*planned - (500 + sign * mover.place)) < 0.5);
        }
        for (int i = 0; i < 500; ++i)
            mover.step(way, speed, acceleration);
    }
    const double took = double(jobs::travelTime(-way, axis)->count()) / 1e6;
    QVERIFY(std::abs(took - mover.at) < 0.01 * mover.at + 0.006);
    QCOMPARE(jobs::plannedPosition(500, 500 + way, std::chrono::hours(1), axis), 500 + way);
    QCOMPARE(jobs::plannedPosition(500, 500 + way, milliseconds(-1), axis), 500.0);
}

void TestSweepPath::withoutSpeedThereIsNoPlan()
{
    SweepAxis axis;
    axis.acceleration = 1000;
    QVERIFY(!jobs::travelTime(100, axis));
    QVERIFY(!jobs::plannedPosition(0, 100, milliseconds(1), axis));
    axis.speed = 0;
    QVERIFY(!jobs::travelTime(100, axis));
    axis.speed = 1000;
    axis.acceleration.reset(); // at once
    QCOMPARE(jobs::travelTime(500, axis), std::optional<Duration>(milliseconds(500)));
    QCOMPARE(jobs::plannedPosition(0, -500, milliseconds(100), axis), std::optional(-100.0));
    QCOMPARE(jobs::travelTime(0, axis), std::optional<Duration>(Duration(0)));
    QCOMPARE(jobs::plannedPosition(9, 9, milliseconds(100), axis), std::optional(9.0));
}

SERVODESK_GUILESS_TEST(TestSweepPath)
#include "tst_sweep_path.moc"

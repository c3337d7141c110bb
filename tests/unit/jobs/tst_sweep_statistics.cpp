// SPDX-License-Identifier: GPL-3.0-or-later
// From legs to figures and grades: what is judged, over what it was counted, and that nothing that
// was not measured, or is no number, ever passes.
#include "jobs/sweep/sweep_statistics.h"
#include "support/test_main.h"

#include <QtTest>

#include <cmath>
#include <limits>

using results::Grade;
using results::SweepErrors;
using results::SweepLeg;
using results::SweepLimit;
using results::SweepLimits;
using results::SweepMetric;
using std::chrono::milliseconds;

namespace {
constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

SweepLeg leg(double start, double target, double error)
{
    SweepLeg one;
    one.start = start;
    one.target = target;
    one.reached = target + error;
    one.steadyError = error;
    one.timeToTarget = milliseconds(500);
    one.samples = 100;
    return one;
}

SweepMetric metric(const std::vector<SweepMetric>& all, const char* key)
{
    for (const SweepMetric& one : all) {
        if (one.key == QLatin1StringView(key))
            return one;
    }
    return {};
}

SweepMetric metric(const std::vector<SweepLeg>& legs, const char* key)
{
    return metric(jobs::sweepMetrics(legs, {}, {}), key);
}

SweepLimit limit(const char* key, std::optional<double> warn, std::optional<double> fail,
                 bool atLeast = false)
{
    return {QString::fromLatin1(key), {}, warn, fail, atLeast};
}

Grade grade(std::optional<double> value, const SweepLimit& by)
{
    SweepMetric one;
    one.key = by.metric;
    one.value = value;
    results::SweepServo servo;
    servo.limits.lines = {by};
    const auto lines = results::evaluate(servo, {one}, results::SweepShape::Sweep);
    return lines.size() == 1 && (lines[0].value == value || std::isnan(value.value_or(0)))
               ? lines[0].grade
               : Grade::NotMeasured;
}
} // namespace

class TestSweepMeter : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void everyMetricIsPresentInOrder();
    void noMeasurementsGiveNoMetrics();
    void theRightLegIsEvaluated_data();
    void theRightLegIsEvaluated();
    void steadyErrorKeepsItsSign();
    void hysteresisIsTheDifferenceOfBothSides();
    void repeatabilityIsOfOneSide();
    void aTargetIsATenthOfAStep();
    void temperatureRisesFromTheStart();
    void counters();
    void nanIsNeverDropped();
    void limitsDetermineTheGrade();
    void theWorstLimitDecides();
};

void TestSweepMeter::everyMetricIsPresentInOrder()
{
    const auto metrics = jobs::sweepMetrics({leg(0, 100, 1)}, {}, {});
    const auto& kinds = results::sweepMetricKinds();
    QCOMPARE(metrics.size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        QCOMPARE(metrics[i].key, kinds[i].key);
        QCOMPARE(metrics[i].unit, kinds[i].unit);
    }
}

void TestSweepMeter::noMeasurementsGiveNoMetrics()
{
    for (const auto& legs : {std::vector<SweepLeg>{}, std::vector<SweepLeg>{SweepLeg{}}}) {
        for (const SweepMetric& one : jobs::sweepMetrics(legs, {}, 20)) {
            QVERIFY2(!one.value && !one.mean && !one.min && !one.max, qPrintable(one.key));
            QCOMPARE(one.count, std::uint64_t(0));
        }
    }
}

void TestSweepMeter::theRightLegIsEvaluated_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<double>("judged");
    QTest::newRow("time") << QByteArray("time_to_target") << 200.0;
    QTest::newRow("settling") << QByteArray("settling") << 300.0;
    QTest::newRow("overshoot") << QByteArray("overshoot") << 3.0;
    QTest::newRow("following") << QByteArray("following_error") << 3.0;
    QTest::newRow("mean speed") << QByteArray("mean_speed") << 2.0;
    QTest::newRow("top speed") << QByteArray("top_speed") << 2.0;
    QTest::newRow("current peak") << QByteArray("current_peak") << 3.0;
    QTest::newRow("current mean") << QByteArray("current_mean") << 3.0;
    QTest::newRow("load peak") << QByteArray("load_peak") << 3.0;
    QTest::newRow("load mean") << QByteArray("load_mean") << 3.0;
    QTest::newRow("voltage") << QByteArray("voltage_min") << 1.0;
    QTest::newRow("temperature") << QByteArray("temperature_max") << 3.0;
}

/// Legs with 1, 2 and 3 (times: 100, 200, 300 ms), and one that measured nothing.
void TestSweepMeter::theRightLegIsEvaluated()
{
    QFETCH(QByteArray, key);
    QFETCH(double, judged);
    std::vector<SweepLeg> legs;
    for (const int n : {2, 3, 1}) {
        SweepLeg one;
        one.timeToTarget = one.settling = milliseconds(100 * n);
        for (const auto member : {&SweepLeg::overshoot, &SweepLeg::followingError,
                                  &SweepLeg::meanSpeed, &SweepLeg::topSpeed, &SweepLeg::currentPeak,
                                  &SweepLeg::currentMean, &SweepLeg::loadPeak, &SweepLeg::loadMean,
                                  &SweepLeg::voltageMin, &SweepLeg::temperatureMax})
            one.*member = n;
        legs.push_back(one);
    }
    legs.emplace_back();
    const SweepMetric found = metric(legs, key.constData());
    const double unit = judged > 99 ? 100 : 1;
    QCOMPARE(found.value, std::optional(judged));
    QCOMPARE(found.mean, std::optional(2 * unit));
    QCOMPARE(found.min, std::optional(unit));
    QCOMPARE(found.max, std::optional(3 * unit));
    QCOMPARE(found.count, std::uint64_t(3));
}

void TestSweepMeter::steadyErrorKeepsItsSign()
{
    const SweepMetric found =
        metric({leg(0, 100, 2), leg(100, 0, -5), leg(0, 100, 3)}, "steady_error");
    QCOMPARE(found.value, std::optional(5.0));
    QCOMPARE(found.mean, std::optional(0.0));
    QCOMPARE(found.min, std::optional(-5.0));
    QCOMPARE(found.max, std::optional(3.0));
}

/// 12 steps at one target, 4 at another, where noise also moves single legs; the ends, come to from
/// one side only, have none.
void TestSweepMeter::hysteresisIsTheDifferenceOfBothSides()
{
    std::vector<SweepLeg> legs{
        leg(0, 2000, -7), leg(2000, 4000, -6), leg(4000, 2000, 6), leg(2000, 0, 6),
        leg(0, 2000, -5), leg(4000, 2000, 6),  leg(0, 1000, -1),   leg(2000, 1000, 3),
    };
    SweepLeg moving = leg(0, 2000, 0); // still under way at its end
    moving.steadyError.reset();
    moving.reached = 500;
    legs.push_back(moving);
    const SweepMetric found = metric(legs, "hysteresis");
    QCOMPARE(found.value, std::optional(12.0));
    QCOMPARE(found.min, std::optional(4.0));
    QCOMPARE(found.mean, std::optional(8.0));
    QCOMPARE(found.count, std::uint64_t(2));

    QVERIFY(!metric({leg(0, 100, 1), leg(100, 0, 1), leg(0, 100, 1)}, "hysteresis").value);
}

/// A servo with 12 steps of hysteresis that is otherwise perfect repeats perfectly.
void TestSweepMeter::repeatabilityIsOfOneSide()
{
    std::vector<SweepLeg> legs{leg(0, 50, -6), leg(99, 50, 6), leg(0, 50, -6), leg(99, 50, 6)};
    QCOMPARE(metric(legs, "repeatability_sigma").value, std::optional(0.0));
    QCOMPARE(metric(legs, "repeatability_range").value, std::optional(0.0));
    QCOMPARE(metric(legs, "repeatability_range").count, std::uint64_t(1));

    // 1, 2, 3, 4 around their mean of 2.5: √(5/3); the other side and another target are better.
    for (const double error : {1.0, 2.0, 3.0, 4.0})
        legs.push_back(leg(0, 70, error));
    legs.push_back(leg(99, 70, 2));
    legs.push_back(leg(99, 70, 3));
    const SweepMetric sigma = metric(legs, "repeatability_sigma");
    QVERIFY(std::abs(*sigma.value - std::sqrt(5.0 / 3)) < 1e-12);
    QCOMPARE(sigma.count, std::uint64_t(2));
    QCOMPARE(sigma.min, std::optional(0.0));
    QCOMPARE(metric(legs, "repeatability_range").value, std::optional(3.0));

    // Once from each side is not twice.
    QVERIFY(!metric({leg(0, 50, 1), leg(99, 50, 5)}, "repeatability_sigma").value);
    QVERIFY(!metric({leg(0, 50, 1), leg(0, 60, 5)}, "repeatability_range").value);
}

void TestSweepMeter::aTargetIsATenthOfAStep()
{
    const std::vector<SweepLeg> near{leg(0, 50.01, 1), leg(0, 49.99, 3)};
    QCOMPARE(metric(near, "repeatability_range").value, std::optional(2.0));
    const std::vector<SweepLeg> far{leg(0, 50, 1), leg(0, 50.2, 3)};
    QVERIFY(!metric(far, "repeatability_range").value);
    // No way, no side.
    QVERIFY(!metric({leg(50, 50, 1), leg(50, 50, 3)}, "repeatability_range").value);
}

void TestSweepMeter::temperatureRisesFromTheStart()
{
    std::vector<SweepLeg> legs{leg(0, 1, 0), leg(0, 1, 0), leg(0, 1, 0)};
    legs[0].temperatureMax = 31;
    legs[2].temperatureMax = 44;
    const SweepMetric rise = metric(jobs::sweepMetrics(legs, {}, 30), "temperature_rise");
    QCOMPARE(rise.value, std::optional(14.0));
    QCOMPARE(rise.min, std::optional(1.0));
    QCOMPARE(rise.count, std::uint64_t(2));
    const auto unknown = jobs::sweepMetrics(legs, {}, {});
    QVERIFY(!metric(unknown, "temperature_rise").value);
    QCOMPARE(metric(unknown, "temperature_max").value, std::optional(44.0));
}

void TestSweepMeter::counters()
{
    std::vector<SweepLeg> legs{leg(0, 9, 0), leg(0, 9, 0), leg(0, 9, 0), leg(0, 9, 0)};
    legs[0].flagWrong = false;
    legs[1].flagWrong = true;
    legs[1].timeToTarget.reset();
    legs[1].missed = true;
    legs[2].alarms = 32;
    legs[3].timeToTarget.reset(); // of a sine: no target, none missed
    legs[3].samples = 0;          // and nothing heard
    SweepErrors errors;
    errors.asked = 1000;
    errors.timeouts = 1;
    errors.badChecksums = 2;
    errors.foreign = 3;
    errors.late = 4;
    const auto found = jobs::sweepMetrics(legs, errors, {});
    const auto is = [&](const char* key, double value, std::uint64_t count) {
        const SweepMetric one = metric(found, key);
        return one.value == value && one.count == count && !one.mean && !one.min && !one.max;
    };
    QVERIFY(is("moving_flag_errors", 1, 2));
    QVERIFY(is("missed_targets", 1, 3));
    QVERIFY(is("alarms", 1, 3));
    QVERIFY(is("communication_errors", 10, 1000));

    legs[0].flagWrong = legs[1].flagWrong = std::nullopt;
    QVERIFY(!metric(legs, "moving_flag_errors").value);
}

void TestSweepMeter::nanIsNeverDropped()
{
    for (const std::size_t place : {0U, 1U, 2U}) {
        std::vector<SweepLeg> legs{leg(0, 9, 1), leg(0, 9, 1), leg(0, 9, 1)};
        legs[place].overshoot = legs[place].steadyError = legs[place].meanSpeed = noNumber;
        legs[place].voltageMin = noNumber;
        legs[(place + 1) % 3].voltageMin = 12;
        for (const char* key : {"overshoot", "steady_error", "mean_speed", "voltage_min",
                                "repeatability_sigma", "repeatability_range"}) {
            const SweepMetric found = metric(legs, key);
            QVERIFY2(found.value && std::isnan(*found.value), key);
            QCOMPARE(grade(found.value, limit(key, {}, 1000, false)), Grade::Fail);
        }
    }
}

void TestSweepMeter::limitsDetermineTheGrade()
{
    const SweepLimit both = limit("overshoot", 3, 5);
    QCOMPARE(grade(3, both), Grade::Pass);
    QCOMPARE(grade(3.1, both), Grade::Warn);
    QCOMPARE(grade(5, both), Grade::Warn);
    QCOMPARE(grade(5.1, both), Grade::Fail);
    QCOMPARE(grade(noNumber, both), Grade::Fail);
    QCOMPARE(grade(std::numeric_limits<double>::infinity(), both), Grade::Fail);
    QCOMPARE(grade(std::nullopt, both), Grade::NotMeasured);
    QCOMPARE(grade(1000, limit("overshoot", 3, {})), Grade::Warn);
    QCOMPARE(grade(noNumber, limit("overshoot", 3, {})), Grade::Fail);
    QCOMPARE(grade(4, limit("overshoot", {}, 5)), Grade::Pass);
    QCOMPARE(grade(6, limit("overshoot", {}, 5)), Grade::Fail);
    QCOMPARE(grade(1, limit("overshoot", {}, noNumber)), Grade::Fail);

    const SweepLimit volts = limit("voltage_min", 11, 10, true);
    QCOMPARE(grade(11, volts), Grade::Pass);
    QCOMPARE(grade(10.9, volts), Grade::Warn);
    QCOMPARE(grade(9.9, volts), Grade::Fail);

    // Crossed limits (which no file may have): the worse one decides.
    QCOMPARE(grade(4, limit("overshoot", 5, 3)), Grade::Fail);

    results::SweepServo servo;
    servo.limits.lines = {limit("no_such", {}, 1)};
    QCOMPARE(results::evaluate(servo, {}, results::SweepShape::Sweep).front().grade,
             Grade::NotMeasured);
}

void TestSweepMeter::theWorstLimitDecides()
{
    const auto of = [](std::vector<Grade> grades) {
        std::vector<results::VerdictLine> lines;
        for (const Grade one : grades)
            lines.push_back({{}, {}, one});
        return results::worstGrade(lines);
    };
    QCOMPARE(of({}), Grade::NotMeasured);
    QCOMPARE(of({Grade::NotMeasured}), Grade::NotMeasured);
    QCOMPARE(of({Grade::NotMeasured, Grade::Pass}), Grade::Pass);
    QCOMPARE(of({Grade::Warn, Grade::Pass, Grade::NotMeasured}), Grade::Warn);
    QCOMPARE(of({Grade::Pass, Grade::Fail, Grade::Warn}), Grade::Fail);
}

SERVODESK_GUILESS_TEST(TestSweepMeter)
#include "tst_sweep_statistics.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Two sweep tests side by side: which figure is better, what makes them incomparable, and which
// settings differ.
#include "results/sweep_compare.h"
#include "support/test_main.h"
#include "support/text.h"
#include "unit/results/sweep_example.h"

#include <QtTest>

#include <limits>

using results::Better;
using results::DifferenceImpact;
using results::Grade;
using results::SweepComparison;
using results::SweepRun;
using results::TestItem;
using support::utf8;
using namespace std::chrono_literals;

namespace {
SweepComparison compared(const SweepRun& a, const SweepRun& b, std::size_t servoB = 0)
{
    return results::compareSweeps({utf8("1"), a, a.servos[0]}, {utf8("2"), b, b.servos[servoB]});
}

results::FigureDifference figure(const SweepComparison& comparison, const char* key)
{
    for (const auto& row : comparison.figures) {
        if (row.key == utf8(key))
            return row;
    }
    return {};
}

void setValue(SweepRun& run, const char* key, std::optional<double> value)
{
    for (results::SweepMetric& metric : run.servos[0].metrics) {
        if (metric.key == utf8(key))
            metric.value = value;
    }
}

using Change = std::function<void(SweepRun&)>;

void addRegister(SweepRun& run, const char* key, std::int64_t raw, double value,
                 catalog::Area area = catalog::Area::Eprom,
                 catalog::Access access = catalog::Access::ReadWrite)
{
    run.servos[0].parameters.registers.push_back(
        {utf8(key), 100, raw, value, utf8("deg"), area, access});
}
} // namespace

class TestSweepCompare : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(utf8(".*"))); }

    void identicalRunsHaveNoDifference();
    void theBetterRunIsNamed();
    void unmeasuredHasNoDifference();
    void gradesAreCompared();
    void differingTests_data();
    void differingTests();
    void stepShapeHasAStepAndSweepHasNone();
    void onlySettingsAreCompared();
    void servosAreFoundByTheirId();
};

void TestSweepCompare::identicalRunsHaveNoDifference()
{
    const SweepRun run = sweep_example::run();
    const SweepComparison same = compared(run, run);
    QVERIFY(same.tests.empty());
    QVERIFY(same.settings.empty());
    QVERIFY(same.comparable());
    QCOMPARE(same.figures.size(), results::sweepMetricKinds().size());
    for (const auto& row : same.figures) {
        QCOMPARE(row.difference.value(), 0.0);
        QVERIFY(row.better == Better::Neither);
    }
}

void TestSweepCompare::theBetterRunIsNamed()
{
    SweepRun a = sweep_example::run();
    SweepRun b = a;
    setValue(a, "overshoot", 3.0);
    setValue(b, "overshoot", 5.5);
    setValue(a, "hysteresis", 12);
    setValue(b, "hysteresis", 4);
    setValue(a, "voltage_min", 6.5);
    setValue(b, "voltage_min", 7.0); // more is better
    setValue(a, "mean_speed", 2500);
    setValue(b, "mean_speed", 2400);
    const SweepComparison found = compared(a, b);
    QCOMPARE(figure(found, "overshoot").difference.value(), 2.5);
    QCOMPARE(figure(found, "overshoot").unit, utf8("%"));
    QVERIFY(figure(found, "overshoot").better == Better::A);
    QCOMPARE(figure(found, "hysteresis").difference.value(), -8.0);
    QVERIFY(figure(found, "hysteresis").better == Better::B);
    QVERIFY(figure(found, "voltage_min").better == Better::B);
    QVERIFY(figure(found, "mean_speed").better == Better::A);
}

void TestSweepCompare::unmeasuredHasNoDifference()
{
    SweepRun a = sweep_example::run();
    SweepRun b = a;
    setValue(b, "current_peak", {});
    setValue(a, "load_peak", std::numeric_limits<double>::quiet_NaN());
    b.servos[0].metrics.pop_back();
    const SweepComparison found = compared(a, b);
    for (const char* key : {"current_peak", "load_peak", "alarms"}) {
        QVERIFY(!figure(found, key).difference);
        QVERIFY(figure(found, key).better == Better::Neither);
    }
    QVERIFY(figure(found, "current_peak").a);
    QVERIFY(!figure(found, "current_peak").b);
    QCOMPARE(found.figures.size(), results::sweepMetricKinds().size());
}

void TestSweepCompare::gradesAreCompared()
{
    SweepRun a = sweep_example::run();
    const auto line = [](const char* key, Grade grade) {
        return results::VerdictLine{{utf8(key), utf8("%"), 1.0, 2.0, false}, 1.5, grade};
    };
    a.servos[0].lines = {line("overshoot", Grade::Pass)};
    SweepRun b = a;
    b.servos[0].lines = {line("overshoot", Grade::Warn), line("overshoot", Grade::Fail),
                         line("overshoot", Grade::Pass)};
    const SweepComparison found = compared(a, b);
    QCOMPARE(figure(found, "overshoot").gradeA.value(), Grade::Pass);
    QCOMPARE(figure(found, "overshoot").gradeB.value(), Grade::Fail);
    QVERIFY(!figure(found, "alarms").gradeA);
}

void TestSweepCompare::differingTests_data()
{
    QTest::addColumn<Change>("change");
    QTest::addColumn<int>("item");
    QTest::addColumn<int>("weight");
    QTest::addColumn<QString>("b");
    const auto row = [](const char* name, TestItem item, DifferenceImpact weight, const char* b,
                        Change change) {
        QTest::newRow(name) << change << int(item) << int(weight) << utf8(b);
    };
    row("model", TestItem::Model, DifferenceImpact::Figure, "X",
        [](SweepRun& run) { run.servos[0].parameters.servo.model = utf8("X"); });
    row("firmware", TestItem::Firmware, DifferenceImpact::Figure, "9.9",
        [](SweepRun& run) { run.servos[0].parameters.servo.firmware = utf8("9.9"); });
    row("resolution", TestItem::Resolution, DifferenceImpact::Path, "1024",
        [](SweepRun& run) { run.servos[0].axis.stepsPerTurn = 1024; });
    row("simulated", TestItem::Simulated, DifferenceImpact::Figure, "false",
        [](SweepRun& run) { run.simulated = false; });
    row("shape", TestItem::Shape, DifferenceImpact::Path, "sweep",
        [](SweepRun& run) { run.spec.shape = results::SweepShape::Sweep; });
    row("range", TestItem::Range, DifferenceImpact::Path, "1000 … 3052",
        [](SweepRun& run) { run.servos[0].axis.to = 3052; });
    row("pace", TestItem::Pace, DifferenceImpact::Figure, "delay",
        [](SweepRun& run) { run.spec.pace = results::SweepPace::Delay; });
    row("pause", TestItem::Pause, DifferenceImpact::Figure, "1250",
        [](SweepRun& run) { run.spec.pause = 1250ms; });
    row("speed", TestItem::Speed, DifferenceImpact::Path, "",
        [](SweepRun& run) { run.servos[0].axis.speed.reset(); });
    row("acceleration", TestItem::Acceleration, DifferenceImpact::Path, "5000",
        [](SweepRun& run) { run.servos[0].axis.acceleration = 5000; });
    row("time", TestItem::MoveTime, DifferenceImpact::Path, "900",
        [](SweepRun& run) { run.spec.time = utf8("900"); });
    row("warm-up", TestItem::WarmUp, DifferenceImpact::Figure, "0",
        [](SweepRun& run) { run.spec.warmUp = {}; });
    row("tolerance", TestItem::Tolerance, DifferenceImpact::Figure, "4",
        [](SweepRun& run) { run.servos[0].axis.tolerance = 4; });
    row("cycles", TestItem::Cycles, DifferenceImpact::Figure, "2, 600 s",
        [](SweepRun& run) { run.spec.cycles = 2; });
    row("rate", TestItem::SampleRate, DifferenceImpact::Figure, "200",
        [](SweepRun& run) { run.sampleRate = 200; });
    row("end", TestItem::End, DifferenceImpact::Figure, "stopped",
        [](SweepRun& run) { run.end = results::SweepEnd::Stopped; });
    row("limits", TestItem::Limits, DifferenceImpact::Grade, "mine", [](SweepRun& run) {
        run.servos[0].limits.name = utf8("mine");
        run.servos[0].limits.lines.pop_back();
    });
}

void TestSweepCompare::differingTests()
{
    QFETCH(Change, change);
    QFETCH(int, item);
    QFETCH(int, weight);
    QFETCH(QString, b);
    const SweepRun one = sweep_example::run();
    SweepRun two = one;
    change(two);
    const SweepComparison found = compared(one, two);
    QCOMPARE(found.tests.size(), std::size_t(1));
    QCOMPARE(int(found.tests[0].item), item);
    QCOMPARE(int(found.tests[0].weight), weight);
    QCOMPARE(found.tests[0].b, b);
    QVERIFY(found.tests[0].a != b);
    QCOMPARE(found.comparable(), found.tests[0].weight != DifferenceImpact::Path);
}

/// A sweep's unused step, seed, points and period are nobody's business.
void TestSweepCompare::stepShapeHasAStepAndSweepHasNone()
{
    SweepRun one = sweep_example::run();
    SweepRun two = one;
    two.servos[0].axis.step = 11;
    two.servos[0].axis.points = {7};
    two.spec.seed = 3;
    two.spec.period = 7s;
    two.sampleRate = one.sampleRate * 1.2;
    const auto itemsOf = [&](results::SweepShape shape) {
        one.spec.shape = two.spec.shape = shape;
        QStringList items;
        for (const auto& difference : compared(one, two).tests)
            items.append(results::testItemName(difference.item));
        return items;
    };
    QCOMPARE(itemsOf(results::SweepShape::Sweep), QStringList());
    QCOMPARE(itemsOf(results::SweepShape::Stairs), QStringList(utf8("step")));
    QCOMPARE(itemsOf(results::SweepShape::Random), QStringList(utf8("seed")));
    QCOMPARE(itemsOf(results::SweepShape::Sine), QStringList(utf8("period")));
    QCOMPARE(itemsOf(results::SweepShape::Points), QStringList(utf8("points")));
}

void TestSweepCompare::onlySettingsAreCompared()
{
    SweepRun a = sweep_example::run();
    SweepRun b = a;
    using catalog::Access;
    using catalog::Area;
    addRegister(a, "position_p", 32, 32);
    addRegister(b, "position_p", 24, 24);
    addRegister(a, "torque_limit", 1000, 100, Area::Sram);
    addRegister(b, "torque_limit", 500, 50, Area::Sram);
    for (const char* key : {"id", "goal_position", "torque_switch", "lock", "move_angle"}) {
        addRegister(a, key, 1, 1, Area::Sram);
        addRegister(b, key, 2, 2, Area::Sram);
    }
    addRegister(a, "present_position", 1, 1, Area::Feedback, Access::ReadOnly);
    addRegister(b, "present_position", 2, 2, Area::Feedback, Access::ReadOnly);
    addRegister(a, "only_a", 7, 7);
    addRegister(b, "only_b", 8, 8);
    b.servos[0].parameters.registers[0].value = 90; // other unit of one raw value
    const auto settings = compared(a, b).settings;
    QStringList keys;
    for (const auto& row : settings)
        keys.append(row.key);
    QCOMPARE(keys, QStringList({utf8("min_angle"), utf8("position_p"), utf8("torque_limit"),
                                utf8("only_a"), utf8("only_b")}));
    QCOMPARE(settings[1].rawA.value(), std::int64_t(32));
    QCOMPARE(settings[1].rawB.value(), std::int64_t(24));
    QCOMPARE(settings[2].b.value(), 50.0);
    QVERIFY(!settings[3].rawB);
    QVERIFY(!settings[4].rawA);
}

void TestSweepCompare::servosAreFoundByTheirId()
{
    const SweepRun run = sweep_example::run();
    QCOMPARE(results::servoOf(run, 6), &run.servos[1]);
    QVERIFY(results::servoOf(run, 7) == nullptr);
    const SweepComparison found = compared(run, run, 1); // the good one with the bad one
    QVERIFY(!found.tests.empty());
    QCOMPARE(found.tests[0].a, utf8("STS3215"));
    QCOMPARE(found.tests[0].b, utf8("SCS15"));
}

SERVODESK_GUILESS_TEST(TestSweepCompare)
#include "tst_sweep_compare.moc"

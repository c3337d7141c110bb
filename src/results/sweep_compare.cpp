// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_compare.h"

#include "results/sweep_fields.h"

#include <QSet>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace results {
namespace {
constexpr double minRateRatio = 1.5;

const SweepMetric* metricOf(const SweepServo& servo, const QString& key)
{
    for (const SweepMetric& metric : servo.metrics) {
        if (metric.key == key)
            return &metric;
    }
    return nullptr;
}

std::optional<double> valueOf(const SweepServo& servo, const QString& key)
{
    const SweepMetric* metric = metricOf(servo, key);
    const bool number = metric && metric->value && std::isfinite(*metric->value);
    return number ? metric->value : std::nullopt;
}

/// The worse one, where two lines judge a figure.
std::optional<Grade> gradeOf(const SweepServo& servo, const QString& key)
{
    std::optional<Grade> worst;
    for (const VerdictLine& line : servo.lines) {
        const bool worse = !worst || line.grade == Grade::Fail ||
                           (line.grade == Grade::Warn && *worst == Grade::Pass);
        if (line.limit.metric == key && worse)
            worst = line.grade;
    }
    return worst;
}

FigureDifference figureOf(const SweepMetricKind& kind, const SweepServo& a, const SweepServo& b)
{
    FigureDifference row{kind.key, kind.unit, valueOf(a, kind.key), valueOf(b, kind.key)};
    row.gradeA = gradeOf(a, kind.key);
    row.gradeB = gradeOf(b, kind.key);
    if (!row.a || !row.b)
        return row;
    row.difference = *row.b - *row.a;
    if (*row.difference != 0)
        row.better = (*row.difference > 0) == kind.atLeast ? Better::B : Better::A;
    return row;
}

QString number(double value)
{
    return QString::number(value, 'g', 10);
}

QString number(std::optional<double> value)
{
    return value ? number(*value) : QString();
}

QString ms(base::Duration span)
{
    return number(double(span.count()) / usPerMs);
}

QString flag(bool value)
{
    return value ? QStringLiteral("true") : QStringLiteral("false");
}

QString range(const SweepAxis& axis)
{
    return number(axis.from) + QStringLiteral(" … ") + number(axis.to);
}

QString list(const std::vector<double>& points)
{
    QStringList texts;
    for (const double point : points)
        texts.append(number(point));
    return texts.join(QStringLiteral(", "));
}

QString length(const SweepSpec& spec)
{
    QStringList parts;
    if (spec.cycles > 0)
        parts.append(QString::number(spec.cycles));
    if (spec.length.count() > 0)
        parts.append(number(double(spec.length.count()) / 1e6) + QStringLiteral(" s"));
    return parts.join(QStringLiteral(", "));
}

/// The planned path, per servo in its own steps.
class TestDifferenceCollector {
public:
    explicit TestDifferenceCollector(std::vector<TestDifference>& found)
        : m_found(found)
    {}

    void check(TestItem item, DifferenceImpact weight, const QString& a, const QString& b)
    {
        if (a != b)
            m_found.push_back({item, weight, a, b});
    }

private:
    std::vector<TestDifference>& m_found;
};

void checkServos(const SweepSide& a, const SweepSide& b, TestDifferenceCollector& test)
{
    const snapshot::SnapshotServo& one = a.servo.parameters.servo;
    const snapshot::SnapshotServo& two = b.servo.parameters.servo;
    test.check(TestItem::Model, DifferenceImpact::Figure, one.model, two.model);
    test.check(TestItem::Firmware, DifferenceImpact::Figure, one.firmware, two.firmware);
    test.check(TestItem::Resolution, DifferenceImpact::Path, number(a.servo.axis.stepsPerTurn),
               number(b.servo.axis.stepsPerTurn));
    test.check(TestItem::Simulated, DifferenceImpact::Figure, flag(a.run.simulated),
               flag(b.run.simulated));
}

/// Only the parameters that the shape has.
void checkPath(const SweepSide& a, const SweepSide& b, TestDifferenceCollector& test)
{
    const SweepSpec& one = a.run.spec;
    const SweepSpec& two = b.run.spec;
    const SweepAxis& axisA = a.servo.axis;
    const SweepAxis& axisB = b.servo.axis;
    test.check(TestItem::Shape, DifferenceImpact::Path, sweepShapeName(one.shape),
               sweepShapeName(two.shape));
    const bool same = one.shape == two.shape;
    if (one.shape == SweepShape::Points && same)
        test.check(TestItem::Points, DifferenceImpact::Path, list(axisA.points),
                   list(axisB.points));
    else
        test.check(TestItem::Range, DifferenceImpact::Path, range(axisA), range(axisB));
    if (one.shape == SweepShape::Stairs && same)
        test.check(TestItem::Step, DifferenceImpact::Path, number(axisA.step), number(axisB.step));
    if (one.shape == SweepShape::Random && same)
        test.check(TestItem::Seed, DifferenceImpact::Path, QString::number(one.seed),
                   QString::number(two.seed));
    if (one.shape == SweepShape::Sine && same)
        test.check(TestItem::Period, DifferenceImpact::Path, ms(one.period), ms(two.period));
}

void checkMotion(const SweepSide& a, const SweepSide& b, TestDifferenceCollector& test)
{
    const SweepSpec& one = a.run.spec;
    const SweepSpec& two = b.run.spec;
    test.check(TestItem::Pace, DifferenceImpact::Figure, sweepPaceName(one.pace),
               sweepPaceName(two.pace));
    test.check(TestItem::Pause, DifferenceImpact::Figure, ms(one.pause), ms(two.pause));
    test.check(TestItem::Speed, DifferenceImpact::Path, number(a.servo.axis.speed),
               number(b.servo.axis.speed));
    test.check(TestItem::Acceleration, DifferenceImpact::Path, number(a.servo.axis.acceleration),
               number(b.servo.axis.acceleration));
    test.check(TestItem::MoveTime, DifferenceImpact::Path, one.time, two.time);
    test.check(TestItem::WarmUp, DifferenceImpact::Figure, ms(one.warmUp), ms(two.warmUp));
    test.check(TestItem::Tolerance, DifferenceImpact::Figure, number(a.servo.axis.tolerance),
               number(b.servo.axis.tolerance));
    test.check(TestItem::Cycles, DifferenceImpact::Figure, length(one), length(two));
}

void checkSampling(const SweepSide& a, const SweepSide& b, TestDifferenceCollector& test)
{
    const auto [slow, fast] = std::minmax(a.run.sampleRate, b.run.sampleRate);
    if (fast > slow * minRateRatio)
        test.check(TestItem::SampleRate, DifferenceImpact::Figure, number(a.run.sampleRate),
                   number(b.run.sampleRate));
    test.check(TestItem::End, DifferenceImpact::Figure, sweepEndName(a.run.end),
               sweepEndName(b.run.end));
    if (a.servo.limits.lines == b.servo.limits.lines)
        return;
    // Edited limits may have the same name.
    QString other = b.servo.limits.name;
    if (other == a.servo.limits.name)
        other += QStringLiteral(" (2)");
    test.check(TestItem::Limits, DifferenceImpact::Grade, a.servo.limits.name, other);
}

/// Writable, but a command, a position or a state, not a setting.
bool isSetting(const snapshot::SnapshotRegister& reg)
{
    static const QSet<QString> others{
        QStringLiteral("id"),          QStringLiteral("lock"),      QStringLiteral("torque_switch"),
        QStringLiteral("fault_reset"), QStringLiteral("load"),      QStringLiteral("motor_speed"),
        QStringLiteral("move_angle"),  QStringLiteral("move_time"), QStringLiteral("wait_angle"),
        QStringLiteral("wait_time")};
    return reg.access == catalog::Access::ReadWrite && reg.area != catalog::Area::Feedback &&
           !others.contains(reg.key) && !reg.key.startsWith(QStringLiteral("goal_"));
}

const snapshot::SnapshotRegister* registerOf(const snapshot::Snapshot& snapshot, const QString& key)
{
    for (const snapshot::SnapshotRegister& reg : snapshot.registers) {
        if (reg.key == key)
            return &reg;
    }
    return nullptr;
}

std::vector<SettingDifference> settingsOf(const snapshot::Snapshot& a, const snapshot::Snapshot& b)
{
    std::vector<SettingDifference> found;
    for (const snapshot::SnapshotRegister& reg : a.registers) {
        if (!isSetting(reg))
            continue;
        const snapshot::SnapshotRegister* other = registerOf(b, reg.key);
        SettingDifference row{reg.key, reg.raw, {}, reg.value, {}, reg.unit};
        if (other) {
            row.rawB = other->raw;
            row.b = other->value;
        }
        // Two maps may have different units for one quantity.
        const bool same = row.rawA == row.rawB && row.a == row.b;
        if (!same)
            found.push_back(std::move(row));
    }
    for (const snapshot::SnapshotRegister& reg : b.registers) {
        if (isSetting(reg) && reg.raw && !registerOf(a, reg.key))
            found.push_back({reg.key, {}, reg.raw, {}, reg.value, reg.unit});
    }
    return found;
}

constexpr std::array itemNames{
    "model",     "firmware", "resolution", "simulated", "shape",       "range",  "step",
    "points",    "seed",     "period",     "pace",      "pause",       "speed",  "acceleration",
    "move-time", "warm-up",  "tolerance",  "cycles",    "sample-rate", "limits", "end"};
static_assert(itemNames.size() == std::size_t(TestItem::End) + 1);
} // namespace

bool SweepComparison::comparable() const
{
    return std::none_of(tests.begin(), tests.end(), [](const TestDifference& one) {
        return one.weight == DifferenceImpact::Path;
    });
}

SweepComparison compareSweeps(const SweepSide& a, const SweepSide& b)
{
    SweepComparison comparison;
    for (const SweepMetricKind& kind : sweepMetricKinds())
        comparison.figures.push_back(figureOf(kind, a.servo, b.servo));
    TestDifferenceCollector test(comparison.tests);
    checkServos(a, b, test);
    checkPath(a, b, test);
    checkMotion(a, b, test);
    checkSampling(a, b, test);
    comparison.settings = settingsOf(a.servo.parameters, b.servo.parameters);
    return comparison;
}

const SweepServo* servoOf(const SweepRun& run, int id)
{
    for (const SweepServo& servo : run.servos) {
        if (servo.parameters.servo.id == id)
            return &servo;
    }
    return nullptr;
}

QString testItemName(TestItem item)
{
    return QString::fromLatin1(itemNames[std::size_t(item)]);
}

QString weightName(DifferenceImpact weight)
{
    switch (weight) {
    case DifferenceImpact::Path:
        return QStringLiteral("path");
    case DifferenceImpact::Figure:
        return QStringLiteral("figure");
    case DifferenceImpact::Grade:
        break;
    }
    return QStringLiteral("grade");
}
} // namespace results

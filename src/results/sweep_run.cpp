// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_run.h"

#include <array>
#include <utility>

namespace record {
namespace {
template <typename Word, std::size_t Count>
using Names = std::array<std::pair<Word, const char*>, Count>;

constexpr Names<SweepShape, 6> shapes{{
    {SweepShape::Sweep, "sweep"},
    {SweepShape::Stairs, "stairs"},
    {SweepShape::BothSides, "both-sides"},
    {SweepShape::Random, "random"},
    {SweepShape::Sine, "sine"},
    {SweepShape::Points, "points"},
}};
constexpr Names<SweepPace, 2> paces{{{SweepPace::Delay, "delay"}, {SweepPace::Dwell, "dwell"}}};
constexpr Names<Grade, 4> grades{{
    {Grade::Pass, "pass"},
    {Grade::Warn, "warn"},
    {Grade::Fail, "fail"},
    {Grade::NotMeasured, "not-measured"},
}};
constexpr Names<SweepEnd, 10> ends{{
    {SweepEnd::Finished, "finished"},
    {SweepEnd::Stopped, "stopped"},
    {SweepEnd::Emergency, "emergency"},
    {SweepEnd::Alarm, "alarm"},
    {SweepEnd::Stall, "stall"},
    {SweepEnd::Failure, "failure"},
    {SweepEnd::LinkLost, "link-lost"},
    {SweepEnd::Refused, "refused"},
    {SweepEnd::TorqueLost, "torque-lost"},
    {SweepEnd::ServoReplaced, "exchanged"},
}};

template <typename Word, std::size_t Count>
QString nameOfValue(const Names<Word, Count>& names, Word word)
{
    for (const auto& [known, name] : names) {
        if (known == word)
            return QString::fromLatin1(name);
    }
    return {};
}

template <typename Word, std::size_t Count>
std::optional<Word> valueOfName(const Names<Word, Count>& names, const QString& wanted)
{
    for (const auto& [word, name] : names) {
        if (wanted == QLatin1String(name))
            return word;
    }
    return {};
}

/// What a servo is to blame for ends its run with a failure; the others leave the question open.
Grade gradeOf(SweepEnd end)
{
    switch (end) {
    case SweepEnd::Finished:
        return Grade::Pass;
    case SweepEnd::Alarm:
    case SweepEnd::Stall:
    case SweepEnd::Failure:
        return Grade::Fail;
    case SweepEnd::Stopped:
    case SweepEnd::Emergency:
    case SweepEnd::LinkLost:
    case SweepEnd::Refused:
    case SweepEnd::TorqueLost:
    case SweepEnd::ServoReplaced:
        break;
    }
    return Grade::NotMeasured;
}

/// A failure is one whatever else was found out; a servo without a verdict is worse than a warning.
int severity(Grade grade)
{
    switch (grade) {
    case Grade::Pass:
        return 0;
    case Grade::Warn:
        return 1;
    case Grade::NotMeasured:
        return 2;
    case Grade::Fail:
        break;
    }
    return 3;
}
} // namespace

QString sweepShapeName(SweepShape shape)
{
    return nameOfValue(shapes, shape);
}

std::optional<SweepShape> sweepShapeFromName(const QString& name)
{
    return valueOfName(shapes, name);
}

QString sweepPaceName(SweepPace pace)
{
    return nameOfValue(paces, pace);
}

std::optional<SweepPace> sweepPaceFromName(const QString& name)
{
    return valueOfName(paces, name);
}

QString gradeName(Grade grade)
{
    return nameOfValue(grades, grade);
}

std::optional<Grade> gradeFromName(const QString& name)
{
    return valueOfName(grades, name);
}

QString sweepEndName(SweepEnd end)
{
    return nameOfValue(ends, end);
}

std::optional<SweepEnd> sweepEndFromName(const QString& name)
{
    return valueOfName(ends, name);
}

Grade SweepRun::verdict() const
{
    Grade worst = servos.empty() ? Grade::NotMeasured : gradeOf(end);
    for (const SweepServo& servo : servos) {
        if (severity(servo.verdict) > severity(worst))
            worst = servo.verdict;
    }
    return worst;
}
} // namespace record

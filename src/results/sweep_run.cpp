// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_run.h"

#include "base/enum_names.h"

namespace results {
namespace {
constexpr base::EnumName<SweepShape> shapeNames[]{
    {SweepShape::Sweep, "sweep"},
    {SweepShape::Stairs, "stairs"},
    {SweepShape::BothSides, "both-sides"},
    {SweepShape::Random, "random"},
    {SweepShape::Sine, "sine"},
    {SweepShape::Points, "points"},
};
constexpr base::EnumName<SweepPace> paceNames[]{{SweepPace::Delay, "delay"},
                                                {SweepPace::Dwell, "dwell"}};
constexpr base::EnumName<Grade> gradeNames[]{
    {Grade::Pass, "pass"},
    {Grade::Warn, "warn"},
    {Grade::Fail, "fail"},
    {Grade::NotMeasured, "not-measured"},
};
constexpr base::EnumName<SweepEnd> endNames[]{
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
};

/// An end that the servo caused is a failure; the other ends give no verdict.
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

/// A failure is the worst; a servo without a verdict is worse than one with a warning.
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
    return base::nameOf(shapeNames, shape);
}

std::optional<SweepShape> sweepShapeFromName(const QString& name)
{
    return base::valueOf(shapeNames, name);
}

QString sweepPaceName(SweepPace pace)
{
    return base::nameOf(paceNames, pace);
}

std::optional<SweepPace> sweepPaceFromName(const QString& name)
{
    return base::valueOf(paceNames, name);
}

QString gradeName(Grade grade)
{
    return base::nameOf(gradeNames, grade);
}

std::optional<Grade> gradeFromName(const QString& name)
{
    return base::valueOf(gradeNames, name);
}

QString sweepEndName(SweepEnd end)
{
    return base::nameOf(endNames, end);
}

std::optional<SweepEnd> sweepEndFromName(const QString& name)
{
    return base::valueOf(endNames, name);
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
} // namespace results

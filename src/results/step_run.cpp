// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/step_run.h"

#include "base/enum_names.h"

#include <algorithm>
#include <cmath>

namespace results {
namespace {
struct ValueRange {
    double sum = 0;
    double min = HUGE_VAL;
    double max = -HUGE_VAL;
    int count = 0;
    double range() const { return count > 0 ? max - min : 0; }
};

/// The sign of the steady error depends on the direction of the move, so its magnitude counts.
double magnitudeOf(const StepFigure& figure, double value)
{
    return figure.member == &StepFigures::steadyError ? std::abs(value) : value;
}

ValueRange rangeOf(const std::vector<StepResponse>& responses, const StepFigure& figure)
{
    ValueRange spread;
    for (const StepResponse& response : responses) {
        const auto& value = response.figures.*figure.member;
        if (!value || !std::isfinite(*value))
            continue;
        const double found = magnitudeOf(figure, *value);
        spread.sum += found;
        spread.min = std::min(spread.min, found);
        spread.max = std::max(spread.max, found);
        ++spread.count;
    }
    return spread;
}

/// The resolution of a figure: a step of the encoder, or the time between two readings.
double resolutionOf(const StepFigure& figure, const StepRun& run)
{
    const QLatin1StringView unit(figure.unit);
    const double way = std::abs(run.axis.to - run.axis.from);
    if (unit == QLatin1StringView("step"))
        return 1;
    if (unit == QLatin1StringView("%") && figure.member == &StepFigures::overshoot)
        return way > 0 ? 100 / way : 0;
    if (unit == QLatin1StringView("ms"))
        return run.sampleRate > 0 ? 1000 / run.sampleRate : 0;
    return 0;
}

StepChange changeOf(const StepDifference& row, const StepRun& before, const StepRun& after)
{
    if (!row.difference)
        return StepChange::NotMeasured;
    if (!row.figure.lessIsBetter)
        return StepChange::Neither;
    const double scatter = (rangeOf(before.responses, row.figure).range() +
                            rangeOf(after.responses, row.figure).range()) /
                           2;
    const double resolution =
        std::max(resolutionOf(row.figure, before), resolutionOf(row.figure, after));
    const double size = std::abs(*row.difference);
    if (size <= scatter || size < resolution)
        return StepChange::Same;
    return *row.difference < 0 ? StepChange::Better : StepChange::Worse;
}

constexpr base::EnumName<StepSymptom> symptomNames[]{
    {StepSymptom::NotSeen, "not-seen"},         {StepSymptom::NoMotion, "no-motion"},
    {StepSymptom::Blocked, "blocked"},          {StepSymptom::Lag, "lag"},
    {StepSymptom::SpeedLimit, "speed-limit"},   {StepSymptom::Overshoot, "overshoot"},
    {StepSymptom::StaticError, "static-error"}, {StepSymptom::Jitter, "jitter"},
    {StepSymptom::Oscillation, "oscillation"},
};

constexpr base::EnumName<StepRemedy> remedyNames[]{
    {StepRemedy::RepeatRun, "repeat-run"},
    {StepRemedy::RemoveObstacle, "clear-way"},
    {StepRemedy::FreeMotion, "free-motion"},
    {StepRemedy::RaiseP, "raise-p"},
    {StepRemedy::LowerP, "lower-p"},
    {StepRemedy::RaiseD, "raise-d"},
    {StepRemedy::LowerD, "lower-d"},
    {StepRemedy::RaiseI, "raise-i"},
    {StepRemedy::DisableI, "no-i"},
    {StepRemedy::LowerStartupForce, "lower-startup-force"},
    {StepRemedy::WidenDeadZone, "widen-dead-zone"},
    {StepRemedy::NarrowDeadZone, "narrow-dead-zone"},
    {StepRemedy::RaiseSpeed, "raise-speed"},
    {StepRemedy::RaiseAcceleration, "raise-acceleration"},
};
} // namespace

StepFigures meanOf(const std::vector<StepResponse>& responses)
{
    StepFigures mean;
    for (const StepFigure& figure : stepFigures) {
        const ValueRange spread = rangeOf(responses, figure);
        if (spread.count > 0)
            mean.*figure.member = spread.sum / spread.count;
    }
    return mean;
}

bool isSameMotion(const StepRun& one, const StepRun& other)
{
    const double way = std::abs(one.axis.to - one.axis.from);
    return std::abs(way - std::abs(other.axis.to - other.axis.from)) <= 1;
}

std::vector<StepDifference> compareSteps(const StepRun& before, const StepRun& after)
{
    std::vector<StepDifference> rows;
    for (const StepFigure& figure : stepFigures) {
        StepDifference row{figure, before.mean.*figure.member, after.mean.*figure.member};
        if (!row.before && !row.after)
            continue;
        if (row.before && row.after)
            row.difference = *row.after - *row.before;
        row.change = changeOf(row, before, after);
        rows.push_back(row);
    }
    return rows;
}

QString stepSymptomName(StepSymptom symptom)
{
    return base::nameOf(symptomNames, symptom);
}

QString stepRemedyName(StepRemedy remedy)
{
    return base::nameOf(remedyNames, remedy);
}
} // namespace results

// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/step_run.h"

#include <algorithm>
#include <cmath>

namespace record {
namespace {
struct ValueRange {
    double sum = 0;
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    int count = 0;
    double range() const { return count > 0 ? most - least : 0; }
};

/// The direction of an error that remains is that of the way; of there and back the size counts.
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
        spread.least = std::min(spread.least, found);
        spread.most = std::max(spread.most, found);
        ++spread.count;
    }
    return spread;
}

/// Finer than this nothing is measured: a step of the encoder, the time from one reading to the
/// next.
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
    const double least =
        std::max(resolutionOf(row.figure, before), resolutionOf(row.figure, after));
    const double size = std::abs(*row.difference);
    if (size <= scatter || size < least)
        return StepChange::Same;
    return *row.difference < 0 ? StepChange::Better : StepChange::Worse;
}
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
    switch (symptom) {
    case StepSymptom::NotSeen:
        return QStringLiteral("not-seen");
    case StepSymptom::NoMotion:
        return QStringLiteral("no-motion");
    case StepSymptom::Blocked:
        return QStringLiteral("blocked");
    case StepSymptom::Lag:
        return QStringLiteral("lag");
    case StepSymptom::SpeedLimit:
        return QStringLiteral("speed-limit");
    case StepSymptom::Overshoot:
        return QStringLiteral("overshoot");
    case StepSymptom::StaticError:
        return QStringLiteral("static-error");
    case StepSymptom::Jitter:
        return QStringLiteral("jitter");
    case StepSymptom::Oscillation:
        return QStringLiteral("oscillation");
    }
    return {};
}

QString stepRemedyName(StepRemedy remedy)
{
    switch (remedy) {
    case StepRemedy::RepeatRun:
        return QStringLiteral("repeat-run");
    case StepRemedy::RemoveObstacle:
        return QStringLiteral("clear-way");
    case StepRemedy::FreeMotion:
        return QStringLiteral("free-motion");
    case StepRemedy::RaiseP:
        return QStringLiteral("raise-p");
    case StepRemedy::LowerP:
        return QStringLiteral("lower-p");
    case StepRemedy::RaiseD:
        return QStringLiteral("raise-d");
    case StepRemedy::LowerD:
        return QStringLiteral("lower-d");
    case StepRemedy::RaiseI:
        return QStringLiteral("raise-i");
    case StepRemedy::DisableI:
        return QStringLiteral("no-i");
    case StepRemedy::LowerStartupForce:
        return QStringLiteral("lower-startup-force");
    case StepRemedy::WidenDeadZone:
        return QStringLiteral("widen-dead-zone");
    case StepRemedy::NarrowDeadZone:
        return QStringLiteral("narrow-dead-zone");
    case StepRemedy::RaiseSpeed:
        return QStringLiteral("raise-speed");
    case StepRemedy::RaiseAcceleration:
        return QStringLiteral("raise-acceleration");
    }
    return {};
}
} // namespace record

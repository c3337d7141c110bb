// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace results {
namespace {
constexpr int legsPerPeriod = 2;
constexpr std::size_t legsOfCycle = 2; ///< of a sine and of random targets
const QLatin1StringView relativeError("following_error_relative");
const QLatin1StringView phaseLag("phase_lag");
const QLatin1StringView readingsPerPeriod("readings_per_period");
const QLatin1StringView missedTargets("missed_targets");
const QLatin1StringView steadyError("steady_error");
const QLatin1StringView overshoot("overshoot");
const QLatin1StringView communicationErrors("communication_errors");

/// Outside the limit; also where the value or the limit is not a number.
bool isBeyond(double value, const std::optional<double>& limit, bool atLeast)
{
    return limit && !(atLeast ? value >= *limit : value <= *limit);
}

Grade gradeOf(std::optional<double> value, const SweepLimit& limit)
{
    if (!value)
        return Grade::NotMeasured;
    if (std::isnan(*value) || isBeyond(*value, limit.fail, limit.atLeast))
        return Grade::Fail;
    return isBeyond(*value, limit.warn, limit.atLeast) ? Grade::Warn : Grade::Pass;
}

bool appliesTo(const QString& metric, SweepShape shape)
{
    if (metric == phaseLag || metric == readingsPerPeriod)
        return shape == SweepShape::Sine;
    if (metric == relativeError)
        return shape == SweepShape::Sine || shape == SweepShape::Random;
    return true;
}

const SweepMetric* metricOf(const SweepServo& servo, QLatin1StringView key)
{
    const auto found = std::find_if(servo.metrics.begin(), servo.metrics.end(),
                                    [&](const SweepMetric& one) { return one.key == key; });
    return found != servo.metrics.end() ? &*found : nullptr;
}

/// There are lines about the figure, and all of them have a grade.
NoVerdictReason metricReason(const SweepServo& servo, QLatin1StringView key)
{
    bool any = false;
    for (const VerdictLine& line : servo.lines) {
        if (line.limit.metric != key)
            continue;
        any = true;
        // What was measured has a grade, unless judge() left a failure open.
        if (line.grade == Grade::NotMeasured)
            return line.value ? NoVerdictReason::SlowLink : NoVerdictReason::NotMeasured;
    }
    return any ? NoVerdictReason::None : NoVerdictReason::NoLimit;
}

NoVerdictReason sineReason(const SweepRun& run, const SweepServo& servo)
{
    if (servo.legs.size() < legsOfCycle)
        return NoVerdictReason::TooShort;
    if (isSineTooFast(run.spec, servo.axis))
        return NoVerdictReason::TooFast;
    const auto wellSampledLegs =
        std::count_if(servo.legs.begin(), servo.legs.end(), [](const SweepLeg& leg) {
            return leg.samples * legsPerPeriod >= minReadingsPerPeriod;
        });
    if (std::size_t(wellSampledLegs) * 4 < servo.legs.size() * 3)
        return NoVerdictReason::TooFewReadings;
    for (const QLatin1StringView key : {relativeError, phaseLag}) {
        if (const NoVerdictReason lack = metricReason(servo, key); lack != NoVerdictReason::None)
            return lack;
        // A figure missing in half of the run is unknown for the run.
        const SweepMetric* metric = metricOf(servo, key);
        if (metric == nullptr || metric->count * 2 < servo.legs.size())
            return NoVerdictReason::NotMeasured;
    }
    return NoVerdictReason::None;
}

/// The lag of one leg of a sine, in the unit of the figure of the run.
std::optional<double> lagOf(const SweepLeg& leg, const SweepServo& servo, const QString& metric)
{
    if (metric == phaseLag)
        return leg.phaseLag ? std::optional(std::abs(*leg.phaseLag)) : std::nullopt;
    const auto scale = followingScale(SweepShape::Sine, servo.axis);
    return leg.followingError && scale ? std::optional(*leg.followingError / *scale * 100)
                                       : std::nullopt;
}

/// A leg lagged too far, and its readings are dense enough that the link delay is not the cause.
/// Missing values of other legs do not count against it.
bool isLagProven(const SweepServo& servo, const SweepLimit& limit)
{
    return std::any_of(servo.legs.begin(), servo.legs.end(), [&](const SweepLeg& leg) {
        return leg.samples * legsPerPeriod >= minReadingsToFailSine &&
               gradeOf(lagOf(leg, servo, limit.metric), limit) == Grade::Fail;
    });
}

/// A figure that fewer than half of the legs have is unknown for the run.
bool holdsForMostLegs(const SweepServo& servo,
                      const std::function<bool(const SweepLeg&)>& predicate)
{
    return 2 * std::size_t(std::count_if(servo.legs.begin(), servo.legs.end(), predicate)) >
           servo.legs.size();
}

bool hasLimit(const SweepServo& servo, QLatin1StringView key)
{
    return std::any_of(servo.lines.begin(), servo.lines.end(),
                       [&](const VerdictLine& line) { return line.limit.metric == key; });
}

/// Moves long enough to prove arrival show that the servo reached its targets.
NoVerdictReason arrivalReason(const SweepServo& servo)
{
    const double tolerance = servo.axis.tolerance;
    if (holdsForMostLegs(servo, [=](const SweepLeg& leg) { return provesArrival(leg, tolerance); }))
        return NoVerdictReason::None;
    const bool tooShort =
        !holdsForMostLegs(servo, [=](const SweepLeg& leg) { return isLongEnough(leg, tolerance); });
    return tooShort && !servo.legs.empty() ? NoVerdictReason::ShortMoves
                                           : NoVerdictReason::NotMeasured;
}

/// Steady error and overshoot count where they have a limit.
NoVerdictReason targetReason(const SweepServo& servo)
{
    if (const NoVerdictReason lack = arrivalReason(servo); lack != NoVerdictReason::None)
        return lack;
    const std::pair<QLatin1StringView, std::optional<double> SweepLeg::*> deciding[]{
        {steadyError, &SweepLeg::steadyError}, {overshoot, &SweepLeg::overshoot}};
    for (const auto& [key, member] : deciding) {
        const auto measured = [member = member](const SweepLeg& leg) {
            return (leg.*member).has_value();
        };
        if (hasLimit(servo, key) && !holdsForMostLegs(servo, measured))
            return NoVerdictReason::NotMeasured;
    }
    return NoVerdictReason::None;
}

/// The following error needs the speed; reaching the targets can always be judged.
NoVerdictReason randomReason(const SweepServo& servo)
{
    if (servo.legs.size() < legsOfCycle)
        return NoVerdictReason::TooShort;
    if (const NoVerdictReason lack = arrivalReason(servo); lack != NoVerdictReason::None)
        return lack;
    const NoVerdictReason reached = metricReason(servo, missedTargets);
    return metricReason(servo, relativeError) == NoVerdictReason::None ? NoVerdictReason::None
                                                                       : reached;
}

NoVerdictReason noVerdictReasonOf(const SweepRun& run, const SweepServo& servo)
{
    if (run.end != SweepEnd::Finished)
        return NoVerdictReason::Ended;
    NoVerdictReason lack = NoVerdictReason::None;
    if (run.spec.shape == SweepShape::Sine)
        lack = sineReason(run, servo);
    else if (run.spec.shape == SweepShape::Random)
        lack = randomReason(servo);
    else
        lack = targetReason(servo);
    if (lack == NoVerdictReason::None && worstGrade(servo.lines) == Grade::NotMeasured)
        return NoVerdictReason::NotMeasured;
    return lack;
}
} // namespace

QString noVerdictReasonName(NoVerdictReason reason)
{
    constexpr std::array names{
        "",         "ended",       "too-short", "too-few-readings", "too-fast",
        "no-limit", "short-moves", "slow-link", "not-measured"};
    static_assert(names.size() == std::size_t(NoVerdictReason::NotMeasured) + 1);
    return QString::fromLatin1(names[std::size_t(reason)]);
}

bool isLongEnough(const SweepLeg& leg, double tolerance)
{
    return std::abs(leg.target - leg.start) > minMoveTolerances * tolerance;
}

bool provesArrival(const SweepLeg& leg, double tolerance)
{
    return leg.missed || (leg.timeToTarget && isLongEnough(leg, tolerance));
}

bool isServoFault(SweepEnd end)
{
    return end == SweepEnd::Alarm || end == SweepEnd::Stall || end == SweepEnd::Failure;
}

bool canBeReference(SweepEnd end)
{
    return end == SweepEnd::Finished;
}

Grade gradeAfter(SweepEnd end, Grade grade, bool isResponsible)
{
    if (end == SweepEnd::Finished || grade == Grade::Fail)
        return grade;
    return isResponsible && isServoFault(end) ? Grade::Fail : Grade::NotMeasured;
}

SweepVerdict sweepVerdict(const SweepRun& run, const SweepServo& servo)
{
    const bool early = run.end != SweepEnd::Finished;
    const bool failed =
        std::any_of(servo.lines.begin(), servo.lines.end(), [early](const VerdictLine& line) {
            return line.grade == Grade::Fail &&
                   !(early && line.limit.metric == communicationErrors);
        });
    const bool isResponsible = run.endedBy == servo.parameters.servo.id && isServoFault(run.end);
    if (failed || isResponsible)
        return {Grade::Fail};
    const NoVerdictReason lack = noVerdictReasonOf(run, servo);
    if (lack != NoVerdictReason::None)
        return {Grade::NotMeasured, lack};
    return {worstGrade(servo.lines)};
}

void assignVerdicts(SweepRun& run)
{
    for (SweepServo& servo : run.servos)
        servo.verdict = sweepVerdict(run, servo).grade;
}

std::vector<VerdictLine> evaluate(const SweepServo& servo, const std::vector<SweepMetric>& metrics,
                                  SweepShape shape)
{
    const auto valueOf = [&](const QString& key) {
        const auto found = std::find_if(metrics.begin(), metrics.end(),
                                        [&](const SweepMetric& one) { return one.key == key; });
        return found != metrics.end() ? found->value : std::nullopt;
    };
    std::vector<VerdictLine> lines;
    for (const SweepLimit& limit : servo.limits.lines) {
        if (!appliesTo(limit.metric, shape))
            continue;
        const auto value = valueOf(limit.metric);
        const bool isLagMetric = limit.metric == relativeError || limit.metric == phaseLag;
        const Grade grade = gradeOf(value, limit);
        const bool unproven = grade == Grade::Fail && shape == SweepShape::Sine && isLagMetric &&
                              !isLagProven(servo, limit);
        lines.push_back({limit, value, unproven ? Grade::NotMeasured : grade});
    }
    return lines;
}

Grade worstGrade(const std::vector<VerdictLine>& lines)
{
    Grade grade = Grade::NotMeasured;
    for (const Grade one : {Grade::Pass, Grade::Warn, Grade::Fail}) {
        const bool any = std::any_of(lines.begin(), lines.end(),
                                     [&](const VerdictLine& line) { return line.grade == one; });
        grade = any ? one : grade;
    }
    return grade;
}

std::optional<double> followingScale(SweepShape shape, const SweepAxis& axis)
{
    const double range = std::abs(axis.to - axis.from);
    if (!(range > 0))
        return std::nullopt;
    if (shape == SweepShape::Sine)
        return range / 2;
    return shape == SweepShape::Random ? std::optional(range) : std::nullopt;
}

bool isSineTooFast(const SweepSpec& spec, const SweepAxis& axis)
{
    if (spec.shape != SweepShape::Sine || !axis.speed || spec.period <= base::Duration::zero())
        return false;
    const double seconds = std::chrono::duration<double>(spec.period).count();
    return std::numbers::pi * std::abs(axis.to - axis.from) / seconds > *axis.speed;
}
} // namespace results

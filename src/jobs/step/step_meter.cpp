// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step/step_meter.h"

#include "jobs/sweep/leg_trace.h"
#include "jobs/sweep/sweep_link.h"
#include "results/sweep_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jobs {
using base::Duration;
using results::StepSample;
using namespace std::chrono_literals;
using Samples = std::vector<StepSample>;

namespace {
constexpr Duration maxInterpolationGap = 50ms; ///< between two readings, to be interpolated
constexpr int maxGapFactor = 4; ///< a gap of this number of intervals means missing readings
constexpr Duration maxNoiseInterval = 5ms; ///< close enough to separate noise from motion
constexpr double minTravel = 3;            ///< steps
constexpr double travelFraction = 0.01;
constexpr double minSwing = 6;         ///< steps, from one extreme to the other
constexpr double swingNoiseFactor = 8; ///< standard deviations
constexpr std::size_t minSwingsForFrequency = 3;

double inMilliseconds(Duration span)
{
    return double(span.count()) / results::usPerMs;
}

/// Steps from where it stood, positive towards its target.
class StepAxis {
public:
    explicit StepAxis(const results::SweepLeg& leg)
        : m_start(leg.start)
        , m_sign(leg.target < leg.start ? -1 : 1)
        , m_length(std::abs(leg.target - leg.start))
    {}
    double travel(double position) const { return m_sign * (position - m_start); }
    double length() const { return m_length; }

private:
    double m_start;
    double m_sign;
    double m_length;
};

/// When it first reached this distance.
struct ThresholdCrossing {
    Duration at{};
    std::size_t reading = 0; ///< the first one beyond
};

std::optional<ThresholdCrossing> firstCrossing(const Samples& samples, const StepAxis& way,
                                               double level, bool mustStay = false)
{
    Duration before{};
    double from = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double travel = way.travel(samples[i].position);
        const bool single =
            mustStay && i + 1 < samples.size() && way.travel(samples[i + 1].position) < level;
        if (travel >= level && !single) {
            if (samples[i].at - before > maxInterpolationGap)
                return std::nullopt;
            return ThresholdCrossing{crossingTime(before, from, samples[i].at, travel, level), i};
        }
        before = samples[i].at;
        from = std::min(travel, level);
    }
    return std::nullopt;
}

std::optional<double> riseTime(const Samples& samples, const StepAxis& way)
{
    const auto low = firstCrossing(samples, way, 0.1 * way.length());
    const auto high = firstCrossing(samples, way, 0.9 * way.length());
    if (!low || !high || high->reading == low->reading)
        return std::nullopt;
    return inMilliseconds(high->at - low->at);
}

/// Scatter of single readings about a smooth curve; 0 if they are too far apart.
double estimateNoise(const Samples& samples, std::size_t first)
{
    double sum = 0;
    int count = 0;
    for (std::size_t i = first + 1; i + 1 < samples.size(); ++i) {
        if (samples[i + 1].at - samples[i - 1].at > 2 * maxNoiseInterval)
            continue;
        const double curvature =
            samples[i - 1].position - 2 * samples[i].position + samples[i + 1].position;
        sum += curvature * curvature;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / count / 6) : 0;
}

struct TurningPoint {
    Duration at{};
    double position = 0;
};

/// Where it turned round by more than `least`, from `first` on. It comes in the direction of its
/// way.
std::vector<TurningPoint> findTurningPoints(const Samples& samples, std::size_t first,
                                            const StepAxis& way, double minTurn)
{
    std::vector<TurningPoint> turns;
    bool ahead = true;
    TurningPoint extreme{samples[first].at, way.travel(samples[first].position)};
    for (std::size_t i = first + 1; i < samples.size(); ++i) {
        const double travel = way.travel(samples[i].position);
        const double back = ahead ? extreme.position - travel : travel - extreme.position;
        if (back < 0) {
            extreme = {samples[i].at, travel};
        } else if (back >= minTurn) {
            turns.push_back(extreme);
            extreme = {samples[i].at, travel};
            ahead = !ahead;
        }
    }
    return turns;
}

void findSwings(results::StepFigures& figures, const Samples& samples, const results::SweepLeg& leg,
                const StepAxis& way)
{
    if (!leg.timeToTarget)
        return;
    const auto arrived = std::find_if(samples.begin(), samples.end(), [&](const StepSample& one) {
        return one.at >= *leg.timeToTarget;
    });
    if (arrived == samples.end())
        return;
    const auto first = std::size_t(arrived - samples.begin());
    const double minTurn = std::max(minSwing, swingNoiseFactor * estimateNoise(samples, first));
    const std::vector<TurningPoint> turns = findTurningPoints(samples, first, way, minTurn);
    figures.swings = double(turns.size());
    if (turns.size() < 2)
        return;
    double longest = 0;
    for (std::size_t i = 1; i < turns.size(); ++i)
        longest = std::max(longest, std::abs(turns[i].position - turns[i - 1].position));
    figures.swingAmplitude = longest / 2;
    const double span = inMilliseconds(turns.back().at - turns.front().at);
    if (turns.size() >= minSwingsForFrequency && span > 0)
        figures.swingFrequency = double(turns.size() - 1) / 2 / span * 1000;
}

std::optional<double> peakReportedSpeed(const Samples& samples)
{
    std::optional<double> maxSpeed;
    for (const StepSample& sample : samples) {
        if (sample.speed)
            maxSpeed = std::max(maxSpeed.value_or(0), std::abs(*sample.speed));
    }
    return maxSpeed;
}
} // namespace

bool isFullySampled(const Samples& samples, const results::SweepLeg& leg, Duration end)
{
    std::vector<Duration> intervals;
    Duration before{};
    for (const StepSample& sample : samples)
        intervals.push_back(sample.at - std::exchange(before, sample.at));
    if (intervals.empty())
        return false;
    const auto middle = intervals.begin() + std::ptrdiff_t(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    const Duration longest =
        std::min(std::max(maxInterpolationGap, maxGapFactor * *middle), SweepLink::minGap);
    const Duration over =
        leg.timeToTarget ? *leg.timeToTarget + leg.settling.value_or(Duration(0)) : end;
    before = {};
    for (const StepSample& sample : samples) {
        if (sample.at - before > longest)
            return false;
        before = sample.at;
        if (before >= over)
            return true;
    }
    return end - before <= longest;
}

void clearMotionFigures(results::StepFigures& figures)
{
    for (const auto figure :
         {&results::StepFigures::deadTime, &results::StepFigures::riseTime,
          &results::StepFigures::timeToTarget, &results::StepFigures::settling,
          &results::StepFigures::overshoot, &results::StepFigures::overshootSteps,
          &results::StepFigures::swings, &results::StepFigures::swingFrequency,
          &results::StepFigures::swingAmplitude, &results::StepFigures::peakSpeed})
        (figures.*figure).reset();
}

results::StepFigures measureStep(const Samples& samples, const results::SweepLeg& leg)
{
    results::StepFigures figures;
    figures.timeToTarget = results::inMs(leg.timeToTarget);
    figures.settling = results::inMs(leg.settling);
    figures.overshoot = leg.overshoot;
    figures.overshootSteps = leg.overshootSteps;
    figures.steadyError = leg.steadyError;
    figures.peakCurrent = leg.currentPeak;
    figures.peakLoad = leg.loadPeak;
    const auto reported = peakReportedSpeed(samples);
    figures.peakSpeed = leg.topSpeed ? leg.topSpeed : reported;
    const StepAxis way(leg);
    const double start = std::max(minTravel, travelFraction * way.length());
    if (way.length() <= 2 * start)
        return figures;
    if (const auto moved = firstCrossing(samples, way, start, true))
        figures.deadTime = inMilliseconds(moved->at);
    figures.riseTime = riseTime(samples, way);
    findSwings(figures, samples, leg, way);
    return figures;
}
} // namespace jobs

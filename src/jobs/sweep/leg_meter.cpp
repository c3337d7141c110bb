// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/leg_meter.h"

#include "results/sweep_verdict.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using std::chrono::milliseconds;

namespace {
constexpr double encoderNoise = 2; ///< steps, either way, that no encoder is blamed for
constexpr double motionThreshold =
    4; ///< more is motion: from one extreme of the noise to the other
constexpr double minDirectedDistance = 1; ///< a shorter way has no direction
constexpr double maxSpread = 3.5;
constexpr double spreadFactor = 2;       ///< the last fifth has not seen the worst
constexpr double minNoiseReadings = 10;  ///< readings needed to know the noise
constexpr double toleranceFraction = 64; ///< as in device/motion/arrival.cpp
constexpr Duration wireDelay = milliseconds(5);
constexpr Duration maxInterpolatedLoss = milliseconds(50);
constexpr Duration flagTimeout = milliseconds(500);
constexpr Duration minRestTime = milliseconds(100);

Duration fromSeconds(double seconds)
{
    return Duration(std::llround(std::min(seconds, 1e9) * 1e6));
}

/// Time from rest until the movement is visible.
Duration startUpTime(const results::SweepAxis& axis)
{
    const double acceleration = axis.acceleration.value_or(0);
    return acceleration > 0 ? fromSeconds(std::sqrt(2 * motionThreshold / acceleration))
                            : Duration(0);
}

Duration timeForDistance(std::optional<double> speed, double way)
{
    return speed && *speed > 0 ? fromSeconds(way / *speed) : Duration(0);
}

/// A flag that is still not set after this distance is wrong.
double flagDistance(const results::SweepAxis& axis, double way)
{
    return std::max(2 * axis.tolerance, std::min(axis.stepsPerTurn / toleranceFraction, way / 2));
}

template <typename Pick>
void keepExtreme(std::optional<double>& best, const std::optional<double>& value, Pick pick)
{
    if (value && std::isfinite(*value))
        best = best ? pick(*best, *value) : *value;
}
} // namespace

LegMeter::LegMeter(const results::SweepAxis& axis, int number, int cycle, Duration at, double start,
                   double target)
    : m_axis(axis)
    , m_goalSentAt(at)
    , m_startUpTime(startUpTime(axis))
    , m_goal(target)
    , m_last{at, start}
    , m_previousAt(at)
    , m_settle(motionThreshold, at, start)
    , m_coarseSettle(std::max(motionThreshold, axis.tolerance), at, start)
    , m_speedMeter(at, start, target)
    , m_movingFlag(at, flagDistance(axis, std::abs(target - start)),
                   flagTimeout + m_startUpTime + 2 * timeForDistance(axis.speed, motionThreshold))
{
    m_leg.number = number;
    m_leg.cycle = cycle;
    m_leg.start = start;
    m_leg.target = target;
    updateAwaySince(at);
    if (std::abs(start - target) <= axis.tolerance) {
        m_leg.timeToTarget = Duration(0);
        m_insideSince = at;
    }
}

void LegMeter::followPath(std::function<double(Duration since)> path, Duration period)
{
    m_path = std::move(path);
    m_period = period;
    m_movingFlag.allowMoving();
}

void LegMeter::setGoal(Duration at, double goal)
{
    m_goal = goal;
    updateAwaySince(at);
}

void LegMeter::updateAwaySince(Duration at)
{
    if (std::abs(m_last.position - m_goal) <= restTolerance())
        m_awaySince.reset();
    else if (!m_awaySince)
        m_awaySince = at;
}

void LegMeter::add(const SweepSample& sample)
{
    if (sample.at < m_goalSentAt)
        return;
    const bool hasPosition = sample.answered && sample.position && std::isfinite(*sample.position);
    if (sample.answered) {
        ++m_leg.samples;
        m_leg.alarms = std::uint8_t(m_leg.alarms | sample.status);
        if (sample.current)
            m_current.add(*sample.current);
        if (sample.load)
            m_load.add(*sample.load);
        const auto less = [](double one, double other) { return std::min(one, other); };
        const auto more = [](double one, double other) { return std::max(one, other); };
        keepExtreme(m_leg.voltageMin, sample.voltage, less);
        keepExtreme(m_leg.temperatureMax, sample.temperature, more);
    } else {
        ++m_leg.lost;
    }
    if (hasPosition) {
        addPosition(sample.at, *sample.position);
        if (sample.moving)
            m_movingFlag.add(sample.at, *sample.position, *sample.moving, m_settle.since());
    }
    m_sampleLost = !hasPosition;
    m_previousAt = sample.at;
}

void LegMeter::addPosition(Duration at, double position)
{
    m_settle.add(at, position);
    m_coarseSettle.add(at, position);
    m_speedMeter.add(at, position);
    m_trace.add(at, position);
    const double beyond = m_smoothedError.add(at, signedError(position));
    m_peak = std::max(m_peak.value_or(beyond), beyond);
    measureFollowingError(at, position);
    detectArrival(at, position);
    m_last = {at, position};
    m_hasReading = true;
    updateAwaySince(at);
}

double LegMeter::signedError(double position) const
{
    return (m_leg.target < m_leg.start ? -1.0 : 1.0) * (position - m_leg.target);
}

/// The band may lie between two readings: then it went through all the same.
void LegMeter::detectArrival(Duration at, double position)
{
    const double before = m_last.position - m_leg.target;
    const double now = position - m_leg.target;
    const bool within = std::abs(now) <= m_axis.tolerance;
    const bool passedThrough = !within && std::signbit(before) != std::signbit(now);
    if (!m_leg.timeToTarget && (within || passedThrough)) {
        const double edge = m_leg.target + std::copysign(m_axis.tolerance, before);
        const bool unseen = m_sampleLost && at - m_last.at > maxInterpolatedLoss;
        const Duration moment =
            unseen ? at : crossingTime(m_last.at, m_last.position, at, position, edge);
        m_leg.timeToTarget = moment - m_goalSentAt;
    }
    if (within && !m_insideSince)
        m_insideSince = at;
    else if (std::abs(now) > m_axis.tolerance + encoderNoise)
        m_insideSince.reset();
}

void LegMeter::measureFollowingError(Duration at, double position)
{
    // The goals of a sine move, wherever the servo stands.
    if (!m_path && std::abs(m_leg.target - m_leg.start) < minDirectedDistance)
        return;
    const Duration since = at - m_goalSentAt - std::min(at - m_previousAt, wireDelay);
    const auto planned = m_path ? std::optional(m_path(since))
                                : plannedPosition(m_leg.start, m_leg.target, since, m_axis);
    if (!planned)
        return;
    if (m_path && m_period > Duration::zero())
        m_phase.add(double(since.count()) / double(m_period.count()), *planned, position);
    // A sine turns round while the servo is still behind: there behind may be either way.
    const double lag =
        m_path ? std::abs(*planned - position) : signedError(*planned) - signedError(position);
    const double smooth = m_smoothedLag.add(at, lag);
    m_leg.followingError = std::max(m_leg.followingError.value_or(0), smooth);
}

bool LegMeter::arrived(Duration rest) const
{
    return m_hasReading && m_insideSince &&
           m_last.at - std::max(*m_insideSince, m_coarseSettle.since()) >= rest;
}

/// The distance that friction and load may leave.
double LegMeter::restTolerance() const
{
    return std::max(m_axis.tolerance, m_axis.stepsPerTurn / toleranceFraction);
}

bool LegMeter::restsNearTarget(Duration rest) const
{
    return m_hasReading && std::abs(m_last.position - m_leg.target) <= restTolerance() &&
           m_last.at - std::max(m_coarseSettle.since(), m_goalSentAt + m_startUpTime) >= rest;
}

bool LegMeter::isStalled(Duration span) const
{
    if (!m_hasReading || !m_awaySince)
        return false;
    const Duration minStandTime =
        std::max(span, 2 * timeForDistance(m_axis.speed, motionThreshold));
    return m_last.at - std::max({m_settle.since(), m_goalSentAt + m_startUpTime, *m_awaySince}) >=
           minStandTime;
}

results::SweepLeg LegMeter::finish(Duration end, Duration runStart) const
{
    results::SweepLeg leg = m_leg;
    leg.at = m_goalSentAt - runStart;
    leg.span = end - m_goalSentAt;
    leg.meanSpeed = m_speedMeter.mean();
    leg.topSpeed = m_speedMeter.top();
    leg.currentPeak = m_current.peak();
    leg.currentMean = m_current.mean();
    leg.loadPeak = m_load.peak();
    leg.loadMean = m_load.mean();
    leg.flagWrong = m_movingFlag.isWrong();
    leg.missed = !leg.timeToTarget && !m_path;
    if (m_path) {
        leg.timeToTarget.reset();
        leg.phaseLag = m_phase.lag();
    } else {
        finishRest(leg, end);
    }
    return leg;
}

void LegMeter::finishRest(results::SweepLeg& leg, Duration end) const
{
    RestCriteria query{
        leg.target, m_axis.tolerance, {}, timeForDistance(m_axis.speed, m_axis.tolerance)};
    if (leg.timeToTarget)
        query.arrival = m_goalSentAt + *leg.timeToTarget;
    const auto rest = analyzeRest(m_trace.points(), query);
    if (!rest)
        return;
    leg.reached = rest->place;
    if (rest->isSteady)
        leg.steadyError = rest->place - leg.target;
    const bool isKnown = rest->hasLeft || (rest->isSteady && rest->settledAt);
    if (query.arrival && isKnown)
        leg.settling = rest->settledAt.value_or(end) - *query.arrival;
    finishOvershoot(leg, *rest);
}

void LegMeter::finishOvershoot(results::SweepLeg& leg, const LegRest& rest) const
{
    const double way = std::abs(leg.target - leg.start);
    const bool hadEnoughTime =
        leg.timeToTarget && m_last.at - m_goalSentAt - *leg.timeToTarget >=
                                minRestTime + timeForDistance(m_axis.speed, m_axis.tolerance);
    if (way < minDirectedDistance || !m_peak || !(rest.isSteady || hadEnoughTime))
        return;
    const double level = rest.isSteady ? signedError(rest.place) : 0;
    const double beyond = *m_peak - level;
    double floor = encoderNoise;
    if (rest.isSteady)
        floor = rest.readings < minNoiseReadings
                    ? maxSpread
                    : std::clamp(spreadFactor * rest.spread, encoderNoise, maxSpread);
    leg.overshootSteps = beyond > floor ? beyond : 0;
    if (results::isLongEnough(leg, m_axis.tolerance))
        leg.overshoot = *leg.overshootSteps / way * 100;
}
} // namespace jobs

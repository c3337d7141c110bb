// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/leg_meter.h"

#include "record/sweep_verdict.h"

#include <algorithm>
#include <cmath>

namespace jobs {
using base::Duration;
using std::chrono::milliseconds;

namespace {
constexpr double noise = 2; ///< steps, either way, that no encoder is blamed for
constexpr double stirs = 4; ///< more is motion: from one extreme of the noise to the other
constexpr double noWay = 1; ///< a shorter way has no direction
constexpr double mostSpread = 3.5;
constexpr double spreads = 2;    ///< the last fifth has not seen the worst
constexpr double enough = 10;    ///< readings that tell the noise
constexpr double restShare = 64; ///< as in device/arrival.cpp
constexpr Duration onTheWire = milliseconds(5);
constexpr Duration shortLoss = milliseconds(50);
constexpr Duration flagPatience = milliseconds(500);
constexpr Duration shortestRest = milliseconds(100);

Duration fromSeconds(double seconds)
{
    return Duration(std::llround(std::min(seconds, 1e9) * 1e6));
}

/// What the servo needs from rest to be seen moving.
Duration startUp(const record::SweepAxis& axis)
{
    const double acceleration = axis.acceleration.value_or(0);
    return acceleration > 0 ? fromSeconds(std::sqrt(2 * stirs / acceleration)) : Duration(0);
}

Duration timeAt(std::optional<double> speed, double way)
{
    return speed && *speed > 0 ? fromSeconds(way / *speed) : Duration(0);
}

/// A flag that stays down is wrong after so much way.
double flagFar(const record::SweepAxis& axis, double way)
{
    return std::max(2 * axis.tolerance, std::min(axis.stepsPerTurn / restShare, way / 2));
}

template <typename Pick>
void keep(std::optional<double>& best, const std::optional<double>& value, Pick pick)
{
    if (value && std::isfinite(*value))
        best = best ? pick(*best, *value) : *value;
}
} // namespace

LegMeter::LegMeter(const record::SweepAxis& axis, int number, int cycle, Duration at, double start,
                   double target)
    : m_axis(axis)
    , m_at(at)
    , m_startUp(startUp(axis))
    , m_goal(target)
    , m_last{at, start}
    , m_before(at)
    , m_still(stirs, at, start)
    , m_calm(std::max(stirs, axis.tolerance), at, start)
    , m_speeds(at, start, target)
    , m_flag(at, flagFar(axis, std::abs(target - start)),
             flagPatience + m_startUp + 2 * timeAt(axis.speed, stirs))
{
    m_leg.number = number;
    m_leg.cycle = cycle;
    m_leg.start = start;
    m_leg.target = target;
    noteAway(at);
    if (std::abs(start - target) <= axis.tolerance) {
        m_leg.timeToTarget = Duration(0);
        m_inside = at;
    }
}

void LegMeter::follow(std::function<double(Duration since)> path, Duration period)
{
    m_path = std::move(path);
    m_period = period;
    m_flag.allowUp();
}

void LegMeter::command(Duration at, double goal)
{
    m_goal = goal;
    noteAway(at);
}

void LegMeter::noteAway(Duration at)
{
    if (std::abs(m_last.position - m_goal) <= leftBeside())
        m_awaySince.reset();
    else if (!m_awaySince)
        m_awaySince = at;
}

void LegMeter::add(const SweepSample& sample)
{
    if (sample.at < m_at)
        return;
    const bool placed = sample.answered && sample.position && std::isfinite(*sample.position);
    if (sample.answered) {
        ++m_leg.samples;
        m_leg.alarms = std::uint8_t(m_leg.alarms | sample.status);
        if (sample.current)
            m_current.add(*sample.current);
        if (sample.load)
            m_load.add(*sample.load);
        const auto less = [](double one, double other) { return std::min(one, other); };
        const auto more = [](double one, double other) { return std::max(one, other); };
        keep(m_leg.voltageMin, sample.voltage, less);
        keep(m_leg.temperatureMax, sample.temperature, more);
    } else {
        ++m_leg.lost;
    }
    if (placed) {
        addPosition(sample.at, *sample.position);
        if (sample.moving)
            m_flag.add(sample.at, *sample.position, *sample.moving, m_still.since());
    }
    m_lostSince = !placed;
    m_before = sample.at;
}

void LegMeter::addPosition(Duration at, double position)
{
    m_still.add(at, position);
    m_calm.add(at, position);
    m_speeds.add(at, position);
    m_trace.add(at, position);
    const double beyond = m_smoothSide.add(at, side(position));
    m_peak = std::max(m_peak.value_or(beyond), beyond);
    holdAgainstPath(at, position);
    lookForArrival(at, position);
    m_last = {at, position};
    m_read = true;
    noteAway(at);
}

double LegMeter::side(double position) const
{
    return (m_leg.target < m_leg.start ? -1.0 : 1.0) * (position - m_leg.target);
}

/// The band may lie between two readings: then it went through all the same.
void LegMeter::lookForArrival(Duration at, double position)
{
    const double before = m_last.position - m_leg.target;
    const double now = position - m_leg.target;
    const bool within = std::abs(now) <= m_axis.tolerance;
    const bool through = !within && std::signbit(before) != std::signbit(now);
    if (!m_leg.timeToTarget && (within || through)) {
        const double edge = m_leg.target + std::copysign(m_axis.tolerance, before);
        const bool unseen = m_lostSince && at - m_last.at > shortLoss;
        const Duration moment =
            unseen ? at : crossing(m_last.at, m_last.position, at, position, edge);
        m_leg.timeToTarget = moment - m_at;
    }
    if (within && !m_inside)
        m_inside = at;
    else if (std::abs(now) > m_axis.tolerance + noise)
        m_inside.reset();
}

void LegMeter::holdAgainstPath(Duration at, double position)
{
    // The goals of a sine move, wherever the servo stands.
    if (!m_path && std::abs(m_leg.target - m_leg.start) < noWay)
        return;
    const Duration since = at - m_at - std::min(at - m_before, onTheWire);
    const auto planned = m_path ? std::optional(m_path(since))
                                : plannedPosition(m_leg.start, m_leg.target, since, m_axis);
    if (!planned)
        return;
    if (m_path && m_period > Duration::zero())
        m_phase.add(double(since.count()) / double(m_period.count()), *planned, position);
    // A sine turns round while the servo is still behind: there behind may be either way.
    const double lag = m_path ? std::abs(*planned - position) : side(*planned) - side(position);
    const double smooth = m_smoothLag.add(at, lag);
    m_leg.followingError = std::max(m_leg.followingError.value_or(0), smooth);
}

bool LegMeter::arrived(Duration rest) const
{
    return m_read && m_inside && m_last.at - std::max(*m_inside, m_calm.since()) >= rest;
}

/// What friction and load may leave of the way.
double LegMeter::leftBeside() const
{
    return std::max(m_axis.tolerance, m_axis.stepsPerTurn / restShare);
}

bool LegMeter::standsNear(Duration rest) const
{
    return m_read && std::abs(m_last.position - m_leg.target) <= leftBeside() &&
           m_last.at - std::max(m_calm.since(), m_at + m_startUp) >= rest;
}

bool LegMeter::stalled(Duration span) const
{
    if (!m_read || !m_awaySince)
        return false;
    const Duration least = std::max(span, 2 * timeAt(m_axis.speed, stirs));
    return m_last.at - std::max({m_still.since(), m_at + m_startUp, *m_awaySince}) >= least;
}

record::SweepLeg LegMeter::finish(Duration end, Duration runStart) const
{
    record::SweepLeg leg = m_leg;
    leg.at = m_at - runStart;
    leg.span = end - m_at;
    leg.meanSpeed = m_speeds.mean();
    leg.topSpeed = m_speeds.top();
    leg.currentPeak = m_current.peak();
    leg.currentMean = m_current.mean();
    leg.loadPeak = m_load.peak();
    leg.loadMean = m_load.mean();
    leg.flagWrong = m_flag.wrong();
    leg.missed = !leg.timeToTarget && !m_path;
    if (m_path) {
        leg.timeToTarget.reset();
        leg.phaseLag = m_phase.lag();
    } else {
        finishRest(leg, end);
    }
    return leg;
}

void LegMeter::finishRest(record::SweepLeg& leg, Duration end) const
{
    RestQuery query{leg.target, m_axis.tolerance, {}, timeAt(m_axis.speed, m_axis.tolerance)};
    if (leg.timeToTarget)
        query.arrival = m_at + *leg.timeToTarget;
    const auto rest = restOf(m_trace.points(), query);
    if (!rest)
        return;
    leg.reached = rest->place;
    if (rest->steady)
        leg.steadyError = rest->place - leg.target;
    const bool said = rest->left || (rest->steady && rest->settled);
    if (query.arrival && said)
        leg.settling = rest->settled.value_or(end) - *query.arrival;
    finishOvershoot(leg, *rest);
}

void LegMeter::finishOvershoot(record::SweepLeg& leg, const LegRest& rest) const
{
    const double way = std::abs(leg.target - leg.start);
    const bool hadTime =
        leg.timeToTarget && m_last.at - m_at - *leg.timeToTarget >=
                                shortestRest + timeAt(m_axis.speed, m_axis.tolerance);
    if (way < noWay || !m_peak || !(rest.steady || hadTime))
        return;
    const double level = rest.steady ? side(rest.place) : 0;
    const double beyond = *m_peak - level;
    double floor = noise;
    if (rest.steady)
        floor = rest.readings < enough ? mostSpread
                                       : std::clamp(spreads * rest.spread, noise, mostSpread);
    leg.overshootSteps = beyond > floor ? beyond : 0;
    if (record::isLongEnough(leg, m_axis.tolerance))
        leg.overshoot = *leg.overshootSteps / way * 100;
}
} // namespace jobs

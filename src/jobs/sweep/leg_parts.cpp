// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/leg_parts.h"

#include "jobs/sweep/leg_trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jobs {
using base::Duration;
using std::chrono::milliseconds;

namespace {
constexpr Duration smoothingWindow = milliseconds(10);
constexpr double minLegDistance = 20;
constexpr double middleFrom = 0.1;
constexpr double middleTo = 0.9;
constexpr std::size_t minReadings = 3;
constexpr Duration maxReadingGap = milliseconds(250);
constexpr Duration minWindow = milliseconds(40);
constexpr Duration longWindow = std::chrono::seconds(2);
constexpr double windowSteps = 60;
constexpr double windowFraction = 1.0 / 6;      ///< of a short way
constexpr double longWindowFraction = 1.0 / 16; ///< of a long way, where noise counts less
constexpr double errorFactor = 1;               ///< standard errors of a slope
constexpr double maxNoise = 8;       ///< steps; that a fitted line may be steeper than its ends
constexpr int minPhaseReadings = 10; ///< readings
constexpr double minAmplitude = 2;   ///< steps, and
constexpr double amplitudeFraction = 0.02; ///< of the goal's
constexpr Duration flagRiseTime = milliseconds(100);

double seconds(Duration span)
{
    return double(span.count()) / 1e6;
}
} // namespace

void SettleDetector::add(Duration at, double position)
{
    if (std::abs(position - m_center) <= m_band)
        return;
    m_center = position;
    m_since = at;
}

double MovingAverage::add(Duration at, double value)
{
    m_values.push_back({at, value});
    while (at - m_values.front().at > smoothingWindow)
        m_values.pop_front();
    double sum = 0;
    for (const Value& one : m_values)
        sum += one.value;
    return sum / double(m_values.size());
}

void PhaseMeter::add(double turns, double goal, double position)
{
    const double angle = 2 * std::numbers::pi * turns;
    const Sums basis{1, std::cos(angle), std::sin(angle)};
    ++m_count;
    for (std::size_t row = 0; row < basis.size(); ++row) {
        for (std::size_t column = 0; column < basis.size(); ++column)
            m_normalMatrix[row][column] += basis[row] * basis[column];
        m_goal[row] += basis[row] * goal;
        m_position[row] += basis[row] * position;
    }
}

/// Least squares, by Cramer's rule: of three unknowns nothing is gained by more.
std::optional<PhaseMeter::Wave> PhaseMeter::fit(const Sums& right) const
{
    const auto determinant = [](const std::array<Sums, 3>& a) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
               a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    const double whole = determinant(m_normalMatrix);
    const double count = m_count;
    if (!(whole > count * count * count * 1e-6)) // readings of one moment only
        return std::nullopt;
    const auto solve = [&](std::size_t column) {
        auto changed = m_normalMatrix;
        for (std::size_t row = 0; row < changed.size(); ++row)
            changed[row][column] = right[row];
        return determinant(changed) / whole;
    };
    return Wave{solve(1), solve(2)};
}

std::optional<double> PhaseMeter::lag() const
{
    if (m_count < minPhaseReadings)
        return std::nullopt;
    const auto goal = fit(m_goal);
    const auto position = fit(m_position);
    if (!goal || !position)
        return std::nullopt;
    const double minSpan =
        std::max(minAmplitude, amplitudeFraction * std::hypot(goal->cosine, goal->sine));
    if (!(std::hypot(position->cosine, position->sine) > minSpan))
        return std::nullopt;
    const double behind =
        std::atan2(position->sine, position->cosine) - std::atan2(goal->sine, goal->cosine);
    return std::remainder(behind * 180 / std::numbers::pi, 360);
}

void Magnitude::add(double value)
{
    if (!std::isfinite(value))
        return;
    m_sum += std::abs(value);
    m_peak = std::max(m_peak, std::abs(value));
    ++m_count;
}

std::optional<double> Magnitude::mean() const
{
    return m_count > 0 ? std::optional(m_sum / m_count) : std::nullopt;
}

std::optional<double> Magnitude::peak() const
{
    return m_count > 0 ? std::optional(m_peak) : std::nullopt;
}

SpeedMeter::SpeedMeter(Duration at, double start, double target)
    : m_start(start)
    , m_distance(std::abs(target - start))
    , m_sign(target < start ? -1.0 : 1.0)
    , m_last{at, 0}
    , m_window{m_last}
{}

void SpeedMeter::add(Duration at, double position)
{
    if (m_distance < minLegDistance)
        return;
    const Point point{at, m_sign * (position - m_start)};
    trackMiddle(point);
    updateTopSpeed(point);
    m_last = point;
}

void SpeedMeter::trackMiddle(const Point& point)
{
    if (m_done)
        return;
    const auto passed = [&](double level) {
        return crossingTime(m_last.at, m_last.distance, point.at, point.distance, level);
    };
    if (!m_startedAt && point.distance >= middleFrom * m_distance)
        m_startedAt = passed(middleFrom * m_distance);
    if (!m_startedAt)
        return;
    m_hasGap = m_hasGap || point.at - m_last.at > maxReadingGap;
    if (point.distance >= middleTo * m_distance)
        m_done = passed(middleTo * m_distance);
    else
        ++m_readings;
}

bool SpeedMeter::spansWindow(const Point& from, const Point& to) const
{
    const Duration span = to.at - from.at;
    const double minSpan = std::max(std::min(windowSteps, windowFraction * m_distance),
                                    longWindowFraction * m_distance);
    return span >= minWindow && (to.distance - from.distance >= minSpan || span >= longWindow);
}

void SpeedMeter::updateTopSpeed(const Point& point)
{
    m_window.push_back(point);
    while (m_window.size() > minReadings && spansWindow(m_window[1], point))
        m_window.pop_front();
    const Point& from = m_window.front();
    if (m_window.size() < minReadings || !spansWindow(from, point))
        return;
    // A reading that the host took up late makes the line steeper than the servo was. Where it
    // could not be the steepest anyway, as in hours of rest, nothing is fitted.
    const double steepest =
        (point.distance - from.distance + maxNoise) / seconds(point.at - from.at);
    if (!m_top || steepest > *m_top)
        m_top = std::max(m_top.value_or(0), std::min(slope(), steepest));
}

/// Least squares, about the middle of the stretch. Less what the scatter about the line makes of
/// it: of many slopes the steepest is to be told, and that one has been lucky.
double SpeedMeter::slope() const
{
    const Duration origin = m_window.front().at;
    double time = 0;
    double distance = 0;
    for (const Point& point : m_window) {
        time += seconds(point.at - origin);
        distance += point.distance;
    }
    time /= double(m_window.size());
    distance /= double(m_window.size());
    double product = 0;
    double square = 0;
    double scatter = 0;
    for (const Point& point : m_window) {
        const double off = seconds(point.at - origin) - time;
        product += off * (point.distance - distance);
        square += off * off;
        scatter += (point.distance - distance) * (point.distance - distance);
    }
    if (square <= 0)
        return 0;
    const double steepness = product / square;
    const double residual = std::max(0.0, scatter - steepness * product);
    const double error = std::sqrt(residual / double(m_window.size() - 2) / square);
    return steepness - errorFactor * error;
}

bool SpeedMeter::isKnown() const
{
    return m_startedAt && m_readings >= minReadings && !m_hasGap;
}

std::optional<double> SpeedMeter::mean() const
{
    if (!isKnown() || !m_done || *m_done <= *m_startedAt)
        return std::nullopt;
    return (middleTo - middleFrom) * m_distance / seconds(*m_done - *m_startedAt);
}

std::optional<double> SpeedMeter::top() const
{
    return isKnown() ? m_top : std::nullopt;
}

void MovingFlagCheck::add(Duration at, double position, bool moving, Duration restingSince)
{
    m_isWrong = m_isWrong.value_or(false);
    if (!m_flagState || m_flagState->moving != moving || (!moving && at < m_at + flagRiseTime))
        m_flagState = FlagState{moving, at, position};
    if (moving) {
        const bool isStanding = at - std::max(restingSince, m_flagState->at) >= m_timeout;
        m_isWrong = *m_isWrong || (isStanding && !m_mayStayMoving);
    } else {
        const bool isMoving = std::abs(position - m_flagState->position) > m_minTravel;
        m_isWrong = *m_isWrong || (isMoving && at - m_flagState->at > flagRiseTime);
    }
}
} // namespace jobs

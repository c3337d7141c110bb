// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/leg_parts.h"

#include "jobs/leg_trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jobs {
using base::Duration;
using std::chrono::milliseconds;

namespace {
constexpr Duration smoothing = milliseconds(10);
constexpr double leastWay = 20;
constexpr double middleFrom = 0.1;
constexpr double middleTo = 0.9;
constexpr std::size_t leastReadings = 3;
constexpr Duration longestHole = milliseconds(250);
constexpr Duration leastStretch = milliseconds(40);
constexpr Duration longStretch = std::chrono::seconds(2);
constexpr double stretchSteps = 60;
constexpr double stretchShare = 1.0 / 6; ///< of a short way
constexpr double longShare = 1.0 / 16;   ///< of a long way: what noise adds counts for less
constexpr double doubts = 1;             ///< standard errors of a slope
constexpr double mostNoise = 8;          ///< steps; that a fitted line may be steeper than its ends
constexpr int leastForPhase = 10;        ///< readings
constexpr double leastAmplitude = 2;     ///< steps, and
constexpr double amplitudeShare = 0.02;  ///< of the goal's
constexpr Duration flagRises = milliseconds(100);

double seconds(Duration span)
{
    return double(span.count()) / 1e6;
}
} // namespace

void Stillness::add(Duration at, double position)
{
    if (std::abs(position - m_place) <= m_band)
        return;
    m_place = position;
    m_since = at;
}

double Smoother::add(Duration at, double value)
{
    m_values.push_back({at, value});
    while (at - m_values.front().at > smoothing)
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
            m_left[row][column] += basis[row] * basis[column];
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
    const double whole = determinant(m_left);
    const double count = m_count;
    if (!(whole > count * count * count * 1e-6)) // readings of one moment only
        return std::nullopt;
    const auto solved = [&](std::size_t column) {
        auto changed = m_left;
        for (std::size_t row = 0; row < changed.size(); ++row)
            changed[row][column] = right[row];
        return determinant(changed) / whole;
    };
    return Wave{solved(1), solved(2)};
}

std::optional<double> PhaseMeter::lag() const
{
    if (m_count < leastForPhase)
        return std::nullopt;
    const auto goal = fit(m_goal);
    const auto position = fit(m_position);
    if (!goal || !position)
        return std::nullopt;
    const double least =
        std::max(leastAmplitude, amplitudeShare * std::hypot(goal->cosine, goal->sine));
    if (!(std::hypot(position->cosine, position->sine) > least))
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
    , m_way(std::abs(target - start))
    , m_sign(target < start ? -1.0 : 1.0)
    , m_last{at, 0}
    , m_stretch{m_last}
{}

void SpeedMeter::add(Duration at, double position)
{
    if (m_way < leastWay)
        return;
    const Point point{at, m_sign * (position - m_start)};
    cross(point);
    measureTop(point);
    m_last = point;
}

void SpeedMeter::cross(const Point& point)
{
    if (m_done)
        return;
    const auto passed = [&](double level) {
        return crossing(m_last.at, m_last.gone, point.at, point.gone, level);
    };
    if (!m_begun && point.gone >= middleFrom * m_way)
        m_begun = passed(middleFrom * m_way);
    if (!m_begun)
        return;
    m_hole = m_hole || point.at - m_last.at > longestHole;
    if (point.gone >= middleTo * m_way)
        m_done = passed(middleTo * m_way);
    else
        ++m_readings;
}

bool SpeedMeter::stretches(const Point& from, const Point& to) const
{
    const Duration span = to.at - from.at;
    const double least = std::max(std::min(stretchSteps, stretchShare * m_way), longShare * m_way);
    return span >= leastStretch && (to.gone - from.gone >= least || span >= longStretch);
}

void SpeedMeter::measureTop(const Point& point)
{
    m_stretch.push_back(point);
    while (m_stretch.size() > leastReadings && stretches(m_stretch[1], point))
        m_stretch.pop_front();
    const Point& from = m_stretch.front();
    if (m_stretch.size() < leastReadings || !stretches(from, point))
        return;
    // Hours of rest are not fitted.
    const double span = seconds(point.at - from.at);
    if (m_top && (point.gone - from.gone + mostNoise) / span < *m_top)
        return;
    m_top = std::max(m_top.value_or(0), slope());
}

/// Least squares, about the middle of the stretch. Less what the scatter about the line makes of
/// it: of many slopes the steepest is to be told, and that one has been lucky.
double SpeedMeter::slope() const
{
    const Duration origin = m_stretch.front().at;
    double time = 0;
    double gone = 0;
    for (const Point& point : m_stretch) {
        time += seconds(point.at - origin);
        gone += point.gone;
    }
    time /= double(m_stretch.size());
    gone /= double(m_stretch.size());
    double product = 0;
    double square = 0;
    double scatter = 0;
    for (const Point& point : m_stretch) {
        const double off = seconds(point.at - origin) - time;
        product += off * (point.gone - gone);
        square += off * off;
        scatter += (point.gone - gone) * (point.gone - gone);
    }
    if (square <= 0)
        return 0;
    const double steepness = product / square;
    const double about = std::max(0.0, scatter - steepness * product);
    const double error = std::sqrt(about / double(m_stretch.size() - 2) / square);
    return steepness - doubts * error;
}

bool SpeedMeter::known() const
{
    return m_begun && m_readings >= leastReadings && !m_hole;
}

std::optional<double> SpeedMeter::mean() const
{
    if (!known() || !m_done || *m_done <= *m_begun)
        return std::nullopt;
    return (middleTo - middleFrom) * m_way / seconds(*m_done - *m_begun);
}

std::optional<double> SpeedMeter::top() const
{
    return known() ? m_top : std::nullopt;
}

void FlagMeter::add(Duration at, double position, bool moving, Duration stillSince)
{
    m_wrong = m_wrong.value_or(false);
    if (!m_run || m_run->moving != moving || (!moving && at < m_at + flagRises))
        m_run = Run{moving, at, position};
    if (moving) {
        const bool stands = at - std::max(stillSince, m_run->at) >= m_patience;
        m_wrong = *m_wrong || (stands && !m_mayStay);
    } else {
        const bool goes = std::abs(position - m_run->position) > m_far;
        m_wrong = *m_wrong || (goes && at - m_run->at > flagRises);
    }
}
} // namespace jobs

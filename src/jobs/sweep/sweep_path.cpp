// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/sweep_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jobs {
using base::Duration;
using results::SweepShape;

namespace {
constexpr double usPerSecond = 1e6;
constexpr std::int64_t separationDivisor = 20; ///< of the range, between random targets: 5 %
constexpr int maxStairs = 1000000;

/// The splitmix64 of a place in a sequence. Not std::uniform_*: those differ between libraries.
std::uint64_t hash(std::uint64_t seed, std::uint64_t place)
{
    std::uint64_t z = (seed + 1) * 0xD1342543DE82EF95U + place * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

/// 0 … count − 1. The remainder favors none by more than count / 2^64.
std::int64_t randomIndex(std::uint64_t seed, std::int64_t place, std::int64_t count)
{
    return std::int64_t(hash(seed, std::uint64_t(place)) % std::uint64_t(count));
}

/// The `index`-th of 0 … last that is at least `apart` from both `one` and `other`; with a negative
/// index how many there are.
std::int64_t indexAwayFrom(std::int64_t last, std::int64_t one, std::int64_t other,
                           std::int64_t separation, std::int64_t index)
{
    const auto [low, high] = std::minmax(one, other);
    const std::int64_t below = std::max<std::int64_t>(0, low - separation + 1);
    const std::int64_t inner = std::max<std::int64_t>(0, high - low - 2 * separation + 1);
    const std::int64_t above = std::max<std::int64_t>(0, last - high - separation + 1);
    if (index < 0)
        return below + inner + above;
    if (index < below)
        return index;
    if (index < below + inner)
        return low + separation + (index - below);
    return high + separation + (index - below - inner);
}

/// Speed, and acceleration or 0: at once. False: not known.
bool motionLimits(const results::SweepAxis& axis, double& speed, double& acceleration)
{
    speed = axis.speed.value_or(0);
    acceleration = std::max(0.0, axis.acceleration.value_or(0));
    return std::isfinite(speed) && speed > 0;
}
} // namespace

SweepPath::SweepPath(const results::SweepSpec& spec, const results::SweepAxis& axis)
    : m_spec(spec)
    , m_axis(axis)
{
    const double range = std::abs(axis.to - axis.from);
    // A remainder of less than a thousandth of a stair is rounding, not another stair.
    if (axis.step > 0)
        m_stairs = int(std::clamp(std::ceil(range / axis.step - 0.001), 1.0, double(maxStairs)));
}

double SweepPath::first() const
{
    return m_spec.shape == SweepShape::Points && !m_axis.points.empty() ? m_axis.points.front()
                                                                        : m_axis.from;
}

int SweepPath::legsPerCycle() const
{
    switch (m_spec.shape) {
    case SweepShape::Stairs:
        return 2 * m_stairs;
    case SweepShape::BothSides:
        return 4;
    case SweepShape::Points:
        return std::max(1, int(m_axis.points.size()));
    case SweepShape::Sweep:
    case SweepShape::Random:
    case SweepShape::Sine:
        break;
    }
    return 2;
}

SweepTarget SweepPath::leg(int number) const
{
    const int index = std::max(0, number - 1);
    const int place = index % legsPerCycle();
    SweepTarget stop{m_axis.from, index / legsPerCycle() + 1, {}};
    switch (m_spec.shape) {
    case SweepShape::Sweep:
    case SweepShape::Sine:
        stop.target = place == 0 ? m_axis.to : m_axis.from;
        break;
    case SweepShape::Stairs:
        stop.target = stairTarget(place < m_stairs ? place + 1 : 2 * m_stairs - place - 1);
        break;
    case SweepShape::BothSides:
        if (place % 2 == 0)
            stop.target = std::round((m_axis.from + m_axis.to) / 2);
        else
            stop.target = place == 1 ? m_axis.to : m_axis.from;
        break;
    case SweepShape::Random:
        stop.target = randomTarget(std::int64_t(index) + 1);
        break;
    case SweepShape::Points:
        if (!m_axis.points.empty()) {
            const std::size_t point = std::size_t(place + 1) % m_axis.points.size();
            stop.target = m_axis.points[point];
            if (point < m_spec.points.size())
                stop.pause = m_spec.points[point].pause;
        }
    }
    return stop;
}

double SweepPath::stairTarget(int place) const
{
    if (place >= m_stairs)
        return m_axis.to;
    return m_axis.from + std::copysign(m_axis.step, m_axis.to - m_axis.from) * place;
}

/// Places with even numbers are free, but for 0, which is `from`; those with odd ones keep away
/// from both their neighbors. So none has to know the whole sequence before it.
double SweepPath::randomTarget(std::int64_t number) const
{
    const double range = std::abs(m_axis.to - m_axis.from);
    const auto last = std::int64_t(std::floor(range + 1e-6));
    if (last < 2) // no room to keep away from two neighbors
        return number % 2 == 0 ? m_axis.from : m_axis.to;
    const std::int64_t separation = (last + separationDivisor - 1) / separationDivisor;
    const auto even = [&](std::int64_t place) {
        return place == 0 ? std::int64_t(0) : randomIndex(m_spec.seed, place, last + 1);
    };
    std::int64_t steps = 0;
    if (number % 2 == 0) {
        steps = even(number);
    } else {
        const std::int64_t before = even(number - 1);
        const std::int64_t after = even(number + 1);
        const std::int64_t room = indexAwayFrom(last, before, after, separation, -1);
        steps =
            indexAwayFrom(last, before, after, separation, randomIndex(m_spec.seed, number, room));
    }
    return m_axis.from + std::copysign(double(steps), m_axis.to - m_axis.from);
}

double SweepPath::sineTarget(Duration since) const
{
    if (m_spec.period <= Duration::zero())
        return m_axis.from;
    // The whole periods are taken off first: a night's worth of them must not cost digits.
    const double share = double((since % m_spec.period).count()) / double(m_spec.period.count());
    return m_axis.from +
           (m_axis.to - m_axis.from) * (1 - std::cos(2 * std::numbers::pi * share)) / 2;
}

std::optional<Duration> travelTime(double way, const results::SweepAxis& axis)
{
    double speed = 0;
    double acceleration = 0;
    if (!motionLimits(axis, speed, acceleration))
        return std::nullopt;
    way = std::abs(way);
    double seconds = way / speed;
    if (acceleration > 0) {
        const double rampDistance = speed * speed / acceleration; // the way of both together
        seconds =
            way < rampDistance ? 2 * std::sqrt(way / acceleration) : seconds + speed / acceleration;
    }
    return Duration(std::llround(std::min(seconds, 1e12) * usPerSecond));
}

std::optional<double> plannedPosition(double start, double target, Duration since,
                                      const results::SweepAxis& axis)
{
    double speed = 0;
    double acceleration = 0;
    if (!motionLimits(axis, speed, acceleration))
        return std::nullopt;
    const double way = std::abs(target - start);
    const double seconds = std::max(0.0, double(since.count()) / usPerSecond);
    double done = speed * seconds;
    if (acceleration > 0) {
        const double top = std::min(speed, std::sqrt(way * acceleration));
        const double ramp = top / acceleration; // seconds
        const double totalTime = ramp + (top > 0 ? way / top : 0);
        if (seconds <= ramp)
            done = acceleration * seconds * seconds / 2;
        else if (seconds <= totalTime - ramp)
            done = top * (seconds - ramp / 2);
        else if (seconds < totalTime)
            done = way - acceleration * (totalTime - seconds) * (totalTime - seconds) / 2;
        else
            done = way;
    }
    return start + std::copysign(std::min(done, way), target - start);
}
} // namespace jobs

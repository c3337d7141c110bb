// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/sweep/leg_trace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jobs {
using base::Duration;

namespace {
constexpr std::size_t rawCapacity = LegTrace::capacity / 2;
constexpr std::size_t newest = 4; ///< readings that no block takes yet
constexpr int tailDivisor = 5;    ///< the last fifth gives the resting position
constexpr std::size_t minTailReadings = 3;
constexpr double maxTraceNoise = 2;
constexpr double minBand = 3; ///< a servo that stays within it stands still
constexpr Duration minRestDuration = std::chrono::milliseconds(100);

using Points = std::vector<LegPoint>::const_iterator;

/// Lowest and highest in order of time; each stands for one half of them.
std::pair<LegPoint, LegPoint> extremes(Points begin, Points end)
{
    const auto [low, high] =
        std::minmax_element(begin, end, [](const LegPoint& one, const LegPoint& other) {
            return one.position < other.position;
        });
    LegPoint first = *std::min(low, high);
    LegPoint second = *std::max(low, high);
    first.sum = second.sum = 0;
    first.count = second.count = 0;
    const Points middle = begin + (end - begin) / 2;
    for (Points point = begin; point != end; ++point) {
        LegPoint& half = point < middle ? first : second;
        half.sum += point->sum;
        half.count += point->count;
    }
    return {first, second};
}

struct Tail {
    double mean = 0;
    double spread = 0;
    double readings = 0;
};

/// Of the points from `first` on: the last fifth of their time, at least three of them.
Tail tailStatistics(const std::vector<LegPoint>& points, std::size_t first)
{
    const Duration end = points.back().at;
    const Duration from = end - (end - points[first].at) / tailDivisor;
    std::size_t begin = points.size();
    while (begin > first &&
           (points[begin - 1].at >= from || points.size() - begin < minTailReadings))
        --begin;
    double sum = 0;
    double count = 0;
    for (std::size_t i = begin; i < points.size(); ++i) {
        sum += points[i].sum;
        count += points[i].count;
    }
    Tail tail{sum / count, 0, count};
    for (std::size_t i = begin; i < points.size(); ++i)
        tail.spread = std::max(tail.spread, std::abs(points[i].position - tail.mean));
    return tail;
}

/// The first of the points from `first` on after which all keep within `band` of `place`;
/// points.size(): the last one does not.
std::size_t firstWithin(const std::vector<LegPoint>& points, std::size_t first, double place,
                        double band)
{
    std::size_t since = points.size();
    while (since > first && std::abs(points[since - 1].position - place) <= band)
        --since;
    return since;
}

bool restsLongEnough(const std::vector<LegPoint>& points, std::size_t since, Duration minDuration)
{
    return points.size() >= since + minTailReadings &&
           points.back().at - points[since].at >= minDuration;
}

void setRest(LegRest& rest, const std::vector<LegPoint>& points, std::size_t since)
{
    const Tail tail = tailStatistics(points, since);
    rest.isSteady = true;
    rest.place = tail.mean;
    rest.spread = tail.spread;
    rest.readings = tail.readings;
}

/// When the stay within tolerance began that lasts till the end. `since`: the first point of it
/// with noise allowed, which may still be a little outside.
void findSettling(LegRest& rest, const std::vector<LegPoint>& points, std::size_t since,
                  const RestCriteria& query)
{
    const auto outside = [&](std::size_t i) {
        return std::abs(points[i].position - query.target) > query.tolerance;
    };
    while (since < points.size() && outside(since))
        ++since;
    if (since == points.size())
        return;
    const LegPoint& in = points[since];
    const LegPoint& out = points[since - 1];
    const double edge = query.target + std::copysign(query.tolerance, out.position - query.target);
    rest.settledAt = crossingTime(out.at, out.position, in.at, in.position, edge);
}

/// Not at its target: perhaps it stands elsewhere, about where it was last.
void findRestElsewhere(LegRest& rest, const std::vector<LegPoint>& points,
                       const RestCriteria& query)
{
    if (points.size() < minTailReadings)
        return;
    std::array<double, minTailReadings> last{};
    for (std::size_t i = 0; i < minTailReadings; ++i)
        last[i] = points[points.size() - 1 - i].position;
    std::sort(last.begin(), last.end());
    const double noise = std::min(maxTraceNoise, tailStatistics(points, 0).spread);
    const double band = std::max(query.tolerance, minBand) + noise;
    const std::size_t since = firstWithin(points, 0, last[1], band);
    if (since < points.size() &&
        restsLongEnough(points, since, minRestDuration + 2 * query.minCrossTime))
        setRest(rest, points, since);
}
} // namespace

void LegTrace::add(Duration at, double position)
{
    m_points.push_back({at, position, position, 1});
    if (m_blockSize > 0 && m_points.size() - m_firstRaw >= m_blockSize + newest) {
        const auto begin = m_points.begin() + std::ptrdiff_t(m_firstRaw);
        const auto end = begin + std::ptrdiff_t(m_blockSize);
        const auto [first, second] = extremes(begin, end);
        begin[0] = first;
        begin[1] = second;
        m_points.erase(begin + 2, end);
        m_firstRaw += 2;
    }
    if (m_points.size() >= capacity)
        decimate();
}

void LegTrace::decimate()
{
    const std::size_t end = m_blockSize == 0 ? m_points.size() - newest : m_firstRaw;
    std::size_t keptCount = rawCapacity;
    std::size_t next = rawCapacity;
    for (; next + 4 <= end; next += 4) {
        const auto begin = m_points.begin() + std::ptrdiff_t(next);
        const auto [first, second] = extremes(begin, begin + 4);
        m_points[keptCount++] = first;
        m_points[keptCount++] = second;
    }
    m_firstRaw = keptCount + (end - next);
    m_blockSize = m_blockSize == 0 ? 4 : 2 * m_blockSize;
    m_points.erase(m_points.begin() + std::ptrdiff_t(keptCount),
                   m_points.begin() + std::ptrdiff_t(next));
}

Duration crossingTime(Duration before, double from, Duration after, double to, double level)
{
    if (from == to)
        return after;
    const double share = std::clamp((level - from) / (to - from), 0.0, 1.0);
    return before + Duration(std::llround(share * double((after - before).count())));
}

std::optional<LegRest> analyzeRest(const std::vector<LegPoint>& points, const RestCriteria& query)
{
    if (points.empty())
        return std::nullopt;
    LegRest rest;
    rest.place = points.back().position;
    if (!query.arrival) {
        findRestElsewhere(rest, points, query);
        return rest;
    }
    const auto arrived = std::find_if(points.begin(), points.end(), [&](const LegPoint& point) {
        return point.at >= *query.arrival;
    });
    const auto first = std::size_t(arrived - points.begin());
    if (first == points.size())
        return rest;
    const double noise = std::min(maxTraceNoise, tailStatistics(points, first).spread);
    const std::size_t since = firstWithin(points, first, query.target, query.tolerance + noise);
    rest.hasLeft = since > first;
    if (since == points.size()) {
        findRestElsewhere(rest, points, query);
        return rest;
    }
    if (rest.hasLeft)
        findSettling(rest, points, since, query);
    else
        rest.settledAt = query.arrival;
    if (restsLongEnough(points, since, minRestDuration + query.minCrossTime)) {
        setRest(rest, points, since);
        return rest;
    }
    // It may stand just outside, with only its noise inside.
    findRestElsewhere(rest, points, query);
    if (rest.isSteady && std::abs(rest.place - query.target) > query.tolerance)
        rest.settledAt.reset();
    return rest;
}
} // namespace jobs

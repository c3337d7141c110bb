// SPDX-License-Identifier: GPL-3.0-or-later
// The positions of one leg, and where and when the servo came to rest in them. Room for a night in
// 4 MB: the first 65 536 readings stay as they are, and so do the last ones; of those between, the
// longer the leg the longer blocks (each as long as the others, 1.5 s after 8 h at 700 Hz) keep
// their extremes only, and the sums of what these stand for. Part of LegMeter; pure, its thread.
// Steps of the feedback, bus time.
#pragma once

#include "base/clock.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace jobs {
struct LegPoint {
    base::Duration at{};
    double position = 0;
    double sum = 0; ///< of the readings it stands for
    int count = 1;
};

class LegTrace {
public:
    static constexpr std::size_t capacity = 131072;

    void add(base::Duration at, double position);
    const std::vector<LegPoint>& points() const { return m_points; }

private:
    void decimate();

    std::vector<LegPoint> m_points;
    std::size_t m_blockSize = 0; ///< number of readings that become two points; 0: not thinned yet
    std::size_t m_firstRaw = 0;  ///< the first point that is no block's
};

/// The settings for evaluating the end of a leg.
struct RestCriteria {
    double target = 0;
    double tolerance = 0;
    std::optional<base::Duration> arrival{}; ///< first within tolerance
    base::Duration minCrossTime{}; ///< the time the way through the tolerance takes, at the least
};

/// How a leg ended. Within tolerance counts what exceeds it by no more than the noise at rest: the
/// largest deviation from their mean of the readings in the last fifth since arrival, at most 2.
struct LegRest {
    bool isSteady = false; ///< it stood: by three readings, and long enough not to be passing by
    double place = 0;      ///< steady: mean of the last fifth of the time it stood; else the last
    double spread = 0;     ///< steady: largest deviation in that fifth
    double readings = 0;   ///< steady: number of readings in it
    bool hasLeft = false;  ///< it was within tolerance and went out again
    std::optional<base::Duration>
        settledAt{}; ///< since when it was within; none: at last it was not
};

/// nullopt: there was no reading.
std::optional<LegRest> analyzeRest(const std::vector<LegPoint>& points, const RestCriteria& query);

/// The moment between two readings when the position was `level`.
base::Duration crossingTime(base::Duration before, double from, base::Duration after, double to,
                            double level);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// What LegMeter measures reading by reading, without keeping the readings: rest, speeds, the
// moving flag. Parts of it; pure, its thread. Steps of the feedback, steps/s, bus time.
#pragma once

#include "base/clock.h"

#include <array>
#include <deque>
#include <optional>

namespace jobs {
/// Since when the position has kept within `band` of one place.
class SettleDetector {
public:
    SettleDetector(double band, base::Duration at, double position)
        : m_band(band)
        , m_center(position)
        , m_since(at)
    {}
    void add(base::Duration at, double position);
    base::Duration since() const { return m_since; }

private:
    double m_band;
    double m_center;
    base::Duration m_since;
};

/// The mean of the last 10 ms: single readings are noisy, and no servo turns round so quickly.
class MovingAverage {
public:
    double add(base::Duration at, double value);

private:
    struct Value {
        base::Duration at;
        double value;
    };
    std::deque<Value> m_values;
};

/// How far a position is behind a goal that moves along a sine: both are fitted by the same period,
/// with an offset of their own, and their phases compared.
class PhaseMeter {
public:
    void add(double turns, double goal, double position); ///< `turns`: periods since any moment
    /// Degrees, −180 to 180, positive: behind. Not measured: from fewer than ten readings, or where
    /// the position hardly moves (2 % of the goal's amplitude, or 2 steps).
    std::optional<double> lag() const;

private:
    struct Wave {
        double cosine = 0;
        double sine = 0;
    };
    using Sums = std::array<double, 3>;
    std::optional<Wave> fit(const Sums& right) const;

    int m_count = 0;
    std::array<Sums, 3> m_normalMatrix{}; ///< products of 1, cos and sin
    Sums m_goal{};
    Sums m_position{};
};

/// Mean and peak magnitude.
struct Magnitude {
    void add(double value);
    std::optional<double> mean() const;
    std::optional<double> peak() const;

private:
    double m_sum = 0;
    double m_peak = 0;
    int m_count = 0;
};

/// Mean speed: over the middle 80 % of the way. Top speed: the steepest stretch that is at least
/// 40 ms and three readings long and at least 60 steps or a sixth of the way, of long ways a
/// sixteenth (or two seconds, where less is gone in them), by the straight line that fits its
/// readings best, less its standard error, and no steeper than its ends are with 8 steps of noise.
/// Not measured: on ways under 20 steps, with fewer than three readings in the middle 80 %, or with
/// a hole of more than 250 ms in it; the mean also when the end of it was not reached.
class SpeedMeter {
public:
    SpeedMeter(base::Duration at, double start, double target);
    void add(base::Duration at, double position);
    std::optional<double> mean() const;
    std::optional<double> top() const;

private:
    struct Point {
        base::Duration at;
        double distance;
    };
    bool isKnown() const;
    void trackMiddle(const Point& point);
    void updateTopSpeed(const Point& point);
    bool spansWindow(const Point& from, const Point& to) const;
    double slope() const;

    double m_start;
    double m_distance; ///< without sign
    double m_sign;
    Point m_last;
    std::optional<base::Duration> m_startedAt{}; ///< 10 % of the way were gone
    std::optional<base::Duration> m_done{};      ///< 90 %
    std::size_t m_readings = 0;                  ///< between them
    bool m_hasGap = false;
    std::deque<Point> m_window;
    std::optional<double> m_top{};
};

/// Whether a moving flag contradicts the position: it is set for `patience` while the servo stands
/// (4 steps), or denies it while the servo goes `far` (longer than 100 ms, and from 100 ms after
/// the goal on: it takes a moment to rise).
class MovingFlagCheck {
public:
    MovingFlagCheck(base::Duration at, double minTravel, base::Duration timeout)
        : m_at(at)
        , m_minTravel(minTravel)
        , m_timeout(timeout)
    {}
    void add(base::Duration at, double position, bool moving, base::Duration restingSince);
    /// A flag that stays up is nothing wrong: the goal itself is moving.
    void allowMoving() { m_mayStayMoving = true; }
    std::optional<bool> isWrong() const { return m_isWrong; }

private:
    struct FlagState {
        bool moving;
        base::Duration at;
        double position;
    };
    base::Duration m_at;
    double m_minTravel;
    base::Duration m_timeout;
    bool m_mayStayMoving = false;
    std::optional<FlagState> m_flagState{}; ///< since the flag last changed
    std::optional<bool> m_isWrong{};
};
} // namespace jobs

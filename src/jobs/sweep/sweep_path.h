// SPDX-License-Identifier: GPL-3.0-or-later
// Where a sweep test goes next: targets of one servo, leg by leg, without end. Pure; any thread.
// Steps of the feedback, spans of bus time. A leg's target is worked out from its number alone, in
// the same time whatever the number.
//   Sweep, Sine  to, from                                         a cycle has 2 legs
//   Stairs       from + step … to, and back the same stairs; the last one may be shorter
//   BothSides    middle (a whole step), to, middle, from          4 legs
//   Random       whole steps from `from`, never nearer to the one before than 5 % of the range and
//                one step; the same for the same seed on every machine      2 legs
//   Points       from the second point on through the list, and back to the first
#pragma once

#include "results/sweep_spec.h"

namespace jobs {
struct SweepTarget {
    double target = 0;
    int cycle = 1;                         ///< the leg to this target belongs to it
    std::optional<base::Duration> pause{}; ///< of a list of points
};

class SweepPath {
public:
    SweepPath(const results::SweepSpec& spec, const results::SweepAxis& axis);

    /// Where the run begins; the way there is no leg.
    double first() const;
    /// The target of leg `number` (from 1). Always the same for the same number.
    SweepTarget leg(int number) const;
    int legsPerCycle() const;

    /// Sine: the goal at a time after the start: begins at `from`, half a period later at `to`.
    double sineTarget(base::Duration since) const;

private:
    double stairTarget(int place) const;
    double randomTarget(std::int64_t number) const;

    results::SweepSpec m_spec;
    results::SweepAxis m_axis;
    int m_stairs = 1; ///< from one end to the other
};

/// How long the servo needs for `way` steps: a trapezoid under its speed and acceleration.
/// nullopt: no speed is known.
std::optional<base::Duration> travelTime(double way, const results::SweepAxis& axis);
/// The planned position `since` after the goal, for a move from rest at `start` to `target`.
/// nullopt: no speed is known.
std::optional<double> plannedPosition(double start, double target, base::Duration since,
                                      const results::SweepAxis& axis);
} // namespace jobs

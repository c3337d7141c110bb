// SPDX-License-Identifier: GPL-3.0-or-later
// Where a sweep test goes next: targets of one servo, leg by leg, without end. Pure; any thread.
// Steps of the feedback, seconds of bus time.
#pragma once

#include "record/sweep_spec.h"

namespace jobs {
struct SweepStop {
    double target = 0;
    int cycle = 1;                         ///< the leg to this target belongs to it
    std::optional<base::Duration> pause{}; ///< of a list of points
};

class SweepPath {
public:
    SweepPath(const record::SweepSpec& spec, const record::SweepAxis& axis);

    /// Where the run begins; the way there is no leg.
    double first() const;
    /// The target of leg `number` (from 1). The same for the same number, whenever asked.
    SweepStop leg(int number) const;
    int legsPerCycle() const;

    /// Sine: the goal so long after the start.
    double wave(base::Duration since) const;

private:
    std::vector<double> m_targets; ///< of one cycle; not Random, not Sine
    record::SweepSpec m_spec;
    record::SweepAxis m_axis;
};

/// How long the servo needs for `way` steps: a trapezoid under its speed and acceleration.
/// nullopt: no speed is known.
std::optional<base::Duration> travelTime(double way, const record::SweepAxis& axis);
/// Where it should be `since` after it was told to go from `start` to `target`.
std::optional<double> plannedPosition(double start, double target, base::Duration since,
                                      const record::SweepAxis& axis);
} // namespace jobs

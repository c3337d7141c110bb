// SPDX-License-Identifier: GPL-3.0-or-later
// Measures one leg of a sweep test from the readings that came during it. Pure; the job's thread.
// Times are bus time; between two readings the moment of crossing is interpolated.
//   time to target: from the goal to the first moment within tolerance
//   settling:       from then to the moment after which it never left tolerance again
//   reached:        mean of the readings in the last fifth of what remains after settling, at least
//                   three of them; overshoot: most beyond the target, in the direction of the way,
//                   above the place where it came to rest
//   mean speed:     over the middle 80 % of the way; top speed: steepest 40 ms
#pragma once

#include "jobs/sweep_path.h"
#include "record/sweep_run.h"

namespace jobs {
/// One reading of one servo, in the units of record/sweep_run.h.
struct SweepSample {
    base::Duration at{}; ///< bus clock
    bool answered = false;
    std::optional<double> position{};
    std::optional<double> speed{};
    std::optional<double> load{};
    std::optional<double> current{};
    std::optional<double> voltage{};
    std::optional<double> temperature{};
    std::optional<bool> moving{};
    std::uint8_t status = 0;
};

class LegMeter {
public:
    /// `at`: the goal had been sent, bus clock. `start`: where the servo stood then.
    LegMeter(const record::SweepAxis& axis, int number, int cycle, base::Duration at, double start,
             double target);

    void add(const SweepSample& sample);

    /// Within tolerance, and still for `rest`.
    bool arrived(base::Duration rest) const;
    /// Away from its target and without motion for `span`, although it has had that long.
    bool stalled(base::Duration span) const;

    /// `end`: the next goal was sent. `runStart` becomes the zero of SweepLeg::at.
    record::SweepLeg finish(base::Duration end, base::Duration runStart) const;

private:
    struct Point {
        base::Duration at;
        double position;
        bool moving;
        bool hasFlag;
    };
    record::SweepAxis m_axis;
    record::SweepLeg m_leg;
    base::Duration m_at;
    std::vector<Point> m_points;
    double m_currentSum = 0;
    int m_currents = 0;
    double m_loadSum = 0;
    int m_loads = 0;
};
} // namespace jobs

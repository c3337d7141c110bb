// SPDX-License-Identifier: GPL-3.0-or-later
// Measures one leg of a sweep test from the readings that came during it. Pure; the job's thread.
// Times are bus time; between two readings the moment of crossing is interpolated, but not across
// lost ones of more than 50 ms together: then it is the later reading's.
//   time to target: from the goal to the first moment within tolerance; 0 if it stood there
//   settling:       from then to the moment after which it never left tolerance again, but for the
//                   noise it shows at rest (at most 2 steps). If it was still outside at the end,
//                   until the end, which is the least it can be. Not measured where it was never
//                   seen to leave, but not long enough either to say that it stays
//   at rest:        three readings within tolerance (or, away from its target, within tolerance,
//                   at least 3 steps, and the noise of one place), for 100 ms and the time its
//                   speed needs for as much way (away from its target: twice as much)
//   reached:        at rest, the mean of the readings in the last fifth of the time it was so, at
//                   least three of them; else the last reading
//   steady error:   reached − target, at rest only
//   overshoot:      how far beyond the place of rest it has been in the direction of the way, by
//                   the mean of 10 ms; none if not more than twice the noise at rest (2 to 3.5
//                   steps; 3.5 if it comes from fewer than ten readings). If it did not come to
//                   rest, beyond the target. In % of the way: on ways over twice the tolerance
//   speeds:         SpeedMeter; moving flag: MovingFlagCheck
//   following error: how far behind the planned path, at most, by the mean of 10 ms. A reading is
//                   compared with the path one reading earlier (at most 5 ms), because goal and
//                   reading may have been on the wire for that time
//   phase lag:      of a sine, by PhaseMeter, against the path as above
//   current, load:  magnitudes
// Of a leg with a silence of 300 ms or more only rest, current and load are known: the run removes
// the other figures, and those of rest too if the silence was at the end. The
// goals of a sine move on: time to target, settling, rest and overshoot are not measured there.
#pragma once

#include "jobs/sweep/leg_parts.h"
#include "jobs/sweep/leg_trace.h"
#include "jobs/sweep/sweep_path.h"
#include "results/sweep_run.h"

#include <functional>

namespace jobs {
/// One reading of one servo, in the units of results/sweep_run.h.
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
    LegMeter(const results::SweepAxis& axis, int number, int cycle, base::Duration at, double start,
             double target);

    /// The goal of a sine by the time after `at`, and its period. Before the first reading.
    void followPath(std::function<double(base::Duration since)> path, base::Duration period);

    /// A goal of a sine was sent at `at`: until then the servo had nowhere else to go.
    void setGoal(base::Duration at, double goal);

    /// In order of time; readings from before the goal are ignored.
    void add(const SweepSample& sample);

    /// Within tolerance (and 2 steps of noise) and within as much, at least 4 steps, of one place,
    /// both for `rest`.
    bool arrived(base::Duration rest) const;
    /// For `rest` at one place as arrived() has it, perhaps beside its target, but no further from
    /// it than a servo that stalled().
    bool restsNearTarget(base::Duration rest) const;
    /// Further from the goal it was sent than its tolerance and 1/64 turn, which friction and load
    /// may leave, and within 4 steps of one place, both for `span`, although it has had that long,
    /// and the time that its speed and acceleration need for more than that.
    bool isStalled(base::Duration span) const;

    /// `end`: the next goal was sent. `runStart` becomes the zero of SweepLeg::at.
    results::SweepLeg finish(base::Duration end, base::Duration runStart) const;

private:
    double restTolerance() const;
    void updateAwaySince(base::Duration at);
    void addPosition(base::Duration at, double position);
    void detectArrival(base::Duration at, double position);
    void measureFollowingError(base::Duration at, double position);
    void finishRest(results::SweepLeg& leg, base::Duration end) const;
    void finishOvershoot(results::SweepLeg& leg, const LegRest& rest) const;
    double signedError(double position) const; ///< beyond the target, in the direction of the way

    struct Reading {
        base::Duration at{};
        double position = 0;
    };
    results::SweepAxis m_axis;
    results::SweepLeg m_leg; ///< as far as it is known already
    base::Duration m_goalSentAt;
    std::function<double(base::Duration)> m_path;
    base::Duration m_period{};                   ///< of m_path
    base::Duration m_startUpTime;                ///< until it can have been seen to move
    double m_goal;                               ///< as sent
    std::optional<base::Duration> m_awaySince{}; ///< restTolerance() and more from m_goal

    Reading m_last;                                ///< at first where it stood
    bool m_hasReading = false;                     ///< m_last was read in this leg
    bool m_sampleLost = false;                     ///< since m_last
    base::Duration m_previousAt{};                 ///< the sample before, answered or not
    std::optional<base::Duration> m_insideSince{}; ///< within tolerance since
    SettleDetector m_settle;
    SettleDetector m_coarseSettle; ///< a coarser one, for arrived()
    SpeedMeter m_speedMeter;
    MovingFlagCheck m_movingFlag;
    LegTrace m_trace;
    MovingAverage m_smoothedError;
    MovingAverage m_smoothedLag;
    PhaseMeter m_phase;
    std::optional<double> m_peak{}; ///< furthest side()
    Magnitude m_current;
    Magnitude m_load;
};
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a servo with defects really brings its shaft while its path leads it to the goal: beside
// the goal by rest hysteresis and static error, past it and back when badly damped. Plain value of
// one servo; its thread. Steps, step/s, seconds.
#pragma once

#include "sim/faults/defects.h"
#include "sim/servo/trajectory.h"

namespace sim {
/// A point of a planned motion.
struct Setpoint {
    double position = 0;
    double speed = 0;        ///< 0 on the path: there the loop lags, as a healthy one does
    double acceleration = 0; ///< step/s²
};

/// Where the shaft truly is, finer than its sensor's steps.
struct Shaft {
    double position = 0;
    double speed = 0;
};

class DefectTrajectory {
public:
    void restart(double at);
    /// The next goal of the path and the position it starts from. Call it before the path's step of
    /// time.
    void setGoal(double goal, double from);

    /// One step of time, after the path's.
    Setpoint follow(const Defects& defects, const Trajectory& path, double topSpeed,
                    const Shaft& shaft, double seconds);

    /// Past its goal, or on the way back to it.
    bool isSwinging() const { return m_phase == Phase::Overshoot || m_phase == Phase::Returning; }

private:
    enum class Phase {
        Path,      ///< on its way
        Overshoot, ///< beyond the goal, and stays there for a moment
        Returning,
        Rest,
    };
    void startSwing(Phase phase, double from, double speed, double to, double topSpeed,
                    double minDuration);
    Setpoint swingSetpoint() const;

    Phase m_phase = Phase::Rest;
    double m_goal = 0;
    double m_distance = 0;     ///< of this move, signed
    double m_restPosition = 0; ///< where it would rest for hysteresis alone
    double m_from = 0;         ///< the swing under way: from here, at this speed …
    double m_fromSpeed = 0;
    double m_to = 0; ///< … to rest there …
    double m_duration = 0;
    double m_elapsed = 0;
};
} // namespace sim

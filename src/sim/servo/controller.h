// SPDX-License-Identifier: GPL-3.0-or-later
// The control loops of the servo's firmware, one call a millisecond: from goal and measured
// position to the duty of the bridge. Plain class; its servo's thread. Steps, step/s, duty in 0.1
// %; positive is towards larger positions.
#pragma once

#include "sim/faults/defect_trajectory.h"
#include "sim/servo/settings.h"

namespace sim {
class Controller {
public:
    static constexpr double tick = 0.001; ///< s

    /// Torque has just come on at this position: hold it, without any history.
    void energize(double position);
    /// Torque is off: the goal in use follows the shaft.
    void follow(double position);

    /// Position and step mode. `limit` is the largest duty allowed now.
    double holdPosition(const Settings& s, double goal, double topSpeed, double position,
                        double limit);
    /// The same for a servo with defects, in two steps: where it brings its shaft …
    Setpoint defectSetpoint(const Settings& s, const Defects& defects, double goal, double topSpeed,
                            const Shaft& shaft);
    /// … and the duty that brings it there, where `support` is the duty that load and friction
    /// take. It has no dead zone and no I, which would blur or hide the defects.
    double holdDefectSetpoint(const Settings& s, const Setpoint& setpoint, double position,
                              double support, double limit);
    /// Closed-loop speed.
    double holdSpeed(const Settings& s, double goal, double speed, double limit);

    const Trajectory& path() const { return m_path; }
    bool isAtRest() const { return m_path.speed == 0.0 && !m_defectTrajectory.isSwinging(); }

private:
    double proportional(const Settings& s, double error) const;

    double rateOf(double error)
    {
        constexpr double share = 0.25; // smoothing: a time constant of 4 ticks
        m_errorRate += ((error - m_lastError) / tick - m_errorRate) * share;
        m_lastError = error;
        return m_errorRate;
    }

    Trajectory m_path;
    DefectTrajectory m_defectTrajectory;
    double m_integral = 0;  ///< duty
    double m_lastError = 0; ///< steps
    double m_errorRate = 0; ///< step/s, smoothed
    double m_speedGoal = 0; ///< step/s, after the acceleration limit
};
} // namespace sim

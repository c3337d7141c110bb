// SPDX-License-Identifier: GPL-3.0-or-later
// The goal of the position loop: the goal register, or what replaces it (the position where torque
// came on, the sum of all steps in step mode), and the speed that the goal time asks for. Owned by
// a ServoDrive; one thread. Steps and step/s, in the servo's own coordinate.
#pragma once

#include "sim/servo/settings.h"

namespace sim {
class MotionGoal {
public:
    /// `settings` must outlive the goal.
    MotionGoal(const Settings& settings, int turnSteps)
        : m_settings(settings)
        , m_turnSteps(turnSteps)
    {}

    void powerOn(double position);
    void registerWritten(); ///< the goal register counts from now on
    void hold(double position) { m_holdPosition = position; }
    void follow(double position) { m_stepGoal = position; } ///< torque is off
    /// The coordinate has moved by `distance`, so that the shaft is at `position` now.
    void shiftCoordinate(double distance, double position);
    /// A write to the register that drives the mode. `addsStep`: it is a distance.
    void command(bool addsStep, double from);

    double position() const;
    double speed() const; ///< requested, before wear limits it
    double stepGoal() const { return m_stepGoal; }
    bool wasWritten() const { return m_written; } ///< since power-on

private:
    const Settings& m_settings;
    int m_turnSteps;
    double m_stepGoal = 0;                ///< where the sum of all steps leads
    double m_timedSpeed = 0;              ///< SCS, LX: makes the goal time of this move
    std::optional<double> m_holdPosition; ///< instead of the goal register
    bool m_written = false;
};
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/controller.h"

namespace sim {
namespace {
constexpr double fullDuty = 1000.0;
} // namespace

void Controller::energize(double position)
{
    *this = Controller();
    follow(position);
}

void Controller::follow(double position)
{
    m_path.restart(position);
    m_defectTrajectory.restart(position);
}

/// P; any duty is at least the startup force.
double Controller::proportional(const Settings& s, double error) const
{
    const double duty = s.positionP * error;
    return std::abs(duty) < s.startupForce ? std::copysign(s.startupForce, error) : duty;
}

double Controller::holdPosition(const Settings& s, double goal, double topSpeed, double position,
                                double limit)
{
    m_path.advance(goal, topSpeed, s.acceleration, tick);
    const double error = m_path.position - position;
    const double rate = rateOf(error);
    double duty = m_integral;
    if (error > s.cwDeadZone || error < -s.ccwDeadZone) {
        duty += proportional(s, error) + s.positionD * rate;
        // No wind-up against a limit that is already reached.
        if (std::abs(duty) < limit || duty * error < 0.0) {
            const double maxIntegral = s.integralLimit > 0.0 ? s.integralLimit : fullDuty;
            m_integral =
                std::clamp(m_integral + s.positionI * error * tick, -maxIntegral, maxIntegral);
        }
    }
    return std::clamp(duty, -limit, limit);
}

Setpoint Controller::defectSetpoint(const Settings& s, const Defects& defects, double goal,
                                    double topSpeed, const Shaft& shaft)
{
    m_defectTrajectory.setGoal(goal, m_path.position);
    m_path.advance(goal, topSpeed, s.acceleration, tick);
    return m_defectTrajectory.follow(defects, m_path, topSpeed, shaft, tick);
}

double Controller::holdDefectSetpoint(const Settings& s, const Setpoint& setpoint, double position,
                                      double support, double limit)
{
    const double error = setpoint.position - position;
    const double rate = rateOf(error);
    return std::clamp(s.positionP * error + s.positionD * rate + support, -limit, limit);
}

double Controller::holdSpeed(const Settings& s, double goal, double speed, double limit)
{
    const double change = s.acceleration > 0.0 ? s.acceleration * tick : HUGE_VAL;
    m_speedGoal += std::clamp(goal - m_speedGoal, -change, change);
    const double error = m_speedGoal - speed;
    const double duty = s.speedP * error + m_integral;
    if (std::abs(duty) < limit || duty * error < 0.0) {
        m_integral = std::clamp(m_integral + s.speedI * error * tick, -fullDuty, fullDuty);
    }
    return std::clamp(duty, -limit, limit);
}
} // namespace sim

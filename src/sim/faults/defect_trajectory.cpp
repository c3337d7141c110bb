// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/faults/defect_trajectory.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
constexpr double minOvershootTime = 0.08;  ///< s, at least
constexpr double overshootHoldTime = 0.03; ///< s at the farthest point
constexpr double minReturnTime = 0.15;     ///< s, at least
constexpr double peakSpeedRatio = 1.875;   ///< largest over mean speed of a swing from rest
constexpr double maxStartSpeedRatio =
    2.5; ///< first over mean speed of one that need not turn round
} // namespace

void DefectTrajectory::restart(double at)
{
    *this = DefectTrajectory();
    m_goal = m_restPosition = at;
}

void DefectTrajectory::setGoal(double goal, double from)
{
    if (goal == m_goal) {
        return;
    }
    m_distance = goal - from;
    m_goal = goal;
    m_phase = Phase::Path;
}

/// As long as it takes without going faster than `topSpeed`, or past `to`.
void DefectTrajectory::startSwing(Phase phase, double from, double speed, double to,
                                  double topSpeed, double minDuration)
{
    const double distance = to - from;
    m_phase = phase;
    m_from = from;
    m_to = to;
    m_fromSpeed = speed * distance > 0.0 ? speed : 0.0;
    const double maxSpeed = std::max({topSpeed, std::abs(m_fromSpeed), 1.0});
    m_duration = std::max(minDuration, peakSpeedRatio * std::abs(distance) / maxSpeed);
    if (m_fromSpeed != 0.0) {
        m_duration = std::min(m_duration, maxStartSpeedRatio * distance / m_fromSpeed);
    }
    m_elapsed = 0;
}

/// The quintic with these ends and speeds, and without acceleration at its ends.
Setpoint DefectTrajectory::swingSetpoint() const
{
    const double u = m_duration > 0.0 ? m_elapsed / m_duration : 1.0;
    if (u >= 1.0) {
        return {m_to, 0.0, 0.0};
    }
    const double distance = m_to - m_from;
    const double start = m_fromSpeed * m_duration;
    const double c3 = 10.0 * distance - 6.0 * start;
    const double c4 = 8.0 * start - 15.0 * distance;
    const double c5 = 6.0 * distance - 3.0 * start;
    const double u2 = u * u;
    return {m_from + start * u + u2 * u * (c3 + u * (c4 + u * c5)),
            (start + u2 * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5))) / m_duration,
            u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5)) / (m_duration * m_duration)};
}

Setpoint DefectTrajectory::follow(const Defects& defects, const Trajectory& path, double topSpeed,
                                  const Shaft& shaft, double seconds)
{
    // Whole steps on either side, so that an even reading comes out at rest.
    const double below = std::floor(0.5 * defects.restHysteresis);
    const double above = defects.restHysteresis - below;
    m_restPosition = std::clamp(m_restPosition, path.position - below, path.position + above);
    const double rest = m_restPosition + defects.staticError;
    const bool arrived = path.position == m_goal && path.speed == 0.0;
    if (!arrived) {
        return {rest, 0.0, 0.0};
    }
    if (m_phase == Phase::Path) {
        const double beyond = std::round(m_distance * 0.01 * defects.overshootPercent);
        if (beyond == 0.0) {
            m_phase = Phase::Rest;
        } else {
            startSwing(Phase::Overshoot, shaft.position, shaft.speed, m_goal + beyond, topSpeed,
                       minOvershootTime);
        }
    }
    if (m_phase == Phase::Rest) {
        return {rest, 0.0, 0.0};
    }
    m_elapsed += seconds;
    if (m_phase == Phase::Overshoot && m_elapsed >= m_duration + overshootHoldTime) {
        startSwing(Phase::Returning, m_to, 0.0, rest, topSpeed, minReturnTime);
    } else if (m_phase == Phase::Returning && m_elapsed >= m_duration) {
        m_phase = Phase::Rest;
    }
    return swingSetpoint();
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/bent_goal.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
constexpr double outTime = 0.08;   ///< s, at least
constexpr double stayTime = 0.03;  ///< s at the farthest point
constexpr double backTime = 0.15;  ///< s, at least
constexpr double steepest = 1.875; ///< largest over mean speed of a swing from rest
constexpr double straight = 2.5;   ///< first over mean speed of one that need not turn round
} // namespace

void BentGoal::restart(double at)
{
    *this = BentGoal();
    m_goal = m_last = at;
}

void BentGoal::aimAt(double goal, double from)
{
    if (goal == m_goal) {
        return;
    }
    m_way = goal - from;
    m_goal = goal;
    m_phase = Phase::Path;
}

/// As long as it takes without going faster than `topSpeed`, or past `to`.
void BentGoal::swing(Phase phase, double from, double speed, double to, double topSpeed,
                     double shortest)
{
    const double way = to - from;
    m_phase = phase;
    m_from = from;
    m_to = to;
    m_fromSpeed = speed * way > 0.0 ? speed : 0.0;
    const double fastest = std::max({topSpeed, std::abs(m_fromSpeed), 1.0});
    m_duration = std::max(shortest, steepest * std::abs(way) / fastest);
    if (m_fromSpeed != 0.0) {
        m_duration = std::min(m_duration, straight * way / m_fromSpeed);
    }
    m_elapsed = 0;
}

/// The quintic with these ends and speeds, and without acceleration at its ends.
Aim BentGoal::swung() const
{
    const double u = m_duration > 0.0 ? m_elapsed / m_duration : 1.0;
    if (u >= 1.0) {
        return {m_to, 0.0, 0.0};
    }
    const double way = m_to - m_from;
    const double start = m_fromSpeed * m_duration;
    const double third = 10.0 * way - 6.0 * start;
    const double fourth = 8.0 * start - 15.0 * way;
    const double fifth = 6.0 * way - 3.0 * start;
    const double uu = u * u;
    return {m_from + start * u + uu * u * (third + u * (fourth + u * fifth)),
            (start + uu * (3.0 * third + u * (4.0 * fourth + u * 5.0 * fifth))) / m_duration,
            u * (6.0 * third + u * (12.0 * fourth + u * 20.0 * fifth)) / (m_duration * m_duration)};
}

Aim BentGoal::follow(const Defects& defects, const Trajectory& path, double topSpeed,
                     const Shaft& shaft, double seconds)
{
    // Whole steps on either side, so that an even reading comes out at rest.
    const double below = std::floor(0.5 * defects.restHysteresis);
    const double above = defects.restHysteresis - below;
    m_last = std::clamp(m_last, path.position - below, path.position + above);
    const double rest = m_last + defects.staticError;
    const bool arrived = path.position == m_goal && path.speed == 0.0;
    if (!arrived) {
        return {rest, 0.0, 0.0};
    }
    if (m_phase == Phase::Path) {
        const double beyond = std::round(m_way * 0.01 * defects.overshootPercent);
        if (beyond == 0.0) {
            m_phase = Phase::Rest;
        } else {
            swing(Phase::Out, shaft.position, shaft.speed, m_goal + beyond, topSpeed, outTime);
        }
    }
    if (m_phase == Phase::Rest) {
        return {rest, 0.0, 0.0};
    }
    m_elapsed += seconds;
    if (m_phase == Phase::Out && m_elapsed >= m_duration + stayTime) {
        swing(Phase::Back, m_to, 0.0, rest, topSpeed, backTime);
    } else if (m_phase == Phase::Back && m_elapsed >= m_duration) {
        m_phase = Phase::Rest;
    }
    return swung();
}
} // namespace sim

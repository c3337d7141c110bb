// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/motion_goal.h"

#include <algorithm>
#include <cmath>

namespace sim {
void MotionGoal::powerOn(double position)
{
    m_stepGoal = position;
    m_holdPosition.reset();
    m_written = false;
}

void MotionGoal::registerWritten()
{
    m_written = true;
    m_holdPosition.reset();
}

void MotionGoal::shiftCoordinate(double distance, double position)
{
    m_stepGoal += distance;
    if (m_holdPosition) {
        m_holdPosition = position;
    }
}

void MotionGoal::command(bool addsStep, double from)
{
    m_holdPosition.reset();
    if (addsStep) {
        constexpr double maxSteps = 30719;
        m_stepGoal = std::clamp(m_stepGoal + m_settings.goalPosition, -maxSteps, maxSteps);
    }
    m_timedSpeed = 0;
    if (m_settings.goalTime > 0) {
        m_timedSpeed = std::abs(position() - from) * 1000.0 / m_settings.goalTime;
    }
}

double MotionGoal::position() const
{
    if (m_holdPosition) {
        return *m_holdPosition;
    }
    if (m_settings.mode == DriveMode::Step) {
        return m_stepGoal;
    }
    if (m_settings.mode == DriveMode::Direct) {
        return std::clamp<double>(m_settings.goalPosition, 0, m_turnSteps - 1);
    }
    if (m_settings.limitsZero) {
        return m_settings.goalPosition;
    }
    return std::min(std::max(m_settings.goalPosition, m_settings.minAngle), m_settings.maxAngle);
}

double MotionGoal::speed() const
{
    if (m_settings.goalSpeed != 0) {
        return std::abs(m_settings.goalSpeed);
    }
    if (m_timedSpeed > 0.0) {
        return std::min<double>(m_timedSpeed, m_settings.maxSpeed);
    }
    return m_settings.zeroSpeedIsMaximum ? m_settings.maxSpeed : 0.0;
}
} // namespace sim

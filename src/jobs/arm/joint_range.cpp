// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/joint_range.h"

#include "jobs/arm/calibration.h"

#include <algorithm>
#include <cmath>

namespace jobs {
namespace {
using base::JointState;
using namespace std::chrono_literals;

constexpr double degreesPerTurn = 360;
constexpr double movedDegrees = 5;
constexpr double minRangeDegrees = 20;
/// A hand turns a joint by half a turn in this time, and the servo's speed need not show it.
constexpr base::Duration maxGap = 500ms;

double stepsPerDegreeOf(const device::Servo& servo)
{
    return servo.profile->stepsPerTurn / servo.profile->angleRangeDeg.value_or(degreesPerTurn);
}
} // namespace

JointRangeRecorder::JointRangeRecorder(const device::Servo& servo)
    : m_basis(device::turnBasis(servo))
    , m_stepsPerDegree(stepsPerDegreeOf(servo))
{
    m_turns.on(m_basis);
}

void JointRangeRecorder::add(std::int64_t reading, std::optional<double> degreesPerSecond,
                             base::Duration at)
{
    m_range.reading = reading;
    if (m_basis.steps == 0)
        return update(reading);
    const bool isLate = m_at && at - *m_at > maxGap;
    m_turns.reading(reading, degreesPerSecond, at);
    m_at = at;
    if (isLate || !m_turns.value()->isCertain)
        m_range.state = JointState::LostTrack;
    if (m_range.state != JointState::LostTrack)
        update(std::llround(m_turns.value()->degrees * m_basis.steps / degreesPerTurn));
}

void JointRangeRecorder::update(std::int64_t steps)
{
    const bool isFirst = m_range.state == JointState::NoReply;
    m_range.now = steps;
    m_range.low = isFirst ? steps : std::min(m_range.low, steps);
    m_range.high = isFirst ? steps : std::max(m_range.high, steps);
    const std::int64_t range = m_range.high - m_range.low;
    const double degrees = static_cast<double>(range) / m_stepsPerDegree;
    if (m_basis.steps > 0 && range + 2 * seamMargin >= m_basis.steps)
        m_range.state = JointState::FullTurn;
    else if (degrees >= minRangeDegrees)
        m_range.state = JointState::Recorded;
    else
        m_range.state = degrees >= movedDegrees ? JointState::KeepMoving : JointState::NotMoved;
}
} // namespace jobs

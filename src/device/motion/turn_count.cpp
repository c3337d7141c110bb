// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion/turn_count.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace device {
using catalog::Role;

namespace {
/// Where the servo reports no speed: none of them is faster than this (two turns a second).
constexpr double maxUnknownSpeed = 720;
constexpr double degreesPerTurn = 360;
} // namespace

TurnBasis turnBasis(const Servo& servo)
{
    TurnBasis basis;
    if (!servo.profile || !servo.profile->multiTurn)
        return basis;
    const catalog::Mode* mode = servo.mode();
    if (mode == nullptr || mode->key == QLatin1StringView("step"))
        return basis; // there the register holds the remaining distance
    basis.steps = servo.profile->stepsPerTurn;
    basis.countsTurns = (servo.raw(Role::Phase).value_or(0) & fullAnglePhaseBit) != 0;
    basis.mode = mode->key;
    basis.offset = servo.raw(Role::PositionOffset).value_or(0);
    return basis;
}

void TurnCounter::on(const TurnBasis& basis)
{
    if (basis == m_basis)
        return;
    // The mode that turns the shaft (speed, PWM, position) does not change the encoder's reading.
    const bool sameReading = basis.steps == m_basis.steps && basis.offset == m_basis.offset &&
                             basis.countsTurns == m_basis.countsTurns;
    m_basis = basis;
    if (!sameReading)
        reset();
}

void TurnCounter::reset()
{
    m_value.reset();
}

/// False when the shaft may have turned by half a turn or more between the two readings.
bool TurnCounter::isUnambiguous(std::int64_t moved, std::optional<double> speed,
                                base::Duration gap) const
{
    const double seconds = std::chrono::duration<double>(gap).count();
    if (seconds <= 0)
        return true;
    const double measured =
        degreesPerTurn * static_cast<double>(std::abs(moved)) / m_basis.steps / seconds;
    const double reported = speed ? std::max(std::abs(*speed), std::abs(m_speed)) : maxUnknownSpeed;
    return std::max(measured, reported) * seconds <= degreesPerTurn / 2;
}

void TurnCounter::reading(std::int64_t raw, std::optional<double> degreesPerSecond,
                          base::Duration at)
{
    const std::int64_t steps = m_basis.steps;
    if (steps <= 0)
        return;
    // A servo that shows more than one turn counts them, even if its known settings differ.
    const bool absolute = m_basis.countsTurns || raw < 0 || raw >= steps;
    bool isCertain = true;
    if (absolute || !m_value) {
        m_total = raw;
    } else {
        std::int64_t moved = raw - m_raw;
        if (moved > steps / 2)
            moved -= steps;
        else if (moved < -steps / 2)
            moved += steps;
        m_total += moved;
        isCertain = m_value->isCertain && isUnambiguous(moved, degreesPerSecond, at - m_at);
    }
    m_raw = raw;
    m_at = at;
    m_speed = degreesPerSecond.value_or(0);
    const double turns = static_cast<double>(m_total) / static_cast<double>(steps);
    m_value =
        Turns{static_cast<int>(std::floor(turns)), turns * degreesPerTurn, absolute, isCertain};
}
} // namespace device

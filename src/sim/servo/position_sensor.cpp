// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/position_sensor.h"

#include "sim/servo/controller.h"

#include <cmath>

namespace sim {
PositionSensor::PositionSensor(const ServoTraits& traits, const Settings& settings,
                               std::uint64_t seed)
    : m_settings(settings)
    , m_encoder(traits, seed)
    , m_turnSteps(traits.turnSteps)
    , m_stepsPerRadian(traits.stepsPerRadian)
{}

void PositionSensor::powerOn(double angle, std::uint64_t tick)
{
    m_encoder.reset(angle);
    m_count = m_encoder.sample(angle, tick);
    stop();
}

void PositionSensor::measure(double angle, std::uint64_t tick)
{
    constexpr double speedShare = 0.2;           // smoothing over 5 ms
    constexpr double reportedShare = 1.0 / 15.0; // and 15 ms more for the register
    const std::int64_t before = m_count;
    m_count = m_encoder.sample(angle, tick);
    const double direction = m_settings.reversed ? -1.0 : 1.0;
    m_speed += (direction * double(m_count - before) / Controller::tick - m_speed) * speedShare;
    m_reportedSpeed += (m_speed - m_reportedSpeed) * reportedShare;
    m_position = read();
}

double PositionSensor::resetTurns()
{
    const double before = read();
    if (isContinuous()) {
        const auto turn = double(m_turnSteps);
        m_turnBase += std::int64_t(std::floor(before / turn) * turn);
    }
    m_position = read();
    return m_position - before;
}

bool PositionSensor::isStill() const
{
    return std::abs(m_reportedSpeed) < speedResolution;
}

std::int64_t PositionSensor::directedCount() const
{
    return m_settings.reversed ? m_turnSteps - 1 - m_count : m_count;
}

double PositionSensor::read() const
{
    if (!isContinuous()) {
        return m_encoder.withinTurn(m_count) - m_settings.offset;
    }
    return double(directedCount() - m_settings.offset - m_turnBase);
}

Shaft PositionSensor::shaft(double radiansPerSecond) const
{
    return {m_position + sign() * (m_encoder.unrounded() - double(m_count)),
            sign() * radiansPerSecond * m_stepsPerRadian};
}

int PositionSensor::offsetFor(int wanted) const
{
    const auto turn = std::int64_t(m_turnSteps);
    const std::int64_t uncorrected = directedCount() - wanted;
    const std::int64_t offset = ((uncorrected % turn) + turn) % turn;
    return int(offset >= turn / 2 ? offset - turn : offset);
}

double PositionSensor::noise(double deviation, std::uint64_t tick) const
{
    return deviation == 0.0 ? 0.0 : std::round(deviation * m_encoder.gaussianNoise(tick));
}
} // namespace sim

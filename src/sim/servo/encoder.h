// SPDX-License-Identifier: GPL-3.0-or-later
// The position sensor on the output shaft: a little slow, a little noisy, whole steps. Magnetic
// sensors turn endlessly through 4096 steps; the SCS potentiometer has 1024 steps over its range
// and a dead sector behind it, where it reads its nearer end; LX reads on below 0 and above 1000
// until the turn is full. Owned by one servo; its thread. Noise is a function of the instant alone,
// so that a reading does not depend on how many were taken before.
#pragma once

#include "sim/servo/servo_traits.h"

namespace sim {
class Encoder {
public:
    Encoder(const ServoTraits& traits, std::uint64_t seed);

    /// Steps since the sensor's zero, counted through all turns.
    std::int64_t sample(double angle, std::uint64_t tick);
    void reset(double angle) { m_filtered = angle; } ///< the shaft has rested for a while

    /// The latest sample before it was rounded, without noise.
    double unrounded() const { return m_filtered * m_stepsPerRadian; }

    /// What a sensor without a turn count shows for a counted position.
    int withinTurn(std::int64_t encoderCount) const;
    /// Normally distributed with a deviation of 1.
    double gaussianNoise(std::uint64_t tick) const;
    bool isContinuous() const { return m_sensor == Sensor::Continuous; }

private:
    double m_stepsPerRadian;
    Sensor m_sensor;
    std::uint64_t m_seed;
    double m_filtered = 0;
};
} // namespace sim

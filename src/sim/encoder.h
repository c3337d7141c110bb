// SPDX-License-Identifier: GPL-3.0-or-later
// The position sensor on the output shaft: a little slow, a little noisy, whole steps. STS and SMS
// turn endlessly through 4096 steps; the SCS potentiometer has 1024 steps over its range and a dead
// sector behind it, where it reads its nearer end. Owned by one servo; its thread. Noise is a
// function of the instant alone, so that a reading does not depend on how often others were taken.
#pragma once

#include <cstdint>

namespace sim {
class Encoder {
public:
    Encoder(double stepsPerRadian, bool endless, std::uint64_t seed);

    /// Steps since the sensor's zero, counted through all turns.
    std::int64_t sample(double angle, std::uint64_t tick);
    void settle(double angle) { m_filtered = angle; } ///< the shaft has rested for a while

    /// What a potentiometer shows for a counted position.
    int potentiometer(std::int64_t counted) const;
    bool endless() const { return m_endless; }
    double stepsPerRadian() const { return m_stepsPerRadian; }

private:
    double m_stepsPerRadian;
    bool m_endless;
    std::uint64_t m_seed;
    double m_filtered = 0;
};
} // namespace sim

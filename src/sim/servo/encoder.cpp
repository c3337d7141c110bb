// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/encoder.h"

#include <cmath>
#include <numbers>

namespace sim {
namespace {
constexpr double filterShare = 1.0 / 3.0; ///< of the way to the true angle in one millisecond
constexpr double noiseSteps = 0.4;        ///< largest deviation

struct RandomPair {
    double low;
    double high; ///< 0 up to, not including, 1
};

/// Two numbers that are evenly distributed (splitmix64 of the instant).
RandomPair randomPair(std::uint64_t seed, std::uint64_t tick)
{
    std::uint64_t z = seed + tick * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    z ^= z >> 31;
    return {double(std::uint32_t(z)) / 4294967296.0, double(std::uint32_t(z >> 32)) / 4294967296.0};
}

/// Triangular, −1…1.
double noise(std::uint64_t seed, std::uint64_t tick)
{
    const RandomPair random = randomPair(seed, tick);
    return random.low - random.high;
}
} // namespace

Encoder::Encoder(const ServoTraits& traits, std::uint64_t seed)
    : m_stepsPerRadian(traits.stepsPerRadian)
    , m_sensor(traits.sensor)
    , m_seed(seed * 0xD1342543DE82EF95U)
{}

std::int64_t Encoder::sample(double angle, std::uint64_t tick)
{
    m_filtered += (angle - m_filtered) * filterShare;
    return std::int64_t(
        std::floor(m_filtered * m_stepsPerRadian + noiseSteps * noise(m_seed, tick) + 0.5));
}

double Encoder::gaussianNoise(std::uint64_t tick) const
{
    constexpr std::uint64_t noiseSeed = 0xA0761D6478BD642FU; // independent of the noise of sample()
    const RandomPair random = randomPair(m_seed ^ noiseSeed, tick);
    return std::sqrt(-2.0 * std::log(1.0 - random.low)) *
           std::cos(2.0 * std::numbers::pi * random.high);
}

int Encoder::withinTurn(std::int64_t encoderCount) const
{
    const double turn = 2.0 * std::numbers::pi * m_stepsPerRadian;
    if (m_sensor == Sensor::OneTurn) {
        // The seam lies opposite the middle of the range.
        constexpr int range = 1000;
        const double below = 0.5 * (turn - range);
        const double from = double(encoderCount) + below;
        return int(std::lround(from - turn * std::floor(from / turn) - below));
    }
    constexpr int last = 1023;
    const double steps = double(encoderCount) - turn * std::floor(double(encoderCount) / turn);
    if (steps <= last) {
        return int(steps);
    }
    return steps < 0.5 * (last + turn) ? last : 0;
}
} // namespace sim

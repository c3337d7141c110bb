// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers from a seed: the same with each compiler, unlike the distributions of the standard
// library. A plain value of one thread.
#pragma once

#include <cstdint>
#include <random>

namespace sim {
class SeededRandom {
public:
    SeededRandom() = default;
    explicit SeededRandom(std::uint64_t seed)
        : m_generator(seed)
    {}

    /// From 0 to 1.
    double fraction() { return double(m_generator() >> 11) / double(std::uint64_t(1) << 53); }
    /// From -most to most.
    double within(double most) { return most * (2 * fraction() - 1); }

private:
    std::mt19937_64 m_generator;
};
} // namespace sim

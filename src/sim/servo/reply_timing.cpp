// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/reply_timing.h"

namespace sim {
namespace {
using namespace std::chrono_literals;

constexpr double maxClockError = 0.008;
constexpr std::chrono::nanoseconds maxTurnAround = 20us;
constexpr std::chrono::nanoseconds maxJitter = 8us;

/// The same with each compiler, unlike the distributions of the standard library.
double fraction(std::mt19937_64& random)
{
    return double(random() >> 11) / double(std::uint64_t(1) << 53);
}

std::chrono::nanoseconds part(std::chrono::nanoseconds most, std::mt19937_64& random)
{
    return std::chrono::nanoseconds(std::int64_t(double(most.count()) * fraction(random)));
}
} // namespace

ReplyTiming::ReplyTiming(std::uint64_t seed)
    : m_random(seed)
    , m_clockError(maxClockError * (2 * fraction(m_random) - 1))
    , m_turnAround(part(maxTurnAround, m_random))
    , m_jitter(maxJitter)
{}

std::chrono::nanoseconds ReplyTiming::nextTurnAround()
{
    return m_turnAround + part(m_jitter, m_random);
}
} // namespace sim

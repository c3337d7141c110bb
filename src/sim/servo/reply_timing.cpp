// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/reply_timing.h"

namespace sim {
namespace {
using namespace std::chrono_literals;

constexpr double maxClockError = 0.008;
constexpr std::chrono::nanoseconds maxTurnAround = 20us;
constexpr std::chrono::nanoseconds maxJitter = 8us;

std::chrono::nanoseconds part(std::chrono::nanoseconds most, SeededRandom& random)
{
    return std::chrono::nanoseconds(std::int64_t(double(most.count()) * random.fraction()));
}
} // namespace

ReplyTiming::ReplyTiming(std::uint64_t seed)
    : m_random(seed)
    , m_clockError(m_random.within(maxClockError))
    , m_turnAround(part(maxTurnAround, m_random))
    , m_jitter(maxJitter)
{}

std::chrono::nanoseconds ReplyTiming::nextTurnAround()
{
    return m_turnAround + part(m_jitter, m_random);
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// When a simulated servo begins its reply and at which exact rate it sends: what makes the replies
// of two servos of one model collide, as they do on a real line. No sheet states the figures;
// chosen: those of a microcontroller without a crystal. Owned by a VirtualServo; one thread.
#pragma once

#include "sim/servo/seeded_random.h"

#include <chrono>

namespace sim {
class ReplyTiming {
public:
    ReplyTiming() = default; ///< exact
    explicit ReplyTiming(std::uint64_t seed);

    /// Of the rate it sends at, as a fraction.
    double clockError() const { return m_clockError; }
    /// How much later than the reply delay says its next reply begins.
    std::chrono::nanoseconds nextTurnAround();

private:
    SeededRandom m_random;
    double m_clockError = 0;
    std::chrono::nanoseconds m_turnAround{};
    std::chrono::nanoseconds m_jitter{};
};
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// How far a joint has been moved, from readings of its servo that show one turn only: the encoder's
// seam may lie anywhere in the range. A missed reading after which the number of turns is open
// begins the range anew; nothing is guessed. A value fed by one thread; times of the bus clock.
#pragma once

#include "base/arm.h"
#include "device/motion/turn_count.h"

namespace jobs {
/// Steps of the servo, counted through the seam; comparable with each other only.
struct JointRange {
    base::JointState state = base::JointState::NoReply;
    std::int64_t low = 0;
    std::int64_t high = 0;
    std::int64_t now = 0;
    std::int64_t shown = 0; ///< the latest reading, as the servo reports it
};

class JointRangeRecorder {
public:
    /// Its settings have been read.
    explicit JointRangeRecorder(const device::Servo& servo);

    /// As the servo reports them; the speed where it does.
    void add(double degrees, std::optional<double> degreesPerSecond, base::Duration at);
    const JointRange& range() const { return m_range; }

private:
    void update(std::int64_t steps);

    device::TurnBasis m_basis;
    double m_stepsPerDegree;
    device::TurnCounter m_turns;
    JointRange m_range;
    std::optional<base::Duration> m_at{}; ///< of the latest reading
    bool m_hasLostTrack = false;
};
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// How far a joint has been moved, from readings of its servo that show one turn only: the encoder's
// seam may lie anywhere in the range. Once readings were missing while the joint may have turned by
// half a turn, its range is not known any more. A value fed by one thread; times of the bus clock.
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
    std::int64_t reading = 0; ///< the latest one, as the servo reports it
};

class JointRangeRecorder {
public:
    /// Its settings have been read.
    explicit JointRangeRecorder(const device::Servo& servo);

    /// In steps, as the servo reports it; the speed where it does.
    void add(std::int64_t reading, std::optional<double> degreesPerSecond, base::Duration at);
    const JointRange& range() const { return m_range; }

private:
    void update(std::int64_t steps);

    device::TurnBasis m_basis;
    double m_stepsPerDegree;
    device::TurnCounter m_turns;
    JointRange m_range;
    std::optional<base::Duration> m_at{}; ///< of the latest reading
};
} // namespace jobs

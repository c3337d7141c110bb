// SPDX-License-Identifier: GPL-3.0-or-later
// The path from where the servo is to its goal: a trapezoid of speed under the speed and
// acceleration registers. Plain value in steps and seconds; its servo's thread.
#pragma once

#include <algorithm>
#include <cmath>

namespace sim {
struct Trajectory {
    double position = 0;
    double speed = 0;

    void restart(double at)
    {
        position = at;
        speed = 0;
    }

    /// acceleration 0: the speed changes at once.
    void advance(double goal, double topSpeed, double acceleration, double seconds)
    {
        const double distance = goal - position;
        if (distance == 0.0 && speed == 0.0) {
            return;
        }
        const double change = acceleration > 0.0 ? acceleration * seconds : HUGE_VAL;
        // The speed from which the brakes still stop at the goal, counted in whole steps of time.
        const double brake =
            acceleration > 0.0
                ? std::sqrt(0.25 * change * change + 2.0 * acceleration * std::abs(distance)) -
                      0.5 * change
                : topSpeed;
        const double targetSpeed = std::copysign(std::min(topSpeed, brake), distance);
        speed += std::clamp(targetSpeed - speed, -change, change);
        const double travel = speed * seconds;
        if (travel * distance >= 0.0 && std::abs(travel) >= std::abs(distance) &&
            std::abs(speed) <= change) {
            restart(goal);
            return;
        }
        position += travel;
    }
};
} // namespace sim

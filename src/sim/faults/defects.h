// SPDX-License-Identifier: GPL-3.0-or-later
// What may be wrong with a simulated servo, as numbers that a test of servos should find again. The
// defaults are a healthy servo, which behaves as if this did not exist. Plain value. Steps are
// those of its sensor; "reported" is what the position register shows.
#pragma once

#include <optional>

namespace sim {
struct Defects {
    /// Rest error that depends on where it came from: the loop stops short of its goal by half of
    /// this on either side, as dry friction makes a loop without I do, and reports it. Reported
    /// position coming from above minus that from below = this, for moves longer than it; a move
    /// back by less than this does not move the shaft at all. (Play behind the sensor is
    /// ServoConfig::gearPlayDegrees, and play before it is hidden by the loop.)
    double restHysteresis = 0; ///< steps

    /// Rests this far beside its goal under any load, and reports it: a constant pull.
    double staticError = 0; ///< steps, signed as the position is

    /// Badly damped: after a move of W steps it goes W·this/100 (whole steps) beyond its goal,
    /// stays there for 30 ms and comes back within some 150 ms, or as fast as the speed of the move
    /// allows. W is the way from the goal it was at (or from where it was on its way there) to the
    /// new one.
    double overshootPercent = 0;

    /// Worn motor: the top speed it reaches is the model's times this; a slower goal speed is
    /// kept. Position, step and speed mode.
    double speedFactor = 1;
    /// … and less by this much for each share of its stall torque that the load sets against it:
    /// 1 loses 20 % of the speed against a load of 20 % of the stall torque.
    double speedPerLoad = 0;

    /// Standard deviation of the position register beyond the sensor's own noise; the servo's loop
    /// has filtered it out.
    double positionNoise = 0; ///< steps

    /// Its firmware is not whole, as after an update that was cut off: it stays in its bootloader.
    bool firmwareLost = false;

    std::optional<bool> movingFlagStuck; ///< the moving flag reads this, whatever it does

    /// It does not rest where a healthy loop would. Then load, friction, gear play and dead zones
    /// of the registers add nothing of their own to where it rests (P = 0 still switches the loop
    /// off, and I does not act).
    bool affectsPosition() const
    {
        return restHysteresis != 0.0 || staticError != 0.0 || overshootPercent != 0.0;
    }
    bool operator==(const Defects&) const = default;
};
} // namespace sim

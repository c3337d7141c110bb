// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to set in a move of this servo in its present mode, and how far: for sliders, input
// fields and their hints. Pure functions on what has been read; raw values unless they say
// otherwise. Nothing here replaces the checks of planMove.
#pragma once

#include "device/motion/motion.h"
#include "device/write_check.h"

namespace device {
enum class GoalKind : std::uint8_t {
    Position, ///< inside the angle limits
    Turns,    ///< multi-turn
    Step,     ///< relative
    Speed,    ///< signed; turns until it is told to stop
    Pwm,      ///< signed
    Current,  ///< signed
};

/// Nullopt: the mode is not known, or nothing drives it.
std::optional<GoalKind> goalKind(const Servo& servo);
const catalog::Register* goalRegister(const Servo& servo);

/// The fields beside the goal that this family has and this mode obeys.
struct MoveFieldSet {
    bool speed = false;
    bool acceleration = false;
    bool time = false;    ///< ms
    bool current = false; ///< the limit of a move
    bool operator==(const MoveFieldSet&) const = default;
};
MoveFieldSet moveFields(const Servo& servo);

/// The reach of a goal slider: the servo's own limits, ±7.5 turns (times the resolution factor,
/// which the raw goal counts in already), ± the model's maximum speed where it is known.
std::optional<GoalRange> goalSliderRange(const Servo& servo);
/// The whole scale those limits lie in: one turn, or the sensor's range. As goalSliderRange where
/// there are no limits.
std::optional<GoalRange> goalScaleRange(const Servo& servo);

/// Steps of a relative move that may still be made in this direction, when `sum` have been made.
std::int64_t remainingSteps(std::int64_t sum, bool positive);

/// The speed above which the model turns no faster, as a raw goal speed. Nullopt: not known.
std::optional<std::int64_t> maxGoalSpeed(const Servo& servo);

/// What goal speed 0 means in a position mode.
enum class ZeroSpeed : std::uint8_t { Unknown, Stops, Fastest, ByTime };
ZeroSpeed zeroSpeed(const Servo& servo);

/// Which way a positive value of the goal turns the output, seen from its side, as the tutorial and
/// the sheets say it for factory directions. Forward: the sheet names no sense of rotation.
enum class PositiveDirection : std::uint8_t { Clockwise, CounterClockwise, Forward };
PositiveDirection positiveDirection(const Servo& servo);

/// Where the torque limit is set: RAM, or an EPROM row that is then written temporarily. Null: the
/// family has none.
struct TorqueLimit {
    const catalog::Register* reg = nullptr;
    bool temporary = false;
};
TorqueLimit torqueLimit(const catalog::Profile& profile);

/// Whether this family can share a packet, or hold a goal for later; in its present mode.
bool supports(const Servo& servo, MoveMethod how);

/// The physical value with all its digits and its unit, so that the same register parses to the
/// same raw number, and another servo's register to the nearest one. A bare number without unit.
QString exactValueText(std::int64_t raw, const catalog::ValueFormat& meaning);
} // namespace device

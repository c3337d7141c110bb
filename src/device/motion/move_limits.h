// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a move of this servo in its present mode, and their ranges: for sliders, input
// fields and their hints. Pure functions on the values read so far; raw values unless stated
// otherwise. Nothing here replaces the checks of planMove.
#pragma once

#include "device/motion/motion.h"
#include "device/write_check.h"

namespace device {
enum class GoalKind : std::uint8_t {
    Position, ///< inside the angle limits
    Turns,    ///< multi-turn
    Step,     ///< relative
    Speed,    ///< signed; turns until it gets a stop command
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

/// The range of a goal slider: the servo's own limits, ±7.5 turns (in raw goals, which include the
/// resolution factor), ± the model's maximum speed where it is known.
std::optional<GoalRange> goalSliderRange(const Servo& servo);
/// The whole scale around those limits: one turn, or the sensor's range. The same as
/// goalSliderRange where there are no limits.
std::optional<GoalRange> goalScaleRange(const Servo& servo);

/// Steps that a relative move may still make in this direction, after `sum` steps.
std::int64_t remainingSteps(std::int64_t sum, bool positive);

/// The speed above which the model turns no faster, as a raw goal speed. Nullopt: not known.
std::optional<std::int64_t> maxGoalSpeed(const Servo& servo);

/// What goal speed 0 means in a position mode.
enum class ZeroSpeed : std::uint8_t { Unknown, Stops, Fastest, ByTime };
ZeroSpeed zeroSpeed(const Servo& servo);

/// The direction in which a positive goal turns the output, seen from its side, as the tutorial and
/// the sheets state it for factory settings. Forward: the sheet names no sense of rotation.
enum class PositiveDirection : std::uint8_t { Clockwise, CounterClockwise, Forward };
PositiveDirection positiveDirection(const Servo& servo);

/// The register of the torque limit: in RAM, or in the EPROM and then written temporarily. Null:
/// the family has none.
struct TorqueLimit {
    const catalog::Register* reg = nullptr;
    bool temporary = false;
};
TorqueLimit torqueLimit(const catalog::Profile& profile);

/// Whether this servo can share a packet, or hold a goal for later, in its present mode.
bool supports(const Servo& servo, MoveMethod how);

/// The physical value with all its digits and its unit, so that the same register parses to the
/// same raw number, and another servo's register to the nearest one. A bare number without unit.
QString exactValueText(std::int64_t raw, const catalog::ValueFormat& meaning);
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the control panel: physical values beside raw ones, the direction in which a goal
// turns, what a speed of 0 means, what a mode switch does, notices, and why a servo cannot be
// controlled. Pure functions, in the language of the interface; main thread.
#pragma once

#include "device/motion/motion.h"
#include "device/motion/move_limits.h"
#include "session/servos/servo_entry.h"

#include <QString>

namespace ui {
/// "180.0°", "22.0 rpm · 132 °/s", "20.0 %"; empty where the unit is not known.
QString physicalValueText(std::int64_t raw, const catalog::Register& reg,
                          const catalog::ValueFormat& meaning);

/// "↻", "↺", or "+" and "−" where no sheet names the sense of rotation.
QString turnSymbol(device::PositiveDirection positive, bool plus);
/// "clockwise", "counter-clockwise", "forward", "in reverse".
QString turnText(device::PositiveDirection positive, bool plus);

/// What goal speed 0 does, and where the model's own maximum lies. Empty: nothing is known.
QString speedHint(const device::Servo& servo, std::optional<std::int64_t> speed);
/// The speed is above the model's own maximum.
bool isAboveMaxSpeed(const device::Servo& servo, std::optional<std::int64_t> speed);

/// "Position", for a button.
QString modeTitle(const catalog::Mode& mode);
/// What the mode does, for the button's tooltip.
QString modeHelp(const QString& key);
/// What the switch will do, one sentence a line. `others`: servos that get the same.
QString modePlanText(const device::ModePlan& plan, const catalog::Profile& profile, int others);

/// Why this servo cannot be controlled; empty: it can be. nullptr: no servo is selected.
QString controlObstacle(const session::ServoEntry* entry);

enum class NoticeKind : std::uint8_t {
    Warning, ///< an alarm, or something the user must act on
    Result   ///< how the action was carried out
};
/// The notices of this kind, one a line. Registers are called by their names in the profile, which
/// may be null.
QString noticeLines(const device::Notices& notices, const catalog::ProfilePtr& profile,
                    NoticeKind kind);
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the control panel: physical values beside raw ones, which way a goal turns, what a
// speed of 0 means, what a mode switch will do. Pure functions, in the language of the interface;
// main thread.
#pragma once

#include "device/motion/motion.h"
#include "device/motion/move_limits.h"

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

/// "Position", as a button says it.
QString modeTitle(const catalog::Mode& mode);
/// What the mode does, for the button's tooltip.
QString modeHelp(const QString& key);
/// What the switch will do, one sentence a line. `others`: servos that get the same.
QString modePlanText(const device::ModePlan& plan, const catalog::Profile& profile, int others);
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a mode switch around its register writes: saving the values for the way back, and
// setting the new mode's command to zero while torque is off. Internal to device; used by write(),
// so that editing 33, 9 or 11 by hand is guarded in the same way.
#pragma once

#include "device/write_check.h"

namespace device {
/// Set when the items select another mode than the servo has now.
struct ModeChange {
    const catalog::Mode* from = nullptr;
    const catalog::Mode* to = nullptr;
};
std::optional<ModeChange> modeChange(const Servo& servo, const RegisterValues& items);

/// True when the mode and this command are written in one frame (LX motor speed): the command then
/// has no meaning in other modes.
bool sharesFrameWithMode(const catalog::Profile& profile, catalog::Role command);

/// In that case, the frame that switches the mode carries the command 0. NotSupported
/// ("mode-first") when the items give another one.
base::Result<void> addZeroCommand(const Servo& servo, RegisterValues& items);

/// Before the write, for the way back to a position mode, both in the journal: the angle limits
/// where the items remove them, and the position speed.
base::Result<void> saveLimits(const Context& context, const Servo& servo,
                              const RegisterValues& items);
base::Result<void> savePositionSpeed(const Context& context, const Servo& servo,
                                     const ModeChange& change);

/// After the write, torque off: zeroes the new mode's command, restores the position speed and the
/// current limit, and makes sure that torque is still off.
base::Result<void> finishModeSwitch(const Context& context, Servo& servo, const ModeChange& change);

/// The command that a switch leaves at 0, or None.
catalog::Role commandZeroedBySwitch(const Servo& servo, const ModeChange& change);

/// The name under which the journal keeps the angle limits for the way back.
QString savedLimitsName();

/// Torque off, proven. Notes it when torque was on.
base::Result<void> torqueOff(const Context& context, Servo& servo);

/// HLS: a current limit of 0 means no torque at all. Notes it, in modes that have the limit.
void noteZeroCurrentLimit(const Context& context, const Servo& servo);
} // namespace device

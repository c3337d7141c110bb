// SPDX-License-Identifier: GPL-3.0-or-later
// The speed that position modes had before the servo was switched away from them. The journal keeps
// it, and a switch back restores it: a position mode with speed 0 may not move at all (phase bit
// 3). The job's thread. Errors: those of the journal, of reading and of writing.
#pragma once

#include "device/motion/mode.h"

namespace device {
/// The name under which the journal keeps it.
QString savedSpeedName();

/// Nullopt: none is kept, or the speed is no register of its own here.
base::Result<std::optional<std::int64_t>> savedSpeed(const base::Journal& journal,
                                                     const Servo& servo);

/// What write() also restores where these items select a position mode. Based on the values read so
/// far.
std::optional<WriteItem> restoredSpeed(const Servo& servo, const std::vector<WriteItem>& items,
                                       std::optional<std::int64_t> remembered);

/// In a position mode, after one that had the command `before`.
base::Result<void> restoreSpeed(const Context& context, Servo& servo, catalog::Role before);
} // namespace device

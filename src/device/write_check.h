// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be known to be wrong with a write before its first byte. Internal to device;
// pure functions on what has been read.
#pragma once

#include "device/transactions.h"
#include "device/writer.h"

namespace device {
/// Key, access, consent, what this family cannot do, and the registers that have a manoeuvre of
/// their own (ID, rate, torque on, calibration, unlocking). Needs nothing read. In writing order.
base::Result<RegisterValues> checkItems(const Servo& servo, const std::vector<WriteItem>& items,
                                        const WriteOptions& options);

/// Ranges and the pairs that belong together, against what has just been read.
/// `allowPreviousValues`: see WriteOptions.
base::Result<void> checkValues(const Context& context, const Servo& servo,
                               const RegisterValues& items, bool allowPreviousValues = false);

/// The value a role will have after the write.
std::optional<std::int64_t> valueAfter(const Servo& servo, const RegisterValues& items,
                                       catalog::Role role);

/// Step mode: the goal says how far, not where to.
bool isRelative(const catalog::Mode& mode);

/// Minimum and maximum of a goal in its raw unit, as the servo's own limits allow; nullopt: free.
struct GoalRange {
    std::int64_t min = 0;
    std::int64_t max = 0;
};
std::optional<GoalRange> goalRange(const Servo& servo);
} // namespace device

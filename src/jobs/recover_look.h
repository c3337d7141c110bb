// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the servo of an interrupted write and compares it with the journal. Reads only. Internal to
// jobs.
#pragma once

#include "jobs/recover.h"

namespace jobs {
/// Items whose value after the write is not known beforehand (calibration, restore) carry the old
/// value twice.
bool newValuesKnown(const base::Intent& intent);

/// Whichever way it is settled, the old values are wanted.
bool onlyBack(const base::Intent& intent);

/// As many of a servo's past writes are looked through for what it held.
constexpr int entriesLookedAt = 1000;

/// What recovery brings to one side or the other: registers that survive a power-off, and a mode
/// that a test has set, though it may be forgotten then (LX).
bool concernsRecovery(const base::Intent& intent, const catalog::Register& reg);

/// Leaves the bus at the rate where the servo was found, else at the rate it had. `servo` is filled
/// in unless nobody answered. LinkLost ends it.
base::Result<OpenIntent> look(const device::Context& context, const base::Intent& intent,
                              device::Servo& servo);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the servo of an interrupted write and compares it with the journal. Reads only. Internal to
// jobs.
#pragma once

#include "jobs/recover/recover.h"

namespace jobs {
/// Items whose value after the write is not known beforehand (calibration, restore) carry the old
/// value twice.
bool hasKnownNewValues(const base::Intent& intent);

/// Whichever way it is settled, the old values are wanted.
bool isRevertOnly(const base::Intent& intent);

/// As many of a servo's past writes are looked through for what it held.
constexpr int maxJournalEntries = 1000;

/// A value that is neither the old nor the new one is another servo's: of registers that survive a
/// power-off, and of the mode, though it may be forgotten then (LX). Any other register may hold
/// what a restart has loaded.
bool identifiesServo(const catalog::Register& reg);

/// What recovery may write by itself: nothing that would turn the shaft, switch torque on or open
/// the lock. `servo`: with its settings read.
bool isRecoverable(const base::Intent& intent, const device::Servo& servo,
                   const catalog::Register& reg);

bool changesMode(const base::Intent& intent, const device::Servo& servo);

/// A command that goes with a switch of the mode: it ends at zero, whichever way that is settled.
bool isZeroedByModeSwitch(const base::Intent& intent, const device::Servo& servo,
                          const catalog::Register& reg);

/// Leaves the bus at the rate where the servo was found, else at the rate it had. `servo` is filled
/// in unless nobody answered. LinkLost ends it.
base::Result<OpenIntent> previewIntent(const device::Context& context, const base::Intent& intent,
                                       device::Servo& servo);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the servo of an interrupted write and compares it with the journal. Reads only. Internal to
// jobs.
#pragma once

#include "jobs/recover/recover.h"

namespace jobs {
/// Items whose new value is not known beforehand (calibration, restore) hold the old value twice.
bool hasKnownNewValues(const base::Intent& intent);

/// Both finishing and undoing restore the old values.
bool isRevertOnly(const base::Intent& intent);

/// How many past writes of a servo are searched for its earlier values.
constexpr int maxJournalEntries = 1000;

/// For these registers a value that is neither the old nor the new one means another servo: those
/// that survive a power-off, and the mode, although LX loses it. Any other register may hold a
/// value that a restart has loaded.
bool identifiesServo(const catalog::Register& reg);

/// Whether recovery may write the register by itself: never if that would turn the shaft, turn
/// torque on or open the lock. `servo`: with its settings read.
bool isRecoverable(const base::Intent& intent, const device::Servo& servo,
                   const catalog::Register& reg);

bool changesMode(const base::Intent& intent, const device::Servo& servo);

/// A command that belongs to a mode switch: it ends at zero, whether that is finished or undone.
bool isZeroedByModeSwitch(const base::Intent& intent, const device::Servo& servo,
                          const catalog::Register& reg);

/// Leaves the bus at the rate where the servo was found, otherwise at its earlier rate. `servo` is
/// filled in unless no servo answered. LinkLost ends it.
base::Result<OpenIntent> previewIntent(const device::Context& context, const base::Intent& intent,
                                       device::Servo& servo);
} // namespace jobs

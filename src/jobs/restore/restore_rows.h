// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a restore plan at a time: what a register is, and what the file's value is in this
// servo's numbers. Internal to jobs; pure; any thread.
#pragma once

#include "jobs/restore/restore_plan.h"

namespace jobs {
/// The reasons that lie in the register itself, whatever its values are.
RestoreReasons registerReasons(const catalog::Register& reg);

/// A limit of voltage, temperature, current or torque, which belongs to a model.
bool isProtectionLimit(const catalog::Register& reg);

/// Fills in `alarm` where the servo's readings lie outside the limit that the row would set, and
/// not outside the one it has.
void predictAlarm(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg);

/// When it is written.
RestoreStage stageOf(const catalog::Register& reg);

/// How near the file's servo is to this one.
struct Compatibility {
    bool sameMap = false;
    bool isSameKind = false; ///< map, model and firmware: raw numbers mean the same for certain
    bool otherModel = false;
    int fileBaud = 0;
};
Compatibility compatibilityOf(const device::Servo& servo, const record::Snapshot& snapshot);

/// Fills in `wanted` and says why it is empty or not the file's own number.
void mapValue(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg,
              const record::SnapshotRegister& file, const Compatibility& compatibility);
} // namespace jobs

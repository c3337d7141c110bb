// SPDX-License-Identifier: GPL-3.0-or-later
// Single rows of a restore plan: the properties of a register, and the file's value in this servo's
// raw numbers. Internal to jobs; pure; any thread.
#pragma once

#include "jobs/restore/restore_plan.h"

namespace jobs {
/// The reasons that come from the register itself, for any value.
RestoreReasons registerReasons(const catalog::Register& reg);

/// A limit of voltage, temperature, current or torque, which belongs to a model.
bool isProtectionLimit(const catalog::Register& reg);

/// Fills in `alarm` where the servo's readings are outside the limit that the row would set, and
/// inside the present one.
void predictAlarm(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg);

/// The stage in which it is written.
RestoreStage stageOf(const catalog::Register& reg);

/// How far the file's servo and this one are alike.
struct Compatibility {
    bool sameMap = false;
    bool isSameKind = false; ///< map, model and firmware: raw numbers mean the same for certain
    bool otherModel = false;
    int fileBaud = 0;
};
Compatibility compatibilityOf(const device::Servo& servo, const snapshot::Snapshot& snapshot);

/// Fills in `newRaw`, and the reason if it is empty or not the file's own number.
void mapValue(RestoreRow& row, const device::Servo& servo, const catalog::Register& reg,
              const snapshot::SnapshotRegister& file, const Compatibility& compatibility);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// From a joint's recorded range to its registers, and back: the offset that puts the middle of the
// range in the middle of the turn, and the position limits. writeJoints() writes the
// templates. Pure; any thread. Errors: NotSupported with the servo's ID and a reason:
// "joint-not-recorded", "joint-lost-track", "joint-full-turn", "joint-beyond-turn",
// "joint-in-step-mode", "no-position-limits", "calibration-out-of-range".
#pragma once

#include "jobs/arm/arm.h"
#include "jobs/arm/joint_range.h"
#include "jobs/arm/joint_template.h"
#include "jobs/arm/lerobot_file.h"
#include "snapshot/snapshot.h"

namespace jobs {
/// A range ends so far from the seam at least, or noise could carry the reading across.
constexpr int seamMargin = 8;

/// Settings read. Whether its position can be recorded and limited.
base::Result<void> requireCalibratable(const device::Servo& servo);

/// `servo`: with its settings as they were while the range was recorded. `middle`: the position
/// that is to read as the middle, counted like the range, as LeRobot asks for it; none: that of the
/// range. A continuous joint that turns through a full turn keeps its offset, and its limits are
/// the ends of the turn. A servo without a full turn keeps its offset.
base::Result<JointCalibration> calibrationOf(const device::Servo& servo, base::JointKind kind,
                                             const JointRange& range,
                                             std::optional<std::int64_t> middle = {});

/// What the servo holds; none: its settings are not read, or it has no position limits.
std::optional<JointCalibration> calibrationIn(const device::Servo& servo);

/// Whether the servo can hold these values: they may come from a file for another one.
base::Result<void> requireValid(const device::Servo& servo, const JointCalibration& values);

/// Position mode (a wheel keeps its own) and single-turn feedback, without which offset and limits
/// mean something else.
JointSettings positionSettings(const device::Servo& servo, base::JointKind kind);

/// The values as a template for this servo, with positionSettings().
snapshot::Snapshot calibrationTemplate(const device::Servo& servo, base::JointKind kind,
                                       const JointCalibration& values, const QString& program);
} // namespace jobs

// SPDX-License-Identifier: GPL-3.0-or-later
// From a joint's recorded range to its registers, and back: the offset that puts the middle of the
// range in the middle of the turn, and the position limits. restoreBundle() writes the templates,
// one transaction a servo. Pure; any thread. Errors: NotSupported with the servo's ID and a reason:
// "joint-not-recorded", "joint-beyond-turn", "no-position-limits".
#pragma once

#include "jobs/arm/arm.h"
#include "jobs/arm/joint_range.h"
#include "jobs/arm/lerobot_file.h"
#include "snapshot/snapshot.h"

namespace jobs {
/// A range ends so far from the seam at least, or noise could carry the reading across.
constexpr int seamMargin = 8;

/// `servo`: with its settings as they were while the range was recorded. `middle`: the position
/// that is to read as the middle, counted like the range, as LeRobot asks for it; none: that of the
/// range. A joint that turns through a full turn keeps its offset and gets no narrower limits.
base::Result<JointCalibration> calibrationOf(const device::Servo& servo, const JointRange& range,
                                             std::optional<std::int64_t> middle = {});

/// What the servo holds; none: its settings are not read, or it has no position limits.
std::optional<JointCalibration> calibrationIn(const device::Servo& servo);

/// The values as a template for this servo, with position mode unless the joint is a wheel.
snapshot::Snapshot calibrationTemplate(const device::Servo& servo, base::JointKind kind,
                                       const JointCalibration& values, const QString& program);
} // namespace jobs

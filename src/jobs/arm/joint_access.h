// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the settings of joints, for window and command line. The job's thread; errors
// are those of reading, and of restoreBundle() as the verdict of a servo.
#pragma once

#include "jobs/restore/restore_many.h"

namespace jobs {
/// Offset, limits, position, EPROM lock and lerobotSettings(): what calibrationIn() and
/// lerobotRemarks() need.
base::Result<void> readJoint(const device::Context& context, device::Servo& servo);

/// Each template (calibrationTemplate(), jointTemplate()) onto the servo with its ID: torque off,
/// one transaction a servo, every value read back; a servo that does not take them all gets its old
/// ones back. The task itself names the risk: offsets shift zero positions.
std::vector<ApplyResult> writeJoints(const device::Context& context,
                                     const std::vector<snapshot::Snapshot>& templates,
                                     ApplyOptions options, const ProgressFn& progress = {});
} // namespace jobs

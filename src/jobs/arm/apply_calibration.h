// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the calibration of joints, for window and command line. The job's thread; errors
// are those of reading, and of restoreBundle() as the verdict of a servo.
#pragma once

#include "jobs/restore/restore_many.h"

namespace jobs {
/// Settings, offset, limits, position and EPROM lock: what calibrationIn() needs, and more.
base::Result<void> readCalibration(const device::Context& context, device::Servo& servo);

/// Each template (calibrationTemplate()) onto the servo with its ID: torque off, one transaction a
/// servo, every value read back; a servo that does not take them all gets its old ones back. The
/// task itself names the risk: offsets shift zero positions.
std::vector<ApplyResult> writeCalibrations(const device::Context& context,
                                           const std::vector<snapshot::Snapshot>& templates,
                                           ApplyOptions options, const ProgressFn& progress = {});
} // namespace jobs

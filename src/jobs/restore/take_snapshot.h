// SPDX-License-Identifier: GPL-3.0-or-later
// A servo's whole memory table as a snapshot::Snapshot. Writes nothing to the servo. Errors are
// those of reading.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"
#include "snapshot/snapshot.h"

namespace jobs {
/// The servo's identity as files hold it.
snapshot::SnapshotServo snapshotServo(const device::Servo& servo);

/// One without registers: program, time, port and servo.
snapshot::Snapshot emptySnapshot(const device::Servo& servo, const QString& program);

/// What has been read so far, as a snapshot. Reads nothing.
snapshot::Snapshot snapshotOf(const device::Servo& servo, const QString& program);

/// `program` is the name and version that goes into the file.
base::Result<snapshot::Snapshot> takeSnapshot(const device::Context& context, device::Servo& servo,
                                              const QString& program);
} // namespace jobs

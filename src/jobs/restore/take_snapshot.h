// SPDX-License-Identifier: GPL-3.0-or-later
// A servo's whole memory table as a record::Snapshot. Writes nothing to the servo. Errors are those
// of reading.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"
#include "snapshot/snapshot.h"

namespace jobs {
/// What has been read of it so far, as a snapshot: reads nothing.
record::Snapshot snapshotOf(const device::Servo& servo, const QString& program);

/// `program` is the name and version that goes into the file.
base::Result<record::Snapshot> takeSnapshot(const device::Context& context, device::Servo& servo,
                                            const QString& program);
} // namespace jobs

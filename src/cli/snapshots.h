// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots taken by commands, asked for or for safety's sake. Main thread. Errors of reading and
// of record::saveSnapshot.
#pragma once

#include "cli/run.h"
#include "record/snapshot.h"

namespace cli {
base::Result<record::Snapshot> saveSnapshotOf(Run& run, device::Servo& servo, const QString& file);

/// A new file in the data folder, before something that loses settings; answers its path.
base::Result<QString> saveSafetySnapshot(Run& run, device::Servo& servo);
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// A servo's table saved without being asked, before something that changes it. The job's thread.
// Errors of reading and of snapshot::saveSnapshot.
#pragma once

#include "device/servo.h"
#include "history/history_rows.h"
#include "jobs/job.h"

namespace session {
/// Name and version as files carry them: "servodesk 0.1.0".
QString programName();

/// A new file in the data folder, and a row of the history; answers the path of the file. Reads the
/// whole table. Its label is the servo's of the history.
base::Result<QString>
saveSafetySnapshot(const device::Context& context, device::Servo& servo,
                   history::SnapshotReason reason = history::SnapshotReason::Automatic);

/// Nothing was changed after all: takes the file and its row of the history away again.
void removeSafetySnapshot(const QString& path);

/// One that was saved to `file`, for the history too. A history that cannot be used does not make
/// the file worse: it is told nowhere here, but refuses writes.
void addToHistory(const snapshot::Snapshot& snapshot, history::SnapshotReason reason,
                  const QString& file);
} // namespace session

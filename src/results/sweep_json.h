// SPDX-License-Identifier: GPL-3.0-or-later
// A whole sweep test as JSON, format "servodesk-sweep", version 1; files of every published version
// can be loaded. Top level: format, version, verdict ("pass", "warn", "fail", "not-measured"),
// program, time, port, baud, simulated, length_ms, end, ended_by (ID or null), sample_rate, gaps,
// test (the requested parameters), servos (id, verdict, axis, limits, lines, errors, parameters as
// in a snapshot file), metrics (one line per figure) and legs (one line per leg), both with
// `servo`, its ID. Times in ms, positions in steps, otherwise sweep_run.h; null: not measured.
// Stable: the same run gives the same bytes. Pure; any thread. Fails with FileMissing,
// FileUnreadable, FileFormat (detail has the place), FileUnwritable, DiskFull.
#pragma once

#include "files/text_file.h"
#include "results/sweep_run.h"

namespace results {
QByteArray encodeSweepRun(const SweepRun& run);
base::Result<SweepRun> decodeSweepRun(const QByteArray& text);

/// The same in pieces of some tens of kB.
void writeSweepRun(const SweepRun& run, const files::TextSink& sink);

/// Never holds the whole text in memory; a long run has a hundred thousand legs.
base::Result<void> saveSweepRun(const SweepRun& run, const QString& path);
base::Result<SweepRun> loadSweepRun(const QString& path);
} // namespace results

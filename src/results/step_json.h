// SPDX-License-Identifier: GPL-3.0-or-later
// Step-response runs as files. JSON, format "servodesk-step-response", version 1: runs (oldest
// first, each with test, gains, axis, mean, responses with figures and samples, parameters as in a
// snapshot file), differences (first run against last) and advice (to the last one). Samples are
// rows of t_ms, position, speed, load, current; null: not measured. CSV: one line per reading,
// `run, response,t[ms],start[step],target[step],position[step],speed[step/s],load[%],current[mA]`.
// Files of every published version can be loaded; differences and advice are computed, not read.
// Pure; any thread. Fails with FileMissing, FileUnreadable, FileFormat, FileUnwritable, DiskFull.
#pragma once

#include "results/step_run.h"

#include <QByteArray>

namespace results {
QByteArray encodeStepRuns(const std::vector<StepRun>& runs, const std::vector<StepAdvice>& advice);
base::Result<std::vector<StepRun>> decodeStepRuns(const QByteArray& text);

base::Result<void> saveStepRuns(const std::vector<StepRun>& runs,
                                const std::vector<StepAdvice>& advice, const QString& path);
base::Result<std::vector<StepRun>> loadStepRuns(const QString& path);

base::Result<void> saveStepSamples(const std::vector<StepRun>& runs, const QString& path);
} // namespace results

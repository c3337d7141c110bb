// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses as the commands print and save them. Pure but for the files; main thread. Fails as
// the writer of the format does; BadArgument for a file name with another ending.
#pragma once

#include "base/error.h"
#include "results/step_run.h"

namespace cli {
enum class StepFileFormat : std::uint8_t { Html, Json, Csv };

base::Result<StepFileFormat> stepFileFormat(const QString& path); ///< by its ending
base::Result<void> saveStepReport(const std::vector<results::StepRun>& runs,
                                  const std::vector<results::StepAdvice>& advice,
                                  StepFileFormat format, const QString& path);

/// "STS3215 · 1, 1800 → 2100", the gains of each run and how it ended, then the figures of one run
/// or the first and the last run compared, and the advice.
QString stepRunsText(const std::vector<results::StepRun>& runs,
                     const std::vector<results::StepAdvice>& advice);
} // namespace cli

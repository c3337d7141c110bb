// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses as the commands print them. Pure; main thread.
#pragma once

#include "base/error.h"
#include "results/step_run.h"

namespace cli {
/// BadArgument for a name with an ending that no format has.
base::Result<void> checkStepReportName(const QString& path);

/// "STS3215 · 1, 1800 → 2100", the gains of each run and how it ended, then the figures of one run
/// or the first and the last run compared, and the advice.
QString stepRunsText(const std::vector<results::StepRun>& runs,
                     const std::vector<results::StepAdvice>& advice);
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// Step-response runs as one self-contained HTML page: the responses of all runs in one SVG chart,
// figures before and after, gains, advice; English and Chinese in one file, no script. It is
// well-formed XML as well. Pure; any thread. Saving fails with FileUnwritable or DiskFull, and the
// old file stays.
#pragma once

#include "report/html_page.h"
#include "results/step_run.h"

namespace report {
/// `chinese`: the language it opens in. At least one run; the first and the last are compared.
QByteArray stepHtml(const std::vector<results::StepRun>& runs,
                    const std::vector<results::StepAdvice>& advice, bool chinese);
base::Result<void> saveStepHtml(const std::vector<results::StepRun>& runs,
                                const std::vector<results::StepAdvice>& advice, bool chinese,
                                const QString& path);

/// All responses in one chart: steps towards the target over milliseconds since the goal. SVG.
QString stepChart(const HtmlWriter& htmlWriter, const std::vector<results::StepRun>& runs);
} // namespace report

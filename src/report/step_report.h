// SPDX-License-Identifier: GPL-3.0-or-later
// Step-response runs as a file: a self-contained HTML page (English and Chinese, no script,
// well-formed XML as well), a PDF of one language, or the data. The page shows the responses of all
// runs in one chart, gains, figures before and after, and advice. Any thread; a PDF needs a
// QGuiApplication. Saving fails with FileUnwritable or DiskFull, and the old file stays.
#pragma once

#include "report/html_page.h"
#include "results/step_run.h"

namespace report {
/// Html, Pdf, Json, Csv by the end of the file's name; of another name: false.
bool isStepReport(const QString& path);
/// `chinese`: the language a report opens in. At least one run; the first and the last are
/// compared. `path` is a name for which isStepReport() holds.
base::Result<void> saveStepReport(const std::vector<results::StepRun>& runs,
                                  const std::vector<results::StepAdvice>& advice, bool chinese,
                                  const QString& path);

/// All responses in one chart: steps towards the target over milliseconds since the goal. SVG.
QString stepChart(const HtmlWriter& htmlWriter, const std::vector<results::StepRun>& runs);
} // namespace report

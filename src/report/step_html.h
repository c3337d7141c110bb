// SPDX-License-Identifier: GPL-3.0-or-later
// Step-response runs as one HTML page that needs nothing else: the responses of all runs over each
// other as SVG, figures before and after, gains, advice; English and Chinese in one file, no
// script. It is well-formed XML as well. Pure; any thread. Saving fails with FileUnwritable or
// DiskFull; the old file stays then.
#pragma once

#include "report/html_page.h"
#include "results/step_run.h"

namespace report {
/// `chinese`: the language it opens in. At least one run; the first and the last are compared.
QByteArray stepHtml(const std::vector<record::StepRun>& runs,
                    const std::vector<record::StepAdvice>& advice, bool chinese);
base::Result<void> saveStepHtml(const std::vector<record::StepRun>& runs,
                                const std::vector<record::StepAdvice>& advice, bool chinese,
                                const QString& path);

/// All responses over each other, in steps towards their target, ms from the goal on. SVG.
QString stepChart(const HtmlWriter& htmlWriter, const std::vector<record::StepRun>& runs);
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a sweep test on paper, as PDF in one language: a page for all servos, then at most
// two for each; the memory tables are in the HTML page. Thread and fonts: see paper.h. Saving fails
// with FileUnwritable or DiskFull, and the old file stays.
#pragma once

#include "report/sweep_parts.h"

namespace report {
QByteArray sweepPdf(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                    bool chinese);
base::Result<void> saveSweepPdf(const results::SweepRun& run,
                                const std::vector<SweepSeries>& series, bool chinese,
                                const QString& path);
} // namespace report

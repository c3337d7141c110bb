// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a sweep test as PDF, A4 landscape, in one language, with the figures of the HTML
// page. Needs a QGuiApplication for the fonts (the platform "offscreen" is enough) and its thread.
// Saving fails with FileUnwritable or DiskFull, and the old file stays.
#pragma once

#include "report/sweep_parts.h"

namespace report {
QByteArray sweepPdf(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                    bool chinese);
base::Result<void> saveSweepPdf(const results::SweepRun& run,
                                const std::vector<SweepSeries>& series, bool chinese,
                                const QString& path);
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a sweep test as PDF, A4 across, in one language, with the same figures as the page.
// Needs a QGuiApplication (fonts; the platform "offscreen" will do) and the thread that owns it.
// Saving fails with FileUnwritable or DiskFull; the old file stays then.
#pragma once

#include "report/sweep_parts.h"

namespace report {
QByteArray sweepPdf(const record::SweepRun& run, const std::vector<SweepSeries>& series,
                    bool chinese);
base::Result<void> saveSweepPdf(const record::SweepRun& run, const std::vector<SweepSeries>& series,
                                bool chinese, const QString& path);
} // namespace report

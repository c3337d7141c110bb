// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a sweep test as one self-contained HTML page: charts as SVG, English and Chinese in
// one file, no script, nothing from the network. It is well-formed XML as well. Long lists of legs
// are shortened, which the page mentions. Pure; any thread. Saving fails with FileUnwritable or
// DiskFull, and the old file stays.
#pragma once

#include "report/sweep_parts.h"

namespace report {
/// `chinese`: the language it opens in. Servos without a series have no position chart.
QByteArray sweepHtml(const results::SweepRun& run, const std::vector<SweepSeries>& series,
                     bool chinese);
base::Result<void> saveSweepHtml(const results::SweepRun& run,
                                 const std::vector<SweepSeries>& series, bool chinese,
                                 const QString& path);
} // namespace report

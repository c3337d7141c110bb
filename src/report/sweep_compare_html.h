// SPDX-License-Identifier: GPL-3.0-or-later
// Two sweep tests side by side as one page that needs nothing else, as report/sweep_html.h has it.
// Pure; any thread. Saving fails with FileUnwritable or DiskFull; the old file stays then.
#pragma once

#include "results/sweep_compare.h"

namespace report {
/// `chinese`: the language it opens in.
QByteArray sweepCompareHtml(const record::SweepSide& a, const record::SweepSide& b, bool chinese);
base::Result<void> saveSweepCompareHtml(const record::SweepSide& a, const record::SweepSide& b,
                                        bool chinese, const QString& path);
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
// Two sweep tests side by side as one self-contained page, like the report (sweep_html.h). Pure;
// any thread. Saving fails with FileUnwritable or DiskFull, and the old file stays.
#pragma once

#include "results/sweep_compare.h"

namespace report {
/// `chinese`: the language it opens in.
QByteArray sweepCompareHtml(const results::SweepSide& a, const results::SweepSide& b, bool chinese);
base::Result<void> saveSweepCompareHtml(const results::SweepSide& a, const results::SweepSide& b,
                                        bool chinese, const QString& path);
} // namespace report

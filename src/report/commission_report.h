// SPDX-License-Identifier: GPL-3.0-or-later
// A commissioning batch to hand over with the servos: one line a servo, how many are done, and what
// is unfinished. Any thread; a PDF needs a QGuiApplication. FileUnwritable, DiskFull.
#pragma once

#include "results/commission_batch.h"

namespace report {
/// By `path` HTML or PDF: isReportPath() in report_file.h holds for it. `name`: of the batch.
/// `chinese`: the language it opens in.
base::Result<void> saveCommissionReport(const results::CommissionBatch& batch, const QString& name,
                                        bool chinese, const QString& path);
} // namespace report

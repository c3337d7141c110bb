// SPDX-License-Identifier: GPL-3.0-or-later
// A snapshot or template to hand over: the whole table with names and values in words, on one page
// of paper. Any thread; a PDF needs a QGuiApplication. FileUnwritable, DiskFull.
#pragma once

#include "catalog/catalog.h"
#include "snapshot/snapshot.h"

namespace report {
/// By `path` HTML or PDF: isReportPath() in report_file.h holds for it. `chinese`: the language it
/// opens in. The catalog words the values; a model that it does not know keeps numbers and units.
base::Result<void> saveSnapshotReport(const snapshot::Snapshot& snapshot,
                                      const catalog::Catalog& catalog, bool chinese,
                                      const QString& path);
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
// Searching the bus, for every command that begins with it: its options, the search with its
// progress line, and what to say beside the servos. Main thread.
#pragma once

#include "cli/run.h"
#include "jobs/scan/scan.h"

namespace cli {
std::vector<Option> searchOptions(); ///< --ids, --bauds, --slow
/// Connects first.
base::Result<jobs::ScanReport> searchBus(Run& run, const Values& values);

Json jsonScan(const jobs::ScanReport& report);
QString scanNote(const jobs::FoundServo& found); ///< empty: nothing to say
/// Both are lines below the table, each with its end: why nothing was found; what else may be
/// there, and what to do.
QString notFoundText(const jobs::ScanReport& report);
QString scanRemarks(const jobs::ScanReport& report);
} // namespace cli

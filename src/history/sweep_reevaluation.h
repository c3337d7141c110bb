// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts that earlier versions stored for lists: sweep tests that were broken off or followed a
// sine could have "passed". Worked out anew from the stored runs, once a file. The thread that
// opened the file; errors as in record/history_file.h.
#pragma once

#include "base/error.h"

namespace record {
class HistoryFile;

base::Result<void> reevaluateStoredSweeps(const HistoryFile& file);
} // namespace record

// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts that earlier versions stored for lists: sweep tests that were broken off or followed a
// sine could have "passed". Computed again from the stored runs, once per file. The thread that
// opened the file; errors as in history/history_file.h.
#pragma once

#include "base/error.h"

namespace history {
class HistoryFile;

base::Result<void> reevaluateStoredSweeps(const HistoryFile& file);
} // namespace history

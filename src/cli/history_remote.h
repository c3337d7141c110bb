// SPDX-License-Identifier: GPL-3.0-or-later
// The history that a command looks at: this computer's, or with --server the copies on a history
// server. Main thread; waits for the server. Errors of record/history_server.h; BadArgument.
#pragma once

#include "cli/command.h"
#include "record/history_server.h"

namespace record {
class History;
}

namespace cli {
/// --server, --bench
std::vector<Option> serverOptions();
/// Null: nothing was ever kept on this computer.
base::Result<std::unique_ptr<record::History>> openHistory(const Values& values);
/// Who sends to the server.
base::Result<std::vector<record::HistoryBench>> listBenches(const Values& values);
} // namespace cli

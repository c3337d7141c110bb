// SPDX-License-Identifier: GPL-3.0-or-later
// The history that a command looks at: this computer's, or with --server the copies on a history
// server. A server is waited for until Ctrl-C, or until it leaves a question unanswered for half a
// minute. Main thread. Errors of record/history_server.h; BadArgument.
#pragma once

#include "cli/run.h"
#include "history/server/history_server.h"
#include "session/history/history_server_choice.h"

namespace record {
class History;
}

namespace cli {
/// --server, --bench
std::vector<Option> serverOptions();
/// `work`, which may ask a server: then on a thread that Ctrl-C leaves behind.
base::Result<Exit> runHistoryCommand(Run& run, const Values& values,
                                     base::Result<Exit> (*work)(Run&, const Values&));
/// Null: nothing was ever kept on this computer.
base::Result<std::unique_ptr<record::History>> openHistory(Run& run, const Values& values);
/// Who sends to the server.
base::Result<std::vector<record::HistoryBench>> listBenches(Run& run, const Values& values);

/// What is remembered, said once if a password had to be removed from it.
session::HistoryServerChoice savedServer(Run& run, session::Settings& settings);
} // namespace cli

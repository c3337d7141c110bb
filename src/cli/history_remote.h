// SPDX-License-Identifier: GPL-3.0-or-later
// The history that a command uses: that of this computer, or with --server the copies on a history
// server. The program waits for a server until Ctrl-C, or until a request has had no reply for half
// a minute. Main thread. Errors of history/server/history_server.h; BadArgument.
#pragma once

#include "cli/run.h"
#include "history/server/history_server.h"

namespace history {
class History;
}

namespace cli {
/// --server, --bench
std::vector<Option> serverOptions();
using HistoryWork = base::Result<Exit> (*)(Run&, const Values&);
/// Work with a server runs on a thread that Ctrl-C abandons; other work runs on the main thread.
base::Result<Exit> runHistoryWork(Run& run, const Values& values, HistoryWork work);
/// The same as the function of a Command.
template <HistoryWork work>
base::Result<Exit> runHistoryCommand(Run& run, const Values& values)
{
    return runHistoryWork(run, values, work);
}
/// Null: there is no history on this computer yet.
base::Result<std::unique_ptr<history::History>> openHistory(Run& run, const Values& values);
/// The benches that send to the server.
base::Result<std::vector<history::HistoryBench>> listBenches(Run& run, const Values& values);
} // namespace cli

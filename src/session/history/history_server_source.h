// SPDX-License-Identifier: GPL-3.0-or-later
// The copies on a history server, for HistoryService: reads only, of all benches or one. The
// connection is made by the first question and kept; after one that failed it is made anew. A
// server that is silent for longer than `timeout` counts as hung; the destructor waits for a
// tenth of a second or less. Main thread; see history_source.h.
#pragma once

#include "history/server/history_server.h"
#include "session/detachable_worker.h"
#include "session/history/history_source.h"

#include <QTimer>

namespace session {
class HistoryServerSource final : public HistorySource {
public:
    explicit HistoryServerSource(const QString& address,
                                 std::chrono::milliseconds timeout = std::chrono::seconds(30));
    ~HistoryServerSource() override;

    void start(Query query) override;
    void selectBench(std::optional<std::int64_t> bench) override { m_bench = bench; }

private:
    class ServerConnection;
    std::shared_ptr<ServerConnection>
        m_connection; ///< shared with the thread, which may be left behind
    DetachableWorker m_thread;
    std::optional<std::int64_t> m_bench;
    QTimer m_watch;
};
} // namespace session

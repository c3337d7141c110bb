// SPDX-License-Identifier: GPL-3.0-or-later
// Takes changes of a bench's history (history/history_changes.h) over into the copies on the
// server. Borrows a HistoryServer opened for sending; its thread, its errors. Sending again is
// harmless, and two programs of one bench may send at the same time.
#pragma once

#include "history/history_changes.h"
#include "history/server/history_server.h"

namespace history {
/// The bench that sends.
struct HistoryOrigin {
    QString bench{};   ///< HistoryChanges::bench()
    QString origin{};  ///< this very file on this very machine
    QString name{};    ///< of the bench, for people
    QString program{}; ///< name and version
};

class HistoryServerWriter {
public:
    HistoryServerWriter(const HistoryServer& server, HistoryOrigin sender)
        : m_server(server)
        , m_sender(std::move(sender))
    {}

    /// Registers the bench with its present name; returns the revision up to which the server has
    /// all.
    base::Result<std::int64_t> registerBench();
    /// All of `rows` or none of them. `from`: the revision before them; `until`: the revision after
    /// them. Returns the revision of the server: another one means that another program has sent
    /// meanwhile and nothing was stored.
    base::Result<std::int64_t> apply(const std::vector<ChangedRow>& rows, std::int64_t from,
                                     std::int64_t until);
    /// Begins again: the file is older than its copy on the server (a backup was restored).
    base::Result<void> restart();

private:
    base::Result<void> applyRows(const std::vector<ChangedRow>& rows) const;

    const HistoryServer& m_server;
    const HistoryOrigin m_sender;
    std::int64_t m_bench = 0; ///< its number on the server; known after greet()
};
} // namespace history

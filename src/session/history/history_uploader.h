// SPDX-License-Identifier: GPL-3.0-or-later
// Sends what the server has not got yet of this bench's history, over a connection that is kept
// while all goes well. send() on one thread, which it may keep waiting for as long as the server
// does; abort(), silenceTime() and dropConnection() from any. Reads the local file like any other
// program: writers do not wait for it. Errors of history/server/history_server.h and
// history/history_file.h; an error means that what was not sent is sent next time.
#pragma once

#include "history/server/history_server_writer.h"

#include <atomic>
#include <mutex>

namespace session {
struct SendProgress {
    std::int64_t sent = 0;    ///< rows, by this call
    std::int64_t pending = 0; ///< rows still to go
};

class HistoryUploader {
public:
    /// `server`: a connection string. `bench`: its name for people.
    HistoryUploader(QString historyPath, QString server, QString bench);
    ~HistoryUploader();

    /// Connects with nothing to send as well: an empty history proves nothing about the server.
    base::Result<SendProgress> send(const std::function<void(const SendProgress&)>& progress = {});

    /// Rows the server lacked when send() checked last; nullopt: not known yet. The thread of
    /// send().
    std::optional<std::int64_t> pendingRows() const { return m_waiting; }

    /// The thread of send(), as the last thing it does here.
    void disconnect();

    /// send() ends soon, with an error, unless it is just connecting: that takes its seconds.
    void abort();
    /// How long the server has kept send() waiting for one answer.
    std::chrono::milliseconds silenceTime() const;
    /// Ends this wait, as if the connection had broken.
    void dropConnection();

private:
    base::Result<void> connect(const history::HistoryChanges& changes);
    base::Result<SendProgress> sendOver(const history::HistoryChanges& changes,
                                        const std::function<void(const SendProgress&)>& progress);
    base::Result<SendProgress> sendAll(const history::HistoryChanges& changes,
                                       const std::function<void(const SendProgress&)>& progress);
    void resetSilence();

    const QString m_path;
    const QString m_address;
    const QString m_bench;
    std::unique_ptr<history::HistoryServer> m_server; ///< changed under the mutex
    std::unique_ptr<history::HistoryServerWriter> m_copy;
    QString m_sentBench;                          ///< the file that m_reached is about
    std::optional<std::int64_t> m_serverRevision; ///< the revision the server had last
    std::optional<std::int64_t> m_waiting;
    mutable std::mutex m_mutex;
    std::atomic<bool> m_aborted{false};
    std::atomic<std::int64_t> m_askedAt{0}; ///< ms of the steady clock; 0: not waiting
};
} // namespace session

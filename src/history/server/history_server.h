// SPDX-License-Identifier: GPL-3.0-or-later
// One connection to the PostgreSQL server that has copies of the histories of many benches. It is
// asked with the very statements of the local file (tables and columns are the same, `number` is
// the server's own), so history::History and HistoryLog read from it; only
// history/server/history_server_writer.h changes it. The thread that connected; abort() from any.
// Calls wait for the server: connecting some seconds, statements until they are answered or
// aborted. Another computer must prove by its certificate that it is the one named
// (sslmode=verify-full), unless sslmode in the string or PGSSLMODE sets another mode. Fails with
// operation "history-server" and a detail "KIND: the server's words": away, hung, password,
// database, rights, tls, certificate, host-name, refused (LinkLost, Port…), driver (NotSupported),
// newer, older, encoding (FileFormat), empty (FileMissing: nothing was ever sent there), busy
// (PortBusy), full (DiskFull), string, secret (BadArgument), server (PortFailed).
// text/server_text.cpp has the words.
#pragma once

#include "base/stop_token.h"
#include "history/history_file.h"
#include "history/server/server_address.h"
#include "history/server/server_socket.h"

#include <atomic>
#include <thread>

namespace history {
/// A bench that has sent something.
struct HistoryBench {
    std::int64_t number = 0; ///< the server's
    QString uuid{};
    QString name{};   ///< for people, changeable
    QDateTime sent{}; ///< when it last sent something; UTC by the server's clock
    std::int64_t writes = 0;
};

class HistoryServer final : public HistoryFile {
public:
    enum class Purpose : std::uint8_t {
        Send,   ///< makes or brings up to date the schema
        Browse, ///< changes nothing; needs the right to read only
    };

    HistoryServer(ServerAddress address, Purpose purpose);
    ~HistoryServer() override;

    base::Result<void> connect();
    /// For a caller with nothing else to do: from now on a thread of its own aborts when `stop` is
    /// requested (Stopped then), or when one answer takes longer than `patience` (hung).
    void startWatchdog(const base::StopToken& stop, std::chrono::milliseconds timeout);
    /// Requests that wait for the server fail at once (hung), and so do all later ones. Any thread.
    void abort();

    base::Result<QueryResult> run(const QString& sql,
                                  const QVariantList& values = {}) const override;
    base::Result<void> transaction(const std::function<base::Result<void>()>& work) const override;
    QString sameBench(const QString& one, const QString& other) const override;

    /// By name.
    base::Result<std::vector<HistoryBench>> benches() const;
    /// From now on lists have only what this one has sent; nullopt: what all have.
    base::Result<void> selectBench(std::optional<std::int64_t> bench) const;
    /// The benches that sent these rows of "servos", "writes", "snapshots", "alarms", "recordings"
    /// or "runs": number → name.
    base::Result<QMap<qint64, QString>> benchNames(const QString& table,
                                                   const std::vector<std::int64_t>& numbers) const;

private:
    base::Result<void> initializeSession() const;
    base::Error error(const QSqlError& error, bool connecting) const;
    QString statement(const QString& sql, const QVariantList& values) const;

    const ServerAddress m_address;
    const Purpose m_purpose;
    const QString m_name; ///< of Qt's connection
    ServerSocket m_socket;
    mutable std::atomic<std::chrono::steady_clock::rep> m_queryStartedAt{
        0}; ///< 0: nothing is asked
    const base::StopToken* m_stop = nullptr;
    std::atomic<bool> m_ending{false};
    std::thread m_watchdog;
};

/// From the connection string of the user to a connection. Waits like connect(). With
/// `stop`: guarded by it, with a patience that ends any wait.
base::Result<std::unique_ptr<HistoryServer>>
connectHistoryServer(const QString& text, HistoryServer::Purpose purpose,
                     const base::StopToken* stop = nullptr);
} // namespace history

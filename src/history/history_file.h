// SPDX-License-Identifier: GPL-3.0-or-later
// The SQLite file of the history: one connection to it, its schema, and errors as values. Internal
// to history/history.h; the thread that opened it. Several programs may have the file open at once:
// write-ahead logging, and a connection that finds it locked waits up to its timeout.
// Fails with NotSupported (no SQLite driver), FileFormat (from a newer version, no database,
// damaged), DiskFull, and FileUnwritable for all else, locked included; detail has the path.
#pragma once

#include "base/error.h"

#include <QVariantList>

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

class QSqlError;

namespace history {
struct QueryResult {
    std::vector<QVariantList> rows{};
    std::int64_t insertedId = 0;
    int changed = 0; ///< rows
};

class HistoryFile {
public:
    /// Made if it is not there, with its folder; brought up to the present schema.
    static base::Result<std::unique_ptr<HistoryFile>> open(const QString& path,
                                                           std::chrono::milliseconds timeout);
    HistoryFile(const HistoryFile&) = delete;
    HistoryFile& operator=(const HistoryFile&) = delete;
    virtual ~HistoryFile();

    // Virtual, because a copy on a server is asked the same questions:
    // history/server/history_server.h.
    /// One statement with its values in place of `?`.
    virtual base::Result<QueryResult> run(const QString& sql,
                                          const QVariantList& values = {}) const;
    /// All of `work` or nothing of it. Has the file to itself from the beginning, since one that
    /// begins by reading could not wait for another writer.
    virtual base::Result<void> transaction(const std::function<base::Result<void>()>& work) const;

    /// A condition to append where two rows must come from one bench; here all do.
    virtual QString sameBench(const QString& one, const QString& other) const;

    const QString& path() const { return m_path; }

protected:
    HistoryFile(QString path, QString connection);

private:
    base::Result<void> prepare() const;
    base::Result<void> prepareExclusive() const;
    base::Result<void> migrate() const;
    base::Result<int> version() const;
    base::Error error(const QSqlError& error) const;

    QString m_path;
    QString m_connection;
};
} // namespace history

// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_file.h"

#include "files/folder_sync.h"
#include "history/history_schema.h"

#include <QDir>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QStorageInfo>
#include <QStringList>
#include <QUuid>

#include <vector>

namespace history {
namespace {
const QString historyOperation = QStringLiteral("history");
const QString driver = QStringLiteral("QSQLITE");

// The result codes of SQLite, as its documentation fixes them; the low byte of the extended ones.
enum SqliteCode : int {
    schemaMismatch = 1, ///< "no such column": not the tables of this program
    inputOutput = 10,
    damaged = 11,
    full = 13,
    cannotOpen = 14,
    noDatabase = 26,
    baseCode = 0xff,
    noSpaceForIndex = 4874, ///< SQLITE_IOERR_SHMSIZE
};

/// Less than SQLite needs for the index of the write-ahead log.
constexpr qint64 minFreeSpace = 64 * 1024;

bool hasFreeSpace(const QString& path)
{
    const QStorageInfo disk(QFileInfo(path).absolutePath());
    return !disk.isValid() || disk.bytesAvailable() >= minFreeSpace;
}

int newest()
{
    return int(historyMigrations().size());
}
} // namespace

base::Result<std::unique_ptr<HistoryFile>> HistoryFile::open(const QString& path,
                                                             std::chrono::milliseconds timeout)
{
    if (!QSqlDatabase::isDriverAvailable(driver))
        return base::fail(base::ErrorCode::NotSupported, historyOperation,
                          QStringLiteral("Qt's SQLite driver is missing (libqt6sql6-sqlite)"));
    const QString folder = QFileInfo(path).absolutePath();
    const bool isNew = !QFileInfo::exists(path);
    const QString existingAncestor = files::existingFolder(path);
    // SQLite would wait forever for data from a pipe.
    if (!isNew && !QFileInfo(path).isFile())
        return base::fail(base::ErrorCode::FileUnwritable, historyOperation,
                          path + QStringLiteral(": not a regular file"));
    if (!QDir().mkpath(folder))
        return base::fail(base::ErrorCode::FileUnwritable, historyOperation,
                          folder + QStringLiteral(": the folder cannot be made"));
    std::unique_ptr<HistoryFile> file(new HistoryFile(
        path, QStringLiteral("history-") + QUuid::createUuid().toString(QUuid::WithoutBraces)));
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(driver, file->m_connection);
        database.setDatabaseName(path);
        database.setConnectOptions(
            QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(qint64(timeout.count())));
        if (!database.open())
            return tl::unexpected(file->error(database.lastError()));
    }
    auto ready = file->prepare();
    if (!ready && ready.error().code == base::ErrorCode::DiskFull)
        ready = file->prepareExclusive();
    if (!ready)
        return tl::unexpected(ready.error());
    if (isNew && !files::syncFolders(path, existingAncestor))
        return base::fail(base::ErrorCode::FileUnwritable, historyOperation,
                          folder + QStringLiteral(": the folder cannot be written to the disk"));
    return file;
}

HistoryFile::HistoryFile(QString path, QString connection)
    : m_path(std::move(path))
    , m_connection(std::move(connection))
{}

QString HistoryFile::sameBench(const QString&, const QString&) const
{
    return {};
}

HistoryFile::~HistoryFile()
{
    QSqlDatabase::removeDatabase(m_connection);
}

base::Error HistoryFile::error(const QSqlError& error) const
{
    base::ErrorCode code = base::ErrorCode::FileUnwritable;
    switch (error.nativeErrorCode().toInt() & baseCode) {
    case schemaMismatch:
    case damaged:
    case noDatabase:
        code = base::ErrorCode::FileFormat;
        break;
    case full:
        code = base::ErrorCode::DiskFull;
        break;
    case inputOutput:
    case cannotOpen:
        if (error.nativeErrorCode().toInt() == noSpaceForIndex || !hasFreeSpace(m_path))
            code = base::ErrorCode::DiskFull;
        break;
    default:
        break;
    }
    return {code, historyOperation, m_path + QStringLiteral(": ") + error.databaseText()};
}

base::Result<QueryResult> HistoryFile::run(const QString& sql, const QVariantList& values) const
{
    QSqlQuery query(QSqlDatabase::database(m_connection, false));
    query.setForwardOnly(true);
    bool fine = query.prepare(sql);
    for (const QVariant& value : values)
        query.addBindValue(value);
    fine = fine && query.exec();
    QueryResult answer;
    if (fine && query.isSelect()) {
        const int columns = query.record().count();
        while (query.next()) {
            QVariantList& row = answer.rows.emplace_back();
            for (int column = 0; column < columns; ++column)
                row.append(query.value(column));
        }
        fine = query.lastError().type() == QSqlError::NoError; // or it ended half-way
    } else if (fine) {
        answer.insertedId = query.lastInsertId().toLongLong();
        answer.changed = query.numRowsAffected();
    }
    if (!fine)
        return tl::unexpected(error(query.lastError()));
    return answer;
}

base::Result<void> HistoryFile::transaction(const std::function<base::Result<void>()>& work) const
{
    if (const auto begun = run(QStringLiteral("BEGIN IMMEDIATE")); !begun)
        return tl::unexpected(begun.error());
    auto done = work();
    if (done) {
        const auto kept = run(QStringLiteral("COMMIT"));
        if (kept)
            return {};
        done = tl::unexpected(kept.error());
    }
    // On a full disk SQLite has rolled back already; then this fails without harm.
    (void)run(QStringLiteral("ROLLBACK"));
    return done;
}

base::Result<int> HistoryFile::version() const
{
    const auto asked = run(QStringLiteral("PRAGMA user_version"));
    if (!asked)
        return tl::unexpected(asked.error());
    const int found = asked->rows.empty() ? 0 : asked->rows.front().value(0).toInt();
    if (found > newest())
        return base::fail(base::ErrorCode::FileFormat, historyOperation,
                          m_path + QStringLiteral(": from a newer version of the program: schema "
                                                  "%1, this one knows up to %2")
                                       .arg(found)
                                       .arg(newest()));
    return found;
}

/// On a full disk there is no room for the shared index of the write-ahead log. In exclusive mode
/// SQLite needs none, so that everything can still be read. The connection must not have opened the
/// index before.
base::Result<void> HistoryFile::prepareExclusive() const
{
    QSqlDatabase database = QSqlDatabase::database(m_connection, false);
    database.close();
    if (!database.open())
        return tl::unexpected(error(database.lastError()));
    const auto lockingResult = run(QStringLiteral("PRAGMA locking_mode = EXCLUSIVE"));
    return lockingResult ? prepare() : tl::unexpected(lockingResult.error());
}

base::Result<void> HistoryFile::prepare() const
{
    const auto found = version();
    if (!found)
        return tl::unexpected(found.error());
    // Fails while another program does the same, or where the file is read-only; the next
    // statements show whether the file can be used.
    (void)run(QStringLiteral("PRAGMA journal_mode = WAL"));
    if (const auto keys = run(QStringLiteral("PRAGMA foreign_keys = ON")); !keys)
        return tl::unexpected(keys.error());
    // What was reported as kept is on the disk; for other work it costs little.
    if (const auto full = run(QStringLiteral("PRAGMA synchronous = FULL")); !full)
        return tl::unexpected(full.error());
    return *found < newest() ? migrate() : base::Result<void>();
}

base::Result<void> HistoryFile::migrate() const
{
    return transaction([this]() -> base::Result<void> {
        // Another program may have been first.
        const auto found = version();
        if (!found)
            return tl::unexpected(found.error());
        for (int step = *found; step < newest(); ++step) {
            for (const QString& sql : historyMigrations()[std::size_t(step)]) {
                if (const auto done = run(sql); !done)
                    return tl::unexpected(done.error());
            }
        }
        const auto marked = run(QStringLiteral("PRAGMA user_version = %1").arg(newest()));
        return marked ? base::Result<void>() : tl::unexpected(marked.error());
    });
}
} // namespace history

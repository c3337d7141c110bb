// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/journal_import.h"

#include "files/file_handle.h"
#include "history/history_intents.h"
#include "history/history_query.h"
#include "history/journal_line.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

#include <mutex>

namespace history {
namespace {
const QString importOperation = QStringLiteral("journal");
const QString importedSuffix = QStringLiteral(".taken-");

tl::unexpected<base::Error> unreadable(const QString& path)
{
    return base::fail(base::ErrorCode::FileUnreadable, importOperation, path);
}

/// What was found in imported files, until it is reported. One per program: the part that
/// opens the history first does the import, and this can be any part.
class UnreadableFiles {
public:
    void add(const QString& path, int lines)
    {
        const std::lock_guard lock(m_mutex);
        m_found.push_back({base::ErrorCode::FileFormat, importOperation,
                           QStringLiteral("%1: %2").arg(path).arg(lines)});
    }
    std::vector<base::Error> take()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_found, {});
    }

private:
    std::mutex m_mutex;
    std::vector<base::Error> m_found;
};

UnreadableFiles& unreadableFiles()
{
    static UnreadableFiles files;
    return files;
}

/// Identifies a file independent of its name: the first line has a time and usually a uuid.
QString firstLineHash(const QByteArray& text)
{
    const QByteArray line = text.left(text.indexOf('\n'));
    return QString::fromLatin1(QCryptographicHash::hash(line, QCryptographicHash::Sha256).toHex());
}

base::Result<void> importLine(const HistoryFile& file, const QByteArray& text,
                              JournalImport& journalImport)
{
    ++journalImport.lines;
    const auto line = decodeJournalLine(text);
    if (!line) {
        ++journalImport.unreadable;
        return {};
    }
    if (const auto* begin = std::get_if<BeginLine>(&*line))
        return insertIntent(file, begin->intent, {});
    if (const auto* keep = std::get_if<FactLine>(&*line))
        return saveFact(file, keep->servo, keep->name, keep->values, keep->at,
                        ConflictPolicy::UnlessOlder);
    const auto& end = std::get<EndLine>(*line);
    const auto ended = endIntent(file, end.uuid, end.end, end.at, ConflictPolicy::UnlessOlder);
    if (!ended)
        return tl::unexpected(ended.error());
    journalImport.unreadable += *ended ? 0 : 1; // the end of an unknown intent
    return {};
}

/// Only whole lines: an unfinished line is left for the next import.
base::Result<void> importText(const HistoryFile& file, const QByteArray& text,
                              JournalImport& journalImport)
{
    const qsizetype size = text.lastIndexOf('\n') + 1;
    if (size == 0)
        return {};
    const QString name = firstLineHash(text);
    const auto known =
        file.run(QStringLiteral("SELECT bytes, unreadable FROM taken WHERE file = ?"), {name});
    if (!known)
        return tl::unexpected(known.error());
    qsizetype from = known->rows.empty() ? 0 : known->rows.front().value(0).toLongLong();
    const int unreadableBefore = known->rows.empty() ? 0 : known->rows.front().value(1).toInt();
    JournalImport found;
    while (from < size) {
        const qsizetype end = text.indexOf('\n', from);
        const QByteArray line = text.mid(from, end - from).trimmed();
        from = end + 1;
        if (line.isEmpty())
            continue;
        if (const auto imported = importLine(file, line, found); !imported)
            return imported;
    }
    const auto noted =
        file.run(QStringLiteral("INSERT INTO taken (file, bytes, unreadable) VALUES (?, ?, ?) "
                                "ON CONFLICT (file) DO UPDATE SET bytes = excluded.bytes, "
                                "unreadable = excluded.unreadable"),
                 {name, size, unreadableBefore + found.unreadable});
    if (!noted)
        return tl::unexpected(noted.error());
    journalImport.lines += found.lines;
    journalImport.unreadable += found.unreadable;
    return {};
}

/// Its new name, which nothing had. Where it cannot be renamed it stays, and its end is known.
QString renameImported(const QString& path)
{
    for (int n = 1;; ++n) {
        const QString renamed = path + importedSuffix + QString::number(n);
        if (!QFileInfo::exists(renamed)) {
            return QFile::rename(path, renamed) ? renamed : path;
        }
    }
}

/// `current`: the file that programs append to; it is renamed afterwards. Until then it is locked
/// against appending.
base::Result<void> importFile(const HistoryFile& file, const QString& path, bool current,
                              JournalImport& journalImport)
{
    files::FileHandle source(path, files::FileHandle::Mode::Read);
    if (!source.isOpen())
        return QFileInfo::exists(path) ? base::Result<void>(unreadable(path))
                                       : base::Result<void>(); // renamed meanwhile
    if (!source.lock(files::FileHandle::Lock::Exclusive))
        return unreadable(path);
    const auto info = source.info();
    if (!info || !info->regular)
        return unreadable(path);
    const auto now = files::FileHandle::infoOf(path);
    if (!now || !(now->id == info->id))
        return {}; // another program has just done it
    const auto text = source.read(0, info->size);
    if (!text)
        return unreadable(path);
    const int before = journalImport.unreadable;
    if (!text->isEmpty()) {
        const auto imported =
            file.transaction([&] { return importText(file, *text, journalImport); });
        if (!imported)
            return imported;
    }
    const QString kept = current ? renameImported(path) : path;
    if (journalImport.unreadable > before)
        unreadableFiles().add(kept, journalImport.unreadable - before);
    return {};
}

/// The renamed files that have grown since; checked without a lock on the database.
base::Result<bool> hasNewLines(const HistoryFile& file, const QFileInfo& renamed)
{
    QFile source(renamed.absoluteFilePath());
    if (!source.open(QIODevice::ReadOnly))
        return false; // it was imported, and the user may move it
    constexpr qint64 maxLineLength = 1 << 20;
    const QByteArray first = source.readLine(maxLineLength);
    const auto known =
        file.run(QStringLiteral("SELECT bytes FROM taken WHERE file = ?"), {firstLineHash(first)});
    if (!known)
        return tl::unexpected(known.error());
    const qint64 imported = known->rows.empty() ? 0 : known->rows.front().value(0).toLongLong();
    if (source.size() <= imported)
        return false;
    source.seek(imported);
    return source.readAll().contains('\n');
}
} // namespace

std::vector<base::Error> importUnreadableJournals()
{
    return unreadableFiles().take();
}

QString legacyJournalPath(const QString& historyPath)
{
    return QFileInfo(historyPath).absolutePath() + QStringLiteral("/journal.jsonl");
}

base::Result<JournalImport> importJournal(const HistoryFile& file)
{
    JournalImport journalImport;
    const QString path = legacyJournalPath(file.path());
    const QFileInfo current(path);
    const QDir folder(current.absolutePath());
    const auto renamed = folder.entryInfoList(
        {current.fileName() + importedSuffix + QLatin1Char('*')}, QDir::Files, QDir::Name);
    for (const QFileInfo& one : renamed) {
        const auto news = hasNewLines(file, one);
        if (!news)
            return tl::unexpected(news.error());
        if (!*news)
            continue;
        if (const auto imported = importFile(file, one.absoluteFilePath(), false, journalImport);
            !imported)
            return tl::unexpected(imported.error());
    }
    if (current.exists()) {
        if (const auto imported = importFile(file, path, true, journalImport); !imported)
            return tl::unexpected(imported.error());
    }
    return journalImport;
}
} // namespace history

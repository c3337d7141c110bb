// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_change_detector.h"

#include "history/history_timeout.h"

namespace history {
/// A connection with exclusive access, as on a full disk, would lock other programs out.
bool HistoryChangeDetector::open()
{
    auto opened = HistoryFile::open(m_path, historyTimeout);
    if (!opened)
        return false;
    const auto mode = (*opened)->run(QStringLiteral("PRAGMA locking_mode"));
    if (!mode || mode->rows.empty() ||
        mode->rows.front().value(0).toString() != QLatin1StringView("normal"))
        return false;
    m_file = std::move(*opened);
    return true;
}

/// SQLite counts the commits of all other connections, per connection.
std::optional<qint64> HistoryChangeDetector::version()
{
    const auto fileInfo = files::FileHandle::infoOf(m_path);
    if (!fileInfo)
        return std::nullopt;
    if (m_file && !(fileInfo->id == m_fileId)) {
        m_file.reset();
        m_lost = true;
    }
    if (!m_file && !open())
        return std::nullopt;
    m_fileId = fileInfo->id;
    const auto asked = m_file->run(QStringLiteral("PRAGMA data_version"));
    if (!asked || asked->rows.empty())
        return std::nullopt;
    return asked->rows.front().value(0).toLongLong();
}

bool HistoryChangeDetector::hasChanged()
{
    const auto now = version();
    if (!now) {
        m_file.reset();
        m_lost = true;
        return false;
    }
    const bool changed = m_lost || (m_version && *now != *m_version);
    m_lost = false;
    m_version = now;
    return changed;
}

void HistoryChangeDetector::close()
{
    m_file.reset();
    m_version.reset();
    m_lost = false;
}
} // namespace history

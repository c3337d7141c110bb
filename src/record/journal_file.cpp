// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/journal_file.h"

#include "record/journal_line.h"

#include <QUuid>

namespace record {
JournalFile::JournalFile(QString path)
    : m_path(std::move(path))
{}

base::Result<QString> JournalFile::begin(const base::Intent& intent)
{
    BeginLine line{intent};
    line.intent.uuid = QUuid::createUuid().toString(QUuid::WithoutBraces);
    if (const auto appended = append(line); !appended)
        return tl::unexpected(appended.error());
    return line.intent.uuid;
}

base::Result<void> JournalFile::end(const QString& uuid, const base::IntentEnd& end)
{
    return append(EndLine{uuid, end});
}

base::Result<std::vector<base::JournalEntry>> JournalFile::entries() const
{
    const std::scoped_lock guard(m_mutex);
    if (const auto fresh = refresh(); !fresh)
        return tl::unexpected(fresh.error());
    return m_state.entries();
}

base::Result<void> JournalFile::keep(const base::ServoIdentity& servo, const QString& name,
                                     const std::vector<std::int64_t>& values)
{
    return append(KeepLine{servo, name, values});
}

base::Result<std::optional<std::vector<std::int64_t>>>
JournalFile::kept(const base::ServoIdentity& servo, const QString& name) const
{
    const std::scoped_lock guard(m_mutex);
    if (const auto fresh = refresh(); !fresh)
        return tl::unexpected(fresh.error());
    return m_state.kept(servo, name);
}

std::vector<JournalWarning> JournalFile::warnings() const
{
    const std::scoped_lock guard(m_mutex);
    return m_state.warnings();
}

base::Result<void> JournalFile::append(const JournalLine& line)
{
    return appendLine(m_path, encodeJournalLine(line, QDateTime::currentDateTimeUtc()));
}

base::Result<void> JournalFile::refresh() const
{
    const auto news = readAppended(m_path, m_mark, m_state.bytesFed());
    if (!news)
        return tl::unexpected(news.error());
    if (news->replaced)
        m_state.clear();
    m_mark = news->mark;
    m_state.feed(news->bytes);
    return {};
}
} // namespace record

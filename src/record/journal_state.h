// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of a journal file amount to, fed line by line as the file grows. A plain value;
// its owner guards it. Never fails: a line it cannot use becomes a warning.
#pragma once

#include "base/journal.h"

#include <QByteArray>
#include <QHash>

namespace record {
struct JournalWarning {
    qint64 line = 0; ///< counted from 1
    QString detail;  ///< untranslated
};

class JournalState {
public:
    void clear();

    /// Takes the next bytes of the file. A line counts when its line feed has come.
    void feed(const QByteArray& bytes);

    qint64 bytesFed() const { return m_bytesFed; }
    const std::vector<base::JournalEntry>& entries() const { return m_entries; }
    std::optional<std::vector<std::int64_t>> kept(const base::ServoIdentity& servo,
                                                  const QString& name) const;
    /// Includes one for an unfinished last line.
    std::vector<JournalWarning> warnings() const;

private:
    void takeLine(const QByteArray& line);
    void warn(const QString& detail);

    std::vector<base::JournalEntry> m_entries;
    QHash<QString, std::size_t> m_entryByUuid;
    QHash<QString, std::vector<std::int64_t>> m_kept;
    std::vector<JournalWarning> m_warnings;
    QByteArray m_unfinished;
    qint64 m_bytesFed = 0;
    qint64 m_lines = 0;
};
} // namespace record

// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's home: a local file of JSON lines that only ever grows. Every call returns after its
// line is on disk; several programs may append to one file. What a crash tore off at the end, and
// lines of a newer program, are passed over and named in warnings(). Any thread. Fails with
// FileUnreadable, FileUnwritable or DiskFull; a failed append leaves no half line behind.
#pragma once

#include "base/journal.h"
#include "record/append_file.h"
#include "record/journal_line.h"
#include "record/journal_state.h"

#include <mutex>

namespace record {
class JournalFile final : public base::Journal {
public:
    /// Nothing is opened or created before the first call.
    explicit JournalFile(QString path);

    base::Result<QString> begin(const base::Intent& intent) override;
    base::Result<void> end(const QString& uuid, const base::IntentEnd& end) override;
    base::Result<std::vector<base::JournalEntry>> entries() const override;
    base::Result<void> keep(const base::ServoIdentity& servo, const QString& name,
                            const std::vector<std::int64_t>& values) override;
    base::Result<std::optional<std::vector<std::int64_t>>> kept(const base::ServoIdentity& servo,
                                                                const QString& name) const override;

    /// Lines that the reading calls so far could not use.
    std::vector<JournalWarning> warnings() const;

    const QString& path() const { return m_path; }

private:
    base::Result<void> append(const JournalLine& line);
    base::Result<void> refresh() const;

    const QString m_path;
    mutable std::mutex m_mutex;
    mutable FileMark m_mark;
    mutable JournalState m_state; ///< what has been read; only what was appended since is parsed
};
} // namespace record

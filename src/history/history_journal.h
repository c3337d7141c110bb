// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's home: the history database. Owned by session::Session; any thread: one connection
// lives on a thread of its own, since SQLite connections of Qt belong to a thread, and whoever
// calls waits for the disk (synchronous = FULL: begin, end and keep answer when it is there). The
// database is opened by the first call that needs it, and opened again where the file was
// replaced. Several programs may use one file. Errors as history/history_file.h: a database that is
// damaged, newer, locked for long or not writable refuses begin(), so no write begins.
//
// From begin() until end() or release() an intent is this program's: other programs see it as under
// way. See history/intent_locks.h.
#pragma once

#include "base/journal.h"
#include "history/history_timeout.h"
#include "history/intent_locks.h"

#include <atomic>
#include <chrono>
#include <memory>

namespace history {
class HistoryJournal final : public base::Journal {
public:
    /// Nothing is opened or created here. `program` is written beside every intent.
    HistoryJournal(QString historyPath, QString program,
                   std::chrono::milliseconds timeout = historyTimeout);
    ~HistoryJournal() override;

    base::Result<QString> begin(const base::Intent& intent) override;
    base::Result<void> end(const QString& uuid, const base::IntentResult& end) override;
    base::Result<std::vector<base::JournalEntry>> entries() const override;
    base::Result<std::vector<base::Intent>> open() const override;
    base::Result<std::vector<base::JournalEntry>> entriesFor(const base::ServoIdentity& servo,
                                                             int limit) const override;
    base::Result<void> saveServoValues(const base::ServoIdentity& servo, const QString& name,
                                       const std::vector<std::int64_t>& values) override;
    base::Result<std::optional<std::vector<std::int64_t>>>
    servoValues(const base::ServoIdentity& servo, const QString& name) const override;

    /// The job is over: what it has left open, any program may settle from now on.
    void release();

    const QString& path() const { return m_path; }
    /// Intents recorded by this object so far. Any thread.
    std::uint64_t intentCount() const { return m_intentCount; }

private:
    class Worker;
    const QString m_path;
    std::atomic<std::uint64_t> m_intentCount{0};
    std::unique_ptr<Worker> m_worker;
    IntentLocks m_locks;
};
} // namespace history

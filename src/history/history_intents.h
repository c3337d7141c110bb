// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's rows in the history: intents with their writes, and facts. Internal to
// history/history_journal.h. The thread of the connection. Errors of history/history_file.h.
#pragma once

#include "history/history_file.h"
#include "history/history_rows.h"

namespace history {
/// These belong inside HistoryFile::together(), which makes them one with what is around them.
/// The number of the servo that answers like this, made if it was never met.
base::Result<std::int64_t> findOrAddServo(const HistoryFile& file,
                                          const base::ServoIdentity& identity);
/// True: from now on the one with this label is meant by those alike; made if it was never met.
base::Result<std::int64_t> makeCurrentServo(const HistoryFile& file,
                                            const base::ServoIdentity& identity,
                                            const QString& label);
/// uuid and time are those of `intent`.
base::Result<void> insertIntent(const HistoryFile& file, const base::Intent& intent,
                                const QString& program);
/// False: there is no such intent.
base::Result<bool> endIntent(const HistoryFile& file, const QString& uuid,
                             const base::IntentResult& end, const QDateTime& at);
base::Result<void> saveFact(const HistoryFile& file, const base::ServoIdentity& servo,
                            const QString& name, const std::vector<std::int64_t>& values,
                            const QDateTime& at);

base::Result<std::optional<std::vector<std::int64_t>>>
loadFact(const HistoryFile& file, const base::ServoIdentity& servo, const QString& name);
/// What follows FROM intents i: a condition and an order. Oldest first.
base::Result<std::vector<base::JournalEntry>>
readEntries(const HistoryFile& file, const QString& whereClause, const QVariantList& values);
/// The latest ones of one servo, and of servos that were changing to its ID.
base::Result<std::vector<base::JournalEntry>>
readServoEntries(const HistoryFile& file, const base::ServoIdentity& servo, int limit);
} // namespace history

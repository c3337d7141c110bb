// SPDX-License-Identifier: GPL-3.0-or-later
// The file journal of earlier versions (journal.jsonl, JSON lines) into the history database. All
// new lines are imported in one transaction, together with the position reached, so that a crash
// changes nothing and two programs at the same time import them once; uuids prevent duplicates.
// Then the file is renamed (journal.jsonl.taken-N), never deleted. A program of an earlier version
// that is still running may append to the renamed file or begin a new one: both are checked again.
// Unreadable lines stay in the file, and are counted and reported. The thread of the connection.
// Errors of history/history_file.h, and FileUnreadable.
#pragma once

#include "history/history_file.h"

#include <vector>

namespace history {
struct JournalImport {
    int lines = 0;      ///< that were new
    int unreadable = 0; ///< of them: torn by a crash, or of a program newer than that version
};

/// "journal.jsonl" beside the database.
QString legacyJournalPath(const QString& historyPath);

/// FileFormat, "journal", one for each imported file with unreadable lines that has not been
/// reported yet, by any connection of this program. Any thread.
std::vector<base::Error> importUnreadableJournals();

/// Cheap where there is nothing to do: it only lists the folder.
base::Result<JournalImport> importJournal(const HistoryFile& file);
} // namespace history

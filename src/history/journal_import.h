// SPDX-License-Identifier: GPL-3.0-or-later
// The file journal of earlier versions (journal.jsonl, JSON lines) into the history database. All
// that is new in it goes in with one transaction, together with how far was read, so that a crash
// in the middle changes nothing and two programs at once do it once; uuids keep what is there from
// coming twice. Then the file is renamed (journal.jsonl.taken-N), never deleted. A program of an
// earlier version that is still running may append to the renamed file or begin a new one: both
// are looked at again. Lines nobody can read stay in the file, and are counted and reported. The
// thread of the connection. Errors of record/history_file.h, and FileUnreadable.
#pragma once

#include "history/history_file.h"

#include <vector>

namespace record {
struct JournalImport {
    int lines = 0;      ///< that were new
    int unreadable = 0; ///< of them: torn by a crash, or of a program newer than that version
};

/// "journal.jsonl" beside the database.
QString legacyJournalPath(const QString& historyPath);

/// FileFormat, "journal", one for each file of which lines could not be read: what this program has
/// taken over so far and nobody has asked for yet, whichever connection did it. Any thread.
std::vector<base::Error> importUnreadableJournals();

/// Cheap where there is nothing to do: one look at the folder.
base::Result<JournalImport> importJournal(const HistoryFile& file);
} // namespace record

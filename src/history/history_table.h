// SPDX-License-Identifier: GPL-3.0-or-later
// A servo's table as it was at a moment between two snapshots: the last snapshot before it, and the
// kept writes after that. Names what it cannot know. Borrows the connection of a history::History
// (its thread). BadArgument "no-snapshot" where none was taken before; else as
// history/history_file.h.
#pragma once

#include "catalog/catalog.h"
#include "history/history_log.h"

namespace history {
/// The ID that the servo had at the moment, and since when: what was written to it under that ID is
/// in the history of the servo with that ID. A servo that had come back to its own ID by then has
/// none, and what was written to it in between is in its table.
struct ChangedId {
    int id = -1;
    QDateTime at{};
};

struct TableState {
    snapshot::Snapshot table{}; ///< `at` is the moment asked for
    HistorySnapshot base{};
    QStringList replayed{}; ///< keys whose value comes from a write after the snapshot
    /// Keys that were changed without a record of the value (centering, stored parameters put back,
    /// interrupted or failed writes, writes that had not ended at the moment): they have no value
    /// in `table`.
    QStringList unknown{};
    /// Keys written until power-off only; `table` has what is stored.
    QStringList temporary{};
    std::optional<ChangedId> changedId{};
};

/// Physical values follow the catalog's profile of that servo; without one they are left out.
base::Result<TableState> tableAt(const HistoryFile& file, const catalog::Catalog& catalog,
                                 std::int64_t servo, const QDateTime& at);
} // namespace history

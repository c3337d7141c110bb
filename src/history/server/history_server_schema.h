// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of the copies on a server. Internal to history/server/history_server.h; its thread and
// errors. Several benches may start at the same time, with programs of several versions: one brings
// the schema up to date while the others wait.
#pragma once

#include "history/history_file.h"

namespace history {
/// Creates or updates the schema; Newer if a later program made it.
base::Result<void> migrateSchema(const HistoryFile& server);
/// Checks that the schema is the one this program reads: Empty, Older, Newer.
base::Result<void> checkSchema(const HistoryFile& server);

/// A table, its columns except number, uuid, bench and references, and its children.
struct ServerTable {
    const char* name;
    QStringList columns;
    bool ofServo = false; ///< has a column `servo`, which a bench names by uuid
    struct Child {
        const char* name;
        const char* parent; ///< column with the parent's number
        const char* order;  ///< column that is unique within the parent
        QStringList columns;
        bool ofServo = false;
        bool ofBench = false; ///< has a column `bench`
    };
    std::vector<Child> children{};
};
/// Referenced tables come first.
const std::vector<ServerTable>& serverTables();
} // namespace history

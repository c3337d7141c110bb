// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of the copies on a server. Internal to record/history_server.h; its thread and errors.
// Several benches may start at the same time, with programs of several versions: one brings the
// schema up to date while the others wait.
#pragma once

#include "history/history_file.h"

namespace record {
/// Makes the schema or brings it up to date; Newer if it is beyond this program.
base::Result<void> migrateSchema(const HistoryFile& server);
/// That it is there, and the one this program reads: Empty, Older, Newer.
base::Result<void> checkSchema(const HistoryFile& server);

/// A table, its columns beside number, uuid, bench and what refers to others, and its children.
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
/// Those others refer to first.
const std::vector<ServerTable>& serverTables();
} // namespace record

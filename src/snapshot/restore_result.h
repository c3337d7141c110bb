// SPDX-License-Identifier: GPL-3.0-or-later
// The result of a restore, row by row, as a file that documents it: JSON or CSV. A plain
// value; any thread. Words are the stable names of device and jobs ("kept", "no-answer"). Fails
// with FileUnwritable, DiskFull.
#pragma once

#include "files/csv_text.h"
#include "snapshot/snapshot.h"

namespace snapshot {
struct RestoreResultRow {
    QString key;
    int address = 0;
    std::optional<std::int64_t> before{};
    std::int64_t newRaw = 0;
    std::optional<std::int64_t> readBack{}; ///< the latest reading
    QString unit{};
    std::optional<double> newValue{}; ///< physical
    QString outcome;                  ///< device::outcomeName()
    QString error{};                  ///< error's name, empty: none
    bool rolledBack = false;          ///< the value before has been proved again
    bool operator==(const RestoreResultRow&) const = default;
};

struct RestoreResult {
    QString program;
    QDateTime at;
    QString source; ///< the snapshot: file or what the user calls it
    QString port;
    int baud = 0;
    SnapshotServo servo{}; ///< as it answers afterwards
    QString verdict;       ///< jobs::verdictName
    QString lock;          ///< "closed", "open", "unknown", "none"
    std::vector<RestoreResultRow> rows{};
    bool operator==(const RestoreResult&) const = default;
};

QByteArray encodeRestoreResults(const std::vector<RestoreResult>& results);
QByteArray encodeRestoreResultsCsv(const std::vector<RestoreResult>& results);

/// CSV where the name ends so, JSON otherwise.
base::Result<void> saveRestoreResults(const std::vector<RestoreResult>& results,
                                      const QString& path,
                                      files::CsvReader reader = files::CsvReader::Program);
} // namespace snapshot

// SPDX-License-Identifier: GPL-3.0-or-later
// Any number of tables side by side: servo, file, factory default, another servo, earlier snapshot.
// Rows are matched by register key. Within one map the raw numbers are compared, between maps the
// physical values. What has no value is unknown, never different. Pure values; any thread; never
// fails.
#pragma once

#include "snapshot/snapshot.h"

namespace snapshot {
enum class CellState : std::uint8_t {
    Known,
    Unknown,   ///< the register is there, its value is not: not read, no default stated
    Missing,   ///< no such register in this table
    NotChosen, ///< a template that leaves this row alone
};

struct CompareCell {
    CellState state = CellState::Missing;
    std::optional<std::int64_t> raw{};
    std::optional<double> value{}; ///< physical
    QString unit{};
    bool operator==(const CompareCell&) const = default;
};

/// The result of a row; in the order of the table.
enum class RowVerdict : std::uint8_t {
    Different, ///< two known values differ
    Missing,   ///< some table has no such register; what is known is alike
    Unknown,   ///< fewer than two values known, or one of several unknown; the known are alike
    Identical,
    ReadOnly, ///< feedback, factory data, identity: never counted as different
};

struct CompareRow {
    QString key;
    int address = 0; ///< from the first table that has it
    catalog::Area area = catalog::Area::Eprom;
    RowVerdict verdict = RowVerdict::Identical;
    bool differs = false;           ///< also for read-only rows
    std::vector<CompareCell> cells; ///< one a table, in the order given
    bool operator==(const CompareRow&) const = default;
};

struct SnapshotComparison {
    std::vector<CompareRow> rows{}; ///< by verdict as above, then by address
    int different = 0;
    int missing = 0;
    int unknown = 0;
    int identical = 0;
    int readOnly = 0;
    bool operator==(const SnapshotComparison&) const = default;
};

/// A row stands in the result if at least two tables (one, where only one is given) have a say in
/// it. Null pointers are not allowed.
SnapshotComparison compareSnapshots(const std::vector<const Snapshot*>& tables);

QString
verdictName(RowVerdict verdict); ///< "different", "missing", "unknown", "identical", "read-only"
QString cellStateName(CellState state); ///< "known", "unknown", "missing", "not-chosen"
} // namespace snapshot

// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/snapshot_compare.h"

#include <QHash>

#include <algorithm>
#include <cmath>

namespace record {
namespace {
CompareCell cellOf(const Snapshot& table, const QString& key)
{
    const SnapshotRegister* reg = table.find(key);
    if (reg == nullptr)
        return {table.isTemplate ? CellState::NotChosen : CellState::Missing};
    return {reg->raw ? CellState::Known : CellState::Unknown, reg->raw, reg->value, reg->unit};
}

/// Beyond the digits a file keeps.
bool sameValue(const CompareCell& a, const CompareCell& b)
{
    constexpr double noise = 1e-9;
    return std::abs(*a.value - *b.value) <=
           noise * std::max(std::abs(*a.value), std::abs(*b.value));
}

/// A register's number means the same wherever the map is the same, unless what decides its scale
/// differs; elsewhere only what it stands for can be compared.
bool haveSameValue(const CompareCell& a, const CompareCell& b, bool sameMap)
{
    if (a.unit != b.unit)
        return false;
    const bool valued = a.value && b.value;
    if (sameMap || !valued)
        return a.raw == b.raw && (!valued || sameValue(a, b));
    return sameValue(a, b);
}

bool hasDifference(const CompareRow& row, const std::vector<const Snapshot*>& tables)
{
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool known =
                row.cells[i].state == CellState::Known && row.cells[j].state == CellState::Known;
            if (known && !haveSameValue(row.cells[i], row.cells[j],
                                        tables[i]->servo.map == tables[j]->servo.map))
                return true;
        }
    }
    return false;
}

int countCells(const CompareRow& row, CellState state)
{
    return static_cast<int>(std::count_if(row.cells.begin(), row.cells.end(),
                                          [&](const auto& cell) { return cell.state == state; }));
}

RowVerdict verdictOf(const CompareRow& row, bool readOnly)
{
    if (readOnly)
        return RowVerdict::ReadOnly;
    if (row.differs)
        return RowVerdict::Different;
    if (countCells(row, CellState::Missing) > 0)
        return RowVerdict::Missing;
    if (countCells(row, CellState::Unknown) > 0)
        return RowVerdict::Unknown;
    return RowVerdict::Identical;
}

/// Every key once, in the order of the first table that has it.
std::vector<const SnapshotRegister*> allRows(const std::vector<const Snapshot*>& tables)
{
    std::vector<const SnapshotRegister*> rows;
    QHash<QString, bool> seen;
    for (const Snapshot* table : tables) {
        for (const SnapshotRegister& reg : table->registers) {
            if (!std::exchange(seen[reg.key], true))
                rows.push_back(&reg);
        }
    }
    return rows;
}

/// Nobody who has this row lets it be written.
bool readOnlyEverywhere(const QString& key, const std::vector<const Snapshot*>& tables)
{
    return std::none_of(tables.begin(), tables.end(), [&](const Snapshot* table) {
        const SnapshotRegister* reg = table->find(key);
        return reg != nullptr && reg->access == catalog::Access::ReadWrite;
    });
}

void count(SnapshotComparison& result, RowVerdict verdict)
{
    switch (verdict) {
    case RowVerdict::Different:
        ++result.different;
        break;
    case RowVerdict::Missing:
        ++result.missing;
        break;
    case RowVerdict::Unknown:
        ++result.unknown;
        break;
    case RowVerdict::Identical:
        ++result.identical;
        break;
    case RowVerdict::ReadOnly:
        ++result.readOnly;
        break;
    }
}
} // namespace

SnapshotComparison compareSnapshots(const std::vector<const Snapshot*>& tables)
{
    SnapshotComparison result;
    const int needed = std::min(2, static_cast<int>(tables.size()));
    for (const SnapshotRegister* reg : allRows(tables)) {
        CompareRow row;
        row.key = reg->key;
        row.address = reg->address;
        row.area = reg->area;
        for (const Snapshot* table : tables)
            row.cells.push_back(cellOf(*table, reg->key));
        if (static_cast<int>(row.cells.size()) - countCells(row, CellState::NotChosen) < needed)
            continue;
        row.differs = hasDifference(row, tables);
        row.verdict = verdictOf(row, readOnlyEverywhere(reg->key, tables));
        count(result, row.verdict);
        result.rows.push_back(std::move(row));
    }
    std::stable_sort(result.rows.begin(), result.rows.end(), [](const auto& a, const auto& b) {
        return std::tie(a.verdict, a.address) < std::tie(b.verdict, b.address);
    });
    return result;
}

QString verdictName(RowVerdict verdict)
{
    switch (verdict) {
    case RowVerdict::Different:
        return QStringLiteral("different");
    case RowVerdict::Missing:
        return QStringLiteral("missing");
    case RowVerdict::Unknown:
        return QStringLiteral("unknown");
    case RowVerdict::Identical:
        return QStringLiteral("identical");
    case RowVerdict::ReadOnly:
        return QStringLiteral("read-only");
    }
    return {};
}

QString cellStateName(CellState state)
{
    switch (state) {
    case CellState::Known:
        return QStringLiteral("known");
    case CellState::Unknown:
        return QStringLiteral("unknown");
    case CellState::Missing:
        return QStringLiteral("missing");
    case CellState::NotChosen:
        return QStringLiteral("not-chosen");
    }
    return {};
}
} // namespace record

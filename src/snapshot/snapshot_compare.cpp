// SPDX-License-Identifier: GPL-3.0-or-later
#include "snapshot/snapshot_compare.h"

#include "base/enum_names.h"

#include <QHash>

#include <algorithm>
#include <cmath>

namespace snapshot {
namespace {
CompareCell cellOf(const Snapshot& table, const QString& key)
{
    const SnapshotRegister* reg = table.find(key);
    if (reg == nullptr)
        return {table.isTemplate ? CellState::NotChosen : CellState::Missing};
    return {reg->raw ? CellState::Known : CellState::Unknown, reg->raw, reg->value, reg->unit};
}

/// Smaller than the last digit in a file.
bool sameValue(const CompareCell& a, const CompareCell& b)
{
    constexpr double noise = 1e-9;
    return std::abs(*a.value - *b.value) <=
           noise * std::max(std::abs(*a.value), std::abs(*b.value));
}

/// Raw numbers have the same meaning within one map, unless registers that determine their scale
/// differ; otherwise only physical values can be compared.
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

/// Read-only in every table that has this row.
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

constexpr base::EnumName<RowVerdict> rowVerdictNames[]{
    {RowVerdict::Different, "different"}, {RowVerdict::Missing, "missing"},
    {RowVerdict::Unknown, "unknown"},     {RowVerdict::Identical, "identical"},
    {RowVerdict::ReadOnly, "read-only"},
};

constexpr base::EnumName<CellState> cellStateNames[]{
    {CellState::Known, "known"},
    {CellState::Unknown, "unknown"},
    {CellState::Missing, "missing"},
    {CellState::NotChosen, "not-chosen"},
};
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
    return base::nameOf(rowVerdictNames, verdict);
}

QString cellStateName(CellState state)
{
    return base::nameOf(cellStateNames, state);
}
} // namespace snapshot

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_model.h"

namespace ui {
namespace {
bool isRightAligned(MemoryColumn column)
{
    return column == MemoryColumn::Address || column == MemoryColumn::Value ||
           column == MemoryColumn::Physical || column == MemoryColumn::Default;
}

/// Found in both languages, whatever the language of the interface.
QString searchText(const MemoryRow& row)
{
    const catalog::Register& reg = *row.reg;
    QStringList parts{QString::number(reg.address),
                      reg.key,
                      reg.name.en,
                      reg.name.zh,
                      reg.help.en,
                      reg.help.zh,
                      row.meaning.name.en,
                      row.meaning.name.zh};
    for (const catalog::NamedValue& value : reg.values)
        parts << value.key << value.name.en << value.name.zh;
    return parts.join(QLatin1Char('\n'));
}

/// A servo with unknown firmware shows its identity and its measurements; one of unclear family
/// shows every byte, since that is the only hint to its family.
bool shownFor(const catalog::Profile& profile, const catalog::Register& reg)
{
    using catalog::Role;
    if (profile.writable || profile.conflict || reg.area == catalog::Area::Feedback || reg.identity)
        return true;
    return reg.role == Role::FirmwareMajor || reg.role == Role::FirmwareMinor ||
           reg.role == Role::ByteOrder || reg.role == Role::ModelMajor ||
           reg.role == Role::ModelMinor;
}

std::vector<MemoryRow> rowsOf(const session::ServoEntry& entry, const RowContext& clock)
{
    std::vector<MemoryRow> rows;
    for (const catalog::Register& reg : entry.servo.profile->registers) {
        if (shownFor(*entry.servo.profile, reg))
            rows.push_back(memoryRow(entry, reg, clock));
    }
    return rows;
}
} // namespace

MemoryModel::MemoryModel(QObject* parent)
    : QAbstractTableModel(parent)
{}

void MemoryModel::setEntry(const session::ServoEntry* entry, const RowContext& clock)
{
    const bool known = entry != nullptr && entry->servo.profile != nullptr;
    std::vector<MemoryRow> fresh = known ? rowsOf(*entry, clock) : std::vector<MemoryRow>();
    const session::ServoRef ref = entry != nullptr ? entry->ref : 0;
    const catalog::ProfilePtr profile = known ? entry->servo.profile : nullptr;
    if (ref != m_ref || profile != m_profile || fresh.size() != m_rows.size()) {
        beginResetModel();
        m_ref = ref;
        // The view closes its editors at the end of the reset, and they use the old registers.
        const catalog::ProfilePtr old = std::exchange(m_profile, profile);
        m_rows = std::move(fresh);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        if (fresh[i].sameAs(m_rows[i]))
            continue;
        m_rows[i] = std::move(fresh[i]);
        const int row = static_cast<int>(i);
        Q_EMIT dataChanged(index(row, 0), index(row, memoryColumns - 1));
    }
}

void MemoryModel::setPhysicalFirst(bool on)
{
    if (on == m_physicalFirst)
        return;
    m_physicalFirst = on;
    emitAllChanged();
}

void MemoryModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, memoryColumns - 1);
    emitAllChanged();
}

void MemoryModel::emitAllChanged()
{
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, memoryColumns - 1));
}

int MemoryModel::rowOf(const QString& key) const
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].reg->key == key)
            return static_cast<int>(i);
    }
    return -1;
}

int MemoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MemoryModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : memoryColumns;
}

QVariant MemoryModel::rawData(const MemoryRow& row, int role) const
{
    switch (role) {
    case KeyRole:
        return row.reg->key;
    case RawRole:
        return row.raw ? QVariant(static_cast<qlonglong>(*row.raw)) : QVariant();
    case StateRole:
        return static_cast<int>(row.state);
    case StaleRole:
        return row.isStale;
    case ChangedRole:
        return row.isChanged();
    case DiffersRole: {
        const auto differs = row.differsFromDefault();
        return differs ? QVariant(*differs) : QVariant();
    }
    case AreaRole:
        return static_cast<int>(row.reg->area);
    case SearchRole:
        return searchText(row);
    default:
        return {};
    }
}

QVariant MemoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const MemoryRow& shown = row(index.row());
    const MemoryColumn column = memoryColumn(index);
    switch (role) {
    case Qt::DisplayRole:
        return memoryText(shown, column, m_physicalFirst);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return memoryTip(shown, column, m_physicalFirst);
    case Qt::EditRole: {
        const auto raw = shown.editValue();
        return raw ? QVariant(static_cast<qlonglong>(*raw)) : QVariant();
    }
    case Qt::TextAlignmentRole:
        return int((isRightAligned(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    default:
        return rawData(shown, role);
    }
}

bool MemoryModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || (flags(index) & Qt::ItemIsEditable) == 0)
        return false;
    bool whole = false;
    const qlonglong raw = value.toLongLong(&whole);
    if (!whole)
        return false;
    Q_EMIT writeRequested(row(index.row()).reg->key, raw, false);
    return true;
}

Qt::ItemFlags MemoryModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemNeverHasChildren;
    const MemoryRow& shown = row(index.row());
    const MemoryColumn column = memoryColumn(index);
    // A plain number has no unit to be typed in: the value column is the place for it.
    const bool hasPhysical = !physicalText(0, *shown.reg, shown.meaning).isEmpty();
    if (shown.isWritable &&
        (column == MemoryColumn::Value || (column == MemoryColumn::Physical && hasPhysical)))
        flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant MemoryModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= memoryColumns)
        return {};
    const auto column = static_cast<MemoryColumn>(section);
    if (role == Qt::DisplayRole)
        return memoryHeader(column);
    if (role == Qt::ToolTipRole)
        return memoryHeaderHelp(column);
    if (role == Qt::TextAlignmentRole)
        return int((isRightAligned(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}
} // namespace ui

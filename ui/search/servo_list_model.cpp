// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/servo_list_model.h"

#include "ui/widgets/rate_text.h"

#include <algorithm>

namespace ui {
using session::ServoRef;

ServoListModel::ServoListModel(const session::ServoRegistry& registry,
                               const catalog::Catalog& catalog, QObject* parent)
    : QAbstractTableModel(parent)
    , m_registry(registry)
    , m_catalog(catalog)
{
    connect(&registry, &session::ServoRegistry::servoAdded, this, &ServoListModel::added);
    connect(&registry, &session::ServoRegistry::servoChanged, this, &ServoListModel::changed);
    connect(&registry, &session::ServoRegistry::tableChanged, this, &ServoListModel::changed);
    connect(&registry, &session::ServoRegistry::servoRemoved, this, &ServoListModel::removed);
    connect(&registry, &session::ServoRegistry::servosCleared, this, &ServoListModel::reload);
    reload();
}

int ServoListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int ServoListModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(ColumnCount);
}

QVariant ServoListModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const ServoRow& row = m_rows[std::size_t(index.row())];
    if (role == RefRole)
        return row.ref;
    if (role == RowRole)
        return QVariant::fromValue(row);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return row.toolTipText();
    if (role != Qt::DisplayRole)
        return {};
    switch (Column(index.column())) {
    case Id:
        return row.id;
    case Model:
        return row.model;
    case Firmware:
        return row.firmware;
    case Map:
        return row.map;
    case Line:
        return row.line;
    case Rate:
        return row.rate;
    case Alarm:
        return row.alarm;
    case LastSeen:
        return row.lastSeen;
    case ColumnCount:
        break;
    }
    return {};
}

QVariant ServoListModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (Column(section)) {
    case Id:
        return tr("ID");
    case Model:
        return tr("Model");
    case Firmware:
        return tr("Firmware");
    case Map:
        return tr("Register map");
    case Line:
        return tr("Bus type");
    case Rate:
        return tr("Baud rate");
    case Alarm:
        return tr("State");
    case LastSeen:
        return tr("Last seen");
    case ColumnCount:
        break;
    }
    return {};
}

ServoRef ServoListModel::refAt(int row) const
{
    return row >= 0 && row < rowCount() ? m_rows[std::size_t(row)].ref : 0;
}

int ServoListModel::rowOf(ServoRef ref) const
{
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
                                    [ref](const ServoRow& row) { return row.ref == ref; });
    return found == m_rows.end() ? -1 : int(found - m_rows.begin());
}

ServoRow ServoListModel::makeRow(ServoRef ref)
{
    const session::ServoEntry* entry = m_registry.servo(ref);
    if (entry == nullptr)
        return {};
    return servoRow(*entry, newerFirmware(entry->servo.profile), m_registry.now(),
                    m_differing.count(ref) != 0);
}

void ServoListModel::setRow(int row, ServoRow now)
{
    if (now == m_rows[std::size_t(row)])
        return;
    m_rows[std::size_t(row)] = std::move(now);
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
}

/// One servo more, or one less, can make others the odd ones.
void ServoListModel::compareFirmware()
{
    std::vector<catalog::ProfilePtr> profiles;
    for (const ServoRow& row : m_rows) {
        const session::ServoEntry* entry = m_registry.servo(row.ref);
        profiles.push_back(entry != nullptr ? entry->servo.profile : nullptr);
    }
    const std::vector<bool> differs = catalog::differingFirmware(profiles);
    std::set<ServoRef> differing;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (differs[i])
            differing.insert(m_rows[i].ref);
    }
    if (differing == m_differing)
        return;
    m_differing = std::move(differing);
    for (int row = 0; row < rowCount(); ++row)
        setRow(row, makeRow(m_rows[std::size_t(row)].ref));
}

const std::optional<catalog::KnownFirmware>&
ServoListModel::newerFirmware(const catalog::ProfilePtr& profile)
{
    const auto [place, isNew] = m_newer.try_emplace(profile);
    if (isNew && profile)
        place->second = m_catalog.newerFirmware(*profile);
    return place->second;
}

void ServoListModel::added(ServoRef ref)
{
    const auto& order = m_registry.order();
    const auto place = std::find(order.begin(), order.end(), ref);
    if (place == order.end() || rowOf(ref) >= 0)
        return;
    const int row = std::min(int(place - order.begin()), rowCount());
    beginInsertRows({}, row, row);
    m_rows.insert(m_rows.begin() + row, makeRow(ref));
    endInsertRows();
    compareFirmware();
}

/// A changed ID or baud rate may move the row; its index and the selection move with it.
void ServoListModel::changed(ServoRef ref)
{
    const int row = rowOf(ref);
    if (row < 0 || m_registry.servo(ref) == nullptr)
        return;
    const QString firmware = m_rows[std::size_t(row)].firmware;
    setRow(row, makeRow(ref));
    if (m_rows[std::size_t(row)].firmware != firmware)
        compareFirmware();
    const auto& order = m_registry.order();
    const int target =
        std::min(int(std::find(order.begin(), order.end(), ref) - order.begin()), rowCount() - 1);
    if (target == row)
        return;
    beginMoveRows({}, row, row, {}, target > row ? target + 1 : target);
    ServoRow moved = std::move(m_rows[std::size_t(row)]);
    m_rows.erase(m_rows.begin() + row);
    m_rows.insert(m_rows.begin() + target, std::move(moved));
    endMoveRows();
}

void ServoListModel::removed(ServoRef ref)
{
    const int row = rowOf(ref);
    if (row < 0)
        return;
    beginRemoveRows({}, row, row);
    m_rows.erase(m_rows.begin() + row);
    endRemoveRows();
    compareFirmware();
}

void ServoListModel::reload()
{
    beginResetModel();
    m_rows.clear();
    for (const ServoRef ref : m_registry.order())
        m_rows.push_back(makeRow(ref));
    endResetModel();
    compareFirmware();
}

void ServoListModel::updateAges()
{
    for (int row = 0; row < rowCount(); ++row) {
        const session::ServoEntry* entry = m_registry.servo(m_rows[std::size_t(row)].ref);
        const QString ago =
            entry != nullptr ? timeAgoText(m_registry.now() - entry->lastSeen) : QString();
        if (ago.isEmpty() || ago == m_rows[std::size_t(row)].lastSeen)
            continue;
        m_rows[std::size_t(row)] = makeRow(entry->ref); // its color may have aged as well
        // The first column as well: the delegate draws the whole row there.
        Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

void ServoListModel::retranslate()
{
    for (ServoRow& row : m_rows)
        row = makeRow(row.ref);
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The servos of the registry as a table, one row per servo, in the order in which they are found.
// The tooltip of each cell contains all its text; the row as a value is under RowRole, for the
// delegate that draws it in two lines. Owned by its panel; main thread.
#pragma once

#include "catalog/catalog.h"
#include "session/servos/servo_registry.h"
#include "ui/widgets/servo_row.h"

#include <QAbstractTableModel>

#include <map>
#include <set>

namespace ui {
class ServoListModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Id, Model, Firmware, Map, Line, Rate, Alarm, LastSeen, ColumnCount };
    enum Roles { RefRole = Qt::UserRole, RowRole };

    ServoListModel(const session::ServoRegistry& registry, const catalog::Catalog& catalog,
                   QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

    session::ServoRef refAt(int row) const;
    int rowOf(session::ServoRef ref) const; ///< -1: not in the list

    /// The times of "last seen" have gone on. An answer that is too old is no longer shown in the
    /// color of a good one.
    void updateAges();
    void retranslate();

private:
    void added(session::ServoRef ref);
    void changed(session::ServoRef ref);
    void removed(session::ServoRef ref);
    void reload();
    ServoRow makeRow(session::ServoRef ref);
    void setRow(int row, ServoRow now);
    void compareFirmware();
    const std::optional<catalog::KnownFirmware>& newerFirmware(const catalog::ProfilePtr& profile);

    const session::ServoRegistry& m_registry;
    const catalog::Catalog& m_catalog;
    std::vector<ServoRow> m_rows;
    std::map<catalog::ProfilePtr, std::optional<catalog::KnownFirmware>>
        m_newer;                             ///< looked up once
    std::set<session::ServoRef> m_differing; ///< by firmware from the others of their model
};
} // namespace ui

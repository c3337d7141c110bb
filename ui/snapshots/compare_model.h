// SPDX-License-Identifier: GPL-3.0-or-later
// Memory tables side by side, one row per register, differing rows first. With a plan, the first
// table is the servo and the second the snapshot that can be written to it: rows then have a tick
// and the reason why they are off. Keeps copies of what it is given; owned by its pane; main
// thread.
#pragma once

#include "jobs/restore/restore_plan.h"
#include "snapshot/snapshot_compare.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <memory>

namespace ui {
/// One column.
struct CompareColumn {
    QString title{};
    QString tip{};
    std::shared_ptr<const snapshot::Snapshot> table{};
    catalog::ProfilePtr profile{}; ///< for names and units; null: as the table has them
};

class CompareModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column : int { Name, Address, FirstTable };
    /// OpenRole: differs, is missing, or is as in the file until power-off only.
    enum Role : int { OpenRole = Qt::UserRole, KeyRole };

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::vector<CompareColumn> tables, std::optional<jobs::RestorePlan> plan);
    void retranslate();

    const snapshot::SnapshotComparison& comparison() const { return m_found; }
    const std::vector<CompareColumn>& tables() const { return m_tables; }
    const std::optional<jobs::RestorePlan>& plan() const { return m_plan; }
    /// The differing rows that the plan can never write, each with its name and the reason; none
    /// without a plan.
    QStringList unrestorableRows() const;
    /// Ticks all rows that can be selected for this reason, or none of them.
    void setAllSelected(jobs::RestoreReason reason, bool on);
    QString nameOf(const QString& key) const; ///< of a register, in the language of the window
    QString formatted(const QString& key, std::int64_t raw) const; ///< as the servo's own

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void selectedRowsChanged(); ///< by setData() or setAllSelected()

private:
    int stateColumn() const { return FirstTable + int(m_tables.size()); }
    const catalog::Register* registerOf(const QString& key) const;
    QString cellText(const snapshot::CompareRow& row, std::size_t table) const;
    QString stateText(const snapshot::CompareRow& row) const;
    QString tip(const snapshot::CompareRow& row, int column) const;
    QVariant toneOf(const snapshot::CompareRow& row, int column) const;
    QVariant checkState(const snapshot::CompareRow& row) const;

    std::vector<CompareColumn> m_tables;
    snapshot::SnapshotComparison m_found;
    std::optional<jobs::RestorePlan> m_plan;
};

/// "12.0 V": the reading that the limit of a row was compared with.
QString readingText(const jobs::RestoreRow& row);
/// "Maximum input voltage: voltage alarm at once …"; the row has an alarm.
QString alarmLine(const CompareModel& model, const jobs::RestoreRow& row);

/// The rows that differ or may differ, or all.
class CompareFilter final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setAll(bool all);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    bool m_all = false;
};
} // namespace ui

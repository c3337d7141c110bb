// SPDX-License-Identifier: GPL-3.0-or-later
// The batch of a commissioning line as a table, the latest servo last: verdict as sign, word and
// color, ID and baud rate before and after, label, remarks. Owned by its view; main thread.
#pragma once

#include "results/commission_batch.h"

#include <QAbstractTableModel>

namespace ui {
class CommissionModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Verdict, Label, Model, Before, After, Written, Voltage, Remarks, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const results::CommissionBatch& batch);
    void retranslate();
    /// Of these rows, or of all if none is given; servos without a label are left out.
    QStringList labels(const QList<int>& rows) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const results::CommissionRow& row, int column) const;
    QString tip(const results::CommissionRow& row) const;

    std::vector<results::CommissionRow> m_rows;
};
} // namespace ui

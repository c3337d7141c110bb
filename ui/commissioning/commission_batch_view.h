// SPDX-License-Identifier: GPL-3.0-or-later
// The servos of a batch as a table, the latest last, with their count, the IDs still to come, and
// their labels for the clipboard. Owned by the commissioning page; main thread.
#pragma once

#include "ui/commissioning/commission_model.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace ui {
class FitColumns;

class CommissionBatchView final : public QWidget {
    Q_OBJECT

public:
    explicit CommissionBatchView(QWidget* parent);

    void show(const results::CommissionBatch& batch);
    /// Those of the entered range; the ones the batch has given are left out here.
    void setIds(const std::vector<int>& ids);

Q_SIGNALS:
    void reportRequested();

private:
    void build();
    void retranslate();
    void showSummary();
    void copyLabels();
    QString idsToComeText() const;

    CommissionModel m_model;
    results::CommissionBatch m_batch;
    std::vector<int> m_ids;
    QLabel* m_title = nullptr;
    QLabel* m_emptyLabel = nullptr;
    FitColumns* m_columns = nullptr;
    QTableView* m_table = nullptr;
    QLabel* m_summary = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_report = nullptr;
};
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The servos of a batch as a table, the latest last, with their count and their labels for the
// clipboard. Owned by the commissioning page; main thread.
#pragma once

#include "ui/commissioning/commission_model.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace ui {
class CommissionBatchView final : public QWidget {
    Q_OBJECT

public:
    explicit CommissionBatchView(QWidget* parent);

    void show(const results::CommissionBatch& batch);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void showSummary();
    void copyLabels();

    CommissionModel m_model;
    results::CommissionBatch m_batch;
    QTableView* m_table = nullptr;
    QLabel* m_summary = nullptr;
    QPushButton* m_copy = nullptr;
};
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The compared tables side by side, the number of rows that differ, and the ticks of the rows to
// restore. Owned by the snapshots page; main thread.
#pragma once

#include "ui/snapshots/compare_model.h"

#include <QWidget>

class QLabel;
class QTableView;
class QToolButton;

namespace ui {
class FitColumns;
class Pill;

class SnapshotPane final : public QWidget {
    Q_OBJECT

public:
    explicit SnapshotPane(QWidget* parent);

    CompareModel& model() { return m_model; }
    QToolButton* columns() const { return m_columns; } ///< its menu is the page's
    /// `emptyText` is shown without a table. `ages`: a line for each servo whose table is not
    /// current.
    void show(const QString& title, std::vector<CompareColumn> tables,
              std::optional<jobs::RestorePlan> plan, const QString& emptyText,
              const QStringList& ages);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void retranslate();
    void showCounts();
    void toggleCheck();

    CompareModel m_model;
    CompareFilter m_filter;
    QLabel* m_title = nullptr;
    QStringList m_ages;
    Pill* m_age = nullptr;
    Pill* m_different = nullptr;
    Pill* m_excluded = nullptr; ///< rows that differ but are never restored
    Pill* m_same = nullptr;
    Pill* m_otherRows = nullptr;
    QToolButton* m_all = nullptr;
    QToolButton* m_columns = nullptr;
    QTableView* m_table = nullptr;
    FitColumns* m_fit = nullptr;
    QLabel* m_emptyLabel = nullptr;
};
} // namespace ui

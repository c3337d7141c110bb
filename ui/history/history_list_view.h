// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the history. While the user has scrolled down, rows that are added above do not move
// what is being read. Its model must outlive it; owned by the history page; main thread.
#pragma once

#include "ui/history/history_table_model.h"

#include <QPersistentModelIndex>
#include <QTableView>

namespace ui {
class FitColumns;

class HistoryListView final : public QTableView {
    Q_OBJECT

public:
    HistoryListView(HistoryTableModel& model, QWidget* parent);

    std::optional<int> selectedRow() const;
    /// After the rows have changed: back to the row that was at the top, and the columns get their
    /// width from the first rows, and again when the first of another day is there.
    void updateAfterChange();

private:
    void saveTopRow(int changedFrom);

    HistoryTableModel& m_model;
    FitColumns* m_columns;
    QPersistentModelIndex m_topRow; ///< the row to keep at the top; none: the list is at its top
    bool m_columnsUnsized = true;   ///< until there are rows
    qsizetype m_timeLength = 0;     ///< of the oldest row's time: an older day takes more letters
};
} // namespace ui

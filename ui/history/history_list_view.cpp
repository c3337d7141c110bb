// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_list_view.h"

#include "ui/common/widget_style.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/tone_delegate.h"

#include <QHeaderView>
#include <QScrollBar>

#include <utility>

namespace ui {
HistoryListView::HistoryListView(HistoryTableModel& model, QWidget* parent)
    : QTableView(parent)
    , m_model(model)
{
    setObjectName(QStringLiteral("historyTable"));
    setModel(&model);
    setItemDelegate(new ToneDelegate(this));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(this);
    m_columns = new FitColumns(this);
    const auto save = [this](const QModelIndex&, int first) { saveTopRow(first); };
    connect(&model, &HistoryTableModel::rowsAboutToBeInserted, this, save);
    connect(&model, &HistoryTableModel::rowsAboutToBeRemoved, this, save);
}

std::optional<int> HistoryListView::selectedRow() const
{
    const QModelIndexList rows = selectionModel()->selectedRows();
    return rows.size() == 1 ? std::optional<int>(rows.front().row()) : std::nullopt;
}

void HistoryListView::saveTopRow(int changedFrom)
{
    const QModelIndex top = indexAt(QPoint(0, 0));
    if (!m_topRow.isValid() && verticalScrollBar()->value() > 0 && changedFrom <= top.row())
        m_topRow = top;
}

void HistoryListView::updateAfterChange()
{
    if (m_topRow.isValid()) {
        const int across = horizontalScrollBar()->value();
        doItemsLayout();
        scrollTo(m_topRow, QAbstractItemView::PositionAtTop);
        horizontalScrollBar()->setValue(across);
        m_topRow = QPersistentModelIndex();
    }
    int section = 0;
    for (const HistoryColumn& column : HistoryFormatter::columns(m_model.kind()))
        setColumnHidden(section++, column.cell == HistoryCell::Detail);
    const bool isEmpty = model()->rowCount() == 0;
    const QModelIndex oldest = model()->index(model()->rowCount() - 1, 0);
    const bool isTimeLonger = oldest.data().toString().size() >
                              std::exchange(m_timeLength, oldest.data().toString().size());
    if ((std::exchange(m_columnsUnsized, isEmpty) || isTimeLonger) && !isEmpty)
        m_columns->fit();
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/fit_columns.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

#include <algorithm>
#include <numeric>
#include <utility>

namespace ui {
namespace {
constexpr int minChars = 6;
}

FitColumns::FitColumns(QTableView* table, int optional)
    : QObject(table)
    , m_table(table)
    , m_optional(optional)
{
    QHeaderView* header = table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Interactive);
    header->setStretchLastSection(true);
    table->viewport()->installEventFilter(this);
    connect(table->model(), &QAbstractItemModel::modelReset, this, &FitColumns::fit);
}

bool FitColumns::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && m_table->viewport()->width() != m_width)
        fit();
    return QObject::eventFilter(watched, event);
}

/// The heading stays readable.
int FitColumns::minWidthOf(int column) const
{
    return std::max(m_table->horizontalHeader()->sectionSizeHint(column),
                    minChars * m_table->fontMetrics().averageCharWidth());
}

/// To the width of the table, as far as possible.
std::vector<int> FitColumns::shortened(std::vector<int> widths) const
{
    int sum = std::accumulate(widths.begin(), widths.end(), 0);
    while (sum > m_width) {
        int widest = -1;
        int next = 0; // as wide as the one after it is enough for the first
        for (int column = 0; column < int(widths.size()); ++column) {
            const int width = widths[std::size_t(column)];
            if (width <= minWidthOf(column))
                continue;
            if (widest < 0 || width > widths[std::size_t(widest)]) {
                next = widest < 0 ? 0 : widths[std::size_t(widest)];
                widest = column;
            } else {
                next = std::max(next, width);
            }
        }
        if (widest < 0)
            break;
        int& width = widths[std::size_t(widest)];
        const int preferred =
            std::max({minWidthOf(widest), std::min(next, width - 1), width - (sum - m_width)});
        sum -= width - preferred;
        width = preferred;
    }
    return widths;
}

void FitColumns::fit()
{
    QHeaderView* header = m_table->horizontalHeader();
    const int count = header->count();
    m_width = m_table->viewport()->width();
    if (count == 0)
        return;
    header->setStretchLastSection(false);
    if (m_optional >= 0)
        header->setSectionHidden(m_optional, false);
    m_table->resizeColumnsToContents();
    std::vector<int> contents;
    for (int column = 0; column < count; ++column)
        contents.push_back(header->isSectionHidden(column) ? 0 : header->sectionSize(column));
    std::vector<int> widths = shortened(contents);
    const bool tooNarrow =
        widths[0] < contents[0] || std::accumulate(widths.begin(), widths.end(), 0) > m_width;
    if (m_optional >= 0 && m_optional < count && tooNarrow) {
        // The keyboard does not move on from a hidden cell.
        const QModelIndex current = m_table->currentIndex();
        if (current.column() == m_optional)
            m_table->selectionModel()->setCurrentIndex(current.siblingAtColumn(0),
                                                       QItemSelectionModel::NoUpdate);
        header->setSectionHidden(m_optional, true);
        contents[std::size_t(m_optional)] = 0;
        widths = shortened(contents);
    }
    for (int column = 0; column < count; ++column) {
        if (!header->isSectionHidden(column))
            header->resizeSection(column, widths[std::size_t(column)]);
    }
    header->setStretchLastSection(true);
}
} // namespace ui

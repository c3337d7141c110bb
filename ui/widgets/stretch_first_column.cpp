// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/stretch_first_column.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

namespace ui {
namespace {
constexpr double minShare = 0.5; ///< of what its texts need
}

StretchFirstColumn::StretchFirstColumn(QTableView* table)
    : QObject(table)
    , m_table(table)
{
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table->viewport()->installEventFilter(this);
    connect(table->horizontalHeader(), &QHeaderView::sectionResized, this,
            [this](int section) { // others have grown or shrunk with their contents
                if (section != 0)
                    distribute();
            });
}

bool StretchFirstColumn::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        distribute();
    return QObject::eventFilter(watched, event);
}

void StretchFirstColumn::distribute()
{
    QHeaderView* header = m_table->horizontalHeader();
    if (m_distributing || header->count() == 0)
        return;
    m_distributing = true;
    int others = 0;
    for (int column = 1; column < header->count(); ++column)
        others += header->isSectionHidden(column) ? 0 : header->sectionSize(column);
    const QAbstractItemView* view = m_table; // a table's own is not for everybody
    const int preferred = std::max(view->sizeHintForColumn(0), header->sectionSizeHint(0));
    const bool room = m_table->viewport()->width() - others >= minShare * preferred;
    const auto mode = room ? QHeaderView::Stretch : QHeaderView::ResizeToContents;
    if (header->sectionResizeMode(0) != mode)
        header->setSectionResizeMode(0, mode);
    m_distributing = false;
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/roomy_column.h"

#include <QEvent>
#include <QHeaderView>
#include <QTableView>

namespace ui {
RoomyColumn::RoomyColumn(QTableView* table)
    : QObject(table)
    , m_table(table)
{
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table->viewport()->installEventFilter(this);
    connect(table->horizontalHeader(), &QHeaderView::sectionResized, this,
            [this](int section) { // others have grown or shrunk with their contents
                if (section != 0)
                    share();
            });
}

bool RoomyColumn::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        share();
    return QObject::eventFilter(watched, event);
}

void RoomyColumn::share()
{
    QHeaderView* header = m_table->horizontalHeader();
    if (m_sharing || header->count() == 0)
        return;
    m_sharing = true;
    int others = 0;
    for (int column = 1; column < header->count(); ++column)
        others += header->isSectionHidden(column) ? 0 : header->sectionSize(column);
    const QAbstractItemView* view = m_table; // a table's own is not for everybody
    const int wanted = std::max(view->sizeHintForColumn(0), header->sectionSizeHint(0));
    const bool room = m_table->viewport()->width() - others >= wanted;
    const auto mode = room ? QHeaderView::Stretch : QHeaderView::ResizeToContents;
    if (header->sectionResizeMode(0) != mode)
        header->setSectionResizeMode(0, mode);
    m_sharing = false;
}
} // namespace ui

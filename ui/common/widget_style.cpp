// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/widget_style.h"

#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTableView>

namespace ui {
void makeCard(QWidget* panel)
{
    panel->setProperty("card", true);
    panel->setAttribute(Qt::WA_StyledBackground); // a plain QWidget paints no style rule by itself
    if (panel->layout() != nullptr)
        panel->layout()->setContentsMargins(cardMargin, cardMargin, cardMargin, cardMargin);
}

void makeTableCard(QWidget* panel)
{
    constexpr int margin = 3; // inside the rounded corners
    makeCard(panel);
    panel->layout()->setContentsMargins(margin, margin, margin, margin);
}

void makeTransparent(QScrollArea* area)
{
    area->setFrameShape(QFrame::NoFrame);
    area->viewport()->setAutoFillBackground(false);
    area->widget()->setAutoFillBackground(false); // setWidget() turns it on
}

void makeHeading(QLabel* label)
{
    label->setProperty("heading", true);
}

void makeEmptyState(QLabel* label)
{
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignCenter);
    label->setForegroundRole(QPalette::PlaceholderText);
}

void makeMainAction(QPushButton* button)
{
    button->setProperty("mainAction", true);
    button->style()->unpolish(button); // one of a button box has its looks already
    button->style()->polish(button);
}

void styleTable(QTableView* table)
{
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setAlternatingRowColors(true);
    table->setWordWrap(false);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + rowPadding);
}
} // namespace ui

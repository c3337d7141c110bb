// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_details.h"

#include "ui/common/widget_style.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int minDetailsWidth = 200;
}

HistoryDetails::HistoryDetails(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_emptyLabel(new QLabel(this))
    , m_rows(new QWidget(this))
    , m_form(new QFormLayout(m_rows))
    , m_buttons(new QVBoxLayout)
{
    setObjectName(QStringLiteral("historyDetails"));
    setMinimumWidth(minDetailsWidth);
    makeHeading(m_title);
    m_title->setObjectName(QStringLiteral("historyTitle"));
    m_title->setWordWrap(true);
    makeEmptyState(m_emptyLabel);
    m_form->setContentsMargins({});
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(m_rows);
    makeTransparent(area);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_title);
    column->addWidget(m_emptyLabel);
    column->addWidget(area, 1);
    column->addLayout(m_buttons);
    makeCard(this);
}

QPushButton* HistoryDetails::addButton(const char* name)
{
    auto* button = new QPushButton(this);
    button->setObjectName(QString::fromLatin1(name));
    m_buttons->addWidget(button);
    return button;
}

void HistoryDetails::show(const HistoryLine* line)
{
    m_title->setVisible(line != nullptr);
    m_emptyLabel->setVisible(line == nullptr);
    m_emptyLabel->setText(tr("Select an entry to see its details."));
    m_title->setText(line != nullptr ? line->title : QString());
    while (m_form->rowCount() > 0)
        m_form->removeRow(0);
    if (line == nullptr)
        return;
    for (const auto& [name, value] : line->details) {
        auto* text = new QLabel(value, m_rows);
        text->setTextFormat(Qt::PlainText);
        text->setWordWrap(true);
        text->setToolTip(value);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        if (name.isEmpty()) {
            m_form->addRow(text);
            continue;
        }
        auto* title = new QLabel(name, m_rows);
        title->setForegroundRole(QPalette::PlaceholderText);
        m_form->addRow(title, text);
    }
}
} // namespace ui

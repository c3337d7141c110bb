// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/checklist_view.h"

#include "text/language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_text.h"

#include <QCheckBox>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int arrowSize = 24;

QLabel* label(QWidget* parent, const QString& text, bool quiet)
{
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setToolTip(text);
    if (quiet)
        label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}
} // namespace

ChecklistView::ChecklistView(QWidget* parent)
    : QWidget(parent)
    , m_column(new QVBoxLayout(this))
    , m_wider(new QPushButton(this))
{
    setObjectName(QStringLiteral("checklist"));
    m_wider->setObjectName(QStringLiteral("searchWider"));
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_wider);
    connect(m_wider, &QPushButton::clicked, this, &ChecklistView::fullSearchRequested);
    retranslate();
}

void ChecklistView::retranslate()
{
    setButtonText(m_wider, tr("Search everything"),
                  tr("Searches all IDs at all baud rates in all protocols; writes nothing"));
}

void ChecklistView::show(const SearchFacts& facts)
{
    m_facts = facts;
    m_ticked.clear();
    fill();
}

void ChecklistView::fill()
{
    m_wider->setVisible(canSearchWider(m_facts));
    delete m_content;
    m_content = new QWidget(this);
    auto* column = new QVBoxLayout(m_content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(10);
    for (const AdviceRow& row : searchAdvice(m_facts))
        column->addWidget(rowWidget(row));
    column->addStretch(1);
    m_column->addWidget(m_content, 1);
}

QWidget* ChecklistView::rowWidget(const AdviceRow& row)
{
    auto* widget = new QWidget(m_content);
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    const QString symptom = text::localized(row.symptom);
    auto* heading = new QToolButton(widget);
    heading->setObjectName(QStringLiteral("checklistRow%1").arg(row.number));
    heading->setToolButtonStyle(Qt::ToolButtonIconOnly);
    heading->setAutoRaise(true);
    heading->setFixedSize(arrowSize, arrowSize);
    heading->setCheckable(true);
    heading->setChecked(row.matches);
    heading->setArrowType(row.matches ? Qt::DownArrow : Qt::RightArrow);
    heading->setAccessibleName(symptom);
    heading->setToolTip(tr("Shows or hides the possible cause"));
    QLabel* words = label(widget, symptom, !row.matches);
    QFont bold = words->font();
    bold.setBold(row.matches);
    words->setFont(bold);
    auto* top = new QHBoxLayout;
    top->addWidget(heading, 0, Qt::AlignTop);
    top->addWidget(words, 1);
    column->addLayout(top);
    auto* items = new QWidget(widget);
    auto* list = new QVBoxLayout(items);
    list->setContentsMargins(4, 0, 0, 0);
    for (const AdviceItem& item : row.items)
        list->addWidget(itemWidget(item, row.number));
    items->setVisible(row.matches);
    column->addWidget(items);
    connect(heading, &QToolButton::toggled, items, [items, heading](bool open) {
        items->setVisible(open);
        heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
    return widget;
}

/// Ruled out: a tick and the reason, gray. Else a box to tick off, the cause and what to look at.
QWidget* ChecklistView::itemWidget(const AdviceItem& item, int row)
{
    const bool chinese = text::isUiChinese();
    auto* widget = new QWidget(m_content);
    auto* line = new QHBoxLayout(widget);
    line->setContentsMargins(0, 0, 0, 0);
    auto* column = new QVBoxLayout;
    column->setSpacing(1);
    const QString cause = item.cause.in(chinese);
    const QString finding = item.finding.in(chinese);
    if (item.ruledOut) {
        auto* sign = label(widget, QStringLiteral("✓"), true);
        sign->setAccessibleName(tr("ruled out"));
        sign->setToolTip(tr("ruled out"));
        line->addWidget(sign, 0, Qt::AlignTop);
        column->addWidget(label(widget, tr("Ruled out: %1").arg(cause), true));
        column->addWidget(label(widget, finding, true));
    } else {
        auto* box = new QCheckBox(widget);
        box->setObjectName(QStringLiteral("check%1_%2").arg(row).arg(item.key));
        box->setAccessibleName(cause);
        box->setChecked(m_ticked.count(box->objectName()) != 0);
        connect(box, &QCheckBox::toggled, this, [this, box](bool on) {
            if (on)
                m_ticked.insert(box->objectName());
            else
                m_ticked.erase(box->objectName());
        });
        box->setToolTip(tr("Mark the items you have checked"));
        line->addWidget(box, 0, Qt::AlignTop);
        column->addWidget(label(widget, cause, false));
        column->addWidget(label(widget, item.check.in(chinese), true));
        if (!finding.isEmpty())
            column->addWidget(label(widget, QStringLiteral("→ ") + finding, false));
    }
    line->addLayout(column, 1);
    return widget;
}

void ChecklistView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    retranslate();
    if (m_content != nullptr)
        fill();
}
} // namespace ui

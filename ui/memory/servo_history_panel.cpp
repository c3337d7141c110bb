// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/servo_history_panel.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"

#include <QLabel>
#include <QListView>
#include <QVBoxLayout>

namespace ui {
ServoHistoryPanel::ServoHistoryPanel(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_emptyLabel(new QLabel(this))
    , m_list(new QListView(this))
{
    setObjectName(QStringLiteral("historyPanel"));
    m_list->setObjectName(QStringLiteral("historyList"));
    m_list->setModel(&m_model);
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_emptyLabel->setWordWrap(true);
    makeHeading(m_title);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_emptyLabel, 1, Qt::AlignTop);
    layout->addWidget(m_list, 1);
    followLanguage(this, [this] { retranslate(); });
}

void ServoHistoryPanel::setEntry(const session::ServoEntry* entry)
{
    m_hasServo = entry != nullptr;
    m_model.setEntry(entry);
    updateVisibility();
}

void ServoHistoryPanel::updateVisibility()
{
    const bool empty = m_model.rowCount() == 0;
    m_emptyLabel->setText(m_hasServo
                              ? tr("No writes to this servo have been recorded. Servos are "
                                   "identified by model, firmware and ID.")
                              : tr("Select a servo on the left to see what was written to it."));
    m_emptyLabel->setVisible(empty);
    m_list->setVisible(!empty);
}

void ServoHistoryPanel::retranslate()
{
    m_title->setText(tr("History of this servo"));
    m_list->setAccessibleName(m_title->text());
    m_list->setToolTip(
        tr("Writes to this servo, newest first, including those made under its earlier IDs"));
    m_model.retranslate();
    updateVisibility();
}
} // namespace ui

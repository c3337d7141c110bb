// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/message_line.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {
MessageLine::MessageLine(const session::ServoRegistry& registry, QWidget* parent)
    : QWidget(parent)
    , m_registry(registry)
    , m_symbol(new QLabel(this))
    , m_text(new QLabel(this))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 0, 0);
    row->addWidget(m_symbol);
    row->addWidget(m_text, 1);
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setMinimumWidth(80);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    fill();
}

void MessageLine::show(const session::Event& event)
{
    if (describe(event, m_registry).message.isEmpty())
        return;
    m_event = event;
    fill();
}

void MessageLine::fill()
{
    m_eventText =
        m_event ? describe(*m_event, m_registry) : EventText{tr("Ready"), {}, Tone::Quiet, {}};
    m_symbol->setText(m_eventText.symbol);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(m_eventText.tone, palette()));
    m_symbol->setPalette(colors);
    m_text->setToolTip(
        (QStringList{m_eventText.message} + m_eventText.details).join(QLatin1Char('\n')));
    m_text->setAccessibleName(tr("Latest message"));
    m_text->setAccessibleDescription(m_text->toolTip());
    elide();
}

/// The remedy follows the sentence if there is space.
void MessageLine::elide()
{
    const QString all =
        (QStringList{m_eventText.message} + m_eventText.details).join(QStringLiteral("  —  "));
    m_text->setText(m_text->fontMetrics().elidedText(all, Qt::ElideRight, m_text->width()));
}

void MessageLine::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        fill();
}

void MessageLine::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    elide();
}
} // namespace ui

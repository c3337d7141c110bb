// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/task_result.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {
namespace {
constexpr int signWidth = 18;
constexpr int gap = 8;

QString signFor(Tone tone)
{
    switch (tone) {
    case Tone::Good:
        return QStringLiteral("✓");
    case Tone::Warn:
        return QStringLiteral("⚠");
    case Tone::Bad:
        return QStringLiteral("✗");
    case Tone::Quiet:
    case Tone::Accent:
        break;
    }
    return QStringLiteral("…");
}

QLabel* textLabel(QWidget* parent, const char* name, int width)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setFixedWidth(width);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}
} // namespace

TaskResult::TaskResult(int width, QWidget* parent)
    : QWidget(parent)
    , m_sign(new QLabel(this))
    , m_headline(textLabel(this, "resultWhat", width - signWidth - gap))
    , m_details(textLabel(this, "resultMore", width - signWidth - gap))
{
    setObjectName(QStringLiteral("taskResult"));
    m_sign->setObjectName(QStringLiteral("resultSign"));
    m_sign->setFixedWidth(signWidth);
    QFont bold = font();
    bold.setBold(true);
    m_headline->setFont(bold);
    m_sign->setFont(bold);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_headline);
    words->addWidget(m_details);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(gap);
    row->addWidget(m_sign, 0, Qt::AlignTop);
    row->addLayout(words);
    hide();
}

void TaskResult::showResult(Wording wording)
{
    m_wording = std::move(wording);
    fill();
    show();
}

void TaskResult::clear()
{
    m_wording = {};
    m_text = {};
    hide();
}

void TaskResult::fill()
{
    if (!m_wording)
        return;
    m_text = m_wording();
    m_sign->setText(signFor(m_text.tone));
    m_headline->setText(m_text.message);
    m_details->setText(m_text.details.join(QLatin1Char('\n')));
    m_details->setVisible(!m_text.details.isEmpty());
    setAccessibleName(m_text.message);
    updateColors();
}

/// The sign has the same meaning as the color.
void TaskResult::updateColors()
{
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText, tone(m_text.tone, this->palette()));
    m_sign->setPalette(palette);
    m_headline->setPalette(m_text.tone == Tone::Quiet ? this->palette() : palette);
}

void TaskResult::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        fill();
    else if (event->type() == QEvent::PaletteChange && m_wording)
        updateColors();
}
} // namespace ui

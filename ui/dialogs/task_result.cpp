// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/task_result.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {
namespace {
constexpr int signWidth = 18;
constexpr int gap = 8;

QString signOf(Tone tone)
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
    , m_what(textLabel(this, "resultWhat", width - signWidth - gap))
    , m_more(textLabel(this, "resultMore", width - signWidth - gap))
{
    setObjectName(QStringLiteral("taskResult"));
    m_sign->setObjectName(QStringLiteral("resultSign"));
    m_sign->setFixedWidth(signWidth);
    QFont bold = font();
    bold.setBold(true);
    m_what->setFont(bold);
    m_sign->setFont(bold);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_what);
    words->addWidget(m_more);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(gap);
    row->addWidget(m_sign, 0, Qt::AlignTop);
    row->addLayout(words);
    hide();
}

void TaskResult::tell(Wording wording)
{
    m_wording = std::move(wording);
    fill();
    show();
}

void TaskResult::clear()
{
    m_wording = {};
    m_told = {};
    hide();
}

void TaskResult::fill()
{
    if (!m_wording)
        return;
    m_told = m_wording();
    m_sign->setText(signOf(m_told.tone));
    m_what->setText(m_told.what);
    m_more->setText(m_told.more.join(QLatin1Char('\n')));
    m_more->setVisible(!m_told.more.isEmpty());
    setAccessibleName(m_told.what);
    colour();
}

/// The sign says it as well, so the colour is never alone.
void TaskResult::colour()
{
    QPalette palette = this->palette();
    palette.setColor(QPalette::WindowText, tone(m_told.tone, this->palette()));
    m_sign->setPalette(palette);
    m_what->setPalette(m_told.tone == Tone::Quiet ? this->palette() : palette);
}

void TaskResult::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        fill();
    else if (event->type() == QEvent::PaletteChange && m_wording)
        colour();
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/task_status.h"

#include "session/tasks/task_queue.h"
#include "text/language.h"
#include "text/progress_text.h"
#include "ui/app/event_text.h"
#include "ui/widgets/thin_progress.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {
namespace {
constexpr auto shownAfter = std::chrono::seconds(1);
constexpr int permille = 1000;
constexpr int barWidth = 80;
} // namespace

TaskStatus::TaskStatus(const session::TaskQueue& tasks, QAction* stop, QWidget* parent)
    : QWidget(parent)
    , m_tasks(tasks)
    , m_text(new QLabel(this))
    , m_bar(new ThinProgress(this))
    , m_stop(new QToolButton(this))
{
    setObjectName(QStringLiteral("taskStatus"));
    m_text->setObjectName(QStringLiteral("taskStatusText"));
    m_text->setTextFormat(Qt::PlainText);
    m_bar->setObjectName(QStringLiteral("taskStatusBar"));
    m_bar->setFixedWidth(barWidth);
    m_bar->setRange(0, permille);
    m_stop->setObjectName(QStringLiteral("taskStatusStop"));
    m_stop->setDefaultAction(stop);
    m_stop->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_stop->setAutoRaise(true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 0, 8, 0);
    row->addWidget(m_text);
    row->addWidget(m_bar);
    row->addWidget(m_stop);
    hide();
    m_delay.setSingleShot(true);
    m_delay.setInterval(shownAfter);
    const auto nameStop = [this, stop] { m_stop->setAccessibleName(stop->iconText()); };
    connect(stop, &QAction::changed, this, nameStop);
    nameStop();
    connect(&m_delay, &QTimer::timeout, this, &TaskStatus::showTask);
    connect(&tasks, &session::TaskQueue::taskChanged, this, &TaskStatus::taskChanged);
    connect(&tasks, &session::TaskQueue::taskProgress, this, &TaskStatus::showProgress);
}

void TaskStatus::taskChanged()
{
    if (m_tasks.runningName().isEmpty()) {
        m_delay.stop();
        m_progress.reset();
        hide();
    } else if (isHidden() && !m_delay.isActive()) {
        m_delay.start();
    }
}

void TaskStatus::showProgress(const jobs::Progress& progress)
{
    m_progress = progress;
    if (!isHidden())
        showText();
}

void TaskStatus::showTask()
{
    showText();
    show();
}

void TaskStatus::showText()
{
    QString words = text::capitalized(taskLabel(m_tasks.runningName()));
    if (m_progress) {
        words +=
            QStringLiteral(" · ") + text::progressText(m_progress->fraction, m_progress->remaining);
        m_bar->setValue(int(m_progress->fraction * permille));
    }
    m_bar->setVisible(m_progress.has_value());
    m_text->setText(words);
    m_bar->setAccessibleName(words);
    m_bar->setToolTip(words);
}

void TaskStatus::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && !isHidden())
        showText();
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_dialog.h"

#include "text/translate.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
using session::Desk;
using text::translate;

namespace {
constexpr int permille = 1000;
} // namespace

TaskDialog::TaskDialog(Desk& desk, session::ServoRef servo, const char* name, QWidget* parent)
    : QDialog(parent)
    , m_desk(desk)
    , m_ref(servo)
    , m_servoLabel(new QLabel(this))
    , m_explanation(textLabel("explanation"))
    , m_body(new QVBoxLayout)
    , m_progress(new QProgressBar(this))
    , m_result(new TaskResult(textWidth, this))
{
    setObjectName(QLatin1String(name));
    setAttribute(Qt::WA_DeleteOnClose);
    m_servoLabel->setObjectName(QStringLiteral("who"));
    m_servoLabel->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    m_servoLabel->setFont(bold);
    m_progress->setObjectName(QStringLiteral("taskProgress"));
    m_progress->setTextVisible(false);
    m_progress->hide();
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint); // fit() does it
    column->setSpacing(12);
    column->addWidget(m_servoLabel);
    column->addWidget(m_explanation);
    column->addLayout(m_body);
    column->addWidget(m_progress);
    column->addWidget(m_result);
    buildButtons(column);
    const auto gone = [this](session::ServoRef ref) {
        if (ref == m_ref)
            reject();
    };
    const auto changed = [this](session::ServoRef ref) {
        if (ref != m_ref || entry() == nullptr)
            return;
        retranslateCommon();
        refresh();
    };
    connect(&desk, &Desk::servoRemoved, this, gone);
    connect(&desk, &Desk::servosCleared, this, &QDialog::reject);
    connect(&desk, &Desk::servoChanged, this, changed);
    connect(&desk, &Desk::linkChanged, this, [this] { updateButtons(); });
    connect(&desk, &Desk::taskProgress, this, &TaskDialog::showProgress);
}

void TaskDialog::buildButtons(QVBoxLayout* column)
{
    auto* row = new QHBoxLayout;
    m_stop = new QPushButton(this);
    m_stop->setObjectName(QStringLiteral("taskStop"));
    m_close = new QPushButton(this);
    m_close->setObjectName(QStringLiteral("taskClose"));
    m_action = new QPushButton(this);
    m_action->setObjectName(QStringLiteral("taskAction"));
    m_action->setProperty("mainAction", true);
    row->addWidget(m_stop);
    row->addStretch();
    row->addWidget(m_close);
    row->addWidget(m_action);
    column->addLayout(row);
    for (QPushButton* button : {m_stop, m_close, m_action})
        button->setAutoDefault(false);
    m_action->setDefault(true);
    m_stop->hide();
    connect(m_stop, &QPushButton::clicked, &m_desk, &Desk::stopTask);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_action, &QPushButton::clicked, this, [this] {
        if (m_ready && !m_running && entry() != nullptr)
            runAction();
    });
}

QLabel* TaskDialog::textLabel(const char* name)
{
    auto* label = new QLabel(this);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setFixedWidth(textWidth);
    return label;
}

void TaskDialog::finishSetup()
{
    retranslateCommon();
    retranslate();
    refresh();
    updateButtons();
    setMinimumWidth(sizeHint().width());
    fitToContents();
}

/// As high as its words need, which change while it is open.
void TaskDialog::fitToContents()
{
    const QSize preferred = sizeHint();
    resize(std::max(width(), preferred.width()), preferred.height());
}

bool TaskDialog::event(QEvent* event)
{
    const bool handled = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest)
        fitToContents();
    return handled;
}

void TaskDialog::retranslateCommon()
{
    if (entry() != nullptr)
        m_servoLabel->setText(servoTitle(*entry()));
    m_stop->setText(translate("ServoTasks", "Stop"));
    m_stop->setAccessibleName(m_stop->text());
    m_stop->setToolTip(translate("ServoTasks", "End it now; what has begun ends safely first"));
    m_close->setText(translate("ServoTasks", "Close"));
    m_close->setAccessibleName(m_close->text());
    m_close->setToolTip(
        translate("ServoTasks", "Close this dialog; what is running goes on to its end"));
    m_progress->setAccessibleName(translate("ServoTasks", "Progress"));
    m_progress->setToolTip(translate("ServoTasks", "Progress"));
}

void TaskDialog::setTexts(const QString& title, const QString& explanation,
                          const QString& actionText, const QString& actionTip)
{
    setWindowTitle(title);
    setAccessibleName(title);
    m_explanation->setText(explanation);
    m_explanation->setVisible(!explanation.isEmpty());
    m_action->setText(actionText);
    m_action->setAccessibleName(actionText);
    m_action->setToolTip(actionTip);
    m_action->setVisible(!actionText.isEmpty());
}

void TaskDialog::setReady(bool ready)
{
    m_ready = ready;
    updateButtons();
}

void TaskDialog::setRunning(bool running)
{
    m_running = running;
    if (running) {
        m_result->clear();
        m_progress->setRange(0, 0);
    }
    updateButtons();
}

void TaskDialog::updateButtons()
{
    m_progress->setVisible(m_running);
    m_stop->setVisible(m_running);
    m_action->setEnabled(m_ready && !m_running && m_desk.state() == session::LinkState::Open);
}

void TaskDialog::showProgress(const jobs::Progress& progress)
{
    if (!m_running)
        return;
    m_progress->setRange(0, permille);
    m_progress->setValue(static_cast<int>(progress.fraction * permille));
}

void TaskDialog::run(session::Task task, std::function<void(const session::TaskCompletion&)> done)
{
    setRunning(true);
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskCompletion& end) {
        setRunning(false);
        if (entry() != nullptr)
            done(end);
    };
    m_desk.perform(m_ref, std::move(task));
}

void TaskDialog::runInBackground(session::Task task,
                                 std::function<void(const session::TaskCompletion&)> done)
{
    task.quiet = true;
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskCompletion& end) {
        if (entry() != nullptr)
            done(end);
    };
    m_desk.perform(m_ref, std::move(task));
}

void TaskDialog::showError(const base::Error& error)
{
    showResult([error] { return errorText(error); });
}

void TaskDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || m_action == nullptr)
        return;
    retranslateCommon();
    retranslate();
    refresh();
}
} // namespace ui

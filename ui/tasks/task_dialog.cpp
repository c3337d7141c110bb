// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_dialog.h"

#include "text/progress_text.h"
#include "text/translate.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/thin_progress.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
using session::Workbench;
using text::translate;

namespace {
constexpr int permille = 1000;
} // namespace

TaskDialog::TaskDialog(Workbench& workbench, session::ServoRef servo, const char* name,
                       QWidget* parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_ref(servo)
    , m_servoLabel(new QLabel(this))
    , m_explanation(textLabel("explanation"))
    , m_body(new QVBoxLayout)
    , m_progress(new ThinProgress(this))
    , m_state(textLabel("taskState"))
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
    m_progress->setRange(0, permille);
    m_progress->hide();
    m_state->hide();
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint); // fitToContents() does it
    column->setSpacing(12);
    column->addWidget(m_servoLabel);
    column->addWidget(m_explanation);
    column->addLayout(m_body);
    column->addWidget(m_progress);
    column->addWidget(m_state);
    column->addWidget(m_result);
    buildButtons(column);
    connectWorkbench();
}

void TaskDialog::connectWorkbench()
{
    const auto removed = [this](session::ServoRef ref) {
        if (ref == m_ref)
            reject();
    };
    const auto changed = [this](session::ServoRef ref) {
        if (ref != m_ref || entry() == nullptr)
            return;
        retranslateCommon();
        refresh();
    };
    connect(&m_workbench.registry(), &session::ServoRegistry::servoRemoved, this, removed);
    connect(&m_workbench.registry(), &session::ServoRegistry::servosCleared, this,
            &QDialog::reject);
    connect(&m_workbench.registry(), &session::ServoRegistry::servoChanged, this, changed);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            [this] { updateButtons(); });
    connect(&m_workbench.tasks(), &session::TaskQueue::taskProgress, this,
            &TaskDialog::showProgress);
    connect(&m_workbench, &Workbench::eventOccurred, this, &TaskDialog::onWritten);
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
    makeMainAction(m_action);
    row->addWidget(m_stop);
    row->addStretch();
    row->addWidget(m_close);
    row->addWidget(m_action);
    column->addLayout(row);
    for (QPushButton* button : {m_stop, m_close, m_action})
        button->setAutoDefault(false);
    m_action->setDefault(true);
    m_stop->hide();
    connect(m_stop, &QPushButton::clicked, this, [this] {
        m_wasStopped = true;
        m_workbench.tasks().stop();
    });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_action, &QPushButton::clicked, this, [this] {
        if (!m_ready || m_running || !isServoThere())
            return;
        m_wasStopped = false;
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

/// As high as its texts need, which change while it is open.
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
    updateServoText();
    m_servoLabel->setVisible(m_ref != 0);
    setButtonText(
        m_stop, translate("ServoTasks", "Stop"),
        translate("ServoTasks", "Stops as soon as the current step has been safely completed"));
    setButtonText(m_close, translate("ServoTasks", "Close"), closeTip());
    m_progress->setAccessibleName(translate("ServoTasks", "Progress"));
    m_progress->setToolTip(translate("ServoTasks", "Progress"));
}

void TaskDialog::updateServoText()
{
    if (entry() != nullptr)
        m_servoLabel->setText(servoText());
}

QString TaskDialog::servoText() const
{
    return servoTitle(*entry());
}

QString TaskDialog::closeTip() const
{
    return translate("ServoTasks", "Closes this dialog; the operation in progress continues");
}

QString TaskDialog::progressText(const jobs::Progress& progress) const
{
    return text::progressText(progress.fraction, progress.remaining);
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
        m_state->setText(translate("ServoTasks", "Working…"));
    }
    m_progress->hide();
    updateButtons();
}

void TaskDialog::updateButtons()
{
    m_state->setVisible(m_running);
    m_stop->setVisible(m_running);
    m_action->setEnabled(m_ready && !m_running &&
                         m_workbench.link().state() == session::LinkState::Open);
}

void TaskDialog::showProgress(const jobs::Progress& progress)
{
    if (!m_running)
        return;
    m_progress->setValue(static_cast<int>(progress.fraction * permille));
    m_progress->show();
    m_state->setText(progressText(progress));
}

void TaskDialog::run(session::Task task, std::function<void(const session::TaskCompletion&)> done)
{
    run(m_ref, std::move(task), std::move(done));
}

void TaskDialog::run(session::ServoRef ref, session::Task task,
                     std::function<void(const session::TaskCompletion&)> done)
{
    setRunning(true);
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskCompletion& end) {
        setRunning(false);
        if (isServoThere())
            done(end);
    };
    m_workbench.tasks().perform(ref, std::move(task));
}

void TaskDialog::runInBackground(session::Task task,
                                 std::function<void(const session::TaskCompletion&)> done)
{
    task.quiet = true;
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskCompletion& end) {
        if (isServoThere())
            done(end);
    };
    m_workbench.tasks().perform(m_ref, std::move(task));
}

void TaskDialog::writeRegister(const catalog::Register& reg, std::int64_t raw, const char* success)
{
    m_writtenKey = reg.key;
    m_writeSuccess = success;
    setRunning(true);
    session::WriteRequest request;
    request.items = {{reg.key, raw}};
    request.consent = device::Consent::confirmed();
    m_workbench.writes().write(m_ref, request);
}

/// Writes have no callback: ours has ended when no write of the register is pending any more.
void TaskDialog::onWritten(const session::Event& event)
{
    const session::ServoEntry* own = entry();
    if (m_writtenKey.isEmpty() || event.kind != session::Event::Kind::Written ||
        event.servo != m_ref || own == nullptr)
        return;
    const auto write = own->writes.find(m_writtenKey);
    if (write != own->writes.end() && write->second.pending > 0)
        return;
    m_writtenKey.clear();
    setRunning(false);
    refresh();
    if (event.error)
        showError(*event.error);
    if (!event.report)
        return;
    showResult([this, report = *event.report, notices = event.notices] {
        TaskText result = writeText(*entry(), report, translate("ServoTasks", m_writeSuccess));
        result.details += noticeLines(notices);
        return result;
    });
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

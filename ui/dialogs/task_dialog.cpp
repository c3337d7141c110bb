// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/task_dialog.h"

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
    , m_who(new QLabel(this))
    , m_explanation(textLabel("explanation"))
    , m_body(new QVBoxLayout)
    , m_progress(new QProgressBar(this))
    , m_result(new TaskResult(textWidth, this))
{
    setObjectName(QLatin1String(name));
    setAttribute(Qt::WA_DeleteOnClose);
    m_who->setObjectName(QStringLiteral("who"));
    m_who->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    m_who->setFont(bold);
    m_progress->setObjectName(QStringLiteral("taskProgress"));
    m_progress->setTextVisible(false);
    m_progress->hide();
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint); // fit() does it
    column->setSpacing(12);
    column->addWidget(m_who);
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
        translateOwn();
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
    m_deed = new QPushButton(this);
    m_deed->setObjectName(QStringLiteral("taskDeed"));
    m_deed->setProperty("mainAction", true);
    row->addWidget(m_stop);
    row->addStretch();
    row->addWidget(m_close);
    row->addWidget(m_deed);
    column->addLayout(row);
    for (QPushButton* button : {m_stop, m_close, m_deed})
        button->setAutoDefault(false);
    m_deed->setDefault(true);
    m_stop->hide();
    connect(m_stop, &QPushButton::clicked, &m_desk, &Desk::stopTask);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_deed, &QPushButton::clicked, this, [this] {
        if (m_ready && !m_running && entry() != nullptr)
            act();
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

void TaskDialog::begin()
{
    translateOwn();
    retranslate();
    refresh();
    updateButtons();
    setMinimumWidth(sizeHint().width());
    fit();
}

/// As high as its words need, which change while it is open.
void TaskDialog::fit()
{
    const QSize wanted = sizeHint();
    resize(std::max(width(), wanted.width()), wanted.height());
}

bool TaskDialog::event(QEvent* event)
{
    const bool handled = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest)
        fit();
    return handled;
}

void TaskDialog::translateOwn()
{
    if (entry() != nullptr)
        m_who->setText(servoTitle(*entry()));
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

void TaskDialog::setWords(const QString& title, const QString& explanation, const QString& deed,
                          const QString& deedTip)
{
    setWindowTitle(title);
    setAccessibleName(title);
    m_explanation->setText(explanation);
    m_explanation->setVisible(!explanation.isEmpty());
    m_deed->setText(deed);
    m_deed->setAccessibleName(deed);
    m_deed->setToolTip(deedTip);
    m_deed->setVisible(!deed.isEmpty());
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
    m_deed->setEnabled(m_ready && !m_running && m_desk.state() == session::LinkState::Open);
}

void TaskDialog::showProgress(const jobs::Progress& progress)
{
    if (!m_running)
        return;
    m_progress->setRange(0, permille);
    m_progress->setValue(static_cast<int>(progress.fraction * permille));
}

void TaskDialog::run(session::Task task, std::function<void(const session::TaskEnd&)> done)
{
    setRunning(true);
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskEnd& end) {
        setRunning(false);
        if (entry() != nullptr)
            done(end);
    };
    m_desk.perform(m_ref, std::move(task));
}

void TaskDialog::look(session::Task task, std::function<void(const session::TaskEnd&)> done)
{
    task.quiet = true;
    task.guard = this;
    task.done = [this, done = std::move(done)](const session::TaskEnd& end) {
        if (entry() != nullptr)
            done(end);
    };
    m_desk.perform(m_ref, std::move(task));
}

void TaskDialog::tellError(const base::Error& error)
{
    tell([error] { return errorWords(error); });
}

void TaskDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || m_deed == nullptr)
        return;
    translateOwn();
    retranslate();
    refresh();
}
} // namespace ui

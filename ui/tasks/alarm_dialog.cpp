// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/alarm_dialog.h"

#include "text/alarm_text.h"
#include "text/error_text.h"
#include "text/translate.h"
#include "ui/common/widget_style.h"
#include "ui/widgets/question_dialog.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>

namespace ui {
using catalog::Role;
using jobs::AlarmPlan;
using jobs::ClearMethod;
using text::translate;

namespace {
using namespace std::chrono_literals;
constexpr auto checkInterval = 400ms;
constexpr int columns = 4;
constexpr int visibleRows = 3;

bool hasAction(ClearMethod release)
{
    return release == ClearMethod::BackOff || release == ClearMethod::NewGoal ||
           release == ClearMethod::FaultReset;
}
} // namespace

AlarmDialog::AlarmDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent)
    : TaskDialog(workbench, servo, "alarmDialog", parent)
    , m_table(new QTableWidget(0, columns, this))
    , m_release(textLabel("release"))
{
    m_table->setObjectName(QStringLiteral("alarms"));
    m_table->setFixedWidth(textWidth);
    styleTable(m_table);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() +
                            visibleRows * m_table->verticalHeader()->defaultSectionSize());
    body()->addWidget(m_table);
    body()->addWidget(m_release);
    m_refreshTimer.setSingleShot(true);
    m_refreshTimer.setInterval(checkInterval);
    connect(&m_refreshTimer, &QTimer::timeout, this, &AlarmDialog::reload);
    finishSetup();
    reload();
}

/// One reading after the other, each when the previous one has ended, so that they do not queue up.
void AlarmDialog::reload()
{
    if (isRunning() || entry() == nullptr)
        return;
    const auto plan = std::make_shared<base::Result<AlarmPlan>>();
    session::Task task;
    task.name = QStringLiteral("read");
    task.work = [plan](session::TaskContext& context) -> base::Result<void> {
        *plan = jobs::planClearAlarm(context.device, context.servo);
        if (!*plan)
            return tl::unexpected(plan->error());
        return {};
    };
    runInBackground(std::move(task), [this, plan](const session::TaskCompletion& end) {
        onPlanRead(end.error ? base::Result<AlarmPlan>(tl::unexpected(*end.error)) : *plan);
    });
}

void AlarmDialog::onPlanRead(const base::Result<AlarmPlan>& plan)
{
    if (isRunning() || m_confirming)
        return;
    if (!plan) {
        m_plan.reset();
        fillTable();
        refresh();
        showError(plan.error());
    } else {
        const bool changed = !m_plan || m_plan->next != plan->next;
        m_plan = *plan;
        fillTable();
        retranslate();
        refresh();
        if (changed && m_plan->next == ClearMethod::None && m_hadAlarm)
            showResult([] {
                return TaskText{Tone::Good, translate("ServoTasks", "The alarm has cleared.")};
            });
        m_hadAlarm = m_plan->next != ClearMethod::None;
    }
    if (workbench().link().state() == session::LinkState::Open)
        m_refreshTimer.start();
}

void AlarmDialog::fillTable()
{
    const std::vector<jobs::Alarm> alarms = m_plan ? m_plan->alarms : std::vector<jobs::Alarm>();
    m_table->setRowCount(static_cast<int>(alarms.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        fillRow(row, alarms[static_cast<std::size_t>(row)]);
}

void AlarmDialog::fillRow(int row, const jobs::Alarm& alarm)
{
    const device::Servo& servo = entry()->servo;
    const QString cells[columns] = {
        text::alarmLabel(alarm.key), valueText(servo, alarm.measured, alarm.value),
        valueText(servo, alarm.measured, alarm.min), valueText(servo, alarm.measured, alarm.max)};
    for (int column = 0; column < columns; ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        const QString more = text::alarmCause(alarm.key);
        item->setToolTip(more.isEmpty() ? cells[column] : cells[column] + QLatin1Char('\n') + more);
        if (column > 0)
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->setItem(row, column, item);
    }
}

QString AlarmDialog::actionText() const
{
    switch (m_plan ? m_plan->next : ClearMethod::None) {
    case ClearMethod::BackOff:
        return translate("ServoTasks", "Turn back slightly…");
    case ClearMethod::NewGoal:
        return translate("ServoTasks", "Hold position…");
    case ClearMethod::FaultReset:
        return translate("ServoTasks", "Reset fault");
    default:
        return translate("ServoTasks", "Clear");
    }
}

void AlarmDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Clear alarm"),
             translate("ServoTasks",
                       "Each alarm is cleared in its own way. While this dialog is open, the "
                       "values are read continuously; nothing is written to the servo."),
             actionText(), translate("ServoTasks", "Performs the action that clears the alarm"));
    m_table->setHorizontalHeaderLabels(
        {translate("ServoTasks", "Alarm"), translate("ServoTasks", "Value"),
         translate("ServoTasks", "Minimum"), translate("ServoTasks", "Maximum")});
    m_table->setAccessibleName(translate("ServoTasks", "Alarms"));
    m_table->setToolTip(
        translate("ServoTasks", "Alarms of this servo, each with its value and limits"));
}

void AlarmDialog::refresh()
{
    QStringList lines;
    if (!m_plan) {
        lines << translate("ServoTasks", "The alarms have not been read.");
    } else {
        for (const jobs::Alarm& alarm : m_plan->alarms) {
            lines << text::alarmCause(alarm.key);
            if (alarm.derived)
                lines << translate("ServoTasks", "This servo family does not report alarms. This "
                                                 "alarm is derived from the value and its limit.");
        }
        lines << text::releaseText(jobs::clearMethodName(m_plan->next));
        if (m_plan->refused) {
            const text::Description description = text::describe(*m_plan->refused);
            lines << description.message << description.cause << description.remedy;
        }
    }
    lines.removeAll(QString());
    m_release->setText(lines.join(QStringLiteral("\n\n")));
    setReady(m_plan && hasAction(m_plan->next) && !m_plan->refused);
}

QString AlarmDialog::positionText(const std::optional<std::int64_t>& raw) const
{
    const catalog::Register* goal = entry()->servo.profile->byRole(Role::GoalPosition);
    return goal != nullptr ? valueText(entry()->servo, goal->key, raw) : QString();
}

void AlarmDialog::runAction()
{
    if (!m_plan->needsConsent()) {
        clearAlarms();
        return;
    }
    Question question;
    if (m_plan->next == ClearMethod::BackOff) {
        question.title = translate("ServoTasks", "Turn the shaft back?");
        question.text =
            translate("ServoTasks", "The shaft will turn from %1 to %2, away from the stalled "
                                    "position, and hold the new position at full torque.")
                .arg(positionText(m_plan->from), positionText(m_plan->to));
        question.acceptText = translate("ServoTasks", "Turn back");
    } else {
        question.title = translate("ServoTasks", "Turn torque on?");
        question.text = translate("ServoTasks", "The present position, %1, will become the goal "
                                                "position, and the servo will hold it.")
                            .arg(positionText(m_plan->to));
        question.acceptText = translate("ServoTasks", "Turn torque on");
    }
    question.risk = translate("ServoTasks", "Remove the obstruction and keep your fingers away "
                                            "from the mechanism.");
    question.guard = this;
    question.rejected = [this] {
        m_confirming = false;
        m_refreshTimer.start();
    };
    m_confirming = true;
    ask(this, question, [this] {
        m_confirming = false;
        clearAlarms();
    });
}

void AlarmDialog::clearAlarms()
{
    if (entry() == nullptr || !m_plan)
        return;
    const auto report = std::make_shared<jobs::AlarmReport>();
    session::Task task;
    task.name = QStringLiteral("clear-alarm");
    task.savesTable = true;
    if (m_plan->next == jobs::ClearMethod::BackOff)
        task.effect = session::Effect::Moves;
    else if (m_plan->next == jobs::ClearMethod::NewGoal)
        task.effect = session::Effect::EnablesTorque; // as was agreed
    task.work = [report, agreed = *m_plan](session::TaskContext& context) -> base::Result<void> {
        auto done = jobs::clearAlarm(context.device, context.servo, agreed);
        if (!done)
            return tl::unexpected(done.error());
        *report = *done;
        return {};
    };
    run(std::move(task), [this, report](const session::TaskCompletion& end) {
        if (end.error)
            showError(*end.error);
        else
            onCleared(*report, end.notices);
        m_refreshTimer.start();
    });
}

void AlarmDialog::onCleared(const jobs::AlarmReport& report, const device::Notices& notices)
{
    m_plan = report.after;
    m_hadAlarm = false;
    fillTable();
    retranslate();
    refresh();
    const bool good = report.isCleared();
    showResult([good, notices] {
        return TaskText{
            good ? Tone::Good : Tone::Warn,
            good ? translate("ServoTasks", "The alarm has cleared.")
                 : translate("ServoTasks",
                             "An alarm is still active or has returned because its cause remains."),
            noticeLines(notices)};
    });
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/restore_defaults_dialog.h"

#include "session/snapshot/safety_snapshot.h"
#include "text/translate.h"
#include "ui/widgets/rate_text.h"

#include <QDir>
#include <QLabel>

namespace ui {
using text::translate;

namespace {
constexpr int shownKeys = 8;

QString changedLine(const std::vector<QString>& keys, const device::Servo& servo)
{
    if (keys.empty())
        return translate("ServoTasks", "No setting differs from before.");
    QStringList shown;
    for (const QString& key : keys) {
        if (shown.size() < shownKeys)
            shown << registerText(servo, key);
    }
    if (static_cast<int>(keys.size()) > shownKeys)
        shown << QStringLiteral("…");
    return translate("ServoTasks", "Settings that differ now (%1): %2")
        .arg(keys.size())
        .arg(shown.join(QStringLiteral(", ")));
}
} // namespace

RestoreDefaultsDialog::RestoreDefaultsDialog(session::Desk& desk, session::ServoRef servo,
                                             QWidget* parent)
    : TaskDialog(desk, servo, "restoreDialog", parent)
    , m_summary(textLabel("restoreWhat"))
{
    body()->addWidget(m_summary);
    finishSetup();
    if (canRun())
        return;
    const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("restore-defaults"),
                              QStringLiteral("no-restore"), entry()->servo.id};
    showResult([refused] {
        return refusedText(refused, translate("ServoTasks", "This servo has no command for it."));
    });
}

bool RestoreDefaultsDialog::canRun() const
{
    return entry()->servo.protocol == base::Protocol::Feetech;
}

void RestoreDefaultsDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Restore defaults"),
             translate("ServoTasks",
                       "The servo goes back to the settings stored in it. ServoDesk takes torque "
                       "off and saves the present table to a file first."),
             translate("ServoTasks", "Save and restore"),
             translate("ServoTasks", "Save the table, restore the defaults, find the servo again"));
    m_summary->setText(translate(
        "ServoTasks",
        "Baud rate: may go back to the stored one; ServoDesk looks for the servo at all rates of "
        "its family.\n"
        "ID: should stay; some servos go back to 1. If another servo has ID 1, connect this one "
        "alone.\n"
        "Limits, gains and offset: go back, so positions may mean other angles afterwards."));
}

void RestoreDefaultsDialog::refresh()
{
    m_summary->setVisible(canRun());
    setReady(canRun());
}

TaskText RestoreDefaultsDialog::outcomeText(const Outcome& outcome,
                                            const session::TaskCompletion& end) const
{
    TaskText result;
    if (end.error) {
        result = errorText(*end.error);
    } else {
        const jobs::RestoreDefaultsReport& report = *outcome.report;
        const bool isLocked = report.lock == device::LockState::Closed;
        result = {isLocked ? Tone::Good : Tone::Warn,
                  translate("ServoTasks", "The defaults have been restored.")};
        result.details << translate("ServoTasks", "ID: %1 → %2, baud rate: %3 → %4")
                              .arg(report.oldId)
                              .arg(report.newId)
                              .arg(rateText(report.oldBaud), rateText(report.newBaud))
                       << changedLine(report.changed, entry()->servo) << lockLine(report.lock);
    }
    if (!outcome.path.isEmpty())
        result.details << translate("ServoTasks", "The settings before are in %1")
                              .arg(QDir::toNativeSeparators(outcome.path));
    result.details += noticeLines(end.notices);
    return result;
}

void RestoreDefaultsDialog::runAction()
{
    const auto outcome = std::make_shared<Outcome>();
    session::Task task;
    task.name = QStringLiteral("restore-defaults");
    task.work = [outcome](session::TaskContext& context) -> base::Result<void> {
        // Not only once a session: what is lost now is what it holds now.
        const auto saved = session::saveSafetySnapshot(context.device, context.servo);
        if (!saved)
            return tl::unexpected(saved.error());
        outcome->path = *saved;
        auto done = jobs::restoreDefaults(context.device, context.servo, context.progress);
        if (!done)
            return tl::unexpected(done.error());
        outcome->report = *done;
        return {};
    };
    run(std::move(task), [this, outcome](const session::TaskCompletion& end) {
        showResult([this, outcome, end] { return outcomeText(*outcome, end); });
    });
}
} // namespace ui

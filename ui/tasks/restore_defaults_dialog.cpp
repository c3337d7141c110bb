// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/restore_defaults_dialog.h"

#include "session/snapshot/safety_snapshot.h"
#include "text/language.h"
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
        return translate("ServoTasks", "No settings have changed.");
    QStringList shown;
    for (const QString& key : keys) {
        if (shown.size() < shownKeys)
            shown << registerText(servo, key);
    }
    if (static_cast<int>(keys.size()) > shownKeys)
        shown << QStringLiteral("…");
    return translate("ServoTasks", "%n setting(s) changed: %1", nullptr, int(keys.size()))
        .arg(text::joinItems(shown));
}
} // namespace

RestoreDefaultsDialog::RestoreDefaultsDialog(session::Workbench& workbench, session::ServoRef servo,
                                             QWidget* parent)
    : TaskDialog(workbench, servo, "restoreDialog", parent)
    , m_summary(textLabel("restoreWhat"))
{
    body()->addWidget(m_summary);
    finishSetup();
    if (canRun())
        return;
    const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("restore-defaults"),
                              QStringLiteral("no-restore"), entry()->servo.id};
    showResult([refused] {
        return refusedText(refused,
                           translate("ServoTasks", "This servo does not support this action."));
    });
}

bool RestoreDefaultsDialog::canRun() const
{
    return entry()->servo.protocol == base::Protocol::Feetech;
}

void RestoreDefaultsDialog::retranslate()
{
    setTexts(
        translate("ServoTasks", "Reset to factory defaults"),
        translate("ServoTasks", "The servo returns to its stored default settings. ServoDesk first "
                                "turns torque off and saves the present memory table to a file."),
        translate("ServoTasks", "Save and reset"),
        translate("ServoTasks", "Saves the memory table, resets the servo to factory defaults, and "
                                "then finds the servo again"));
    m_summary->setText(translate(
        "ServoTasks",
        "Baud rate: may revert to the stored rate. ServoDesk searches for the servo at all baud "
        "rates of its family.\nID: should stay the same; some servos revert to 1. If another servo "
        "has ID 1, connect only this servo.\nLimits, gains and position correction: will be reset; "
        "afterwards, the same position may correspond to a different angle."));
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
                  translate("ServoTasks", "The factory defaults have been restored.")};
        result.details << translate("ServoTasks", "ID: %1 → %2, baud rate: %3 → %4")
                              .arg(report.oldId)
                              .arg(report.newId)
                              .arg(rateText(report.oldBaud), rateText(report.newBaud))
                       << changedLine(report.changed, entry()->servo) << lockLine(report.lock);
    }
    if (!outcome.path.isEmpty())
        result.details << translate("ServoTasks", "The previous settings were saved to %1")
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/reboot_dialog.h"

#include "jobs/change/change.h"
#include "text/translate.h"

namespace ui {
using text::translate;

RebootDialog::RebootDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent)
    : TaskDialog(workbench, servo, "rebootDialog", parent)
{
    finishSetup();
    if (canRun())
        return;
    const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("reboot"),
                              QStringLiteral("no-reboot"), entry()->servo.id};
    showResult([refused] {
        return refusedText(refused,
                           translate("ServoTasks", "This servo does not support this action."));
    });
}

/// LX knows no such command.
bool RebootDialog::canRun() const
{
    return entry()->servo.protocol != base::Protocol::Lx;
}

void RebootDialog::retranslate()
{
    setTexts(
        translate("ServoTasks", "Reboot servo"),
        translate("ServoTasks",
                  "Torque is turned off first, so a load held by the servo will drop. Temporarily "
                  "written values and the turn count are lost. ServoDesk keeps the whole bus quiet "
                  "for up to two seconds until the servo replies again."),
        translate("ServoTasks", "Reboot"),
        translate("ServoTasks", "Turns torque off, reboots the servo and waits for its reply"));
}

void RebootDialog::refresh()
{
    setReady(canRun());
}

void RebootDialog::runAction()
{
    const auto elapsed = std::make_shared<int>(0);
    session::Task task;
    task.name = QStringLiteral("reboot");
    task.work = [elapsed](session::TaskContext& context) -> base::Result<void> {
        const auto done = jobs::reboot(context.device, context.servo);
        if (!done)
            return tl::unexpected(done.error());
        *elapsed = *done;
        return {};
    };
    run(std::move(task), [this, elapsed](const session::TaskCompletion& end) {
        if (end.error) {
            showError(*end.error);
            return;
        }
        showResult([elapsed] {
            return TaskText{
                Tone::Good,
                translate("ServoTasks", "The servo has rebooted and is replying again."),
                {translate("ServoTasks", "The reboot took %1 ms. Torque is off.").arg(*elapsed)}};
        });
    });
}
} // namespace ui

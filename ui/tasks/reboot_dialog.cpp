// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/reboot_dialog.h"

#include "jobs/change/change.h"
#include "text/translate.h"

namespace ui {
using text::translate;

RebootDialog::RebootDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent)
    : TaskDialog(desk, servo, "rebootDialog", parent)
{
    finishSetup();
    if (canRun())
        return;
    const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("reboot"),
                              QStringLiteral("no-reboot"), entry()->servo.id};
    showResult([refused] {
        return refusedText(refused, translate("ServoTasks", "This servo has no command for it."));
    });
}

/// LX knows no such command.
bool RebootDialog::canRun() const
{
    return entry()->servo.protocol != base::Protocol::Lx;
}

void RebootDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Restart the servo"),
             translate("ServoTasks",
                       "Torque is switched off first: a load that hangs on the shaft will drop. "
                       "What was written temporarily is lost, and the turn count with it. The "
                       "whole bus keeps quiet until the servo answers again, two seconds at most."),
             translate("ServoTasks", "Restart"),
             translate("ServoTasks", "Take torque off, restart the servo and wait for it"));
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
                translate("ServoTasks", "The servo has restarted and answers again."),
                {translate("ServoTasks", "It took %1 ms. Torque is off.").arg(*elapsed)}};
        });
    });
}
} // namespace ui

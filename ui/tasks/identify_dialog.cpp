// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/identify_dialog.h"

#include "jobs/change/blink.h"
#include "text/translate.h"

namespace ui {
using text::translate;

IdentifyDialog::IdentifyDialog(session::Workbench& workbench, session::ServoRef servo,
                               QWidget* parent)
    : TaskDialog(workbench, servo, "identifyDialog", parent)
{
    finishSetup();
    // A blinking LED must not delay closing the port.
    connect(&workbench.link(), &session::LinkController::linkChanged, this, [this] {
        if (isRunning() && this->workbench().link().state() == session::LinkState::Closing)
            this->workbench().tasks().stop();
    });
    runAction();
}

void IdentifyDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Blink LED"),
             translate(
                 "ServoTasks",
                 "This servo's LED blinks for a few seconds, and then the LED setting is restored. "
                 "The servo does not move. If the servo has no LED, you will not see anything."),
             translate("ServoTasks", "Repeat"), translate("ServoTasks", "Blinks the LED again"));
}

void IdentifyDialog::runAction()
{
    const auto report = std::make_shared<jobs::BlinkReport>();
    session::Task task;
    task.name = QStringLiteral("identify");
    task.savesTable = true;
    task.work = [report](session::TaskContext& context) -> base::Result<void> {
        const auto blinked =
            jobs::blink(context.device, context.servo, jobs::blinkTime, context.progress);
        if (!blinked)
            return tl::unexpected(blinked.error());
        *report = *blinked;
        return {};
    };
    run(std::move(task), [this, report](const session::TaskCompletion& end) {
        if (end.error) {
            showResult([error = *end.error, notices = end.notices] {
                TaskText words = errorText(error);
                words.details += noticeLines(notices);
                return words;
            });
            return;
        }
        showResult([this, report, notices = end.notices] {
            TaskText words{Tone::Good, translate("ServoTasks", "The LED setting has been "
                                                               "restored.")};
            words.details << QStringLiteral("%1 = %2").arg(
                registerText(entry()->servo, report->key),
                valueText(entry()->servo, report->key, report->before));
            words.details += noticeLines(notices);
            return words;
        });
    });
}

/// Closing the dialog means that the user has seen the LED.
void IdentifyDialog::done(int result)
{
    if (isRunning())
        workbench().tasks().stop();
    TaskDialog::done(result);
}
} // namespace ui

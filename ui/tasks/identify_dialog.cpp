// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/identify_dialog.h"

#include "jobs/change/blink.h"
#include "text/translate.h"

namespace ui {
using text::translate;

IdentifyDialog::IdentifyDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent)
    : TaskDialog(desk, servo, "identifyDialog", parent)
{
    finishSetup();
    // Nobody should wait for a blinking LED to close the port.
    connect(&desk, &session::Desk::linkChanged, this, [this] {
        if (isRunning() && this->desk().state() == session::LinkState::Closing)
            this->desk().stopTask();
    });
    runAction();
}

void IdentifyDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Identify"),
             translate("ServoTasks", "The LED of this servo blinks for some seconds; then its "
                                     "setting is put back as it was. Nothing moves. A board "
                                     "without LED shows nothing."),
             translate("ServoTasks", "Again"), translate("ServoTasks", "Let it blink once more"));
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
            TaskText words{Tone::Good, translate("ServoTasks", "The LED is as it was before.")};
            words.details << QStringLiteral("%1 = %2").arg(
                registerText(entry()->servo, report->key),
                valueText(entry()->servo, report->key, report->before));
            words.details += noticeLines(notices);
            return words;
        });
    });
}

/// Whoever closes it has seen it.
void IdentifyDialog::done(int result)
{
    if (isRunning())
        desk().stopTask();
    TaskDialog::done(result);
}
} // namespace ui

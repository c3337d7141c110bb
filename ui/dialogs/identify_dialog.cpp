// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/identify_dialog.h"

#include "jobs/blink.h"
#include "text/translate.h"

namespace ui {
using text::translate;

IdentifyDialog::IdentifyDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent)
    : TaskDialog(desk, servo, "identifyDialog", parent)
{
    begin();
    // Nobody should wait for a blinking LED to close the port.
    connect(&desk, &session::Desk::linkChanged, this, [this] {
        if (running() && this->desk().state() == session::LinkState::Closing)
            this->desk().stopTask();
    });
    act();
}

void IdentifyDialog::retranslate()
{
    setWords(translate("ServoTasks", "Identify"),
             translate("ServoTasks", "The LED of this servo blinks for some seconds; then its "
                                     "setting is put back as it was. Nothing moves. A board "
                                     "without LED shows nothing."),
             translate("ServoTasks", "Again"), translate("ServoTasks", "Let it blink once more"));
}

void IdentifyDialog::act()
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
    run(std::move(task), [this, report](const session::TaskEnd& end) {
        if (end.error) {
            tell([error = *end.error, notices = end.notices] {
                TaskWords words = errorWords(error);
                words.more += noticeLines(notices);
                return words;
            });
            return;
        }
        tell([this, report, notices = end.notices] {
            TaskWords words{Tone::Good, translate("ServoTasks", "The LED is as it was before.")};
            words.more << QStringLiteral("%1 = %2").arg(
                registerWord(entry()->servo, report->key),
                valueWord(entry()->servo, report->key, report->before));
            words.more += noticeLines(notices);
            return words;
        });
    });
}

/// Whoever closes it has seen it.
void IdentifyDialog::done(int result)
{
    if (running())
        desk().stopTask();
    TaskDialog::done(result);
}
} // namespace ui

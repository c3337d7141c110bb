// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_rescue_dialog.h"

#include "session/snapshot/safety_snapshot.h"
#include "text/firmware_text.h"
#include "text/progress_text.h"
#include "text/translate.h"
#include "ui/tasks/firmware_file_row.h"
#include "ui/tasks/firmware_report_text.h"

#include <QLabel>

#include <memory>

namespace ui {
using text::translate;

FirmwareRescueDialog::FirmwareRescueDialog(session::Workbench& workbench,
                                           session::Settings& settings, QWidget* parent)
    : TaskDialog(workbench, 0, "firmwareRescueDialog", parent)
    , m_file(new FirmwareFileRow(settings, this))
    , m_untried(textLabel("firmwareUntried"))
{
    m_untried->setForegroundRole(QPalette::PlaceholderText);
    body()->addWidget(m_file);
    body()->addWidget(m_untried);
    connect(m_file, &FirmwareFileRow::changed, this, [this] {
        result()->clear();
        refresh();
    });
    connect(m_file, &FirmwareFileRow::failed, this, &FirmwareRescueDialog::showError);
    finishSetup();
}

void FirmwareRescueDialog::retranslate()
{
    setTexts(translate("ServoTasks", "Rescue firmware"),
             translate("ServoTasks",
                       "For a servo that no longer replies after an interrupted update. Connect "
                       "only this servo: every servo whose supply comes on meanwhile receives the "
                       "firmware. Turn the servo's supply off, press Start, then turn it on "
                       "within 30 seconds."),
             translate("ServoTasks", "Start"),
             translate("ServoTasks", "Waits for the servo's bootloader, then sends the firmware"));
    m_untried->setText(text::firmwareUntriedText());
}

/// Until a bootloader replies, the estimate is the time that is left for it.
QString FirmwareRescueDialog::progressText(const jobs::Progress& progress) const
{
    if (progress.fraction > 0 || !progress.remaining)
        return TaskDialog::progressText(progress);
    return translate("ServoTasks", "Turn the servo's supply on now (%1 left).")
        .arg(text::durationText(*progress.remaining));
}

void FirmwareRescueDialog::refresh()
{
    m_file->setEnabled(!isRunning());
    setReady(m_file->file().has_value());
}

void FirmwareRescueDialog::runAction()
{
    const auto done = std::make_shared<std::optional<jobs::FirmwareReport>>();
    session::Task task;
    task.name = QStringLiteral("rescue-firmware");
    task.changesPortBaud = true;
    task.work = [done,
                 file = *m_file->file()](session::TaskContext& context) -> base::Result<void> {
        auto report =
            jobs::rescueFirmware(context.device, file, session::programName(), context.progress);
        if (!report)
            return tl::unexpected(report.error());
        *done = std::move(*report);
        return (*done)->outcome == base::FirmwareOutcome::Updated
                   ? base::Result<void>{}
                   : tl::unexpected((*done)->error.value_or(
                         base::Error{base::ErrorCode::NoReply, QStringLiteral("firmware")}));
    };
    run(std::move(task), [this, done](const session::TaskCompletion& end) {
        if (*done) {
            showResult([done] { return firmwareReportText(FirmwareUpdate{.report = **done}); });
            if ((*done)->servo)
                search(*(*done)->servo);
        } else if (end.error) {
            showError(*end.error);
        }
        refresh();
    });
    refresh();
}

/// Brings it into the list.
void FirmwareRescueDialog::search(const device::Servo& servo)
{
    jobs::ScanSpec spec;
    spec.firstId = spec.lastId = servo.id;
    spec.bauds = {servo.baud};
    spec.protocols = {servo.protocol};
    workbench().search().start(spec);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_update_dialog.h"

#include "jobs/firmware/firmware_preflight.h"
#include "jobs/restore/take_snapshot.h"
#include "session/battery.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/firmware_text.h"
#include "text/translate.h"
#include "ui/common/theme.h"
#include "ui/common/widget_text.h"
#include "ui/tasks/firmware_file_row.h"
#include "ui/tasks/firmware_report_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <memory>

namespace ui {
using base::FirmwareCheckResult;
using text::translate;

FirmwareUpdateDialog::FirmwareUpdateDialog(session::Workbench& workbench, session::ServoRef servo,
                                           session::Settings& settings, QWidget* parent)
    : TaskDialog(workbench, servo, "firmwareUpdateDialog", parent)
    , m_file(new FirmwareFileRow(settings, this))
    , m_list(new QWidget(this))
    , m_untried(textLabel("firmwareUntried"))
{
    m_list->setObjectName(QStringLiteral("firmwareChecks"));
    m_list->hide();
    m_untried->setForegroundRole(QPalette::PlaceholderText);
    body()->addWidget(m_file);
    body()->addWidget(m_list);
    body()->addWidget(m_untried);
    connect(m_file, &FirmwareFileRow::changed, this, &FirmwareUpdateDialog::forgetChecks);
    connect(m_file, &FirmwareFileRow::failed, this, &FirmwareUpdateDialog::showError);
    finishSetup();
    showRefusal();
}

void FirmwareUpdateDialog::forgetChecks()
{
    result()->clear();
    m_checks.clear();
    m_accepted.clear();
    retranslate();
    refresh();
    showRefusal();
}

void FirmwareUpdateDialog::showRefusal()
{
    if (const auto possible = jobs::requireBootloader(entry()->servo); !possible)
        showError(possible.error());
}

void FirmwareUpdateDialog::retranslate()
{
    setTexts(
        translate("ServoTasks", "Update firmware"),
        translate("ServoTasks",
                  "The servo, its supply and the file are checked first. Torque is turned on at "
                  "the present position for a moment, then off, so a load held by the servo will "
                  "drop.\n\nThe first block erases the old firmware. Until the whole file has been "
                  "sent, keep the supply on and the cable plugged in; Stop has no effect then."),
        isChecked() ? translate("ServoTasks", "Update") : translate("ServoTasks", "Check"),
        isChecked() ? translate("ServoTasks", "Sends the firmware to the servo")
                    : translate("ServoTasks", "Checks the servo, its supply and the file"));
    m_untried->setText(text::firmwareUntriedText());
    showChecks();
}

void FirmwareUpdateDialog::refresh()
{
    const bool isGood = std::all_of(m_checks.begin(), m_checks.end(), [this](const auto& one) {
        return one.isPassed || m_accepted.count(one.check) > 0;
    });
    m_file->setEnabled(!isRunning());
    m_list->setEnabled(!isRunning());
    setReady(m_file->file() && isGood && jobs::requireBootloader(entry()->servo));
}

void FirmwareUpdateDialog::runAction()
{
    if (isChecked())
        update();
    else
        check();
}

void FirmwareUpdateDialog::check()
{
    const auto results = std::make_shared<std::vector<FirmwareCheckResult>>();
    session::Task task;
    task.name = QStringLiteral("check-firmware");
    task.effect = session::Effect::Moves;
    task.work = [results,
                 file = *m_file->file()](session::TaskContext& context) -> base::Result<void> {
        const auto saved = session::saveSafetySnapshot(context.device, context.servo);
        auto checked = jobs::checkFirmwareUpdate(
            context.device, context.servo,
            {file, saved.map([](const QString&) {}), session::lowBatteryPercent()},
            context.progress);
        if (!checked)
            return tl::unexpected(checked.error());
        *results = std::move(*checked);
        return {};
    };
    run(std::move(task), [this, results](const session::TaskCompletion& end) {
        m_checks = *results;
        if (end.error)
            showError(*end.error);
        retranslate();
        refresh();
    });
    refresh();
}

void FirmwareUpdateDialog::update()
{
    struct Update {
        std::optional<snapshot::Snapshot> before;
        jobs::FirmwareReport report;
    };
    const auto done = std::make_shared<Update>();
    session::Task task;
    task.name = QStringLiteral("update-firmware");
    task.changesFirmware = true;
    task.work = [done,
                 file = *m_file->file()](session::TaskContext& context) -> base::Result<void> {
        const QString program = session::programName();
        auto before = jobs::takeSnapshot(context.device, context.servo, program);
        if (!before)
            return tl::unexpected(before.error());
        auto report =
            jobs::updateFirmware(context.device, context.servo, file, program, context.progress);
        if (!report)
            return tl::unexpected(report.error());
        done->before = std::move(*before);
        done->report = std::move(*report);
        if (done->report.servo)
            context.servo = *done->report.servo;
        return done->report.outcome == base::FirmwareOutcome::Updated
                   ? base::Result<void>{}
                   : tl::unexpected(done->report.error.value_or(
                         base::Error{base::ErrorCode::NoReply, QStringLiteral("firmware")}));
    };
    run(std::move(task), [this, done](const session::TaskCompletion& end) {
        m_checks.clear();
        m_accepted.clear();
        if (done->before)
            showResult([done] { return firmwareReportText(done->report, done->before); });
        else if (end.error)
            showError(*end.error);
        retranslate();
        refresh();
    });
    refresh();
}

void FirmwareUpdateDialog::showChecks()
{
    qDeleteAll(m_list->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    delete m_list->layout();
    auto* grid = new QGridLayout(m_list);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    for (const FirmwareCheckResult& one : m_checks)
        addCheck(grid->rowCount(), one);
    m_list->setVisible(isChecked());
}

void FirmwareUpdateDialog::addCheck(int row, const FirmwareCheckResult& result)
{
    auto* grid = static_cast<QGridLayout*>(m_list->layout());
    const QString key = base::firmwareCheckName(result.check);
    auto* sign = new QLabel(result.isPassed ? QStringLiteral("✓") : QStringLiteral("!"), m_list);
    QPalette colors = sign->palette();
    colors.setColor(QPalette::WindowText,
                    tone(result.isPassed ? Tone::Good : Tone::Bad, palette()));
    sign->setPalette(colors);
    auto* words = new QLabel(m_list);
    words->setObjectName(QStringLiteral("firmwareCheck-") + key);
    words->setTextFormat(Qt::PlainText);
    words->setWordWrap(true);
    words->setText(text::firmwareCheckText(result));
    grid->addWidget(sign, row, 0, Qt::AlignTop);
    grid->addWidget(words, row, 1);
    if (result.isPassed)
        return;
    auto* accept = new QCheckBox(m_list);
    accept->setObjectName(QStringLiteral("firmwareAccept-") + key);
    accept->setChecked(m_accepted.count(result.check) > 0);
    accept->setText(translate("ServoTasks", "I accept this risk"));
    setAccessText(accept,
                  translate("ServoTasks", "Accept: %1").arg(text::firmwareCheckLabel(result.check)),
                  translate("ServoTasks", "Lets the update start although this check has failed"));
    grid->addWidget(accept, row + 1, 1);
    connect(accept, &QCheckBox::toggled, this, [this, check = result.check](bool on) {
        if (on)
            m_accepted.insert(check);
        else
            m_accepted.erase(check);
        refresh();
    });
}
} // namespace ui

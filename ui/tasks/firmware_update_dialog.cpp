// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/firmware_update_dialog.h"

#include "jobs/firmware/firmware_preflight.h"
#include "jobs/restore/take_snapshot.h"
#include "session/battery.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/bus_text.h"
#include "text/firmware_text.h"
#include "text/translate.h"
#include "ui/common/theme.h"
#include "ui/common/widget_text.h"
#include "ui/tasks/firmware_file_row.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <memory>

namespace ui {
using base::FirmwareCheckResult;
using session::ServoRef;
using text::translate;

FirmwareUpdateDialog::FirmwareUpdateDialog(session::Workbench& workbench,
                                           std::vector<ServoRef> servos,
                                           session::Settings& settings, QWidget* parent)
    : TaskDialog(workbench, servos.front(), "firmwareUpdateDialog", parent)
    , m_servos(std::move(servos))
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
    connect(m_file, &FirmwareFileRow::changed, this, &FirmwareUpdateDialog::onFileChanged);
    connect(m_file, &FirmwareFileRow::failed, this, &FirmwareUpdateDialog::showError);
    finishSetup();
    showRefusal();
}

/// Servos of the list that are updated already stay so.
void FirmwareUpdateDialog::onFileChanged()
{
    result()->clear();
    m_checks.clear();
    m_accepted.clear();
    retranslate();
    refresh();
    showRefusal();
}

/// Another model may need another file, and each servo has its own supply and memory table.
void FirmwareUpdateDialog::keepSameRisks(const catalog::Profile& updated)
{
    using base::FirmwareCheck;
    const bool isSameModel =
        next() != nullptr && next()->servo.profile &&
        next()->servo.profile->identity.modelId() == updated.identity.modelId();
    std::erase_if(m_accepted, [&](FirmwareCheck check) {
        const bool isOfFile = check == FirmwareCheck::FileName || check == FirmwareCheck::FileSize;
        const bool isOfBench =
            check == FirmwareCheck::OtherServos || check == FirmwareCheck::Battery;
        return !isOfBench && !(isOfFile && isSameModel);
    });
}

void FirmwareUpdateDialog::showRefusal()
{
    if (next() == nullptr)
        return;
    if (const auto possible = jobs::requireBootloader(next()->servo); !possible)
        showError(possible.error());
}

const session::ServoEntry* FirmwareUpdateDialog::next() const
{
    return m_done.size() < m_servos.size() ? workbench().registry().servo(m_servos[m_done.size()])
                                           : nullptr;
}

QString FirmwareUpdateDialog::servoText() const
{
    if (m_servos.size() == 1)
        return TaskDialog::servoText();
    if ((isRunning() || isChecked() || !m_done.empty()) && next() != nullptr)
        return translate("ServoTasks", "%1 (%2 of %3)")
            .arg(servoTitle(*next()))
            .arg(m_done.size() + 1)
            .arg(m_servos.size());
    const int count = static_cast<int>(m_servos.size());
    return translate("ServoTasks", "%n servo(s), one after the other: ID %1", nullptr, count)
        .arg(text::idRangesText(ids()));
}

QString FirmwareUpdateDialog::closeTip() const
{
    return m_servos.size() == 1
               ? TaskDialog::closeTip()
               : translate("ServoTasks",
                           "Closes this dialog; the present servo is completed, those "
                           "after it are not updated");
}

std::vector<int> FirmwareUpdateDialog::ids(std::size_t first) const
{
    std::vector<int> all;
    for (std::size_t i = first; i < m_servos.size(); ++i) {
        if (const session::ServoEntry* entry = workbench().registry().servo(m_servos[i]))
            all.push_back(entry->servo.id);
    }
    return all;
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

bool FirmwareUpdateDialog::isGood() const
{
    return std::all_of(m_checks.begin(), m_checks.end(), [this](const auto& one) {
        return one.isPassed || m_accepted.count(one.check) > 0;
    });
}

void FirmwareUpdateDialog::refresh()
{
    updateServoText();
    m_file->setEnabled(!isRunning());
    m_list->setEnabled(!isRunning());
    setReady(m_file->file() && isGood() && next() != nullptr &&
             jobs::requireBootloader(next()->servo));
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
    task.changesPortBaud = true;
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
    run(m_servos[m_done.size()], std::move(task),
        [this, results](const session::TaskCompletion& end) { checked(*results, end.error); });
    retranslate();
    refresh();
}

void FirmwareUpdateDialog::checked(const std::vector<FirmwareCheckResult>& results,
                                   const std::optional<base::Error>& error)
{
    m_checks = results;
    const bool isFirst = m_done.empty();
    if (!error && !isFirst && isGood())
        return update();
    if (error && !isFirst)
        return end({.refusal = error});
    if (error)
        showError(*error);
    else if (!isFirst) // what was not accepted before has to be answered
        showDone();
    retranslate();
    refresh();
}

void FirmwareUpdateDialog::update()
{
    const auto done = std::make_shared<FirmwareUpdate>();
    session::Task task;
    task.name = QStringLiteral("update-firmware");
    task.changesFirmware = true;
    task.changesPortBaud = true;
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
    run(m_servos[m_done.size()], std::move(task), [this, done](const session::TaskCompletion& end) {
        if (!done->before)
            done->refusal = end.error;
        updated(std::move(*done));
    });
    retranslate();
    refresh();
}

/// Goes on with the next servo after an update that succeeded, and only then.
void FirmwareUpdateDialog::updated(FirmwareUpdate done)
{
    m_checks.clear();
    if (!isUpdated(done) || m_done.size() + 1 == m_servos.size() || wasStopped())
        return end(std::move(done));
    done.id = next() != nullptr ? next()->servo.id : 0;
    const catalog::ProfilePtr profile = done.report.servo->profile;
    m_done.push_back(std::move(done));
    keepSameRisks(*profile);
    check();
}

/// All are updated, or a new start begins with the first one that is not.
void FirmwareUpdateDialog::end(FirmwareUpdate last)
{
    last.id = next() != nullptr ? next()->servo.id : 0;
    m_done.push_back(std::move(last));
    showDone();
    if (!isUpdated(m_done.back()))
        m_done.pop_back();
    else if (m_done.size() == m_servos.size())
        m_done.clear();
    m_checks.clear();
    m_accepted.clear();
    retranslate();
    refresh();
}

void FirmwareUpdateDialog::showDone()
{
    showResult([done = m_done, isList = m_servos.size() > 1, left = ids(m_done.size())] {
        return isList ? firmwareReportText(done, left) : firmwareReportText(done.front());
    });
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

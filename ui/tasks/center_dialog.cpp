// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/center_dialog.h"

#include "device/reader.h"
#include "text/translate.h"

#include <QGridLayout>
#include <QLabel>

namespace ui {
using catalog::Role;
using text::translate;

CenterDialog::CenterDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent)
    : TaskDialog(workbench, servo, "centerDialog", parent)
{
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    const auto addRow = [&](int row, std::array<QLabel*, 3>& labels, const char* name) {
        static const char* const columns[] = {"", "Before", "After"};
        for (int column = 0; column < 3; ++column) {
            auto* label = new QLabel(this);
            label->setObjectName(QLatin1String(name) + QLatin1String(columns[column]));
            grid->addWidget(label, row, column);
            labels[static_cast<std::size_t>(column)] = label;
        }
    };
    addRow(0, m_headers, "head");
    addRow(1, m_position, "position");
    addRow(2, m_offset, "offset");
    grid->setColumnStretch(2, 1);
    body()->addLayout(grid);
    finishSetup();
    if (canRun()) {
        readBefore();
        return;
    }
    // With the error of the job, which would refuse it.
    const catalog::Register* offset = entry()->servo.profile->byRole(Role::PositionOffset);
    const QString detail = offset != nullptr && offset->writable()
                               ? QStringLiteral("write ") + offset->key
                               : entry()->servo.profile->series;
    const base::Error refused{base::ErrorCode::NotSupported, QStringLiteral("center"), detail,
                              entry()->servo.id};
    showResult([refused] {
        return refusedText(refused,
                           translate("ServoTasks", "This servo does not support this action."));
    });
}

bool CenterDialog::canRun() const
{
    const auto& profile = entry()->servo.profile;
    return profile && profile->centering != catalog::Centering::None &&
           profile->byRole(Role::PositionOffset) != nullptr;
}

void CenterDialog::readBefore()
{
    session::Task task;
    task.name = QStringLiteral("read");
    task.work = [](session::TaskContext& context) {
        return device::readRoles(context.device, context.servo,
                                 {Role::PositionOffset, Role::PresentPosition});
    };
    runInBackground(std::move(task), [this](const session::TaskCompletion& end) {
        if (end.error) {
            showError(*end.error);
            return;
        }
        m_report.positionBefore = entry()->servo.raw(Role::PresentPosition);
        m_report.offsetBefore = entry()->servo.raw(Role::PositionOffset);
        refresh();
    });
}

QString CenterDialog::fieldText(Role role, const std::optional<std::int64_t>& raw) const
{
    const auto& profile = entry()->servo.profile;
    const catalog::Register* reg = profile ? profile->byRole(role) : nullptr;
    return reg != nullptr ? valueText(entry()->servo, reg->key, raw) : QStringLiteral("–");
}

void CenterDialog::refresh()
{
    m_position[1]->setText(fieldText(Role::PresentPosition, m_report.positionBefore));
    m_position[2]->setText(fieldText(Role::PresentPosition, m_report.positionAfter));
    m_offset[1]->setText(fieldText(Role::PositionOffset, m_report.offsetBefore));
    m_offset[2]->setText(fieldText(Role::PositionOffset, m_report.offsetAfter));
    setReady(canRun());
}

void CenterDialog::retranslate()
{
    setTexts(
        translate("ServoTasks", "Set midpoint"),
        translate("ServoTasks",
                  "The present shaft position becomes the midpoint of the travel range. Torque is "
                  "turned off first to prevent a jump to the old goal position and stays off until "
                  "you turn it on. The position correction is kept after power-off."),
        translate("ServoTasks", "Set midpoint"),
        translate("ServoTasks", "Turns torque off and sets the present position as the "
                                "midpoint"));
    m_headers[1]->setText(translate("ServoTasks", "Before"));
    m_headers[2]->setText(translate("ServoTasks", "After"));
    m_position[0]->setText(translate("ServoTasks", "Position"));
    m_offset[0]->setText(translate("ServoTasks", "Position correction"));
}

void CenterDialog::runAction()
{
    const auto report = std::make_shared<jobs::CenterReport>();
    session::Task task;
    task.name = QStringLiteral("center");
    task.savesTable = true;
    task.work = [report](session::TaskContext& context) -> base::Result<void> {
        auto done = jobs::center(context.device, context.servo);
        if (!done)
            return tl::unexpected(done.error());
        *report = *done;
        return {};
    };
    run(std::move(task), [this, report](const session::TaskCompletion& end) {
        if (end.error) {
            showError(*end.error);
            return;
        }
        m_report = *report;
        refresh();
        showResult([this, notices = end.notices] {
            TaskText result{m_report.lock == device::LockState::Closed ? Tone::Good : Tone::Warn,
                            translate("ServoTasks", "The present position is now the midpoint.")};
            result.details << lockLine(m_report.lock) << noticeLines(notices);
            result.details.removeAll(QString());
            return result;
        });
    });
}
} // namespace ui

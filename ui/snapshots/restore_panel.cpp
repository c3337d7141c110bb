// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/restore_panel.h"

#include "device/motion/saved_speed.h"
#include "session/snapshot/safety_snapshot.h"
#include "session/snapshot/snapshots.h"
#include "snapshot/factory_snapshot.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/snapshots/apply_dialog.h"
#include "ui/snapshots/compare_model.h"
#include "ui/snapshots/dry_run_dialog.h"
#include "ui/snapshots/restore_text.h"
#include "ui/snapshots/snapshot_actions.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/question_dialog.h"

#include <QAction>
#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {
using jobs::RestoreReason;

namespace {
bool isTorqueOn(const jobs::RestorePlan& plan)
{
    return plan.servo.raw(catalog::Role::TorqueSwitch).value_or(0) != 0;
}

/// Ticked rows, and rows that are the same on this servo but may differ on others.
bool isTransferable(const jobs::RestoreRow& row)
{
    if (row.reasons.testFlag(RestoreReason::Identity))
        return false;
    const jobs::RestoreReasons special = jobs::RestoreReasons(RestoreReason::Live) |
                                         RestoreReason::ReadOnly | RestoreReason::Factory |
                                         RestoreReason::NeedsConsent | RestoreReason::OptIn;
    return row.selected || (row.reasons.testFlag(RestoreReason::Same) && !(row.reasons & special));
}

bool isAngleLimit(const jobs::RestorePlan& plan, const QString& key)
{
    const catalog::Register* reg = plan.servo.profile->find(key);
    return reg != nullptr &&
           (reg->role == catalog::Role::MinAngle || reg->role == catalog::Role::MaxAngle);
}

/// The snapshot has none, and the user has ticked neither: other servos keep theirs.
bool keepsLimitsOfOthers(const jobs::RestorePlan& plan)
{
    const auto isUntickedZero = [&](catalog::Role role) {
        const catalog::Register* reg = plan.servo.profile->byRole(role);
        const jobs::RestoreRow* limit = reg != nullptr ? plan.find(reg->key) : nullptr;
        return limit != nullptr && limit->newRaw == 0 && !limit->selected;
    };
    return isUntickedZero(catalog::Role::MinAngle) && isUntickedZero(catalog::Role::MaxAngle);
}

void addRows(ApplySource& source, const jobs::RestorePlan& plan)
{
    const bool keepsLimits = keepsLimitsOfOthers(plan);
    device::RegisterValues values;
    for (const jobs::RestoreRow& row : plan.rows) {
        if (!isTransferable(row) || (keepsLimits && isAngleLimit(plan, row.key)))
            continue;
        source.only << row.key;
        source.dangerous = source.dangerous || row.reasons.testFlag(RestoreReason::NeedsConsent);
        if (row.reasons.testFlag(RestoreReason::OtherModelLimit))
            source.otherModelLimits << row.key;
        const catalog::Register* reg = plan.servo.profile->find(row.key);
        if (reg != nullptr && row.newRaw)
            values.push_back({reg, *row.newRaw});
    }
    source.dangerous =
        source.dangerous || device::canRemoveAngleLimits(*plan.servo.profile, values);
}
} // namespace

RestorePanel::RestorePanel(AppContext& appContext, session::Settings& settings,
                           SnapshotBrowser& browser, CompareModel& model, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_selection(appContext.selection)
    , m_settings(settings)
    , m_browser(browser)
    , m_model(model)
{
    build();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
}

void RestorePanel::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    auto* ticks = new FlowLayout(nullptr, 14);
    const auto check = [&](const char* name) {
        auto* made = new QCheckBox(this);
        made->setObjectName(QString::fromLatin1(name));
        ticks->addWidget(made);
        return made;
    };
    m_identity = check("restoreIdentity");
    m_rollBack = check("restoreRollBack");
    auto* row = new FlowLayout(nullptr, 6);
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(this);
        made->setObjectName(QString::fromLatin1(name));
        row->addWidget(made);
        return made;
    };
    m_write = button("restoreWrite");
    makeMainAction(m_write);
    m_dryRun = button("restoreDryRun");
    m_applyToSeveral = button("restoreSeveral");
    m_template = button("restoreTemplate");
    m_order = new QLabel(this);
    m_order->setObjectName(QStringLiteral("restoreOrder"));
    m_order->setWordWrap(true);
    // The buttons are last, where a change of the text does not move them.
    column->addLayout(ticks);
    column->addWidget(m_order);
    column->addLayout(row);
    for (QWidget* writer : {m_write, m_applyToSeveral})
        new PressGuard(writer);
    m_saveResult = new QAction(this);
}

void RestorePanel::connectAll()
{
    connect(&m_model, &CompareModel::selectedRowsChanged, this, &RestorePanel::rememberTicks);
    connect(m_identity, &QCheckBox::toggled, this,
            [this](bool on) { m_model.setAllSelected(RestoreReason::Identity, on); });
    connect(m_write, &QPushButton::clicked, this, &RestorePanel::confirmWrite);
    connect(m_dryRun, &QPushButton::clicked, this, &RestorePanel::dryRun);
    connect(m_applyToSeveral, &QPushButton::clicked, this, &RestorePanel::applyToSeveral);
    connect(m_template, &QPushButton::clicked, this, &RestorePanel::templateRequested);
    connect(m_saveResult, &QAction::triggered, this, &RestorePanel::saveResult);
}

std::optional<jobs::RestorePlan> RestorePanel::makePlan(const session::ServoEntry* entry)
{
    const auto selected = m_browser.selectedSnapshots();
    return m_ticks.plan(entry, m_selection.current(),
                        selected.empty() ? nullptr : selected.front().snapshot.get(),
                        m_identity->isChecked());
}

void RestorePanel::rememberTicks()
{
    if (m_model.plan())
        m_ticks.remember(*m_model.plan());
    updateControls();
}

QString RestorePanel::orderText() const
{
    const auto& plan = m_model.plan();
    if (!plan || jobs::plannedWrites(*plan).empty())
        return {};
    return isTorqueOn(*plan)
               ? tr("Torque is turned off first and stays off. Order: limits, mode, gains, then "
                    "the lock. Every row is read back. The change can be undone.")
               : tr("Order: limits, mode, gains, then the lock. Every row is read back. The change "
                    "can be undone.");
}

void RestorePanel::updateControls()
{
    if (!m_workbenchGuard)
        return;
    const bool open =
        m_workbench.link().state() == session::LinkState::Open && !m_workbench.tasks().isTesting();
    const auto& plan = m_model.plan();
    const std::size_t count = plan ? jobs::plannedWrites(*plan).size() : 0;
    const bool bundle = m_browser.bundle() != nullptr;
    const auto selected = m_browser.selectedSnapshots();
    m_write->setText(count == 0 ? tr("Write selected rows")
                                : tr("Write %n selected row(s)", nullptr, int(count)));
    m_write->setEnabled(open && count > 0 && !m_writing);
    m_dryRun->setEnabled(plan.has_value());
    m_applyToSeveral->setText(bundle ? tr("Restore the bundle…") : tr("Several servos…"));
    m_applyToSeveral->setEnabled(open && !m_writing && (bundle || !selected.empty()));
    for (QPushButton* button : {m_write, m_applyToSeveral})
        button->setAccessibleName(button->text());
    m_template->setEnabled(!selected.empty() && !selected.front().snapshot->isTemplate &&
                           snapshot::profileOf(*selected.front().snapshot, m_workbench.catalog()));
    m_identity->setEnabled(plan.has_value());
    m_order->setText(orderText());
}

void RestorePanel::dryRun()
{
    if (!m_model.plan() || m_dryRunPending)
        return;
    // The speed that the journal remembers is written back, too. It is read by a task, which may
    // wait for the journal.
    const auto plan = std::make_shared<jobs::RestorePlan>(*m_model.plan());
    session::Task task;
    task.name = QStringLiteral("dry-run");
    task.quiet = true;
    task.work = [plan](session::TaskContext& context) -> base::Result<void> {
        const auto speed = device::savedSpeed(context.device.journal, plan->servo);
        if (!speed)
            return tl::unexpected(speed.error());
        plan->positionSpeed = *speed;
        return {};
    };
    task.guard = this;
    task.done = [this, plan](const session::TaskCompletion& end) {
        m_dryRunPending = false;
        if (end.error)
            Q_EMIT failed(*end.error);
        else
            (new DryRunDialog(m_model, *plan, this))->open();
    };
    m_dryRunPending = true;
    m_workbench.tasks().perform(m_selection.current(), std::move(task));
}

/// Of the rows to be written: a shaft that moves, an address that changes, a servo that becomes
/// unreachable. The rest is visible in the table.
QStringList RestorePanel::risks() const
{
    const jobs::RestorePlan& plan = *m_model.plan();
    QStringList lines;
    for (const jobs::RestoreWrite& one : jobs::plannedWrites(plan)) {
        const jobs::RestoreRow* row = plan.find(one.key);
        const QString name = m_model.nameOf(one.key);
        if (row->reasons.testFlag(RestoreReason::OtherModelLimit))
            lines
                << tr("%1: this limit comes from another model (%2).").arg(name, plan.sourceModel);
        else if (row->reasons.testFlag(RestoreReason::NeedsConsent) && isAngleLimit(plan, one.key))
            lines << tr("%1: with both angle limits at 0, the shaft can turn without limit.")
                         .arg(name);
        else if (row->reasons.testFlag(RestoreReason::NeedsConsent))
            lines << tr("%1: a wrong value can make the servo unreachable or dangerous.").arg(name);
        if (row->reasons.testFlag(RestoreReason::WouldAlarm))
            lines << alarmLine(m_model, *row);
        if (row->reasons.testFlag(RestoreReason::MovesShaft))
            lines << tr("%1 shifts the position that the servo reports.").arg(name);
        if (row->reasons.testFlag(RestoreReason::Identity))
            lines << tr("%1 changes from %2 to %3. Afterwards, the servo can be reached only with "
                        "the new setting.")
                         .arg(name)
                         .arg(m_model.formatted(one.key, one.from.value_or(0)),
                              m_model.formatted(one.key, one.to));
    }
    return lines;
}

void RestorePanel::confirmWrite()
{
    const auto& plan = m_model.plan();
    if (!plan)
        return;
    const QStringList lines = risks();
    const bool torque = isTorqueOn(*plan);
    if (lines.isEmpty() && !torque) {
        write();
        return;
    }
    Question question;
    question.title = tr("Write to ID %1?").arg(plan->id);
    if (torque)
        question.text = tr("Torque is on; it will be turned off first and will stay off. A load "
                           "held by the servo may drop.");
    question.risk = lines.join(QLatin1Char('\n'));
    question.acceptText = plan->needsConsent() ? tr("Write anyway") : tr("Write");
    question.acceptIsDefault = lines.isEmpty();
    question.guard = this;
    ask(this, question, [this] { write(); });
}

void RestorePanel::write()
{
    const auto& plan = m_model.plan();
    const auto selected = m_browser.selectedSnapshots();
    if (!plan || selected.empty() || m_writing)
        return;
    Q_EMIT started();
    session::RestoreRequest request;
    request.plan = *plan;
    if (plan->needsConsent())
        request.consent = device::Consent::confirmed(); // asked for in confirmWrite()
    request.onFailure = m_rollBack->isChecked() ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    request.guard = this;
    const QString source =
        selected.front().path.isEmpty() ? selected.front().title : selected.front().path;
    request.done = [this, source](const session::RestoreCompletion& end) {
        onFinished(end, source);
    };
    m_writing = true;
    updateControls();
    m_workbench.restores().restore(m_selection.current(), request);
}

void RestorePanel::onFinished(const session::RestoreCompletion& end, const QString& source)
{
    m_writing = false;
    m_results.clear();
    if (end.outcome) {
        const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
        if (entry != nullptr && entry->servo.profile)
            m_results.push_back(
                jobs::toRestoreResult(*end.outcome, entry->servo, source, session::programName()));
        // A tick is for one write: a dangerous row asks again.
        for (const jobs::RestoreRowResult& row : end.outcome->rows) {
            if (isRowApplied(row))
                m_ticks.forget(row.write.key);
        }
    }
    Q_EMIT finished(end);
    m_workbench.writes().readTable(m_selection.current());
    updateControls();
}

void RestorePanel::applyToSeveral()
{
    ApplySource source;
    source.bundle = m_browser.bundle();
    const auto selected = m_browser.selectedSnapshots();
    if (source.bundle) {
        source.name = QFileInfo(m_browser.bundlePath()).fileName();
    } else if (!selected.empty()) {
        source.name = selected.front().title;
        source.snapshot = selected.front().snapshot;
        if (m_model.plan())
            addRows(source, *m_model.plan());
    } else {
        return;
    }
    (new ApplyDialog(m_workbench, m_workbench.snapshots(), std::move(source), this))->open();
}

void RestorePanel::saveResult()
{
    askForSavePath(this,
                   {QStringLiteral("snapshotFileDialog"),
                    tr("Save the result"),
                    {tr("Table for spreadsheets (*.csv)"), tr("Data (*.json)")},
                    QStringLiteral("restore-result.csv"),
                    &m_settings,
                    SnapshotActions::folderKey()},
                   [this, results = m_results](const QString& path) {
                       m_workbench.snapshots().save(results, path);
                   });
}

void RestorePanel::retranslate()
{
    setButtonText(m_identity, tr("Include ID and baud rate"),
                  tr("Also selects ID and baud rate, which are written last; the servo can then be "
                     "reached only with the new settings"));
    setButtonText(m_rollBack, tr("If a row fails, restore all old values"),
                  tr("Without this option, writing stops at the failed row; values already written "
                     "stay in the servo"));
    m_write->setToolTip(
        tr("Writes only the selected rows that differ from the servo's present values"));
    setButtonText(m_dryRun, tr("Dry run…"),
                  tr("Shows exactly what would be written, and in which order"));
    m_applyToSeveral->setToolTip(tr("Writes the selected rows to several servos"));
    setButtonText(m_template, tr("Save template…"),
                  tr("Saves selected rows of this snapshot to a file for setting up other servos"));
    m_saveResult->setText(tr("Save result…"));
    updateControls();
}
} // namespace ui

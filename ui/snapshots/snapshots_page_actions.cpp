// SPDX-License-Identifier: GPL-3.0-or-later
// What the snapshots page does.
#include "device/motion/saved_speed.h"
#include "session/snapshot/restore_request.h"
#include "session/snapshot/safety_snapshot.h"
#include "snapshot/factory_snapshot.h"
#include "text/restore_text.h"
#include "ui/snapshots/apply_dialog.h"
#include "ui/snapshots/dry_run_dialog.h"
#include "ui/snapshots/restore_text.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/snapshots/snapshot_pane.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/snapshots/template_dialog.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/note_dialog.h"
#include "ui/widgets/question_dialog.h"

#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace ui {
namespace {
const QString folderKey = QStringLiteral("snapshots/folder");
const QString snapshotSuffix = QStringLiteral(".servo.json");
const QString bundleSuffix = QStringLiteral(".bundle.json");

/// A double suffix, which a file dialog does not add by itself.
QString withSuffix(const QString& path, const QString& end)
{
    if (path.endsWith(QLatin1StringView(".csv"), Qt::CaseInsensitive) ||
        path.endsWith(end, Qt::CaseInsensitive))
        return path;
    return (path.endsWith(QLatin1StringView(".json"), Qt::CaseInsensitive) ? path.chopped(5)
                                                                           : path) +
           end;
}

/// What is ticked, and what this servo has already but others may not.
bool isTransferable(const jobs::RestoreRow& row)
{
    using jobs::RestoreReason;
    if (row.reasons.testFlag(RestoreReason::Identity))
        return false;
    const jobs::RestoreReasons special = jobs::RestoreReasons(RestoreReason::Live) |
                                         RestoreReason::ReadOnly | RestoreReason::Factory |
                                         RestoreReason::NeedsConsent | RestoreReason::OptIn;
    return row.selected || (row.reasons.testFlag(RestoreReason::Same) && !(row.reasons & special));
}

QString fileNamePart(QString name)
{
    for (QChar& letter : name) {
        if (!letter.isLetterOrNumber() && letter != QLatin1Char('-'))
            letter = QLatin1Char('_');
    }
    return name;
}
} // namespace

QString SnapshotsPage::folder() const
{
    return m_settings.pageValue(folderKey, QDir::homePath()).toString();
}

void SnapshotsPage::askFile(const QString& title, const QString& name, const QStringList& filters,
                            const QString& suffix,
                            std::function<void(const QString&)> selectedSnapshots)
{
    auto* dialog = new QFileDialog(this, title);
    dialog->setObjectName(QStringLiteral("snapshotFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(suffix);
    dialog->setDirectory(folder());
    dialog->selectFile(name);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, selectedSnapshots = std::move(selectedSnapshots)](const QString& path) {
                m_settings.setPageValue(folderKey, QFileInfo(path).absolutePath());
                selectedSnapshots(path);
            });
    dialog->open();
}

void SnapshotsPage::takeSnapshot()
{
    m_banner->hideMessage();
    m_snapshots.take(m_selection.current(), {});
}

void SnapshotsPage::openFiles()
{
    auto* dialog = new QFileDialog(this, tr("Open snapshots"));
    dialog->setObjectName(QStringLiteral("snapshotOpenDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    dialog->setNameFilters(
        {tr("Snapshots and bundles (*.servo.json *.bundle.json)"), tr("All files (*)")});
    dialog->setDirectory(folder());
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& paths) {
        m_banner->hideMessage();
        for (const QString& path : paths) {
            m_settings.setPageValue(folderKey, QFileInfo(path).absolutePath());
            m_snapshots.open(path);
        }
    });
    dialog->open();
}

void SnapshotsPage::saveCopy()
{
    const auto selectedSnapshots = m_browser->selectedSnapshots();
    if (selectedSnapshots.empty())
        return;
    const session::SharedSnapshot table = selectedSnapshots.front().snapshot;
    const QString name = QStringLiteral("%1-id%2-%3")
                             .arg(fileNamePart(table->servo.model))
                             .arg(table->servo.id)
                             .arg(table->at.toLocalTime().toString(QStringLiteral("yyyyMMdd")));
    askFile(tr("Save the snapshot"), name + snapshotSuffix,
            {tr("Snapshot (*.servo.json)"), tr("Table for spreadsheets (*.csv)")}, {},
            [this, table](const QString& path) {
                m_snapshots.save(table, withSuffix(path, snapshotSuffix));
            });
}

void SnapshotsPage::saveBundle()
{
    askFile(
        tr("Save all servos"), QStringLiteral("servos") + bundleSuffix,
        {tr("Bundle (*.bundle.json)")}, {}, [this](const QString& path) {
            m_banner->hideMessage();
            m_snapshots.takeAll({QFileInfo(path).baseName(), {}, withSuffix(path, bundleSuffix)});
        });
}

void SnapshotsPage::saveTemplate()
{
    const auto selectedSnapshots = m_browser->selectedSnapshots();
    if (selectedSnapshots.empty())
        return;
    const session::SharedSnapshot from = selectedSnapshots.front().snapshot;
    const auto profile = record::profileOf(*from, m_desk.catalog());
    if (!profile)
        return;
    auto* dialog = new TemplateDialog(*from, profile, this);
    connect(dialog, &TemplateDialog::accepted, this,
            [this, dialog, from] { askTemplateFile(from, dialog->keys()); });
    dialog->open();
}

void SnapshotsPage::askTemplateFile(const session::SharedSnapshot& from, const QStringList& keys)
{
    askFile(tr("Save the template"), QStringLiteral("template") + snapshotSuffix,
            {tr("Template (*.servo.json)")}, {}, [this, from, keys](const QString& path) {
                const auto made = m_snapshots.toTemplate(*from, keys, {QFileInfo(path).baseName()});
                if (made)
                    m_snapshots.save(*made, withSuffix(path, snapshotSuffix));
                else
                    showError(made.error());
            });
}

void SnapshotsPage::editNote()
{
    const auto kept = m_browser->selectedHistoryRow();
    if (!kept)
        return;
    auto* dialog = new NoteDialog(kept->label, kept->note, this);
    connect(dialog, &NoteDialog::accepted, this, [this, dialog, number = kept->number] {
        m_browser->invalidate(number);
        m_historyService.setSnapshotNote(number, dialog->label(), dialog->note());
    });
    dialog->open();
}

void SnapshotsPage::deleteSnapshots()
{
    const auto numbers = m_browser->selectedNumbers();
    if (numbers.empty())
        return;
    Question question;
    question.title = numbers.size() == 1 ? tr("Delete this snapshot?")
                                         : tr("Delete %1 snapshots?").arg(numbers.size());
    question.text = tr("They leave the history of this computer. Files stay where they are.");
    question.risk = tr("This cannot be undone.");
    question.acceptText = tr("Delete");
    question.guard = this;
    ask(this, question, [this, numbers] { m_historyService.removeSnapshots(numbers); });
}

bool SnapshotsPage::torqueIsOn(const jobs::RestorePlan& plan)
{
    return plan.servo.raw(catalog::Role::TorqueSwitch).value_or(0) != 0;
}

void SnapshotsPage::dryRun()
{
    const auto& now = m_pane->model().plan();
    if (!now || m_dryRunPending)
        return;
    // What the journal remembers is written back, too; it is asked where it may be waited for.
    const auto plan = std::make_shared<jobs::RestorePlan>(*now);
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
            showError(*end.error);
        else
            (new DryRunDialog(m_pane->model(), *plan, this))->open();
    };
    m_dryRunPending = true;
    m_desk.perform(m_selection.current(), std::move(task));
}

/// Asked about is what can hurt: a shaft that turns or drops, an address that changes, a row that
/// can make the servo unreachable. The rest is in sight anyway.
void SnapshotsPage::confirmWrite()
{
    const auto& now = m_pane->model().plan();
    if (!now)
        return;
    using jobs::RestoreReason;
    QStringList risks;
    bool consent = false;
    for (const jobs::RestoreWrite& one : jobs::plannedWrites(*now)) {
        const jobs::RestoreRow* row = now->find(one.key);
        const QString name = m_pane->model().nameOf(one.key);
        consent = consent || row->reasons.testFlag(RestoreReason::NeedsConsent);
        if (row->reasons.testFlag(RestoreReason::OtherModelLimit))
            risks << tr("%1 is a limit of another model (%2).").arg(name, now->sourceModel);
        else if (row->reasons.testFlag(RestoreReason::NeedsConsent))
            risks << tr("%1: a wrong value can make the servo unreachable or dangerous.").arg(name);
        if (row->reasons.testFlag(RestoreReason::WouldAlarm))
            risks << alarmLine(m_pane->model(), *row);
        if (row->reasons.testFlag(RestoreReason::MovesShaft))
            risks << tr("%1 shifts where the servo believes it is.").arg(name);
        if (row->reasons.testFlag(RestoreReason::Identity))
            risks << tr("%1 changes from %2 to %3: the servo answers there afterwards.")
                         .arg(name)
                         .arg(m_pane->model().formatted(one.key, one.from.value_or(0)),
                              m_pane->model().formatted(one.key, one.to));
    }
    const bool torque = torqueIsOn(*now);
    if (risks.isEmpty() && !torque) {
        sendPlan();
        return;
    }
    Question question;
    question.title = tr("Write to ID %1?").arg(now->id);
    if (torque)
        question.text = tr("Torque is on: it goes off first and stays off. What the servo holds "
                           "may drop.");
    question.risk = risks.join(QLatin1Char('\n'));
    question.acceptText = consent ? tr("Write anyway") : tr("Write");
    question.acceptIsDefault = risks.isEmpty();
    question.guard = this;
    ask(this, question, [this] { sendPlan(); });
}

void SnapshotsPage::sendPlan()
{
    const auto& now = m_pane->model().plan();
    const auto selectedSnapshots = m_browser->selectedSnapshots();
    if (!now || selectedSnapshots.empty() || m_writing)
        return;
    m_banner->hideMessage();
    session::RestoreRequest order;
    order.plan = *now;
    order.dangerous = now->needsConsent(); // asked for in write()
    order.onFailure = m_rollBack->isChecked() ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    order.guard = this;
    const QString source = selectedSnapshots.front().path.isEmpty()
                               ? selectedSnapshots.front().title
                               : selectedSnapshots.front().path;
    order.done = [this, source](const session::RestoreCompletion& end) { restored(end, source); };
    m_writing = true;
    showState();
    m_desk.restore(m_selection.current(), order);
}

namespace {
bool isApplied(const jobs::RestoreRowResult& row)
{
    return row.write.outcome == device::WriteOutcome::Kept ||
           row.write.outcome == device::WriteOutcome::Temporary;
}

bool isSuccess(const jobs::RestoreOutcome& outcome)
{
    return outcome.verdict == jobs::RestoreVerdict::Done ||
           outcome.verdict == jobs::RestoreVerdict::AlreadySet;
}

BannerText restoreOutcomeText(const jobs::RestoreOutcome& outcome, const CompareModel& model)
{
    const RegisterNames names{
        [&model](const QString& key) { return model.nameOf(key); },
        [&model](const QString& key, std::int64_t raw) { return model.formatted(key, raw); }};
    const auto good = std::count_if(outcome.rows.begin(), outcome.rows.end(), isApplied);
    QStringList others;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        if (!isApplied(row))
            others << names.name(row.write.key);
    }
    BannerText message;
    message.tone = isSuccess(outcome) ? Tone::Good : Tone::Bad;
    message.message = text::restoreVerdictText(jobs::verdictName(outcome.verdict));
    if (outcome.verdict != jobs::RestoreVerdict::RolledBack)
        message.message +=
            QStringLiteral(": ") +
            (good == 1 ? SnapshotsPage::tr("1 row written and read back")
                       : SnapshotsPage::tr("%1 rows written and read back").arg(good));
    QStringList cause;
    if (!others.isEmpty())
        cause << SnapshotsPage::tr("Not written, or not proven: %1.")
                     .arg(others.join(QStringLiteral(", ")));
    cause << notRolledBackText(outcome, names) << openLockText(outcome.lock);
    cause.removeAll(QString());
    message.cause = cause.join(QLatin1Char(' '));
    if (outcome.verdict == jobs::RestoreVerdict::Failed)
        message.remedy = restoreRemedy(outcome);
    return message;
}
} // namespace

void SnapshotsPage::restored(const session::RestoreCompletion& end, const QString& source)
{
    m_writing = false;
    m_results.clear();
    if (end.error) {
        showError(*end.error);
    } else if (end.outcome) {
        if (const session::ServoEntry* servo = entry())
            m_results.push_back(
                jobs::toRestoreResult(*end.outcome, servo->servo, source, session::programName()));
        // Ticked by hand for this one write: a dangerous row asks for it anew.
        for (const jobs::RestoreRowResult& row : end.outcome->rows) {
            if (isApplied(row))
                m_checks.erase(row.write.key);
        }
        m_bannerShowsRestore = true;
        m_banner->showMessage(
            [this, outcome = *end.outcome] { return restoreOutcomeText(outcome, m_pane->model()); },
            {m_saveResult});
    }
    m_desk.readTable(m_selection.current());
    scheduleRefresh();
    showState();
}

void SnapshotsPage::askResultFile()
{
    askFile(tr("Save the result"), QStringLiteral("restore-result.csv"),
            {tr("Table (*.csv)"), tr("Data (*.json)")}, QStringLiteral("csv"),
            [this, results = m_results](const QString& path) { m_snapshots.save(results, path); });
}

void SnapshotsPage::applyToSeveral()
{
    ApplySource source;
    source.bundle = m_browser->bundle();
    const auto selectedSnapshots = m_browser->selectedSnapshots();
    if (source.bundle) {
        source.name = QFileInfo(m_browser->bundlePath()).fileName();
    } else if (!selectedSnapshots.empty()) {
        source.name = selectedSnapshots.front().title;
        source.snapshot = selectedSnapshots.front().snapshot;
        const auto& now = m_pane->model().plan();
        for (const jobs::RestoreRow& row : now ? now->rows : std::vector<jobs::RestoreRow>{}) {
            if (!isTransferable(row))
                continue;
            source.only << row.key;
            source.dangerous =
                source.dangerous || row.reasons.testFlag(jobs::RestoreReason::NeedsConsent);
            if (row.reasons.testFlag(jobs::RestoreReason::OtherModelLimit))
                source.otherModelLimits << row.key;
        }
    } else {
        return;
    }
    (new ApplyDialog(m_desk, m_snapshots, std::move(source), this))->open();
}

void SnapshotsPage::showSaved(const QString& path)
{
    m_bannerShowsRestore = false;
    m_banner->showMessage([path] {
        return BannerText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
    });
}

void SnapshotsPage::showError(const base::Error& error)
{
    m_bannerShowsRestore = false;
    if (error.code != base::ErrorCode::Stopped)
        m_banner->showMessage(error);
    showState();
}
} // namespace ui

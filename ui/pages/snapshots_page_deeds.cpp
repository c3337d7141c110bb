// SPDX-License-Identifier: GPL-3.0-or-later
// What the snapshots page does.
#include "device/remembered_speed.h"
#include "record/factory_snapshot.h"
#include "session/restore_order.h"
#include "session/safety_snapshot.h"
#include "text/restore_words.h"
#include "ui/dialogs/apply_dialog.h"
#include "ui/dialogs/ask.h"
#include "ui/dialogs/dry_run_dialog.h"
#include "ui/dialogs/note_dialog.h"
#include "ui/dialogs/restore_words.h"
#include "ui/dialogs/template_dialog.h"
#include "ui/pages/snapshot_pane.h"
#include "ui/pages/snapshot_shelf.h"
#include "ui/pages/snapshots_page.h"
#include "ui/widgets/banner.h"

#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

namespace ui {
namespace {
const QString folderChoice = QStringLiteral("snapshots/folder");
const QString snapshotEnd = QStringLiteral(".servo.json");
const QString bundleEnd = QStringLiteral(".bundle.json");

/// A double suffix, which a file dialog does not add by itself.
QString withEnd(const QString& path, const QString& end)
{
    if (path.endsWith(QLatin1StringView(".csv"), Qt::CaseInsensitive) ||
        path.endsWith(end, Qt::CaseInsensitive))
        return path;
    return (path.endsWith(QLatin1StringView(".json"), Qt::CaseInsensitive) ? path.chopped(5)
                                                                           : path) +
           end;
}

/// What is ticked, and what this servo has already but others may not.
bool forOthers(const jobs::RestoreRow& row)
{
    using jobs::RestoreReason;
    if (row.reasons.testFlag(RestoreReason::Identity))
        return false;
    const jobs::RestoreReasons special =
        jobs::RestoreReasons(RestoreReason::Live) | RestoreReason::ReadOnly |
        RestoreReason::Factory | RestoreReason::NeedsConsent | RestoreReason::OffUnlessAsked;
    return row.ticked || (row.reasons.testFlag(RestoreReason::Same) && !(row.reasons & special));
}

QString fileWord(QString name)
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
    return m_settings.choice(folderChoice, QDir::homePath()).toString();
}

void SnapshotsPage::askFile(const QString& title, const QString& name, const QStringList& filters,
                            const QString& suffix, std::function<void(const QString&)> chosen)
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
            [this, chosen = std::move(chosen)](const QString& path) {
                m_settings.setChoice(folderChoice, QFileInfo(path).absolutePath());
                chosen(path);
            });
    dialog->open();
}

void SnapshotsPage::take()
{
    m_banner->clear();
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
        m_banner->clear();
        for (const QString& path : paths) {
            m_settings.setChoice(folderChoice, QFileInfo(path).absolutePath());
            m_snapshots.open(path);
        }
    });
    dialog->open();
}

void SnapshotsPage::saveCopy()
{
    const auto chosen = m_shelf->chosen();
    if (chosen.empty())
        return;
    const session::SharedSnapshot table = chosen.front().snapshot;
    const QString name = QStringLiteral("%1-id%2-%3")
                             .arg(fileWord(table->servo.model))
                             .arg(table->servo.id)
                             .arg(table->at.toLocalTime().toString(QStringLiteral("yyyyMMdd")));
    askFile(tr("Save the snapshot"), name + snapshotEnd,
            {tr("Snapshot (*.servo.json)"), tr("Table for spreadsheets (*.csv)")}, {},
            [this, table](const QString& path) {
                m_snapshots.save(table, withEnd(path, snapshotEnd));
            });
}

void SnapshotsPage::saveBundle()
{
    askFile(tr("Save all servos"), QStringLiteral("servos") + bundleEnd,
            {tr("Bundle (*.bundle.json)")}, {}, [this](const QString& path) {
                m_banner->clear();
                m_snapshots.takeAll({QFileInfo(path).baseName(), {}, withEnd(path, bundleEnd)});
            });
}

void SnapshotsPage::saveTemplate()
{
    const auto chosen = m_shelf->chosen();
    if (chosen.empty())
        return;
    const session::SharedSnapshot from = chosen.front().snapshot;
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
    askFile(tr("Save the template"), QStringLiteral("template") + snapshotEnd,
            {tr("Template (*.servo.json)")}, {}, [this, from, keys](const QString& path) {
                const auto made = m_snapshots.asTemplate(*from, keys, {QFileInfo(path).baseName()});
                if (made)
                    m_snapshots.save(*made, withEnd(path, snapshotEnd));
                else
                    fail(made.error());
            });
}

void SnapshotsPage::editNote()
{
    const auto kept = m_shelf->onlyKept();
    if (!kept)
        return;
    auto* dialog = new NoteDialog(kept->label, kept->note, this);
    connect(dialog, &NoteDialog::accepted, this, [this, dialog, number = kept->number] {
        m_shelf->forget(number);
        m_archive.setSnapshotNote(number, dialog->label(), dialog->note());
    });
    dialog->open();
}

void SnapshotsPage::removeKept()
{
    const auto numbers = m_shelf->chosenNumbers();
    if (numbers.empty())
        return;
    Question question;
    question.title = numbers.size() == 1 ? tr("Delete this snapshot?")
                                         : tr("Delete %1 snapshots?").arg(numbers.size());
    question.text = tr("They leave the history of this computer. Files stay where they are.");
    question.risk = tr("This cannot be undone.");
    question.yes = tr("Delete");
    question.guard = this;
    ask(this, question, [this, numbers] { m_archive.removeSnapshots(numbers); });
}

bool SnapshotsPage::torqueIsOn(const jobs::RestorePlan& plan)
{
    return plan.servo.raw(catalog::Role::TorqueSwitch).value_or(0) != 0;
}

void SnapshotsPage::dryRun()
{
    const auto& now = m_pane->model().plan();
    if (!now || m_dryRunComing)
        return;
    // What the journal remembers is written back, too; it is asked where it may be waited for.
    const auto plan = std::make_shared<jobs::RestorePlan>(*now);
    session::Task task;
    task.name = QStringLiteral("dry-run");
    task.quiet = true;
    task.work = [plan](session::TaskContext& context) -> base::Result<void> {
        const auto speed = device::rememberedSpeed(context.device.journal, plan->servo);
        if (!speed)
            return tl::unexpected(speed.error());
        plan->positionSpeed = *speed;
        return {};
    };
    task.guard = this;
    task.done = [this, plan](const session::TaskEnd& end) {
        m_dryRunComing = false;
        if (end.error)
            fail(*end.error);
        else
            (new DryRunDialog(m_pane->model(), *plan, this))->open();
    };
    m_dryRunComing = true;
    m_desk.perform(m_selection.current(), std::move(task));
}

/// Asked about is what can hurt: a shaft that turns or drops, an address that changes, a row that
/// can make the servo unreachable. The rest is in sight anyway.
void SnapshotsPage::write()
{
    const auto& now = m_pane->model().plan();
    if (!now)
        return;
    using jobs::RestoreReason;
    QStringList risks;
    bool consent = false;
    for (const jobs::RestoreWrite& one : jobs::writesOf(*now)) {
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
    question.yes = consent ? tr("Write anyway") : tr("Write");
    question.harmless = risks.isEmpty();
    question.guard = this;
    ask(this, question, [this] { sendPlan(); });
}

void SnapshotsPage::sendPlan()
{
    const auto& now = m_pane->model().plan();
    const auto chosen = m_shelf->chosen();
    if (!now || chosen.empty() || m_writing)
        return;
    m_banner->clear();
    session::RestoreOrder order;
    order.plan = *now;
    order.dangerous = now->needsConsent(); // asked for in write()
    order.onFailure = m_rollBack->isChecked() ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    order.guard = this;
    const QString source =
        chosen.front().path.isEmpty() ? chosen.front().title : chosen.front().path;
    order.done = [this, source](const session::RestoreEnd& end) { restored(end, source); };
    m_writing = true;
    showState();
    m_desk.restore(m_selection.current(), order);
}

namespace {
bool tookValue(const jobs::RestoreRowResult& row)
{
    return row.write.outcome == device::WriteOutcome::Kept ||
           row.write.outcome == device::WriteOutcome::Temporary;
}

bool wentWell(const jobs::RestoreOutcome& outcome)
{
    return outcome.verdict == jobs::RestoreVerdict::Done ||
           outcome.verdict == jobs::RestoreVerdict::AlreadySo;
}

BannerWords outcomeWords(const jobs::RestoreOutcome& outcome, const CompareModel& model)
{
    const RegisterNames names{
        [&model](const QString& key) { return model.nameOf(key); },
        [&model](const QString& key, std::int64_t raw) { return model.formatted(key, raw); }};
    const auto good = std::count_if(outcome.rows.begin(), outcome.rows.end(), tookValue);
    QStringList others;
    for (const jobs::RestoreRowResult& row : outcome.rows) {
        if (!tookValue(row))
            others << names.name(row.write.key);
    }
    BannerWords words;
    words.tone = wentWell(outcome) ? Tone::Good : Tone::Bad;
    words.what = text::restoreVerdictWords(jobs::verdictName(outcome.verdict));
    if (outcome.verdict != jobs::RestoreVerdict::RolledBack)
        words.what += QStringLiteral(": ") +
                      (good == 1 ? SnapshotsPage::tr("1 row written and read back")
                                 : SnapshotsPage::tr("%1 rows written and read back").arg(good));
    QStringList cause;
    if (!others.isEmpty())
        cause << SnapshotsPage::tr("Not written, or not proven: %1.")
                     .arg(others.join(QStringLiteral(", ")));
    cause << notPutBackWords(outcome, names) << lockWords(outcome.lock);
    cause.removeAll(QString());
    words.cause = cause.join(QLatin1Char(' '));
    if (outcome.verdict == jobs::RestoreVerdict::Failed)
        words.remedy = restoreRemedy(outcome);
    return words;
}
} // namespace

void SnapshotsPage::restored(const session::RestoreEnd& end, const QString& source)
{
    m_writing = false;
    m_results.clear();
    if (end.error) {
        fail(*end.error);
    } else if (end.outcome) {
        if (const session::ServoEntry* servo = entry())
            m_results.push_back(
                jobs::resultOf(*end.outcome, servo->servo, source, session::programName()));
        // Ticked by hand for this one write: a dangerous row asks for it anew.
        for (const jobs::RestoreRowResult& row : end.outcome->rows) {
            if (tookValue(row))
                m_ticks.erase(row.write.key);
        }
        m_tellsRestore = true;
        m_banner->present(
            [this, outcome = *end.outcome] { return outcomeWords(outcome, m_pane->model()); },
            {m_saveResult});
    }
    m_desk.readTable(m_selection.current());
    refreshSoon();
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
    source.bundle = m_shelf->bundle();
    const auto chosen = m_shelf->chosen();
    if (source.bundle) {
        source.name = QFileInfo(m_shelf->bundlePath()).fileName();
    } else if (!chosen.empty()) {
        source.name = chosen.front().title;
        source.snapshot = chosen.front().snapshot;
        const auto& now = m_pane->model().plan();
        for (const jobs::RestoreRow& row : now ? now->rows : std::vector<jobs::RestoreRow>{}) {
            if (!forOthers(row))
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

void SnapshotsPage::tellSaved(const QString& path)
{
    m_tellsRestore = false;
    m_banner->present([path] {
        return BannerWords{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
    });
}

void SnapshotsPage::fail(const base::Error& error)
{
    m_tellsRestore = false;
    if (error.code != base::ErrorCode::Stopped)
        m_banner->present(error);
    showState();
}
} // namespace ui

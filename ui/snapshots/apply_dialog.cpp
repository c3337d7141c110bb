// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/apply_dialog.h"

#include "session/snapshot/safety_snapshot.h"
#include "text/error_text.h"
#include "text/notice_text.h"
#include "text/restore_text.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/snapshots/restore_text.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
using jobs::ApplyVerdict;

namespace {
constexpr int applyWidth = 760;
constexpr int applyHeight = 520;

Tone toneOf(ApplyVerdict verdict)
{
    switch (verdict) {
    case ApplyVerdict::AlreadySet:
    case ApplyVerdict::Done:
        return Tone::Good;
    case ApplyVerdict::Planned:
        return Tone::Accent;
    case ApplyVerdict::RolledBack:
    case ApplyVerdict::OtherServo:
        return Tone::Warn;
    case ApplyVerdict::Failed:
    case ApplyVerdict::NoReply:
    case ApplyVerdict::Error:
        break;
    }
    return Tone::Bad;
}

QString symbolFor(Tone tone)
{
    return tone == Tone::Good     ? QStringLiteral("✔ ")
           : tone == Tone::Accent ? QStringLiteral("≠ ")
           : tone == Tone::Warn   ? QStringLiteral("⚠ ")
                                  : QStringLiteral("✘ ");
}

RegisterNames keyNames()
{
    return {[](const QString& key) { return key; },
            [](const QString&, std::int64_t raw) { return QString::number(raw); }};
}

/// "P gain 40 → 32" for each row that will be written, or the result of each.
QString details(const jobs::ApplyResult& one)
{
    QStringList lines;
    if (one.error)
        lines << text::describe(*one.error).message;
    if (one.outcome) {
        for (const jobs::RestoreRowResult& row : one.outcome->rows)
            lines << QStringLiteral("%1: %2 → %3, %4")
                         .arg(row.write.key)
                         .arg(qint64(row.write.oldRaw.value_or(0)))
                         .arg(qint64(row.write.newRaw))
                         .arg(text::outcomeLabel(device::outcomeName(row.write.outcome)));
        const QString left = notRolledBackText(*one.outcome, keyNames());
        if (!left.isEmpty())
            lines << left << restoreRemedy(*one.outcome);
    } else {
        for (const jobs::RestoreWrite& write : jobs::plannedWrites(one.plan))
            lines << QStringLiteral("%1: %2 → %3")
                         .arg(write.key)
                         .arg(qint64(write.from.value_or(0)))
                         .arg(qint64(write.to));
    }
    for (const jobs::RestoreRow* row : jobs::omittedRows(one.plan))
        lines << QStringLiteral("%1: %2").arg(
            row->key, text::restoreReasonText(jobs::restoreReasonNames(row->reasons)));
    return lines.join(QLatin1Char('\n'));
}

/// The result for one servo; with rows that were left out, a success is only a warning.
Tone toneOf(const jobs::ApplyResult& one)
{
    const Tone how = toneOf(one.verdict);
    return how == Tone::Good && !jobs::omittedRows(one.plan).empty() ? Tone::Warn : how;
}

bool hasProblem(const jobs::ApplyResult& one)
{
    const Tone how = toneOf(one.verdict);
    return how == Tone::Bad || how == Tone::Warn;
}
} // namespace

ApplyDialog::ApplyDialog(session::Workbench& workbench, session::Snapshots& snapshots,
                         ApplySource source, QWidget* parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_snapshots(snapshots)
    , m_source(std::move(source))
{
    setObjectName(QStringLiteral("applyDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    fillServos();
    build();
    followLanguage(this, [this] { retranslate(); });
    connect(&m_workbench.tasks(), &session::TaskQueue::taskChanged, this,
            &ApplyDialog::updateControls);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &ApplyDialog::updateControls);
    connect(&m_snapshots, &session::Snapshots::saved, this, [this](const QString& path) {
        m_result->showResult([path] {
            return TaskText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
        });
    });
    connect(&m_snapshots, &session::Snapshots::failed, this, [this](const base::Error& error) {
        m_result->showResult([error] { return errorText(error); });
    });
}

/// The servos of the bundle, or all writable servos of the list.
void ApplyDialog::fillServos()
{
    if (m_source.bundle) {
        for (const snapshot::Snapshot& one : m_source.bundle->servos)
            m_rows.push_back({one.servo.id, one.servo.model});
        return;
    }
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const session::ServoEntry* entry = m_workbench.registry().servo(ref);
        const bool here =
            !m_workbench.link().canSetBaud() || entry->servo.baud == m_workbench.link().baud();
        if (here && entry->servo.profile && entry->servo.profile->writable)
            m_rows.push_back({entry->servo.id, entry->servo.profile->modelName});
    }
}

void ApplyDialog::build()
{
    auto* column = new QVBoxLayout(this);
    m_summary = new QLabel(this);
    m_summary->setObjectName(QStringLiteral("applyWhat"));
    m_summary->setWordWrap(true);
    m_table = new QTableWidget(int(m_rows.size()), Count, this);
    m_table->setObjectName(QStringLiteral("applyTable"));
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    const QString model = m_source.snapshot ? m_source.snapshot->servo.model : QString();
    for (int row = 0; row < int(m_rows.size()); ++row) {
        for (int cell = 0; cell < Count; ++cell)
            m_table->setItem(row, cell, new QTableWidgetItem);
        QTableWidgetItem* tick = m_table->item(row, Servo);
        tick->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        const bool meant = m_source.bundle || m_rows[std::size_t(row)].model == model;
        tick->setCheckState(meant ? Qt::Checked : Qt::Unchecked);
        fillRow(row);
    }
    const auto check = [this](const char* name) {
        auto* made = new QCheckBox(this);
        made->setObjectName(QString::fromLatin1(name));
        return made;
    };
    m_rollBack = check("applyRollBack");
    m_otherModel = check("applyOtherModel");
    m_otherModel->setVisible(m_source.bundle != nullptr);
    m_dangerous = check("applyDangerous");
    m_dangerous->setVisible(m_source.bundle != nullptr);
    m_result = new TaskResult(applyWidth - 2 * dialogMargin, this);
    auto* row = new QHBoxLayout;
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(this);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        row->addWidget(made);
        return made;
    };
    m_dryRun = button("applyDryRun");
    m_save = button("applySave");
    row->addStretch();
    m_stop = button("applyStop");
    m_close = button("applyClose");
    m_write = button("applyWrite");
    makeMainAction(m_write);
    column->addWidget(m_summary);
    column->addWidget(m_table, 1);
    column->addWidget(m_rollBack);
    column->addWidget(m_otherModel);
    column->addWidget(m_dangerous);
    column->addWidget(m_result);
    column->addLayout(row);
    connect(m_table, &QTableWidget::itemChanged, this, &ApplyDialog::updateControls);
    connect(m_dryRun, &QPushButton::clicked, this, [this] { run(true); });
    connect(m_write, &QPushButton::clicked, this, &ApplyDialog::askForConfirmation);
    connect(m_stop, &QPushButton::clicked, this, [this] { m_workbench.tasks().stop(); });
    connect(m_save, &QPushButton::clicked, this, &ApplyDialog::askForSavePath);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    resize(applyWidth, applyHeight);
}

void ApplyDialog::fillRow(int row)
{
    const QSignalBlocker blocker(m_table);
    const Row& about = m_rows[std::size_t(row)];
    m_table->item(row, Servo)->setText(QStringLiteral("ID %1").arg(about.id));
    m_table->item(row, Model)->setText(about.model);
    QTableWidgetItem* rows = m_table->item(row, Rows);
    QTableWidgetItem* verdict = m_table->item(row, Verdict);
    if (!about.applied) {
        rows->setText(QString());
        verdict->setText(QString());
        return;
    }
    const jobs::ApplyResult& one = *about.applied;
    const std::size_t count =
        one.outcome ? one.outcome->rows.size() : jobs::plannedWrites(one.plan).size();
    rows->setText(QString::number(count));
    const Tone how = toneOf(one);
    const std::size_t left = jobs::omittedRows(one.plan).size();
    QString words = symbolFor(how) + text::restoreVerdictText(jobs::verdictName(one.verdict));
    if (one.outcome && !one.outcome->notReverted.isEmpty())
        words += QStringLiteral(" · ") + tr("old values not restored");
    if (left > 0)
        words += QStringLiteral(" · ") + tr("%n row(s) skipped", nullptr, int(left));
    const std::vector<const jobs::RestoreRow*> alarms = jobs::predictedAlarms(one.plan);
    const bool alarm = std::any_of(alarms.begin(), alarms.end(),
                                   [](const jobs::RestoreRow* limit) { return limit->selected; });
    if (alarm && !one.outcome)
        words += QStringLiteral(" · ✗ ") + tr("would cause an alarm now");
    verdict->setText(words);
    verdict->setData(toneRole, int(how));
    for (int cell = 0; cell < Count; ++cell)
        m_table->item(row, cell)->setToolTip(details(one));
}

void ApplyDialog::retranslate()
{
    setWindowTitle(m_source.bundle ? tr("Restore a bundle") : tr("Apply to several servos"));
    setAccessibleName(windowTitle());
    m_summary->setText(
        m_source.bundle
            ? tr("“%1”: each servo gets its own snapshot, matched by ID. IDs and baud rates are "
                 "never written here.")
                  .arg(m_source.name)
            : tr("“%1”: each selected servo is read, and only the rows that differ are written. "
                 "IDs and baud rates are never written here.")
                  .arg(m_source.name));
    m_table->setAccessibleName(tr("Servos"));
    m_table->setHorizontalHeaderLabels({tr("Servo"), tr("Model"), tr("Rows"), tr("Result")});
    const auto setTexts = [](QWidget* widget, const QString& name, const QString& tip) {
        if (auto* button = qobject_cast<QAbstractButton*>(widget))
            button->setText(name);
        widget->setAccessibleName(name);
        widget->setToolTip(tip);
    };
    setTexts(m_rollBack, tr("If a row fails, restore that servo's old values"),
             tr("If this option is not selected, writing to a servo stops at the failed row; "
                "values already written stay in the servo"));
    setTexts(m_otherModel, tr("Include IDs that now belong to another model"),
             tr("Matches registers by name; registers without a match are skipped and listed"));
    setTexts(m_dangerous, tr("Include dangerous rows"),
             tr("Also writes rows where a wrong value can make a servo unreachable"));
    setTexts(m_dryRun, tr("Dry run"),
             tr("Reads the servos and shows what would be written to "
                "each"));
    setTexts(m_write, tr("Write"), tr("Writes the differing rows to each selected servo"));
    setTexts(m_stop, tr("Stop"), tr("Stops after finishing the current servo"));
    setTexts(m_save, tr("Save result…"), tr("Saves the result for each row to a file"));
    setTexts(m_close, tr("Close"), tr("Closes this window"));
    for (int row = 0; row < int(m_rows.size()); ++row)
        fillRow(row);
    updateControls();
}

std::vector<int> ApplyDialog::selected() const
{
    std::vector<int> ids;
    for (int row = 0; row < int(m_rows.size()); ++row) {
        if (m_table->item(row, Servo)->checkState() == Qt::Checked)
            ids.push_back(m_rows[std::size_t(row)].id);
    }
    return ids;
}

void ApplyDialog::updateControls()
{
    const bool open =
        m_workbench.link().state() == session::LinkState::Open && !m_workbench.tasks().isTesting();
    const bool ready = open && !m_running && !selected().empty();
    m_dryRun->setEnabled(ready);
    m_write->setEnabled(ready);
    m_stop->setEnabled(m_running);
    m_save->setEnabled(m_written && !m_running);
    m_table->setEnabled(!m_running);
}

bool ApplyDialog::dangerous() const
{
    return m_source.bundle ? m_dangerous->isChecked() : m_source.dangerous;
}

void ApplyDialog::askForConfirmation()
{
    Question question;
    question.title = tr("Write to %n servo(s)?", nullptr, int(selected().size()));
    question.text = tr("Torque will be turned off on each servo before writing and will stay off.");
    if (dangerous())
        question.risk = tr("Dangerous rows are selected: a wrong value can make a servo "
                           "unreachable.");
    question.acceptText = tr("Write");
    question.acceptIsDefault = !dangerous();
    question.guard = this;
    ask(this, question, [this] { run(false); });
}

void ApplyDialog::run(bool dryRun)
{
    session::ApplyRequest order;
    const std::vector<int> ids = selected();
    if (m_source.bundle) {
        order.bundle = *m_source.bundle;
        auto& servos = order.bundle->servos;
        servos.erase(std::remove_if(servos.begin(), servos.end(),
                                    [&](const snapshot::Snapshot& one) {
                                        return std::find(ids.begin(), ids.end(), one.servo.id) ==
                                               ids.end();
                                    }),
                     servos.end());
    } else {
        order.snapshot = *m_source.snapshot;
        order.ids = ids;
    }
    order.options.choice.only = m_source.only;
    const auto consent = dangerous() ? device::Consent::confirmed() : device::Consent();
    order.options.choice.consent = consent;
    order.options.choice.otherModelLimits = m_source.otherModelLimits;
    order.options.restore.consent = consent;
    order.options.restore.onFailure =
        m_rollBack->isChecked() ? jobs::OnFailure::RollBack : jobs::OnFailure::Stop;
    order.options.otherModel = m_otherModel->isChecked();
    order.options.dryRun = dryRun;
    order.guard = this;
    order.onServo = [this](const jobs::ApplyResult& one) { addResult(one); };
    order.done = [this, dryRun](const session::ApplyCompletion& end) { onFinished(end, dryRun); };
    for (Row& row : m_rows)
        row.applied.reset();
    for (int row = 0; row < int(m_rows.size()); ++row)
        fillRow(row);
    m_running = true;
    m_written = false;
    m_result->clear();
    updateControls();
    m_workbench.restores().apply(std::move(order));
}

void ApplyDialog::addResult(const jobs::ApplyResult& one)
{
    for (int row = 0; row < int(m_rows.size()); ++row) {
        if (m_rows[std::size_t(row)].id != one.id)
            continue;
        m_rows[std::size_t(row)].applied = one;
        fillRow(row);
    }
}

void ApplyDialog::onFinished(const session::ApplyCompletion& end, bool dryRun)
{
    m_running = false;
    m_written = !dryRun && !end.servos.empty();
    updateControls();
    if (end.error) {
        m_result->showResult([error = *end.error] { return errorText(error); });
        return;
    }
    const auto failedCount = std::count_if(end.servos.begin(), end.servos.end(), hasProblem);
    const std::size_t all = end.servos.size();
    const auto partly =
        std::count_if(end.servos.begin(), end.servos.end(), [](const jobs::ApplyResult& one) {
            return !jobs::omittedRows(one.plan).empty();
        });
    m_result->showResult([dryRun, failedCount, partly, all] {
        if (failedCount > 0)
            return TaskText{
                Tone::Bad,
                tr("The operation failed for %1 of %2 servos; their tooltips show the reason.")
                    .arg(failedCount)
                    .arg(all)};
        if (partly > 0 && !dryRun)
            return TaskText{Tone::Warn, tr("Written, but rows were skipped on %1 of %2 servos; "
                                           "their tooltips show which rows and why.")
                                            .arg(partly)
                                            .arg(all)};
        return TaskText{Tone::Good, dryRun ? tr("Nothing was written. Each servo's tooltip lists "
                                                "the rows that would be written.")
                                           : tr("All %1 servos match the snapshot.").arg(all)};
    });
}

void ApplyDialog::askForSavePath()
{
    std::vector<snapshot::RestoreResult> results;
    for (const Row& row : m_rows) {
        if (row.applied && row.applied->outcome && row.applied->servo)
            results.push_back(jobs::toRestoreResult(*row.applied->outcome, *row.applied->servo,
                                                    m_source.name, session::programName()));
    }
    ui::askForSavePath(this,
                       {QStringLiteral("applyFileDialog"),
                        tr("Save the result"),
                        {tr("Table for spreadsheets (*.csv)"), tr("Data (*.json)")},
                        QStringLiteral("restore-result.csv")},
                       [this, results](const QString& path) { m_snapshots.save(results, path); });
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/apply_dialog.h"

#include "session/snapshot/safety_snapshot.h"
#include "text/error_text.h"
#include "text/notice_text.h"
#include "text/restore_text.h"
#include "ui/snapshots/restore_text.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
using jobs::ApplyVerdict;

namespace {
constexpr int initialWidth = 760;
constexpr int initialHeight = 520;
constexpr int margin = 24;

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

/// "P gain 40 → 32" for each row to come, or what became of each.
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

/// What happened to it; rows that were left out make a good end no better than a warning.
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

ApplyDialog::ApplyDialog(session::Desk& desk, session::Snapshots& snapshots, ApplySource source,
                         QWidget* parent)
    : QDialog(parent)
    , m_desk(desk)
    , m_snapshots(snapshots)
    , m_source(std::move(source))
{
    setObjectName(QStringLiteral("applyDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    fillServos();
    build();
    retranslate();
    connect(&m_desk, &session::Desk::taskChanged, this, &ApplyDialog::updateControls);
    connect(&m_desk, &session::Desk::linkChanged, this, &ApplyDialog::updateControls);
    connect(&m_snapshots, &session::Snapshots::saved, this, [this](const QString& path) {
        m_result->showResult([path] {
            return TaskText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
        });
    });
    connect(&m_snapshots, &session::Snapshots::failed, this, [this](const base::Error& error) {
        m_result->showResult([error] { return errorText(error); });
    });
}

/// The servos of the bundle, or all of the list that can be written to.
void ApplyDialog::fillServos()
{
    if (m_source.bundle) {
        for (const record::Snapshot& one : m_source.bundle->servos)
            m_rows.push_back({one.servo.id, one.servo.model});
        return;
    }
    for (const session::ServoRef ref : m_desk.servos()) {
        const session::ServoEntry* entry = m_desk.servo(ref);
        const bool here = !m_desk.canSetBaud() || entry->servo.baud == m_desk.baud();
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
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
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
    m_result = new TaskResult(initialWidth - margin, this);
    auto* row = new QHBoxLayout;
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(this);
        made->setObjectName(QString::fromLatin1(name));
        made->setAutoDefault(false);
        row->addWidget(made);
        return made;
    };
    m_dryRun = button("applyDryRun");
    m_write = button("applyWrite");
    m_write->setProperty("mainAction", true);
    m_stop = button("applyStop");
    row->addStretch();
    m_save = button("applySave");
    m_close = button("applyClose");
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
    connect(m_stop, &QPushButton::clicked, this, [this] { m_desk.stopTask(); });
    connect(m_save, &QPushButton::clicked, this, &ApplyDialog::askForSavePath);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    resize(initialWidth, initialHeight);
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
        words += QStringLiteral(" · ") + tr("old values not put back");
    if (left > 0)
        words += QStringLiteral(" · ") +
                 (left == 1 ? tr("1 row left out") : tr("%1 rows left out").arg(left));
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
            ? tr("“%1”: each servo gets its own snapshot, by its ID. IDs and rates are never "
                 "written here.")
                  .arg(m_source.name)
            : tr("“%1”: each ticked servo is read and gets the rows that differ. IDs and rates "
                 "are never written here.")
                  .arg(m_source.name));
    m_table->setAccessibleName(tr("Servos"));
    m_table->setHorizontalHeaderLabels({tr("Servo"), tr("Model"), tr("Rows"), tr("Verdict")});
    const auto setTexts = [](QWidget* widget, const QString& name, const QString& tip) {
        if (auto* button = qobject_cast<QAbstractButton*>(widget))
            button->setText(name);
        widget->setAccessibleName(name);
        widget->setToolTip(tip);
    };
    setTexts(m_rollBack, tr("If a row fails, put this servo back as it was"),
             tr("Otherwise writing to this servo ends at the row that fails, and what is written "
                "stays"));
    setTexts(m_otherModel, tr("Also where another model has the ID now"),
             tr("By register name; what cannot be mapped is left out and listed"));
    setTexts(m_dangerous, tr("Dangerous rows too"),
             tr("Rows in which a wrong value can make a servo unreachable; left out otherwise"));
    setTexts(m_dryRun, tr("Dry run"), tr("Read the servos and show what would be written to each"));
    setTexts(m_write, tr("Write"), tr("Write the rows that differ to each ticked servo"));
    setTexts(m_stop, tr("Stop"), tr("Stop after the servo that is being written to"));
    setTexts(m_save, tr("Save result…"), tr("Save what became of each row as a file"));
    setTexts(m_close, tr("Close"), tr("Close this window"));
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
    const bool open = m_desk.state() == session::LinkState::Open && !m_desk.isTesting();
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
    question.title = tr("Write to %1 servos?").arg(selected().size());
    question.text = tr("Torque goes off at each servo that is written to, and stays off.");
    if (dangerous())
        question.risk = tr("Dangerous rows are among those that are ticked: a wrong value can make "
                           "a servo unreachable.");
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
                                    [&](const record::Snapshot& one) {
                                        return std::find(ids.begin(), ids.end(), one.servo.id) ==
                                               ids.end();
                                    }),
                     servos.end());
    } else {
        order.snapshot = *m_source.snapshot;
        order.ids = ids;
    }
    order.options.choice.only = m_source.only;
    order.options.choice.dangerous = dangerous();
    order.options.choice.otherModelLimits = m_source.otherModelLimits;
    order.options.restore.dangerous = dangerous();
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
    m_desk.apply(std::move(order));
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
            return TaskText{Tone::Bad,
                            tr("%1 of %2 servos did not come to it; the tooltip of each says why.")
                                .arg(failedCount)
                                .arg(all)};
        if (partly > 0 && !dryRun)
            return TaskText{Tone::Warn,
                            tr("Written, but rows were left out at %1 of %2 servos; the tooltip "
                               "of each says which and why.")
                                .arg(partly)
                                .arg(all)};
        return TaskText{Tone::Good,
                        dryRun ? tr("Nothing was written. The tooltip of each servo lists its "
                                    "rows.")
                               : tr("All %1 servos are as the snapshot says.").arg(all)};
    });
}

void ApplyDialog::askForSavePath()
{
    std::vector<record::RestoreResult> results;
    for (const Row& row : m_rows) {
        if (row.applied && row.applied->outcome && row.applied->servo)
            results.push_back(jobs::toRestoreResult(*row.applied->outcome, *row.applied->servo,
                                                    m_source.name, session::programName()));
    }
    auto* dialog = new QFileDialog(this, tr("Save the result"));
    dialog->setObjectName(QStringLiteral("applyFileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Table (*.csv)"), tr("Data (*.json)")});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(QStringLiteral("restore-result.csv"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, results](const QString& path) { m_snapshots.save(results, path); });
    dialog->open();
}

void ApplyDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_close != nullptr)
        retranslate();
}
} // namespace ui

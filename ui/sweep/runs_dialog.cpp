// SPDX-License-Identifier: GPL-3.0-or-later
// What its buttons do is in runs_dialog_actions.cpp.
#include "ui/sweep/runs_dialog.h"

#include "ui/widgets/tone_delegate.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int initialWidth = 940;
constexpr int initialHeight = 520;
constexpr int margin = 24;
} // namespace

RunsDialog::RunsDialog(session::HistoryService& historyService, session::Settings& settings,
                       QWidget* parent)
    : QDialog(parent)
    , m_historyService(historyService)
    , m_settings(settings)
    , m_model(new RunsModel(this))
    , m_hint(new QLabel(this))
    , m_filter(new QLineEdit(this))
    , m_table(new QTableView(this))
    , m_result(new TaskResult(initialWidth - margin, this))
    , m_report(new QPushButton(this))
    , m_compare(new QPushButton(this))
    , m_reference(new QPushButton(this))
    , m_label(new QPushButton(this))
    , m_delete(new QPushButton(this))
    , m_close(new QPushButton(this))
{
    setObjectName(QStringLiteral("runsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&historyService, &session::HistoryService::changed, this, &RunsDialog::query);
    connect(&historyService, &session::HistoryService::failed, this, &RunsDialog::showError);
    connect(m_filter, &QLineEdit::textChanged, this, &RunsDialog::query);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &RunsDialog::updateButtons);
    connect(m_report, &QPushButton::clicked, this, &RunsDialog::openReport);
    connect(m_compare, &QPushButton::clicked, this, &RunsDialog::compare);
    connect(m_reference, &QPushButton::clicked, this, &RunsDialog::markReference);
    connect(m_label, &QPushButton::clicked, this, &RunsDialog::editLabel);
    connect(m_delete, &QPushButton::clicked, this, &RunsDialog::removeRuns);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
    query();
}

void RunsDialog::build()
{
    m_hint->setObjectName(QStringLiteral("runsHint"));
    m_hint->setWordWrap(true);
    m_filter->setObjectName(QStringLiteral("runsFilter"));
    m_filter->setClearButtonEnabled(true);
    m_table->setObjectName(QStringLiteral("runs"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setWordWrap(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setTabKeyNavigation(false);
    auto* row = new QHBoxLayout;
    const std::pair<QPushButton*, const char*> buttons[] = {
        {m_report, "runsReport"}, {m_compare, "runsCompare"}, {m_reference, "runsReference"},
        {m_label, "runsLabel"},   {m_delete, "runsDelete"},   {m_close, "runsClose"}};
    for (const auto& [button, name] : buttons) {
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        if (button == m_close)
            row->addStretch();
        row->addWidget(button);
    }
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->addWidget(m_filter);
    column->addWidget(m_table, 1);
    column->addWidget(m_hint);
    column->addWidget(m_result);
    column->addLayout(row);
    setMinimumSize(initialWidth, initialHeight);
}

void RunsDialog::retranslate()
{
    setWindowTitle(tr("Earlier tests"));
    setAccessibleName(windowTitle());
    const auto setTexts = [](QWidget* widget, const QString& name, const QString& tip) {
        widget->setAccessibleName(name);
        widget->setToolTip(tip);
    };
    const auto word = [&](QPushButton* button, const QString& text, const QString& tip) {
        button->setText(text);
        setTexts(button, text, tip);
    };
    m_filter->setPlaceholderText(tr("Model, firmware, label, note, operator or port"));
    setTexts(m_filter, tr("Filter"), tr("Show only tests with this text"));
    setTexts(m_table, tr("Earlier tests"), tr("One row for each servo of a test, newest first"));
    word(m_report, tr("Save report…"), tr("Save the report of the selected test as a page"));
    word(m_compare, tr("Compare two"),
         tr("Hold two selected tests against each other; the one "
            "marked as reference, else the older one, is A"));
    word(m_label, tr("Label…"),
         tr("Give the servo in the selected test a name: servos carry no serial number"));
    word(m_delete, tr("Delete…"), tr("Delete the selected tests from the history"));
    word(m_close, tr("Close"), tr("Close this window"));
    m_model->retranslate();
    updateButtons();
}

void RunsDialog::query()
{
    record::RunFilter filter;
    filter.kind = QStringLiteral("sweep");
    filter.text = m_filter->text().trimmed();
    const int asked = ++m_queryId;
    m_historyService.list(filter, this, [this, asked](const auto& runs) {
        if (asked == m_queryId)
            fill(runs);
    });
}

void RunsDialog::fill(const base::Result<std::vector<record::TestRun>>& runs)
{
    if (!runs) {
        showError(runs.error());
        return;
    }
    std::vector<RunRow> selected;
    for (const int row : rows())
        selected.push_back(m_model->at(row));
    m_model->show(*runs);
    for (const RunRow& one : selected) {
        if (const int row = m_model->rowOf(one); row >= 0)
            m_table->selectionModel()->select(
                m_model->index(row, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
    if (!m_loaded && m_model->rowCount() > 0) {
        m_loaded = true; // later the widths are the user's
        for (int column = 0; column < m_model->columnCount() - 1; ++column)
            m_table->resizeColumnToContents(column);
    }
    updateButtons();
}

std::vector<int> RunsDialog::rows() const
{
    std::vector<int> found;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        found.push_back(index.row());
    std::sort(found.begin(), found.end());
    return found;
}

/// Empty: it can be one.
QString RunsDialog::noReferenceReason(const record::TestRun& run, const record::TestServo& servo)
{
    if (!record::canBeReference(run))
        return tr("This test did not finish, so it cannot be a reference");
    return record::canBeReference(run, servo)
               ? QString()
               : tr("This servo failed the test, so it cannot be a reference");
}

void RunsDialog::updateButtons()
{
    const std::vector<int> chosen = rows();
    const bool one = chosen.size() == 1;
    m_report->setEnabled(one);
    m_label->setEnabled(one);
    const bool is = one && m_model->servo(chosen.front()).reference;
    QString refusal;
    if (one && !is)
        refusal = noReferenceReason(m_model->run(chosen.front()), m_model->servo(chosen.front()));
    m_reference->setEnabled(one && refusal.isEmpty());
    m_compare->setEnabled(chosen.size() == 2);
    m_delete->setEnabled(!chosen.empty());
    m_reference->setText(is ? tr("Clear reference") : tr("Mark as reference"));
    m_reference->setAccessibleName(m_reference->text());
    const QString mark = !refusal.isEmpty()
                             ? refusal
                             : tr("Hold later tests of this model against this servo; a model has "
                                  "one reference");
    m_reference->setToolTip(is ? tr("This servo is no longer what others are held against") : mark);
    if (m_model->rowCount() == 0)
        m_hint->setText(m_filter->text().trimmed().isEmpty()
                            ? tr("No test has been run yet. Tests of the window and of the "
                                 "command line are kept here.")
                            : tr("No test fits this filter."));
    else
        m_hint->setText(tr("Select two rows to hold one against the other. Servos carry no serial "
                           "number: who is who is told by model, firmware, ID and your label."));
}

void RunsDialog::showError(const base::Error& error)
{
    m_result->showResult([error] { return errorText(error); });
}

void RunsDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_close != nullptr)
        retranslate();
}
} // namespace ui

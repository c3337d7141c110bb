// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/run_list_dialog.h"

#include "ui/common/widget_style.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/tone_delegate.h"

#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
constexpr int runsWidth = 940;
constexpr int runsHeight = 520;
} // namespace

RunListDialog::RunListDialog(session::HistoryService& historyService, const QString& kind,
                             QWidget* parent)
    : QDialog(parent)
    , m_historyService(historyService)
    , m_model(new RunsModel(this))
    , m_hint(new QLabel(this))
    , m_table(new QTableView(this))
    , m_result(new TaskResult(runsWidth - 2 * dialogMargin, this))
    , m_kind(kind)
    , m_filter(new QLineEdit(this))
    , m_buttons(new QHBoxLayout)
    , m_label(addButton("runsLabel"))
    , m_delete(addButton("runsDelete"))
    , m_close(addButton("runsClose"))
{
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(&historyService, &session::HistoryService::changed, this, &RunListDialog::query);
    connect(&historyService, &session::HistoryService::failed, this, &RunListDialog::showError);
    connect(m_filter, &QLineEdit::textChanged, this, &RunListDialog::query);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            [this] { updateButtons(); });
    connect(m_label, &QPushButton::clicked, this, &RunListDialog::editLabel);
    connect(m_delete, &QPushButton::clicked, this, &RunListDialog::removeRuns);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void RunListDialog::build()
{
    m_ownButtons = 0;
    m_hint->setObjectName(QStringLiteral("runsHint"));
    m_hint->setWordWrap(true);
    m_filter->setObjectName(QStringLiteral("runsFilter"));
    m_filter->setClearButtonEnabled(true);
    m_table->setObjectName(QStringLiteral("runs"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    styleTable(m_table);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_buttons->insertStretch(m_buttons->count() - 1);
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->addWidget(m_filter);
    column->addWidget(m_table, 1);
    column->addWidget(m_hint);
    column->addWidget(m_result);
    column->addLayout(m_buttons);
    setMinimumSize(runsWidth, runsHeight);
}

QPushButton* RunListDialog::addButton(const char* name)
{
    auto* button = new QPushButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    m_buttons->insertWidget(m_ownButtons++, button);
    return button;
}

void RunListDialog::setButtonText(QPushButton* button, const QString& text, const QString& tip)
{
    button->setText(text);
    button->setAccessibleName(text);
    button->setToolTip(tip);
}

void RunListDialog::hideColumns(std::initializer_list<RunColumn> columns)
{
    for (const RunColumn column : columns)
        m_table->setColumnHidden(int(column), true);
}

void RunListDialog::retranslate()
{
    setAccessibleName(windowTitle());
    m_filter->setPlaceholderText(tr("Model, firmware, label, note, operator or port"));
    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setToolTip(tr("Shows only tests that contain this text"));
    m_table->setAccessibleName(tr("Earlier tests"));
    m_table->setToolTip(tr("One row for each servo in a test, newest first"));
    setButtonText(
        m_label, tr("Label…"),
        tr("Labels the servo in the selected test; servos have no serial number to identify them"));
    setButtonText(m_delete, tr("Delete…"), tr("Deletes the selected tests from the history"));
    setButtonText(m_close, tr("Close"), tr("Closes this window"));
    m_model->retranslate();
    updateButtons();
}

void RunListDialog::query()
{
    history::RunFilter filter;
    filter.kind = m_kind;
    filter.text = m_filter->text().trimmed();
    const int asked = ++m_queryId;
    m_historyService.list(filter, this, [this, asked](const auto& runs) {
        if (asked == m_queryId)
            fill(runs);
    });
}

void RunListDialog::fill(const base::Result<std::vector<history::TestRun>>& runs)
{
    if (!runs) {
        showError(runs.error());
        return;
    }
    std::vector<RunRow> selected;
    for (const int row : rows())
        selected.push_back(m_model->at(row));
    m_model->show(*runs);
    m_hasList = true;
    for (const RunRow& one : selected) {
        if (const int row = m_model->rowOf(one); row >= 0)
            m_table->selectionModel()->select(
                m_model->index(row, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
    }
    if (!m_loaded && m_model->rowCount() > 0) {
        m_loaded = true; // from now on the user sets the widths
        for (int column = 0; column < m_model->columnCount() - 1; ++column)
            m_table->resizeColumnToContents(column);
    }
    updateButtons();
}

std::vector<int> RunListDialog::rows() const
{
    std::vector<int> found;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        found.push_back(index.row());
    std::sort(found.begin(), found.end());
    return found;
}

void RunListDialog::updateButtons()
{
    const std::size_t chosen = rows().size();
    m_label->setEnabled(chosen == 1);
    m_delete->setEnabled(chosen > 0);
}

/// In place of the list if there is nothing to list.
void RunListDialog::showHint(const QString& hint)
{
    const bool empty = m_hasList && m_model->rowCount() == 0;
    const QString why = m_filter->text().trimmed().isEmpty()
                            ? tr("No tests yet. All tests run in this program or from the command "
                                 "line are stored here.")
                            : tr("No test matches this filter.");
    m_table->setVisible(!empty);
    m_hint->setText(empty ? why : hint);
    m_hint->setAlignment(empty ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter);
    m_hint->setForegroundRole(empty ? QPalette::PlaceholderText : QPalette::NoRole);
    m_hint->setSizePolicy(QSizePolicy::Preferred,
                          empty ? QSizePolicy::Expanding : QSizePolicy::Preferred);
}

void RunListDialog::showError(const base::Error& error)
{
    m_result->showResult([error] { return errorText(error); });
}

void RunListDialog::editLabel()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 1)
        return;
    const RunRow row = m_model->at(chosen.front());
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("runsLabelDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Label"));
    dialog->setLabelText(tr("Label of this servo, as written on it:"));
    dialog->setTextValue(m_model->servo(chosen.front()).label);
    connect(dialog, &QInputDialog::textValueSelected, this, [this, row](const QString& words) {
        m_historyService.setLabel(row.number, row.servo, words.trimmed());
    });
    dialog->open();
}

void RunListDialog::removeRuns()
{
    std::vector<std::int64_t> numbers;
    for (const int row : rows()) {
        const std::int64_t number = m_model->run(row).number;
        if (std::find(numbers.begin(), numbers.end(), number) == numbers.end())
            numbers.push_back(number);
    }
    if (numbers.empty())
        return;
    Question question;
    question.title = tr("Delete %n test(s)?", nullptr, int(numbers.size()));
    question.text = deletionText();
    question.risk = tr("This cannot be undone.");
    question.acceptText = tr("Delete");
    question.guard = this;
    ui::ask(this, question, [this, numbers] { m_historyService.remove(numbers); });
}
} // namespace ui

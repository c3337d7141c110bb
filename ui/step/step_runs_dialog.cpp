// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_runs_dialog.h"

#include "session/step/step_test.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/follow_language.h"
#include "ui/step/step_text.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>

namespace ui {
StepRunsDialog::StepRunsDialog(session::HistoryService& historyService,
                               const catalog::Catalog& catalog, QWidget* parent)
    : RunListDialog(historyService, QStringLiteral("step"), parent)
    , m_catalog(catalog)
    , m_open(addButton("runsOpen"))
{
    setObjectName(QStringLiteral("stepRunsDialog"));
    rememberSize(*this);
    hideColumns({RunColumn::Verdict, RunColumn::Reference});
    connect(m_open, &QPushButton::clicked, this, &StepRunsDialog::openSelected);
    connect(m_table, &QTableView::activated, this, &StepRunsDialog::openSelected);
    followLanguage(this, [this] { retranslate(); });
    query();
}

void StepRunsDialog::retranslate()
{
    setWindowTitle(tr("Earlier step responses"));
    setButtonText(m_open, tr("Open"),
                  tr("Shows the selected run on the Step response page, or compares two selected "
                     "runs there"));
    m_detailsOf = 0;
    RunListDialog::retranslate();
}

void StepRunsDialog::updateButtons()
{
    RunListDialog::updateButtons();
    const std::vector<int> chosen = rows();
    m_open->setEnabled(!chosen.empty() && chosen.size() <= session::StepTest::maxOpened);
    const std::int64_t number = chosen.size() == 1 ? m_model->run(chosen.front()).number : 0;
    if (number != 0 && number == m_detailsOf)
        return;
    m_detailsOf = number;
    showHint(tr("Select one run to open it, or two to compare them."));
    if (number != 0)
        showDetails(number);
}

/// The list has no gains: they are in the run.
void StepRunsDialog::showDetails(std::int64_t number)
{
    m_historyService.loadStep(number, this,
                              [this, number](const base::Result<session::SharedStep>& run) {
                                  if (!run)
                                      showError(run.error());
                                  else if (number == m_detailsOf)
                                      showHint(stepDetailsText(**run, m_catalog));
                              });
}

QString StepRunsDialog::deletionText() const
{
    return tr("The metrics, responses and settings of these runs are deleted from the history. "
              "Report files are kept.");
}

void StepRunsDialog::openSelected()
{
    if (!m_open->isEnabled())
        return;
    std::vector<std::int64_t> numbers;
    for (const int row : rows())
        numbers.insert(numbers.begin(), m_model->run(row).number); // the newest is at the top
    accept();
    Q_EMIT openRequested(numbers);
}
} // namespace ui

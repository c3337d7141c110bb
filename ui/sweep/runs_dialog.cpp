// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/runs_dialog.h"

#include "report/sweep_compare_text.h"
#include "report/sweep_html.h"
#include "session/sweep/sweep_report.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/sweep/compare_dialog.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace ui {
RunsDialog::RunsDialog(session::HistoryService& historyService, session::Settings& settings,
                       QWidget* parent)
    : RunListDialog(historyService, QStringLiteral("sweep"), parent)
    , m_settings(settings)
    , m_report(addButton("runsReport"))
    , m_compare(addButton("runsCompare"))
    , m_reference(addButton("runsReference"))
{
    setObjectName(QStringLiteral("runsDialog"));
    rememberSize(*this);
    connect(m_report, &QPushButton::clicked, this, &RunsDialog::openReport);
    connect(m_compare, &QPushButton::clicked, this, &RunsDialog::compare);
    connect(m_reference, &QPushButton::clicked, this, &RunsDialog::markReference);
    followLanguage(this, [this] { retranslate(); });
    query();
}

void RunsDialog::retranslate()
{
    setWindowTitle(tr("Earlier tests"));
    setButtonText(m_report, tr("Save report…"),
                  tr("Saves the report of the selected test as a web page"));
    setButtonText(m_compare, tr("Compare two"),
                  tr("Compares the two selected tests; A is the one marked as reference, "
                     "otherwise the older one"));
    RunListDialog::retranslate();
}

/// Empty: it can be one.
QString RunsDialog::noReferenceReason(const history::TestRun& run, const history::TestServo& servo)
{
    if (!history::canBeReference(run))
        return tr("This test did not finish, so it cannot be a reference");
    return history::canBeReference(run, servo)
               ? QString()
               : tr("This servo failed the test, so it cannot be a reference");
}

void RunsDialog::updateButtons()
{
    RunListDialog::updateButtons();
    const std::vector<int> chosen = rows();
    const bool one = chosen.size() == 1;
    m_report->setEnabled(one);
    m_compare->setEnabled(chosen.size() == 2);
    const bool isReference = one && m_model->servo(chosen.front()).reference;
    QString refusal;
    if (one && !isReference)
        refusal = noReferenceReason(m_model->run(chosen.front()), m_model->servo(chosen.front()));
    m_reference->setEnabled(one && refusal.isEmpty());
    const QString mark = !refusal.isEmpty()
                             ? refusal
                             : tr("Uses this servo's test as the reference for later tests of this "
                                  "model; each model has one reference");
    setButtonText(m_reference, isReference ? tr("Clear reference") : tr("Mark as reference"),
                  isReference ? tr("Stops using this servo as the reference") : mark);
    showHint(tr("Select two rows to compare them. Servos have no serial number; they are "
                "identified by model, firmware, ID and label."));
}

QString RunsDialog::deletionText() const
{
    return tr("The metrics, moves and settings of all servos in these tests are deleted from the "
              "history. Saved report and data files are kept.");
}

void RunsDialog::openReport()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 1)
        return;
    const RunRow row = m_model->at(chosen.front());
    const QStringList files = m_model->run(chosen.front()).files;
    askForSavePath(this,
                   {QStringLiteral("runsReportDialog"),
                    tr("Save the report"),
                    {tr("Web page (*.html)")},
                    QStringLiteral("sweep-%1.html").arg(qint64(row.number)),
                    &m_settings,
                    reportFolderKey()},
                   [this, row, files](const QString& path) { saveReport(row, path, files); });
}

/// The readings are not in the history, so the page has no curves of position; where their file is
/// still there it goes beside the page.
void RunsDialog::saveReport(const RunRow& row, const QString& path, const QStringList& files)
{
    const auto found = std::find_if(files.begin(), files.end(), [](const QString& file) {
        return file.endsWith(QLatin1StringView(".readings.csv")) && QFile::exists(file);
    });
    const QString readings = found != files.end() ? *found : QString();
    m_historyService.load(
        row.number, this, [this, path, readings](const base::Result<session::SharedRun>& run) {
            if (!run) {
                showError(run.error());
                return;
            }
            const bool chinese = text::isUiChinese();
            m_historyService.runInOrder(
                [run = *run, chinese, path, readings] {
                    const auto saved = report::saveSweepHtml(*run, {}, chinese, path);
                    return saved ? session::copySweepReadings(readings, path) : saved;
                },
                this,
                [this, path](const base::Result<void>& saved) {
                    if (saved)
                        showSaved(path);
                    else
                        showError(saved.error());
                });
        });
}

void RunsDialog::showSaved(const QString& path)
{
    m_result->showResult([path] {
        return TaskText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
    });
}

/// A is the reference, otherwise the older one.
void RunsDialog::compare()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 2)
        return;
    int a = chosen[1]; // the newest stands at the top
    int b = chosen[0];
    const auto isReference = [this](int row) {
        const history::TestServo& servo = m_model->servo(row);
        return servo.reference && history::canBeReference(m_model->run(row), servo);
    };
    if (isReference(b) && !isReference(a))
        std::swap(a, b);
    const RunRow one = m_model->at(a);
    const RunRow two = m_model->at(b);
    m_historyService.load(
        one.number, this, [=, this](const base::Result<session::SharedRun>& first) {
            if (!first) {
                showError(first.error());
                return;
            }
            m_historyService.load(
                two.number, this,
                [=, this, first = *first](const base::Result<session::SharedRun>& second) {
                    if (!second) {
                        showError(second.error());
                        return;
                    }
                    auto* dialog = new CompareDialog(
                        m_historyService, m_settings,
                        {QString::number(qint64(one.number)), first, one.servo},
                        {QString::number(qint64(two.number)), *second, two.servo}, this);
                    dialog->open();
                });
        });
}

void RunsDialog::markReference()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 1)
        return;
    const RunRow row = m_model->at(chosen.front());
    m_historyService.setReference(row.number, row.servo, !m_model->servo(chosen.front()).reference);
}

QString referenceText(const session::ReferenceResult& result)
{
    const QString when =
        QLocale().toString(result.run.at.toLocalTime().date(), QLocale::ShortFormat);
    if (result.ignored)
        return RunsDialog::tr(
                   "The reference %1 (test %2, %3) is ignored because that test did not finish. "
                   "Under Earlier tests, mark a completed test as the reference.")
            .arg(result.reference.model)
            .arg(qint64(result.run.number))
            .arg(when);
    const QString head = RunsDialog::tr("Compared with the reference %1 (test %2, %3):")
                             .arg(result.reference.model)
                             .arg(qint64(result.run.number))
                             .arg(when);
    QStringList lines;
    if (!result.comparison.comparable())
        lines << QStringLiteral("⚠ ") + text::localized(report::compareTexts().notComparable);
    else
        for (const report::Text& line : report::referenceLines(result.comparison))
            lines << text::localized(line);
    if (lines.isEmpty())
        lines << RunsDialog::tr("no metric differs by 10 % or more");
    return text::joinSentences({head, text::joinClauses(lines)});
}
} // namespace ui

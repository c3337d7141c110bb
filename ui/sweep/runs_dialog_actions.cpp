// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_compare_text.h"
#include "report/sweep_html.h"
#include "session/sweep/sweep_report.h"
#include "text/language.h"
#include "ui/sweep/compare_dialog.h"
#include "ui/sweep/runs_dialog.h"
#include "ui/widgets/question_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QInputDialog>

#include <algorithm>

namespace ui {
namespace {
const QString folderKey = QStringLiteral("sweep/report_folder");
} // namespace

void RunsDialog::openReport()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 1)
        return;
    const RunRow row = m_model->at(chosen.front());
    const QStringList files = m_model->run(chosen.front()).files;
    auto* dialog = new QFileDialog(this, tr("Save the report"));
    dialog->setObjectName(QStringLiteral("runsReportDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Page (*.html)")});
    dialog->setDefaultSuffix(QStringLiteral("html"));
    dialog->setDirectory(m_settings.pageValue(folderKey, QDir::homePath()).toString());
    dialog->selectFile(QStringLiteral("sweep-%1.html").arg(qint64(row.number)));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, row, files](const QString& path) { saveReport(row, path, files); });
    dialog->open();
}

/// The readings are not in the history, so the page has no curves of position; where their file is
/// still there it goes beside the page.
void RunsDialog::saveReport(const RunRow& row, const QString& path, const QStringList& files)
{
    const auto found = std::find_if(files.begin(), files.end(), [](const QString& file) {
        return file.endsWith(QLatin1StringView(".readings.csv")) && QFile::exists(file);
    });
    const QString readings = found != files.end() ? *found : QString();
    m_settings.setPageValue(folderKey, QFileInfo(path).absolutePath());
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

/// A is what is held against: the reference, else the older one.
void RunsDialog::compare()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 2)
        return;
    int a = chosen[1]; // the newest stands at the top
    int b = chosen[0];
    const auto isReference = [this](int row) {
        const record::TestServo& servo = m_model->servo(row);
        return servo.reference && record::canBeReference(m_model->run(row), servo);
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

void RunsDialog::editLabel()
{
    const std::vector<int> chosen = rows();
    if (chosen.size() != 1)
        return;
    const RunRow row = m_model->at(chosen.front());
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("runsLabelDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Label"));
    dialog->setLabelText(tr("Name of this servo, as it is written on it:"));
    dialog->setTextValue(m_model->servo(chosen.front()).label);
    connect(dialog, &QInputDialog::textValueSelected, this, [this, row](const QString& words) {
        m_historyService.setLabel(row.number, row.servo, words.trimmed());
    });
    dialog->open();
}

void RunsDialog::removeRuns()
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
    question.title = tr("Delete these tests: %1?").arg(numbers.size());
    question.text = tr("Their figures, legs and settings leave the history, those of all servos "
                       "that were tested together. Reports and readings in files stay.");
    question.risk = tr("This cannot be undone.");
    question.acceptText = tr("Delete");
    question.guard = this;
    ui::ask(this, question, [this, numbers] { m_historyService.remove(numbers); });
}

QString referenceText(const session::ReferenceResult& result)
{
    const QString when =
        QLocale().toString(result.run.at.toLocalTime().date(), QLocale::ShortFormat);
    if (result.ignored)
        return RunsDialog::tr("The reference %1 (test %2 of %3) is ignored: that test did not "
                              "finish. Mark one that did under Earlier tests.")
            .arg(result.reference.model)
            .arg(qint64(result.run.number))
            .arg(when);
    const QString head = RunsDialog::tr("Compared with the reference %1 (test %2 of %3):")
                             .arg(result.reference.model)
                             .arg(qint64(result.run.number))
                             .arg(when);
    QStringList lines;
    if (!result.comparison.comparable())
        lines << QStringLiteral("⚠ ") +
                     report::compareTexts().notComparable.in(text::isUiChinese());
    else
        for (const report::Text& line : report::referenceLines(result.comparison))
            lines << line.in(text::isUiChinese());
    if (lines.isEmpty())
        lines << RunsDialog::tr("no figure differs by a tenth or more");
    return head + QLatin1Char(' ') + lines.join(QStringLiteral("; "));
}
} // namespace ui

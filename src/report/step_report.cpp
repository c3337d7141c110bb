// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_report.h"

#include "report/bilingual.h"
#include "report/register_name.h"
#include "report/report_file.h"
#include "report/step_text.h"
#include "report/sweep_text.h"
#include "results/step_json.h"

namespace report {
using catalog::Text;
using results::StepRun;

namespace {
QString head(const HtmlWriter& htmlWriter, const StepRun& run)
{
    const SweepTexts& words = sweepTexts();
    const snapshot::SnapshotServo& servo = run.parameters.servo;
    std::vector<QStringList> rows{
        {htmlWriter.htmlText(words.model), escaped(servo.model)},
        {htmlWriter.htmlText(words.id), QString::number(servo.id)},
        {htmlWriter.htmlText(words.date), localTime(run.at)},
        {htmlWriter.htmlText(words.port), escaped(run.port)},
        {htmlWriter.htmlText(words.from), exactNumber(run.axis.from)},
        {htmlWriter.htmlText(words.to), exactNumber(run.axis.to)},
        {htmlWriter.htmlText(words.sampling), figure(run.sampleRate) + QStringLiteral(" Hz")},
        {htmlWriter.htmlText(words.program), escaped(run.program)}};
    if (!run.spec.operatorName.isEmpty())
        rows.push_back({htmlWriter.htmlText(words.operatorName), escaped(run.spec.operatorName)});
    if (!run.spec.note.isEmpty())
        rows.push_back({htmlWriter.htmlText(words.note), escaped(run.spec.note)});
    const QString simulated = run.simulated ? QStringLiteral("<p class=\"simulated\">%1</p>\n")
                                                  .arg(htmlWriter.htmlText(words.simulated))
                                            : QString();
    return simulated + keyValueTable(rows);
}

QString gains(const HtmlWriter& htmlWriter, const std::vector<StepRun>& runs)
{
    QStringList headings{htmlWriter.htmlText(translate("StepText", "Register"))};
    for (std::size_t i = 0; i < runs.size(); ++i)
        headings << QString::number(i + 1);
    std::vector<QStringList> rows;
    for (const results::StepGain& gain : runs.front().gains) {
        QStringList row{htmlWriter.htmlText(registerName(runs.front().parameters.servo, gain.key))};
        for (const StepRun& run : runs) {
            QString raw = QStringLiteral("–");
            for (const results::StepGain& one : run.gains) {
                if (one.key == gain.key)
                    raw = QString::number(one.raw);
            }
            row << raw;
        }
        rows.push_back(row);
    }
    return table(headings, rows);
}

QString unit(const HtmlWriter& htmlWriter, const results::StepFigure& figure)
{
    return htmlWriter.htmlText(unitText(QString::fromUtf8(figure.unit)));
}

QString single(const HtmlWriter& htmlWriter, const StepRun& run)
{
    const SweepTexts& words = sweepTexts();
    std::vector<QStringList> rows;
    for (const results::StepFigure& one : results::stepFigures) {
        rows.push_back({htmlWriter.htmlText(stepFigureText(QString::fromLatin1(one.key))),
                        htmlWriter.optional(run.mean.*one.member, words.notMeasured),
                        unit(htmlWriter, one)});
    }
    return table({htmlWriter.htmlText(words.figure), htmlWriter.htmlText(words.value),
                  htmlWriter.htmlText(words.unit)},
                 rows);
}

QString compared(const HtmlWriter& htmlWriter, const StepRun& before, const StepRun& after)
{
    const SweepTexts& words = sweepTexts();
    std::vector<QStringList> rows;
    for (const results::StepDifference& row : results::compareSteps(before, after)) {
        const StepPairText pair = stepPairText(row.before, row.after);
        rows.push_back({htmlWriter.htmlText(stepFigureText(QString::fromLatin1(row.figure.key))),
                        pair.before, pair.after, pair.difference, unit(htmlWriter, row.figure),
                        htmlWriter.htmlText(stepChangeText(row.change))});
    }
    return table(
        {htmlWriter.htmlText(words.figure), htmlWriter.htmlText(translate("StepText", "Before")),
         htmlWriter.htmlText(translate("StepText", "After")),
         htmlWriter.htmlText(translate("StepText", "Difference")), htmlWriter.htmlText(words.unit),
         htmlWriter.htmlText(translate("StepText", "Change"))},
        rows);
}

QString ends(const HtmlWriter& htmlWriter, const std::vector<StepRun>& runs)
{
    QString text;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].end != results::SweepEnd::Finished) {
            const QString form = QString::number(i + 1) + QStringLiteral(": %1");
            text += htmlWriter.paragraph(filled(inBoth(form), endText(runs[i].end)));
        }
    }
    return text;
}

QString adviceList(const HtmlWriter& htmlWriter, const StepRun& run,
                   const std::vector<results::StepAdvice>& advice)
{
    if (advice.empty())
        return {};
    QString text = htmlWriter.heading(2, translate("StepText", "What to try next"));
    for (std::size_t i = 0; i < advice.size(); ++i) {
        if (i == 0 || advice[i].symptom != advice[i - 1].symptom)
            text += htmlWriter.heading(3, stepSymptomText(advice[i].symptom));
        text += htmlWriter.paragraph(
            stepAdviceLine(advice[i], registerName(run.parameters.servo, advice[i].key)));
    }
    return text;
}

Text title()
{
    return translate("StepText", "Step response");
}

QString body(const HtmlWriter& htmlWriter, const std::vector<StepRun>& runs,
             const std::vector<results::StepAdvice>& advice, const EmbedChart& place)
{
    return htmlWriter.heading(1, title()) + head(htmlWriter, runs.front()) +
           ends(htmlWriter, runs) + place(stepChart(htmlWriter, runs)) +
           htmlWriter.heading(2, translate("StepText", "Gains")) + gains(htmlWriter, runs) +
           htmlWriter.heading(2, translate("StepText", "Metrics")) +
           htmlWriter.paragraph(translate("StepText",
                                          "Values are means of all responses in both directions; "
                                          "steady-state errors are absolute values.")) +
           (runs.size() > 1 ? compared(htmlWriter, runs.front(), runs.back())
                            : single(htmlWriter, runs.front())) +
           adviceList(htmlWriter, runs.front(), advice);
}
} // namespace

bool isStepReport(const QString& path)
{
    const QString ending = endingOf(path);
    return isReportPath(path) || ending == QLatin1String("json") || ending == QLatin1String("csv");
}

base::Result<void> saveStepReport(const std::vector<StepRun>& runs,
                                  const std::vector<results::StepAdvice>& advice, bool chinese,
                                  const QString& path)
{
    const QString ending = endingOf(path);
    if (ending == QLatin1String("json"))
        return results::saveStepRuns(runs, advice, path);
    if (ending == QLatin1String("csv"))
        return results::saveStepSamples(runs, path);
    return saveReport(
        {title(), runs.front().program, runs.front().at},
        [&](const HtmlWriter& htmlWriter, const EmbedChart& place) {
            return body(htmlWriter, runs, advice, place);
        },
        chinese, path);
}
} // namespace report

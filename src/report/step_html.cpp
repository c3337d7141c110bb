// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_html.h"

#include "files/text_file.h"
#include "report/bilingual.h"
#include "report/step_text.h"
#include "report/sweep_text.h"

namespace report {
using catalog::Text;
using record::StepRun;

namespace {
QString head(const HtmlWriter& htmlWriter, const StepRun& run)
{
    const SweepTexts& words = sweepTexts();
    const record::SnapshotServo& servo = run.parameters.servo;
    std::vector<QStringList> rows{
        {htmlWriter.htmlText(words.model), escaped(servo.model)},
        {htmlWriter.htmlText(words.id), QString::number(servo.id)},
        {htmlWriter.htmlText(words.date), escaped(run.at.toLocalTime().toString(Qt::ISODate))},
        {htmlWriter.htmlText(words.port), escaped(run.port)},
        {htmlWriter.htmlText(words.from), figure(run.axis.from)},
        {htmlWriter.htmlText(words.to), figure(run.axis.to)},
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
    QStringList headings{htmlWriter.htmlText(both("Register", "寄存器"))};
    for (std::size_t i = 0; i < runs.size(); ++i)
        headings << QString::number(i + 1);
    std::vector<QStringList> rows;
    for (const record::StepGain& gain : runs.front().gains) {
        QStringList row{escaped(gain.key)};
        for (const StepRun& run : runs) {
            QString raw = QStringLiteral("–");
            for (const record::StepGain& one : run.gains) {
                if (one.key == gain.key)
                    raw = QString::number(one.raw);
            }
            row << raw;
        }
        rows.push_back(row);
    }
    return table(headings, rows);
}

QString unit(const HtmlWriter& htmlWriter, const record::StepFigure& figure)
{
    return htmlWriter.htmlText(unitText(QString::fromUtf8(figure.unit)));
}

QString single(const HtmlWriter& htmlWriter, const StepRun& run)
{
    const SweepTexts& words = sweepTexts();
    std::vector<QStringList> rows;
    for (const record::StepFigure& one : record::stepFigures) {
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
    for (const record::StepDifference& row : record::compareSteps(before, after)) {
        rows.push_back({htmlWriter.htmlText(stepFigureText(QString::fromLatin1(row.figure.key))),
                        htmlWriter.optional(row.before, words.notMeasured),
                        htmlWriter.optional(row.after, words.notMeasured),
                        htmlWriter.optional(row.difference, words.none),
                        unit(htmlWriter, row.figure),
                        htmlWriter.htmlText(stepChangeText(row.change))});
    }
    return table({htmlWriter.htmlText(words.figure), htmlWriter.htmlText(both("Before", "之前")),
                  htmlWriter.htmlText(both("After", "之后")),
                  htmlWriter.htmlText(both("Difference", "差值")), htmlWriter.htmlText(words.unit),
                  htmlWriter.htmlText(both("Change", "变化"))},
                 rows);
}

QString ends(const HtmlWriter& htmlWriter, const std::vector<StepRun>& runs)
{
    QString text;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].end != record::SweepEnd::Finished) {
            const Text words = endText(runs[i].end);
            const QString number = QString::number(i + 1) + QStringLiteral(": ");
            text += htmlWriter.paragraph({number + words.en, number + words.zh});
        }
    }
    return text;
}
} // namespace

QByteArray stepHtml(const std::vector<StepRun>& runs, const std::vector<record::StepAdvice>& advice,
                    bool chinese)
{
    const HtmlWriter htmlWriter(ReportLanguage::Both);
    const Text title = both("Step response", "阶跃响应");
    QString body = htmlWriter.heading(1, title) + head(htmlWriter, runs.front()) +
                   ends(htmlWriter, runs) + stepChart(htmlWriter, runs) +
                   htmlWriter.heading(2, both("Gains", "增益参数")) + gains(htmlWriter, runs) +
                   htmlWriter.heading(2, both("Figures", "指标")) +
                   htmlWriter.paragraph(both("Means of all responses, there and back; errors that "
                                             "remain by their size.",
                                             "所有往返响应的平均值；静差取绝对值。"));
    body += runs.size() > 1 ? compared(htmlWriter, runs.front(), runs.back())
                            : single(htmlWriter, runs.front());
    if (!advice.empty()) {
        body += htmlWriter.heading(2, both("What to try next", "下一步建议"));
        for (std::size_t i = 0; i < advice.size(); ++i) {
            if (i == 0 || advice[i].symptom != advice[i - 1].symptom)
                body += htmlWriter.heading(3, stepSymptomText(advice[i].symptom));
            body += htmlWriter.paragraph(stepAdviceLine(advice[i]));
        }
    }
    return page(htmlWriter, title, body, chinese).toUtf8();
}

base::Result<void> saveStepHtml(const std::vector<StepRun>& runs,
                                const std::vector<record::StepAdvice>& advice, bool chinese,
                                const QString& path)
{
    return record::saveTextFile(QStringLiteral("save-report"), stepHtml(runs, advice, chinese),
                                path);
}
} // namespace report

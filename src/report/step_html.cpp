// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/step_html.h"

#include "record/text_file.h"
#include "report/step_words.h"
#include "report/sweep_words.h"

namespace report {
using catalog::Text;
using record::StepRun;

namespace {
Text both(const char* english, const char* chinese)
{
    return {QString::fromUtf8(english), QString::fromUtf8(chinese)};
}

QString head(const Scribe& scribe, const StepRun& run)
{
    const SweepWords& words = sweepWords();
    const record::SnapshotServo& servo = run.parameters.servo;
    std::vector<QStringList> rows{
        {scribe.say(words.model), escaped(servo.model)},
        {scribe.say(words.id), QString::number(servo.id)},
        {scribe.say(words.date), escaped(run.at.toLocalTime().toString(Qt::ISODate))},
        {scribe.say(words.port), escaped(run.port)},
        {scribe.say(words.from), figure(run.axis.from)},
        {scribe.say(words.to), figure(run.axis.to)},
        {scribe.say(words.sampling), figure(run.sampleRate) + QStringLiteral(" Hz")},
        {scribe.say(words.program), escaped(run.program)}};
    if (!run.spec.operatorName.isEmpty())
        rows.push_back({scribe.say(words.operatorName), escaped(run.spec.operatorName)});
    if (!run.spec.note.isEmpty())
        rows.push_back({scribe.say(words.note), escaped(run.spec.note)});
    const QString simulated =
        run.simulated
            ? QStringLiteral("<p class=\"simulated\">%1</p>\n").arg(scribe.say(words.simulated))
            : QString();
    return simulated + pairs(rows);
}

QString gains(const Scribe& scribe, const std::vector<StepRun>& runs)
{
    QStringList headings{scribe.say(both("Register", "寄存器"))};
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

QString unit(const Scribe& scribe, const record::StepFigure& figure)
{
    return scribe.say(unitWords(QString::fromUtf8(figure.unit)));
}

QString single(const Scribe& scribe, const StepRun& run)
{
    const SweepWords& words = sweepWords();
    std::vector<QStringList> rows;
    for (const record::StepFigure& one : record::stepFigures) {
        rows.push_back({scribe.say(stepFigureWords(QString::fromLatin1(one.key))),
                        scribe.optional(run.mean.*one.member, words.notMeasured),
                        unit(scribe, one)});
    }
    return table({scribe.say(words.figure), scribe.say(words.value), scribe.say(words.unit)}, rows);
}

QString compared(const Scribe& scribe, const StepRun& before, const StepRun& after)
{
    const SweepWords& words = sweepWords();
    std::vector<QStringList> rows;
    for (const record::StepDifference& row : record::compareSteps(before, after)) {
        rows.push_back({scribe.say(stepFigureWords(QString::fromLatin1(row.figure.key))),
                        scribe.optional(row.before, words.notMeasured),
                        scribe.optional(row.after, words.notMeasured),
                        scribe.optional(row.difference, words.none), unit(scribe, row.figure),
                        scribe.say(stepChangeWords(row.change))});
    }
    return table({scribe.say(words.figure), scribe.say(both("Before", "之前")),
                  scribe.say(both("After", "之后")), scribe.say(both("Difference", "差值")),
                  scribe.say(words.unit), scribe.say(both("Change", "变化"))},
                 rows);
}

QString ends(const Scribe& scribe, const std::vector<StepRun>& runs)
{
    QString text;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].end != record::SweepEnd::Finished) {
            const Text words = endWords(runs[i].end);
            const QString number = QString::number(i + 1) + QStringLiteral(": ");
            text += scribe.paragraph({number + words.en, number + words.zh});
        }
    }
    return text;
}
} // namespace

QByteArray stepHtml(const std::vector<StepRun>& runs, const std::vector<record::StepAdvice>& advice,
                    bool chinese)
{
    const Scribe scribe(Tongue::Both);
    const Text title = both("Step response", "阶跃响应");
    QString body = scribe.heading(1, title) + head(scribe, runs.front()) + ends(scribe, runs) +
                   stepChart(scribe, runs) + scribe.heading(2, both("Gains", "增益参数")) +
                   gains(scribe, runs) + scribe.heading(2, both("Figures", "指标")) +
                   scribe.paragraph(both("Means of all responses, there and back; errors that "
                                         "remain by their size.",
                                         "所有往返响应的平均值；静差取绝对值。"));
    body += runs.size() > 1 ? compared(scribe, runs.front(), runs.back())
                            : single(scribe, runs.front());
    if (!advice.empty()) {
        body += scribe.heading(2, both("What to try next", "下一步建议"));
        for (std::size_t i = 0; i < advice.size(); ++i) {
            if (i == 0 || advice[i].symptom != advice[i - 1].symptom)
                body += scribe.heading(3, stepSymptomWords(advice[i].symptom));
            body += scribe.paragraph(stepAdviceWords(advice[i]));
        }
    }
    return page(scribe, title, body, chinese).toUtf8();
}

base::Result<void> saveStepHtml(const std::vector<StepRun>& runs,
                                const std::vector<record::StepAdvice>& advice, bool chinese,
                                const QString& path)
{
    return record::saveTextFile(QStringLiteral("save-report"), stepHtml(runs, advice, chinese),
                                path);
}
} // namespace report

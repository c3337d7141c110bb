// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/step_output.h"

#include "cli/input/arguments.h"
#include "cli/output/table.h"
#include "cli/translate.h"
#include "report/step_report.h"
#include "report/step_text.h"
#include "report/sweep_text.h"
#include "text/language.h"

namespace cli {
namespace {
QString gainsText(const results::StepRun& run)
{
    QStringList gains;
    for (const results::StepGain& gain : run.gains)
        gains << QStringLiteral("%1=%2").arg(gain.key).arg(gain.raw);
    return gains.join(QLatin1Char(' '));
}

QString figuresText(const results::StepRun& run)
{
    Table table({translate("cli", "Metric"), translate("cli", "Value"), translate("cli", "Unit")});
    table.alignRight({1});
    for (const results::StepFigure& figure : results::stepFigures) {
        const auto& value = run.mean.*figure.member;
        if (value)
            table.add({text::localized(report::stepFigureText(QString::fromLatin1(figure.key))),
                       report::stepValue(value), report::stepUnit(figure, text::isUiChinese())});
    }
    return table.text();
}

QString comparisonText(const results::StepRun& before, const results::StepRun& after)
{
    Table table({translate("cli", "Metric"), translate("cli", "Before"), translate("cli", "After"),
                 translate("cli", "Difference"), translate("cli", "Unit"),
                 translate("cli", "Change")});
    table.alignRight({1, 2, 3});
    for (const results::StepDifference& row : results::compareSteps(before, after)) {
        const report::StepPairText pair = report::stepPairText(row.before, row.after);
        table.add({text::localized(report::stepFigureText(QString::fromLatin1(row.figure.key))),
                   pair.before, pair.after, pair.difference,
                   report::stepUnit(row.figure, text::isUiChinese()),
                   text::localized(report::stepChangeText(row.change))});
    }
    return table.text();
}
} // namespace

base::Result<void> checkStepReportName(const QString& path)
{
    if (report::isStepReport(path))
        return {};
    return badArgument(
        translate("cli", "the report file name must end with .html, .pdf, .json or .csv"));
}

QString stepRunsText(const std::vector<results::StepRun>& runs,
                     const std::vector<results::StepAdvice>& advice)
{
    const results::StepRun& first = runs.front();
    QString text =
        QStringLiteral("%1 · %2, %3 → %4\n")
            .arg(first.parameters.servo.model, QString::number(first.parameters.servo.id),
                 report::stepValue(first.axis.from), report::stepValue(first.axis.to));
    for (const results::StepRun& run : runs) {
        if (!run.gains.empty())
            text += gainsText(run) + QLatin1Char('\n');
        if (run.end != results::SweepEnd::Finished)
            text += text::localized(report::endText(run.end)) + QLatin1Char('\n');
    }
    text += runs.size() > 1 ? comparisonText(first, runs.back()) : figuresText(first);
    return text + report::stepAdviceText(advice, text::isUiChinese());
}
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the report about one servo.
#include "report/bilingual.h"
#include "report/register_name.h"
#include "report/sweep_parts.h"
#include "report/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
using Rows = std::vector<QStringList>;

/// "9.75 step"
Text withUnit(const QString& number, const QString& unit)
{
    return unit.isEmpty() ? inBoth(number)
                          : filled(inBoth(QStringLiteral("%1 %2")), inBoth(number), unitText(unit));
}

QString graded(results::Grade grade, const QString& words)
{
    return QStringLiteral("<span class=\"verdict %1\">").arg(gradeClass(grade)) + gradeSign(grade) +
           u' ' + words + QStringLiteral("</span>");
}

QString limitCell(const results::SweepLimit& limit, const std::optional<double>& bound)
{
    if (!bound)
        return QStringLiteral("–");
    return (limit.atLeast ? QStringLiteral("&lt; ") : QStringLiteral("&gt; ")) +
           exactNumber(*bound);
}

/// "above 8 step"
Text reasonOf(const results::VerdictLine& line)
{
    const SweepTexts& words = sweepTexts();
    const auto bound = line.grade == results::Grade::Fail ? line.limit.fail : line.limit.warn;
    const Text& form = line.limit.atLeast ? words.under : words.over;
    return filled(form, bound ? withUnit(exactNumber(*bound), line.limit.unit) : Text());
}

const results::VerdictLine* lineOf(const results::SweepServo& servo, const QString& metric)
{
    const auto found =
        std::find_if(servo.lines.begin(), servo.lines.end(),
                     [&](const results::VerdictLine& line) { return line.limit.metric == metric; });
    return found == servo.lines.end() ? nullptr : &*found;
}

QString judgedFigure(const results::VerdictLine& line)
{
    if (!std::isfinite(*line.value))
        return QStringLiteral("–");
    return figure(*line.value, {line.limit.warn, line.limit.fail});
}

QStringList metricRow(const HtmlWriter& htmlWriter, const results::SweepMetric& metric,
                      const results::VerdictLine* line)
{
    const Text none = inBoth(QStringLiteral("–"));
    QStringList row{htmlWriter.htmlText(metricLabel(metric.key)),
                    line != nullptr && line->value ? judgedFigure(*line)
                                                   : htmlWriter.optional(metric.value, none),
                    htmlWriter.htmlText(unitText(metric.unit)),
                    htmlWriter.optional(metric.mean, none),
                    htmlWriter.optional(metric.min, none),
                    htmlWriter.optional(metric.max, none),
                    QString::number(metric.count)};
    if (line == nullptr)
        return row << QString() << QString() << QString();
    return row << limitCell(line->limit, line->limit.warn)
               << limitCell(line->limit, line->limit.fail) << lineBadge(htmlWriter, line->grade);
}

/// What was neither measured nor judged is left out.
QString metricsTable(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    Rows rows;
    for (const results::SweepMetric& metric : servo.metrics) {
        const results::VerdictLine* line = lineOf(servo, metric.key);
        if (metric.value || line != nullptr)
            rows.push_back(metricRow(htmlWriter, metric, line));
    }
    return table({htmlWriter.htmlText(words.figure), htmlWriter.htmlText(words.value),
                  htmlWriter.htmlText(words.unit), htmlWriter.htmlText(words.mean),
                  htmlWriter.htmlText(words.lowest), htmlWriter.htmlText(words.highest),
                  htmlWriter.htmlText(words.count), htmlWriter.htmlText(words.warnLimit),
                  htmlWriter.htmlText(words.failLimit), htmlWriter.htmlText(words.result)},
                 rows);
}

/// Who it is, and what the test meant in its steps.
QString setupLine(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const QString step = QStringLiteral("step");
    const results::SweepAxis& axis = servo.axis;
    const snapshot::SnapshotServo& identity = servo.parameters.servo;
    QStringList facts;
    const auto add = [&](const Text& name, const QString& value) {
        facts << htmlWriter.htmlText(name) + QStringLiteral(": ") + value;
    };
    const auto inUnit = [&](const QString& number, const QString& unit) {
        return htmlWriter.htmlText(withUnit(number, unit));
    };
    add(words.firmware, escaped(identity.firmware));
    add(words.protocol, htmlWriter.htmlText(protocolText(identity.protocol)));
    add(words.inSteps,
        inUnit(exactNumber(axis.from) + QStringLiteral(" … ") + exactNumber(axis.to), step));
    add(words.tolerance, inUnit(exactNumber(axis.tolerance), step));
    if (axis.speed)
        add(words.speed, inUnit(exactNumber(*axis.speed), QStringLiteral("step/s")));
    if (axis.acceleration)
        add(words.acceleration, exactNumber(*axis.acceleration) + QStringLiteral(" step/s²"));
    add(words.limits,
        htmlWriter.htmlText(servo.limits.name.isEmpty() ? words.none
                                                        : limitsName(servo.limits.name)));
    return QStringLiteral("<p>") + facts.join(QStringLiteral(" · ")) + QStringLiteral("</p>\n");
}

/// The chart, or the sentence that stands in its place.
QString placed(const QString& markup, const EmbedChart& place)
{
    return markup.startsWith(QStringLiteral("<svg")) ? place(markup) : markup;
}

QString parametersPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const snapshot::Snapshot& kept = servo.parameters;
    Rows rows;
    for (const snapshot::SnapshotRegister& reg : kept.registers)
        rows.push_back(
            {QString::number(reg.address), htmlWriter.htmlText(registerName(kept.servo, reg.key)),
             reg.raw ? QString::number(qint64(*reg.raw)) : htmlWriter.htmlText(words.notMeasured),
             reg.value && std::isfinite(*reg.value) ? exactNumber(*reg.value) : QStringLiteral("–"),
             htmlWriter.htmlText(registerUnit(reg.unit)), htmlWriter.htmlText(areaText(reg.area))});
    return QStringLiteral("<details><summary>") + htmlWriter.htmlText(words.parameters) +
           QStringLiteral("</summary>\n<p>") + htmlWriter.htmlText(words.readAt) +
           QStringLiteral(": ") + localTime(kept.at) + QStringLiteral(", ") +
           escaped(kept.servo.map) + QStringLiteral("</p>\n") +
           table({htmlWriter.htmlText(words.address), htmlWriter.htmlText(words.name),
                  htmlWriter.htmlText(words.raw), htmlWriter.htmlText(words.value),
                  htmlWriter.htmlText(words.unit), htmlWriter.htmlText(words.area)},
                 rows) +
           QStringLiteral("</details>\n");
}

} // namespace

QString errorsChart(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    std::vector<double> errors;
    for (const results::SweepLeg& leg : servo.legs) {
        if (leg.steadyError && std::isfinite(*leg.steadyError))
            errors.push_back(*leg.steadyError);
    }
    if (errors.empty())
        return htmlWriter.paragraph(sweepTexts().noErrors);
    results::SweepLimit limit;
    for (const results::SweepLimit& line : servo.limits.lines) {
        if (line.metric == QStringLiteral("steady_error"))
            limit = line;
    }
    return errorHistogram(htmlWriter, errors, limit.warn, limit.fail);
}

QString lineBadge(const HtmlWriter& htmlWriter, results::Grade grade)
{
    return graded(grade, htmlWriter.htmlText(lineGradeLabel(grade)));
}

QString badge(const HtmlWriter& htmlWriter, results::Grade grade)
{
    return graded(grade, htmlWriter.htmlText(gradeLabel(grade)));
}

QString inSeconds(base::Duration span)
{
    return exactNumber(double(span.count()) / 1e6);
}

QString reasonsOf(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo)
{
    QStringList reasons;
    const auto reason = results::sweepVerdict(run, servo).reason;
    if (reason != results::NoVerdictReason::None)
        reasons << htmlWriter.htmlText(noVerdictReasonText(reason));
    for (const auto grade : {results::Grade::Fail, results::Grade::Warn}) {
        for (const results::VerdictLine& line : servo.lines) {
            if (line.grade == grade && line.value)
                reasons << htmlWriter.htmlText(metricLabel(line.limit.metric)) + u' ' +
                               htmlWriter.htmlText(withUnit(judgedFigure(line), line.limit.unit)) +
                               QStringLiteral(" – ") + htmlWriter.htmlText(reasonOf(line));
        }
    }
    return reasons.join(QStringLiteral("<br/>"));
}

QString servoFigures(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                     const results::SweepServo& servo)
{
    const snapshot::SnapshotServo& identity = servo.parameters.servo;
    QString text = QStringLiteral("<h2>ID %1 · ").arg(identity.id) + escaped(identity.model) +
                   QStringLiteral(" · ") + badge(htmlWriter, servo.verdict) +
                   QStringLiteral("</h2>\n");
    const QString reasons = reasonsOf(htmlWriter, run, servo);
    if (!reasons.isEmpty())
        text += QStringLiteral("<p>") + reasons + QStringLiteral("</p>\n");
    return text + setupLine(htmlWriter, servo) + htmlWriter.heading(3, sweepTexts().figures) +
           metricsTable(htmlWriter, servo);
}

QString positionPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                     const std::vector<SweepSeries>& series, const EmbedChart& place)
{
    const auto own = std::find_if(series.begin(), series.end(), [&](const SweepSeries& one) {
        return one.servo == servo.parameters.servo.id;
    });
    return htmlWriter.heading(3, sweepTexts().positionChart) +
           (own == series.end() ? htmlWriter.paragraph(sweepTexts().noSeries)
                                : placed(positionChart(htmlWriter, own->samples), place));
}

QString errorsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                   const EmbedChart& place)
{
    return htmlWriter.heading(3, sweepTexts().histogram) +
           placed(errorsChart(htmlWriter, servo), place);
}

QString servoPart(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const EmbedChart& place)
{
    return servoFigures(htmlWriter, run, servo) + positionPart(htmlWriter, servo, series, place) +
           errorsPart(htmlWriter, servo, place) + legsPart(htmlWriter, servo) +
           parametersPart(htmlWriter, servo);
}
} // namespace report

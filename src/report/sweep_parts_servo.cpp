// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the report about one servo.
#include "report/bilingual.h"
#include "report/sweep_parts.h"
#include "report/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
using Rows = std::vector<QStringList>;
constexpr std::size_t shownAtEnds = 50;
constexpr std::size_t shownWorst = 20;

/// "9.75 step"
Text withUnit(const QString& number, const QString& unit)
{
    return unit.isEmpty() ? inBoth(number)
                          : filled(inBoth(QStringLiteral("%1 %2")), inBoth(number), unitText(unit));
}

Text withUnit(double number, const QString& unit)
{
    return withUnit(figure(number), unit);
}

QString colored(results::Grade grade, const QString& words)
{
    return QStringLiteral("<span class=\"verdict\" style=\"color: %1\">").arg(gradeColor(grade)) +
           gradeSign(grade) + u' ' + words + QStringLiteral("</span>");
}

QString limitCell(const HtmlWriter& htmlWriter, const results::SweepLimit& limit,
                  const std::optional<double>& bound)
{
    if (!bound)
        return QStringLiteral("–");
    const QString sign = limit.atLeast ? QStringLiteral("&lt; ") : QStringLiteral("&gt; ");
    return sign + htmlWriter.htmlText(withUnit(*bound, limit.unit));
}

Text reasonOf(const results::VerdictLine& line)
{
    const SweepTexts& words = sweepTexts();
    if (line.grade == results::Grade::NotMeasured)
        return words.noFeedback;
    if (line.grade == results::Grade::Pass)
        return words.within;
    const auto bound = line.grade == results::Grade::Fail ? line.limit.fail : line.limit.warn;
    const Text& form = line.limit.atLeast ? words.under : words.over;
    const Text number = bound ? withUnit(*bound, line.limit.unit) : Text();
    return filled(form, number);
}

QString verdictLines(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                     results::NoVerdictReason reason)
{
    const SweepTexts& words = sweepTexts();
    Rows rows;
    for (const results::VerdictLine& line : servo.lines) {
        const QString value = line.value && std::isfinite(*line.value)
                                  ? htmlWriter.htmlText(withUnit(*line.value, line.limit.unit))
                                  : htmlWriter.htmlText(words.notMeasured);
        rows.push_back({lineBadge(htmlWriter, line.grade),
                        htmlWriter.htmlText(metricLabel(line.limit.metric)), value,
                        limitCell(htmlWriter, line.limit, line.limit.warn),
                        limitCell(htmlWriter, line.limit, line.limit.fail),
                        htmlWriter.htmlText(reasonOf(line))});
    }
    QString text = htmlWriter.heading(3, words.verdict);
    if (reason != results::NoVerdictReason::None)
        text += htmlWriter.paragraph(noVerdictReasonText(reason));
    text += QStringLiteral("<p>") + htmlWriter.htmlText(words.limits) + QStringLiteral(": ") +
            (servo.limits.name.isEmpty() ? htmlWriter.htmlText(words.none)
                                         : escaped(servo.limits.name)) +
            QStringLiteral("</p>\n");
    return text + table({htmlWriter.htmlText(words.result), htmlWriter.htmlText(words.figure),
                         htmlWriter.htmlText(words.value), htmlWriter.htmlText(words.warnLimit),
                         htmlWriter.htmlText(words.failLimit), htmlWriter.htmlText(words.reason)},
                        rows);
}

QString metricsTable(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const Text none = inBoth(QStringLiteral("–"));
    Rows rows;
    for (const results::SweepMetric& metric : servo.metrics)
        rows.push_back({htmlWriter.htmlText(metricLabel(metric.key)),
                        htmlWriter.optional(metric.value, words.notMeasured),
                        htmlWriter.htmlText(unitText(metric.unit)),
                        htmlWriter.optional(metric.mean, none),
                        htmlWriter.optional(metric.min, none),
                        htmlWriter.optional(metric.max, none), QString::number(metric.count)});
    return table({htmlWriter.htmlText(words.figure), htmlWriter.htmlText(words.value),
                  htmlWriter.htmlText(words.unit), htmlWriter.htmlText(words.mean),
                  htmlWriter.htmlText(words.lowest), htmlWriter.htmlText(words.highest),
                  htmlWriter.htmlText(words.count)},
                 rows) +
           htmlWriter.paragraph(words.gradingNote) + htmlWriter.paragraph(words.hysteresisNote);
}

QString charts(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
               const std::vector<SweepSeries>& series, const EmbedChart& place)
{
    const SweepTexts& words = sweepTexts();
    const auto drawn = [&](const QString& markup) {
        return markup.startsWith(QStringLiteral("<svg")) ? place(markup) : markup;
    };
    QString text = htmlWriter.heading(3, words.positionChart);
    const auto own = std::find_if(series.begin(), series.end(), [&](const SweepSeries& one) {
        return one.servo == servo.parameters.servo.id;
    });
    text += own == series.end() ? htmlWriter.paragraph(words.noSeries)
                                : drawn(positionChart(htmlWriter, own->samples));
    text += htmlWriter.heading(3, words.histogram);
    return text + drawn(errorsChart(htmlWriter, servo));
}

QString remarksOf(const HtmlWriter& htmlWriter, const results::SweepLeg& leg)
{
    const SweepTexts& words = sweepTexts();
    QStringList remarks;
    if (leg.missed)
        remarks.append(QStringLiteral("✘ ") + htmlWriter.htmlText(words.missed));
    if (leg.flagWrong.value_or(false))
        remarks.append(QStringLiteral("⚠ ") + htmlWriter.htmlText(words.flagWrong));
    if (leg.alarms != 0)
        remarks.append(QStringLiteral("⚠ ") + htmlWriter.htmlText(alarmBitsText(leg.alarms)));
    return remarks.join(QStringLiteral(", "));
}

QStringList legRow(const HtmlWriter& htmlWriter, const results::SweepLeg& leg)
{
    const Text none = inBoth(QStringLiteral("–"));
    const auto ms = [](std::optional<base::Duration> span) {
        return span ? std::optional<double>(double(span->count()) / 1000) : std::nullopt;
    };
    const auto cell = [&](std::optional<double> value) { return htmlWriter.optional(value, none); };
    return {QString::number(leg.number), QString::number(leg.cycle), inSeconds(leg.at),
            figure(leg.start),           figure(leg.target),         cell(leg.reached),
            cell(ms(leg.timeToTarget)),  cell(ms(leg.settling)),     cell(leg.overshoot),
            cell(leg.steadyError),       cell(leg.meanSpeed),        cell(leg.followingError),
            cell(leg.currentPeak),       cell(leg.loadPeak),         cell(leg.voltageMin),
            cell(leg.temperatureMax),    QString::number(leg.lost),  remarksOf(htmlWriter, leg)};
}

QString legsTable(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const auto shown = legsToShow(servo.legs);
    Rows rows;
    for (const results::SweepLeg* leg : shown)
        rows.push_back(legRow(htmlWriter, *leg));
    QString text = htmlWriter.heading(3, words.legs);
    if (shown.size() < servo.legs.size()) {
        const Text all = inBoth(QString::number(servo.legs.size()));
        text += htmlWriter.paragraph(filled(words.legsShown, all));
    }
    QStringList headings;
    for (const Text& heading :
         {words.leg, words.cycle, words.at, words.start, words.target, words.reached,
          words.timeToTarget, words.settling, words.overshoot, words.steadyError, words.meanSpeed,
          words.following, words.current, words.load, words.voltage, words.temperature, words.lost,
          words.remarks})
        headings.append(htmlWriter.htmlText(heading));
    return text + table(headings, rows, true);
}

QString axisRows(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const QString step = QStringLiteral("step");
    const results::SweepAxis& axis = servo.axis;
    const QString range = figure(axis.from) + QStringLiteral(" … ") + figure(axis.to);
    Rows rows{{htmlWriter.htmlText(words.inSteps), htmlWriter.htmlText(withUnit(range, step))},
              {htmlWriter.htmlText(words.tolerance),
               htmlWriter.htmlText(withUnit(axis.tolerance, step))}};
    if (axis.speed)
        rows.push_back({htmlWriter.htmlText(words.speed),
                        htmlWriter.htmlText(withUnit(*axis.speed, QStringLiteral("step/s")))});
    if (axis.acceleration)
        rows.push_back({htmlWriter.htmlText(words.acceleration),
                        figure(*axis.acceleration) + QStringLiteral(" step/s²")});
    return keyValueTable(rows);
}

QString parametersPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const snapshot::Snapshot& kept = servo.parameters;
    Rows rows;
    for (const snapshot::SnapshotRegister& reg : kept.registers)
        rows.push_back(
            {QString::number(reg.address), escaped(reg.key),
             reg.raw ? QString::number(qint64(*reg.raw)) : htmlWriter.htmlText(words.notMeasured),
             htmlWriter.optional(reg.value, inBoth(QStringLiteral("–"))), escaped(reg.unit),
             escaped(catalog::areaName(reg.area))});
    return QStringLiteral("<details><summary>") + htmlWriter.htmlText(words.parameters) +
           QStringLiteral("</summary>\n<p>") + htmlWriter.htmlText(words.readAt) +
           QStringLiteral(": ") + kept.at.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
           QStringLiteral(" UTC, ") + escaped(kept.servo.map) + QStringLiteral("</p>\n") +
           table({htmlWriter.htmlText(words.address), htmlWriter.htmlText(words.name),
                  htmlWriter.htmlText(words.raw), htmlWriter.htmlText(words.value),
                  htmlWriter.htmlText(words.unit), htmlWriter.htmlText(words.area)},
                 rows) +
           QStringLiteral("</details>\n");
}

/// Missed legs are worse than alarms, alarms worse than errors.
double severity(const results::SweepLeg& leg)
{
    constexpr double beyondAnyError = 1e9;
    const double error = std::abs(leg.steadyError.value_or(0));
    return (leg.missed ? 2 * beyondAnyError : 0) + (leg.alarms != 0 ? beyondAnyError : 0) +
           (std::isfinite(error) ? error : 0);
}
} // namespace

std::vector<const results::SweepLeg*> legsToShow(const std::vector<results::SweepLeg>& legs,
                                                 std::size_t all)
{
    std::vector<const results::SweepLeg*> shown;
    if (legs.size() <= std::max(all, 2 * shownAtEnds + shownWorst)) {
        for (const results::SweepLeg& leg : legs)
            shown.push_back(&leg);
        return shown;
    }
    std::vector<const results::SweepLeg*> middle;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const bool atEnds = i < shownAtEnds || i + shownAtEnds >= legs.size();
        (atEnds ? shown : middle).push_back(&legs[i]);
    }
    std::partial_sort(middle.begin(), middle.begin() + std::ptrdiff_t(shownWorst), middle.end(),
                      [](const auto* a, const auto* b) { return severity(*a) > severity(*b); });
    shown.insert(shown.end(), middle.begin(), middle.begin() + std::ptrdiff_t(shownWorst));
    // The pointers are into one list, so their order is that of time.
    std::sort(shown.begin(), shown.end());
    return shown;
}

QString badge(const HtmlWriter& htmlWriter, results::Grade grade)
{
    return colored(grade, htmlWriter.htmlText(gradeLabel(grade)));
}

QString lineBadge(const HtmlWriter& htmlWriter, results::Grade grade)
{
    return colored(grade, htmlWriter.htmlText(lineGradeLabel(grade)));
}

QString inSeconds(base::Duration span)
{
    return figure(double(span.count()) / 1e6);
}

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

QString servoPart(const HtmlWriter& htmlWriter, const results::SweepRun& run,
                  const results::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const EmbedChart& place)
{
    const results::NoVerdictReason reason = results::sweepVerdict(run, servo).reason;
    const snapshot::SnapshotServo& identity = servo.parameters.servo;
    const QString name = QStringLiteral("ID %1 · ").arg(identity.id) + identity.model;
    return htmlWriter.heading(2, inBoth(name)) + axisRows(htmlWriter, servo) +
           verdictLines(htmlWriter, servo, reason) + metricsTable(htmlWriter, servo) +
           charts(htmlWriter, servo, series, place) + legsTable(htmlWriter, servo) +
           parametersPart(htmlWriter, servo);
}
} // namespace report

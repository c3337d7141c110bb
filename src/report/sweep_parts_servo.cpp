// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of one servo.
#include "report/sweep_parts.h"
#include "report/sweep_words.h"

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
    if (unit.isEmpty())
        return {number, number};
    const Text words = unitWords(unit);
    return {number + u' ' + words.en, number + u' ' + words.zh};
}

Text withUnit(double number, const QString& unit)
{
    return withUnit(figure(number), unit);
}

QString coloured(record::Grade grade, const QString& words)
{
    return QStringLiteral("<span class=\"verdict\" style=\"color: %1\">").arg(gradeColour(grade)) +
           gradeSign(grade) + u' ' + words + QStringLiteral("</span>");
}

QString limitCell(const Scribe& scribe, const record::SweepLimit& limit,
                  const std::optional<double>& bound)
{
    if (!bound)
        return QStringLiteral("–");
    const QString sign = limit.atLeast ? QStringLiteral("&lt; ") : QStringLiteral("&gt; ");
    return sign + scribe.say(withUnit(*bound, limit.unit));
}

Text reasonOf(const record::VerdictLine& line)
{
    const SweepWords& words = sweepWords();
    if (line.grade == record::Grade::NotMeasured)
        return words.noFeedback;
    if (line.grade == record::Grade::Pass)
        return words.within;
    const auto bound = line.grade == record::Grade::Fail ? line.limit.fail : line.limit.warn;
    const Text& form = line.limit.atLeast ? words.under : words.over;
    const Text number = bound ? withUnit(*bound, line.limit.unit) : Text();
    return {form.en.arg(number.en), form.zh.arg(number.zh)};
}

QString verdictLines(const Scribe& scribe, const record::SweepServo& servo,
                     record::NoVerdict reason)
{
    const SweepWords& words = sweepWords();
    Rows rows;
    for (const record::VerdictLine& line : servo.lines) {
        const QString value = line.value && std::isfinite(*line.value)
                                  ? scribe.say(withUnit(*line.value, line.limit.unit))
                                  : scribe.say(words.notMeasured);
        rows.push_back({lineBadge(scribe, line.grade), scribe.say(metricWords(line.limit.metric)),
                        value, limitCell(scribe, line.limit, line.limit.warn),
                        limitCell(scribe, line.limit, line.limit.fail),
                        scribe.say(reasonOf(line))});
    }
    QString text = scribe.heading(3, words.verdict);
    if (reason != record::NoVerdict::None)
        text += scribe.paragraph(noVerdictWords(reason));
    text += QStringLiteral("<p>") + scribe.say(words.limits) + QStringLiteral(": ") +
            (servo.limits.name.isEmpty() ? scribe.say(words.none) : escaped(servo.limits.name)) +
            QStringLiteral("</p>\n");
    return text + table({scribe.say(words.result), scribe.say(words.figure),
                         scribe.say(words.value), scribe.say(words.warnLimit),
                         scribe.say(words.failLimit), scribe.say(words.reason)},
                        rows);
}

QString metricsTable(const Scribe& scribe, const record::SweepServo& servo)
{
    const SweepWords& words = sweepWords();
    const Text none{QStringLiteral("–"), QStringLiteral("–")};
    Rows rows;
    for (const record::SweepMetric& metric : servo.metrics)
        rows.push_back({scribe.say(metricWords(metric.key)),
                        scribe.optional(metric.value, words.notMeasured),
                        scribe.say(unitWords(metric.unit)), scribe.optional(metric.mean, none),
                        scribe.optional(metric.min, none), scribe.optional(metric.max, none),
                        QString::number(metric.count)});
    return table({scribe.say(words.figure), scribe.say(words.value), scribe.say(words.unit),
                  scribe.say(words.mean), scribe.say(words.lowest), scribe.say(words.highest),
                  scribe.say(words.count)},
                 rows) +
           scribe.paragraph(words.howJudged) + scribe.paragraph(words.hysteresisNote);
}

QString charts(const Scribe& scribe, const record::SweepServo& servo,
               const std::vector<SweepSeries>& series, const PlaceChart& place)
{
    const SweepWords& words = sweepWords();
    const auto drawn = [&](const QString& markup) {
        return markup.startsWith(QStringLiteral("<svg")) ? place(markup) : markup;
    };
    QString text = scribe.heading(3, words.positionChart);
    const auto own = std::find_if(series.begin(), series.end(), [&](const SweepSeries& one) {
        return one.servo == servo.parameters.servo.id;
    });
    text += own == series.end() ? scribe.paragraph(words.noSeries)
                                : drawn(positionChart(scribe, own->samples));
    text += scribe.heading(3, words.histogram);
    std::vector<double> errors;
    for (const record::SweepLeg& leg : servo.legs) {
        if (leg.steadyError && std::isfinite(*leg.steadyError))
            errors.push_back(*leg.steadyError);
    }
    if (errors.empty())
        return text + scribe.paragraph(words.noErrors);
    record::SweepLimit limit;
    for (const record::SweepLimit& line : servo.limits.lines) {
        if (line.metric == QStringLiteral("steady_error"))
            limit = line;
    }
    return text + drawn(errorHistogram(scribe, errors, limit.warn, limit.fail));
}

QString remarksOf(const Scribe& scribe, const record::SweepLeg& leg)
{
    const SweepWords& words = sweepWords();
    QStringList remarks;
    if (leg.missed)
        remarks.append(QStringLiteral("✘ ") + scribe.say(words.missed));
    if (leg.flagWrong.value_or(false))
        remarks.append(QStringLiteral("⚠ ") + scribe.say(words.flagWrong));
    if (leg.alarms != 0)
        remarks.append(QStringLiteral("⚠ ") + scribe.say(alarmBitsWords(leg.alarms)));
    return remarks.join(QStringLiteral(", "));
}

QStringList legRow(const Scribe& scribe, const record::SweepLeg& leg)
{
    const Text none{QStringLiteral("–"), QStringLiteral("–")};
    const auto ms = [](std::optional<base::Duration> span) {
        return span ? std::optional<double>(double(span->count()) / 1000) : std::nullopt;
    };
    const auto cell = [&](std::optional<double> value) { return scribe.optional(value, none); };
    return {QString::number(leg.number), QString::number(leg.cycle), inSeconds(leg.at),
            figure(leg.start),           figure(leg.target),         cell(leg.reached),
            cell(ms(leg.timeToTarget)),  cell(ms(leg.settling)),     cell(leg.overshoot),
            cell(leg.steadyError),       cell(leg.meanSpeed),        cell(leg.followingError),
            cell(leg.currentPeak),       cell(leg.loadPeak),         cell(leg.voltageMin),
            cell(leg.temperatureMax),    QString::number(leg.lost),  remarksOf(scribe, leg)};
}

QString legsTable(const Scribe& scribe, const record::SweepServo& servo)
{
    const SweepWords& words = sweepWords();
    const auto shown = legsToShow(servo.legs);
    Rows rows;
    for (const record::SweepLeg* leg : shown)
        rows.push_back(legRow(scribe, *leg));
    QString text = scribe.heading(3, words.legs);
    if (shown.size() < servo.legs.size()) {
        const QString all = QString::number(servo.legs.size());
        text += scribe.paragraph({words.legsShown.en.arg(all), words.legsShown.zh.arg(all)});
    }
    QStringList headings;
    for (const Text& heading :
         {words.leg, words.cycle, words.at, words.start, words.target, words.reached,
          words.timeToTarget, words.settling, words.overshoot, words.steadyError, words.meanSpeed,
          words.following, words.current, words.load, words.voltage, words.temperature, words.lost,
          words.remarks})
        headings.append(scribe.say(heading));
    return text + table(headings, rows, true);
}

QString axisRows(const Scribe& scribe, const record::SweepServo& servo)
{
    const SweepWords& words = sweepWords();
    const QString step = QStringLiteral("step");
    const record::SweepAxis& axis = servo.axis;
    const QString range = figure(axis.from) + QStringLiteral(" … ") + figure(axis.to);
    Rows rows{{scribe.say(words.inSteps), scribe.say(withUnit(range, step))},
              {scribe.say(words.tolerance), scribe.say(withUnit(axis.tolerance, step))}};
    if (axis.speed)
        rows.push_back(
            {scribe.say(words.speed), scribe.say(withUnit(*axis.speed, QStringLiteral("step/s")))});
    if (axis.acceleration)
        rows.push_back({scribe.say(words.acceleration),
                        figure(*axis.acceleration) + QStringLiteral(" step/s²")});
    return pairs(rows);
}

QString parametersPart(const Scribe& scribe, const record::SweepServo& servo)
{
    const SweepWords& words = sweepWords();
    const record::Snapshot& kept = servo.parameters;
    Rows rows;
    for (const record::SnapshotRegister& reg : kept.registers)
        rows.push_back({QString::number(reg.address), escaped(reg.key),
                        reg.raw ? QString::number(qint64(*reg.raw)) : scribe.say(words.notMeasured),
                        scribe.optional(reg.value, {QStringLiteral("–"), QStringLiteral("–")}),
                        escaped(reg.unit), escaped(catalog::areaName(reg.area))});
    return QStringLiteral("<details><summary>") + scribe.say(words.parameters) +
           QStringLiteral("</summary>\n<p>") + scribe.say(words.readAt) + QStringLiteral(": ") +
           kept.at.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
           QStringLiteral(" UTC, ") + escaped(kept.servo.map) + QStringLiteral("</p>\n") +
           table({scribe.say(words.address), scribe.say(words.name), scribe.say(words.raw),
                  scribe.say(words.value), scribe.say(words.unit), scribe.say(words.area)},
                 rows) +
           QStringLiteral("</details>\n");
}

/// Missed before alarms before errors.
double badness(const record::SweepLeg& leg)
{
    constexpr double beyondAnyError = 1e9;
    const double error = std::abs(leg.steadyError.value_or(0));
    return (leg.missed ? 2 * beyondAnyError : 0) + (leg.alarms != 0 ? beyondAnyError : 0) +
           (std::isfinite(error) ? error : 0);
}
} // namespace

std::vector<const record::SweepLeg*> legsToShow(const std::vector<record::SweepLeg>& legs,
                                                std::size_t all)
{
    std::vector<const record::SweepLeg*> shown;
    if (legs.size() <= std::max(all, 2 * shownAtEnds + shownWorst)) {
        for (const record::SweepLeg& leg : legs)
            shown.push_back(&leg);
        return shown;
    }
    std::vector<const record::SweepLeg*> middle;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const bool atEnds = i < shownAtEnds || i + shownAtEnds >= legs.size();
        (atEnds ? shown : middle).push_back(&legs[i]);
    }
    std::partial_sort(middle.begin(), middle.begin() + std::ptrdiff_t(shownWorst), middle.end(),
                      [](const auto* a, const auto* b) { return badness(*a) > badness(*b); });
    shown.insert(shown.end(), middle.begin(), middle.begin() + std::ptrdiff_t(shownWorst));
    // All of one list: by place is by time.
    std::sort(shown.begin(), shown.end());
    return shown;
}

QString badge(const Scribe& scribe, record::Grade grade)
{
    return coloured(grade, scribe.say(gradeWords(grade)));
}

QString lineBadge(const Scribe& scribe, record::Grade grade)
{
    return coloured(grade, scribe.say(lineGradeWords(grade)));
}

QString inSeconds(base::Duration span)
{
    return figure(double(span.count()) / 1e6);
}

QString servoPart(const Scribe& scribe, const record::SweepRun& run,
                  const record::SweepServo& servo, const std::vector<SweepSeries>& series,
                  const PlaceChart& place)
{
    const record::NoVerdict reason = record::sweepVerdict(run, servo).reason;
    const record::SnapshotServo& who = servo.parameters.servo;
    const QString name = QStringLiteral("ID %1 · ").arg(who.id) + who.model;
    return scribe.heading(2, {name, name}) + axisRows(scribe, servo) +
           verdictLines(scribe, servo, reason) + metricsTable(scribe, servo) +
           charts(scribe, servo, series, place) + legsTable(scribe, servo) +
           parametersPart(scribe, servo);
}
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the report about the legs of one servo.
#include "report/bilingual.h"
#include "report/sweep_parts.h"
#include "report/sweep_text.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
constexpr std::size_t shownAtEnds = 50;
constexpr std::size_t shownWorst = 20;

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
    return remarks.join(htmlWriter.htmlText(listComma()));
}

/// In every run of any length the same, so that it is found in the readings.
QString instantText(base::Duration at)
{
    return QString::number(double(at.count()) / 1e6, 'f', 2);
}

/// To a tenth of a step, which a mean of readings has.
QString reachedText(const results::SweepLeg& leg)
{
    return leg.reached && std::isfinite(*leg.reached) ? QString::number(*leg.reached, 'f', 1)
                                                      : QStringLiteral("–");
}

QString numberText(std::optional<double> value)
{
    return value && std::isfinite(*value) ? figure(*value) : QStringLiteral("–");
}

QString millisecondsText(std::optional<base::Duration> span)
{
    return span ? figure(double(span->count()) / 1000) : QStringLiteral("–");
}

struct LegColumn {
    Text heading;
    QString (*cell)(const HtmlWriter& htmlWriter, const results::SweepLeg& leg);
    bool onPaper = true;
};

std::vector<LegColumn> columns()
{
    using Leg = const results::SweepLeg&;
    using Writer = const HtmlWriter&;
    const SweepTexts& words = sweepTexts();
    return {
        {words.leg, [](Writer, Leg leg) { return QString::number(leg.number); }},
        {words.cycle, [](Writer, Leg leg) { return QString::number(leg.cycle); }},
        {words.at, [](Writer, Leg leg) { return instantText(leg.at); }},
        {words.start, [](Writer, Leg leg) { return exactNumber(leg.start); }},
        {words.target, [](Writer, Leg leg) { return exactNumber(leg.target); }},
        {words.reached, [](Writer, Leg leg) { return reachedText(leg); }},
        {words.timeToTarget, [](Writer, Leg leg) { return millisecondsText(leg.timeToTarget); }},
        {words.settling, [](Writer, Leg leg) { return millisecondsText(leg.settling); }},
        {words.overshoot, [](Writer, Leg leg) { return numberText(leg.overshoot); }},
        {words.steadyError, [](Writer, Leg leg) { return numberText(leg.steadyError); }},
        {words.meanSpeed, [](Writer, Leg leg) { return numberText(leg.meanSpeed); }, false},
        {words.following, [](Writer, Leg leg) { return numberText(leg.followingError); }},
        {words.current, [](Writer, Leg leg) { return numberText(leg.currentPeak); }},
        {words.load, [](Writer, Leg leg) { return numberText(leg.loadPeak); }},
        {words.voltage, [](Writer, Leg leg) { return numberText(leg.voltageMin); }, false},
        {words.temperature, [](Writer, Leg leg) { return numberText(leg.temperatureMax); }, false},
        {words.lost, [](Writer, Leg leg) { return QString::number(leg.lost); }},
        {words.remarks, remarksOf},
    };
}

QString legsTable(const HtmlWriter& htmlWriter, const std::vector<const results::SweepLeg*>& legs,
                  bool paper)
{
    std::vector<LegColumn> shown = columns();
    if (paper)
        std::erase_if(shown, [](const LegColumn& column) { return !column.onPaper; });
    QStringList headings;
    for (const LegColumn& column : shown)
        headings.append(htmlWriter.htmlText(column.heading));
    std::vector<QStringList> rows;
    for (const results::SweepLeg* leg : legs) {
        QStringList& row = rows.emplace_back();
        for (const LegColumn& column : shown)
            row.append(column.cell(htmlWriter, *leg));
    }
    return table(headings, rows, true);
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

std::vector<const results::SweepLeg*> worstLegs(const std::vector<results::SweepLeg>& legs,
                                                std::size_t count)
{
    std::vector<const results::SweepLeg*> shown;
    for (const results::SweepLeg& leg : legs)
        shown.push_back(&leg);
    if (shown.size() <= count)
        return shown;
    std::partial_sort(shown.begin(), shown.begin() + std::ptrdiff_t(count), shown.end(),
                      [](const auto* a, const auto* b) { return severity(*a) > severity(*b); });
    shown.resize(count);
    std::sort(shown.begin(), shown.end());
    return shown;
}

QString legsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo)
{
    const SweepTexts& words = sweepTexts();
    const auto shown = legsToShow(servo.legs);
    QString text = htmlWriter.heading(3, words.legs);
    if (shown.size() < servo.legs.size())
        text += htmlWriter.paragraph(
            filled(words.legsShown, inBoth(QString::number(servo.legs.size()))));
    return text + legsTable(htmlWriter, shown, false);
}

QString worstLegsPart(const HtmlWriter& htmlWriter, const results::SweepServo& servo,
                      std::size_t count)
{
    const SweepTexts& words = sweepTexts();
    const auto shown = worstLegs(servo.legs, count);
    QString text = htmlWriter.heading(3, words.legs);
    if (shown.size() < servo.legs.size())
        text += htmlWriter.paragraph(filled(words.worstShown, inBoth(QString::number(shown.size())),
                                            inBoth(QString::number(servo.legs.size()))));
    return text + legsTable(htmlWriter, shown, true);
}
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_compare_html.h"

#include "record/text_file.h"
#include "report/sweep_compare_words.h"
#include "report/sweep_parts.h"
#include "report/sweep_words.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {
using record::SweepSide;
using Rows = std::vector<QStringList>;

const Text dash{QStringLiteral("–"), QStringLiteral("–")};

QString userText(const QString& text)
{
    return QStringLiteral("<span class=\"user\">") + escaped(text) + QStringLiteral("</span>");
}

QString sidesPart(const Scribe& scribe, const SweepSide& a, const SweepSide& b)
{
    const SweepWords& words = sweepWords();
    const CompareWords& own = compareWords();
    Rows rows;
    const auto row = [&](const Text& name, const auto& cell) {
        rows.push_back({scribe.say(name), cell(a), cell(b)});
    };
    row(own.run, [](const SweepSide& side) { return escaped(side.name); });
    row(words.verdict, [&](const SweepSide& side) { return badge(scribe, side.servo.verdict); });
    row(words.label, [](const SweepSide& side) { return userText(side.servo.parameters.label); });
    row(words.model,
        [](const SweepSide& side) { return escaped(side.servo.parameters.servo.model); });
    row(words.id,
        [](const SweepSide& side) { return QString::number(side.servo.parameters.servo.id); });
    row(words.firmware,
        [](const SweepSide& side) { return escaped(side.servo.parameters.servo.firmware); });
    row(words.date, [](const SweepSide& side) {
        return side.run.at.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
               QStringLiteral(" UTC");
    });
    row(words.legs, [](const SweepSide& side) { return QString::number(side.servo.legs.size()); });
    row(words.operatorName,
        [](const SweepSide& side) { return userText(side.run.spec.operatorName); });
    row(words.note, [](const SweepSide& side) { return userText(side.run.spec.note); });
    row(words.program, [](const SweepSide& side) { return escaped(side.run.program); });
    QString text = scribe.heading(1, own.title);
    if (a.run.simulated || b.run.simulated)
        text += QStringLiteral("<p class=\"simulated\">") + scribe.say(words.simulated) +
                QStringLiteral("</p>\n");
    return text + table({QString(), scribe.say(own.a), scribe.say(own.b)}, rows);
}

QString warningsPart(const Scribe& scribe, const record::SweepComparison& found)
{
    const CompareWords& own = compareWords();
    QString text = scribe.heading(2, own.warnings);
    if (found.tests.empty())
        return text + scribe.paragraph(own.sameTest);
    const auto has = [&](record::Weight weight) {
        return std::any_of(found.tests.begin(), found.tests.end(),
                           [&](const auto& one) { return one.weight == weight; });
    };
    const auto warn = [&](const Text& words) {
        text += QStringLiteral("<p class=\"verdict\" style=\"color: %1\">⚠ ")
                    .arg(gradeColour(record::Grade::Warn)) +
                scribe.say(words) + QStringLiteral("</p>\n");
    };
    if (!found.comparable())
        warn(own.notComparable);
    if (has(record::Weight::Figure))
        warn(own.someDiffer);
    if (has(record::Weight::Grade))
        warn(own.gradesDiffer);
    Rows rows;
    for (const record::TestDifference& one : found.tests)
        rows.push_back({scribe.say(testItemWords(one.item)),
                        scribe.say(testValueWords(one.item, one.a)),
                        scribe.say(testValueWords(one.item, one.b))});
    return text + table({scribe.say(own.testPart), scribe.say(own.a), scribe.say(own.b)}, rows);
}

QString gradeCell(const Scribe& scribe, const std::optional<record::Grade>& grade)
{
    return grade ? lineBadge(scribe, *grade) : QString();
}

QString figuresPart(const Scribe& scribe, const record::SweepComparison& found)
{
    const SweepWords& words = sweepWords();
    const CompareWords& own = compareWords();
    Rows rows;
    for (const record::FigureDifference& one : found.figures) {
        const bool tells = one.better != record::Better::Neither;
        rows.push_back({scribe.say(metricWords(one.key)), scribe.optional(one.a, words.notMeasured),
                        scribe.optional(one.b, words.notMeasured), differenceText(one),
                        scribe.say(unitWords(one.unit)),
                        tells ? QStringLiteral("<b>%1</b>").arg(betterSign(one)) : betterSign(one),
                        gradeCell(scribe, one.gradeA), gradeCell(scribe, one.gradeB)});
    }
    return scribe.heading(2, words.figure) +
           table({scribe.say(words.figure), scribe.say(own.a), scribe.say(own.b),
                  scribe.say(own.difference), scribe.say(words.unit), scribe.say(own.better),
                  scribe.say(own.gradeA), scribe.say(own.gradeB)},
                 rows) +
           scribe.paragraph(words.howJudged) + scribe.paragraph(words.hysteresisNote);
}

QString chartOf(const Scribe& scribe, const Text& side, const SweepSide& of)
{
    std::vector<double> errors;
    for (const record::SweepLeg& leg : of.servo.legs) {
        if (leg.steadyError && std::isfinite(*leg.steadyError))
            errors.push_back(*leg.steadyError);
    }
    QString text = QStringLiteral("<p><b>") + scribe.say(side) + QStringLiteral("</b> ") +
                   escaped(of.name) + QStringLiteral("</p>\n");
    if (errors.empty())
        return text + scribe.paragraph(sweepWords().noErrors);
    record::SweepLimit limit;
    for (const record::SweepLimit& line : of.servo.limits.lines) {
        if (line.metric == QStringLiteral("steady_error"))
            limit = line;
    }
    return text + errorHistogram(scribe, errors, limit.warn, limit.fail);
}

QString settingsPart(const Scribe& scribe, const record::SweepComparison& found)
{
    const CompareWords& own = compareWords();
    QString text = scribe.heading(2, own.settings);
    if (found.settings.empty())
        return text + scribe.paragraph(own.noSettings);
    const auto raw = [&](const std::optional<std::int64_t>& value) {
        return value ? QString::number(qint64(*value)) : QStringLiteral("–");
    };
    Rows rows;
    for (const record::SettingDifference& one : found.settings)
        rows.push_back({escaped(one.key), scribe.optional(one.a, dash),
                        scribe.optional(one.b, dash), escaped(one.unit), raw(one.rawA),
                        raw(one.rawB)});
    const QString rawWord = scribe.say(sweepWords().raw);
    return text + table({scribe.say(own.setting), scribe.say(own.a), scribe.say(own.b),
                         scribe.say(sweepWords().unit), rawWord + QStringLiteral(" A"),
                         rawWord + QStringLiteral(" B")},
                        rows);
}
} // namespace

QByteArray sweepCompareHtml(const SweepSide& a, const SweepSide& b, bool chinese)
{
    const Scribe scribe(Tongue::Both);
    const record::SweepComparison found = record::compareSweeps(a, b);
    const CompareWords& own = compareWords();
    const QString body = sidesPart(scribe, a, b) + warningsPart(scribe, found) +
                         figuresPart(scribe, found) + scribe.heading(2, own.steadyErrors) +
                         chartOf(scribe, own.a, a) + chartOf(scribe, own.b, b) +
                         settingsPart(scribe, found);
    return page(scribe, own.title, body, chinese).toUtf8();
}

base::Result<void> saveSweepCompareHtml(const SweepSide& a, const SweepSide& b, bool chinese,
                                        const QString& path)
{
    return record::saveTextFile(QStringLiteral("save-report"), sweepCompareHtml(a, b, chinese),
                                path);
}
} // namespace report

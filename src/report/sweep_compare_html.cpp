// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sweep_compare_html.h"

#include "files/text_file.h"
#include "report/bilingual.h"
#include "report/register_name.h"
#include "report/sweep_compare_text.h"
#include "report/sweep_parts.h"
#include "report/sweep_text.h"

#include <algorithm>

namespace report {
namespace {
using results::SweepSide;
using Rows = std::vector<QStringList>;

const Text dash = inBoth(QStringLiteral("–"));

QString sidesPart(const HtmlWriter& htmlWriter, const SweepSide& a, const SweepSide& b)
{
    const SweepTexts& words = sweepTexts();
    const CompareTexts& own = compareTexts();
    Rows rows;
    const auto row = [&](const Text& name, const auto& cell) {
        rows.push_back({htmlWriter.htmlText(name), cell(a), cell(b)});
    };
    row(own.run, [](const SweepSide& side) { return escaped(side.name); });
    row(words.verdict,
        [&](const SweepSide& side) { return badge(htmlWriter, side.servo.verdict); });
    row(words.label, [](const SweepSide& side) { return userText(side.servo.parameters.label); });
    row(words.model,
        [](const SweepSide& side) { return escaped(side.servo.parameters.servo.model); });
    row(words.id,
        [](const SweepSide& side) { return QString::number(side.servo.parameters.servo.id); });
    row(words.firmware,
        [](const SweepSide& side) { return escaped(side.servo.parameters.servo.firmware); });
    row(words.date, [](const SweepSide& side) { return localTime(side.run.at); });
    row(words.legs, [](const SweepSide& side) { return QString::number(side.servo.legs.size()); });
    row(words.operatorName,
        [](const SweepSide& side) { return userText(side.run.spec.operatorName); });
    row(words.note, [](const SweepSide& side) { return userText(side.run.spec.note); });
    row(words.program, [](const SweepSide& side) { return escaped(side.run.program); });
    QString text = htmlWriter.heading(1, own.title);
    if (a.run.simulated || b.run.simulated)
        text += QStringLiteral("<p class=\"simulated\">") + htmlWriter.htmlText(words.simulated) +
                QStringLiteral("</p>\n");
    return text + table({QString(), htmlWriter.htmlText(own.a), htmlWriter.htmlText(own.b)}, rows);
}

QString warningsPart(const HtmlWriter& htmlWriter, const results::SweepComparison& found)
{
    const CompareTexts& own = compareTexts();
    QString text = htmlWriter.heading(2, own.warnings);
    if (found.tests.empty())
        return text + htmlWriter.paragraph(own.sameTest);
    const auto has = [&](results::DifferenceImpact weight) {
        return std::any_of(found.tests.begin(), found.tests.end(),
                           [&](const auto& one) { return one.weight == weight; });
    };
    const auto warn = [&](const Text& words) {
        text += QStringLiteral("<p class=\"verdict %1\">⚠ ").arg(gradeClass(results::Grade::Warn)) +
                htmlWriter.htmlText(words) + QStringLiteral("</p>\n");
    };
    if (!found.comparable())
        warn(own.notComparable);
    if (has(results::DifferenceImpact::Figure))
        warn(own.someDiffer);
    if (has(results::DifferenceImpact::Grade))
        warn(own.gradesDiffer);
    Rows rows;
    for (const results::TestDifference& one : found.tests)
        rows.push_back({htmlWriter.htmlText(testItemText(one.item)),
                        htmlWriter.htmlText(testValueText(one.item, one.a)),
                        htmlWriter.htmlText(testValueText(one.item, one.b))});
    return text + table({htmlWriter.htmlText(own.testPart), htmlWriter.htmlText(own.a),
                         htmlWriter.htmlText(own.b)},
                        rows);
}

QString gradeCell(const HtmlWriter& htmlWriter, const std::optional<results::Grade>& grade)
{
    return grade ? lineBadge(htmlWriter, *grade) : QString();
}

QString figuresPart(const HtmlWriter& htmlWriter, const results::SweepComparison& found)
{
    const SweepTexts& words = sweepTexts();
    const CompareTexts& own = compareTexts();
    Rows rows;
    for (const results::FigureDifference& one : found.figures) {
        const bool hasDirection = one.better != results::Better::Neither;
        rows.push_back(
            {htmlWriter.htmlText(metricLabel(one.key)),
             htmlWriter.optional(one.a, words.notMeasured),
             htmlWriter.optional(one.b, words.notMeasured), differenceText(one),
             htmlWriter.htmlText(unitText(one.unit)),
             hasDirection ? QStringLiteral("<b>%1</b>").arg(betterSign(one)) : betterSign(one),
             gradeCell(htmlWriter, one.gradeA), gradeCell(htmlWriter, one.gradeB)});
    }
    return htmlWriter.heading(2, words.figure) +
           table({htmlWriter.htmlText(words.figure), htmlWriter.htmlText(own.a),
                  htmlWriter.htmlText(own.b), htmlWriter.htmlText(own.difference),
                  htmlWriter.htmlText(words.unit), htmlWriter.htmlText(own.better),
                  htmlWriter.htmlText(own.gradeA), htmlWriter.htmlText(own.gradeB)},
                 rows) +
           htmlWriter.paragraph(words.gradingNote) + htmlWriter.paragraph(words.hysteresisNote);
}

QString chartOf(const HtmlWriter& htmlWriter, const Text& letter, const SweepSide& side)
{
    return QStringLiteral("<p><b>") + htmlWriter.htmlText(letter) + QStringLiteral("</b> ") +
           escaped(side.name) + QStringLiteral("</p>\n") + errorsChart(htmlWriter, side.servo);
}

QString settingsPart(const HtmlWriter& htmlWriter, const results::SweepComparison& found,
                     const SweepSide& a, const SweepSide& b)
{
    const CompareTexts& own = compareTexts();
    QString text = htmlWriter.heading(2, own.settings);
    if (found.settings.empty())
        return text + htmlWriter.paragraph(own.noSettings);
    const auto raw = [&](const std::optional<std::int64_t>& value) {
        return value ? QString::number(qint64(*value)) : QStringLiteral("–");
    };
    Rows rows;
    for (const results::SettingDifference& one : found.settings)
        rows.push_back({htmlWriter.htmlText(settingName(a, b, one.key)),
                        htmlWriter.optional(one.a, dash), htmlWriter.optional(one.b, dash),
                        htmlWriter.htmlText(registerUnit(one.unit)), raw(one.rawA), raw(one.rawB)});
    const QString rawWord = htmlWriter.htmlText(sweepTexts().raw);
    return text + table({htmlWriter.htmlText(own.setting), htmlWriter.htmlText(own.a),
                         htmlWriter.htmlText(own.b), htmlWriter.htmlText(sweepTexts().unit),
                         rawWord + QStringLiteral(" A"), rawWord + QStringLiteral(" B")},
                        rows);
}
} // namespace

QByteArray sweepCompareHtml(const SweepSide& a, const SweepSide& b, bool chinese)
{
    const HtmlWriter htmlWriter(ReportLanguage::Both);
    const results::SweepComparison found = results::compareSweeps(a, b);
    const CompareTexts& own = compareTexts();
    const QString body = sidesPart(htmlWriter, a, b) + warningsPart(htmlWriter, found) +
                         figuresPart(htmlWriter, found) + htmlWriter.heading(2, own.steadyErrors) +
                         chartOf(htmlWriter, own.a, a) + chartOf(htmlWriter, own.b, b) +
                         settingsPart(htmlWriter, found, a, b);
    return page(htmlWriter, own.title, body, chinese).toUtf8();
}

base::Result<void> saveSweepCompareHtml(const SweepSide& a, const SweepSide& b, bool chinese,
                                        const QString& path)
{
    return files::saveTextFile(QStringLiteral("save-report"), sweepCompareHtml(a, b, chinese),
                               path);
}
} // namespace report

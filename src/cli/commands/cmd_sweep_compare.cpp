// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "report/html_page.h"
#include "report/sweep_compare_html.h"
#include "report/sweep_compare_text.h"
#include "report/sweep_text.h"
#include "text/language.h"

#include <QFileInfo>

namespace cli {
namespace {
QString figureText(const std::optional<double>& value)
{
    return value ? report::figure(*value) : noValue();
}

QString gradeText(const std::optional<results::Grade>& grade)
{
    return grade ? text::localized(report::lineGradeLabel(*grade)) : QString();
}

std::optional<QString> gradeJson(const std::optional<results::Grade>& grade)
{
    return grade ? std::optional(results::gradeName(*grade)) : std::nullopt;
}

Json sideJson(const results::SweepSide& side)
{
    const snapshot::SnapshotServo& identity = side.servo.parameters.servo;
    return Json::object()
        .add("run", side.name)
        .add("id", identity.id)
        .add("model", identity.model)
        .add("firmware", identity.firmware)
        .add("label", side.servo.parameters.label)
        .add("time", side.run.at.toString(Qt::ISODateWithMs))
        .add("verdict", results::gradeName(side.servo.verdict));
}

Json figuresJson(const results::SweepComparison& found)
{
    Json::Array rows;
    for (const results::FigureDifference& one : found.figures) {
        std::optional<QString> better;
        if (one.better != results::Better::Neither)
            better = one.better == results::Better::A ? QStringLiteral("a") : QStringLiteral("b");
        rows.push_back(Json::object()
                           .add("metric", one.key)
                           .add("unit", one.unit)
                           .add("a", one.a)
                           .add("b", one.b)
                           .add("difference", one.difference)
                           .add("better", better)
                           .add("grade_a", gradeJson(one.gradeA))
                           .add("grade_b", gradeJson(one.gradeB)));
    }
    return rows;
}

Json testsJson(const results::SweepComparison& found)
{
    Json::Array rows;
    for (const results::TestDifference& one : found.tests)
        rows.push_back(Json::object()
                           .add("part", results::testItemName(one.item))
                           .add("concerns", results::weightName(one.weight))
                           .add("a", one.a)
                           .add("b", one.b));
    return rows;
}

Json settingsJson(const results::SweepComparison& found)
{
    Json::Array rows;
    for (const results::SettingDifference& one : found.settings)
        rows.push_back(Json::object()
                           .add("key", one.key)
                           .add("a", one.a)
                           .add("b", one.b)
                           .add("unit", one.unit)
                           .add("raw_a", one.rawA)
                           .add("raw_b", one.rawB));
    return rows;
}

QString sideText(const char* letter, const results::SweepSide& side)
{
    const snapshot::SnapshotServo& identity = side.servo.parameters.servo;
    return QStringLiteral("%1: %2 · %3 · ID %4 · %5 · %6 %7\n")
        .arg(QString::fromLatin1(letter), side.name, identity.model, QString::number(identity.id),
             localTime(side.run.at), report::gradeSign(side.servo.verdict),
             text::localized(report::gradeLabel(side.servo.verdict)));
}

QString testsText(const results::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    if (found.tests.empty())
        return text::localized(words.sameTest) + QLatin1Char('\n');
    QString text;
    if (!found.comparable())
        text += QStringLiteral("⚠ ") + text::localized(words.notComparable) + QLatin1Char('\n');
    Table table({text::localized(words.warnings), QStringLiteral("A"), QStringLiteral("B")});
    for (const results::TestDifference& one : found.tests)
        table.add({text::localized(report::testItemText(one.item)),
                   text::localized(report::testValueText(one.item, one.a)),
                   text::localized(report::testValueText(one.item, one.b))});
    return text + table.text();
}

QString figuresText(const results::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    Table table({translate("cli", "Metric"), QStringLiteral("A"), QStringLiteral("B"),
                 text::localized(words.difference), translate("cli", "Unit"),
                 text::localized(words.better), text::localized(words.gradeA),
                 text::localized(words.gradeB)});
    table.alignRight({1, 2, 3});
    for (const results::FigureDifference& one : found.figures) {
        if (!one.a && !one.b)
            continue;
        table.add({text::localized(report::metricLabel(one.key)), figureText(one.a),
                   figureText(one.b), report::differenceText(one),
                   text::localized(report::unitText(one.unit)), report::betterSign(one),
                   gradeText(one.gradeA), gradeText(one.gradeB)});
    }
    return table.text();
}

QString settingsText(const results::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    if (found.settings.empty())
        return text::localized(words.noSettings) + QLatin1Char('\n');
    Table table({text::localized(words.settings), QStringLiteral("A"), QStringLiteral("B"),
                 translate("cli", "Unit")});
    table.alignRight({1, 2});
    for (const results::SettingDifference& one : found.settings)
        table.add({one.key, figureText(one.a), figureText(one.b), one.unit});
    return table.text();
}

struct Chosen {
    RunSelector word;
    results::SweepRun run;
    const results::SweepServo* servo = nullptr; ///< in `run`
};

base::Result<void> choose(const Values& values, const char* which, Chosen& into)
{
    auto word = parseRunSelector(values.argument(which));
    if (!word)
        return tl::unexpected(word.error());
    into.word = *word;
    auto run = loadSweep(*word);
    if (!run)
        return tl::unexpected(run.error());
    into.run = std::move(*run);
    const auto id = values.option("--servo");
    // The servo is not named if the run has only one.
    if (id && !into.word.servo && into.run.servos.size() > 1) {
        const auto parsed = parseId(*id);
        if (!parsed)
            return tl::unexpected(parsed.error());
        into.word.servo = *parsed;
    }
    const auto servo = chooseServo(into.run, into.word);
    if (!servo)
        return tl::unexpected(servo.error());
    into.servo = *servo;
    return {};
}

base::Result<Exit> runSweepCompare(Run& run, const Values& values)
{
    const auto path = values.option("--report");
    if (path && QFileInfo(*path).suffix().toLower() != QLatin1String("html"))
        return badArgument(
            translate("cli", "the file name of a comparison report must end with .html"));
    Chosen one;
    Chosen two;
    if (const auto chosen = choose(values, "A", one); !chosen)
        return tl::unexpected(chosen.error());
    if (const auto chosen = choose(values, "B", two); !chosen)
        return tl::unexpected(chosen.error());
    const results::SweepSide a{one.word.name, one.run, *one.servo};
    const results::SweepSide b{two.word.name, two.run, *two.servo};
    if (path) {
        if (const auto saved = report::saveSweepCompareHtml(a, b, text::isUiChinese(), *path);
            !saved)
            return tl::unexpected(saved.error());
    }
    const results::SweepComparison found = results::compareSweeps(a, b);
    run.finish(
        Json::object()
            .add("a", sideJson(a))
            .add("b", sideJson(b))
            .add("comparable", found.comparable())
            .add("figures", figuresJson(found))
            .add("tests", testsJson(found))
            .add("settings", settingsJson(found)),
        sideText("A", a) + sideText("B", b) + QLatin1Char('\n') + testsText(found) +
            QLatin1Char('\n') + figuresText(found) + QLatin1Char('\n') + settingsText(found) +
            (path ? translate("cli", "Report: %1").arg(*path) + QLatin1Char('\n') : QString()));
    return Exit::Success;
}
} // namespace

Command sweepCompareCommand()
{
    return {"sweep-compare",
            QT_TRANSLATE_NOOP("cli", "compare two sweep tests; no port is needed"),
            {{"A", QT_TRANSLATE_NOOP("cli", "test run in the history (12, or 12:3 for ID 3 of that "
                                            "run), or a .json report file")},
             {"B", QT_TRANSLATE_NOOP("cli", "test run to compare with the first one")}},
            {{"--servo", QT_TRANSLATE_NOOP("cli", "servo to compare, if a run has several"), "ID"},
             {"--report", QT_TRANSLATE_NOOP("cli", "save the comparison as a web page (.html)"),
              "FILE"}},
            runSweepCompare};
}
} // namespace cli

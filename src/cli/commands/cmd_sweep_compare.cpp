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
QString in(const catalog::Text& words)
{
    return words.in(text::isUiChinese());
}

QString number(const std::optional<double>& value)
{
    return value ? report::figure(*value) : QStringLiteral("–");
}

QString gradeText(const std::optional<record::Grade>& grade)
{
    return grade ? in(report::lineGradeLabel(*grade)) : QString();
}

std::optional<QString> gradeJson(const std::optional<record::Grade>& grade)
{
    return grade ? std::optional(record::gradeName(*grade)) : std::nullopt;
}

Json sideJson(const record::SweepSide& side)
{
    const record::SnapshotServo& identity = side.servo.parameters.servo;
    return Json::object()
        .add("run", side.name)
        .add("id", identity.id)
        .add("model", identity.model)
        .add("firmware", identity.firmware)
        .add("label", side.servo.parameters.label)
        .add("time", side.run.at.toString(Qt::ISODateWithMs))
        .add("verdict", record::gradeName(side.servo.verdict));
}

Json figuresJson(const record::SweepComparison& found)
{
    Json::Array rows;
    for (const record::FigureDifference& one : found.figures) {
        std::optional<QString> better;
        if (one.better != record::Better::Neither)
            better = one.better == record::Better::A ? QStringLiteral("a") : QStringLiteral("b");
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

Json testsJson(const record::SweepComparison& found)
{
    Json::Array rows;
    for (const record::TestDifference& one : found.tests)
        rows.push_back(Json::object()
                           .add("part", record::testItemName(one.item))
                           .add("concerns", record::weightName(one.weight))
                           .add("a", one.a)
                           .add("b", one.b));
    return rows;
}

Json settingsJson(const record::SweepComparison& found)
{
    Json::Array rows;
    for (const record::SettingDifference& one : found.settings)
        rows.push_back(Json::object()
                           .add("key", one.key)
                           .add("a", one.a)
                           .add("b", one.b)
                           .add("unit", one.unit)
                           .add("raw_a", one.rawA)
                           .add("raw_b", one.rawB));
    return rows;
}

QString sideText(const char* letter, const record::SweepSide& side)
{
    const record::SnapshotServo& identity = side.servo.parameters.servo;
    return QStringLiteral("%1: %2 · %3 · ID %4 · %5 · %6 %7\n")
        .arg(QString::fromLatin1(letter), side.name, identity.model, QString::number(identity.id),
             side.run.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
             report::gradeSign(side.servo.verdict), in(report::gradeLabel(side.servo.verdict)));
}

QString testsText(const record::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    if (found.tests.empty())
        return in(words.sameTest) + QLatin1Char('\n');
    QString text;
    if (!found.comparable())
        text += QStringLiteral("⚠ ") + in(words.notComparable) + QLatin1Char('\n');
    Table table({in(words.warnings), QStringLiteral("A"), QStringLiteral("B")});
    for (const record::TestDifference& one : found.tests)
        table.add({in(report::testItemText(one.item)), in(report::testValueText(one.item, one.a)),
                   in(report::testValueText(one.item, one.b))});
    return text + table.text();
}

QString figuresText(const record::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    Table table({translate("cli", "Figure"), QStringLiteral("A"), QStringLiteral("B"),
                 in(words.difference), translate("cli", "Unit"), in(words.better), in(words.gradeA),
                 in(words.gradeB)});
    table.alignRight({1, 2, 3});
    for (const record::FigureDifference& one : found.figures) {
        if (!one.a && !one.b)
            continue;
        table.add({in(report::metricLabel(one.key)), number(one.a), number(one.b),
                   report::differenceText(one), in(report::unitText(one.unit)),
                   report::betterSign(one), gradeText(one.gradeA), gradeText(one.gradeB)});
    }
    return table.text();
}

QString settingsText(const record::SweepComparison& found)
{
    const report::CompareTexts& words = report::compareTexts();
    if (found.settings.empty())
        return in(words.noSettings) + QLatin1Char('\n');
    Table table(
        {in(words.settings), QStringLiteral("A"), QStringLiteral("B"), translate("cli", "Unit")});
    table.alignRight({1, 2});
    for (const record::SettingDifference& one : found.settings)
        table.add({one.key, number(one.a), number(one.b), one.unit});
    return table.text();
}

struct Chosen {
    RunSelector word;
    record::SweepRun run;
    const record::SweepServo* servo = nullptr; ///< in `run`
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
    // A run of one servo is clear without a word about it.
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

base::Result<Exit> run(Run& run, const Values& values)
{
    const auto path = values.option("--report");
    if (path && QFileInfo(*path).suffix().toLower() != QLatin1String("html"))
        return badArgument(translate("cli", "the report of a comparison ends with .html"));
    Chosen one;
    Chosen two;
    if (const auto chosen = choose(values, "A", one); !chosen)
        return tl::unexpected(chosen.error());
    if (const auto chosen = choose(values, "B", two); !chosen)
        return tl::unexpected(chosen.error());
    const record::SweepSide a{one.word.name, one.run, *one.servo};
    const record::SweepSide b{two.word.name, two.run, *two.servo};
    if (path) {
        if (const auto saved = report::saveSweepCompareHtml(a, b, text::isUiChinese(), *path);
            !saved)
            return tl::unexpected(saved.error());
    }
    const record::SweepComparison found = record::compareSweeps(a, b);
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
    return {
        "sweep-compare",
        QT_TRANSLATE_NOOP("cli", "hold one sweep test against another; needs no port"),
        {{"A", QT_TRANSLATE_NOOP("cli", "a test run: 12 of the history, 12:3 for servo 3 of "
                                        "it, or a report that ends with .json")},
         {"B", QT_TRANSLATE_NOOP("cli", "the one that is held against it")}},
        {{"--servo", QT_TRANSLATE_NOOP("cli", "which servo, where a run has several"), "ID"},
         {"--report", QT_TRANSLATE_NOOP("cli", "save the comparison as a page (.html)"), "FILE"}},
        run};
}
} // namespace cli

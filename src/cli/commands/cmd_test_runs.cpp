// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/input/arguments.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/sweep_history.h"
#include "cli/translate.h"
#include "report/sweep_text.h"
#include "session/paths.h"
#include "text/language.h"

namespace cli {
namespace {
Json servoJson(const history::TestRun& run, const history::TestServo& servo)
{
    return Json::object()
        .add("id", servo.id)
        .add("model", servo.model)
        .add("map", servo.map)
        .add("firmware", servo.firmware)
        .add("verdict", results::gradeName(servo.verdict))
        .add("label", servo.label)
        .add("reference", servo.reference && history::canBeReference(run, servo));
}

Json runJson(const history::TestRun& run)
{
    Json::Array servos;
    for (const history::TestServo& servo : run.servos)
        servos.push_back(servoJson(run, servo));
    return Json::object()
        .add("number", run.number)
        .add("uuid", run.uuid)
        .add("kind", run.kind)
        .add("time", run.at.toString(Qt::ISODateWithMs))
        .add("program", run.program)
        .add("port", run.port)
        .add("simulated", run.simulated)
        .add("verdict", results::gradeName(run.verdict))
        .add("end", run.end)
        .add("operator", run.operatorName)
        .add("note", run.note)
        .add("length_ms", double(run.length.count()) / 1000)
        .add("servos", std::move(servos))
        .add("files", run.files);
}

/// A reference that came with a database may be one that could not be marked here.
QString referenceText(const history::TestRun& run, const history::TestServo& servo)
{
    if (servo.reference && !history::canBeReference(run))
        return translate("cli", "ignored: the test did not finish");
    if (servo.reference && !history::canBeReference(run, servo))
        return translate("cli", "ignored: the servo failed");
    return servo.reference ? QStringLiteral("★") : QString();
}

/// A step response has no verdict and no reference.
QString stepRunsListText(const std::vector<history::TestRun>& runs)
{
    Table table({translate("cli", "Run"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "Result"), translate("cli", "Label"), translate("cli", "Note")});
    table.alignRight({0, 2});
    for (const history::TestRun& run : runs) {
        const auto end = results::sweepEndFromName(run.end);
        for (const history::TestServo& servo : run.servos)
            table.add({QString::number(qint64(run.number)), localTime(run.at),
                       QString::number(servo.id), servo.model, servo.firmware,
                       end ? text::localized(report::endText(*end)) : run.end,
                       QString(servo.label).simplified(), QString(run.note).simplified()});
    }
    return table.text();
}

QString sweepRunsText(const std::vector<history::TestRun>& runs)
{
    Table table({translate("cli", "Run"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "Verdict"), translate("cli", "Reference"),
                 translate("cli", "Label"), translate("cli", "Note")});
    table.alignRight({0, 2});
    for (const history::TestRun& run : runs) {
        for (const history::TestServo& servo : run.servos) {
            table.add({QString::number(qint64(run.number)), localTime(run.at),
                       QString::number(servo.id), servo.model, servo.firmware,
                       report::gradeSign(servo.verdict) + QLatin1Char(' ') +
                           text::localized(report::gradeLabel(servo.verdict)),
                       referenceText(run, servo), QString(servo.label).simplified(),
                       QString(run.note).simplified()});
        }
    }
    return table.text();
}

using RunsText = QString (*)(const std::vector<history::TestRun>& runs);

base::Result<Exit> runList(Run& run, const Values& values, const QString& kind, RunsText runsText)
{
    history::RunFilter filter;
    filter.kind = kind;
    filter.model = values.option("--model").value_or(QString());
    filter.text = values.option("--text").value_or(QString());
    if (const auto id = values.option("--servo")) {
        const auto parsed = parseId(*id);
        if (!parsed)
            return tl::unexpected(parsed.error());
        filter.id = *parsed;
    }
    const auto runs = listRuns(filter);
    if (!runs)
        return tl::unexpected(runs.error());
    Json::Array list;
    for (const history::TestRun& one : *runs)
        list.push_back(runJson(one));
    run.finish(Json::object().add("runs", std::move(list)),
               runs->empty() ? translate("cli", "No matching test runs.") + QLatin1Char('\n')
                             : runsText(*runs));
    return Exit::Success;
}

base::Result<Exit> runSweepList(Run& run, const Values& values)
{
    return runList(run, values, QStringLiteral("sweep"), sweepRunsText);
}

base::Result<Exit> runStepList(Run& run, const Values& values)
{
    return runList(run, values, QStringLiteral("step"), stepRunsListText);
}

base::Result<Exit> runReference(Run& run, const Values& values)
{
    const auto word = parseRunSelector(values.argument("RUN"));
    if (!word)
        return tl::unexpected(word.error());
    if (word->number == 0)
        return badArgument(translate("cli", "a reference must be a test run in the history, for "
                                            "example 12, or 12:3 for ID 3 of that run"));
    const auto sweep = loadSweep(*word);
    if (!sweep)
        return tl::unexpected(sweep.error());
    const auto servo = chooseServo(*sweep, *word);
    if (!servo)
        return tl::unexpected(servo.error());
    const snapshot::SnapshotServo& identity = (*servo)->parameters.servo;
    const bool mark = !values.has("--clear");
    const auto history = history::History::open(session::historyFile());
    if (!history)
        return tl::unexpected(history.error());
    if (const auto set = (*history)->setReference(word->number, identity.id, mark); !set)
        return tl::unexpected(set.error());
    run.finish(Json::object()
                   .add("run", word->number)
                   .add("id", identity.id)
                   .add("model", identity.model)
                   .add("reference", mark),
               (mark ? translate("cli", "Test run %1, ID %2, is now the reference for %3")
                     : translate("cli", "Test run %1, ID %2, is no longer a reference for %3"))
                       .arg(qint64(word->number))
                       .arg(identity.id)
                       .arg(identity.model) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

std::vector<Option> filterOptions()
{
    return {{"--model", QT_TRANSLATE_NOOP("cli", "only servos of this model"), "MODEL"},
            {"--servo", QT_TRANSLATE_NOOP("cli", "only servos with this ID"), "ID"},
            {"--text",
             QT_TRANSLATE_NOOP("cli",
                               "only runs whose label, note, operator or port contains this text"),
             "TEXT"}};
}
} // namespace

Command sweepRunsCommand()
{
    return {"sweep-runs",
            QT_TRANSLATE_NOOP("cli", "list the sweep tests in the history; no port is needed"),
            {},
            filterOptions(),
            runSweepList};
}

Command stepRunsCommand()
{
    return {"step-runs",
            QT_TRANSLATE_NOOP("cli", "list the step responses in the history; no port is needed"),
            {},
            filterOptions(),
            runStepList};
}

Command sweepReferenceCommand()
{
    return {
        "sweep-reference",
        QT_TRANSLATE_NOOP("cli", "mark a servo in a test run as the reference for its model"),
        {{"RUN", QT_TRANSLATE_NOOP(
                     "cli", "test run number in the history: 12, or 12:3 for ID 3 of that run")}},
        {{"--clear", QT_TRANSLATE_NOOP("cli", "remove the reference mark")}},
        runReference};
}
} // namespace cli

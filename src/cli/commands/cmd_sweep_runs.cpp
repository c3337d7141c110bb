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
Json servoJson(const record::TestRun& run, const record::TestServo& servo)
{
    return Json::object()
        .add("id", servo.id)
        .add("model", servo.model)
        .add("map", servo.map)
        .add("firmware", servo.firmware)
        .add("verdict", record::gradeName(servo.verdict))
        .add("label", servo.label)
        .add("reference", servo.reference && record::canBeReference(run, servo));
}

Json runJson(const record::TestRun& run)
{
    Json::Array servos;
    for (const record::TestServo& servo : run.servos)
        servos.push_back(servoJson(run, servo));
    return Json::object()
        .add("number", run.number)
        .add("uuid", run.uuid)
        .add("kind", run.kind)
        .add("time", run.at.toString(Qt::ISODateWithMs))
        .add("program", run.program)
        .add("port", run.port)
        .add("simulated", run.simulated)
        .add("verdict", record::gradeName(run.verdict))
        .add("end", run.end)
        .add("operator", run.operatorName)
        .add("note", run.note)
        .add("length_ms", double(run.length.count()) / 1000)
        .add("servos", std::move(servos))
        .add("files", run.files);
}

/// Earlier versions marked tests that had not finished, too.
QString referenceText(const record::TestRun& run, const record::TestServo& servo)
{
    if (servo.reference && !record::canBeReference(run))
        return translate("cli", "ignored: did not finish");
    if (servo.reference && !record::canBeReference(run, servo))
        return translate("cli", "ignored: failed");
    return servo.reference ? QStringLiteral("★") : QString();
}

QString runsText(const std::vector<record::TestRun>& runs)
{
    if (runs.empty())
        return translate("cli", "No test run fits.") + QLatin1Char('\n');
    Table table({translate("cli", "Run"), translate("cli", "When"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "Verdict"), translate("cli", "Reference"),
                 translate("cli", "Label"), translate("cli", "Note")});
    table.alignRight({0, 2});
    for (const record::TestRun& run : runs) {
        const QString when = run.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
        for (const record::TestServo& servo : run.servos) {
            table.add({QString::number(qint64(run.number)), when, QString::number(servo.id),
                       servo.model, servo.firmware,
                       report::gradeSign(servo.verdict) + QLatin1Char(' ') +
                           report::gradeLabel(servo.verdict).in(text::isUiChinese()),
                       referenceText(run, servo), QString(servo.label).simplified(),
                       QString(run.note).simplified()});
        }
    }
    return table.text();
}

base::Result<Exit> runList(Run& run, const Values& values)
{
    record::RunFilter filter;
    filter.kind = QStringLiteral("sweep");
    filter.model = values.option("--model").value_or(QString());
    filter.text = values.option("--text").value_or(QString());
    if (const auto id = values.option("--servo")) {
        const auto parsed = parseId(*id);
        if (!parsed)
            return tl::unexpected(parsed.error());
        filter.id = *parsed;
    }
    const auto runs = listSweeps(filter);
    if (!runs)
        return tl::unexpected(runs.error());
    Json::Array list;
    for (const record::TestRun& one : *runs)
        list.push_back(runJson(one));
    run.finish(Json::object().add("runs", std::move(list)), runsText(*runs));
    return Exit::Success;
}

base::Result<Exit> runReference(Run& run, const Values& values)
{
    const auto word = parseRunSelector(values.argument("RUN"));
    if (!word)
        return tl::unexpected(word.error());
    if (word->number == 0)
        return badArgument(translate("cli", "a reference is a test run of the history: 12, or 12:3 "
                                            "for servo 3 of it"));
    const auto sweep = loadSweep(*word);
    if (!sweep)
        return tl::unexpected(sweep.error());
    const auto servo = chooseServo(*sweep, *word);
    if (!servo)
        return tl::unexpected(servo.error());
    const record::SnapshotServo& identity = (*servo)->parameters.servo;
    const bool mark = !values.has("--clear");
    const auto history = record::History::open(session::historyFile());
    if (!history)
        return tl::unexpected(history.error());
    if (const auto set = (*history)->setReference(word->number, identity.id, mark); !set)
        return tl::unexpected(set.error());
    run.finish(Json::object()
                   .add("run", word->number)
                   .add("id", identity.id)
                   .add("model", identity.model)
                   .add("reference", mark),
               (mark ? translate("cli", "Test run %1, servo %2, is now the reference of %3")
                     : translate("cli", "Test run %1, servo %2, is no reference of %3"))
                       .arg(qint64(word->number))
                       .arg(identity.id)
                       .arg(identity.model) +
                   QLatin1Char('\n'));
    return Exit::Success;
}
} // namespace

Command sweepRunsCommand()
{
    return {"sweep-runs",
            QT_TRANSLATE_NOOP("cli", "list the sweep tests of the history; needs no port"),
            {},
            {{"--model", QT_TRANSLATE_NOOP("cli", "only servos of this model"), "MODEL"},
             {"--servo", QT_TRANSLATE_NOOP("cli", "only with this ID"), "ID"},
             {"--text", QT_TRANSLATE_NOOP("cli", "only with this in label, note, operator or port"),
              "TEXT"}},
            runList};
}

Command sweepReferenceCommand()
{
    return {"sweep-reference",
            QT_TRANSLATE_NOOP("cli", "make a servo of a test run the reference of its model"),
            {{"RUN", QT_TRANSLATE_NOOP("cli", "number in the history: 12, or 12:3 for servo 3")}},
            {{"--clear", QT_TRANSLATE_NOOP("cli", "it is one no longer")}},
            runReference};
}
} // namespace cli

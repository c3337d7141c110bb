// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the history: a write with all that belongs to it, a label, a table taken out again.
#include "cli/commands.h"
#include "cli/history_remote.h"
#include "cli/input/arguments.h"
#include "cli/input/history_input.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "history/history_table.h"
#include "text/language.h"
#include "text/write_text.h"

#include <algorithm>

namespace cli {
namespace {
base::Result<std::unique_ptr<record::History>> requireHistory(Run& run, const Values& values)
{
    auto history = openHistory(run, values);
    if (history && !*history)
        return badArgument(translate("cli", "there is no history yet"));
    return history;
}

base::Result<std::int64_t> parseNumber(const QString& word)
{
    bool fine = false;
    const qint64 number = QString(word).remove(QLatin1Char('#')).toLongLong(&fine);
    if (!fine || number < 1)
        return badArgument(translate("cli", "\"%1\" is no number of a row").arg(word));
    return number;
}

/// All registers that were written together with one of them.
base::Result<std::vector<record::HistoryWrite>> together(const record::HistoryLog& log,
                                                         std::int64_t number)
{
    const auto one = log.write(number);
    if (!one)
        return tl::unexpected(one.error());
    record::HistoryFilter filter;
    filter.servo = one->servo;
    filter.from = one->at;
    filter.until = one->at.addMSecs(1);
    filter.limit = 10000;
    auto near = log.writes(filter);
    if (!near)
        return near;
    std::vector<record::HistoryWrite> own;
    for (record::HistoryWrite& write : *near) {
        if (write.intent == one->intent)
            own.insert(own.begin(), std::move(write));
    }
    return own;
}

base::Result<Exit> show(Run& run, const Values& values)
{
    const auto number = parseNumber(values.argument("WRITE"));
    if (!number)
        return tl::unexpected(number.error());
    const auto history = requireHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const auto writes = together((*history)->log(), *number);
    if (!writes)
        return tl::unexpected(writes.error());
    record::HistoryProfiles profiles(run.session().catalog());
    if (const auto known = loadProfiles(**history, profiles); !known)
        return tl::unexpected(known.error());
    const record::HistoryWrite& head = writes->front();
    Table table({translate("cli", "Register"), translate("cli", "Old"), translate("cli", "New"),
                 translate("cli", "Read back"), translate("cli", "Outcome")});
    table.alignRight({1, 2, 3});
    Json::Array rows;
    for (const record::HistoryWrite& write : *writes) {
        const auto value = [&](const std::optional<std::int64_t>& raw) {
            return raw ? profiles.valueText(write, *raw, text::isUiChinese()) : QStringLiteral("–");
        };
        table.add({write.key, value(write.oldRaw), value(write.newRaw), value(write.readBack),
                   text::writeOutcomeLabel(write.outcome)});
        rows.push_back(Json::object()
                           .add("number", write.number)
                           .add("register", write.key)
                           .add("address", write.address)
                           .add("old", write.oldRaw)
                           .add("new", write.newRaw)
                           .add("read_back", write.readBack)
                           .add("outcome", write.outcome));
    }
    run.finish(
        Json::object()
            .add("intent", head.intentUuid)
            .add("time", head.at.toString(Qt::ISODateWithMs))
            .add("kind", base::intentKindName(head.kind))
            .add("temporary", head.temporary)
            .add("servo", head.servo)
            .add("id", head.servoId)
            .add("model", head.model)
            .add("label", head.label)
            .add("port", head.port)
            .add("baud", head.baud)
            .add("program", head.program)
            .add("detail", head.detail)
            .add("writes", std::move(rows)),
        text::intentLabel(head.kind, head.temporary, head.ownDefaults) + QStringLiteral(": ") +
            translate("cli", "%1, servo %2 %3, on %4 at %5 baud, by %6")
                .arg(head.at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
                     QString::number(head.servoId),
                     head.label.isEmpty()
                         ? head.model
                         : head.model + QStringLiteral(" \"") + head.label + QLatin1Char('"'),
                     head.port, QString::number(head.baud),
                     head.program.isEmpty() ? translate("cli", "an earlier version")
                                            : head.program) +
            QLatin1Char('\n') + table.text());
    return Exit::Success;
}

base::Result<Exit> runLabel(Run& run, const Values& values)
{
    const auto history = requireHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const record::HistoryLog log = (*history)->log();
    auto servo = parseServo(**history, values.argument("SERVO"));
    if (!servo)
        return tl::unexpected(servo.error());
    const QString label = values.argument("LABEL").trimmed();
    if (values.has("--another")) {
        const auto other = log.assignToOther(*servo, label);
        if (!other)
            return tl::unexpected(other.error());
        *servo = other->number;
    } else if (const auto named = log.setLabel(*servo, label); !named) {
        return tl::unexpected(named.error());
    }
    const auto now = log.servo(*servo);
    if (!now)
        return tl::unexpected(now.error());
    run.finish(Json::object()
                   .add("servo", now->number)
                   .add("id", now->identity.id)
                   .add("model", now->identity.model)
                   .add("label", now->label),
               (values.has("--another")
                    ? translate("cli", "The %1 that answers to ID %2 is now servo %3, \"%4\"")
                    : translate("cli", "The %1 with ID %2, servo %3, is called \"%4\""))
                       .arg(now->identity.model, QString::number(now->identity.id),
                            QString::number(qint64(now->number)), now->label) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> takeSnapshot(Run& run, const Values& values)
{
    const auto number = parseNumber(values.argument("SNAPSHOT"));
    if (!number)
        return tl::unexpected(number.error());
    const auto history = requireHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const auto snapshot = (*history)->log().snapshot(*number);
    if (!snapshot)
        return tl::unexpected(snapshot.error());
    const QString file = values.argument("FILE");
    if (const auto saved = record::saveSnapshot(*snapshot, file); !saved)
        return tl::unexpected(saved.error());
    const auto count = int(snapshot->registers.size());
    run.finish(Json::object()
                   .add("snapshot", *number)
                   .add("id", snapshot->servo.id)
                   .add("file", file)
                   .add("registers", count),
               translate("cli", "Registers saved to %1: %2").arg(file).arg(count) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

QString tableText(const record::TableState& point, const QString& file)
{
    const auto local = [](const QDateTime& at) {
        return at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    };
    const QString comma = QStringLiteral(", ");
    QStringList lines{
        translate("cli", "Registers saved to %1: %2").arg(file).arg(point.table.registers.size()),
        translate("cli", "From snapshot %1 of %2; written since then: %3")
            .arg(QString::number(qint64(point.base.number)), local(point.base.at),
                 point.replayed.isEmpty() ? translate("cli", "nothing")
                                          : point.replayed.join(comma))};
    if (!point.unknown.isEmpty())
        lines << translate("cli", "Changed without a record of how, so without a value: %1")
                     .arg(point.unknown.join(comma));
    if (!point.temporary.isEmpty())
        lines << translate("cli", "Written temporarily, which is left out: the table has the "
                                  "stored value of %1")
                     .arg(point.temporary.join(comma));
    if (point.changedId)
        lines << translate("cli", "Its ID was changed to %1 on %2: what was written to it with "
                                  "that ID is in the history of servo ID %1, not here")
                     .arg(QString::number(point.changedId->id), local(point.changedId->at));
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

base::Result<Exit> takeTable(Run& run, const Values& values)
{
    const auto at = parseDateTime(values.argument("TIME"), QDateTime::currentDateTimeUtc());
    if (!at)
        return tl::unexpected(at.error());
    const auto history = requireHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const auto servo = parseServo(**history, values.argument("SERVO"));
    if (!servo)
        return tl::unexpected(servo.error());
    const auto point = record::tableAt((*history)->file(), run.session().catalog(), *servo, *at);
    if (!point)
        return tl::unexpected(point.error());
    const QString file = values.argument("FILE");
    if (const auto saved = record::saveSnapshot(point->table, file); !saved)
        return tl::unexpected(saved.error());
    Json changedId; // null: it kept its ID
    if (point->changedId)
        changedId = Json::object()
                        .add("id", point->changedId->id)
                        .add("time", point->changedId->at.toString(Qt::ISODateWithMs));
    run.finish(Json::object()
                   .add("servo", *servo)
                   .add("id", point->table.servo.id)
                   .add("time", at->toString(Qt::ISODateWithMs))
                   .add("file", file)
                   .add("snapshot", point->base.number)
                   .add("snapshot_time", point->base.at.toString(Qt::ISODateWithMs))
                   .add("replayed", point->replayed)
                   .add("unknown", point->unknown)
                   .add("temporary", point->temporary)
                   .add("changed_id", std::move(changedId)),
               tableText(*point, file));
    return Exit::Success;
}

base::Result<Exit> runShow(Run& run, const Values& values)
{
    return runHistoryCommand(run, values, show);
}

base::Result<Exit> runSnapshot(Run& run, const Values& values)
{
    return runHistoryCommand(run, values, takeSnapshot);
}

base::Result<Exit> runTable(Run& run, const Values& values)
{
    return runHistoryCommand(run, values, takeTable);
}
} // namespace

Command historyShowCommand()
{
    return {"history show",
            QT_TRANSLATE_NOOP("cli", "show a write with all that was written together with it"),
            {{"WRITE", QT_TRANSLATE_NOOP("cli", "its number in \"history\"")}},
            serverOptions(),
            runShow};
}

Command historyLabelCommand()
{
    return {"history label",
            QT_TRANSLATE_NOOP("cli", "give a servo of the history a name, as servos carry no "
                                     "serial number"),
            {{"SERVO",
              QT_TRANSLATE_NOOP("cli", "its number in \"history --kind servos\", or its label")},
             {"LABEL", QT_TRANSLATE_NOOP("cli", "the name; \"\" takes it away")}},
            {{"--another",
              QT_TRANSLATE_NOOP("cli", "what answers like this from now on is another servo, the "
                                       "one with this label; the past stays with the former")}},
            runLabel};
}

Command historySnapshotCommand()
{
    return {"history snapshot",
            QT_TRANSLATE_NOOP("cli", "take a snapshot out of the history again, as a file for "
                                     "snapshot restore"),
            {{"SNAPSHOT", QT_TRANSLATE_NOOP("cli", "its number in \"history --kind snapshots\"")},
             {"FILE", QT_TRANSLATE_NOOP("cli", "usually NAME.servo.json; replaced if it exists")}},
            serverOptions(),
            runSnapshot};
}

Command historyTableCommand()
{
    return {"history table",
            QT_TRANSLATE_NOOP("cli",
                              "a servo's table as it was at a moment, as a file for snapshot "
                              "restore: the last snapshot before it and the writes since"),
            {{"SERVO",
              QT_TRANSLATE_NOOP("cli", "its number in \"history --kind servos\", or its label")},
             {"TIME", QT_TRANSLATE_NOOP("cli", "2026-11-22T10:30, 10:30, or 90m, 2h, 3d, 1w ago")},
             {"FILE", QT_TRANSLATE_NOOP("cli", "usually NAME.servo.json; replaced if it exists")}},
            serverOptions(),
            runTable};
}
} // namespace cli

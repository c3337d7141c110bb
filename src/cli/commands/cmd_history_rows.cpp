// SPDX-License-Identifier: GPL-3.0-or-later
// Single entries of the history: a write with all its registers, labels, saving a snapshot or a
// table.
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
base::Result<std::unique_ptr<history::History>> requireHistory(Run& run, const Values& values)
{
    auto history = openHistory(run, values);
    if (history && !*history)
        return badArgument(translate("cli", "no history yet"));
    return history;
}

base::Result<std::int64_t> parseNumber(const QString& word)
{
    bool isNumber = false;
    const qint64 number = QString(word).remove(QLatin1Char('#')).toLongLong(&isNumber);
    if (!isNumber || number < 1)
        return badArgument(translate("cli", "\"%1\" is not a valid entry number").arg(word));
    return number;
}

/// All registers that were written together with this one.
base::Result<std::vector<history::HistoryWrite>> together(const history::HistoryLog& log,
                                                          std::int64_t number)
{
    const auto one = log.write(number);
    if (!one)
        return tl::unexpected(one.error());
    history::HistoryFilter filter;
    filter.servo = one->servo;
    filter.from = one->at;
    filter.until = one->at.addMSecs(1);
    filter.limit = 10000;
    auto near = log.writes(filter);
    if (!near)
        return near;
    std::vector<history::HistoryWrite> own;
    for (history::HistoryWrite& write : *near) {
        if (write.intent == one->intent)
            own.insert(own.begin(), std::move(write));
    }
    return own;
}

Json jsonWrite(const history::HistoryWrite& write)
{
    return Json::object()
        .add("number", write.number)
        .add("register", write.key)
        .add("address", write.address)
        .add("old", write.oldRaw)
        .add("new", write.newRaw)
        .add("read_back", write.readBack)
        .add("outcome", write.outcome);
}

/// The properties that all registers of a write share.
Json jsonIntent(const history::HistoryWrite& write)
{
    return Json::object()
        .add("intent", write.intentUuid)
        .add("time", write.at.toString(Qt::ISODateWithMs))
        .add("kind", base::intentKindName(write.kind))
        .add("temporary", write.temporary)
        .add("servo", write.servo)
        .add("id", write.servoId)
        .add("model", write.model)
        .add("label", write.label)
        .add("port", write.port)
        .add("baud", write.baud)
        .add("program", write.program)
        .add("detail", write.detail);
}

QString intentText(const history::HistoryWrite& write)
{
    const QString servo = write.label.isEmpty() ? write.model
                                                : write.model + QStringLiteral(" \"") +
                                                      write.label + QLatin1Char('"');
    return text::intentLabel(write.kind, write.temporary, write.ownDefaults) +
           QStringLiteral(": ") +
           translate("cli", "%1, ID %2, %3, on %4 at %5 baud, by %6")
               .arg(localTime(write.at), QString::number(write.servoId), servo, write.port,
                    QString::number(write.baud), write.program) +
           QLatin1Char('\n');
}

base::Result<Exit> showWrite(Run& run, const Values& values)
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
    history::HistoryProfiles profiles(run.session().catalog());
    if (const auto known = loadProfiles(**history, profiles); !known)
        return tl::unexpected(known.error());
    Table table({translate("cli", "Register"), translate("cli", "Old"), translate("cli", "New"),
                 translate("cli", "Read back"), translate("cli", "Result")});
    table.alignRight({1, 2, 3});
    Json::Array rows;
    for (const history::HistoryWrite& write : *writes) {
        const auto value = [&](const std::optional<std::int64_t>& raw) {
            return raw ? profiles.valueText(write, *raw, text::isUiChinese()) : noValue();
        };
        table.add({write.key, value(write.oldRaw), value(write.newRaw), value(write.readBack),
                   text::writeOutcomeLabel(write.outcome)});
        rows.push_back(jsonWrite(write));
    }
    const history::HistoryWrite& first = writes->front();
    run.finish(jsonIntent(first).add("writes", std::move(rows)), intentText(first) + table.text());
    return Exit::Success;
}

QString renamedText(const history::HistoryServo& servo, bool another)
{
    const QString line =
        another ? translate("cli", "The %1 replying as ID %2 is now servo #%3, \"%4\"")
        : servo.label.isEmpty()
            ? translate("cli", "The %1 with ID %2, servo #%3, no longer has a label")
            : translate("cli", "The %1 with ID %2, servo #%3, now has the label \"%4\"");
    const QString filled = line.arg(servo.identity.model).arg(servo.identity.id).arg(servo.number);
    return line.contains(QLatin1String("%4")) ? filled.arg(servo.label) : filled;
}

base::Result<Exit> runLabel(Run& run, const Values& values)
{
    const auto history = requireHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const history::HistoryLog log = (*history)->log();
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
               renamedText(*now, values.has("--another")) + QLatin1Char('\n'));
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
    if (const auto saved = snapshot::saveSnapshot(*snapshot, file); !saved)
        return tl::unexpected(saved.error());
    const auto count = int(snapshot->registers.size());
    run.finish(Json::object()
                   .add("snapshot", *number)
                   .add("id", snapshot->servo.id)
                   .add("file", file)
                   .add("registers", count),
               translate("cli", "%n register(s) saved to %1", nullptr, count).arg(file) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

QString tableText(const history::TableState& point, const QString& file)
{
    const QString comma = QStringLiteral(", ");
    QStringList lines{
        translate("cli", "%n register(s) saved to %1", nullptr, int(point.table.registers.size()))
            .arg(file),
        translate("cli", "From snapshot %1 taken on %2; written since then: %3")
            .arg(QString::number(qint64(point.base.number)), localTime(point.base.at),
                 point.replayed.isEmpty() ? translate("cli", "nothing")
                                          : point.replayed.join(comma))};
    if (!point.unknown.isEmpty())
        lines << translate("cli",
                           "Saved without a value because the new value was not recorded: %1")
                     .arg(point.unknown.join(comma));
    if (!point.temporary.isEmpty())
        lines << translate("cli", "Temporary writes are not included; for these registers, the "
                                  "table contains the stored values: %1")
                     .arg(point.temporary.join(comma));
    if (point.changedId)
        lines << translate("cli", "The ID was changed to %1 on %2; writes made with the new ID are "
                                  "in the history of the servo with ID %1, not here")
                     .arg(QString::number(point.changedId->id), localTime(point.changedId->at));
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
    const auto point = history::tableAt((*history)->file(), run.session().catalog(), *servo, *at);
    if (!point)
        return tl::unexpected(point.error());
    const QString file = values.argument("FILE");
    if (const auto saved = snapshot::saveSnapshot(point->table, file); !saved)
        return tl::unexpected(saved.error());
    Json changedId; // null: unchanged
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
} // namespace

Command historyShowCommand()
{
    return {"history show",
            QT_TRANSLATE_NOOP("cli", "show a write and everything written together with it"),
            {{"WRITE", QT_TRANSLATE_NOOP("cli", "write number, as listed by \"history\"")}},
            serverOptions(),
            runHistoryCommand<showWrite>};
}

Command historyLabelCommand()
{
    return {"history label",
            QT_TRANSLATE_NOOP("cli", "label a servo in the history (servos have no serial number)"),
            {{"SERVO", QT_TRANSLATE_NOOP(
                           "cli", "servo label, or number as listed by \"history --kind servos\"")},
             {"LABEL", QT_TRANSLATE_NOOP("cli", "new label; \"\" removes it")}},
            {{"--another",
              QT_TRANSLATE_NOOP(
                  "cli",
                  "from now on, treat the servo that replies with this model and ID as a different "
                  "servo, with this label; earlier entries stay with the previous servo")}},
            runLabel};
}

Command historySnapshotCommand()
{
    return {"history snapshot",
            QT_TRANSLATE_NOOP(
                "cli", "save a snapshot from the history as a file for \"snapshot restore\""),
            {{"SNAPSHOT", QT_TRANSLATE_NOOP(
                              "cli", "snapshot number, as listed by \"history --kind snapshots\"")},
             outputFileArgument},
            serverOptions(),
            runHistoryCommand<takeSnapshot>};
}

Command historyTableCommand()
{
    return {
        "history table",
        QT_TRANSLATE_NOOP("cli",
                          "save a servo's memory table as it was at a given time (last snapshot "
                          "plus the writes up to then) to a file for \"snapshot restore\""),
        {{"SERVO", QT_TRANSLATE_NOOP(
                       "cli", "servo label, or number as listed by \"history --kind servos\"")},
         {"TIME",
          QT_TRANSLATE_NOOP(
              "cli", "time: 2026-11-22T10:30, 10:30, or how long ago, such as 90m, 2h, 3d, 1w")},
         outputFileArgument},
        serverOptions(),
        runHistoryCommand<takeTable>};
}
} // namespace cli

// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of the history, and their export.
#include "cli/commands.h"
#include "cli/history_remote.h"
#include "cli/input/arguments.h"
#include "cli/input/history_input.h"
#include "cli/output/table.h"
#include "cli/run.h"
#include "cli/translate.h"
#include "report/sweep_text.h"
#include "text/alarm_text.h"
#include "text/language.h"
#include "text/write_text.h"

namespace cli {
namespace {
using history::HistoryKind;

QString formatTime(const QDateTime& at)
{
    return at.isValid() ? localTime(at) : noValue();
}

QString shown(std::int64_t number)
{
    return QString::number(qint64(number));
}

QString formatOutcome(const history::HistoryWrite& write)
{
    const QString word = text::writeOutcomeLabel(write.outcome);
    return write.isGood() ? word : QStringLiteral("✗ ") + word;
}

Table tableOf(const std::vector<history::HistoryServo>& servos)
{
    Table table({translate("cli", "Servo"), translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "ID"), translate("cli", "Label"), translate("cli", "In use"),
                 translate("cli", "Last write"), translate("cli", "Port")});
    table.alignRight({0, 3});
    for (const history::HistoryServo& servo : servos) {
        const base::ServoIdentity& identity = servo.identity;
        const QString firmware =
            identity.firmwareMajor < 0
                ? QStringLiteral("?")
                : QStringLiteral("%1.%2").arg(identity.firmwareMajor).arg(identity.firmwareMinor);
        table.add({shown(servo.number), identity.model, firmware, QString::number(identity.id),
                   servo.label, servo.current ? QStringLiteral("●") : QString(),
                   formatTime(servo.lastWrite), identity.port});
    }
    return table;
}

Table tableOf(const std::vector<history::HistoryWrite>& writes,
              const history::HistoryProfiles& profiles)
{
    Table table({translate("cli", "Write"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Label"), translate("cli", "Register"),
                 translate("cli", "Old"), translate("cli", "New"), translate("cli", "Result"),
                 translate("cli", "Type"), translate("cli", "Port")});
    table.alignRight({0, 2, 6, 7});
    for (const history::HistoryWrite& write : writes)
        table.add({shown(write.number), formatTime(write.at), QString::number(write.servoId),
                   write.model, write.label, write.key,
                   profiles.valueText(write, write.oldRaw, text::isUiChinese()),
                   write.newRaw ? profiles.valueText(write, *write.newRaw, text::isUiChinese())
                                : noValue(),
                   formatOutcome(write),
                   text::intentLabel(write.kind, write.temporary, write.ownDefaults), write.port});
    return table;
}

Table tableOf(const std::vector<history::HistorySnapshot>& snapshots)
{
    Table table({translate("cli", "Snapshot"), translate("cli", "Time"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Label"), translate("cli", "Note"),
                 translate("cli", "Reason"), translate("cli", "Registers"),
                 translate("cli", "File")});
    table.alignRight({0, 2, 7});
    for (const history::HistorySnapshot& snapshot : snapshots)
        table.add({shown(snapshot.number), formatTime(snapshot.at),
                   QString::number(snapshot.servoId), snapshot.model,
                   QString(snapshot.label).simplified(), QString(snapshot.note).simplified(),
                   snapshot.reason == history::SnapshotReason::Automatic
                       ? translate("cli", "before a change")
                       : translate("cli", "manual"),
                   QString::number(snapshot.registers), snapshot.file});
    return table;
}

Table tableOf(const std::vector<history::HistoryAlarm>& alarms)
{
    Table table({translate("cli", "Alarm"), translate("cli", "Time"), translate("cli", "Cleared"),
                 translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Label"),
                 translate("cli", "Type")});
    table.alignRight({0, 3});
    for (const history::HistoryAlarm& alarm : alarms)
        table.add({shown(alarm.number), formatTime(alarm.at), formatTime(alarm.clearedAt),
                   QString::number(alarm.servoId), alarm.model, alarm.label,
                   text::alarmLabel(alarm.key)});
    return table;
}

Table tableOf(const std::vector<history::HistoryRecording>& recordings)
{
    Table table({translate("cli", "Recording"), translate("cli", "Time"),
                 translate("cli", "Duration"), translate("cli", "ID"), translate("cli", "Rows"),
                 translate("cli", "File")});
    table.alignRight({0, 2, 4});
    for (const history::HistoryRecording& recording : recordings) {
        QStringList ids;
        for (const auto& servo : recording.servos)
            ids.append(QString::number(servo.id));
        table.add({shown(recording.number), formatTime(recording.at),
                   QStringLiteral("%1 s").arg(double(recording.length.count()) / 1e6, 0, 'f', 1),
                   text::joinItems(ids), QString::number(recording.rows), recording.file});
    }
    return table;
}

Table tableOf(const std::vector<history::TestRun>& runs)
{
    Table table({translate("cli", "Run"), translate("cli", "Time"), translate("cli", "Test"),
                 translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Label"),
                 translate("cli", "Verdict"), translate("cli", "Note")});
    table.alignRight({0, 3});
    for (const history::TestRun& run : runs) {
        for (const history::TestServo& servo : run.servos)
            table.add({shown(run.number), formatTime(run.at), run.kind, QString::number(servo.id),
                       servo.model, servo.label,
                       report::gradeSign(servo.verdict) + QLatin1Char(' ') +
                           text::localized(report::gradeLabel(servo.verdict)),
                       QString(run.note).simplified()});
    }
    return table;
}

Json jsonOf(const QVariant& value)
{
    switch (value.typeId()) {
    case QMetaType::QDateTime:
        return value.toDateTime().isValid() ? Json(value.toDateTime().toString(Qt::ISODateWithMs))
                                            : Json();
    case QMetaType::QStringList:
        return value.toStringList();
    case QMetaType::Bool:
        return value.toBool();
    case QMetaType::Double:
        return value.toDouble();
    case QMetaType::Int:
    case QMetaType::LongLong:
        return std::int64_t(value.toLongLong());
    default:
        return value.isNull() && value.typeId() != QMetaType::QString ? Json()
                                                                      : Json(value.toString());
    }
}

/// The same columns as in an exported file.
template <typename Row>
base::Result<Exit> showRows(Run& run, HistoryKind kind, const base::Result<std::vector<Row>>& rows,
                            const auto&... meaning)
{
    if (!rows)
        return tl::unexpected(rows.error());
    Json::Array list;
    for (const Row& row : *rows) {
        Json::Object object;
        for (const auto& [name, value] : history::fieldsOf(row))
            object.emplace_back(QLatin1String(name), jsonOf(value));
        list.push_back(std::move(object));
    }
    QString text = rows->empty()
                       ? translate("cli", "No matching entries in the history.") + QLatin1Char('\n')
                       : tableOf(*rows, meaning...).text();
    if (kind == HistoryKind::Servos && !rows->empty())
        text += translate("cli", "Servos have no serial number, so servos with the same model, "
                                 "firmware, ID and label are listed as one.") +
                QLatin1Char('\n');
    run.finish(
        Json::object().add(history::historyKindName(kind).toLatin1().constData(), std::move(list)),
        text);
    return Exit::Success;
}

base::Result<HistoryKind> kindOf(const Values& values)
{
    const QString word = values.option("--kind").value_or(QStringLiteral("writes"));
    const auto kind = history::historyKindFromName(word);
    if (!kind)
        return badArgument(translate("cli", "--kind must be writes, snapshots, alarms, recordings, "
                                            "runs, servos or (on a server only) benches"));
    return *kind;
}

template <typename Row>
base::Result<std::vector<Row>> nothing()
{
    return std::vector<Row>();
}

base::Result<Exit> showWrites(Run& run, const history::History* history,
                              const history::HistoryFilter& filter)
{
    history::HistoryProfiles profiles(run.session().catalog());
    if (history == nullptr)
        return showRows(run, HistoryKind::Writes, nothing<history::HistoryWrite>(), profiles);
    if (const auto known = loadProfiles(*history, profiles); !known)
        return tl::unexpected(known.error());
    return showRows(run, HistoryKind::Writes, history->log().writes(filter), profiles);
}

base::Result<Exit> show(Run& run, const history::History* history, HistoryKind kind,
                        const history::HistoryFilter& filter)
{
    switch (kind) {
    case HistoryKind::Servos:
        return showRows(run, kind,
                        history ? history->log().servos(filter) : nothing<history::HistoryServo>());
    case HistoryKind::Writes:
        return showWrites(run, history, filter);
    case HistoryKind::Snapshots:
        return showRows(run, kind,
                        history ? history->log().snapshots(filter)
                                : nothing<history::HistorySnapshot>());
    case HistoryKind::Alarms:
        return showRows(run, kind,
                        history ? history->log().alarms(filter) : nothing<history::HistoryAlarm>());
    case HistoryKind::Recordings:
        return showRows(run, kind,
                        history ? history->log().recordings(filter)
                                : nothing<history::HistoryRecording>());
    case HistoryKind::Runs:
        break;
    }
    if (history == nullptr)
        return showRows(run, kind, nothing<history::TestRun>());
    auto runs = history::runFilterOf(*history, filter);
    if (!runs)
        return tl::unexpected(runs.error());
    runs->limit = filter.limit;
    return showRows(run, kind, history->runs(*runs));
}

base::Result<Exit> exportTo(Run& run, const history::History& history, HistoryKind kind,
                            const history::HistoryFilter& filter, const QString& file, bool csv)
{
    const auto rows = csv ? history::exportHistoryCsv(history, kind, filter, file)
                          : history::exportHistoryJson(history, {kind}, filter, file);
    if (!rows)
        return tl::unexpected(rows.error());
    run.finish(Json::object().add("file", file).add("rows", *rows),
               translate("cli", "%n row(s) written to %1", nullptr, int(*rows)).arg(file) +
                   QLatin1Char('\n'));
    return Exit::Success;
}

base::Result<Exit> showBenches(Run& run, const Values& values)
{
    const auto benches = listBenches(run, values);
    if (!benches)
        return tl::unexpected(benches.error());
    Table table(
        {translate("cli", "Bench"), translate("cli", "Last sent"), translate("cli", "Writes")});
    table.alignRight({2});
    Json::Array list;
    for (const history::HistoryBench& bench : *benches) {
        table.add({bench.name, formatTime(bench.sent), shown(bench.writes)});
        list.push_back(Json::object()
                           .add("name", bench.name)
                           .add("uuid", bench.uuid)
                           .add("sent", bench.sent.toString(Qt::ISODateWithMs))
                           .add("writes", bench.writes));
    }
    run.finish(Json::object().add("benches", std::move(list)), table.text());
    return Exit::Success;
}

base::Result<Exit> list(Run& run, const Values& values)
{
    if (values.option("--kind") == QStringLiteral("benches"))
        return showBenches(run, values);
    const auto kind = kindOf(values);
    if (!kind)
        return tl::unexpected(kind.error());
    const auto csv = values.option("--csv");
    const auto json = values.option("--export");
    if (csv && json)
        return badArgument(translate("cli", "use either --csv or --export, not both"));
    const auto history = openHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const auto filter = historyFilter(history->get(), values);
    if (!filter)
        return tl::unexpected(filter.error());
    if (!csv && !json)
        return show(run, history->get(), *kind, *filter);
    if (!*history)
        return badArgument(translate("cli", "no history yet"));
    return exportTo(run, **history, *kind, *filter, csv ? *csv : *json, csv.has_value());
}
} // namespace

Command historyCommand()
{
    std::vector<Option> options{
        {"--kind",
         QT_TRANSLATE_NOOP("cli", "kind of entries: writes (default), snapshots, alarms, "
                                  "recordings, runs, servos or (on a server only) benches"),
         "KIND"}};
    for (const Option& option : historyOptions())
        options.push_back(option);
    for (const Option& option : serverOptions())
        options.push_back(option);
    options.push_back({"--csv",
                       QT_TRANSLATE_NOOP("cli", "write all matching entries to a CSV file instead "
                                                "(for other programs; without a byte order mark)"),
                       "FILE"});
    options.push_back(
        {"--export", QT_TRANSLATE_NOOP("cli", "write all matching entries to a JSON file instead"),
         "FILE"});
    return {
        "history",
        QT_TRANSLATE_NOOP(
            "cli",
            "list writes, snapshots, alarms, recordings and tests of servos; no port is needed"),
        {},
        options,
        runHistoryCommand<list>};
}
} // namespace cli

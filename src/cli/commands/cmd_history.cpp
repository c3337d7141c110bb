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
using record::HistoryKind;

QString formatTime(const QDateTime& at)
{
    return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"))
                        : QStringLiteral("–");
}

QString shown(std::int64_t number)
{
    return QString::number(qint64(number));
}

QString formatOutcome(const record::HistoryWrite& write)
{
    const QString word = text::writeOutcomeLabel(write.outcome);
    return write.isGood() ? word : QStringLiteral("✗ ") + word;
}

Table tableOf(const std::vector<record::HistoryServo>& servos)
{
    Table table({translate("cli", "Servo"), translate("cli", "Model"), translate("cli", "Firmware"),
                 translate("cli", "ID"), translate("cli", "Label"), translate("cli", "Now"),
                 translate("cli", "Last write"), translate("cli", "Port")});
    table.alignRight({0, 3});
    for (const record::HistoryServo& servo : servos) {
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

Table tableOf(const std::vector<record::HistoryWrite>& writes,
              const record::HistoryProfiles& profiles)
{
    Table table({translate("cli", "Write"), translate("cli", "When"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Label"), translate("cli", "Register"),
                 translate("cli", "Old"), translate("cli", "New"), translate("cli", "Outcome"),
                 translate("cli", "Kind"), translate("cli", "Port")});
    table.alignRight({0, 2, 6, 7});
    for (const record::HistoryWrite& write : writes)
        table.add({shown(write.number), formatTime(write.at), QString::number(write.servoId),
                   write.model, write.label, write.key,
                   profiles.valueText(write, write.oldRaw, text::isUiChinese()),
                   write.newRaw ? profiles.valueText(write, *write.newRaw, text::isUiChinese())
                                : QStringLiteral("–"),
                   formatOutcome(write),
                   text::intentLabel(write.kind, write.temporary, write.ownDefaults), write.port});
    return table;
}

Table tableOf(const std::vector<record::HistorySnapshot>& snapshots)
{
    Table table({translate("cli", "Snapshot"), translate("cli", "When"), translate("cli", "ID"),
                 translate("cli", "Model"), translate("cli", "Label"), translate("cli", "Note"),
                 translate("cli", "Taken"), translate("cli", "Registers"),
                 translate("cli", "File")});
    table.alignRight({0, 2, 7});
    for (const record::HistorySnapshot& snapshot : snapshots)
        table.add({shown(snapshot.number), formatTime(snapshot.at),
                   QString::number(snapshot.servoId), snapshot.model,
                   QString(snapshot.label).simplified(), QString(snapshot.note).simplified(),
                   snapshot.reason == record::SnapshotReason::Automatic
                       ? translate("cli", "before a change")
                       : translate("cli", "on request"),
                   QString::number(snapshot.registers), snapshot.file});
    return table;
}

Table tableOf(const std::vector<record::HistoryAlarm>& alarms)
{
    Table table({translate("cli", "Alarm"), translate("cli", "When"), translate("cli", "Gone"),
                 translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Label"),
                 translate("cli", "What")});
    table.alignRight({0, 3});
    for (const record::HistoryAlarm& alarm : alarms)
        table.add({shown(alarm.number), formatTime(alarm.at), formatTime(alarm.clearedAt),
                   QString::number(alarm.servoId), alarm.model, alarm.label,
                   text::alarmLabel(alarm.key)});
    return table;
}

Table tableOf(const std::vector<record::HistoryRecording>& recordings)
{
    Table table({translate("cli", "Recording"), translate("cli", "When"),
                 translate("cli", "Length"), translate("cli", "ID"), translate("cli", "Readings"),
                 translate("cli", "File")});
    table.alignRight({0, 2, 4});
    for (const record::HistoryRecording& recording : recordings) {
        QStringList ids;
        for (const auto& servo : recording.servos)
            ids.append(QString::number(servo.id));
        table.add({shown(recording.number), formatTime(recording.at),
                   QStringLiteral("%1 s").arg(double(recording.length.count()) / 1e6, 0, 'f', 1),
                   ids.join(QStringLiteral(", ")), QString::number(recording.rows),
                   recording.file});
    }
    return table;
}

Table tableOf(const std::vector<record::TestRun>& runs)
{
    Table table({translate("cli", "Run"), translate("cli", "When"), translate("cli", "Test"),
                 translate("cli", "ID"), translate("cli", "Model"), translate("cli", "Label"),
                 translate("cli", "Verdict"), translate("cli", "Note")});
    table.alignRight({0, 3});
    for (const record::TestRun& run : runs) {
        for (const record::TestServo& servo : run.servos)
            table.add({shown(run.number), formatTime(run.at), run.kind, QString::number(servo.id),
                       servo.model, servo.label,
                       report::gradeSign(servo.verdict) + QLatin1Char(' ') +
                           report::gradeLabel(servo.verdict).in(text::isUiChinese()),
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
    const QStringList columns = record::historyColumns(kind);
    Json::Array list;
    for (const Row& row : *rows) {
        const QVariantList values = record::valuesOf(row);
        Json::Object object;
        for (qsizetype i = 0; i < columns.size(); ++i)
            object.emplace_back(columns[i], jsonOf(values.value(i)));
        list.push_back(std::move(object));
    }
    QString text = rows->empty()
                       ? translate("cli", "Nothing in the history fits.") + QLatin1Char('\n')
                       : tableOf(*rows, meaning...).text();
    if (kind == HistoryKind::Servos && !rows->empty())
        text +=
            translate("cli", "Servos carry no serial number: those alike in model, firmware, ID "
                             "and label are one here.") +
            QLatin1Char('\n');
    run.finish(
        Json::object().add(record::historyKindName(kind).toLatin1().constData(), std::move(list)),
        text);
    return Exit::Success;
}

base::Result<HistoryKind> kindOf(const Values& values)
{
    const QString word = values.option("--kind").value_or(QStringLiteral("writes"));
    const auto kind = record::historyKindFromName(word);
    if (!kind)
        return badArgument(translate("cli",
                                     "--kind is writes, snapshots, alarms, recordings, runs, "
                                     "servos or, of a server, benches"));
    return *kind;
}

template <typename Row>
base::Result<std::vector<Row>> nothing()
{
    return std::vector<Row>();
}

base::Result<Exit> showWrites(Run& run, const record::History* history,
                              const record::HistoryFilter& filter)
{
    record::HistoryProfiles profiles(run.session().catalog());
    if (history == nullptr)
        return showRows(run, HistoryKind::Writes, nothing<record::HistoryWrite>(), profiles);
    if (const auto known = loadProfiles(*history, profiles); !known)
        return tl::unexpected(known.error());
    return showRows(run, HistoryKind::Writes, history->log().writes(filter), profiles);
}

base::Result<Exit> show(Run& run, const record::History* history, HistoryKind kind,
                        const record::HistoryFilter& filter)
{
    switch (kind) {
    case HistoryKind::Servos:
        return showRows(run, kind,
                        history ? history->log().servos(filter) : nothing<record::HistoryServo>());
    case HistoryKind::Writes:
        return showWrites(run, history, filter);
    case HistoryKind::Snapshots:
        return showRows(run, kind,
                        history ? history->log().snapshots(filter)
                                : nothing<record::HistorySnapshot>());
    case HistoryKind::Alarms:
        return showRows(run, kind,
                        history ? history->log().alarms(filter) : nothing<record::HistoryAlarm>());
    case HistoryKind::Recordings:
        return showRows(run, kind,
                        history ? history->log().recordings(filter)
                                : nothing<record::HistoryRecording>());
    case HistoryKind::Runs:
        break;
    }
    if (history == nullptr)
        return showRows(run, kind, nothing<record::TestRun>());
    auto runs = record::runFilterOf(*history, filter);
    if (!runs)
        return tl::unexpected(runs.error());
    runs->limit = filter.limit;
    return showRows(run, kind, history->runs(*runs));
}

base::Result<Exit> exportTo(Run& run, const record::History& history, HistoryKind kind,
                            const record::HistoryFilter& filter, const QString& file, bool csv)
{
    const auto rows = csv ? record::exportHistoryCsv(history, kind, filter, file)
                          : record::exportHistoryJson(history, {kind}, filter, file);
    if (!rows)
        return tl::unexpected(rows.error());
    run.finish(Json::object().add("file", file).add("rows", *rows),
               translate("cli", "Rows written to %1: %2").arg(file).arg(qint64(*rows)) +
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
    for (const record::HistoryBench& bench : *benches) {
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
        return badArgument(translate("cli", "give --csv or --export, not both"));
    const auto history = openHistory(run, values);
    if (!history)
        return tl::unexpected(history.error());
    const auto filter = historyFilter(history->get(), values);
    if (!filter)
        return tl::unexpected(filter.error());
    if (!csv && !json)
        return show(run, history->get(), *kind, *filter);
    if (!*history)
        return badArgument(translate("cli", "there is no history yet"));
    return exportTo(run, **history, *kind, *filter, csv ? *csv : *json, csv.has_value());
}

base::Result<Exit> runList(Run& run, const Values& values)
{
    return runHistoryCommand(run, values, list);
}
} // namespace

Command historyCommand()
{
    std::vector<Option> options{
        {"--kind",
         QT_TRANSLATE_NOOP("cli", "writes (usual), snapshots, alarms, recordings, runs, servos; "
                                  "of a server also benches"),
         "KIND"}};
    for (const Option& option : historyOptions())
        options.push_back(option);
    for (const Option& option : serverOptions())
        options.push_back(option);
    options.push_back(
        {"--csv", QT_TRANSLATE_NOOP("cli", "all that fits to a CSV file instead"), "FILE"});
    options.push_back(
        {"--export", QT_TRANSLATE_NOOP("cli", "all that fits to a JSON file instead"), "FILE"});
    return {"history",
            QT_TRANSLATE_NOOP("cli", "list what was written to servos and happened to them; needs "
                                     "no port"),
            {},
            options,
            runList};
}
} // namespace cli

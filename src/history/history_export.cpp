// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_export.h"

#include "base/enum_names.h"
#include "files/csv_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace history {
namespace {
const QString exportOperation = QStringLiteral("export");
constexpr int pageSize = 2000;

constexpr base::EnumName<HistoryKind> kindNames[]{
    {HistoryKind::Servos, "servos"},         {HistoryKind::Writes, "writes"},
    {HistoryKind::Snapshots, "snapshots"},   {HistoryKind::Alarms, "alarms"},
    {HistoryKind::Recordings, "recordings"}, {HistoryKind::Runs, "runs"},
};

QVariant number(std::int64_t value)
{
    return QVariant(qint64(value));
}

QVariant milliseconds(base::Duration length)
{
    return double(length.count()) / 1000;
}

QString versionOf(int high, int low)
{
    return high < 0 || low < 0 ? QString() : QStringLiteral("%1.%2").arg(high).arg(low);
}

template <typename Servo>
QStringList idsOf(const std::vector<Servo>& servos)
{
    QStringList ids;
    for (const Servo& servo : servos)
        ids.append(QString::number(servo.id));
    return ids;
}

template <typename Servo>
QStringList textsOf(const std::vector<Servo>& servos, QString Servo::*member)
{
    QStringList texts;
    for (const Servo& servo : servos)
        texts.append(servo.*member);
    return texts;
}

QString timeText(const QDateTime& at)
{
    return at.isValid() ? at.toUTC().toString(Qt::ISODateWithMs) : QString();
}

QString cellOf(const QVariant& value)
{
    switch (value.typeId()) {
    case QMetaType::QDateTime:
        return timeText(value.toDateTime());
    case QMetaType::QStringList:
        return value.toStringList().join(QStringLiteral("; "));
    case QMetaType::Bool:
        return value.toBool() ? QStringLiteral("1") : QStringLiteral("0");
    default:
        return value.toString();
    }
}

QJsonValue jsonOf(const QVariant& value)
{
    if (value.typeId() == QMetaType::QDateTime)
        return value.toDateTime().isValid() ? QJsonValue(timeText(value.toDateTime()))
                                            : QJsonValue();
    return QJsonValue::fromVariant(value);
}

using RowSink = std::function<bool(const HistoryFields& row)>;

/// Gives all pages of a list to the sink, until the sink returns false.
template <typename Row>
base::Result<std::int64_t>
forEachPage(HistoryFilter filter, const RowSink& sink,
            const std::function<base::Result<std::vector<Row>>(const HistoryFilter&)>& page)
{
    filter.limit = pageSize;
    filter.after.reset();
    std::int64_t count = 0;
    for (;;) {
        const auto rows = page(filter);
        if (!rows)
            return tl::unexpected(rows.error());
        for (const Row& row : *rows) {
            ++count;
            if (!sink(fieldsOf(row)))
                return count;
        }
        if (rows->size() < std::size_t(pageSize))
            return count;
        filter.after = PageCursor{rows->back().at, rows->back().number};
    }
}

template <typename Row>
base::Result<std::int64_t> all(const base::Result<std::vector<Row>>& rows, const RowSink& sink)
{
    if (!rows)
        return tl::unexpected(rows.error());
    for (const Row& row : *rows) {
        if (!sink(fieldsOf(row)))
            break;
    }
    return std::int64_t(rows->size());
}

base::Result<std::int64_t> forEachRow(const History& history, HistoryKind kind,
                                      const HistoryFilter& filter, const RowSink& sink)
{
    const HistoryLog log = history.log();
    switch (kind) {
    case HistoryKind::Servos:
        return all(log.servos(filter), sink);
    case HistoryKind::Writes:
        return forEachPage<HistoryWrite>(filter, sink,
                                         [&](const HistoryFilter& f) { return log.writes(f); });
    case HistoryKind::Snapshots:
        return forEachPage<HistorySnapshot>(
            filter, sink, [&](const HistoryFilter& f) { return log.snapshots(f); });
    case HistoryKind::Alarms:
        return forEachPage<HistoryAlarm>(filter, sink,
                                         [&](const HistoryFilter& f) { return log.alarms(f); });
    case HistoryKind::Recordings:
        return forEachPage<HistoryRecording>(
            filter, sink, [&](const HistoryFilter& f) { return log.recordings(f); });
    case HistoryKind::Runs:
        break;
    }
    const auto runs = runFilterOf(history, filter);
    return runs ? all(history.runs(*runs), sink)
                : base::Result<std::int64_t>(tl::unexpected(runs.error()));
}

/// Rows are short; writing larger pieces is faster.
class BufferedSink {
public:
    explicit BufferedSink(const files::TextSink& sink)
        : m_sink(sink)
    {}

    bool put(const QByteArray& text)
    {
        constexpr qsizetype enough = 1 << 18;
        m_text += text;
        return m_text.size() < enough || flush();
    }
    bool flush()
    {
        const bool fine = m_sink(m_text);
        m_text.clear();
        return fine;
    }

private:
    const files::TextSink& m_sink;
    QByteArray m_text;
};

/// The file is replaced only if all rows could be read.
base::Result<std::int64_t>
save(const QString& path, const std::function<base::Result<std::int64_t>(BufferedSink&)>& write)
{
    std::int64_t count = 0;
    const auto saved = files::saveTextFileIfValid(
        exportOperation,
        [&](const files::TextSink& sink) -> base::Result<void> {
            BufferedSink out(sink);
            const auto written = write(out);
            if (!written)
                return tl::unexpected(written.error());
            out.flush();
            count = *written;
            return {};
        },
        path);
    if (!saved)
        return tl::unexpected(saved.error());
    return count;
}

QByteArray jsonLine(const HistoryFields& row)
{
    QJsonObject object;
    for (const auto& [name, value] : row)
        object.insert(QLatin1String(name), jsonOf(value));
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

/// The field names of an empty row.
QStringList columnsOf(HistoryKind kind)
{
    const auto names = [](const HistoryFields& row) {
        QStringList columns;
        for (const HistoryField& field : row)
            columns.append(QLatin1String(field.name));
        return columns;
    };
    switch (kind) {
    case HistoryKind::Servos:
        return names(fieldsOf(HistoryServo()));
    case HistoryKind::Writes:
        return names(fieldsOf(HistoryWrite()));
    case HistoryKind::Snapshots:
        return names(fieldsOf(HistorySnapshot()));
    case HistoryKind::Alarms:
        return names(fieldsOf(HistoryAlarm()));
    case HistoryKind::Recordings:
        return names(fieldsOf(HistoryRecording()));
    case HistoryKind::Runs:
        break;
    }
    return names(fieldsOf(TestRun()));
}
} // namespace

QString historyKindName(HistoryKind kind)
{
    return base::nameOf(kindNames, kind);
}

std::optional<HistoryKind> historyKindFromName(const QString& name)
{
    return base::valueOf(kindNames, name);
}

HistoryFields fieldsOf(const HistoryServo& servo)
{
    const base::ServoIdentity& identity = servo.identity;
    return {
        {"number", number(servo.number)},
        {"uuid", servo.uuid},
        {"model", identity.model},
        {"protocol", base::protocolName(identity.protocol)},
        {"model_id", versionOf(identity.modelMajor, identity.modelMinor)},
        {"firmware", versionOf(identity.firmwareMajor, identity.firmwareMinor)},
        {"map", identity.map},
        {"id", identity.id},
        {"label", servo.label},
        {"current", servo.current},
        {"last_write", servo.lastWrite},
        {"port", identity.port},
        {"baud", identity.baud},
    };
}

HistoryFields fieldsOf(const HistoryWrite& write)
{
    return {
        {"number", number(write.number)},
        {"intent", write.intentUuid},
        {"time", write.at},
        {"servo", number(write.servo)},
        {"id", write.servoId},
        {"model", write.model},
        {"label", write.label},
        {"kind", base::intentKindName(write.kind)},
        {"register", write.key},
        {"address", write.address},
        {"old", number(write.oldRaw)},
        {"new", write.newRaw ? number(*write.newRaw) : QVariant()},
        {"read_back", write.readBack ? number(*write.readBack) : QVariant()},
        {"outcome", write.outcome},
        {"temporary", write.temporary},
        {"port", write.port},
        {"baud", write.baud},
        {"program", write.program},
        {"detail", write.detail},
    };
}

HistoryFields fieldsOf(const HistorySnapshot& snapshot)
{
    return {
        {"number", number(snapshot.number)},
        {"uuid", snapshot.uuid},
        {"time", snapshot.at},
        {"servo", number(snapshot.servo)},
        {"id", snapshot.servoId},
        {"model", snapshot.model},
        {"firmware", snapshot.firmware},
        {"label", snapshot.label},
        {"note", snapshot.note},
        {"reason", snapshotReasonName(snapshot.reason)},
        {"registers", snapshot.registers},
        {"file", snapshot.file},
        {"port", snapshot.port},
        {"baud", snapshot.baud},
        {"program", snapshot.program},
    };
}

HistoryFields fieldsOf(const HistoryAlarm& alarm)
{
    return {
        {"number", number(alarm.number)}, {"uuid", alarm.uuid},           {"time", alarm.at},
        {"went", alarm.clearedAt},        {"servo", number(alarm.servo)}, {"id", alarm.servoId},
        {"model", alarm.model},           {"label", alarm.label},         {"alarm", alarm.key},
        {"derived", alarm.derived},       {"port", alarm.port},
    };
}

HistoryFields fieldsOf(const HistoryRecording& recording)
{
    return {
        {"number", number(recording.number)},
        {"uuid", recording.uuid},
        {"time", recording.at},
        {"length_ms", milliseconds(recording.length)},
        {"file", recording.file},
        {"readings", recording.rows},
        {"port", recording.port},
        {"simulated", recording.simulated},
        {"ids", idsOf(recording.servos)},
        {"models", textsOf(recording.servos, &HistoryRecording::Servo::model)},
        {"labels", textsOf(recording.servos, &HistoryRecording::Servo::label)},
    };
}

HistoryFields fieldsOf(const TestRun& run)
{
    return {
        {"number", number(run.number)},
        {"uuid", run.uuid},
        {"time", run.at},
        {"kind", run.kind},
        {"verdict", results::gradeName(run.verdict)},
        {"end", run.end},
        {"ids", idsOf(run.servos)},
        {"models", textsOf(run.servos, &TestServo::model)},
        {"labels", textsOf(run.servos, &TestServo::label)},
        {"operator", run.operatorName},
        {"note", run.note},
        {"length_ms", milliseconds(run.length)},
        {"port", run.port},
        {"simulated", run.simulated},
        {"program", run.program},
        {"files", run.files},
    };
}

base::Result<RunFilter> runFilterOf(const History& history, const HistoryFilter& filter)
{
    RunFilter runs;
    runs.model = filter.model;
    runs.id = filter.id;
    runs.from = filter.from;
    runs.until = filter.until;
    runs.text = filter.label;
    if (filter.servo) {
        const auto servo = history.log().servo(*filter.servo);
        if (!servo)
            return tl::unexpected(servo.error());
        runs.id = servo->identity.id;
        runs.model = servo->identity.model;
        runs.firmware = versionOf(servo->identity.firmwareMajor, servo->identity.firmwareMinor);
    }
    return runs;
}

base::Result<std::int64_t> exportHistoryCsv(const History& history, HistoryKind kind,
                                            const HistoryFilter& filter, const QString& path,
                                            files::CsvReader reader)
{
    return save(path, [&](BufferedSink& out) {
        out.put(files::csvStart(reader) + files::csvLine(columnsOf(kind)));
        return forEachRow(history, kind, filter, [&](const HistoryFields& row) {
            QStringList cells;
            for (const HistoryField& field : row)
                cells.append(cellOf(field.value));
            return out.put(files::csvLine(cells));
        });
    });
}

base::Result<std::int64_t> exportHistoryJson(const History& history,
                                             const std::vector<HistoryKind>& kinds,
                                             const HistoryFilter& filter, const QString& path)
{
    return save(path, [&](BufferedSink& out) -> base::Result<std::int64_t> {
        std::int64_t count = 0;
        out.put("{\"format\": \"servodesk-history\", \"version\": 1");
        for (const HistoryKind kind : kinds) {
            out.put(",\n\"" + historyKindName(kind).toLatin1() + "\": [");
            bool first = true;
            const auto rows = forEachRow(history, kind, filter, [&](const HistoryFields& row) {
                const bool put = out.put((first ? "\n" : ",\n") + jsonLine(row));
                first = false;
                return put;
            });
            if (!rows)
                return rows;
            count += *rows;
            out.put("]");
        }
        out.put("}\n");
        return count;
    });
}
} // namespace history

// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_export.h"

#include "files/csv_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace record {
namespace {
const QString exportOperation = QStringLiteral("export");
constexpr int pageSize = 2000;

struct KindName {
    HistoryKind kind;
    QLatin1String name;
    const char* columns;
};

constexpr std::array kindNames{
    KindName{HistoryKind::Servos, QLatin1String("servos"),
             "number uuid model protocol model_id firmware map id label current last_write port "
             "baud"},
    KindName{HistoryKind::Writes, QLatin1String("writes"),
             "number intent time servo id model label kind register address old new read_back "
             "outcome temporary port baud program detail"},
    KindName{HistoryKind::Snapshots, QLatin1String("snapshots"),
             "number uuid time servo id model firmware label note reason registers file port baud "
             "program"},
    KindName{HistoryKind::Alarms, QLatin1String("alarms"),
             "number uuid time went servo id model label alarm derived port"},
    KindName{HistoryKind::Recordings, QLatin1String("recordings"),
             "number uuid time length_ms file readings port simulated ids models labels"},
    KindName{HistoryKind::Runs, QLatin1String("runs"),
             "number uuid time kind verdict end ids models labels operator note length_ms port "
             "simulated program files"},
};

const KindName& nameEntryOf(HistoryKind kind)
{
    return *std::find_if(kindNames.begin(), kindNames.end(),
                         [&](const KindName& entry) { return entry.kind == kind; });
}

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

using RowSink = std::function<bool(const QVariantList& row)>;

/// Hands over all pages of a list; false: the sink has had enough.
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
            if (!sink(valuesOf(row)))
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
        if (!sink(valuesOf(row)))
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

/// Rows are short; the disk is given more at a time.
class BufferedSink {
public:
    explicit BufferedSink(const TextSink& sink)
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
    const TextSink& m_sink;
    QByteArray m_text;
};

/// Nothing takes the file's place unless all of it could be read.
base::Result<std::int64_t>
save(const QString& path, const std::function<base::Result<std::int64_t>(BufferedSink&)>& write)
{
    std::int64_t count = 0;
    const auto saved = saveTextFileIfValid(
        exportOperation,
        [&](const TextSink& sink) -> base::Result<void> {
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

QByteArray jsonLine(const QStringList& columns, const QVariantList& row)
{
    QJsonObject object;
    for (qsizetype i = 0; i < columns.size(); ++i)
        object.insert(columns[i], jsonOf(row.value(i)));
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}
} // namespace

QString historyKindName(HistoryKind kind)
{
    return nameEntryOf(kind).name;
}

std::optional<HistoryKind> historyKindFromName(const QString& name)
{
    for (const KindName& entry : kindNames) {
        if (name == entry.name)
            return entry.kind;
    }
    return std::nullopt;
}

QStringList historyColumns(HistoryKind kind)
{
    return QString::fromLatin1(nameEntryOf(kind).columns).split(QLatin1Char(' '));
}

QVariantList valuesOf(const HistoryServo& servo)
{
    const base::ServoIdentity& identity = servo.identity;
    return {number(servo.number),
            servo.uuid,
            identity.model,
            base::protocolName(identity.protocol),
            versionOf(identity.modelMajor, identity.modelMinor),
            versionOf(identity.firmwareMajor, identity.firmwareMinor),
            identity.map,
            identity.id,
            servo.label,
            servo.current,
            servo.lastWrite,
            identity.port,
            identity.baud};
}

QVariantList valuesOf(const HistoryWrite& write)
{
    return {number(write.number),
            write.intentUuid,
            write.at,
            number(write.servo),
            write.servoId,
            write.model,
            write.label,
            base::intentKindName(write.kind),
            write.key,
            write.address,
            number(write.oldRaw),
            write.newRaw ? number(*write.newRaw) : QVariant(),
            write.readBack ? number(*write.readBack) : QVariant(),
            write.outcome,
            write.temporary,
            write.port,
            write.baud,
            write.program,
            write.detail};
}

QVariantList valuesOf(const HistorySnapshot& snapshot)
{
    return {number(snapshot.number),
            snapshot.uuid,
            snapshot.at,
            number(snapshot.servo),
            snapshot.servoId,
            snapshot.model,
            snapshot.firmware,
            snapshot.label,
            snapshot.note,
            snapshotReasonName(snapshot.reason),
            snapshot.registers,
            snapshot.file,
            snapshot.port,
            snapshot.baud,
            snapshot.program};
}

QVariantList valuesOf(const HistoryAlarm& alarm)
{
    return {number(alarm.number), alarm.uuid,          alarm.at,
            alarm.clearedAt,      number(alarm.servo), alarm.servoId,
            alarm.model,          alarm.label,         alarm.key,
            alarm.derived,        alarm.port};
}

QVariantList valuesOf(const HistoryRecording& recording)
{
    QStringList ids;
    QStringList models;
    QStringList labels;
    for (const HistoryRecording::Servo& servo : recording.servos) {
        ids.append(QString::number(servo.id));
        models.append(servo.model);
        labels.append(servo.label);
    }
    return {number(recording.number),
            recording.uuid,
            recording.at,
            milliseconds(recording.length),
            recording.file,
            recording.rows,
            recording.port,
            recording.simulated,
            ids,
            models,
            labels};
}

QVariantList valuesOf(const TestRun& run)
{
    QStringList ids;
    QStringList models;
    QStringList labels;
    for (const TestServo& servo : run.servos) {
        ids.append(QString::number(servo.id));
        models.append(servo.model);
        labels.append(servo.label);
    }
    return {number(run.number),
            run.uuid,
            run.at,
            run.kind,
            gradeName(run.verdict),
            run.end,
            ids,
            models,
            labels,
            run.operatorName,
            run.note,
            milliseconds(run.length),
            run.port,
            run.simulated,
            run.program,
            run.files};
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
                                            const HistoryFilter& filter, const QString& path)
{
    return save(path, [&](BufferedSink& out) {
        out.put(csvLine(historyColumns(kind)));
        return forEachRow(history, kind, filter, [&](const QVariantList& row) {
            QStringList cells;
            for (const QVariant& value : row)
                cells.append(cellOf(value));
            return out.put(csvLine(cells));
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
            const QStringList columns = historyColumns(kind);
            out.put(",\n\"" + historyKindName(kind).toLatin1() + "\": [");
            bool first = true;
            const auto rows = forEachRow(history, kind, filter, [&](const QVariantList& row) {
                const bool put = out.put((first ? "\n" : ",\n") + jsonLine(columns, row));
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
} // namespace record

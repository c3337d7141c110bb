// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms and recordings of the history.
#include "history/history_intents.h"
#include "history/history_log.h"
#include "history/history_query.h"

#include <map>

namespace history {
namespace {
QString selectAlarms(const QString& inner)
{
    return QStringLiteral("SELECT a.number, a.uuid, a.servo, s.id, s.model, s.label, a.\"key\", "
                          "a.derived, a.at, a.went, a.port FROM (%1) a JOIN servos s ON s.number = "
                          "a.servo ORDER BY a.at DESC, a.number DESC")
        .arg(inner);
}

HistoryAlarm readAlarmRow(const QVariantList& row)
{
    HistoryAlarm alarm;
    int column = 0;
    alarm.number = row.value(column++).toLongLong();
    alarm.uuid = row.value(column++).toString();
    alarm.servo = row.value(column++).toLongLong();
    alarm.servoId = row.value(column++).toInt();
    alarm.model = row.value(column++).toString();
    alarm.label = row.value(column++).toString();
    alarm.key = row.value(column++).toString();
    alarm.derived = row.value(column++).toBool();
    alarm.at = readTime(row.value(column++));
    alarm.clearedAt = readTime(row.value(column++));
    alarm.port = row.value(column++).toString();
    return alarm;
}

HistoryRecording readRecordingRow(const QVariantList& row)
{
    HistoryRecording recording;
    int column = 0;
    recording.number = row.value(column++).toLongLong();
    recording.uuid = row.value(column++).toString();
    recording.at = readTime(row.value(column++));
    recording.length = base::Duration(row.value(column++).toLongLong());
    recording.file = row.value(column++).toString();
    recording.rows = row.value(column++).toLongLong();
    recording.port = row.value(column++).toString();
    recording.simulated = row.value(column++).toBool();
    return recording;
}

base::Result<void> addServos(const HistoryFile& file, std::int64_t recording,
                             const std::vector<base::ServoIdentity>& servos)
{
    int place = 0;
    for (const base::ServoIdentity& identity : servos) {
        const auto servo = findOrAddServo(file, identity);
        if (!servo)
            return tl::unexpected(servo.error());
        const auto added =
            file.run(QStringLiteral("INSERT INTO recording_servos (recording, place, servo) "
                                    "VALUES (?, ?, ?)"),
                     {qint64(recording), place++, qint64(*servo)});
        if (!added)
            return tl::unexpected(added.error());
    }
    return {};
}

base::Result<void> readServos(const HistoryFile& file, std::vector<HistoryRecording>& recordings)
{
    std::vector<std::int64_t> numbers;
    std::map<std::int64_t, std::size_t> places;
    for (const HistoryRecording& recording : recordings) {
        places[recording.number] = numbers.size();
        numbers.push_back(recording.number);
    }
    const auto rows = file.run(
        QStringLiteral("SELECT r.recording, r.servo, s.id, s.model, s.label FROM recording_servos "
                       "r JOIN servos s ON s.number = r.servo WHERE r.recording IN (%1) "
                       "ORDER BY r.recording, r.place")
            .arg(numberList(numbers)));
    if (!rows)
        return tl::unexpected(rows.error());
    for (const QVariantList& row : rows->rows)
        recordings[places[row.value(0).toLongLong()]].servos.push_back(
            {row.value(1).toLongLong(), row.value(2).toInt(), row.value(3).toString(),
             row.value(4).toString()});
    return {};
}
} // namespace

base::Result<void> HistoryLog::recordAlarmStart(const base::ServoIdentity& identity,
                                                const QString& key, bool derived,
                                                const QDateTime& at) const
{
    return m_file.transaction([&]() -> base::Result<void> {
        const auto servo = findOrAddServo(m_file, identity);
        if (!servo)
            return tl::unexpected(servo.error());
        const auto added = m_file.run(
            QStringLiteral("INSERT INTO alarms (uuid, servo, \"key\", derived, at, port) "
                           "SELECT ?, ?, ?, ?, ?, ? WHERE NOT EXISTS (SELECT 1 FROM alarms "
                           "WHERE servo = ? AND \"key\" = ? AND went IS NULL)"),
            {newUuid(), qint64(*servo), nonNull(key), int(derived), at.toMSecsSinceEpoch(),
             nonNull(identity.port), qint64(*servo), nonNull(key)});
        return added ? base::Result<void>() : tl::unexpected(added.error());
    });
}

base::Result<void> HistoryLog::recordAlarmEnd(const base::ServoIdentity& identity,
                                              const QString& key, const QDateTime& at) const
{
    return m_file.transaction([&]() -> base::Result<void> {
        const auto servo = findOrAddServo(m_file, identity);
        if (!servo)
            return tl::unexpected(servo.error());
        const auto gone = m_file.run(QStringLiteral("UPDATE alarms SET went = ? WHERE servo = ? "
                                                    "AND \"key\" = ? AND went IS NULL"),
                                     {at.toMSecsSinceEpoch(), qint64(*servo), nonNull(key)});
        return gone ? base::Result<void>() : tl::unexpected(gone.error());
    });
}

base::Result<std::vector<HistoryAlarm>> HistoryLog::alarms(const HistoryFilter& filter) const
{
    SqlConditions extra;
    if (!filter.key.isEmpty())
        extra.add(QStringLiteral("\"key\" = ?"), {filter.key});
    if (filter.onlyProblems)
        extra.add(QStringLiteral("went IS NULL"));
    const auto rows = readPage(m_file, filter, QStringLiteral("alarms"), extra, selectAlarms);
    if (!rows)
        return tl::unexpected(rows.error());
    return newestFirst<HistoryAlarm>(*rows, readAlarmRow, filter.limit);
}

base::Result<std::int64_t>
HistoryLog::addRecording(const HistoryRecording& recording,
                         const std::vector<base::ServoIdentity>& servos) const
{
    std::int64_t number = 0;
    const auto done = m_file.transaction([&]() -> base::Result<void> {
        const auto added = m_file.run(
            QStringLiteral("INSERT INTO recordings (uuid, at, length, file, readings, port, "
                           "simulated) VALUES (?, ?, ?, ?, ?, ?, ?)"),
            {newUuid(), recording.at.toMSecsSinceEpoch(), qint64(recording.length.count()),
             nonNull(recording.file), recording.rows, nonNull(recording.port),
             int(recording.simulated)});
        if (!added)
            return tl::unexpected(added.error());
        number = added->insertedId;
        return addServos(m_file, number, servos);
    });
    if (!done)
        return tl::unexpected(done.error());
    return number;
}

base::Result<std::vector<HistoryRecording>>
HistoryLog::recordings(const HistoryFilter& filter) const
{
    const auto servos = matchingServos(m_file, filter);
    if (!servos)
        return tl::unexpected(servos.error());
    SqlConditions extra;
    if (*servos)
        extra.add(QStringLiteral("number IN (SELECT recording FROM recording_servos WHERE servo IN "
                                 "(%1))")
                      .arg(numberList(**servos)));
    // The servos are selected; time and page of the filter remain.
    HistoryFilter rest;
    rest.from = filter.from;
    rest.until = filter.until;
    rest.after = filter.after;
    rest.limit = filter.limit;
    const auto rows =
        readPage(m_file, rest, QStringLiteral("recordings"), extra, [](const QString& inner) {
            return QStringLiteral("SELECT number, uuid, at, length, file, readings, port, "
                                  "simulated FROM (%1) r ORDER BY at DESC, number DESC")
                .arg(inner);
        });
    if (!rows)
        return tl::unexpected(rows.error());
    auto recordings = newestFirst<HistoryRecording>(*rows, readRecordingRow, filter.limit);
    if (const auto read = readServos(m_file, recordings); !read)
        return tl::unexpected(read.error());
    return recordings;
}

base::Result<void> HistoryLog::removeRecording(std::int64_t number) const
{
    const auto done =
        m_file.run(QStringLiteral("DELETE FROM recordings WHERE number = ?"), {qint64(number)});
    if (!done)
        return tl::unexpected(done.error());
    if (done->changed < 1)
        return notFoundError(QStringLiteral("recording"), number);
    return {};
}
} // namespace history

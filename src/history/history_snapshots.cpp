// SPDX-License-Identifier: GPL-3.0-or-later
// The snapshots of the history: the compressed text of the snapshot file and the columns of lists.
#include "catalog/profile.h"
#include "history/history_intents.h"
#include "history/history_log.h"
#include "history/history_query.h"

namespace history {
namespace {
QString selectSnapshotRows(const QString& inner)
{
    return QStringLiteral(
               "SELECT p.number, p.uuid, p.servo, s.id, s.model, s.firmware_major, "
               "s.firmware_minor, p.label, p.note, p.at, p.reason, p.program, p.port, p.baud, "
               "p.file, p.registers FROM (%1) p JOIN servos s ON s.number = p.servo "
               "ORDER BY p.at DESC, p.number DESC")
        .arg(inner);
}

QString versionText(int high, int low)
{
    catalog::Identity identity;
    identity.firmwareMajor = high;
    identity.firmwareMinor = low;
    return identity.firmware();
}

HistorySnapshot readSnapshotRow(const QVariantList& row)
{
    HistorySnapshot snapshot;
    int column = 0;
    snapshot.number = row.value(column++).toLongLong();
    snapshot.uuid = row.value(column++).toString();
    snapshot.servo = row.value(column++).toLongLong();
    snapshot.servoId = row.value(column++).toInt();
    snapshot.model = row.value(column++).toString();
    const int high = row.value(column++).toInt();
    snapshot.firmware = versionText(high, row.value(column++).toInt());
    snapshot.label = row.value(column++).toString();
    snapshot.note = row.value(column++).toString();
    snapshot.at = readTime(row.value(column++));
    snapshot.reason =
        snapshotReasonFromName(row.value(column++).toString()).value_or(SnapshotReason::Manual);
    snapshot.program = row.value(column++).toString();
    snapshot.port = row.value(column++).toString();
    snapshot.baud = row.value(column++).toInt();
    snapshot.file = row.value(column++).toString();
    snapshot.registers = row.value(column++).toInt();
    return snapshot;
}

/// "3.10" → 3, 10; all other texts → -1, -1.
std::pair<int, int> numbersIn(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('.'));
    bool first = false;
    bool second = false;
    const int high = parts.value(0).toInt(&first);
    const int low = parts.value(1).toInt(&second);
    return first && second ? std::pair(high, low) : std::pair(-1, -1);
}

base::Result<void> changeOne(const HistoryFile& file, const QString& sql,
                             const QVariantList& values, std::int64_t number)
{
    const auto done = file.run(sql, values);
    if (!done)
        return tl::unexpected(done.error());
    if (done->changed < 1)
        return notFoundError(QStringLiteral("snapshot"), number);
    return {};
}
} // namespace

base::ServoIdentity identityOf(const snapshot::Snapshot& snapshot)
{
    base::ServoIdentity identity;
    identity.id = snapshot.servo.id;
    std::tie(identity.modelMajor, identity.modelMinor) = numbersIn(snapshot.servo.modelId);
    std::tie(identity.firmwareMajor, identity.firmwareMinor) = numbersIn(snapshot.servo.firmware);
    identity.map = snapshot.servo.map;
    identity.port = snapshot.port;
    identity.baud = snapshot.baud;
    identity.protocol =
        base::protocolFromName(snapshot.servo.protocol).value_or(base::Protocol::Feetech);
    identity.model = snapshot.servo.model;
    return identity;
}

base::Result<std::int64_t> HistoryLog::addSnapshot(const snapshot::Snapshot& snapshot,
                                                   SnapshotReason reason, const QString& file) const
{
    const auto known =
        std::count_if(snapshot.registers.begin(), snapshot.registers.end(),
                      [](const snapshot::SnapshotRegister& row) { return row.raw.has_value(); });
    std::int64_t number = 0;
    const auto done = m_file.transaction([&]() -> base::Result<void> {
        const auto servo = findOrAddServo(m_file, identityOf(snapshot));
        if (!servo)
            return tl::unexpected(servo.error());
        const auto added = m_file.run(
            QStringLiteral("INSERT INTO snapshots (uuid, servo, at, reason, program, port, baud, "
                           "file, label, note, registers, data) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
            {newUuid(), qint64(*servo), snapshot.at.toMSecsSinceEpoch(), snapshotReasonName(reason),
             nonNull(snapshot.program), nonNull(snapshot.port), snapshot.baud, nonNull(file),
             nonNull(snapshot.label), nonNull(snapshot.note), int(known),
             qCompress(snapshot::encodeSnapshot(snapshot))});
        if (!added)
            return tl::unexpected(added.error());
        number = added->insertedId;
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    return number;
}

base::Result<std::vector<HistorySnapshot>> HistoryLog::snapshots(const HistoryFilter& filter) const
{
    SqlConditions extra;
    if (filter.reason)
        extra.add(QStringLiteral("reason = ?"), {snapshotReasonName(*filter.reason)});
    const auto rows =
        readPage(m_file, filter, QStringLiteral("snapshots"), extra, selectSnapshotRows);
    if (!rows)
        return tl::unexpected(rows.error());
    return newestFirst<HistorySnapshot>(*rows, readSnapshotRow, filter.limit);
}

base::Result<HistorySnapshot> HistoryLog::snapshotRow(std::int64_t number) const
{
    const auto row =
        m_file.run(selectSnapshotRows(QStringLiteral("SELECT * FROM snapshots WHERE number = ?")),
                   {qint64(number)});
    if (!row)
        return tl::unexpected(row.error());
    if (row->rows.empty())
        return notFoundError(QStringLiteral("snapshot"), number);
    return readSnapshotRow(row->rows.front());
}

base::Result<snapshot::Snapshot> HistoryLog::snapshot(std::int64_t number) const
{
    const auto row =
        m_file.run(QStringLiteral("SELECT data, label, note FROM snapshots WHERE number = ?"),
                   {qint64(number)});
    if (!row)
        return tl::unexpected(row.error());
    if (row->rows.empty())
        return notFoundError(QStringLiteral("snapshot"), number);
    auto snapshot = snapshot::decodeSnapshot(qUncompress(row->rows.front().value(0).toByteArray()));
    if (!snapshot)
        return snapshot;
    snapshot->label = row->rows.front().value(1).toString();
    snapshot->note = row->rows.front().value(2).toString();
    return snapshot;
}

base::Result<void> HistoryLog::setSnapshotNote(std::int64_t number, const QString& label,
                                               const QString& note) const
{
    return changeOne(m_file,
                     QStringLiteral("UPDATE snapshots SET label = ?, note = ? WHERE number = ?"),
                     {nonNull(label), nonNull(note), qint64(number)}, number);
}

base::Result<void> HistoryLog::removeSnapshot(std::int64_t number) const
{
    return changeOne(m_file, QStringLiteral("DELETE FROM snapshots WHERE number = ?"),
                     {qint64(number)}, number);
}
} // namespace history

// SPDX-License-Identifier: GPL-3.0-or-later
// The writes of the history, page by page.
#include "history/history_log.h"
#include "history/history_query.h"

#include <algorithm>

namespace history {
namespace {
QString selectWriteRows(const QString& inner)
{
    return QStringLiteral(
               "SELECT w.number, w.intent, i.uuid, w.place, w.servo, s.id, s.model, s.label, w.at, "
               "i.kind, i.temporary, w.\"key\", w.address, w.old, w.new, w.read_back, w.outcome, "
               "i.outcome, i.detail, i.port, i.baud, i.program, EXISTS (SELECT 1 FROM writes o "
               "WHERE o.intent = w.intent AND o.old <> o.new) FROM (%1) w JOIN intents i ON "
               "i.number = w.intent JOIN servos s ON s.number = w.servo "
               "ORDER BY w.at DESC, w.number DESC")
        .arg(inner);
}

HistoryWrite readWriteRow(const QVariantList& row)
{
    HistoryWrite write;
    int column = 0;
    write.number = row.value(column++).toLongLong();
    write.intent = row.value(column++).toLongLong();
    write.intentUuid = row.value(column++).toString();
    write.place = row.value(column++).toInt();
    write.servo = row.value(column++).toLongLong();
    write.servoId = row.value(column++).toInt();
    write.model = row.value(column++).toString();
    write.label = row.value(column++).toString();
    write.at = readTime(row.value(column++));
    write.kind =
        base::intentKindFromName(row.value(column++).toString()).value_or(base::IntentKind::Write);
    write.temporary = row.value(column++).toBool();
    write.key = row.value(column++).toString();
    write.address = row.value(column++).toInt();
    write.oldRaw = row.value(column++).toLongLong();
    write.newRaw = row.value(column++).toLongLong();
    const QVariant readBack = row.value(column++);
    if (!readBack.isNull())
        write.readBack = readBack.toLongLong();
    const QString own = row.value(column++).toString();
    const QString overallGrade = row.value(column++).toString();
    write.outcome = own.isEmpty() ? overallGrade : own;
    write.detail = row.value(column++).toString();
    write.port = row.value(column++).toString();
    write.baud = row.value(column++).toInt();
    write.program = row.value(column++).toString();
    const bool knownBefore = row.value(column++).toBool();
    write.ownDefaults = write.kind == base::IntentKind::Restore && !knownBefore;
    if (write.ownDefaults || write.kind == base::IntentKind::Calibrate)
        write.newRaw = write.readBack;
    return write;
}

SqlConditions extraConditions(const HistoryFilter& filter)
{
    SqlConditions extra;
    if (!filter.key.isEmpty())
        extra.add(QStringLiteral("\"key\" = ?"), {filter.key});
    if (filter.onlyProblems)
        extra.add(QStringLiteral("trouble = 1"));
    return extra;
}
} // namespace

base::Result<std::vector<HistoryWrite>> HistoryLog::writes(const HistoryFilter& filter) const
{
    const auto rows = readPage(m_file, filter, QStringLiteral("writes"), extraConditions(filter),
                               selectWriteRows);
    if (!rows)
        return tl::unexpected(rows.error());
    return newestFirst<HistoryWrite>(*rows, readWriteRow, filter.limit);
}

base::Result<std::int64_t> HistoryLog::countWrites(const HistoryFilter& filter) const
{
    const auto servos = matchingServos(m_file, filter);
    if (!servos)
        return tl::unexpected(servos.error());
    HistoryFilter all = filter;
    all.after.reset();
    SqlConditions sqlConditions = toConditions(all);
    const SqlConditions extra = extraConditions(filter);
    sqlConditions.conditions += extra.conditions;
    sqlConditions.values += extra.values;
    if (*servos)
        sqlConditions.add(QStringLiteral("servo IN (%1)").arg(numberList(**servos)));
    const auto counted =
        m_file.run(QStringLiteral("SELECT COUNT(*) FROM writes") + sqlConditions.where(),
                   sqlConditions.values);
    if (!counted)
        return tl::unexpected(counted.error());
    return counted->rows.front().value(0).toLongLong();
}

base::Result<HistoryWrite> HistoryLog::write(std::int64_t number) const
{
    const auto row = m_file.run(
        selectWriteRows(QStringLiteral("SELECT * FROM writes WHERE number = ?")), {qint64(number)});
    if (!row)
        return tl::unexpected(row.error());
    if (row->rows.empty())
        return notFoundError(QStringLiteral("write"), number);
    return readWriteRow(row->rows.front());
}

/// Steps from key to key in the index: DISTINCT would read every write.
base::Result<QStringList> HistoryLog::writtenKeys(std::optional<std::int64_t> servo) const
{
    const QString next = servo
                             ? QStringLiteral("SELECT MIN(\"key\") FROM writes WHERE servo = ? "
                                              "AND \"key\" > ?")
                             : QStringLiteral("SELECT MIN(\"key\") FROM writes WHERE \"key\" > ?");
    QStringList keys;
    QString last = QStringLiteral("");
    for (;;) {
        const auto found =
            m_file.run(next, servo ? QVariantList{qint64(*servo), last} : QVariantList{last});
        if (!found)
            return tl::unexpected(found.error());
        if (found->rows.empty() || found->rows.front().value(0).isNull())
            return keys;
        last = found->rows.front().value(0).toString();
        keys.append(last);
    }
}
} // namespace history

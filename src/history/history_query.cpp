// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_query.h"

namespace history {
tl::unexpected<base::Error> notFoundError(const QString& what, std::int64_t number)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history"),
                      QStringLiteral("no %1 %2").arg(what).arg(qint64(number)));
}

void SqlConditions::add(const QString& condition, const QVariantList& with)
{
    conditions.append(condition);
    values += with;
}

QString SqlConditions::where() const
{
    return conditions.isEmpty()
               ? QString()
               : QStringLiteral(" WHERE ") + conditions.join(QStringLiteral(" AND "));
}

SqlConditions toConditions(const HistoryFilter& filter)
{
    SqlConditions sqlConditions;
    if (filter.from.isValid())
        sqlConditions.add(QStringLiteral("at >= ?"), {filter.from.toMSecsSinceEpoch()});
    if (filter.until.isValid())
        sqlConditions.add(QStringLiteral("at < ?"), {filter.until.toMSecsSinceEpoch()});
    if (filter.after) {
        const qint64 at = filter.after->at.toMSecsSinceEpoch();
        sqlConditions.add(QStringLiteral("at <= ?"), {at});
        sqlConditions.add(QStringLiteral("(at < ? OR number < ?)"),
                          {at, qint64(filter.after->number)});
    }
    return sqlConditions;
}

base::Result<std::optional<std::vector<std::int64_t>>> matchingServos(const HistoryFile& file,
                                                                      const HistoryFilter& filter)
{
    SqlConditions sqlConditions;
    // A label stays with a servo when its ID changes.
    if (filter.servo)
        sqlConditions.add(
            QStringLiteral("EXISTS (SELECT 1 FROM servos s WHERE s.number = ? AND (s.number "
                           "= servos.number OR (s.label <> '' AND s.label = servos.label "
                           "AND s.simulated = servos.simulated AND s.protocol = "
                           "servos.protocol AND s.model_major = servos.model_major AND "
                           "s.model_minor = servos.model_minor AND s.map = servos.map") +
                file.sameBench(QStringLiteral("s"), QStringLiteral("servos")) +
                QStringLiteral(")))"),
            {qint64(*filter.servo)});
    if (filter.id)
        sqlConditions.add(QStringLiteral("id = ?"), {*filter.id});
    if (!filter.model.isEmpty())
        sqlConditions.add(QStringLiteral("lower(model) = ?"), {filter.model.toLower()});
    if (!filter.label.isEmpty())
        sqlConditions.add(QStringLiteral("label = ?"), {filter.label});
    if (sqlConditions.conditions.isEmpty())
        return std::nullopt;
    const auto found = file.run(QStringLiteral("SELECT number FROM servos") + sqlConditions.where(),
                                sqlConditions.values);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<std::int64_t> numbers;
    for (const QVariantList& row : found->rows)
        numbers.push_back(row.value(0).toLongLong());
    return numbers;
}

base::Result<std::vector<QVariantList>>
readPage(const HistoryFile& file, const HistoryFilter& filter, const QString& table,
         const SqlConditions& extra, const std::function<QString(const QString& inner)>& rows)
{
    const auto servos = matchingServos(file, filter);
    if (!servos)
        return tl::unexpected(servos.error());
    std::vector<QVariantList> all;
    const auto add = [&](const std::optional<std::int64_t>& servo) -> base::Result<void> {
        SqlConditions sqlConditions = toConditions(filter);
        sqlConditions.conditions += extra.conditions;
        sqlConditions.values += extra.values;
        if (servo)
            sqlConditions.add(QStringLiteral("servo = ?"), {qint64(*servo)});
        const QString inner = QStringLiteral("SELECT * FROM ") + table + sqlConditions.where() +
                              QStringLiteral(" ORDER BY at DESC, number DESC LIMIT %1")
                                  .arg(std::max(filter.limit, 0));
        auto found = file.run(rows(inner), sqlConditions.values);
        if (!found)
            return tl::unexpected(found.error());
        std::move(found->rows.begin(), found->rows.end(), std::back_inserter(all));
        return {};
    };
    if (!*servos) {
        if (const auto added = add(std::nullopt); !added)
            return tl::unexpected(added.error());
        return all;
    }
    for (const std::int64_t servo : **servos) {
        if (const auto added = add(servo); !added)
            return tl::unexpected(added.error());
    }
    return all;
}

QString numberList(const std::vector<std::int64_t>& numbers)
{
    if (numbers.empty())
        return QStringLiteral("-1");
    QStringList list;
    for (const std::int64_t number : numbers)
        list.append(QString::number(number));
    return list.join(QStringLiteral(", "));
}

QString servoColumns()
{
    return QStringLiteral("s.number, s.uuid, s.protocol, s.model_major, s.model_minor, "
                          "s.firmware_major, s.firmware_minor, s.map, s.id, s.label, s.model");
}

HistoryServo readServoRow(const QVariantList& row, int from)
{
    HistoryServo servo;
    servo.number = row.value(from++).toLongLong();
    servo.uuid = row.value(from++).toString();
    servo.identity.protocol =
        base::protocolFromName(row.value(from++).toString()).value_or(base::Protocol::Feetech);
    servo.identity.modelMajor = row.value(from++).toInt();
    servo.identity.modelMinor = row.value(from++).toInt();
    servo.identity.firmwareMajor = row.value(from++).toInt();
    servo.identity.firmwareMinor = row.value(from++).toInt();
    servo.identity.map = row.value(from++).toString();
    servo.identity.id = row.value(from++).toInt();
    servo.label = row.value(from++).toString();
    servo.identity.model = row.value(from++).toString();
    return servo;
}
} // namespace history

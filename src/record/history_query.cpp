// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/history_query.h"

namespace record {
tl::unexpected<base::Error> notInHistory(const QString& what, std::int64_t number)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history"),
                      QStringLiteral("no %1 %2").arg(what).arg(qint64(number)));
}

void HistoryChoice::add(const QString& condition, const QVariantList& with)
{
    conditions.append(condition);
    values += with;
}

QString HistoryChoice::where() const
{
    return conditions.isEmpty()
               ? QString()
               : QStringLiteral(" WHERE ") + conditions.join(QStringLiteral(" AND "));
}

HistoryChoice choiceOf(const HistoryFilter& filter)
{
    HistoryChoice choice;
    if (filter.from.isValid())
        choice.add(QStringLiteral("at >= ?"), {filter.from.toMSecsSinceEpoch()});
    if (filter.until.isValid())
        choice.add(QStringLiteral("at < ?"), {filter.until.toMSecsSinceEpoch()});
    if (filter.after) {
        const qint64 at = filter.after->at.toMSecsSinceEpoch();
        choice.add(QStringLiteral("at <= ?"), {at});
        choice.add(QStringLiteral("(at < ? OR number < ?)"), {at, qint64(filter.after->number)});
    }
    return choice;
}

base::Result<std::optional<std::vector<std::int64_t>>> servosOf(const HistoryFile& file,
                                                                const HistoryFilter& filter)
{
    HistoryChoice choice;
    // A label stays with a servo when its ID changes.
    if (filter.servo)
        choice.add(QStringLiteral("EXISTS (SELECT 1 FROM servos s WHERE s.number = ? AND (s.number "
                                  "= servos.number OR (s.label <> '' AND s.label = servos.label "
                                  "AND s.simulated = servos.simulated AND s.protocol = "
                                  "servos.protocol AND s.model_major = servos.model_major AND "
                                  "s.model_minor = servos.model_minor AND s.map = servos.map") +
                       file.sameBench(QStringLiteral("s"), QStringLiteral("servos")) +
                       QStringLiteral(")))"),
                   {qint64(*filter.servo)});
    if (filter.id)
        choice.add(QStringLiteral("id = ?"), {*filter.id});
    if (!filter.model.isEmpty())
        choice.add(QStringLiteral("lower(model) = ?"), {filter.model.toLower()});
    if (!filter.label.isEmpty())
        choice.add(QStringLiteral("label = ?"), {filter.label});
    if (choice.conditions.isEmpty())
        return std::nullopt;
    const auto found =
        file.run(QStringLiteral("SELECT number FROM servos") + choice.where(), choice.values);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<std::int64_t> numbers;
    for (const QVariantList& row : found->rows)
        numbers.push_back(row.value(0).toLongLong());
    return numbers;
}

base::Result<std::vector<QVariantList>>
pageOf(const HistoryFile& file, const HistoryFilter& filter, const QString& table,
       const HistoryChoice& more, const std::function<QString(const QString& inner)>& rows)
{
    const auto servos = servosOf(file, filter);
    if (!servos)
        return tl::unexpected(servos.error());
    std::vector<QVariantList> all;
    const auto add = [&](const std::optional<std::int64_t>& servo) -> base::Result<void> {
        HistoryChoice choice = choiceOf(filter);
        choice.conditions += more.conditions;
        choice.values += more.values;
        if (servo)
            choice.add(QStringLiteral("servo = ?"), {qint64(*servo)});
        const QString inner =
            QStringLiteral("SELECT * FROM ") + table + choice.where() +
            QStringLiteral(" ORDER BY at DESC, number DESC LIMIT %1").arg(std::max(filter.most, 0));
        auto found = file.run(rows(inner), choice.values);
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

HistoryServo servoIn(const QVariantList& row, int from)
{
    HistoryServo servo;
    servo.number = row.value(from++).toLongLong();
    servo.uuid = row.value(from++).toString();
    servo.who.protocol =
        base::protocolFromName(row.value(from++).toString()).value_or(base::Protocol::Feetech);
    servo.who.modelMajor = row.value(from++).toInt();
    servo.who.modelMinor = row.value(from++).toInt();
    servo.who.firmwareMajor = row.value(from++).toInt();
    servo.who.firmwareMinor = row.value(from++).toInt();
    servo.who.map = row.value(from++).toString();
    servo.who.id = row.value(from++).toInt();
    servo.label = row.value(from++).toString();
    servo.who.model = row.value(from++).toString();
    return servo;
}
} // namespace record

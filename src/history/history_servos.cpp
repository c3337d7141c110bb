// SPDX-License-Identifier: GPL-3.0-or-later
// The servos of the history and their labels.
#include "history/history_intents.h"
#include "history/history_log.h"
#include "history/history_query.h"

namespace history {
namespace {
/// With place and time of the last write.
const QString selectServos = QStringLiteral(
    "SELECT %1, s.current, (SELECT MAX(at) FROM intents WHERE servo = s.number), "
    "(SELECT port FROM intents WHERE servo = s.number ORDER BY at DESC, number DESC LIMIT 1), "
    "(SELECT baud FROM intents WHERE servo = s.number ORDER BY at DESC, number DESC LIMIT 1) "
    "FROM servos s ");

base::Result<std::vector<HistoryServo>> read(const HistoryFile& file, const QString& rest,
                                             const QVariantList& values)
{
    const auto found = file.run(selectServos.arg(servoColumns()) + rest, values);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<HistoryServo> servos;
    for (const QVariantList& row : found->rows) {
        HistoryServo servo = readServoRow(row);
        int column = servoColumnCount;
        servo.current = row.value(column++).toBool();
        servo.lastWrite = readTime(row.value(column++));
        servo.identity.port = row.value(column++).toString();
        servo.identity.baud = row.value(column++).toInt();
        servos.push_back(std::move(servo));
    }
    return servos;
}

base::Result<HistoryServo> readOne(const HistoryFile& file, std::int64_t number)
{
    auto found = read(file, QStringLiteral("WHERE s.number = ?"), {qint64(number)});
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return notFoundError(QStringLiteral("servo"), number);
    return found->front();
}
} // namespace

base::Result<std::vector<HistoryServo>> HistoryLog::servos(const HistoryFilter& filter) const
{
    SqlConditions sqlConditions;
    if (filter.servo)
        sqlConditions.add(QStringLiteral("s.number = ?"), {qint64(*filter.servo)});
    if (filter.id)
        sqlConditions.add(QStringLiteral("s.id = ?"), {*filter.id});
    if (!filter.model.isEmpty())
        sqlConditions.add(QStringLiteral("lower(s.model) = ?"), {filter.model.toLower()});
    if (!filter.label.isEmpty())
        sqlConditions.add(QStringLiteral("s.label = ?"), {filter.label});
    return read(
        m_file,
        sqlConditions.where() +
            QStringLiteral(" ORDER BY %1 DESC NULLS LAST, s.number DESC").arg(servoColumnCount + 2),
        sqlConditions.values);
}

base::Result<HistoryServo> HistoryLog::servo(std::int64_t number) const
{
    return readOne(m_file, number);
}

base::Result<std::optional<HistoryServo>> HistoryLog::of(const base::ServoIdentity& identity) const
{
    auto found =
        read(m_file,
             QStringLiteral(
                 "WHERE s.current = 1 AND s.id = ? AND s.simulated = ? AND s.protocol = ? AND "
                 "s.model_major = ? AND s.model_minor = ? AND s.firmware_major = ? AND "
                 "s.firmware_minor = ? AND s.map = ?"),
             {identity.id, int(identity.isSimulated()), base::protocolName(identity.protocol),
              identity.modelMajor, identity.modelMinor, identity.firmwareMajor,
              identity.firmwareMinor, nonNull(identity.map)});
    if (!found)
        return tl::unexpected(found.error());
    if (found->empty())
        return std::nullopt;
    return found->front();
}

base::Result<HistoryServo> HistoryLog::findOrAdd(const base::ServoIdentity& identity) const
{
    std::int64_t number = 0;
    const auto met = m_file.transaction([&]() -> base::Result<void> {
        const auto found = findOrAddServo(m_file, identity);
        if (!found)
            return tl::unexpected(found.error());
        number = *found;
        return {};
    });
    if (!met)
        return tl::unexpected(met.error());
    return readOne(m_file, number);
}

base::Result<void> HistoryLog::setLabel(std::int64_t number, const QString& label) const
{
    return m_file.transaction([&]() -> base::Result<void> {
        const auto named = m_file.run(
            QStringLiteral(
                "UPDATE servos SET label = ? WHERE number = ? AND NOT EXISTS (SELECT 1 FROM servos "
                "AS o WHERE o.number <> servos.number AND o.label = ? AND o.id = servos.id AND "
                "o.simulated = servos.simulated AND o.protocol = servos.protocol AND o.model_major "
                "= servos.model_major AND "
                "o.model_minor = servos.model_minor AND o.firmware_major = servos.firmware_major "
                "AND o.firmware_minor = servos.firmware_minor AND o.map = servos.map)"),
            {nonNull(label), qint64(number), nonNull(label)});
        if (!named)
            return tl::unexpected(named.error());
        if (named->changed > 0)
            return {};
        const auto servoThere = readOne(m_file, number);
        if (!servoThere)
            return tl::unexpected(servoThere.error());
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history"),
                          QStringLiteral("label-in-use"));
    });
}

base::Result<HistoryServo> HistoryLog::assignToOther(std::int64_t number,
                                                     const QString& label) const
{
    std::int64_t other = 0;
    const auto done = m_file.transaction([&]() -> base::Result<void> {
        auto former = readOne(m_file, number);
        if (!former)
            return tl::unexpected(former.error());
        if (former->identity.port.isEmpty()) { // never written to
            const auto port = m_file.run(
                QStringLiteral("SELECT CASE simulated WHEN 1 THEN 'sim:' ELSE '' END FROM servos "
                               "WHERE number = ?"),
                {qint64(number)});
            if (!port)
                return tl::unexpected(port.error());
            former->identity.port = port->rows.front().value(0).toString();
        }
        const auto found = makeCurrentServo(m_file, former->identity, label);
        if (!found)
            return tl::unexpected(found.error());
        other = *found;
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    return readOne(m_file, other);
}
} // namespace history

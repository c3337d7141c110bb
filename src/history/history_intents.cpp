// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_intents.h"

#include "history/history_query.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <map>

namespace history {
namespace {
const QString identityCondition =
    QStringLiteral("id = ? AND simulated = ? AND protocol = ? AND model_major = "
                   "? AND model_minor = ? AND firmware_major = ? AND "
                   "firmware_minor = ? AND map = ?");

QVariantList valuesOf(const base::ServoIdentity& identity)
{
    return {identity.id,
            int(identity.isSimulated()),
            base::protocolName(identity.protocol),
            identity.modelMajor,
            identity.modelMinor,
            identity.firmwareMajor,
            identity.firmwareMinor,
            nonNull(identity.map)};
}

base::Result<std::int64_t> insertServo(const HistoryFile& file, const base::ServoIdentity& identity,
                                       const QString& label)
{
    QVariantList values{newUuid()};
    values += valuesOf(identity);
    values += {nonNull(label), nonNull(identity.model)};
    const auto added =
        file.run(QStringLiteral(
                     "INSERT INTO servos (uuid, id, simulated, protocol, model_major, model_minor, "
                     "firmware_major, firmware_minor, map, label, model, current) "
                     "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 1)"),
                 values);
    if (!added)
        return tl::unexpected(added.error());
    return added->insertedId;
}

/// The outcome of each register; where only the outcome of the whole write is known, that one.
base::Result<void> endWrites(const HistoryFile& file, std::int64_t intent,
                             const base::IntentResult& end)
{
    const auto all = file.run(QStringLiteral("UPDATE writes SET trouble = ? WHERE intent = ?"),
                              {isSuccess(end.outcome) ? 0 : 1, qint64(intent)});
    if (!all)
        return tl::unexpected(all.error());
    for (const base::ItemResult& item : end.items) {
        // Unknown when it was written, but the end of the whole write was a success.
        const bool settled = isSuccess(end.outcome) && item.outcome == QLatin1String("unknown");
        const auto one = file.run(
            QStringLiteral("UPDATE writes SET read_back = ?, outcome = ?, trouble = ? "
                           "WHERE intent = ? AND \"key\" = ?"),
            {item.readBack ? QVariant(qint64(*item.readBack)) : QVariant(), nonNull(item.outcome),
             settled || isSuccess(item.outcome) ? 0 : 1, qint64(intent), item.key});
        if (!one)
            return tl::unexpected(one.error());
    }
    return {};
}

/// The label goes with the servo to its new ID; a servo that replies to the old one is another.
base::Result<void> moveLabel(const HistoryFile& file, std::int64_t intent)
{
    const auto moved = file.run(
        QStringLiteral("SELECT %1, w.new, i.port FROM intents i JOIN servos s ON s.number = "
                       "i.servo JOIN writes w ON w.intent = i.number AND w.place = 0 "
                       "WHERE i.number = ? AND i.kind = 'set-id' AND s.label <> ''")
            .arg(servoColumns()),
        {qint64(intent)});
    if (!moved)
        return tl::unexpected(moved.error());
    if (moved->rows.empty())
        return {};
    HistoryServo servo = readServoRow(moved->rows.front());
    servo.identity.port = moved->rows.front().value(servoColumnCount + 1).toString();
    if (servo.identity.id == moved->rows.front().value(servoColumnCount).toInt())
        return {};
    if (const auto preferred = makeCurrentServo(file, servo.identity, {}); !preferred)
        return tl::unexpected(preferred.error());
    servo.identity.id = moved->rows.front().value(servoColumnCount).toInt();
    const auto there = makeCurrentServo(file, servo.identity, servo.label);
    return there ? base::Result<void>() : tl::unexpected(there.error());
}

base::Intent readIntentRow(const QVariantList& row)
{
    base::Intent intent;
    int column = 1;
    intent.uuid = row.value(column++).toString();
    intent.at = readTime(row.value(column++));
    intent.kind =
        base::intentKindFromName(row.value(column++).toString()).value_or(base::IntentKind::Write);
    intent.temporary = row.value(column++).toBool();
    intent.lockOpened = row.value(column++).toBool();
    const QString port = row.value(column++).toString();
    const int baud = row.value(column++).toInt();
    column += 2; // how it ended
    intent.servo = readServoRow(row, column).identity;
    intent.servo.port = port;
    intent.servo.baud = baud;
    return intent;
}

std::optional<std::int64_t> toOptionalInteger(const QVariant& value)
{
    return value.isNull() ? std::nullopt : std::optional<std::int64_t>(value.toLongLong());
}
} // namespace

base::Result<std::int64_t> findOrAddServo(const HistoryFile& file,
                                          const base::ServoIdentity& identity)
{
    const auto found = file.run(QStringLiteral("SELECT number, model FROM servos WHERE current = 1 "
                                               "AND ") +
                                    identityCondition,
                                valuesOf(identity));
    if (!found)
        return tl::unexpected(found.error());
    if (found->rows.empty())
        return insertServo(file, identity, {});
    const std::int64_t number = found->rows.front().value(0).toLongLong();
    if (!identity.model.isEmpty() && found->rows.front().value(1).toString() != identity.model) {
        const auto named = file.run(QStringLiteral("UPDATE servos SET model = ? WHERE number = ?"),
                                    {identity.model, qint64(number)});
        if (!named)
            return tl::unexpected(named.error());
    }
    return number;
}

base::Result<std::int64_t>
makeCurrentServo(const HistoryFile& file, const base::ServoIdentity& identity, const QString& label)
{
    const auto others = file.run(
        QStringLiteral("UPDATE servos SET current = 0 WHERE current = 1 AND ") + identityCondition,
        valuesOf(identity));
    if (!others)
        return tl::unexpected(others.error());
    QVariantList values = valuesOf(identity);
    values.append(nonNull(label));
    const auto there = file.run(QStringLiteral("SELECT number FROM servos WHERE ") +
                                    identityCondition + QStringLiteral(" AND label = ?"),
                                values);
    if (!there)
        return tl::unexpected(there.error());
    if (there->rows.empty())
        return insertServo(file, identity, label);
    const std::int64_t number = there->rows.front().value(0).toLongLong();
    const auto preferred = file.run(
        QStringLiteral("UPDATE servos SET current = 1 WHERE number = ?"), {qint64(number)});
    if (!preferred)
        return tl::unexpected(preferred.error());
    return number;
}

base::Result<void> insertIntent(const HistoryFile& file, const base::Intent& intent,
                                const QString& program)
{
    const auto servo = findOrAddServo(file, intent.servo);
    if (!servo)
        return tl::unexpected(servo.error());
    const qint64 at = intent.at.toMSecsSinceEpoch();
    const auto added = file.run(
        QStringLiteral("INSERT INTO intents (uuid, servo, at, kind, temporary, lock_opened, port, "
                       "baud, program) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
        {intent.uuid, qint64(*servo), at, base::intentKindName(intent.kind), int(intent.temporary),
         int(intent.lockOpened), nonNull(intent.servo.port), intent.servo.baud, nonNull(program)});
    if (!added)
        return tl::unexpected(added.error());
    int place = 0;
    for (const base::JournalItem& item : intent.items) {
        const auto one = file.run(
            QStringLiteral("INSERT INTO writes (intent, place, servo, at, \"key\", address, old, "
                           "new) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
            {qint64(added->insertedId), place++, qint64(*servo), at, nonNull(item.key),
             item.address, qint64(item.oldRaw), qint64(item.newRaw)});
        if (!one)
            return tl::unexpected(one.error());
    }
    return {};
}

base::Result<bool> endIntent(const HistoryFile& file, const QString& uuid,
                             const base::IntentResult& end, const QDateTime& at)
{
    const auto found =
        file.run(QStringLiteral("SELECT number FROM intents WHERE uuid = ?"), {uuid});
    if (!found)
        return tl::unexpected(found.error());
    if (found->rows.empty())
        return false;
    const std::int64_t number = found->rows.front().value(0).toLongLong();
    const auto ended = file.run(
        QStringLiteral("UPDATE intents SET outcome = ?, detail = ?, ended = ? WHERE number = ?"),
        {nonNull(end.outcome), nonNull(end.detail), at.toMSecsSinceEpoch(), qint64(number)});
    if (!ended)
        return tl::unexpected(ended.error());
    if (const auto writes = endWrites(file, number, end); !writes)
        return tl::unexpected(writes.error());
    if (end.outcome == QLatin1String("done")) {
        if (const auto followed = moveLabel(file, number); !followed)
            return tl::unexpected(followed.error());
    }
    return true;
}

base::Result<void> saveFact(const HistoryFile& file, const base::ServoIdentity& servo,
                            const QString& name, const std::vector<std::int64_t>& values,
                            const QDateTime& at)
{
    const auto number = findOrAddServo(file, servo);
    if (!number)
        return tl::unexpected(number.error());
    QJsonArray list;
    for (const std::int64_t value : values)
        list.append(QString::number(value)); // a JSON number has 53 bits
    const QString content = QString::fromLatin1(QJsonDocument(list).toJson(QJsonDocument::Compact));
    const auto kept = file.run(
        QStringLiteral("INSERT INTO facts (uuid, servo, name, at, content) VALUES (?, ?, ?, ?, ?) "
                       "ON CONFLICT (servo, name) DO UPDATE SET content = excluded.content, "
                       "at = excluded.at"),
        {newUuid(), qint64(*number), nonNull(name), at.toMSecsSinceEpoch(), content});
    return kept ? base::Result<void>() : tl::unexpected(kept.error());
}

base::Result<std::optional<std::vector<std::int64_t>>>
loadFact(const HistoryFile& file, const base::ServoIdentity& servo, const QString& name)
{
    QVariantList values{name};
    values += valuesOf(servo);
    const auto found =
        file.run(QStringLiteral("SELECT content FROM facts WHERE name = ? AND servo IN "
                                "(SELECT number FROM servos WHERE current = 1 AND ") +
                     identityCondition + QStringLiteral(")"),
                 values);
    if (!found)
        return tl::unexpected(found.error());
    if (found->rows.empty())
        return std::nullopt;
    const QByteArray content = found->rows.front().value(0).toString().toLatin1();
    std::vector<std::int64_t> list;
    const QJsonArray array = QJsonDocument::fromJson(content).array();
    for (const QJsonValue value : array)
        list.push_back(value.toString().toLongLong());
    return list;
}

base::Result<std::vector<base::JournalEntry>>
readEntries(const HistoryFile& file, const QString& whereClause, const QVariantList& values)
{
    const QString fromClause =
        QStringLiteral("FROM intents i JOIN servos s ON s.number = i.servo ") + whereClause;
    const auto heads =
        file.run(QStringLiteral("SELECT i.number, i.uuid, i.at, i.kind, i.temporary, "
                                "i.lock_opened, i.port, i.baud, i.outcome, i.detail, ") +
                     servoColumns() + QLatin1Char(' ') + fromClause,
                 values);
    if (!heads)
        return tl::unexpected(heads.error());
    std::vector<base::JournalEntry> entries;
    std::map<std::int64_t, std::size_t> places;
    for (const QVariantList& row : heads->rows) {
        base::JournalEntry entry{readIntentRow(row), std::nullopt};
        constexpr int outcome = 8;
        if (!row.value(outcome).isNull())
            entry.end = base::IntentResult{row.value(outcome).toString(),
                                           row.value(outcome + 1).toString()};
        places[row.value(0).toLongLong()] = entries.size();
        entries.push_back(std::move(entry));
    }
    const auto items =
        file.run(QStringLiteral("SELECT intent, \"key\", address, old, new, read_back, outcome "
                                "FROM writes WHERE intent IN (SELECT i.number ") +
                     fromClause + QStringLiteral(") ORDER BY intent, place"),
                 values);
    if (!items)
        return tl::unexpected(items.error());
    for (const QVariantList& row : items->rows) {
        const auto place = places.find(row.value(0).toLongLong());
        if (place == places.end())
            continue; // added by another program in between
        base::JournalEntry& entry = entries[place->second];
        entry.intent.items.push_back({row.value(1).toString(), row.value(2).toInt(),
                                      row.value(3).toLongLong(), row.value(4).toLongLong()});
        if (entry.end && !row.value(6).isNull())
            entry.end->items.push_back({row.value(1).toString(), toOptionalInteger(row.value(5)),
                                        row.value(6).toString()});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const base::JournalEntry& a, const base::JournalEntry& b) {
                         return a.intent.at < b.intent.at;
                     });
    return entries;
}

base::Result<std::vector<base::JournalEntry>>
readServoEntries(const HistoryFile& file, const base::ServoIdentity& servo, int limit)
{
    const QString ownServo = QStringLiteral("(SELECT number FROM servos WHERE current = 1 AND ") +
                             identityCondition + QStringLiteral(")");
    // Servos changing to this ID have another one, so only the kind is compared.
    const QString isSameKind =
        QStringLiteral("(SELECT number FROM servos WHERE ") +
        identityCondition.mid(identityCondition.indexOf(QLatin1String("simulated"))) +
        QStringLiteral(")");
    QVariantList values = valuesOf(servo);
    values << limit;
    values += valuesOf(servo).mid(1);
    values << servo.id << limit << limit;
    // Each part is a query of its own, so that an index is used in a long history too.
    return readEntries(
        file,
        QStringLiteral("WHERE i.number IN (SELECT number FROM (SELECT * FROM (SELECT number, at "
                       "FROM intents WHERE servo = ") +
            ownServo +
            QStringLiteral(" ORDER BY at DESC, number DESC LIMIT ?) AS own UNION SELECT * FROM "
                           "(SELECT number, at FROM intents WHERE kind = 'set-id' AND servo IN ") +
            isSameKind +
            QStringLiteral(" AND EXISTS (SELECT 1 FROM writes WHERE intent = intents.number AND "
                           "place = 0 AND new = ?) ORDER BY at DESC, number DESC LIMIT ?) AS came "
                           "ORDER BY 2 DESC, 1 DESC LIMIT ?) AS both_of_them) "
                           "ORDER BY i.at, i.number"),
        values);
}
} // namespace history

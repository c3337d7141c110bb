// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_changes.h"

#include "history/history_file.h"
#include "history/history_schema.h"

#include <algorithm>

namespace history {
namespace {
struct Child {
    const char* table;
    const char* parent; ///< its column that names the row
    const char* order;
    QStringList columns;
    bool ofServo = false;
};

struct SyncedTable {
    QString table;
    QStringList columns; ///< without number, uuid, revision and servo
    bool ofServo = false;
    std::vector<Child> children{};
};

QStringList splitWords(const char* list)
{
    return QString::fromLatin1(list).split(QLatin1Char(' '));
}

/// Blobs come last, so that SQLite reads them only where they are needed.
const std::vector<SyncedTable>& tables()
{
    static const std::vector<SyncedTable> all{
        {QStringLiteral("servos"),
         splitWords("protocol model_major model_minor firmware_major "
                    "firmware_minor map id label model simulated current")},
        {QStringLiteral("intents"),
         splitWords("at kind temporary lock_opened port baud program ended outcome detail"),
         true,
         {{"writes", "intent", "place",
           splitWords("place at key address old new read_back outcome trouble"), true}}},
        {QStringLiteral("snapshots"),
         splitWords("at reason program port baud file label note registers data"), true},
        {QStringLiteral("alarms"), splitWords("key derived at went port"), true},
        {QStringLiteral("recordings"),
         splitWords("at length file readings port simulated"),
         false,
         {{"recording_servos", "recording", "place", splitWords("place"), true}}},
        {QStringLiteral("facts"), splitWords("name at content"), true},
        {QStringLiteral("runs"),
         splitWords("kind at program port simulated verdict ended operator note length"),
         false,
         {{"run_servos", "run", "place",
           splitWords("place id model map firmware verdict label reference")},
          {"run_texts", "run", "part", splitWords("part data")},
          {"run_files", "run", "place", splitWords("place path")}}},
    };
    return all;
}

const SyncedTable& tableOf(const QString& name)
{
    return *std::find_if(tables().begin(), tables().end(),
                         [&](const SyncedTable& copied) { return copied.table == name; });
}

QString selectStatement(const QStringList& columns, bool ofServo, const QString& table)
{
    QStringList list;
    for (const QString& column : columns)
        list.append(QStringLiteral("t.\"%1\"").arg(column));
    if (ofServo)
        list.append(QStringLiteral("(SELECT uuid FROM servos WHERE number = t.servo)"));
    return QStringLiteral("SELECT ") + list.join(QStringLiteral(", ")) +
           QStringLiteral(" FROM %1 t ").arg(table);
}

QVariantMap toValueMap(const QVariantList& row, const QStringList& columns, bool ofServo,
                       qint64& bytes)
{
    QVariantMap values;
    for (qsizetype i = 0; i < columns.size(); ++i) {
        values.insert(columns[i], row.value(i));
        if (row.value(i).typeId() == QMetaType::QByteArray)
            bytes += row.value(i).toByteArray().size();
    }
    if (ofServo)
        values.insert(QStringLiteral("servo_uuid"), row.value(columns.size()));
    return values;
}

/// A row that was changed or deleted, not read yet.
struct ChangeEntry {
    std::int64_t revision = 0;
    QString table;
    QString uuid;
    std::int64_t number = 0; ///< 0: deleted
};

/// The first rows after `revision`, of all tables. One statement, so that it reads one state of
/// the file: with a query per table, a row added meanwhile to a table already read would be
/// skipped.
base::Result<std::vector<ChangeEntry>> changesAfter(const HistoryFile& file, std::int64_t revision,
                                                    int limit)
{
    QStringList parts;
    QVariantList values;
    const auto add = [&](const QString& columns, const QString& table) {
        parts.append(QStringLiteral("SELECT * FROM (SELECT %1 FROM %2 WHERE revision > ? "
                                    "ORDER BY revision LIMIT ?)")
                         .arg(columns, table));
        values << qint64(revision) << limit;
    };
    for (const QString& table : syncedTables())
        add(QStringLiteral("revision, '%1', uuid, number").arg(table), table);
    add(QStringLiteral("revision, kind, uuid, 0"), QStringLiteral("removed"));
    values << limit;
    const auto found = file.run(
        parts.join(QStringLiteral(" UNION ALL ")) + QStringLiteral(" ORDER BY 1 LIMIT ?"), values);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<ChangeEntry> changes;
    for (const QVariantList& row : found->rows)
        changes.push_back({row.value(0).toLongLong(), row.value(1).toString(),
                           row.value(2).toString(), row.value(3).toLongLong()});
    return changes;
}

/// Nothing: it was deleted since, which is a later change.
base::Result<std::optional<ChangedRow>> readRow(const HistoryFile& file, const ChangeEntry& changes,
                                                qint64& bytes)
{
    const SyncedTable& copied = tableOf(changes.table);
    const auto found = file.run(selectStatement(copied.columns, copied.ofServo, copied.table) +
                                    QStringLiteral("WHERE t.number = ?"),
                                {qint64(changes.number)});
    if (!found)
        return tl::unexpected(found.error());
    if (found->rows.empty())
        return std::nullopt;
    ChangedRow row{changes.revision, changes.table, changes.uuid, false, {}, {}};
    row.values = toValueMap(found->rows.front(), copied.columns, copied.ofServo, bytes);
    for (const Child& child : copied.children) {
        const QString table = QString::fromLatin1(child.table);
        const auto rows =
            file.run(selectStatement(child.columns, child.ofServo, table) +
                         QStringLiteral("WHERE t.%1 = ? ORDER BY t.%2")
                             .arg(QLatin1String(child.parent), QLatin1String(child.order)),
                     {qint64(changes.number)});
        if (!rows)
            return tl::unexpected(rows.error());
        QVector<QVariantMap>& list = row.children[table];
        for (const QVariantList& one : rows->rows)
            list.append(toValueMap(one, child.columns, child.ofServo, bytes));
    }
    return row;
}
} // namespace

base::Result<QString> HistoryChanges::bench() const
{
    const auto found = m_file.run(QStringLiteral("SELECT value FROM about WHERE name = 'bench'"));
    if (!found)
        return tl::unexpected(found.error());
    if (found->rows.empty())
        return base::fail(base::ErrorCode::FileFormat, QStringLiteral("history"), m_file.path());
    return found->rows.front().value(0).toString();
}

base::Result<std::int64_t> HistoryChanges::revision() const
{
    const auto found = m_file.run(QStringLiteral("SELECT MAX(revision) FROM clock"));
    if (!found)
        return tl::unexpected(found.error());
    return found->rows.front().value(0).toLongLong();
}

base::Result<std::vector<ChangedRow>> HistoryChanges::after(std::int64_t revision, int limit,
                                                            qint64 bytes) const
{
    const auto changes = changesAfter(m_file, revision, limit);
    if (!changes)
        return tl::unexpected(changes.error());
    std::vector<ChangedRow> rows;
    qint64 size = 0;
    for (const ChangeEntry& one : *changes) {
        if (!rows.empty() && size >= bytes)
            break;
        if (one.number == 0) {
            rows.push_back({one.revision, one.table, one.uuid, true, {}, {}});
            continue;
        }
        auto row = readRow(m_file, one, size);
        if (!row)
            return tl::unexpected(row.error());
        if (*row)
            rows.push_back(std::move(**row));
    }
    return rows;
}

base::Result<std::int64_t> HistoryChanges::pendingCount(std::int64_t revision) const
{
    QStringList parts;
    for (const QString& table : syncedTables())
        parts.append(QStringLiteral("(SELECT COUNT(*) FROM %1 WHERE revision > %2)")
                         .arg(table)
                         .arg(qint64(revision)));
    parts.append(
        QStringLiteral("(SELECT COUNT(*) FROM removed WHERE revision > %1)").arg(qint64(revision)));
    const auto counted = m_file.run(QStringLiteral("SELECT ") + parts.join(QStringLiteral(" + ")));
    if (!counted)
        return tl::unexpected(counted.error());
    return counted->rows.front().value(0).toLongLong();
}
} // namespace history

// SPDX-License-Identifier: GPL-3.0-or-later
// Many rows per statement: a round trip takes milliseconds, and a history has a million rows.
#include "history/server/history_server_writer.h"

#include "history/server/history_server_schema.h"

#include <QDateTime>

#include <algorithm>

namespace history {
namespace {
constexpr std::size_t maxRowsPerStatement = 200;
constexpr qint64 maxBytesPerStatement = qint64(4) << 20; ///< of blobs in one statement

QString quotedName(const QString& name)
{
    return u'"' + name + u'"';
}

qint64 now()
{
    return QDateTime::currentMSecsSinceEpoch();
}

/// Rows to insert into one table, as values in place of `?`.
class InsertStatement {
public:
    /// `then` follows the values. Each row has a value for each of `columns`; a servo's is
    /// its uuid.
    InsertStatement(const HistoryServer& server, const char* table, QStringList columns,
                    QString suffix)
        : m_server(server)
        , m_table(QString::fromLatin1(table))
        , m_columns(std::move(columns))
        , m_suffix(std::move(suffix))
    {
        QStringList placeholders;
        for (const QString& column : m_columns)
            placeholders.append(column == QLatin1String("servo")
                                    ? QStringLiteral("(SELECT number FROM servos WHERE uuid = ?)")
                                    : QStringLiteral("?"));
        m_placeholders = u'(' + placeholders.join(QStringLiteral(", ")) + u')';
    }

    base::Result<void> add(const QVariantList& row)
    {
        m_values += row;
        ++m_rows;
        for (const QVariant& value : row)
            m_bytes += value.typeId() == QMetaType::QByteArray ? value.toByteArray().size() : 0;
        return m_rows < maxRowsPerStatement && m_bytes < maxBytesPerStatement ? base::Result<void>()
                                                                              : flush();
    }

    base::Result<void> flush()
    {
        if (m_rows == 0)
            return {};
        QStringList names;
        for (const QString& column : m_columns)
            names.append(quotedName(column));
        const QStringList placeholders(qsizetype(m_rows), m_placeholders);
        const auto done =
            m_server.run(QStringLiteral("INSERT INTO ") + m_table + QStringLiteral(" (") +
                             names.join(QStringLiteral(", ")) + QStringLiteral(") VALUES ") +
                             placeholders.join(QStringLiteral(", ")) + u' ' + m_suffix,
                         m_values);
        m_values.clear();
        m_rows = 0;
        m_bytes = 0;
        if (!done)
            return tl::unexpected(done.error());
        m_answers.insert(m_answers.end(), done->rows.begin(), done->rows.end());
        return {};
    }

    const std::vector<QVariantList>& answers() const { return m_answers; }

private:
    const HistoryServer& m_server;
    const QString m_table;
    const QStringList m_columns;
    const QString m_suffix;
    QString m_placeholders;
    QVariantList m_values;
    std::size_t m_rows = 0;
    qint64 m_bytes = 0;
    std::vector<QVariantList> m_answers;
};

using Rows = std::vector<const ChangedRow*>;

QString upsertClause(const QStringList& columns, const QString& unique)
{
    QStringList sets;
    for (const QString& column : columns)
        sets.append(QStringLiteral("%1 = excluded.%1").arg(quotedName(column)));
    return QStringLiteral("ON CONFLICT (%1) DO UPDATE SET ").arg(unique) +
           sets.join(QStringLiteral(", "));
}

/// Rows of a servo that the server does not have yet: it comes with a later revision.
base::Result<void> insertServos(const HistoryServer& server, std::int64_t bench, const Rows& rows)
{
    QStringList uuids;
    const auto collectUuid = [&](const QVariantMap& values) {
        const QString uuid = values.value(QStringLiteral("servo_uuid")).toString();
        if (!uuid.isEmpty())
            uuids.append(uuid);
    };
    for (const ChangedRow* row : rows) {
        collectUuid(row->values);
        for (const QVector<QVariantMap>& children : row->children)
            std::for_each(children.begin(), children.end(), collectUuid);
    }
    uuids.removeDuplicates();
    InsertStatement insert(server, "servos", {QStringLiteral("uuid"), QStringLiteral("bench")},
                           QStringLiteral("ON CONFLICT (uuid) DO NOTHING"));
    for (const QString& uuid : uuids) {
        if (const auto added = insert.add({uuid, qint64(bench)}); !added)
            return added;
    }
    return insert.flush();
}

QVariantList valuesOf(const QVariantMap& values, const QStringList& columns)
{
    QVariantList list;
    for (const QString& column : columns)
        list.append(values.value(column));
    return list;
}

/// Replaces the children of the rows by their order; surplus children are deleted.
base::Result<void> upsertChildren(const HistoryServer& server, const ServerTable::Child& child,
                                  std::int64_t bench, const Rows& rows,
                                  const QMap<QString, qint64>& numbers)
{
    QVariantList fixed;
    QStringList columns{QString::fromLatin1(child.parent)};
    if (child.ofServo)
        columns.append(QStringLiteral("servo"));
    if (child.ofBench) {
        columns.append(QStringLiteral("bench"));
        fixed.append(qint64(bench));
    }
    const QString order = QString::fromLatin1(child.order);
    InsertStatement insert(
        server, child.name, columns + child.columns,
        upsertClause(columns.mid(1) + child.columns,
                     QString::fromLatin1(child.parent) + QStringLiteral(", ") + order));
    QStringList ends;
    for (const ChangedRow* row : rows) {
        const qint64 parent = numbers.value(row->uuid);
        const QVector<QVariantMap> children = row->children.value(QString::fromLatin1(child.name));
        qint64 last = -1;
        for (const QVariantMap& values : children) {
            QVariantList list{parent};
            if (child.ofServo)
                list.append(values.value(QStringLiteral("servo_uuid")));
            list += fixed + valuesOf(values, child.columns);
            last = std::max(last, values.value(order).toLongLong());
            if (const auto added = insert.add(list); !added)
                return added;
        }
        ends.append(QStringLiteral("(%1, %2)").arg(parent).arg(last));
    }
    if (const auto done = insert.flush(); !done || ends.isEmpty())
        return done;
    const auto rest =
        server.run(QStringLiteral("DELETE FROM %1 USING (VALUES %2) v (parent, last) "
                                  "WHERE %3 = v.parent AND %4 > v.last")
                       .arg(QString::fromLatin1(child.name), ends.join(QStringLiteral(", ")),
                            QString::fromLatin1(child.parent), order));
    return rest ? base::Result<void>() : tl::unexpected(rest.error());
}

base::Result<void> upsertRows(const HistoryServer& server, const ServerTable& table,
                              std::int64_t bench, const Rows& rows)
{
    QStringList columns{QStringLiteral("bench")};
    if (table.ofServo)
        columns.append(QStringLiteral("servo"));
    InsertStatement insert(server, table.name,
                           QStringList{QStringLiteral("uuid")} + columns + table.columns,
                           upsertClause(columns + table.columns, QStringLiteral("uuid")) +
                               QStringLiteral(" RETURNING uuid, number"));
    for (const ChangedRow* row : rows) {
        QVariantList list{row->uuid, qint64(bench)};
        if (table.ofServo)
            list.append(row->values.value(QStringLiteral("servo_uuid")));
        if (const auto added = insert.add(list + valuesOf(row->values, table.columns)); !added)
            return added;
    }
    if (const auto done = insert.flush(); !done)
        return done;
    QMap<QString, qint64> numbers;
    for (const QVariantList& answer : insert.answers())
        numbers.insert(answer.value(0).toString(), answer.value(1).toLongLong());
    for (const ServerTable::Child& child : table.children) {
        if (const auto put = upsertChildren(server, child, bench, rows, numbers); !put)
            return put;
    }
    return {};
}

base::Result<void> removeRows(const HistoryServer& server, const ServerTable& table,
                              std::int64_t bench, const Rows& rows)
{
    if (rows.empty())
        return {};
    QVariantList values{qint64(bench)};
    for (const ChangedRow* row : rows)
        values.append(row->uuid);
    const QStringList placeholders(qsizetype(rows.size()), QStringLiteral("?"));
    const auto deleted =
        server.run(QStringLiteral("DELETE FROM %1 WHERE bench = ? AND uuid IN (%2)")
                       .arg(QString::fromLatin1(table.name), placeholders.join(u',')),
                   values);
    return deleted ? base::Result<void>() : tl::unexpected(deleted.error());
}
} // namespace

base::Result<std::int64_t> HistoryServerWriter::registerBench()
{
    const auto known = m_server.run(
        QStringLiteral("INSERT INTO benches (uuid, name, program, sent) VALUES (?, ?, ?, ?) "
                       "ON CONFLICT (uuid) DO UPDATE SET name = excluded.name, "
                       "program = excluded.program RETURNING number"),
        {m_sender.bench, m_sender.name, m_sender.program, now()});
    if (!known)
        return tl::unexpected(known.error());
    m_bench = known->rows.front().value(0).toLongLong();
    const auto begun =
        m_server.run(QStringLiteral("INSERT INTO progress (bench, origin, revision) VALUES "
                                    "(?, ?, 0) ON CONFLICT DO NOTHING"),
                     {qint64(m_bench), m_sender.origin});
    if (!begun)
        return tl::unexpected(begun.error());
    const auto reached =
        m_server.run(QStringLiteral("SELECT revision FROM progress WHERE bench = ? AND origin = ?"),
                     {qint64(m_bench), m_sender.origin});
    if (!reached)
        return tl::unexpected(reached.error());
    return reached->rows.front().value(0).toLongLong();
}

base::Result<void> HistoryServerWriter::restart()
{
    const auto done = m_server.run(
        QStringLiteral("UPDATE progress SET revision = 0 WHERE bench = ? AND origin = ?"),
        {qint64(m_bench), m_sender.origin});
    return done ? base::Result<void>() : tl::unexpected(done.error());
}

base::Result<std::int64_t> HistoryServerWriter::apply(const std::vector<ChangedRow>& rows,
                                                      std::int64_t from, std::int64_t until)
{
    std::int64_t reached = from;
    const auto done = m_server.transaction([&]() -> base::Result<void> {
        const auto present =
            m_server.run(QStringLiteral("SELECT revision FROM progress WHERE bench = ? AND "
                                        "origin = ? FOR UPDATE"),
                         {qint64(m_bench), m_sender.origin});
        if (!present)
            return tl::unexpected(present.error());
        reached = present->rows.empty() ? 0 : present->rows.front().value(0).toLongLong();
        if (reached != from)
            return {};
        if (const auto applied = applyRows(rows); !applied)
            return applied;
        reached = until;
        const auto marked =
            m_server.run(QStringLiteral("UPDATE progress SET revision = ? WHERE bench = ? AND "
                                        "origin = ?"),
                         {qint64(until), qint64(m_bench), m_sender.origin});
        if (!marked)
            return tl::unexpected(marked.error());
        const auto sent = m_server.run(QStringLiteral("UPDATE benches SET sent = ? WHERE number "
                                                      "= ?"),
                                       {now(), qint64(m_bench)});
        return sent ? base::Result<void>() : tl::unexpected(sent.error());
    });
    if (!done)
        return tl::unexpected(done.error());
    return reached;
}

base::Result<void> HistoryServerWriter::applyRows(const std::vector<ChangedRow>& rows) const
{
    Rows present;
    for (const ChangedRow& row : rows) {
        if (!row.removed)
            present.push_back(&row);
    }
    if (const auto named = insertServos(m_server, m_bench, present); !named)
        return named;
    for (const ServerTable& table : serverTables()) {
        Rows presentRows;
        Rows deleted;
        for (const ChangedRow& row : rows) {
            if (row.table == QLatin1String(table.name))
                (row.removed ? deleted : presentRows).push_back(&row);
        }
        if (const auto put = upsertRows(m_server, table, m_bench, presentRows); !put)
            return put;
        if (const auto removed = removeRows(m_server, table, m_bench, deleted); !removed)
            return removed;
    }
    return {};
}
} // namespace history

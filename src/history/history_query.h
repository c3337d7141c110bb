// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the readers of the history: conditions with their values, times, and the
// servos that match a filter. Internal to history. Errors of history/history_file.h.
#pragma once

#include "history/history_file.h"
#include "history/history_rows.h"

#include <QUuid>
#include <QVariant>

#include <algorithm>
#include <vector>

namespace history {
/// An SQL NULL is not an empty text.
inline QString nonNull(const QString& text)
{
    return text.isNull() ? QStringLiteral("") : text;
}

/// Identifies a row in every copy of the history.
inline QString newUuid()
{
    return QUuid::createUuid().toString(QUuid::WithoutBraces);
}

inline QDateTime readTime(const QVariant& value)
{
    return value.isNull() ? QDateTime()
                          : QDateTime::fromMSecsSinceEpoch(value.toLongLong(), Qt::UTC);
}

tl::unexpected<base::Error> notFoundError(const QString& what, std::int64_t number);

struct SqlConditions {
    QStringList conditions{};
    QVariantList values{};

    void add(const QString& condition, const QVariantList& with = {});
    /// "" or " WHERE a AND b"
    QString where() const;
};

/// Time span and page, as they are the same for every list.
SqlConditions toConditions(const HistoryFilter& filter);

/// The numbers of the servos the filter names; nullopt: it names none, all are meant.
base::Result<std::optional<std::vector<std::int64_t>>> matchingServos(const HistoryFile& file,
                                                                      const HistoryFilter& filter);

/// Newest first: all of `table` that fits, up to `filter.limit`. Each servo is a query of its
/// own, so that an index is used; `rows` makes the whole SELECT around the inner one.
base::Result<std::vector<QVariantList>>
readPage(const HistoryFile& file, const HistoryFilter& filter, const QString& table,
         const SqlConditions& extra, const std::function<QString(const QString& inner)>& rows);

/// Rows of several servos in one order, at most `limit`.
template <typename Row>
std::vector<Row> newestFirst(const std::vector<QVariantList>& rows,
                             Row (*rowIn)(const QVariantList& row), int limit)
{
    std::vector<Row> all;
    all.reserve(rows.size());
    for (const QVariantList& row : rows)
        all.push_back(rowIn(row));
    std::stable_sort(all.begin(), all.end(), [](const Row& a, const Row& b) {
        return a.at != b.at ? a.at > b.at : a.number > b.number;
    });
    if (all.size() > std::size_t(std::max(limit, 0)))
        all.erase(all.begin() + std::max(limit, 0), all.end());
    return all;
}

/// "1, 2, 3"; for none "-1", which no row has.
QString numberList(const std::vector<std::int64_t>& numbers);

/// A SELECT's columns of servos in the order readServoRow() takes them, from the alias s.
QString servoColumns();
constexpr int servoColumnCount = 11;
HistoryServo readServoRow(const QVariantList& row, int from = 0);
} // namespace history

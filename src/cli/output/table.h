// SPDX-License-Identifier: GPL-3.0-or-later
// Aligned columns for a terminal, where Chinese characters take two cells. A value; any thread;
// never fails.
#pragma once

#include <QDateTime>
#include <QSet>
#include <QStringList>

#include <vector>

namespace cli {
/// For a cell without a value.
inline QString noValue()
{
    return QStringLiteral("–");
}

/// "2026-11-22 10:30:05", in the time zone of the computer.
QString localTime(const QDateTime& at);

/// Cells that a text takes on a terminal.
int displayWidth(const QString& text);

/// Padded with blanks to `width` cells.
QString padded(const QString& text, int width, bool right = false);

class Table {
public:
    explicit Table(QStringList header)
        : m_header(std::move(header))
    {}

    /// For numbers.
    Table& alignRight(const QSet<int>& columns);
    void add(QStringList row) { m_rows.push_back(std::move(row)); }
    bool empty() const { return m_rows.empty(); }

    /// Lines without trailing blanks, each with a line feed.
    QString text() const;

private:
    QStringList m_header;
    std::vector<QStringList> m_rows;
    QSet<int> m_right;
};
} // namespace cli

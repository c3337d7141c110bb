// SPDX-License-Identifier: GPL-3.0-or-later
// Aligned columns for a terminal. Chinese characters take two cells there, which printf does not
// know. A value; any thread; never fails.
#pragma once

#include <QSet>
#include <QStringList>

#include <vector>

namespace cli {
/// Cells a text takes on a terminal.
int displayWidth(const QString& text);

/// Filled up with blanks to `width` cells.
QString padded(const QString& text, int width, bool right = false);

class Table {
public:
    explicit Table(QStringList header)
        : m_header(std::move(header))
    {}

    /// Numbers stand to the right.
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

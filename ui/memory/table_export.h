// SPDX-License-Identifier: GPL-3.0-or-later
// A table as text for other programs and for paper: CSV, self-contained HTML, or tab-separated
// rows. Cells are taken as data, never as markup or formulas. Pure functions; any thread.
#pragma once

#include <QStringList>

#include <vector>

namespace ui {
struct TableSheet {
    QString title;
    QStringList captionLines; ///< lines above the table: servo, port, time
    QStringList headers;
    std::vector<QStringList> rows;
    std::vector<bool> numeric; ///< by column: right-aligned; shorter: false
};

/// RFC 4180 in UTF-8 with its mark, which spreadsheets need for Chinese. The title and `about` are
/// left out: one header line, then data.
QByteArray toCsv(const TableSheet& sheet);

/// One file without references to others.
QByteArray toHtml(const TableSheet& sheet);

/// Header and rows for the clipboard. Tabs and line breaks in cells become blanks.
QString toTsv(const TableSheet& sheet);
} // namespace ui

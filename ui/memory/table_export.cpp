// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/table_export.h"

#include "files/csv_text.h"

namespace ui {
namespace {
const char* const style =
    "body{font-family:\"Noto Sans\",\"Noto Sans CJK SC\",sans-serif;font-size:10pt;color:#1f2430;"
    "background:#fff;margin:2em}"
    "h1{font-size:14pt;margin:0 0 .3em}p{margin:.1em 0;color:#5d6675}"
    "table{border-collapse:collapse;margin-top:1em}"
    "th,td{padding:3px 8px;border-bottom:1px solid #c9ced6;text-align:left;vertical-align:top}"
    "th{font-weight:600}td.n,th.n{text-align:right}";

QString htmlRow(const QStringList& cells, const QString& tag, const std::vector<bool>& numeric)
{
    QString row = QStringLiteral("<tr>");
    for (qsizetype i = 0; i < cells.size(); ++i) {
        const auto column = static_cast<std::size_t>(i);
        const bool right = column < numeric.size() && numeric[column];
        row +=
            QStringLiteral("<%1%2>").arg(tag, right ? QStringLiteral(" class=\"n\"") : QString());
        row += cells[i].toHtmlEscaped();
        row += QStringLiteral("</%1>").arg(tag);
    }
    return row + QStringLiteral("</tr>\n");
}

QString tsvLine(const QStringList& cells)
{
    QStringList line;
    for (const QString& cell : cells)
        line << cell.simplified();
    return line.join(QLatin1Char('\t')) + QLatin1Char('\n');
}
} // namespace

QByteArray toCsv(const TableSheet& sheet)
{
    QByteArray text =
        files::csvStart(files::CsvReader::Spreadsheet) + files::csvLine(sheet.headers);
    for (const QStringList& row : sheet.rows)
        text += files::csvLine(row);
    return text;
}

QByteArray toHtml(const TableSheet& sheet)
{
    QString page = QStringLiteral("<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1"
                                  "</title>\n<style>%2</style></head><body>\n<h1>%1</h1>\n")
                       .arg(sheet.title.toHtmlEscaped(), QLatin1String(style));
    for (const QString& line : sheet.captionLines)
        page += QStringLiteral("<p>") + line.toHtmlEscaped() + QStringLiteral("</p>\n");
    page += QStringLiteral("<table>\n<thead>\n");
    page += htmlRow(sheet.headers, QStringLiteral("th"), sheet.numeric);
    page += QStringLiteral("</thead>\n<tbody>\n");
    for (const QStringList& row : sheet.rows)
        page += htmlRow(row, QStringLiteral("td"), sheet.numeric);
    page += QStringLiteral("</tbody>\n</table>\n</body></html>\n");
    return page.toUtf8();
}

QString toTsv(const TableSheet& sheet)
{
    QString text = tsvLine(sheet.headers);
    for (const QStringList& row : sheet.rows)
        text += tsvLine(row);
    return text;
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/csv_text.h"

#include <QByteArrayList>
#include <QLocale>

#include <cmath>

namespace files {
namespace {
/// "-5" and "+5" are numbers, "-5+cmd" and "=1" are not.
bool looksLikeFormula(const QString& cell)
{
    if (cell.isEmpty() || !QStringLiteral("=+-@\t\r").contains(cell.front()))
        return false;
    bool number = false;
    cell.toDouble(&number);
    return !number;
}
} // namespace

QByteArray csvStart(CsvReader reader)
{
    return reader == CsvReader::Spreadsheet ? QByteArrayLiteral("\xEF\xBB\xBF") : QByteArray();
}

QByteArray csvText(const QString& cell)
{
    QString text = looksLikeFormula(cell) ? QLatin1Char('\'') + cell : cell;
    const bool quoted = text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')) ||
                        text.contains(QLatin1Char('\n')) || text.contains(QLatin1Char('\r'));
    if (!quoted)
        return text.toUtf8();
    return '"' + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")).toUtf8() + '"';
}

QByteArray csvNumber(std::optional<double> value)
{
    return value && std::isfinite(*value)
               ? QByteArray::number(*value, 'g', QLocale::FloatingPointShortest)
               : QByteArray();
}

QByteArray csvLine(const QStringList& cells)
{
    QByteArrayList texts;
    for (const QString& cell : cells)
        texts << csvText(cell);
    return texts.join(',') + '\n';
}
} // namespace files

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/table.h"

#include "cli/output/terminal_text.h"

#include <algorithm>
#include <array>

namespace cli {
namespace {
struct Span {
    char32_t first, last;
};

// The East Asian wide and full-width blocks that names and help texts use.
constexpr std::array wide{Span{0x1100, 0x115f},   Span{0x2e80, 0x303e},  Span{0x3041, 0x33ff},
                          Span{0x3400, 0x4dbf},   Span{0x4e00, 0x9fff},  Span{0xa000, 0xa4cf},
                          Span{0xac00, 0xd7a3},   Span{0xf900, 0xfaff},  Span{0xfe30, 0xfe4f},
                          Span{0xff00, 0xff60},   Span{0xffe0, 0xffe6},  Span{0x1f300, 0x1f64f},
                          Span{0x20000, 0x2fffd}, Span{0x30000, 0x3fffd}};

int cells(char32_t c)
{
    const bool isWide = std::any_of(wide.begin(), wide.end(),
                                    [c](const Span& s) { return c >= s.first && c <= s.last; });
    if (isWide)
        return 2;
    const auto category = QChar::category(c);
    return category == QChar::Mark_NonSpacing || category == QChar::Other_Format ? 0 : 1;
}

QString withoutTrailingBlanks(QString line)
{
    while (line.endsWith(QLatin1Char(' ')))
        line.chop(1);
    return line;
}
} // namespace

QString localTime(const QDateTime& at)
{
    return at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

int displayWidth(const QString& text)
{
    int width = 0;
    for (const char32_t c : text.toUcs4())
        width += cells(c);
    return width;
}

QString padded(const QString& text, int width, bool right)
{
    const QString blanks(std::max(0, width - displayWidth(text)), QLatin1Char(' '));
    return right ? blanks + text : text + blanks;
}

Table& Table::alignRight(const QSet<int>& columns)
{
    m_right = columns;
    return *this;
}

QString Table::text() const
{
    std::vector<QStringList> lines{m_header};
    lines.insert(lines.end(), m_rows.begin(), m_rows.end());
    // A line feed in a cell would start a new row.
    for (QStringList& line : lines) {
        for (QString& cell : line)
            cell = terminalSafe(cell).replace(QLatin1Char('\n'), QLatin1Char(' '));
    }
    std::vector<int> widths(static_cast<std::size_t>(m_header.size()), 0);
    for (const QStringList& line : lines) {
        for (std::size_t i = 0; i < widths.size(); ++i)
            widths[i] = std::max(widths[i], displayWidth(line.value(static_cast<int>(i))));
    }
    QString out;
    for (const QStringList& line : lines) {
        QStringList cellTexts;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            const int column = static_cast<int>(i);
            cellTexts << padded(line.value(column), widths[i], m_right.contains(column));
        }
        out += withoutTrailingBlanks(cellTexts.join(QStringLiteral("  "))) + QLatin1Char('\n');
    }
    return out;
}
} // namespace cli

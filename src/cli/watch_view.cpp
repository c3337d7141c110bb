// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watch_view.h"

#include "cli/table.h"
#include "cli/translate.h"
#include "text/language.h"
#include "text/notice_words.h"

#include <algorithm>

namespace cli {
namespace {
constexpr auto redrawEvery = std::chrono::milliseconds(100);
constexpr int timeWidth = 8;
constexpr int idWidth = 4;
constexpr int valueWidth = 8;

QString title(const jobs::WatchColumn& column)
{
    QString key = column.key;
    key.remove(QLatin1String("present_"));
    return column.unit.isEmpty() ? key : QStringLiteral("%1[%2]").arg(key, column.unit);
}

QString shortened(const QString& line, int width)
{
    QString cut = line;
    while (width > 0 && displayWidth(cut) >= width)
        cut.chop(1);
    return cut;
}
} // namespace

WatchView::WatchView(Console& console, const jobs::WatchSpec& spec, bool quiet)
    : m_console(console)
    , m_columns(jobs::watchColumns(spec))
    , m_inPlace(console.resultTerminal())
    , m_quiet(console.json() || (quiet && !m_inPlace))
{
    for (const jobs::WatchColumn& column : m_columns)
        m_widths.push_back(std::max(valueWidth, displayWidth(title(column))));
    for (const device::Servo& servo : spec.servos)
        m_profiles[servo.id] = servo.profile;
}

QString WatchView::header() const
{
    QString text = padded(translate("cli", "time[s]"), timeWidth, true) +
                   padded(translate("cli", "ID"), idWidth + 1, true);
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        text += QStringLiteral("  ") + padded(title(m_columns[i]), m_widths[i], true);
    return text + QStringLiteral("  ") + translate("cli", "alarms");
}

QString WatchView::line(const jobs::WatchRow& row) const
{
    const double seconds = std::chrono::duration<double>(row.at - *m_start).count();
    QString text = padded(QString::number(seconds, 'f', 3), timeWidth, true) +
                   padded(QString::number(row.id), idWidth + 1, true);
    if (!row.answered)
        return text + QStringLiteral("  ") + translate("cli", "no answer");
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const auto value = i < row.values.size() ? row.values[i] : std::nullopt;
        const int decimals = m_columns[i].unit.isEmpty() ? 0 : 1;
        text += QStringLiteral("  ") +
                padded(value ? QString::number(*value, 'f', decimals) : QStringLiteral("–"),
                       m_widths[i], true);
    }
    const auto profile = m_profiles.find(row.id);
    return text + QStringLiteral("  ") +
           text::statusWords(row.status,
                             profile != m_profiles.end() ? profile->second.get() : nullptr,
                             text::inChinese());
}

void WatchView::add(const jobs::WatchRow& row)
{
    if (m_quiet)
        return;
    if (!m_start)
        m_start = row.at;
    if (m_inPlace) {
        m_latest[row.id] = row;
        if (Clock::now() >= m_next)
            redraw();
        return;
    }
    if (!m_headed)
        m_console.print(header() + QLatin1Char('\n'));
    m_headed = true;
    m_console.print(line(row) + QLatin1Char('\n'));
}

void WatchView::redraw()
{
    const int width = m_console.terminalWidth();
    QString screen;
    if (m_drawn > 0)
        screen += QStringLiteral("\033[%1A").arg(m_drawn);
    const auto put = [&screen, width](const QString& text) {
        screen += QStringLiteral("\r\033[K") + shortened(text, width) + QLatin1Char('\n');
    };
    put(header());
    for (const auto& [id, row] : m_latest)
        put(line(row));
    m_console.print(screen);
    m_drawn = static_cast<int>(m_latest.size()) + 1;
    m_next = Clock::now() + redrawEvery;
}

void WatchView::finish()
{
    if (m_inPlace && !m_quiet && !m_latest.empty())
        redraw();
}
} // namespace cli

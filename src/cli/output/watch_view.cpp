// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/watch_view.h"

#include "cli/output/table.h"
#include "cli/translate.h"
#include "text/language.h"
#include "text/notice_text.h"

#include <algorithm>

namespace cli {
namespace {
constexpr auto redrawInterval = std::chrono::milliseconds(100);
constexpr int timeWidth = 8;
constexpr int idWidth = 5;
constexpr int alarmsWidth = 9;
constexpr int valueWidth = 8;

QString title(const jobs::WatchColumn& column)
{
    QString key = column.key;
    key.remove(QLatin1String("present_")).remove(QLatin1String("active_"));
    QString unit = column.unit;
    unit.replace(QLatin1String("deg"), QStringLiteral("°"));
    return unit.isEmpty() ? key : QStringLiteral("%1[%2]").arg(key, unit);
}

/// Without flags and states, which are in the alarms or mean little among numbers.
bool isNumber(const jobs::WatchSpec& spec, const jobs::WatchColumn& column)
{
    for (const device::Servo& servo : spec.servos) {
        const catalog::Register* reg = servo.profile->find(column.key);
        if (reg != nullptr)
            return reg->encoding != catalog::Encoding::Bits &&
                   reg->encoding != catalog::Encoding::Enum;
    }
    return false;
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
    , m_inPlace(console.isStdoutTerminal())
    , m_quiet(console.isJson() || (quiet && !m_inPlace))
{
    const auto columns = jobs::watchColumns(spec);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const QString text = title(columns[i]);
        if (isNumber(spec, columns[i]))
            m_columns.push_back({i, text, std::max(valueWidth, displayWidth(text))});
    }
    for (const device::Servo& servo : spec.servos)
        m_profiles[servo.id] = servo.profile;
}

QString WatchView::header() const
{
    QString text = padded(translate("cli", "time[s]"), timeWidth, true) +
                   padded(translate("cli", "ID"), idWidth, true) + QStringLiteral("  ") +
                   padded(translate("cli", "alarms"), alarmsWidth);
    for (const Column& column : m_columns)
        text += QStringLiteral("  ") + padded(column.title, column.width, true);
    return text;
}

QString WatchView::line(const jobs::WatchRow& row) const
{
    const double seconds = std::chrono::duration<double>(row.at - *m_start).count();
    const auto profile = m_profiles.find(row.id);
    const catalog::Profile* known = profile != m_profiles.end() ? profile->second.get() : nullptr;
    const QString state = !row.answered                 ? translate("cli", "no reply")
                          : !text::reportsAlarms(known) ? noValue()
                                                        : text::statusText(row.status, known);
    QString text = padded(QString::number(seconds, 'f', 3), timeWidth, true) +
                   padded(QString::number(row.id), idWidth, true) + QStringLiteral("  ") +
                   padded(state, alarmsWidth);
    for (const Column& column : m_columns) {
        const auto value =
            column.place < row.values.size() ? row.values[column.place] : std::nullopt;
        text += QStringLiteral("  ") +
                padded(value ? QString::number(*value, 'f', 1) : noValue(), column.width, true);
    }
    return text;
}

void WatchView::add(const jobs::WatchRow& row)
{
    if (m_quiet)
        return;
    if (!m_start)
        m_start = row.at;
    if (m_inPlace) {
        remember(row);
        if (Clock::now() >= m_next)
            redraw();
        return;
    }
    if (!m_headerShown)
        m_console.print(header() + QLatin1Char('\n'));
    m_headerShown = true;
    m_console.print(line(row) + QLatin1Char('\n'));
}

/// Values that are not read in every cycle keep their latest reading.
void WatchView::remember(const jobs::WatchRow& row)
{
    jobs::WatchRow& shown = m_latest[row.id];
    const auto earlier = std::exchange(shown, row).values;
    for (std::size_t i = 0; row.answered && i < std::min(earlier.size(), row.values.size()); ++i) {
        if (!shown.values[i])
            shown.values[i] = earlier[i];
    }
}

void WatchView::redraw()
{
    const int width = m_console.terminalWidth();
    QStringList lines{shortened(header(), width)};
    for (const auto& [id, row] : m_latest)
        lines << shortened(line(row), width);
    m_console.rewrite(m_drawn, lines);
    m_drawn = static_cast<int>(m_latest.size()) + 1;
    m_next = Clock::now() + redrawInterval;
}

void WatchView::finish()
{
    if (m_inPlace && !m_quiet && !m_latest.empty())
        redraw();
}
} // namespace cli

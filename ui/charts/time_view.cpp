// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/time_view.h"

#include <algorithm>

namespace ui {
using base::Duration;

bool TimeView::advance(Duration now)
{
    m_now = now;
    if (!m_following)
        return false;
    const Duration wide = width();
    const record::TimeSpan before = m_span;
    m_span = {now - wide, now};
    return !(m_span == before);
}

void TimeView::follow(bool on)
{
    m_following = on;
    if (on)
        advance(m_now);
}

void TimeView::show(record::TimeSpan span)
{
    m_following = false;
    if (span.to < span.from)
        std::swap(span.from, span.to);
    const Duration wanted = span.to - span.from;
    const Duration wide = std::clamp(wanted, narrowest, widest);
    const Duration middle = span.from + wanted / 2;
    m_span = wanted == wide ? span : record::TimeSpan{middle - wide / 2, middle - wide / 2 + wide};
}

void TimeView::setWidth(Duration wanted)
{
    const Duration wide = std::clamp(wanted, narrowest, widest);
    const Duration from = m_following ? m_span.to - wide : m_span.from + (width() - wide) / 2;
    m_span = {from, from + wide};
}

void TimeView::zoom(double factor, double place)
{
    const double pinned = m_following ? 1 : place;
    const auto wanted = Duration(std::int64_t(double(width().count()) * factor));
    const Duration wide = std::clamp(wanted, narrowest, widest);
    const Duration still = at(pinned);
    const Duration from = still - Duration(std::int64_t(double(wide.count()) * pinned));
    m_span = {m_following ? m_span.to - wide : from, m_following ? m_span.to : from + wide};
}

void TimeView::panBy(Duration by, const std::optional<record::TimeSpan>& kept)
{
    m_following = false;
    const Duration wide = width();
    Duration from = m_span.from + by;
    if (kept) {
        const Duration least = wide / 10;
        const Duration earliest = std::min(kept->from + least - wide, m_span.from);
        const Duration latest = std::max(kept->to - least, m_span.from);
        from = std::clamp(from, earliest, latest);
    }
    m_span = {from, from + wide};
}

Duration TimeView::at(double place) const
{
    return m_span.from + Duration(std::int64_t(double(width().count()) * place));
}

double TimeView::place(Duration at) const
{
    return double((at - m_span.from).count()) / double(width().count());
}
} // namespace ui

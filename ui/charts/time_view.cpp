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
    const Duration clampedWidth = width();
    const recording::TimeSpan before = m_span;
    m_span = {now - clampedWidth, now};
    return !(m_span == before);
}

void TimeView::setFollowing(bool on)
{
    m_following = on;
    if (on)
        advance(m_now);
}

void TimeView::show(recording::TimeSpan span)
{
    m_following = false;
    if (span.to < span.from)
        std::swap(span.from, span.to);
    const Duration requested = span.to - span.from;
    const Duration clampedWidth = std::clamp(requested, minWidth, maxWidth);
    const Duration middle = span.from + requested / 2;
    m_span = requested == clampedWidth
                 ? span
                 : recording::TimeSpan{middle - clampedWidth / 2,
                                       middle - clampedWidth / 2 + clampedWidth};
}

void TimeView::setWidth(Duration requested)
{
    const Duration clampedWidth = std::clamp(requested, minWidth, maxWidth);
    const Duration from =
        m_following ? m_span.to - clampedWidth : m_span.from + (width() - clampedWidth) / 2;
    m_span = {from, from + clampedWidth};
}

void TimeView::zoom(double factor, double place)
{
    const double fixedFraction = m_following ? 1 : place;
    const auto requested = Duration(std::int64_t(double(width().count()) * factor));
    const Duration clampedWidth = std::clamp(requested, minWidth, maxWidth);
    const Duration still = timeAt(fixedFraction);
    const Duration from =
        still - Duration(std::int64_t(double(clampedWidth.count()) * fixedFraction));
    m_span = {m_following ? m_span.to - clampedWidth : from,
              m_following ? m_span.to : from + clampedWidth};
}

void TimeView::panBy(Duration by, const std::optional<recording::TimeSpan>& bounds)
{
    m_following = false;
    const Duration clampedWidth = width();
    Duration from = m_span.from + by;
    if (bounds) {
        const Duration least = clampedWidth / 10;
        const Duration earliest = std::min(bounds->from + least - clampedWidth, m_span.from);
        const Duration latest = std::max(bounds->to - least, m_span.from);
        from = std::clamp(from, earliest, latest);
    }
    m_span = {from, from + clampedWidth};
}

Duration TimeView::timeAt(double place) const
{
    return m_span.from + Duration(std::int64_t(double(width().count()) * place));
}

double TimeView::fractionOf(Duration at) const
{
    return double((at - m_span.from).count()) / double(width().count());
}
} // namespace ui

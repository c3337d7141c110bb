// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_control.h"

#include <algorithm>

namespace ui {
using base::Duration;
using recording::TimeSpan;

namespace {
constexpr std::size_t maxStoredViews = 50;
constexpr qint64 oneTurn = 800; ///< ms; a turn of the wheel has many steps, but is one zoom
constexpr double fitMargin = 0.02;
constexpr double minBoxPart = 12; ///< pixels of a lane in a box that is meant for it
} // namespace

TrendControl::TrendControl(QObject* parent)
    : QObject(parent)
{}

void TrendControl::remember(Kind kind)
{
    const bool same = kind != Kind::Single && kind == m_lastKind && m_sinceZoom.isValid() &&
                      m_sinceZoom.elapsed() < oneTurn;
    m_lastKind = kind;
    m_sinceZoom.start();
    if (same)
        return;
    View view{m_state.view.isFollowing(), m_state.view.span(), {}};
    for (const TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (axis.range.isFixed())
            view.fixed.emplace_back(axis.range.unit(), axis.range.range());
    }
    m_previousViews.push_back(std::move(view));
    if (m_previousViews.size() > maxStoredViews)
        m_previousViews.erase(m_previousViews.begin());
}

void TrendControl::goBack()
{
    if (m_previousViews.empty())
        return;
    const View view = std::move(m_previousViews.back());
    m_previousViews.pop_back();
    m_sinceZoom.invalidate();
    if (view.following && m_state.live) {
        m_state.view.setFollowing(true);
        m_state.view.setWidth(view.span.to - view.span.from);
    } else {
        m_state.view.show(view.span);
    }
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        const auto found =
            std::find_if(view.fixed.begin(), view.fixed.end(),
                         [&](const auto& fixed) { return fixed.first == axis.range.unit(); });
        axis.range.setAutomatic();
        if (found != view.fixed.end())
            axis.fix(found->second);
    }
    Q_EMIT viewChanged();
}

void TrendControl::follow(bool on)
{
    if (on == m_state.view.isFollowing() || (on && !m_state.live))
        return;
    m_state.view.setFollowing(on);
    Q_EMIT viewChanged();
}

void TrendControl::setWidth(Duration width)
{
    if (width == m_state.view.width())
        return;
    m_state.view.setWidth(width);
    Q_EMIT viewChanged();
}

void TrendControl::show(const TimeSpan& span)
{
    remember(Kind::Single);
    drag(span);
}

void TrendControl::drag(const TimeSpan& span)
{
    m_state.view.show(span);
    Q_EMIT viewChanged();
}

void TrendControl::zoomToFit()
{
    remember(Kind::Single);
    const auto all = m_state.store != nullptr ? m_state.store->span() : std::nullopt;
    if (all) {
        const auto more = Duration(std::int64_t(double((all->to - all->from).count()) * fitMargin));
        m_state.view.show({all->from - more, all->to + more});
    }
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes())
        axis.range.setAutomatic();
    Q_EMIT viewChanged();
}

void TrendControl::fitValues(const QString& unit)
{
    remember(Kind::Single);
    m_axes->axisOf(unit).range.setAutomatic();
    Q_EMIT viewChanged();
}

template <typename Change>
void TrendControl::changeAxes(const QString* unit, Change change)
{
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (axis.used && (unit == nullptr || axis.range.unit() == *unit))
            axis.fix(change(axis.shown));
    }
}

void TrendControl::zoomToBox(const QRectF& shares)
{
    remember(Kind::Single);
    const TimeView& view = m_state.view;
    const double low = std::min(shares.top(), shares.bottom());
    const double high = std::max(shares.top(), shares.bottom());
    m_state.view.show({view.timeAt(shares.left()), view.timeAt(shares.right())});
    if (low > 0.001 || high < 0.999)
        zoomValuesTo(low, high);
    Q_EMIT viewChanged();
}

/// The part of the plot's height between these shares; lanes that it hardly touches stay.
void TrendControl::zoomValuesTo(double low, double high)
{
    const QRectF& plot = m_axes->plot();
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (!axis.used || axis.area.height() < 1)
            continue;
        const double top = std::max(axis.area.top(), plot.bottom() - high * plot.height());
        const double bottom = std::min(axis.area.bottom(), plot.bottom() - low * plot.height());
        if (bottom - top < minBoxPart)
            continue;
        const auto valueAt = [&](double y) {
            const double share = (axis.area.bottom() - y) / axis.area.height();
            return axis.shown.low + share * axis.shown.size();
        };
        axis.fix({valueAt(bottom), valueAt(top)});
    }
}

void TrendControl::pan(double x, double y)
{
    if (x != 0) {
        const auto by = Duration(std::int64_t(-x * double(m_state.view.width().count())));
        m_state.view.panBy(by, m_state.store != nullptr ? m_state.store->span() : std::nullopt);
    }
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (axis.used && axis.range.isFixed() && y != 0)
            moveAxis(axis, y);
    }
    Q_EMIT viewChanged();
}

void TrendControl::panValues(const QString* unit, double y)
{
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (axis.used && (unit == nullptr || axis.range.unit() == *unit))
            moveAxis(axis, y);
    }
    Q_EMIT viewChanged();
}

/// By a share of the plot's height.
void TrendControl::moveAxis(TrendAxes::ValueAxis& axis, double y)
{
    if (axis.area.height() < 1)
        return;
    const double by = y * m_axes->plot().height() / axis.area.height() * axis.shown.size();
    axis.fix({axis.shown.low - by, axis.shown.high - by});
}

void TrendControl::zoom(double factor, double place)
{
    remember(Kind::Wheel);
    m_state.view.zoom(factor, place);
    Q_EMIT viewChanged();
}

void TrendControl::zoomValues(const QString* unit, double factor, double place)
{
    remember(Kind::Values);
    changeAxes(unit, [&](const AxisRange& range) {
        const double pinned = range.low + std::clamp(place, 0.0, 1.0) * range.size();
        return AxisRange{pinned + (range.low - pinned) * factor,
                         pinned + (range.high - pinned) * factor};
    });
    Q_EMIT viewChanged();
}

void TrendControl::showEnd(bool newest)
{
    if (newest && m_state.live) {
        follow(true);
        return;
    }
    const auto all = m_state.store != nullptr ? m_state.store->span() : std::nullopt;
    if (!all)
        return;
    const Duration width = m_state.view.width();
    m_state.view.show(newest ? TimeSpan{all->to - width, all->to}
                             : TimeSpan{all->from, all->from + width});
    Q_EMIT viewChanged();
}

void TrendControl::showCursors(bool on)
{
    if (on == m_state.cursors.has_value())
        return;
    if (on)
        m_state.cursors = {m_state.view.timeAt(1.0 / 3), m_state.view.timeAt(2.0 / 3)};
    else
        m_state.cursors.reset();
    Q_EMIT cursorsChanged();
}

void TrendControl::setCursors(Duration a, Duration b)
{
    m_state.cursors = {a, b};
    Q_EMIT cursorsChanged();
}

void TrendControl::moveCursor(Cursor which, Duration to)
{
    if (!m_state.cursors)
        showCursors(true);
    m_movedCursor = which;
    (which == Cursor::A ? m_state.cursors->first : m_state.cursors->second) =
        std::clamp(to, m_state.view.span().from, m_state.view.span().to);
    Q_EMIT cursorsChanged();
}

void TrendControl::stepCursor(int samples)
{
    if (!m_state.cursors)
        return;
    const bool isA = m_movedCursor == Cursor::A;
    Duration at = isA ? m_state.cursors->first : m_state.cursors->second;
    for (int i = 0; i < std::abs(samples); ++i) {
        const auto to = neighborOf(at, samples > 0);
        if (!to)
            break;
        at = *to;
    }
    (isA ? m_state.cursors->first : m_state.cursors->second) = at;
    const TimeSpan span = m_state.view.span();
    if (at < span.from || at > span.to)
        drag({at - m_state.view.width() / 2, at + m_state.view.width() / 2});
    Q_EMIT cursorsChanged();
}

/// The sample before or after this instant that is nearest to it.
std::optional<Duration> TrendControl::neighborOf(Duration at, bool next) const
{
    std::optional<Duration> nearest;
    for (const TrendChannel& channel : m_state.channels) {
        if (!channel.visible || channel.id < 0 || m_state.store == nullptr)
            continue;
        const auto found =
            next ? m_state.store->after(channel.id, at) : m_state.store->before(channel.id, at);
        if (found && (!nearest || (next ? found->at < *nearest : found->at > *nearest)))
            nearest = found->at;
    }
    return nearest;
}
} // namespace ui

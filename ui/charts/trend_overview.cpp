// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_overview.h"

#include "ui/charts/palette.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {
using base::Duration;
using record::TimeSpan;

namespace {
constexpr int stripHeight = 40;
constexpr double border = 3;       ///< above and below the curves
constexpr double grip = 6;         ///< pixels around an edge of the handle
constexpr double leastHandle = 6;  ///< pixels painted at least
constexpr qint64 renewEvery = 700; ///< ms

/// Each curve as high as the strip: it is for recognising, not for reading.
void fillHeight(Trace& trace)
{
    bool any = false;
    double low = 0;
    double high = 0;
    for (const record::SampleColumn& column : trace.columns) {
        if (!std::isfinite(column.min) || !std::isfinite(column.max))
            continue;
        low = any ? std::min(low, column.min) : column.min;
        high = any ? std::max(high, column.max) : column.max;
        any = true;
    }
    const double more = std::max((high - low) * 0.03, std::abs(high) * 1e-3 + 1e-9);
    trace.look.low = low - more;
    trace.look.high = high + more;
}
} // namespace

TrendOverview::TrendOverview(const TrendState& state, QWidget* parent)
    : QWidget(parent)
    , m_state(state)
{
    setFixedHeight(stripHeight);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

QSize TrendOverview::sizeHint() const
{
    return {300, stripHeight};
}

void TrendOverview::setColours(const TrendColours& colours)
{
    m_colours = colours;
    rebuild();
}

void TrendOverview::rebuild()
{
    m_stale = true;
    m_fetching = false;
    update();
}

std::optional<TimeSpan> TrendOverview::history() const
{
    auto all = m_state.store != nullptr ? m_state.store->span() : std::nullopt;
    if (all && m_state.view.following())
        all->to = std::max(all->to, m_state.view.now());
    if (all && all->to <= all->from)
        all->to = all->from + Duration(1);
    return all;
}

/// One channel a call; when all are there, the picture changes at once.
void TrendOverview::advance(bool busy)
{
    const bool due = !m_sinceImage.isValid() || m_sinceImage.elapsed() > renewEvery;
    if (m_stale || (!m_shownHistory && history())) {
        if (begin()) { // at once: something else is to be seen
            while (m_fetching)
                fetchNext();
        }
    } else if (busy) {
        // the stretch that is shown changes all the time: the handle only
    } else if (m_fetching) {
        fetchNext();
    } else if (due && history() != m_shownHistory) {
        begin();
    }
    if (handle() != m_paintedHandle)
        update();
}

bool TrendOverview::begin()
{
    m_stale = false;
    const auto all = history();
    m_sinceImage.start();
    if (!all || width() < 2) {
        m_shownHistory.reset();
        m_image = {};
        update();
        return false;
    }
    m_nextHistory = *all;
    m_nextChannel = 0;
    m_traces.clear();
    m_fetching = true;
    return true;
}

void TrendOverview::fetchNext()
{
    const auto wanted = [](const TrendChannel& channel) {
        return channel.visible && channel.id >= 0;
    };
    const auto& channels = m_state.channels;
    while (m_nextChannel < channels.size() && !wanted(channels[m_nextChannel]))
        ++m_nextChannel;
    if (m_nextChannel >= channels.size() || m_state.store == nullptr) {
        finish();
        return;
    }
    const TrendChannel& channel = channels[m_nextChannel++];
    Trace trace;
    trace.look.colour = trendColourOn(channel.colour, m_colours.ground).rgb();
    trace.look.steps = channel.steps;
    m_state.store->columns(channel.id, m_nextHistory, width(), trace.columns);
    m_traces.push_back(std::move(trace));
}

void TrendOverview::finish()
{
    m_fetching = false;
    const double ratio = devicePixelRatioF();
    m_image = QImage((QSizeF(width(), height() - 2 * border) * ratio).toSize(),
                     QImage::Format_ARGB32_Premultiplied);
    for (Trace& trace : m_traces)
        fillHeight(trace);
    m_raster.paint(m_image, m_traces, m_nextHistory, {.width = ratio}, {0, m_image.width()});
    m_image.setDevicePixelRatio(ratio);
    m_shownHistory = m_nextHistory;
    m_sinceImage.start();
    update();
}

double TrendOverview::xOf(Duration at) const
{
    const TimeSpan& all = *m_shownHistory;
    return double((at - all.from).count()) / double((all.to - all.from).count()) * width();
}

Duration TrendOverview::timeAt(double x) const
{
    const TimeSpan& all = *m_shownHistory;
    return all.from + Duration(std::int64_t(x / width() * double((all.to - all.from).count())));
}

QRectF TrendOverview::handle() const
{
    if (!m_shownHistory)
        return {};
    double left = std::round(std::clamp(xOf(m_state.view.span().from), 0.0, double(width())));
    double right = std::round(std::clamp(xOf(m_state.view.span().to), 0.0, double(width())));
    if (right - left < leastHandle) {
        left = std::clamp((left + right - leastHandle) / 2, 0.0, width() - leastHandle);
        right = left + leastHandle;
    }
    return QRectF(std::floor(left), 0, right - std::floor(left), height()).adjusted(0, 0, -1, -1);
}

void TrendOverview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_colours.ground);
    QColor veil = m_colours.grid;
    m_paintedHandle = handle();
    if (!m_image.isNull())
        painter.drawImage(QPointF(0, border), m_image);
    veil.setAlphaF(0.55F);
    if (m_shownHistory) {
        painter.fillRect(QRectF(0, 0, m_paintedHandle.left(), height()), veil);
        painter.fillRect(QRectF(m_paintedHandle.right(), 0, width(), height()), veil);
    }
    painter.setPen(QPen(m_colours.grid, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    if (!m_shownHistory)
        return;
    painter.setPen(QPen(m_colours.accent, 1));
    painter.drawRect(m_paintedHandle);
    for (const double x : {m_paintedHandle.left(), m_paintedHandle.right()})
        painter.fillRect(QRectF(x - 1, height() / 2.0 - 7, 3, 14), m_colours.accent);
}

void TrendOverview::resizeEvent(QResizeEvent*)
{
    rebuild();
}

TrendOverview::Grip TrendOverview::gripAt(double x) const
{
    if (!m_shownHistory)
        return Grip::None;
    const QRectF shown = handle();
    const double reach = std::min(grip, shown.width() / 3);
    if (std::abs(x - shown.left()) <= reach || (x < shown.left() && x > shown.left() - grip))
        return Grip::Left;
    if (std::abs(x - shown.right()) <= reach || (x > shown.right() && x < shown.right() + grip))
        return Grip::Right;
    return shown.contains(QPointF(x, 1)) ? Grip::Whole : Grip::None;
}

void TrendOverview::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_shownHistory)
        return;
    const double x = event->position().x();
    m_grip = gripAt(x);
    Q_EMIT grabbed();
    m_pressedAt = x;
    m_pressedSpan = m_state.view.span();
    if (m_grip == Grip::None) { // go there
        const Duration half = m_state.view.width() / 2;
        m_pressedSpan = {timeAt(x) - half, timeAt(x) - half + m_state.view.width()};
        m_grip = Grip::Whole;
        Q_EMIT wished(m_pressedSpan);
    }
}

void TrendOverview::mouseMoveEvent(QMouseEvent* event)
{
    const double x = event->position().x();
    if (m_grip == Grip::None) {
        const Grip under = gripAt(x);
        setCursor(under == Grip::Whole                          ? Qt::OpenHandCursor
                  : under == Grip::Left || under == Grip::Right ? Qt::SizeHorCursor
                                                                : Qt::ArrowCursor);
        return;
    }
    const Duration by = timeAt(x) - timeAt(m_pressedAt);
    TimeSpan span = m_pressedSpan;
    if (m_grip != Grip::Right)
        span.from += by;
    if (m_grip != Grip::Left)
        span.to += by;
    if (m_grip == Grip::Left)
        span.from = std::min(span.from, span.to - TimeView::narrowest);
    if (m_grip == Grip::Right)
        span.to = std::max(span.to, span.from + TimeView::narrowest);
    Q_EMIT wished(span);
}

void TrendOverview::mouseReleaseEvent(QMouseEvent*)
{
    m_grip = Grip::None;
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_overview.h"

#include "ui/common/palette.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {
using base::Duration;
using recording::TimeSpan;

namespace {
constexpr int stripHeight = 40;
constexpr double border = 3;          ///< above and below the curves
constexpr double handleTolerance = 6; ///< pixels around an edge of the handle
constexpr double minHandleWidth = 6;  ///< pixels painted at least
constexpr qint64 renewInterval = 700; ///< ms

/// Each curve as high as the strip: it is for recognizing, not for reading.
void fillHeight(Trace& trace)
{
    bool any = false;
    double low = 0;
    double high = 0;
    for (const recording::SampleColumn& column : trace.columns) {
        if (!std::isfinite(column.min) || !std::isfinite(column.max))
            continue;
        low = any ? std::min(low, column.min) : column.min;
        high = any ? std::max(high, column.max) : column.max;
        any = true;
    }
    const double more = std::max((high - low) * 0.03, std::abs(high) * 1e-3 + 1e-9);
    trace.style.low = low - more;
    trace.style.high = high + more;
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

void TrendOverview::setColors(const TrendColors& colors)
{
    m_colors = colors;
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
    if (all && m_state.view.isFollowing())
        all->to = std::max(all->to, m_state.view.now());
    if (all && all->to <= all->from)
        all->to = all->from + Duration(1);
    return all;
}

/// By a pixel at least: an hour of history moves by one every few seconds.
bool TrendOverview::isOutdated() const
{
    const auto all = history();
    if (!all || !m_shownHistory)
        return all != m_shownHistory;
    return std::abs(xOf(all->from)) >= 1 || std::abs(xOf(all->to) - width()) >= 1;
}

/// One channel a call; when all are there, the picture changes at once.
void TrendOverview::advance(bool busy)
{
    const bool due = !m_sinceImage.isValid() || m_sinceImage.elapsed() > renewInterval;
    if (m_stale || (!m_shownHistory && history())) {
        if (begin()) { // at once: something else is to be seen
            while (m_fetching)
                fetchNext();
        }
    } else if (busy) {
        // the stretch that is shown changes all the time: the handle only
    } else if (m_fetching) {
        fetchNext();
    } else if (due && isOutdated()) {
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
    const auto isDrawn = [](const TrendChannel& channel) {
        return channel.visible && channel.id >= 0;
    };
    const auto& channels = m_state.channels;
    while (m_nextChannel < channels.size() && !isDrawn(channels[m_nextChannel]))
        ++m_nextChannel;
    if (m_nextChannel >= channels.size() || m_state.store == nullptr) {
        finish();
        return;
    }
    const TrendChannel& channel = channels[m_nextChannel++];
    Trace trace;
    trace.style.color = trendColorOn(channel.color, m_colors.background).rgb();
    trace.style.steps = channel.steps;
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
    if (right - left < minHandleWidth) {
        left = std::clamp((left + right - minHandleWidth) / 2, 0.0, width() - minHandleWidth);
        right = left + minHandleWidth;
    }
    return QRectF(std::floor(left), 0, right - std::floor(left), height()).adjusted(0, 0, -1, -1);
}

void TrendOverview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), m_colors.background);
    QColor veil = m_colors.grid;
    m_paintedHandle = handle();
    if (!m_image.isNull())
        painter.drawImage(QPointF(0, border), m_image);
    veil.setAlphaF(0.55F);
    if (m_shownHistory) {
        painter.fillRect(QRectF(0, 0, m_paintedHandle.left(), height()), veil);
        painter.fillRect(QRectF(m_paintedHandle.right(), 0, width(), height()), veil);
    }
    painter.setPen(QPen(m_colors.grid, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    if (!m_shownHistory)
        return;
    painter.setPen(QPen(m_colors.accent, 1));
    painter.drawRect(m_paintedHandle);
    for (const double x : {m_paintedHandle.left(), m_paintedHandle.right()})
        painter.fillRect(QRectF(x - 1, height() / 2.0 - 7, 3, 14), m_colors.accent);
}

void TrendOverview::resizeEvent(QResizeEvent*)
{
    rebuild();
}

TrendOverview::Handle TrendOverview::handleAt(double x) const
{
    if (!m_shownHistory)
        return Handle::None;
    const QRectF shown = handle();
    const double reach = std::min(handleTolerance, shown.width() / 3);
    if (std::abs(x - shown.left()) <= reach ||
        (x < shown.left() && x > shown.left() - handleTolerance))
        return Handle::Left;
    if (std::abs(x - shown.right()) <= reach ||
        (x > shown.right() && x < shown.right() + handleTolerance))
        return Handle::Right;
    return shown.contains(QPointF(x, 1)) ? Handle::Whole : Handle::None;
}

void TrendOverview::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_shownHistory)
        return;
    const double x = event->position().x();
    m_handle = handleAt(x);
    Q_EMIT dragStarted();
    m_pressedAt = x;
    m_pressedSpan = m_state.view.span();
    if (m_handle == Handle::None) { // go there
        const Duration half = m_state.view.width() / 2;
        m_pressedSpan = {timeAt(x) - half, timeAt(x) - half + m_state.view.width()};
        m_handle = Handle::Whole;
        Q_EMIT spanRequested(m_pressedSpan);
    }
}

void TrendOverview::mouseMoveEvent(QMouseEvent* event)
{
    const double x = event->position().x();
    if (m_handle == Handle::None) {
        const Handle under = handleAt(x);
        setCursor(under == Handle::Whole                            ? Qt::OpenHandCursor
                  : under == Handle::Left || under == Handle::Right ? Qt::SizeHorCursor
                                                                    : Qt::ArrowCursor);
        return;
    }
    const Duration by = timeAt(x) - timeAt(m_pressedAt);
    TimeSpan span = m_pressedSpan;
    if (m_handle != Handle::Right)
        span.from += by;
    if (m_handle != Handle::Left)
        span.to += by;
    if (m_handle == Handle::Left)
        span.from = std::min(span.from, span.to - TimeView::minWidth);
    if (m_handle == Handle::Right)
        span.to = std::max(span.to, span.from + TimeView::minWidth);
    Q_EMIT spanRequested(span);
}

void TrendOverview::mouseReleaseEvent(QMouseEvent*)
{
    m_handle = Handle::None;
}
} // namespace ui

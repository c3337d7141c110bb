// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trace_item.h"

#include <QPainter>

#include <cmath>
#include <cstring>
#include <optional>

namespace ui {
namespace {
constexpr double penWidth = 1.5; ///< logical pixels

/// Moves the picture, to the left if positive. What comes in is empty.
void scrollImage(QImage& image, int by)
{
    const auto width = std::size_t(image.width());
    const auto kept = width - std::size_t(std::abs(by));
    for (int y = 0; y < image.height(); ++y) {
        auto* const row = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::memmove(row + std::max(-by, 0), row + std::max(by, 0), kept * sizeof(QRgb));
    }
}

void clear(QImage& image, PixelRange part)
{
    for (int y = 0; y < image.height(); ++y) {
        auto* const row = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::fill(row + part.from, row + part.to, 0U);
    }
}

/// The part of a line within the rectangle; SVG files know no clipping here.
std::optional<QLineF> clipped(const QLineF& line, const QRectF& frame)
{
    double from = 0;
    double to = 1;
    const auto cut = [&](double step, double room) { // keeps what has step * t <= room
        if (step == 0)
            return room >= 0;
        (step < 0 ? from : to) = step < 0 ? std::max(from, room / step) : std::min(to, room / step);
        return from <= to;
    };
    if (!cut(-line.dx(), line.x1() - frame.left()) || !cut(line.dx(), frame.right() - line.x1()) ||
        !cut(-line.dy(), line.y1() - frame.top()) || !cut(line.dy(), frame.bottom() - line.y1()))
        return {};
    return QLineF(line.pointAt(from), line.pointAt(to));
}

/// The pieces of a curve between its gaps and the plot's edges, as lines on the paper.
class LineMaker {
public:
    LineMaker(QPainter* painter, const Trace& trace, const TraceFrame& frame)
        : m_painter(painter)
        , m_trace(trace)
        , m_frame(frame)
    {}

    void paint()
    {
        for (const record::SampleColumn& column : m_trace.columns) {
            const bool known = std::isfinite(column.min) && std::isfinite(column.max) &&
                               std::isfinite(column.first) && std::isfinite(column.last);
            if (column.gapBefore || !known)
                leave();
            if (known)
                add(column);
        }
        leave();
    }

private:
    void add(const record::SampleColumn& column)
    {
        if (m_trace.look.steps && m_at)
            point(column.from, m_last);
        point(column.from, column.first);
        const base::Duration middle = column.from + (column.to - column.from) / 2;
        if (column.min < std::min(column.first, column.last))
            point(middle, column.min);
        if (column.max > std::max(column.first, column.last))
            point(middle, column.max);
        point(column.to, column.last);
        m_last = column.last;
    }

    void point(base::Duration at, double value)
    {
        const QPointF place(m_frame.x(at), m_frame.y(m_trace.look.shown(value)));
        const QRectF paper(0, 0, m_frame.width, m_frame.height);
        const std::optional<QLineF> seen = clipped(QLineF(m_at.value_or(place), place), paper);
        m_at = place;
        if (!seen)
            return;
        if (m_points.isEmpty() || m_points.back() != seen->p1()) {
            finish();
            m_points << seen->p1();
        }
        if (seen->p2() != seen->p1())
            m_points << seen->p2();
    }

    void leave()
    {
        finish();
        m_at.reset();
    }

    void finish()
    {
        if (m_points.size() == 1)
            m_painter->drawLine(m_points.front() - QPointF(1, 0), m_points.front() + QPointF(1, 0));
        else if (m_points.size() > 1)
            m_painter->drawPolyline(m_points);
        m_points.clear();
    }

    QPainter* m_painter;
    const Trace& m_trace;
    TraceFrame m_frame;
    QPolygonF m_points;
    std::optional<QPointF> m_at;
    double m_last = 0;
};
} // namespace

TraceItem::TraceItem(QGraphicsItem* parent)
    : QGraphicsItem(parent)
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(10); // above grid and axes
}

void TraceItem::setPlot(const QRectF& plot)
{
    if (plot == m_plot)
        return;
    prepareGeometryChange();
    m_plot = plot;
}

void TraceItem::forget()
{
    m_image.pixels = {};
    m_traces.clear();
    update();
}

void TraceItem::show(const record::SampleStore* store, const std::vector<TraceLook>& looks,
                     const record::TimeSpan& span, double ratio)
{
    m_span = span;
    m_traces.resize(looks.size());
    for (std::size_t i = 0; i < looks.size(); ++i)
        m_traces[i].look = looks[i];
    update();
    const QSize size = (m_plot.size() * ratio).toSize();
    if (store == nullptr || size.isEmpty() || span.to <= span.from) {
        forget();
        return;
    }
    if (m_paper) {
        fetch(*store, span, m_plot.width());
        return;
    }
    m_ratio = ratio;
    if (m_image.pixels.size() != size) {
        m_image.pixels = QImage(size, QImage::Format_ARGB32_Premultiplied);
        m_image.perPixel = 0;
    }
    const double perPixel = double((span.to - span.from).count()) / size.width();
    const auto end = std::int64_t(std::ceil(double(span.to.count()) / perPixel));
    const PixelRange part = shift(*store, looks, end - size.width(), perPixel);
    if (part.empty())
        return;
    const auto at = [&](int x) {
        return base::Duration(std::int64_t(std::floor(double(m_image.first + x) * perPixel)));
    };
    const int wide = TraceRaster::reach + 1;
    fetch(*store, {at(part.from - wide), at(part.to + wide)},
          (part.to - part.from + 2 * wide) / ratio);
    clear(m_image.pixels, part);
    m_raster.paint(m_image.pixels, m_traces, {at(0), at(size.width())}, penWidth * ratio, part);
}

/// What has to be painted once the rest has been moved to its place.
PixelRange TraceItem::shift(const record::SampleStore& store, const std::vector<TraceLook>& looks,
                            std::int64_t first, double perPixel)
{
    const int width = m_image.pixels.width();
    const std::int64_t by = first - m_image.first;
    PixelRange part{0, width};
    const bool same = m_image.perPixel == perPixel && m_image.looks == looks;
    m_image.first = first;
    if (same && std::abs(by) < width) {
        if (by != 0)
            scrollImage(m_image.pixels, int(by));
        part = unpainted(store);
        if (by > 0)
            part = {std::min(part.from, int(width - by) - TraceRaster::reach), width};
        if (by < 0)
            part = {0, part.empty() ? int(-by) + TraceRaster::reach : part.to};
        part = {std::max(part.from, 0), std::min(part.to, width)};
    }
    m_image.perPixel = perPixel;
    m_image.looks = looks;
    m_image.latest.resize(looks.size());
    for (std::size_t i = 0; i < looks.size(); ++i)
        m_image.latest[i] = store.latest(looks[i].id);
    return part;
}

/// From the sample on that was the latest of its channel when the picture was made.
PixelRange TraceItem::unpainted(const record::SampleStore& store) const
{
    const int width = m_image.pixels.width();
    PixelRange part{width, width};
    for (std::size_t i = 0; i < m_image.looks.size(); ++i) {
        const auto latest = store.latest(m_image.looks[i].id);
        if (latest == m_image.latest[i])
            continue;
        const double from = m_image.latest[i] && latest && latest->at >= m_image.latest[i]->at
                                ? double(m_image.latest[i]->at.count()) / m_image.perPixel -
                                      double(m_image.first) - TraceRaster::reach
                                : 0;
        part.from = std::min(part.from, int(std::clamp(from, 0.0, double(width))));
    }
    return part;
}

void TraceItem::fetch(const record::SampleStore& store, const record::TimeSpan& span, double pixels)
{
    for (Trace& trace : m_traces)
        store.columns(trace.look.id, span, std::max(int(std::ceil(pixels)), 2), trace.columns);
}

void TraceItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_plot.isEmpty())
        return;
    if (m_paper) {
        paintLines(painter);
    } else if (!m_image.pixels.isNull()) {
        painter->save(); // pixel to pixel, which no scaling needs to be done for
        painter->translate(m_plot.topLeft());
        painter->scale(1 / m_ratio, 1 / m_ratio);
        painter->drawImage(QPoint(0, 0), m_image.pixels);
        painter->restore();
    }
}

void TraceItem::paintLines(QPainter* painter) const
{
    painter->save();
    painter->translate(m_plot.topLeft());
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Trace& trace : m_traces) {
        painter->setPen(
            QPen(QColor(trace.look.colour), penWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        LineMaker(painter, trace,
                  {m_span, trace.look.low, trace.look.high, m_plot.width(), m_plot.height()})
            .paint();
    }
    painter->restore();
}
} // namespace ui

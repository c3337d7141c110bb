// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trace_item.h"

#include <QPainter>

#include <cmath>
#include <optional>

namespace ui {
namespace {
constexpr double penWidth = 1.5; ///< logical pixels

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
        if (m_trace.steps && m_at)
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
        const QPointF place(m_frame.x(at), m_frame.y(m_trace.shown(value)));
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
    changed();
}

void TraceItem::setPaper(bool on)
{
    m_paper = on;
    changed();
}

void TraceItem::setSpan(const record::TimeSpan& span)
{
    m_span = span;
}

void TraceItem::changed()
{
    m_stale = true;
    update();
}

void TraceItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_plot.isEmpty() || m_span.to <= m_span.from)
        return;
    if (m_paper)
        paintLines(painter);
    else
        paintImage(painter);
}

void TraceItem::paintImage(QPainter* painter)
{
    const double ratio = painter->device()->devicePixelRatioF();
    const QSize size = (m_plot.size() * ratio).toSize();
    if (m_image.size() != size) {
        m_image = QImage(size, QImage::Format_ARGB32_Premultiplied);
        m_stale = true;
    }
    if (m_image.isNull())
        return;
    if (m_stale) {
        m_image.fill(Qt::transparent);
        for (const Trace& trace : m_traces)
            m_raster.paint(m_image, trace, m_span, penWidth * ratio);
        m_stale = false;
    }
    painter->save(); // pixel to pixel, which no scaling needs to be done for
    painter->translate(m_plot.topLeft());
    painter->scale(1 / ratio, 1 / ratio);
    painter->drawImage(QPoint(0, 0), m_image);
    painter->restore();
}

void TraceItem::paintLines(QPainter* painter) const
{
    painter->save();
    painter->translate(m_plot.topLeft());
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Trace& trace : m_traces) {
        painter->setPen(QPen(trace.colour, penWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        LineMaker(painter, trace, {m_span, trace.low, trace.high, m_plot.width(), m_plot.height()})
            .paint();
    }
    painter->restore();
}
} // namespace ui

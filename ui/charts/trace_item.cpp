// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trace_item.h"

#include <QPainter>

#include <cmath>
#include <cstring>
#include <optional>

namespace ui {
namespace {
constexpr double penWidth = 1.5; ///< logical pixels
constexpr int partWidth = 768;   ///< device pixels repainted at once while the view changes
constexpr int coarseColumn = 2;  ///< pixels
constexpr int wide = TraceRaster::neighborColumns + 1;

/// Moves the image, to the left if positive. The new part is empty.
void scrollImage(QImage& image, int by)
{
    const auto width = std::size_t(image.width());
    const auto kept = width - std::size_t(std::abs(by));
    for (int y = 0; y < image.height(); ++y) {
        auto* const row = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::memmove(row + std::max(-by, 0), row + std::max(by, 0), kept * sizeof(QRgb));
    }
}

/// The part of a line within the rectangle, because SVG output does not clip it.
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
class LineBuilder {
public:
    LineBuilder(QPainter* painter, const Trace& trace, const TraceFrame& frame)
        : m_painter(painter)
        , m_trace(trace)
        , m_frame(frame)
    {}

    void paint()
    {
        for (const recording::SampleColumn& column : m_trace.columns) {
            const bool known = std::isfinite(column.min) && std::isfinite(column.max) &&
                               std::isfinite(column.first) && std::isfinite(column.last);
            if (column.gapBefore || !known)
                finishLine();
            if (known)
                add(column);
        }
        finishLine();
    }

private:
    void add(const recording::SampleColumn& column)
    {
        if (m_trace.style.steps && m_at)
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
        const QPointF place(m_frame.x(at), m_frame.y(m_trace.style.shown(value)));
        const QRectF paper(QPointF(0, m_trace.style.top * m_frame.height),
                           QPointF(m_frame.width, m_trace.style.bottom * m_frame.height));
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

    void finishLine()
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

void TraceItem::clear()
{
    m_image.pixels = {};
    m_image.valid = {};
    m_coarse = false;
    m_traces.clear();
    update();
}

void TraceItem::show(const recording::SampleStore* store, const std::vector<TraceStyle>& styles,
                     const recording::TimeSpan& span, double ratio, bool coarseUpdates)
{
    m_span = span;
    m_ratio = ratio;
    m_traces.resize(styles.size());
    for (std::size_t i = 0; i < styles.size(); ++i)
        m_traces[i].style = styles[i];
    update();
    const QSize size = (m_plot.size() * ratio).toSize();
    if (store == nullptr || size.isEmpty() || span.to <= span.from) {
        clear();
        return;
    }
    if (m_paper) {
        fetch(*store, span, m_plot.width());
        return;
    }
    const bool onlyMoved = shift(*store, styles, span, size);
    m_coarse = (coarseUpdates || m_coarse) && m_image.missing() > partWidth / 4;
    if (m_coarse && onlyMoved) { // the next frames need these columns too
        complete(*store, partWidth);
        m_coarse = m_image.missing() > partWidth / 4;
    }
    if (m_coarse)
        paintCoarse(*store);
    else
        complete(*store, size.width());
}

void TraceItem::refine(const recording::SampleStore& store)
{
    complete(store, partWidth);
    m_coarse = m_image.missing() > 0;
    if (!m_coarse)
        update();
}

base::Duration TraceItem::Image::at(int x) const
{
    return base::Duration(std::int64_t(std::floor(double(first + x) * perPixel)));
}

/// Moves the painted image to its position and checks how much of it is still valid. False: it is
/// of another scale.
bool TraceItem::shift(const recording::SampleStore& store, const std::vector<TraceStyle>& styles,
                      const recording::TimeSpan& span, const QSize& size)
{
    const int width = size.width();
    if (m_image.pixels.size() != size) {
        m_image.pixels = QImage(size, QImage::Format_ARGB32_Premultiplied);
        m_image.valid = {};
    }
    const double perPixel = double((span.to - span.from).count()) / width;
    const std::int64_t first = std::int64_t(std::ceil(double(span.to.count()) / perPixel)) - width;
    const std::int64_t by = first - m_image.first;
    PixelRange& valid = m_image.valid;
    const bool sameScale = m_image.perPixel == perPixel && m_image.styles == styles;
    if (!sameScale || std::abs(by) >= width)
        valid = {};
    m_image.first = first;
    m_image.perPixel = perPixel;
    m_image.styles = styles;
    if (!valid.empty() && by != 0) {
        scrollImage(m_image.pixels, int(by));
        const int from = by < 0 ? TraceRaster::neighborColumns : 0; // its neighbors were not known
        const int to = by > 0 ? width - TraceRaster::neighborColumns : width;
        valid = {std::max(valid.from, from) - int(by), std::min(valid.to, to) - int(by)};
        valid = {std::max(valid.from, 0), std::min(valid.to, width)};
    }
    if (!valid.empty())
        valid.to = std::min(valid.to, upToDate(store));
    if (valid.empty())
        valid = {width, width};
    m_image.latest.resize(styles.size());
    for (std::size_t i = 0; i < styles.size(); ++i)
        m_image.latest[i] = store.latest(styles[i].id);
    return sameScale;
}

/// The pixels before the last sample of its channel when the image was painted.
int TraceItem::upToDate(const recording::SampleStore& store) const
{
    const int width = m_image.pixels.width();
    int to = width;
    for (std::size_t i = 0; i < m_image.styles.size(); ++i) {
        const auto latest = store.latest(m_image.styles[i].id);
        const auto& before = m_image.latest[i];
        if (latest == before)
            continue;
        const double from = before && latest && latest->at >= before->at
                                ? double(before->at.count()) / m_image.perPixel -
                                      double(m_image.first) - TraceRaster::neighborColumns
                                : 0;
        to = std::min(to, int(std::clamp(from, 0.0, double(width))));
    }
    return to;
}

/// The missing part at the right, where time advances, and then at the left.
void TraceItem::complete(const recording::SampleStore& store, int maxColumns)
{
    const int width = m_image.pixels.width();
    PixelRange& valid = m_image.valid;
    const int right = std::min(width - valid.to, maxColumns);
    paintPart(store, {valid.to, valid.to + right});
    valid.to += right;
    const int left = std::min(valid.from, maxColumns - right);
    paintPart(store, {valid.from - left, valid.from});
    valid.from -= left;
}

void TraceItem::paintPart(const recording::SampleStore& store, PixelRange part)
{
    if (part.empty())
        return;
    fetch(store, {m_image.at(part.from - wide), m_image.at(part.to + wide)},
          (part.to - part.from + 2 * wide) / m_ratio);
    m_raster.paint(m_image.pixels, m_traces, {m_image.at(0), m_image.at(m_image.pixels.width())},
                   {.width = penWidth * m_ratio}, part);
}

/// The coarse image: at most one pixel per logical pixel, in columns of two. It still contains the
/// lowest and highest value of each column.
void TraceItem::paintCoarse(const recording::SampleStore& store)
{
    const double ratio = std::min(m_ratio, 1.0);
    const QSize size = (m_plot.size() * ratio).toSize();
    if (m_coarseImage.size() != size)
        m_coarseImage = QImage(size, QImage::Format_ARGB32_Premultiplied);
    Image grid; // of its own pixels, counted from instant 0 as in the fine one
    grid.perPixel = double((m_span.to - m_span.from).count()) / size.width();
    grid.first = std::int64_t(std::ceil(double(m_span.to.count()) / grid.perPixel)) - size.width();
    const int from = -wide - int((grid.first - wide) % coarseColumn != 0);
    const int columns = (size.width() + wide - from + coarseColumn - 1) / coarseColumn;
    fetch(store, {grid.at(from), grid.at(from + columns * coarseColumn)}, columns);
    m_raster.paint(m_coarseImage, m_traces, {grid.at(0), grid.at(size.width())},
                   {.width = penWidth * ratio, .smooth = false}, {0, size.width()});
}

void TraceItem::fetch(const recording::SampleStore& store, const recording::TimeSpan& span,
                      double pixels)
{
    for (Trace& trace : m_traces)
        store.columns(trace.style.id, span, std::max(int(std::ceil(pixels)), 2), trace.columns);
}

void TraceItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_plot.isEmpty())
        return;
    if (m_paper) {
        paintLines(painter);
    } else if (const QImage& pixels = m_coarse ? m_coarseImage : m_image.pixels; !pixels.isNull()) {
        const double ratio = m_coarse ? std::min(m_ratio, 1.0) : m_ratio;
        painter->save(); // the fine one pixel to pixel, which no scaling needs to be done for
        painter->setRenderHint(QPainter::SmoothPixmapTransform, false);
        painter->translate(m_plot.topLeft());
        painter->scale(1 / ratio, 1 / ratio);
        painter->drawImage(QPoint(0, 0), pixels);
        painter->restore();
    }
}

void TraceItem::paintLines(QPainter* painter) const
{
    painter->save();
    painter->translate(m_plot.topLeft());
    painter->setRenderHint(QPainter::Antialiasing);
    for (const Trace& trace : m_traces) {
        painter->setPen(QPen(QColor(trace.style.color), penWidth,
                             trace.style.dashed ? Qt::DashLine : Qt::SolidLine,
                             trace.style.dashed ? Qt::FlatCap : Qt::RoundCap, Qt::RoundJoin));
        LineBuilder(painter, trace,
                    {m_span, trace.style.low, trace.style.high, m_plot.width(), m_plot.height()})
            .paint();
    }
    painter->restore();
}
} // namespace ui

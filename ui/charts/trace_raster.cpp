// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trace_raster.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr float nothing = 1e30F;
constexpr int block = 64; ///< columns filled together where they are tall: rows lie in the cache
constexpr double farAway = 1e7; ///< pixels; more is not drawn either

QRgb blend(QRgb below, QRgb over, int coverage)
{
    const auto mix = [&](int shift) {
        const int under = int(below >> shift & 0xff);
        const int above = int(over >> shift & 0xff);
        return QRgb(under + (above - under) * coverage / 256) << shift;
    };
    return mix(24) | mix(16) | mix(8) | mix(0);
}

bool finite(const record::SampleColumn& column)
{
    return std::isfinite(column.min) && std::isfinite(column.max) && std::isfinite(column.first) &&
           std::isfinite(column.last);
}
} // namespace

void TraceRaster::paint(QImage& image, const Trace& trace, const record::TimeSpan& span,
                        double penWidth)
{
    reset(image.width());
    collect(trace, {span, trace.low, trace.high, double(image.width()), double(image.height())});
    widen(int(penWidth - 1) / 2);
    fill(image, trace.colour.rgb(), penWidth / 2);
}

void TraceRaster::reset(int width)
{
    m_width = width;
    m_top.assign(std::size_t(width), nothing);
    m_bottom.assign(std::size_t(width), -nothing);
    m_firstRow.resize(std::size_t(width));
    m_endRow.resize(std::size_t(width));
}

void TraceRaster::collect(const Trace& trace, const TraceFrame& frame)
{
    const auto y = [&](double value) {
        return std::clamp(frame.y(trace.shown(value)), -farAway, farAway);
    };
    const auto x = [&](base::Duration at) { return frame.x(at); };
    const record::SampleColumn* before = nullptr;
    for (std::size_t i = 0; i < trace.columns.size(); ++i) {
        const record::SampleColumn& column = trace.columns[i];
        if (!finite(column)) {
            before = nullptr;
            continue;
        }
        const double left = x(column.from);
        const double right = x(column.to);
        if (before != nullptr && !column.gapBefore) {
            const double fromY = y(before->last);
            const double fromX = x(before->to);
            line(fromX, fromY, left, trace.steps ? fromY : y(column.first));
            if (trace.steps)
                run(left, left, fromY, y(column.first));
        } else if (i + 1 == trace.columns.size() || trace.columns[i + 1].gapBefore) {
            run(left - 1, left + 1, y(column.first), y(column.first)); // alone: a dot
        }
        run(left, right, y(column.max), y(column.min));
        before = &column;
    }
}

/// A slanted line, cut at the columns' borders.
void TraceRaster::line(double x0, double y0, double x1, double y1)
{
    const int from = int(std::clamp(std::floor(x0), 0.0, double(m_width)));
    const int to = int(std::clamp(std::floor(x1), -1.0, double(m_width - 1)));
    const double slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0;
    for (int x = from; x <= to; ++x) {
        const double a = y0 + (std::max(double(x), x0) - x0) * slope;
        const double b = x1 > x0 ? y0 + (std::min(double(x + 1), x1) - x0) * slope : y1;
        extend(x, a, b);
    }
}

void TraceRaster::run(double x0, double x1, double y0, double y1)
{
    const int from = int(std::clamp(std::floor(x0), 0.0, double(m_width)));
    const int to = int(std::clamp(std::floor(x1), -1.0, double(m_width - 1)));
    for (int x = from; x <= to; ++x)
        extend(x, y0, y1);
}

void TraceRaster::extend(int x, double y0, double y1)
{
    float& top = m_top[std::size_t(x)];
    float& bottom = m_bottom[std::size_t(x)];
    top = std::min(top, float(std::min(y0, y1)));
    bottom = std::max(bottom, float(std::max(y0, y1)));
}

/// Upright lines as thick as level ones.
void TraceRaster::widen(int by)
{
    for (int pass = 0; pass < by; ++pass) {
        for (auto* edge : {&m_top, &m_bottom}) {
            const bool upper = edge == &m_top;
            m_spare = *edge;
            for (std::size_t x = 0; x < edge->size(); ++x) {
                const float left = m_spare[x > 0 ? x - 1 : x];
                const float right = m_spare[x + 1 < edge->size() ? x + 1 : x];
                float& here = (*edge)[x];
                here = upper ? std::min({here, left, right}) : std::max({here, left, right});
            }
        }
    }
}

void TraceRaster::fill(QImage& image, QRgb colour, double halfPen)
{
    const auto height = float(image.height());
    for (std::size_t x = 0; x < std::size_t(m_width); ++x) {
        float& top = m_top[x];
        float& bottom = m_bottom[x];
        top = std::max(top - float(halfPen), 0.0F);
        bottom = std::min(bottom + float(halfPen), height);
        if (top < bottom) {
            m_firstRow[x] = int(std::ceil(top));
            m_endRow[x] = int(bottom);
        } else {
            m_firstRow[x] = m_endRow[x] = 0;
        }
    }
    blendEnds(image, colour);
    for (int from = 0; from < m_width; from += block)
        fillBlock(image, colour, from, std::min(from + block, m_width));
}

void TraceRaster::fillBlock(QImage& image, QRgb colour, int from, int to)
{
    int first = image.height();
    int end = 0;
    std::int64_t covered = 0;
    for (auto x = std::size_t(from); x < std::size_t(to); ++x) {
        if (m_firstRow[x] >= m_endRow[x])
            continue;
        first = std::min(first, m_firstRow[x]);
        end = std::max(end, m_endRow[x]);
        covered += m_endRow[x] - m_firstRow[x];
    }
    const auto stride = image.bytesPerLine() / qsizetype(sizeof(QRgb));
    auto* const pixels = reinterpret_cast<QRgb*>(image.bits());
    const bool tall = covered * 4 > std::int64_t(end - first) * (to - from);
    if (!tall) {
        for (int x = from; x < to; ++x) {
            for (int y = m_firstRow[std::size_t(x)]; y < m_endRow[std::size_t(x)]; ++y)
                pixels[y * stride + x] = colour;
        }
        return;
    }
    const int* const firstRow = m_firstRow.data();
    const int* const endRow = m_endRow.data();
    for (int y = first; y < end; ++y) {
        QRgb* const row = pixels + y * stride;
        for (int x = from; x < to; ++x)
            row[x] = (y >= firstRow[x]) & (y < endRow[x]) ? colour : row[x];
    }
}

void TraceRaster::blendEnds(QImage& image, QRgb colour)
{
    const auto stride = image.bytesPerLine() / qsizetype(sizeof(QRgb));
    auto* const pixels = reinterpret_cast<QRgb*>(image.bits());
    const auto put = [&](std::size_t x, int y, float coverage) {
        if (y < 0 || y >= image.height() || coverage <= 0)
            return;
        QRgb& pixel = pixels[y * stride + qsizetype(x)];
        pixel = blend(pixel, colour, int(coverage * 256));
    };
    for (std::size_t x = 0; x < std::size_t(m_width); ++x) {
        if (m_top[x] >= m_bottom[x])
            continue;
        const int above = m_firstRow[x] - 1;
        const int below = m_endRow[x];
        if (below < m_firstRow[x]) { // within one row
            put(x, below, m_bottom[x] - m_top[x]);
            continue;
        }
        put(x, above, float(m_firstRow[x]) - m_top[x]);
        put(x, below, m_bottom[x] - float(below));
    }
}
} // namespace ui

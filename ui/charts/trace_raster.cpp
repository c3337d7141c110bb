// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trace_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace ui {
namespace {
constexpr float nothing = 1e30F;
constexpr int block = 64; ///< columns painted together, so that this part of the image stays in
                          ///< the cache
constexpr double dashLength = 4; ///< in widths of the pen
constexpr double gapLength = 2.5;
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

/// The left edge, counted in pixels from instant 0, so that dashes stay with the curve.
std::int64_t firstPixel(const recording::TimeSpan& span, int width)
{
    const double perPixel = double((span.to - span.from).count()) / std::max(width, 1);
    return perPixel > 0 ? std::llround(double(span.from.count()) / perPixel) : 0;
}

bool finite(const recording::SampleColumn& column)
{
    return std::isfinite(column.min) && std::isfinite(column.max) && std::isfinite(column.first) &&
           std::isfinite(column.last);
}
} // namespace

void TraceRaster::paint(QImage& image, const std::vector<Trace>& traces,
                        const recording::TimeSpan& span, Pen pen, PixelRange part)
{
    m_part = {std::max(part.from, 0), std::min(part.to, image.width())};
    m_wide = {std::max(m_part.from - neighborColumns, 0),
              std::min(m_part.to + neighborColumns, image.width())};
    if (m_part.empty())
        return;
    m_runs.resize(std::max(m_runs.size(), traces.size()));
    for (std::size_t i = 0; i < traces.size(); ++i) {
        const TraceStyle& look = traces[i].style;
        reset(m_runs[i]);
        collect(m_runs[i], traces[i],
                {span, look.low, look.high, double(image.width()), double(image.height())});
        if (look.dashed)
            dash(m_runs[i], firstPixel(span, image.width()), pen);
        widen(m_runs[i], int(pen.width - 1) / 2);
        const auto rowAt = [&](double share) {
            return float(std::clamp(share, 0.0, 1.0) * image.height());
        };
        roundOff(m_runs[i], pen, rowAt(look.top), rowAt(look.bottom));
    }
    updateCover(traces.size());
    clear(image);
    for (int from = m_part.from; from < m_part.to; from += block) {
        const PixelRange range{from, std::min(from + block, m_part.to)};
        for (std::size_t i = 0; i < traces.size(); ++i) {
            const QRgb color = traces[i].style.color;
            if (pen.smooth)
                blendEnds(image, color, m_runs[i], range);
            fill(image, color, m_runs[i].upper, range);
            fill(image, color, m_runs[i].lower, range);
        }
    }
}

void TraceRaster::clear(QImage& image) const
{
    for (int y = 0; y < image.height(); ++y) {
        auto* const row = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::fill(row + m_part.from, row + m_part.to, 0U);
    }
}

void TraceRaster::reset(Runs& runs) const
{
    const auto width = std::size_t(m_wide.to - m_wide.from);
    runs.top.assign(width, nothing);
    runs.bottom.assign(width, -nothing);
    for (Rows* rows : {&runs.upper, &runs.lower}) {
        rows->first.assign(width, 0);
        rows->end.assign(width, 0);
    }
}

void TraceRaster::collect(Runs& runs, const Trace& trace, const TraceFrame& frame) const
{
    const auto y = [&](double value) {
        return std::clamp(frame.y(trace.style.shown(value)), -farAway, farAway);
    };
    const auto x = [&](base::Duration at) { return frame.x(at) - m_wide.from; };
    const recording::SampleColumn* before = nullptr;
    for (std::size_t i = 0; i < trace.columns.size(); ++i) {
        const recording::SampleColumn& column = trace.columns[i];
        if (!finite(column)) {
            before = nullptr;
            continue;
        }
        const double left = x(column.from);
        const double right = x(column.to);
        if (before != nullptr && !column.gapBefore) {
            const double fromY = y(before->last);
            line(runs, x(before->to), fromY, left, trace.style.steps ? fromY : y(column.first));
            if (trace.style.steps)
                run(runs, left, left, fromY, y(column.first));
        } else if (i + 1 == trace.columns.size() || trace.columns[i + 1].gapBefore) {
            run(runs, left - 1, left + 1, y(column.first), y(column.first)); // alone: a dot
        }
        const auto [low, high] = std::minmax(column.first, column.last);
        if (!trace.style.steps && column.min >= low && column.max <= high) // smooth, where it is
            line(runs, left, y(column.first), right, y(column.last));
        else
            run(runs, left, right, y(column.max), y(column.min));
        before = &column;
    }
}

/// A slanted line, split at the borders of the columns.
void TraceRaster::line(Runs& runs, double x0, double y0, double x1, double y1) const
{
    const double width = m_wide.to - m_wide.from;
    const int from = int(std::clamp(std::floor(x0), 0.0, width));
    const int to = int(std::clamp(std::floor(x1), -1.0, width - 1));
    const double slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0;
    for (int x = from; x <= to; ++x) {
        const double a = y0 + (std::max(double(x), x0) - x0) * slope;
        const double b = x1 > x0 ? y0 + (std::min(double(x + 1), x1) - x0) * slope : y1;
        extend(runs, x, a, b);
    }
}

void TraceRaster::run(Runs& runs, double x0, double x1, double y0, double y1) const
{
    const double width = m_wide.to - m_wide.from;
    const int from = int(std::clamp(std::floor(x0), 0.0, width));
    const int to = int(std::clamp(std::floor(x1), -1.0, width - 1));
    for (int x = from; x <= to; ++x)
        extend(runs, x, y0, y1);
}

void TraceRaster::extend(Runs& runs, int x, double y0, double y1)
{
    float& top = runs.top[std::size_t(x)];
    float& bottom = runs.bottom[std::size_t(x)];
    top = std::min(top, float(std::min(y0, y1)));
    bottom = std::max(bottom, float(std::max(y0, y1)));
}

/// Takes out the gaps, except from steep parts, which would become dots.
void TraceRaster::dash(Runs& runs, std::int64_t firstPixel, Pen pen) const
{
    const std::int64_t length = std::llround(dashLength * pen.width);
    const std::int64_t period = length + std::llround(gapLength * pen.width);
    for (std::size_t x = 0; x < runs.top.size(); ++x) {
        const std::int64_t place = (firstPixel + m_wide.from + std::int64_t(x)) % period;
        const bool inGap = (place < 0 ? place + period : place) >= length;
        if (inGap && runs.bottom[x] - runs.top[x] < float(length)) {
            runs.top[x] = nothing;
            runs.bottom[x] = -nothing;
        }
    }
}

/// Vertical lines as thick as horizontal ones.
void TraceRaster::widen(Runs& runs, int by)
{
    for (int pass = 0; pass < by; ++pass) {
        for (auto* edge : {&runs.top, &runs.bottom}) {
            const bool upper = edge == &runs.top;
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

/// Gives the lines their thickness, and returns which rows are covered entirely.
void TraceRaster::roundOff(Runs& runs, Pen pen, float upper, float lower)
{
    const auto halfPen = float(pen.width / 2);
    for (std::size_t x = 0; x < runs.top.size(); ++x) {
        float& top = runs.top[x];
        float& bottom = runs.bottom[x];
        top = std::max(top - halfPen, upper);
        bottom = std::min(bottom + halfPen, lower);
        if (top < bottom && !pen.smooth) { // never thinner than one
            top = std::min(std::round(top), lower - 1);
            bottom = std::max(std::round(bottom), top + 1);
        }
        if (top < bottom) {
            runs.upper.first[x] = int(std::ceil(top));
            runs.upper.end[x] = int(bottom);
        }
    }
}

/// Removes the run that curves in front will cover; at most two pieces remain.
void TraceRaster::updateCover(std::size_t count)
{
    const auto width = std::size_t(m_wide.to - m_wide.from);
    m_cover.first.assign(width, 0);
    m_cover.end.assign(width, 0);
    for (std::size_t i = count; i-- > 0;) {
        Rows& upper = m_runs[i].upper;
        Rows& lower = m_runs[i].lower;
        for (std::size_t x = 0; x < width; ++x) {
            const int first = upper.first[x];
            const int end = upper.end[x];
            int& from = m_cover.first[x];
            int& to = m_cover.end[x];
            if (end <= first)
                continue;
            if (from < to) {
                upper.end[x] = std::min(end, std::max(from, first));
                lower.first[x] = std::max(first, std::min(to, end));
                lower.end[x] = end;
                if (end <= from || first >= to) { // apart: one piece only
                    upper.end[x] = end;
                    lower.end[x] = lower.first[x];
                }
            }
            const bool touching = first <= to && end >= from && from < to;
            if (touching) {
                from = std::min(from, first);
                to = std::max(to, end);
            } else if (end - first > to - from) {
                from = first;
                to = end;
            }
        }
    }
}

/// Row by row, which is fast for the memory, unless there is little to fill.
void TraceRaster::fill(QImage& image, QRgb color, const Rows& rows, PixelRange range) const
{
    std::array<int, block> first;
    std::array<int, block> end;
    first.fill(0);
    end.fill(0);
    const int width = range.to - range.from;
    int top = image.height();
    int bottom = 0;
    int innerTop = 0;
    int innerBottom = image.height();
    int covered = 0;
    for (int i = 0; i < width; ++i) {
        const auto x =
            static_cast<std::size_t>(range.from - m_wide.from) + static_cast<std::size_t>(i);
        const int a = rows.first[x];
        const int b = rows.end[x];
        innerTop = std::max(innerTop, a < b ? a : image.height());
        innerBottom = std::min(innerBottom, b);
        if (a >= b)
            continue;
        first[std::size_t(i)] = a;
        end[std::size_t(i)] = b;
        top = std::min(top, a);
        bottom = std::max(bottom, b);
        covered += b - a;
    }
    if (covered == 0)
        return;
    const auto stride = image.bytesPerLine() / qsizetype(sizeof(QRgb));
    QRgb* const pixels = reinterpret_cast<QRgb*>(image.bits()) + range.from;
    if (covered * 6 < (bottom - top) * width) {
        for (int i = 0; i < width; ++i) {
            for (int y = first[std::size_t(i)]; y < end[std::size_t(i)]; ++y)
                pixels[y * stride + i] = color;
        }
        return;
    }
    if (innerTop >= innerBottom)
        innerTop = innerBottom = bottom;
    std::array<QRgb, block> whole;
    whole.fill(color);
    const auto ragged = [&](int from, int to) {
        for (int y = from; y < to; ++y) {
            std::array<QRgb, block> row; // of fixed length, for the compiler to work on in parallel
            std::memcpy(row.data(), pixels + y * stride, std::size_t(width) * sizeof(QRgb));
            for (std::size_t i = 0; i < block; ++i)
                row[i] = (y >= first[i]) & (y < end[i]) ? color : row[i];
            std::memcpy(pixels + y * stride, row.data(), std::size_t(width) * sizeof(QRgb));
        }
    };
    ragged(top, innerTop);
    for (int y = innerTop; y < innerBottom; ++y)
        std::memcpy(pixels + y * stride, whole.data(), std::size_t(width) * sizeof(QRgb));
    ragged(innerBottom, bottom);
}

void TraceRaster::blendEnds(QImage& image, QRgb color, const Runs& runs, PixelRange range) const
{
    const auto stride = image.bytesPerLine() / qsizetype(sizeof(QRgb));
    auto* const pixels = reinterpret_cast<QRgb*>(image.bits());
    const auto put = [&](int x, int y, float coverage) {
        if (y < 0 || y >= image.height() || coverage <= 0)
            return;
        QRgb& pixel = pixels[y * stride + x];
        pixel = blend(pixel, color, int(coverage * 256));
    };
    for (int x = range.from; x < range.to; ++x) {
        const auto i = std::size_t(x - m_wide.from);
        const float top = runs.top[i];
        const float bottom = runs.bottom[i];
        if (top >= bottom)
            continue;
        const int first = int(std::ceil(top));
        const int end = int(bottom);
        if (end < first) { // within one row
            put(x, end, bottom - top);
            continue;
        }
        put(x, first - 1, float(first) - top);
        put(x, end, bottom - float(end));
    }
}
} // namespace ui

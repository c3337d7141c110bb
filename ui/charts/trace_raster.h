// SPDX-License-Identifier: GPL-3.0-or-later
// Paints curves into an image as one vertical run per pixel column, smooth at both ends. QPainter
// takes several times as long for lines of this width, and far more where an hour of movement
// becomes a solid band: pixels that a later curve covers are not painted here at all. Keeps its
// buffers between frames. Values that are not numbers are left out like gaps. Main thread.
#pragma once

#include "recording/sample_store.h"

#include <QColor>
#include <QImage>

namespace ui {
/// From time and value to pixels, of the screen or of the paper.
struct TraceFrame {
    recording::TimeSpan span;
    double low = 0; ///< value at the lower edge
    double high = 1;
    double width = 1; ///< pixels
    double height = 1;

    double x(base::Duration at) const
    {
        const double whole = double((span.to - span.from).count());
        return double((at - span.from).count()) * width / (whole > 0 ? whole : 1);
    }
    double y(double value) const { return (high - value) * height / (high - low); }
};

struct TraceStyle {
    recording::ChannelId id = -1;
    QRgb color = 0xff000000;
    bool steps = false;
    double scale = 1;
    double offset = 0;
    double low = 0; ///< of its axis
    double high = 1;
    bool dashed = false;
    double top = 0; ///< share of the image's height; nothing is painted outside of these
    double bottom = 1;
    bool operator==(const TraceStyle&) const = default;

    double shown(double value) const { return value * scale + offset; }
};

/// Its min/max columns in a stretch of time.
struct Trace {
    TraceStyle style;
    std::vector<recording::SampleColumn> columns;
};

struct PixelRange {
    int from = 0;
    int to = 0; ///< exclusive
    bool empty() const { return from >= to; }
};

class TraceRaster {
public:
    /// Columns of pixels that the neighbors of a part must be known for.
    static constexpr int neighborColumns = 4;

    struct Pen {
        double width = 1;   ///< pixels of the image
        bool smooth = true; ///< false: whole pixels, in about a third of the time less
    };

    /// These columns of an ARGB32_Premultiplied image anew, in the order of the traces. `span` is
    /// the time the whole image covers.
    void paint(QImage& image, const std::vector<Trace>& traces, const recording::TimeSpan& span,
               Pen pen, PixelRange part);

private:
    struct Rows { ///< fully covered ones
        std::vector<int> first;
        std::vector<int> end;
    };
    struct Runs {
        std::vector<float> top; ///< top >= bottom: nothing
        std::vector<float> bottom;
        Rows upper;
        Rows lower; ///< the second piece, where another curve lies over the middle
    };

    void reset(Runs& runs) const;
    void collect(Runs& runs, const Trace& trace, const TraceFrame& frame) const;
    void line(Runs& runs, double x0, double y0, double x1, double y1) const;
    void run(Runs& runs, double x0, double x1, double y0, double y1) const;
    static void extend(Runs& runs, int x, double y0, double y1);
    void dash(Runs& runs, std::int64_t firstPixel, Pen pen) const;
    void widen(Runs& runs, int by);
    static void roundOff(Runs& runs, Pen pen, float upper, float lower);
    void updateCover(std::size_t count);
    void clear(QImage& image) const;
    void fill(QImage& image, QRgb color, const Rows& rows, PixelRange range) const;
    void blendEnds(QImage& image, QRgb color, const Runs& runs, PixelRange range) const;

    std::vector<Runs> m_runs;
    Rows m_cover;
    std::vector<float> m_spare;
    PixelRange m_wide; ///< what is collected
    PixelRange m_part; ///< what is painted
};
} // namespace ui

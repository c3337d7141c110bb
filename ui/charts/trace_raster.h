// SPDX-License-Identifier: GPL-3.0-or-later
// Paints curves into an image, one vertical run a column of pixels, smooth at both ends. QPainter
// needs several times as long for a line of this width, and far more where an hour of movement
// becomes a solid band. Main thread; keeps its buffers between frames. Values that are no numbers
// are left out like gaps.
#pragma once

#include "ui/charts/trace.h"

#include <QImage>

namespace ui {
class TraceRaster {
public:
    /// Into an ARGB32_Premultiplied image, over what is there. Columns whose time is beyond the
    /// image's sides are clipped.
    void paint(QImage& image, const Trace& trace, const record::TimeSpan& span, double penWidth);

private:
    void reset(int width);
    void collect(const Trace& trace, const TraceFrame& frame);
    void line(double x0, double y0, double x1, double y1);
    void run(double x0, double x1, double y0, double y1);
    void extend(int x, double y0, double y1);
    void widen(int by);
    void fill(QImage& image, QRgb colour, double halfPen);
    void fillBlock(QImage& image, QRgb colour, int from, int to);
    void blendEnds(QImage& image, QRgb colour);

    std::vector<float> m_top; ///< a column's run; top > bottom: nothing
    std::vector<float> m_bottom;
    std::vector<float> m_spare;
    std::vector<int> m_firstRow; ///< fully covered rows
    std::vector<int> m_endRow;
    int m_width = 0;
    int m_usedFrom = 0;
    int m_usedTo = 0;
};
} // namespace ui

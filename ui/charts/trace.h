// SPDX-License-Identifier: GPL-3.0-or-later
// One curve as it is about to be painted: its samples, its style and its position. A value; main
// thread.
#pragma once

#include "recording/sample_store.h"

#include <QColor>

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
} // namespace ui

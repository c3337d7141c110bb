// SPDX-License-Identifier: GPL-3.0-or-later
// Straight lines of one logical pixel, all of the same number of device pixels. Filled rectangles,
// because QPainter spends far more time on a line, and a chart has a hundred of them in every
// frame. Main thread.
#pragma once

#include <QColor>
#include <QPainter>

#include <cmath>

namespace ui {
/// Rounded down to a device pixel, so that all lines are equally wide.
inline double snapped(const QPainter& painter, double position)
{
    const double ratio = painter.device()->devicePixelRatioF();
    return std::floor(position * ratio) / ratio;
}

inline void paintVertical(QPainter& painter, double x, double top, double bottom,
                          const QColor& color)
{
    painter.fillRect(QRectF(snapped(painter, x), top, 1, bottom - top), color);
}

inline void paintHorizontal(QPainter& painter, double y, double left, double right,
                            const QColor& color)
{
    painter.fillRect(QRectF(left, snapped(painter, y), right - left, 1), color);
}
} // namespace ui

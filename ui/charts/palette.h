// SPDX-License-Identifier: GPL-3.0-or-later
// Colors of curves that color-blind people can distinguish (after Okabe and Ito), with a contrast
// of at least 3:1 to the background, light or dark. Pure functions; call them when painting, since
// the theme may change at any time.
#pragma once

#include <QColor>

namespace ui {
constexpr int trendColorCount = 8; ///< 7 is the gray one, for goals and other company

/// Any number; after the last comes the first again.
QColor trendColor(int index, const QColor& background);

/// What to draw `wanted` with on this ground: one of ours becomes its twin of the right theme, any
/// other is made lighter or darker until it is seen.
QColor trendColorOn(const QColor& requested, const QColor& background);

/// As WCAG counts it, 1 … 21.
double contrast(const QColor& one, const QColor& other);
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// Colors of curves, one for each quantity in every chart, with a contrast of at least 3:1 to the
// background, light or dark. Pure functions; call them when painting, since the theme may change at
// any time.
#pragma once

#include <QColor>
#include <QStringList>

#include <vector>

namespace ui {
constexpr int trendColorCount = 8;
constexpr int positionColor = 0; ///< blue
constexpr int goalColor = 7;     ///< gray, and dashed

/// Any number; after the last comes the first again.
QColor trendColor(int index, const QColor& background);

/// Whether a register's key, of any family, or a role's word is that of a goal: "@goal",
/// "goal_speed".
bool isGoalKey(const QString& key);

/// For curves of these registers or roles in one chart: goals are gray, and the first of each
/// quantity has its color; others get what is left.
std::vector<QColor> trendColors(const QStringList& keys, const QColor& background);

/// What to draw `wanted` with on this ground: one of ours becomes its twin of the right theme, any
/// other is made lighter or darker until it is seen.
QColor trendColorOn(const QColor& requested, const QColor& background);

/// As WCAG counts it, 1 … 21.
double contrast(const QColor& one, const QColor& other);
} // namespace ui

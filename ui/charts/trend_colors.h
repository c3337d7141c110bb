// SPDX-License-Identifier: GPL-3.0-or-later
// All colors of a chart except those of the curves, taken from a palette. A value; made again when
// the theme changes, and from the light theme for paper.
#pragma once

#include <QColor>
#include <QPalette>

namespace ui {
struct TrendColors {
    QColor background;
    QColor grid;
    QColor text;
    QColor muted;
    QColor accent;
    QColor onAccent;
    QColor good;
    QColor warn;
    QColor bad;

    static TrendColors of(const QPalette& palette);
    static TrendColors ofPaper();
};
} // namespace ui

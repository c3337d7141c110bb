// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a chart is painted with besides the curves, taken from a palette. A value; made anew
// when the theme changes, and of the light theme for paper.
#pragma once

#include <QColor>
#include <QPalette>

namespace ui {
struct TrendColours {
    QColor ground;
    QColor grid;
    QColor text;
    QColor quiet;
    QColor accent;
    QColor onAccent;
    QColor good;
    QColor warn;
    QColor bad;

    static TrendColours of(const QPalette& palette);
    static TrendColours ofPaper();
};
} // namespace ui

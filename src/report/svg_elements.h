// SPDX-License-Identifier: GPL-3.0-or-later
// What the charts of the reports are drawn with: axes, lines and labels as SVG markup. Coordinates
// are pixels of the picture. Pure; any thread.
#pragma once

#include "report/html_page.h"

namespace report {
/// 1, 2 or 5 times a power of ten, not below `rough`.
double niceStep(double rough);

struct ChartAxis {
    double low = 0;
    double high = 1;
    double step = 1;  ///< between two grid lines
    double begin = 0; ///< in the picture
    double end = 1;
    double at(double value) const { return begin + (value - low) / (high - low) * (end - begin); }
};

QString svgNumber(double value);
QString svgLine(double x1, double y1, double x2, double y2, const char* style);
/// `content` is markup.
QString svgText(double x, double y, const char* anchor, const QString& content);
/// The whole chart on a white ground.
QString svgChart(const HtmlWriter& htmlWriter, const catalog::Text& title, double width,
                 double height, const QString& content);
} // namespace report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg_elements.h"

#include <cmath>

namespace report {
double niceStep(double rough)
{
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double times = rough / power;
    return power * (times <= 1 ? 1 : times <= 2 ? 2 : times <= 5 ? 5 : 10);
}

QString svgNumber(double value)
{
    return QString::number(value, 'f', 1);
}

QString svgLine(double x1, double y1, double x2, double y2, const char* style)
{
    return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" %5/>\n")
        .arg(svgNumber(x1), svgNumber(y1), svgNumber(x2), svgNumber(y2), QLatin1String(style));
}

QString svgText(double x, double y, const char* anchor, const QString& content)
{
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\" font-size=\"12\" "
                          "fill=\"#1f2328\">%4</text>\n")
        .arg(svgNumber(x), svgNumber(y), QString::fromLatin1(anchor), content);
}

QString svgChart(const HtmlWriter& htmlWriter, const catalog::Text& title, double width,
                 double height, const QString& content)
{
    return QStringLiteral(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
               "aria-label=\"%1\" width=\"%2\" height=\"%3\" viewBox=\"0 0 %2 %3\">\n"
               "<rect x=\"0\" y=\"0\" width=\"%2\" height=\"%3\" fill=\"#ffffff\"/>\n%4</svg>\n")
        .arg(htmlWriter.attributeText(title))
        .arg(width)
        .arg(height)
        .arg(content);
}
} // namespace report

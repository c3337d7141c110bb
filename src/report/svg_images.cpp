// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg_images.h"

#include "report/fonts.h"
#include "report/paper.h"

#include <QFont>
#include <QPainter>
#include <QSvgRenderer>
#include <QTextFormat>

namespace report {
namespace {
QByteArray svgOf(const PaperCharts& charts, const QTextFormat& format)
{
    return charts.svg(format.toImageFormat().name());
}
} // namespace

QFont paperFont()
{
    QFont font;
    if (const QStringList families = textFamilies(); !families.isEmpty())
        font.setFamilies(families);
    return font;
}

SvgImages::SvgImages(const PaperCharts& charts, double width)
    : m_charts(charts)
    , m_width(width)
{}

QSizeF SvgImages::intrinsicSize(QTextDocument*, int, const QTextFormat& format)
{
    const QSizeF size = QSvgRenderer(svgOf(m_charts, format)).defaultSize();
    return size.isEmpty() ? QSizeF() : size * (m_width / size.width());
}

void SvgImages::drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int,
                           const QTextFormat& format)
{
    QSvgRenderer renderer(svgOf(m_charts, format));
    painter->save();
    painter->setFont(paperFont());
    renderer.render(painter, place);
    painter->restore();
}
} // namespace report

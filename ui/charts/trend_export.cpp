// SPDX-License-Identifier: GPL-3.0-or-later
// The chart as a picture file: on white whatever the theme, with legend and time axis, from a chart
// of its own that is not visible. Written beside the old file first, so that a full disk leaves no
// half picture.
#include "ui/charts/trend_chart_private.h"

#include <QBuffer>
#include <QChart>
#include <QFileInfo>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>

namespace ui {
namespace {
constexpr double paperBorder = 12;
constexpr QSize minImageSize(320, 240);

/// The same view with the same axes, on paper.
void paintOnPaper(QPainter* painter, const TrendState& state, const TrendAxes& axes,
                  const QFont& font, const QSizeF& size)
{
    QGraphicsScene scene;
    auto* const chart = new QChart;
    scene.addItem(chart);
    chart->resize(size - QSizeF(2 * paperBorder, 2 * paperBorder));
    TrendScene picture(chart, state, nullptr);
    picture.setPaper(true);
    picture.setFont(font);
    picture.setColors(TrendColors::ofPaper());
    picture.layOut();
    picture.refresh(TrendScene::Axes::Immediate, 1);
    for (const TrendAxes::ValueAxis& axis : axes.valueAxes())
        picture.axes().axisOf(axis.range.unit()).range = axis.range;
    picture.refresh(TrendScene::Axes::Smooth, 1);
    chart->layout()->activate(); // no event loop will
    painter->fillRect(QRectF(QPointF(0, 0), size), Qt::white);
    const QRectF paper(QPointF(paperBorder, paperBorder), chart->size());
    scene.render(painter, paper, QRectF(QPointF(0, 0), chart->size()));
}

/// Writes a temporary file first. A device is never replaced by a file, but written to.
QString writeFile(const QString& path, const QByteArray& bytes)
{
    const QFileInfo old(path);
    if (old.exists() && !old.isFile()) {
        QFile device(path);
        const bool good = device.open(QIODevice::WriteOnly | QIODevice::Unbuffered) &&
                          device.write(bytes) == bytes.size();
        return good ? QString() : device.errorString();
    }
    QSaveFile file(path);
    const bool good =
        file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
    return good ? QString() : file.errorString();
}

bool write(const QString& path, const QByteArray& bytes, QString* errorMessage)
{
    QString why;
    if (path.isEmpty())
        why = TrendChart::tr("No file name specified.");
    else if (const QString system = writeFile(path, bytes); !system.isEmpty())
        why = TrendChart::tr("%1 could not be written: %2").arg(path, system);
    if (!why.isEmpty() && errorMessage != nullptr)
        *errorMessage = why;
    return why.isEmpty();
}
} // namespace

bool TrendChart::savePng(const QString& path, QSize size, QString* errorMessage) const
{
    const double ratio = devicePixelRatioF();
    const QSize logical = size.expandedTo(minImageSize);
    QImage image(logical * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    {
        QPainter painter(&image);
        paintOnPaper(&painter, m_private->state(), m_private->plot->picture().axes(), font(),
                     logical);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return write(path, bytes, errorMessage);
}

bool TrendChart::saveSvg(const QString& path, QSize size, QString* errorMessage) const
{
    const QSize logical = size.expandedTo(minImageSize);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(logical);
        generator.setViewBox(QRect(QPoint(0, 0), logical));
        generator.setTitle(tr("Trend chart"));
        QPainter painter(&generator);
        paintOnPaper(&painter, m_private->state(), m_private->plot->picture().axes(), font(),
                     logical);
    }
    return write(path, bytes, errorMessage);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// A picture is on white whatever the theme, with legend and time axis, from a chart of its own that
// is not visible.
#include "ui/charts/trend_export.h"

#include "files/csv_text.h"
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
    picture.axes().setLaneLayout(axes.laneLayout());
    picture.setLanes(axes.hasLanes());
    picture.refresh(TrendScene::Axes::Immediate, 1);
    for (const TrendAxes::ValueAxis& axis : axes.valueAxes())
        picture.axes().axisOf(axis.range.unit()).range = axis.range;
    picture.refresh(TrendScene::Axes::Smooth, 1);
    chart->layout()->activate(); // no event loop will
    painter->fillRect(QRectF(QPointF(0, 0), size), Qt::white);
    const QRectF paper(QPointF(paperBorder, paperBorder), chart->size());
    scene.render(painter, paper, QRectF(QPointF(0, 0), chart->size()));
}

bool write(const QString& path, const QByteArray& bytes, QString* errorMessage)
{
    QString why;
    if (path.isEmpty())
        why = TrendChart::tr("No file name specified.");
    else if (const QString system = writeTrendFile(path, bytes); !system.isEmpty())
        why = TrendChart::tr("%1 could not be written: %2").arg(path, system);
    if (!why.isEmpty() && errorMessage != nullptr)
        *errorMessage = why;
    return why.isEmpty();
}
} // namespace

QString writeTrendFile(const QString& path, const QByteArray& bytes)
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

QByteArray trendCsv(const TrendTable& table, const std::atomic_bool& stop)
{
    QStringList names{QStringLiteral("time_s")};
    for (const TrendTable::Column& column : table.columns)
        names << column.name;
    QByteArray text = files::csvStart(files::CsvReader::Spreadsheet) + files::csvLine(names);
    std::vector<std::size_t> next(table.columns.size(), 0);
    while (!stop) {
        std::optional<base::Duration> at;
        for (std::size_t i = 0; i < next.size(); ++i) {
            const auto& points = table.columns[i].points;
            if (next[i] < points.size() && (!at || points[next[i]].at < *at))
                at = points[next[i]].at;
        }
        if (!at)
            break;
        text += QByteArray::number(double((*at - table.zero).count()) / 1e6, 'f', 6);
        for (std::size_t i = 0; i < next.size(); ++i) {
            const auto& points = table.columns[i].points;
            text += ',';
            if (next[i] < points.size() && points[next[i]].at == *at)
                text += files::csvNumber(points[next[i]++].value);
        }
        text += '\n';
    }
    return text;
}

TrendTable TrendChart::shownTable() const
{
    const TrendState& state = m_private->state();
    TrendTable table;
    table.zero = isFollowing() ? shown().to : state.origin;
    for (const TrendChannel& channel : state.channels) {
        if (!channel.visible || channel.id < 0 || state.store == nullptr)
            continue;
        const QString name = channel.unit.isEmpty()
                                 ? channel.name
                                 : QStringLiteral("%1 [%2]").arg(channel.name, channel.unit);
        table.columns.push_back({name, state.store->points(channel.id, shown())});
    }
    return table;
}

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

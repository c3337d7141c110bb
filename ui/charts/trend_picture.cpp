// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_picture.h"

#include "ui/charts/palette.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegendMarker>
#include <QLineSeries>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double legendSpace = 4;
constexpr double leastPlot = 40;

/// Of the columns within the stretch; those beside it are there for their lines only.
std::optional<AxisRange> extremes(const Trace& trace, const record::TimeSpan& span)
{
    std::optional<AxisRange> found;
    const auto take = [&](double value) {
        const double y = trace.shown(value);
        if (!std::isfinite(y))
            return;
        found =
            found ? AxisRange{std::min(found->low, y), std::max(found->high, y)} : AxisRange{y, y};
    };
    for (const record::SampleColumn& column : trace.columns) {
        if (column.to < span.from || column.from > span.to)
            continue;
        take(column.min);
        take(column.max);
    }
    return found;
}
} // namespace

TrendPicture::TrendPicture(QChart* chart, const TrendState& state, QObject* parent)
    : QObject(parent)
    , m_chart(chart)
    , m_state(state)
    , m_axes(new TrendAxes(chart))
    , m_traces(new TraceItem(chart))
    , m_overlay(new TrendOverlay(chart))
{
    chart->setBackgroundVisible(false);
    chart->setPlotAreaBackgroundVisible(false);
    chart->setMargins({});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    chart->setAnimationOptions(QChart::NoAnimation);
    chart->legend()->detachFromChart();
    chart->legend()->setAlignment(Qt::AlignTop);
    chart->legend()->setMarkerShape(QLegend::MarkerShapeRectangle);
    chart->legend()->setContentsMargins(0, 0, 0, 0);
}

void TrendPicture::setColours(const TrendColours& colours)
{
    m_colours = colours;
    m_axes->setColours(colours);
    m_overlay->setColours(colours);
    channelsChanged();
}

void TrendPicture::setFont(const QFont& font)
{
    m_chart->legend()->setFont(font);
    m_axes->setFont(font);
    m_overlay->setFont(font);
}

void TrendPicture::channelsChanged()
{
    rebuildSeries();
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        axis.used = false;
        axis.colour = {};
    }
    std::vector<QString> units;
    for (std::size_t i = 0; i < m_state.channels.size(); ++i) {
        const TrendChannel& channel = m_state.channels[i];
        TrendAxes::ValueAxis& axis = m_axes->axisOf(channel.unit);
        if (!channel.visible)
            continue;
        axis.colour = axis.used ? QColor() : trendColourOn(channel.colour, m_colours.ground);
        axis.used = true;
    }
    styleLegend();
}

/// Qt Charts' own objects for each channel, made anew only when there are others.
void TrendPicture::rebuildSeries()
{
    bool same = m_series.size() == m_state.channels.size();
    for (std::size_t i = 0; same && i < m_series.size(); ++i)
        same = m_series[i]->property("unit").toString() == m_state.channels[i].unit;
    if (same)
        return;
    for (QLineSeries* series : m_series) {
        m_chart->removeSeries(series);
        delete series;
    }
    m_series.clear();
    for (std::size_t i = 0; i < m_state.channels.size(); ++i) {
        auto* const series = new QLineSeries(m_chart);
        const QString& unit = m_state.channels[i].unit;
        series->setProperty("unit", unit);
        m_chart->addSeries(series);
        m_axes->attach(series, unit);
        m_series.push_back(series);
        for (QLegendMarker* marker : m_chart->legend()->markers(series))
            connect(marker, &QLegendMarker::clicked, this,
                    [this, i] { Q_EMIT legendClicked(int(i)); });
    }
}

void TrendPicture::styleLegend()
{
    m_chart->legend()->setLabelColor(m_colours.text);
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        const TrendChannel& channel = m_state.channels[i];
        const QColor colour = trendColourOn(channel.colour, m_colours.ground);
        m_series[i]->setName(channel.name.toHtmlEscaped());
        m_series[i]->setVisible(channel.visible);
        for (QLegendMarker* marker : m_chart->legend()->markers(m_series[i])) {
            marker->setVisible(true);
            marker->setPen(QPen(channel.visible ? colour : m_colours.quiet, 1));
            marker->setBrush(channel.visible ? QBrush(colour) : QBrush(Qt::NoBrush));
            marker->setLabelBrush(channel.visible ? m_colours.text : m_colours.quiet);
        }
    }
}

double TrendPicture::layOutLegend(double width)
{
    QLegend* const legend = m_chart->legend();
    if (m_series.empty())
        return 0;
    legend->setGeometry(QRectF(0, 0, width, 400));
    double bottom = 0;
    for (const QGraphicsItem* group : legend->childItems()) {
        for (const QGraphicsItem* marker : group->childItems())
            bottom =
                std::max(bottom, marker->mapRectToItem(legend, marker->boundingRect()).bottom());
    }
    legend->setGeometry(QRectF(0, 0, width, std::ceil(bottom)));
    return std::ceil(bottom) + legendSpace;
}

void TrendPicture::layOut()
{
    m_legendHeight = layOutLegend(m_chart->size().width());
    layOutPlot();
}

bool TrendPicture::layOutPlot()
{
    QRectF room(QPointF(0, 0), m_chart->size());
    room.setTop(m_legendHeight);
    QRectF plot = m_axes->layOut(room);
    if (plot.width() < leastPlot || plot.height() < leastPlot)
        plot = {};
    if (plot == m_plot)
        return false;
    m_plot = plot;
    if (!plot.isEmpty())
        m_chart->setPlotArea(plot);
    m_traces->setPlot(plot);
    m_overlay->setPlot(plot);
    return true;
}

void TrendPicture::refresh(Axes axes, double ratio)
{
    fetch(ratio);
    rangeAxes(axes);
    if (layOutPlot())
        fetch(ratio); // other texts, another width
    std::size_t i = 0;
    for (Trace& trace : m_traces->traces()) {
        const TrendChannel& channel = m_state.channels[std::size_t(m_traceChannel[i++])];
        const AxisRange range = m_axes->axisOf(channel.unit).range.shown();
        trace.low = range.low;
        trace.high = range.high;
    }
    m_axes->show(m_state.view, m_state.origin);
    m_traces->changed();
    refreshOverlay();
}

void TrendPicture::fetch(double ratio)
{
    m_traces->setSpan(m_state.view.span());
    m_traceChannel.clear();
    std::vector<Trace>& traces = m_traces->traces();
    std::size_t used = 0;
    const int pixels = std::max(int(m_plot.width() * ratio), 1);
    for (std::size_t i = 0; i < m_state.channels.size(); ++i) {
        const TrendChannel& channel = m_state.channels[i];
        if (!channel.visible || channel.id < 0 || m_state.store == nullptr)
            continue;
        if (used == traces.size())
            traces.emplace_back();
        Trace& trace = traces[used++]; // its memory is used again
        trace.colour = trendColourOn(channel.colour, m_colours.ground);
        trace.steps = channel.steps;
        trace.scale = channel.scale;
        trace.offset = channel.offset;
        m_state.store->columns(channel.id, m_state.view.span(), pixels, trace.columns);
        m_traceChannel.push_back(int(i));
    }
    traces.resize(used);
}

void TrendPicture::rangeAxes(Axes how)
{
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        std::optional<AxisRange> range;
        std::size_t i = 0;
        for (const Trace& trace : m_traces->traces()) {
            if (m_state.channels[std::size_t(m_traceChannel[i++])].unit != axis.range.unit())
                continue;
            if (const auto seen = extremes(trace, m_state.view.span()))
                range = range ? AxisRange{std::min(range->low, seen->low),
                                          std::max(range->high, seen->high)}
                              : *seen;
        }
        if (!range)
            continue;
        if (how == Axes::AtOnce)
            axis.range.settle(range->low, range->high);
        else
            axis.range.take(range->low, range->high, m_state.view.now());
    }
}

void TrendPicture::refreshOverlay()
{
    m_overlay->setView(m_state.view);
    m_overlay->setMarks(m_state.marks);
    m_overlay->setCursors(m_state.cursors);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_scene.h"

#include "ui/charts/axis_ticks.h"
#include "ui/common/palette.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QLegendMarker>
#include <QLineSeries>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {
constexpr double legendSpace = 4;
constexpr double minPlotSize = 40;
constexpr double offScaleSlack = 0.002; ///< of the axis; half a pixel

bool hasTrace(const TrendChannel& channel)
{
    return channel.visible && channel.id >= 0;
}

/// Of what is drawn in `span`; a scale may turn it upside down.
std::optional<AxisRange> extremes(const TrendState& state, const TrendChannel& channel,
                                  const recording::TimeSpan& span)
{
    const auto range = state.store->range(channel.id, span);
    if (!range)
        return {};
    const double a = range->first * channel.scale + channel.offset;
    const double b = range->second * channel.scale + channel.offset;
    if (!std::isfinite(a) || !std::isfinite(b))
        return {};
    return AxisRange{std::min(a, b), std::max(a, b)};
}

/// The values at the edges of the whole plot, so that those of the axis are where it has them.
void placeIn(TraceStyle& style, const TrendAxes::ValueAxis& axis, const QRectF& plot)
{
    const AxisRange& shown = axis.shown;
    const QRectF& area = axis.area;
    style.top = style.bottom = 0; // without room: nothing
    if (area.height() < 1 || plot.height() < 1)
        return;
    const double perPixel = shown.size() / area.height();
    style.high = shown.high + (area.top() - plot.top()) * perPixel;
    style.low = style.high - plot.height() * perPixel;
    style.top = (area.top() - plot.top()) / plot.height();
    style.bottom = (area.bottom() - plot.top()) / plot.height();
}
} // namespace

TrendScene::TrendScene(QChart* chart, const TrendState& state, QObject* parent)
    : QObject(parent)
    , m_chart(chart)
    , m_state(state)
    , m_axes(new TrendAxes(chart))
    , m_traces(new TraceItem(chart))
    , m_laneLabels(new LaneLabels(chart))
    , m_overlay(new TrendOverlay(chart))
    , m_offScaleChips(new OffScaleChips(chart))
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
    chart->legend()->layout()->setContentsMargins(0, 0, 0, 0); // in line with what is above it
}

void TrendScene::setColors(const TrendColors& colors)
{
    m_colors = colors;
    m_axes->setColors(colors);
    m_laneLabels->setColors(colors);
    m_overlay->setColors(colors);
    m_offScaleChips->setColors(colors);
    channelsChanged();
}

void TrendScene::setPaper(bool on)
{
    m_traces->setPaper(on);
    m_offScaleChips->setVisible(!on); // paper has no clicks
}

void TrendScene::setFont(const QFont& font)
{
    m_chart->legend()->setFont(font);
    m_axes->setFont(font);
    m_laneLabels->setFont(font);
    m_overlay->setFont(font);
    m_offScaleChips->setFont(font);
}

void TrendScene::channelsChanged()
{
    rebuildSeries();
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        axis.used = false;
        axis.color = {};
    }
    for (std::size_t i = 0; i < m_state.channels.size(); ++i) {
        const TrendChannel& channel = m_state.channels[i];
        TrendAxes::ValueAxis& axis = m_axes->axisOf(channel.unit);
        if (!channel.visible)
            continue;
        axis.color = axis.used ? QColor() : trendColorOn(channel.color, m_colors.background);
        axis.order = axis.used ? axis.order : i;
        axis.used = true;
    }
    styleLegend();
}

/// The objects of Qt Charts for each channel, made again only when the channels change.
void TrendScene::rebuildSeries()
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
        m_series.push_back(series);
        for (QLegendMarker* marker : m_chart->legend()->markers(series))
            connect(marker, &QLegendMarker::clicked, this,
                    [this, i] { Q_EMIT legendClicked(int(i)); });
    }
}

void TrendScene::styleLegend()
{
    m_chart->legend()->setLabelColor(m_colors.text);
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        const TrendChannel& channel = m_state.channels[i];
        const QColor color = trendColorOn(channel.color, m_colors.background);
        m_series[i]->setName(channel.name.toHtmlEscaped());
        m_series[i]->setVisible(channel.visible);
        for (QLegendMarker* marker : m_chart->legend()->markers(m_series[i])) {
            marker->setVisible(true);
            marker->setPen(QPen(channel.visible ? color : m_colors.muted, 1));
            marker->setBrush(channel.visible ? QBrush(color) : QBrush(Qt::NoBrush));
            marker->setLabelBrush(channel.visible ? m_colors.text : m_colors.muted);
        }
    }
}

double TrendScene::layOutLegend(double width)
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

void TrendScene::layOut()
{
    m_legendHeight = layOutLegend(m_chart->size().width());
    layOutPlot();
}

bool TrendScene::layOutPlot()
{
    QRectF room(QPointF(0, 0), m_chart->size());
    room.setTop(m_legendHeight);
    room.setRight(room.right() - m_laneLabels->width());
    QRectF plot = m_axes->layOut(room);
    if (plot.width() < minPlotSize || plot.height() < minPlotSize)
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

void TrendScene::refresh(Axes axes, double ratio, bool coarseUpdates)
{
    rangeAxes(axes);
    layOutPlot(); // the texts may have become longer
    if (m_axes->hasLanes()) {
        showLaneLabels();
        if (layOutPlot()) // those beside the lanes as well
            showLaneLabels();
    }
    showOffScale();
    m_axes->show(m_state.view, m_state.origin);
    showTraces(ratio, coarseUpdates);
    refreshOverlay();
}

void TrendScene::setLanes(bool on)
{
    m_axes->setLanes(on);
    showLaneLabels(); // the plot ends where they begin
    layOut();
}

void TrendScene::showLaneLabels()
{
    std::vector<LaneLabel> labels;
    for (const TrendChannel& channel : m_state.channels) {
        if (!m_axes->hasLanes() || !channel.visible)
            continue;
        std::optional<recording::SamplePoint> last;
        if (m_state.store != nullptr && channel.id >= 0)
            last = m_state.store->at(channel.id, m_state.view.span().to);
        const QString value =
            last ? valueText(last->value, displayStep(channel.unit)) : QStringLiteral("\u2013");
        labels.push_back({channel.name, value + QLatin1Char(' ') + channel.unit,
                          trendColorOn(channel.color, m_colors.background),
                          m_axes->axisOf(channel.unit).area});
    }
    std::stable_sort(labels.begin(), labels.end(), [](const LaneLabel& a, const LaneLabel& b) {
        return a.lane.top() < b.lane.top();
    });
    m_laneLabels->setLabels(std::move(labels));
}

/// Of the visible curves of one axis.
std::optional<AxisRange> TrendScene::rangeInView(const QString& unit) const
{
    std::optional<AxisRange> range; // of what the axis is for
    std::optional<AxisRange> whole;
    const auto add = [](std::optional<AxisRange>& to, const std::optional<AxisRange>& seen) {
        if (seen)
            to = to ? AxisRange{std::min(to->low, seen->low), std::max(to->high, seen->high)}
                    : *seen;
    };
    for (const TrendChannel& channel : m_state.channels) {
        if (!hasTrace(channel) || channel.unit != unit)
            continue;
        const recording::TimeSpan& view = m_state.view.span();
        const std::optional<AxisRange> seen = extremes(m_state, channel, view);
        add(whole, seen);
        if (channel.axisFrom <= view.from)
            add(range, seen);
        else if (channel.axisFrom <= view.to)
            add(range, extremes(m_state, channel, {channel.axisFrom, view.to}));
    }
    return range ? range : whole;
}

void TrendScene::rangeAxes(Axes how)
{
    for (TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (m_state.store == nullptr || !axis.used || axis.range.isFixed())
            continue;
        const std::optional<AxisRange> range = rangeInView(axis.range.unit());
        if (!range)
            continue;
        if (how == Axes::Immediate)
            axis.range.setNow(range->low, range->high);
        else
            axis.range.update(range->low, range->high, m_state.view.now());
    }
    m_axes->updateRanges();
}

/// Only an axis that the user has set can have curves outside.
void TrendScene::showOffScale()
{
    std::vector<OffScale> found;
    for (const TrendAxes::ValueAxis& axis : m_axes->valueAxes()) {
        if (m_state.store == nullptr || !axis.used || !axis.range.isFixed())
            continue;
        const std::optional<AxisRange> range = rangeInView(axis.range.unit());
        const double slack = axis.shown.size() * offScaleSlack;
        const bool above = range && range->high > axis.shown.high + slack;
        const bool below = range && range->low < axis.shown.low - slack;
        if (above || below)
            found.push_back({axis.range.unit(), axis.area, above, below});
    }
    m_offScaleChips->setOffScale(std::move(found));
}

void TrendScene::showTraces(double ratio, bool coarseUpdates)
{
    std::vector<TraceStyle> looks;
    for (const TrendChannel& channel : m_state.channels) {
        if (!hasTrace(channel))
            continue;
        TraceStyle style{.id = channel.id,
                         .color = trendColorOn(channel.color, m_colors.background).rgb(),
                         .steps = channel.steps,
                         .scale = channel.scale,
                         .offset = channel.offset,
                         .dashed = channel.dashed};
        placeIn(style, m_axes->axisOf(channel.unit), m_plot);
        looks.push_back(style);
    }
    m_traces->show(m_state.store, looks, m_state.view.span(), ratio, coarseUpdates);
}

void TrendScene::refine()
{
    if (m_state.store != nullptr && isCoarse())
        m_traces->refine(*m_state.store);
}

void TrendScene::refreshOverlay()
{
    m_overlay->setView(m_state.view);
    m_overlay->setMarks(m_state.marks, m_state.markTextFunction);
    m_overlay->setCursors(m_state.cursors);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_axes.h"

#include <QChart>
#include <QFontMetricsF>
#include <QPainter>
#include <QValueAxis>

#include <cmath>
#include <utility>

namespace ui {
namespace {
constexpr double gap = 6;            ///< between plot and text
constexpr double columnGap = 10;     ///< between the texts of two axes
constexpr double widthStep = 8;      ///< the plot does not resize for one more digit
constexpr double timeTextRoom = 1.6; ///< a text and the space beside it
constexpr double tallPlot = 420;

/// One by one: there must never be thousands of ticks in between.
void scaleAxis(QValueAxis* axis, const AxisRange& range, double step)
{
    const bool sameStep = axis->tickInterval() == step;
    if (axis->min() == range.low && axis->max() == range.high && sameStep)
        return;
    if (step > axis->tickInterval())
        axis->setTickInterval(step);
    axis->setRange(range.low, range.high);
    if (step != axis->tickInterval())
        axis->setTickInterval(step);
}

QValueAxis* makeAxis(QChart* chart, Qt::Alignment side)
{
    auto* const axis = new QValueAxis(chart);
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0);
    axis->setTickInterval(1);
    axis->setLabelsVisible(false);
    axis->setLabelFormat(QStringLiteral(" ")); // laid out even so
    axis->setLineVisible(false);
    chart->addAxis(axis, side);
    return axis;
}
} // namespace

TrendAxes::TrendAxes(QChart* chart)
    : QGraphicsItem(chart)
    , m_chart(chart)
    , m_timeAxis(makeAxis(chart, Qt::AlignBottom))
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(5);
}

void TrendAxes::setColors(const TrendColors& colors)
{
    m_colors = colors;
    const QPen grid(colors.grid, 1);
    m_timeAxis->setGridLinePen(grid);
    for (const ValueAxis& axis : m_values)
        axis.axis->setGridLinePen(grid);
    update();
}

void TrendAxes::setFont(const QFont& font)
{
    m_font = font;
    update();
}

TrendAxes::ValueAxis& TrendAxes::axisOf(const QString& unit)
{
    for (ValueAxis& axis : m_values) {
        if (axis.range.unit() == unit)
            return axis;
    }
    ValueAxis& made = m_values.emplace_back();
    made.range = AutoRange(unit);
    made.axis = makeAxis(m_chart, Qt::AlignLeft);
    made.axis->setGridLinePen(QPen(m_colors.grid, 1));
    made.axis->setVisible(false);
    return made;
}

void TrendAxes::attach(QAbstractSeries* series, const QString& unit)
{
    series->attachAxis(m_timeAxis);
    series->attachAxis(axisOf(unit).axis);
}

double TrendAxes::textWidth(const ValueAxis& axis) const
{
    const QFontMetricsF metrics(m_font);
    double widest = metrics.horizontalAdvance(axis.range.unit());
    const double step = axis.range.step(tall());
    for (const double value : ticks(axis.range.paddedRange(), step))
        widest = std::max(widest, metrics.horizontalAdvance(valueText(value, step)));
    return std::ceil(widest / widthStep) * widthStep;
}

bool TrendAxes::tall() const
{
    return m_plot.height() > tallPlot;
}

QRectF TrendAxes::layOut(const QRectF& room)
{
    if (room != m_room) {
        prepareGeometryChange();
        m_room = room;
    }
    const double line = QFontMetricsF(m_font).height();
    double left = room.left() + gap;
    double right = room.right() - gap;
    bool onLeft = true;
    for (ValueAxis& axis : m_values) {
        if (!axis.used)
            continue;
        axis.left = std::exchange(onLeft, !onLeft);
        axis.width = textWidth(axis);
        (axis.left ? left : right) += (axis.left ? 1 : -1) * (axis.width + columnGap);
    }
    const double least = line; // the first and last time stick out
    const QRectF plot(QPointF(std::ceil(std::max(left, room.left() + 2 * least)),
                              std::ceil(room.top() + line + gap)),
                      QPointF(std::floor(std::min(right, room.right() - 2 * least)),
                              std::floor(room.bottom() - line - 2 * gap)));
    double leftEdge = plot.left() - gap;
    double rightEdge = plot.right() + gap;
    for (ValueAxis& axis : m_values) {
        if (!axis.used)
            continue;
        axis.edge = axis.left ? leftEdge - axis.width : rightEdge;
        (axis.left ? leftEdge : rightEdge) += (axis.left ? -1 : 1) * (axis.width + columnGap);
    }
    if (plot != m_plot) {
        m_plot = plot;
        update();
    }
    return plot;
}

void TrendAxes::show(const TimeView& view, base::Duration origin)
{
    chooseGrid();
    showTime(view, origin);
    showValues();
}

void TrendAxes::showTime(const TimeView& view, base::Duration origin)
{
    const base::Duration zero = view.isFollowing() ? view.span().to : origin;
    const auto seconds = [&](base::Duration at) { return double((at - zero).count()) / 1e6; };
    const AxisRange range{seconds(view.span().from), seconds(view.span().to)};
    const QFontMetricsF metrics(m_font);
    int maxTicks = 10;
    double step = 1;
    for (int tries = 0; tries < 4; ++tries) { // the length of the texts depends on the step
        step = timeStep(range.size(), maxTicks);
        const double text = std::max(metrics.horizontalAdvance(timeText(range.low, range, step)),
                                     metrics.horizontalAdvance(timeText(range.high, range, step)));
        const int fitting = std::max(int(m_plot.width() / (text * timeTextRoom)), 1);
        if (fitting >= maxTicks)
            break;
        maxTicks = fitting;
    }
    if (range == m_time && step == m_timeStep)
        return;
    m_time = range;
    m_timeStep = step;
    scaleAxis(m_timeAxis, range, step);
    update();
}

void TrendAxes::showValues()
{
    for (ValueAxis& axis : m_values) {
        const AxisRange range = axis.range.paddedRange();
        if (std::exchange(axis.painted, range) != range)
            update();
        if (axis.axis->isVisible())
            scaleAxis(axis.axis, range, axis.range.step(tall()));
    }
}

/// Grid lines for the first axis in use; the others share its divisions, and Qt Charts draws
/// nothing for them.
void TrendAxes::chooseGrid()
{
    bool drawn = false;
    for (const ValueAxis& axis : m_values) {
        const bool grid = axis.used && !drawn;
        drawn = drawn || grid;
        if (axis.axis->isVisible() != grid)
            axis.axis->setVisible(grid);
    }
}

TrendAxes::ValueAxis* TrendAxes::axisAt(const QPointF& position)
{
    if (position.y() < m_plot.top() - 2 * gap || position.y() > m_plot.bottom() + gap)
        return nullptr;
    for (ValueAxis& axis : m_values) {
        if (axis.used && position.x() >= axis.edge - columnGap / 2 &&
            position.x() <= axis.edge + axis.width + columnGap / 2)
            return &axis;
    }
    return nullptr;
}

void TrendAxes::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    painter->setFont(m_font);
    paintTime(painter);
    for (const ValueAxis& axis : m_values) {
        if (axis.used)
            paintValues(painter, axis);
    }
}

void TrendAxes::paintTime(QPainter* painter) const
{
    const QFontMetricsF metrics(m_font);
    painter->setPen(m_colors.muted);
    const double baseline = m_plot.bottom() + gap + metrics.ascent();
    for (const double at : ticks(m_time, m_timeStep)) {
        const QString text = timeText(at, m_time, m_timeStep);
        const double x = m_plot.left() + (at - m_time.low) / m_time.size() * m_plot.width();
        painter->drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, baseline), text);
    }
}

void TrendAxes::paintValues(QPainter* painter, const ValueAxis& axis) const
{
    const QFontMetricsF metrics(m_font);
    const AxisRange range = axis.range.paddedRange();
    const double step = axis.range.step(tall());
    const auto write = [&](const QString& text, double baseline) {
        const double slack = axis.width - metrics.horizontalAdvance(text);
        painter->drawText(QPointF(axis.edge + (axis.left ? slack : 0), baseline), text);
    };
    painter->setPen(axis.color.isValid() ? axis.color : m_colors.muted);
    for (const double value : ticks(range, step)) {
        const double y = m_plot.bottom() - (value - range.low) / range.size() * m_plot.height();
        write(valueText(value, step), y + metrics.capHeight() / 2);
    }
    write(axis.range.unit(), m_plot.top() - gap);
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_axes.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ui {
namespace {
constexpr double gap = 6;            ///< between plot and text
constexpr double columnGap = 10;     ///< between the texts of two axes
constexpr double widthStep = 8;      ///< the plot does not resize for one more digit
constexpr double timeTextRoom = 1.6; ///< a text and the space beside it
constexpr double tickLength = 4;
constexpr double rowsPerTick = 2; ///< texts that fit between two ticks
constexpr double minSide = 0.1;   ///< of an axis; with less below zero, or above, it has one sign
constexpr double maxStretch = 3;  ///< axes are not made taller than this to level their zeros
} // namespace

void TrendAxes::ValueAxis::fix(const AxisRange& wanted)
{
    range.setFixed(wanted);
    shown = range.range();
}

TrendAxes::TrendAxes(QGraphicsItem* chart)
    : QGraphicsItem(chart)
{
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(5);
}

void TrendAxes::setColors(const TrendColors& colors)
{
    m_colors = colors;
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
    return made;
}

void TrendAxes::updateRanges()
{
    std::vector<AxisRange> before;
    for (ValueAxis& axis : m_values) {
        before.push_back(axis.shown);
        axis.shown = axis.range.range();
    }
    levelZeros();
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (m_values[i].shown != before[i])
            update();
    }
    updateSteps();
}

/// Where the axis that needs it least makes the others grow least. While one is fixed the others
/// stay where they were level.
void TrendAxes::levelZeros()
{
    std::vector<ValueAxis*> signedAxes;
    bool anyFixed = false;
    for (ValueAxis& axis : m_values) {
        anyFixed = anyFixed || (axis.used && axis.range.isFixed());
        const double below = -axis.shown.low / axis.shown.size();
        if (axis.used && !axis.range.isFixed() && below > minSide && below < 1 - minSide)
            signedAxes.push_back(&axis);
    }
    const auto stretch = [&](double share) {
        double most = 1;
        for (const ValueAxis* axis : signedAxes)
            most = std::max(most, stretchedRange(axis->shown, share).size() / axis->shown.size());
        return most;
    };
    if (!anyFixed) {
        m_shareBelowZero = 0;
        double least = maxStretch;
        for (const ValueAxis* candidate : signedAxes) {
            const double share = -candidate->shown.low / candidate->shown.size();
            if (const double most = stretch(share); most < least) {
                least = most;
                m_shareBelowZero = share;
            }
        }
    }
    if (m_shareBelowZero <= 0 || stretch(m_shareBelowZero) >= maxStretch)
        return;
    for (ValueAxis* axis : signedAxes)
        axis->shown = stretchedRange(axis->shown, m_shareBelowZero);
}

void TrendAxes::updateSteps()
{
    const double row = QFontMetricsF(m_font).height() * rowsPerTick;
    const int parts = std::clamp(int(m_plot.height() / row), 3, 10);
    for (ValueAxis& axis : m_values)
        axis.step = valueStep(axis.shown.size(), parts, axis.range.unit());
}

double TrendAxes::textWidth(const ValueAxis& axis) const
{
    const QFontMetricsF metrics(m_font);
    double widest = metrics.horizontalAdvance(axis.range.unit());
    for (const double value : ticks(axis.shown, axis.step))
        widest = std::max(widest, metrics.horizontalAdvance(valueText(value, axis.step)));
    return std::ceil(widest / widthStep) * widthStep;
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
        updateSteps();
        update();
    }
    return plot;
}

void TrendAxes::show(const TimeView& view, base::Duration origin)
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
    update();
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
    if (m_plot.isEmpty())
        return;
    painter->setFont(m_font);
    paintTime(painter);
    bool grid = true;
    for (const ValueAxis& axis : m_values) {
        if (axis.used)
            paintValues(painter, axis, std::exchange(grid, false));
    }
}

void TrendAxes::paintTime(QPainter* painter) const
{
    const QFontMetricsF metrics(m_font);
    const double baseline = m_plot.bottom() + gap + metrics.ascent();
    for (const double at : ticks(m_time, m_timeStep)) {
        const QString text = timeText(at, m_time, m_timeStep);
        const double x = m_plot.left() + (at - m_time.low) / m_time.size() * m_plot.width();
        painter->setPen(m_colors.grid);
        painter->drawLine(QLineF(x, m_plot.top(), x, m_plot.bottom() + tickLength));
        painter->setPen(m_colors.muted);
        painter->drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, baseline), text);
    }
}

/// The lines of the first axis go across; those of the others are ticks beside the plot.
void TrendAxes::paintValues(QPainter* painter, const ValueAxis& axis, bool grid) const
{
    const QFontMetricsF metrics(m_font);
    const auto write = [&](const QString& text, double baseline) {
        const double slack = axis.width - metrics.horizontalAdvance(text);
        painter->drawText(QPointF(axis.edge + (axis.left ? slack : 0), baseline), text);
    };
    const QColor color = axis.color.isValid() ? axis.color : m_colors.muted;
    const double inner = axis.left ? axis.edge + axis.width + gap : axis.edge - gap;
    for (const double value : ticks(axis.shown, axis.step)) {
        const double y =
            m_plot.bottom() - (value - axis.shown.low) / axis.shown.size() * m_plot.height();
        painter->setPen(grid ? m_colors.grid : color);
        if (grid)
            painter->drawLine(QLineF(m_plot.left(), y, m_plot.right(), y));
        else
            painter->drawLine(QLineF(inner, y, inner + (axis.left ? -1 : 1) * tickLength, y));
        painter->setPen(color);
        write(valueText(value, axis.step), y + metrics.capHeight() / 2);
    }
    painter->setPen(color);
    write(axis.range.unit(), m_plot.top() - gap - 2);
}
} // namespace ui

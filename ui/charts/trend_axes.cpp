// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_axes.h"

#include "ui/charts/hairline.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

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
constexpr double topLines = 1.1;     ///< of text above the plot: units, marks
constexpr double tickLength = 4;
constexpr double laneGap = 10; ///< between two lanes
/// In lines of text: the last time may extend below the labels of the lanes.
constexpr double timeOverhang = 4;
constexpr double firstLane = 2;    ///< times as high as each of the others
constexpr double minLaneLines = 2; ///< of text
constexpr double edgeReach = 3;    ///< of the mouse, beside the space between two lanes
constexpr double rowsPerTick = 2;  ///< texts that fit between two ticks
constexpr double rowsPerLaneTick = 1.4;
constexpr double minSide = 0.1;  ///< of an axis; with less below zero, or above, it has one sign
constexpr double maxStretch = 3; ///< axes are not made taller than this to level their zeros
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
    setFlag(ItemUsesExtendedStyleOption); // what has to be painted
    setZValue(5);
}

QRectF TrendAxes::boundingRect() const
{
    return m_room.adjusted(0, 0, timeOverhang * QFontMetricsF(m_font).height(), 0);
}

void TrendAxes::setColors(const TrendColors& colors)
{
    m_colors = colors;
    update();
}

void TrendAxes::setFont(const QFont& font)
{
    prepareGeometryChange();
    m_font = font;
    for (ValueAxis& axis : m_values)
        axis.measured = 0;
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
    for (ValueAxis& axis : m_values)
        axis.shown = axis.range.range();
    if (!m_lanes)
        levelZeros();
    for (ValueAxis& axis : m_values) {
        if (axis.shown == axis.painted)
            continue;
        axis.painted = axis.shown;
        axis.measured = 0;
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
    const double row = QFontMetricsF(m_font).height() * (m_lanes ? rowsPerLaneTick : rowsPerTick);
    for (ValueAxis& axis : m_values) {
        const int parts = std::clamp(int(axis.area.height() / row), m_lanes ? 1 : 3, 10);
        const double step = valueStep(axis.shown.size(), parts, axis.range.unit());
        if (step == axis.step)
            continue;
        axis.step = step;
        axis.measured = 0;
    }
}

/// Asked for several times a frame, so measured only when the texts have changed.
double TrendAxes::textWidth(ValueAxis& axis) const
{
    if (axis.measured > 0)
        return axis.measured;
    const QFontMetricsF metrics(m_font);
    double widest = metrics.horizontalAdvance(axis.range.unit());
    for (const double value : ticks(axis.shown, axis.step))
        widest = std::max(widest, metrics.horizontalAdvance(valueText(value, axis.step)));
    axis.measured = std::ceil(widest / widthStep) * widthStep;
    return axis.measured;
}

/// In the order of their channels; lanes in the user's order first.
std::vector<TrendAxes::ValueAxis*> TrendAxes::usedAxes()
{
    std::vector<ValueAxis*> used;
    for (ValueAxis& axis : m_values) {
        if (axis.used)
            used.push_back(&axis);
    }
    const auto place = [this](const ValueAxis* axis) {
        const auto chosen = m_lanes ? m_laneLayout.order.indexOf(axis->range.unit()) : -1;
        return std::pair(chosen < 0 ? m_laneLayout.order.size() : chosen, axis->order);
    };
    std::sort(used.begin(), used.end(),
              [&](const ValueAxis* a, const ValueAxis* b) { return place(a) < place(b); });
    return used;
}

void TrendAxes::setLanes(bool on)
{
    m_lanes = on;
    update();
}

void TrendAxes::setLaneLayout(LaneLayout layout)
{
    m_laneLayout = std::move(layout);
    update();
}

/// As they are now, whatever moves next.
void TrendAxes::keepLaneHeights()
{
    const std::vector<ValueAxis*> axes = usedAxes();
    for (const ValueAxis* axis : axes)
        m_laneLayout.heights[axis->range.unit()] = laneHeight(*axis, axis == axes.front());
}

TrendAxes::ValueAxis* TrendAxes::laneLabelAt(const QPointF& position)
{
    if (usedAxes().size() < 2)
        return nullptr; // there is nothing to change places with
    for (ValueAxis& axis : m_values) {
        if (m_lanes && axis.used && position.x() > axis.area.right() &&
            position.y() >= axis.area.top() && position.y() <= axis.area.bottom())
            return &axis;
    }
    return nullptr;
}

void TrendAxes::moveLane(const QString& unit, double y)
{
    const std::vector<ValueAxis*> axes = usedAxes();
    QStringList order;
    for (const ValueAxis* axis : axes)
        order << axis->range.unit();
    const auto from = order.indexOf(unit);
    if (!m_lanes || from < 0)
        return;
    // Beyond the middle of the other lane: a higher one that comes in its place is not passed back.
    qsizetype to = from;
    while (to > 0 && y < axes[std::size_t(to) - 1]->area.center().y())
        --to;
    while (to + 1 < order.size() && y > axes[std::size_t(to) + 1]->area.center().y())
        ++to;
    if (to == from)
        return;
    keepLaneHeights();
    order.move(from, to);
    for (const QString& hidden : std::as_const(m_laneLayout.order)) {
        if (!order.contains(hidden))
            order << hidden;
    }
    m_laneLayout.order = order;
    update();
}

double TrendAxes::laneHeight(const ValueAxis& axis, bool isFirst) const
{
    const double usual = isFirst ? firstLane : 1.0;
    return std::clamp(m_laneLayout.heights.value(axis.range.unit(), usual), 0.2, 10.0);
}

double TrendAxes::minLaneHeight() const
{
    return std::ceil(QFontMetricsF(m_font).height() * minLaneLines);
}

TrendAxes::ValueAxis* TrendAxes::laneEdgeAt(const QPointF& position)
{
    const std::vector<ValueAxis*> axes = usedAxes();
    for (std::size_t i = 0; m_lanes && i + 1 < axes.size(); ++i) {
        const QRectF space(axes[i]->area.bottomLeft(), axes[i + 1]->area.topRight());
        if (space.adjusted(0, -edgeReach, 0, edgeReach).contains(position))
            return axes[i];
    }
    return nullptr;
}

void TrendAxes::moveLaneEdge(ValueAxis& above, double y)
{
    const std::vector<ValueAxis*> axes = usedAxes();
    const auto found = std::find(axes.begin(), axes.end(), &above);
    if (!m_lanes || found == axes.end() || found + 1 == axes.end())
        return;
    keepLaneHeights();
    ValueAxis& below = **(found + 1);
    const double both = above.area.height() + below.area.height();
    const double least = std::min(minLaneHeight(), both / 2);
    const double upper = std::clamp(y - above.area.top(), least, both - least);
    double& aboveShare = m_laneLayout.heights[above.range.unit()];
    double& belowShare = m_laneLayout.heights[below.range.unit()];
    const double shares = aboveShare + belowShare;
    aboveShare = shares * upper / both;
    belowShare = shares - aboveShare;
    update();
}

QRectF TrendAxes::layOut(const QRectF& room)
{
    if (room != m_room) {
        prepareGeometryChange();
        m_room = room;
    }
    const QRectF plot = m_lanes ? layOutLanes(room) : layOutBeside(room);
    if (plot != m_plot) {
        m_plot = plot;
        update();
    }
    updateSteps();
    return plot;
}

/// One below the other; the first one, which is the position as a rule, is higher.
QRectF TrendAxes::layOutLanes(const QRectF& chart)
{
    const double line = QFontMetricsF(m_font).height();
    const std::vector<ValueAxis*> axes = usedAxes();
    double widest = 2 * line;
    double shares = 0;
    for (ValueAxis* axis : axes) {
        widest = std::max(widest, textWidth(*axis));
        shares += laneHeight(*axis, axis == axes.front());
    }
    const QRectF plot(
        QPointF(std::ceil(chart.left() + widest + 2 * gap),
                std::ceil(chart.top() + topLines * line + gap)),
        QPointF(std::floor(chart.right() - gap), std::floor(chart.bottom() - line - 2 * gap)));
    // Lanes of a very low plot are closer, but none is outside of it.
    const double space = std::min(laneGap, plot.height() / (2.0 * double(axes.size()) + 1));
    const double room = plot.height() - (double(axes.size()) - 1) * space;
    double top = plot.top();
    for (ValueAxis* axis : axes) {
        const double height = room * laneHeight(*axis, axis == axes.front()) / shares;
        axis->left = true;
        axis->width = widest;
        axis->edge = plot.left() - gap - widest;
        axis->area = QRectF(plot.left(), std::floor(top), plot.width(), std::floor(height));
        top += height + space;
    }
    return plot;
}

/// All of them in the whole plot, with their texts left and right of it.
QRectF TrendAxes::layOutBeside(const QRectF& room)
{
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
                              std::ceil(room.top() + topLines * line + gap)),
                      QPointF(std::floor(std::min(right, room.right() - 2 * least)),
                              std::floor(room.bottom() - line - 2 * gap)));
    double leftEdge = plot.left() - gap;
    double rightEdge = plot.right() + gap;
    for (ValueAxis& axis : m_values) {
        axis.area = plot;
        if (!axis.used)
            continue;
        axis.edge = axis.left ? leftEdge - axis.width : rightEdge;
        (axis.left ? leftEdge : rightEdge) += (axis.left ? -1 : 1) * (axis.width + columnGap);
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
    for (ValueAxis& axis : m_values) {
        if (axis.used && position.y() >= axis.area.top() - 2 * gap &&
            position.y() <= axis.area.bottom() + gap && position.x() >= axis.edge - columnGap / 2 &&
            position.x() <= axis.edge + axis.width + columnGap / 2)
            return &axis;
    }
    return nullptr;
}

TrendAxes::ValueAxis* TrendAxes::laneAt(const QPointF& position)
{
    for (ValueAxis& axis : m_values) {
        if (m_lanes && axis.used && axis.area.contains(position))
            return &axis;
    }
    return nullptr;
}

void TrendAxes::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*)
{
    if (m_plot.isEmpty())
        return;
    painter->setFont(m_font);
    paintTime(painter, option->exposedRect);
    bool grid = true;
    for (const ValueAxis& axis : m_values) {
        if (!axis.used)
            continue;
        paintValues(painter, axis, grid || m_lanes, option->exposedRect);
        grid = false;
    }
}

void TrendAxes::paintTime(QPainter* painter, const QRectF& exposed) const
{
    const QFontMetricsF metrics(m_font);
    const double baseline = m_plot.bottom() + gap + metrics.ascent();
    const bool isTextExposed = exposed.bottom() > m_plot.bottom() + gap;
    for (const double at : ticks(m_time, m_timeStep)) {
        const double x = m_plot.left() + (at - m_time.low) / m_time.size() * m_plot.width();
        if (m_lanes) {
            for (const ValueAxis& axis : m_values) {
                if (axis.used)
                    paintVertical(*painter, x, axis.area.top(), axis.area.bottom(), m_colors.grid);
            }
        } else {
            paintVertical(*painter, x, m_plot.top(), m_plot.bottom() + tickLength, m_colors.grid);
        }
        if (!isTextExposed)
            continue;
        const QString text = timeText(at, m_time, m_timeStep);
        painter->setPen(m_colors.muted);
        painter->drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, baseline), text);
    }
}

/// The lines of the first axis go across; those of the others are ticks beside the plot.
void TrendAxes::paintValues(QPainter* painter, const ValueAxis& axis, bool grid,
                            const QRectF& exposed) const
{
    const QFontMetricsF metrics(m_font);
    const auto write = [&](const QString& text, double baseline) {
        const double slack = axis.width - metrics.horizontalAdvance(text);
        painter->drawText(QPointF(axis.edge + (axis.left ? slack : 0), baseline), text);
    };
    const QColor color = axis.color.isValid() ? axis.color : m_colors.muted;
    const double inner = axis.left ? axis.edge + axis.width + gap : axis.edge - gap;
    const bool isTextExposed =
        exposed.left() < axis.edge + axis.width && exposed.right() > axis.edge;
    for (const double value : ticks(axis.shown, axis.step)) {
        const double y =
            axis.area.bottom() - (value - axis.shown.low) / axis.shown.size() * axis.area.height();
        if (grid)
            paintHorizontal(*painter, y, m_plot.left(), m_plot.right(), m_colors.grid);
        else
            paintHorizontal(*painter, y, inner - (axis.left ? tickLength : 0),
                            inner + (axis.left ? 0 : tickLength), color);
        if (!isTextExposed)
            continue;
        painter->setPen(color);
        double baseline = y + metrics.capHeight() / 2;
        if (m_lanes) // the text of another lane is near
            baseline = std::min(std::max(baseline, axis.area.top() + metrics.capHeight()),
                                axis.area.bottom());
        write(valueText(value, axis.step), baseline);
    }
    if (m_lanes) {
        const QRectF& lane = axis.area;
        for (const double y : {lane.top(), lane.bottom()})
            paintHorizontal(*painter, y, lane.left(), lane.right(), m_colors.grid);
        for (const double x : {lane.left(), lane.right()})
            paintVertical(*painter, x, lane.top(), lane.bottom() + 1, m_colors.grid);
    } else if (isTextExposed) {
        painter->setPen(color);
        write(axis.range.unit(), m_plot.top() - gap - metrics.capHeight() / 2);
    }
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The axes of a trend chart: time below, one value axis per unit, alternately left and right. One
// set of ticks paints grid, tick marks and labels; the grid is that of the first axis in use, and
// zero is at one height on all that have both signs. Not Qt Charts' axes: laying out their labels
// costs milliseconds each time a range changes, and they do not know minutes. Owned by the picture;
// main thread.
#pragma once

#include "ui/charts/auto_range.h"
#include "ui/charts/time_view.h"
#include "ui/charts/trend_channel.h"
#include "ui/charts/trend_colors.h"

#include <QFont>
#include <QGraphicsItem>

#include <deque>
#include <vector>

namespace ui {
class TrendAxes final : public QGraphicsItem {
public:
    struct ValueAxis {
        AutoRange range;
        AxisRange shown{};   ///< the range, stretched so that zeros are level
        AxisRange painted{}; ///< the one shown when the axes were last updated
        bool left = true;
        bool used = false;     ///< a visible channel is on it
        QColor color{};        ///< of its only channel; invalid: several
        std::size_t order = 0; ///< of its first channel
        QRectF area{};         ///< where its values are: the plot, or its lane
        double edge = 0; ///< where its texts begin, next to the plot or outside of the one before
        double width = 0;
        double step = 1;     ///< between ticks
        double measured = 0; ///< the width of its texts; 0: they have changed

        void fix(const AxisRange& wanted); ///< shown at once
    };

    explicit TrendAxes(QGraphicsItem* chart);

    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);

    /// Makes the axis if there is none yet; the reference stays valid.
    ValueAxis& axisOf(const QString& unit);
    std::deque<ValueAxis>& valueAxes() { return m_values; }
    const std::deque<ValueAxis>& valueAxes() const { return m_values; }

    /// The room that is left for the plot in `room` once every used axis has its texts.
    QRectF layOut(const QRectF& room);
    /// After ranges have changed: what is shown of them.
    void updateRanges();
    void show(const TimeView& view, base::Duration origin);

    /// One part of the plot for each axis in use, one below the other.
    void setLanes(bool on);
    bool hasLanes() const { return m_lanes; }
    const QRectF& plot() const { return m_plot; } ///< all of it
    void setLaneLayout(LaneLayout layout);
    const LaneLayout& laneLayout() const { return m_laneLayout; }
    /// The axis of the lane above the space under this place, if another lane is below it.
    ValueAxis* laneEdgeAt(const QPointF& position);
    /// Makes this lane end here, and the next one fill what is left of both.
    void moveLaneEdge(ValueAxis& above, double y);
    /// The axis of the lane whose name and values are under this place.
    ValueAxis* laneLabelAt(const QPointF& position);
    /// The lane passes each one whose middle it is dragged beyond.
    void moveLane(const QString& unit, double y);

    /// The used axis whose texts are under this place.
    ValueAxis* axisAt(const QPointF& position);
    /// The axis of the lane under this place; null while all share the plot.
    ValueAxis* laneAt(const QPointF& position);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void levelZeros();
    void updateSteps();
    void paintTime(QPainter* painter, const QRectF& exposed) const;
    void paintValues(QPainter* painter, const ValueAxis& axis, bool grid,
                     const QRectF& exposed) const;
    double textWidth(ValueAxis& axis) const;
    std::vector<ValueAxis*> usedAxes();
    void keepLaneHeights();
    QRectF layOutBeside(const QRectF& room);
    QRectF layOutLanes(const QRectF& chart);
    double laneHeight(const ValueAxis& axis, bool isFirst) const;
    double minLaneHeight() const;

    std::deque<ValueAxis> m_values;
    TrendColors m_colors;
    QFont m_font;
    QRectF m_room;
    QRectF m_plot;
    double m_shareBelowZero = 0; ///< where zeros are level; 0: nowhere
    AxisRange m_time{-10, 0};
    double m_timeStep = 1;
    bool m_lanes = false;
    LaneLayout m_laneLayout;
};
} // namespace ui

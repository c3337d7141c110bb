// SPDX-License-Identifier: GPL-3.0-or-later
// The axes of a trend chart: time below, one value axis per unit, alternately left and right. Qt
// Charts keeps the ranges and draws the grid. One item paints the labels, because an axis that lays
// out its own labels costs milliseconds each time its range changes, and does not know minutes.
// Owned by the picture; main thread.
#pragma once

#include "ui/charts/auto_range.h"
#include "ui/charts/time_view.h"
#include "ui/charts/trend_colors.h"

#include <QFont>
#include <QGraphicsItem>

#include <deque>

class QAbstractSeries;
class QChart;
class QValueAxis;

namespace ui {
class TrendAxes final : public QGraphicsItem {
public:
    struct ValueAxis {
        AutoRange range;
        QValueAxis* axis = nullptr;
        bool left = true;
        bool used = false; ///< a visible channel is on it
        QColor color{};    ///< of its only channel; invalid: several
        double edge = 0;   ///< where its texts begin, next to the plot or outside of the one before
        double width = 0;
        AxisRange painted{};
    };

    explicit TrendAxes(QChart* chart);

    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);
    const QFont& font() const { return m_font; }

    /// Makes the axis if there is none yet; the reference stays valid.
    ValueAxis& axisOf(const QString& unit);
    std::deque<ValueAxis>& valueAxes() { return m_values; }
    const std::deque<ValueAxis>& valueAxes() const { return m_values; }
    void attach(QAbstractSeries* series, const QString& unit);

    /// The room that is left for the plot in `room` once every used axis has its texts.
    QRectF layOut(const QRectF& room);
    /// Ranges to Qt Charts and texts, where they have changed.
    void show(const TimeView& view, base::Duration origin);
    const AxisRange& time() const { return m_time; }

    /// The used axis whose texts are under this place.
    ValueAxis* axisAt(const QPointF& position);

    QRectF boundingRect() const override { return m_room; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void showTime(const TimeView& view, base::Duration origin);
    void showValues();
    void chooseGrid();
    void paintTime(QPainter* painter) const;
    void paintValues(QPainter* painter, const ValueAxis& axis) const;
    double textWidth(const ValueAxis& axis) const;
    bool tall() const;

    QChart* m_chart;
    QValueAxis* m_timeAxis;
    std::deque<ValueAxis> m_values;
    TrendColors m_colors;
    QFont m_font;
    QRectF m_room;
    QRectF m_plot;
    AxisRange m_time{-10, 0};
    double m_timeStep = 1;
};
} // namespace ui

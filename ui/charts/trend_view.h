// SPDX-License-Identifier: GPL-3.0-or-later
// The view of the chart with its mouse, wheel, touch and keyboard input: turns input into requests
// and changes nothing itself. Positions are fractions of the plot, 0 … 1 from its left and lower
// edge. Main thread.
#pragma once

#include "ui/charts/trend_scene.h"

#include <QChartView>

class QGestureEvent;

namespace ui {
class TrendView final : public QChartView {
    Q_OBJECT

public:
    TrendView(const TrendState& state, QWidget* parent);

    TrendScene& picture() { return *m_scene; }

Q_SIGNALS:
    void resized();
    void boxDrawn(const QRectF& shares); ///< x and y from the lower left; whole height: time only
    void panStarted();
    void panned(double x,
                double y); ///< by shares, since the last one; y: of scales the user has set
    void valuesPanned(const QString* unit, double y); ///< null: all
    void panEnded();
    void zoomed(double factor, double place);
    /// axis: unit, or null for all
    void valuesZoomed(const QString* unit, double factor, double place);
    void backRequested();
    void fitRequested();
    void valuesFitRequested(const QString& unit);
    void laneEdgeMoved(const QString& unit, double y); ///< of the lane above it; scene
    void laneMoved(const QString& unit, double y);     ///< it is dragged to this height; scene
    void laneReleased();
    void pauseRequested();
    void endRequested(bool newest); ///< the oldest, or the newest there is
    void cursorMoved(ui::Cursor which, double place);
    void cursorNudged(ui::Cursor which, double pixels);
    void cursorStepped(int samples); ///< the one that was moved last
    void cursorsRequested();
    void channelToggleRequested(int index);
    void toolTipRequested(const QPointF& scenePlace, const QPoint& screenPlace);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    enum class DragMode : std::uint8_t {
        Nothing,
        Box,
        Pan,
        PanValues,
        CursorA,
        CursorB,
        LaneEdge,
        Lane
    };

    QPointF fraction(const QPointF& scene) const;
    QRectF boxTo(const QPointF& scene) const;
    DragMode dragModeFor(const QMouseEvent& event, const QPointF& position);
    bool pinched(QGestureEvent* event);
    void hover(const QPointF& scene);
    bool moveKey(int key, Qt::KeyboardModifiers with);
    bool zoomKey(int key, Qt::KeyboardModifiers with);
    bool cursorKey(int key, const QString& text, Qt::KeyboardModifiers with);
    bool plainKey(int key);

    TrendScene* m_scene;
    DragMode m_dragMode = DragMode::Nothing;
    QPointF m_pressed; ///< scene
    QPointF m_last;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    bool m_hasMoved = false; ///< since it was pressed
    QString m_draggedLane;   ///< the unit of the lane that is held, or that above the edge
};
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of TrendChart: connects state, plot and overview, and paints at most 30 frames a
// second, however many changes are requested. Main thread.
#pragma once

#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_control.h"
#include "ui/charts/trend_overview.h"
#include "ui/charts/trend_view.h"

#include <QTimer>

#include <functional>

namespace ui {
class TrendChart::Private {
public:
    explicit Private(TrendChart* chart);

    TrendState& state() { return control.state(); }
    void connectAll();
    void updateColors();
    void rangeImmediately() { m_rangeImmediately = true; } ///< the next frame
    void channelsChanged();
    void changeChannel(int index, const std::function<bool(TrendChannel&)>& change);
    void showNotice();

    /// Now if the last one is long enough ago, otherwise as soon as it is.
    void scheduleFrame();
    void frame();
    /// What waits for its turn, and the fine picture, now.
    void flush();
    void advanceOverview(); ///< it can wait while the user zooms or pans
    void updateCursorReadings();

    TrendChart* const q;
    TrendControl control;
    TrendView* const plot;
    TrendOverview* const overview;

private:
    void connectPlot();
    void sharpen();
    void showTip(const QPointF& scene, const QPoint& screen);
    void nudge(Cursor which, double pixels);
    QString valuesAt(base::Duration at) const;

    QTimer m_frameTimer;
    QTimer m_idleTimer; ///< the view has not been changed for a moment
    QElapsedTimer m_sinceFrame;
    QElapsedTimer m_sinceReadings;
    bool m_rangeImmediately = true; ///< the next frame ranges the axes without patience
    bool m_coarseUpdates = false;   ///< the user zooms or pans
    bool m_isPanning = false;       ///< axes only grow until it ends: the curves do not jump
};
} // namespace ui

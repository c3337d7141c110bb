// SPDX-License-Identifier: GPL-3.0-or-later
// The strip below a chart: the whole history in small, and a handle over the span that is shown.
// Drag the handle to move it, its edges to resize it, press beside it to go there. The image of the
// history is repainted part by part, so that no frame takes long. Main thread.
#pragma once

#include "ui/charts/trace_raster.h"
#include "ui/charts/trend_colors.h"
#include "ui/charts/trend_scene.h"

#include <QElapsedTimer>
#include <QWidget>

namespace ui {
class TrendOverview final : public QWidget {
    Q_OBJECT

public:
    TrendOverview(const TrendState& state, QWidget* parent);

    void setColors(const TrendColors& colors);
    void rebuild();                  ///< other channels, another store
    void advance(bool busy = false); ///< once a frame; busy: another time, if it can wait
    QRectF handle() const;
    std::optional<recording::TimeSpan> history() const;

    QSize sizeHint() const override;

Q_SIGNALS:
    void dragStarted(); ///< a drag begins
    void spanRequested(const recording::TimeSpan& span);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    enum class Handle : std::uint8_t { None, Left, Right, Whole };

    bool isOutdated() const;
    void fetchNext();
    bool begin();
    void finish();
    Handle handleAt(double x) const;
    double xOf(base::Duration at) const;
    base::Duration timeAt(double x) const;

    const TrendState& m_state;
    TrendColors m_colors;
    TraceRaster m_raster;
    std::optional<recording::TimeSpan> m_shownHistory; ///< of m_image
    recording::TimeSpan m_nextHistory;
    std::vector<Trace> m_traces; ///< being fetched
    std::size_t m_nextChannel = 0;
    bool m_fetching = false;
    bool m_stale = true;
    QImage m_image;
    QElapsedTimer m_sinceImage;
    QRectF m_paintedHandle;
    Handle m_handle = Handle::None;
    double m_pressedAt = 0;
    recording::TimeSpan m_pressedSpan;
};
} // namespace ui

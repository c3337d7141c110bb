// SPDX-License-Identifier: GPL-3.0-or-later
// The one item of the chart that paints all curves, clipped to the plot's rectangle. On the screen
// from an image that is kept until something changes, so that a cursor being dragged costs nothing
// here; on paper as lines. Owned by the QChart; main thread.
#pragma once

#include "ui/charts/trace_raster.h"

#include <QGraphicsItem>

namespace ui {
class TraceItem final : public QGraphicsItem {
public:
    explicit TraceItem(QGraphicsItem* parent);

    void setPlot(const QRectF& plot);
    /// For lines instead of an image.
    void setPaper(bool on);
    void setSpan(const record::TimeSpan& span);
    /// Change them, then call changed().
    std::vector<Trace>& traces() { return m_traces; }
    const std::vector<Trace>& traces() const { return m_traces; }
    void changed();

    QRectF boundingRect() const override { return m_plot; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void paintImage(QPainter* painter);
    void paintLines(QPainter* painter) const;

    QRectF m_plot;
    record::TimeSpan m_span;
    std::vector<Trace> m_traces;
    QImage m_image;
    TraceRaster m_raster;
    bool m_paper = false;
    bool m_stale = true;
};
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// The one item of the chart that paints all curves, clipped to the plot's rectangle. On the screen
// from an image: while only time goes on it is shifted, and nothing but the new stretch is asked
// for and painted; a cursor being dragged costs nothing here. On paper as lines. Owned by the
// QChart; main thread.
#pragma once

#include "ui/charts/trace_raster.h"

#include <QGraphicsItem>

namespace ui {
class TraceItem final : public QGraphicsItem {
public:
    explicit TraceItem(QGraphicsItem* parent);

    void setPlot(const QRectF& plot);
    void setPaper(bool on) { m_paper = on; } ///< lines instead of an image
    void forget();                           ///< another store: nothing is kept

    /// Looks into the store. `ratio`: device pixels a logical one.
    void show(const record::SampleStore* store, const std::vector<TraceLook>& looks,
              const record::TimeSpan& span, double ratio);

    QRectF boundingRect() const override { return m_plot; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    struct Image {
        QImage pixels;
        double perPixel = 0;    ///< µs
        std::int64_t first = 0; ///< pixel at its left, counted from instant 0
        std::vector<TraceLook> looks;
        std::vector<std::optional<record::SamplePoint>> latest; ///< when it was painted
    };

    PixelRange shift(const record::SampleStore& store, const std::vector<TraceLook>& looks,
                     std::int64_t first, double perPixel);
    PixelRange unpainted(const record::SampleStore& store) const;
    void fetch(const record::SampleStore& store, const record::TimeSpan& span, double pixels);
    void paintLines(QPainter* painter) const;

    QRectF m_plot;
    record::TimeSpan m_span;
    std::vector<Trace> m_traces; ///< what was fetched last; its memory is used again
    Image m_image;
    TraceRaster m_raster;
    double m_ratio = 1;
    bool m_paper = false;
};
} // namespace ui

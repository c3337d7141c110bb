// SPDX-License-Identifier: GPL-3.0-or-later
// The one item of the chart that paints all curves, clipped to the plot's rectangle. On the screen
// it paints from an image: while only time advances the image is shifted, and only the new part is
// painted; dragging a cursor costs nothing here. While the user zooms or pans, a coarse image is
// shown, and the fine one is painted part by part when there is time. On paper it paints lines.
// Owned by the QChart; main thread.
#pragma once

#include "ui/charts/trace_raster.h"

#include <QGraphicsItem>

namespace ui {
class TraceItem final : public QGraphicsItem {
public:
    explicit TraceItem(QGraphicsItem* parent);

    void setPlot(const QRectF& plot);
    void setPaper(bool on) { m_paper = on; } ///< lines instead of an image
    void clear();                            ///< another store: nothing is kept

    /// Looks into the store. `ratio`: device pixels a logical one. `coarseUpdates`: the next change
    /// is expected at once.
    void show(const recording::SampleStore* store, const std::vector<TraceStyle>& styles,
              const recording::TimeSpan& span, double ratio, bool coarseUpdates);
    /// What is seen is the coarse image; paint again at rest.
    bool isCoarse() const { return m_coarse; }
    /// Makes a part of the fine image, of the samples and the view of the latest show().
    void refine(const recording::SampleStore& store);

    QRectF boundingRect() const override { return m_plot; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    struct Image {
        QImage pixels;
        PixelRange valid;       ///< painted, and as the samples are
        double perPixel = 0;    ///< µs
        std::int64_t first = 0; ///< pixel at its left, counted from instant 0
        std::vector<TraceStyle> styles;
        std::vector<std::optional<recording::SamplePoint>> latest; ///< when it was painted

        int missing() const { return pixels.width() - (valid.to - valid.from); }
        base::Duration at(int x) const;
    };

    bool shift(const recording::SampleStore& store, const std::vector<TraceStyle>& styles,
               const recording::TimeSpan& span, const QSize& size);
    int upToDate(const recording::SampleStore& store) const;
    void complete(const recording::SampleStore& store, int maxColumns);
    void paintPart(const recording::SampleStore& store, PixelRange part);
    void paintCoarse(const recording::SampleStore& store);
    void fetch(const recording::SampleStore& store, const recording::TimeSpan& span, double pixels);
    void paintLines(QPainter* painter) const;

    QRectF m_plot;
    recording::TimeSpan m_span;
    std::vector<Trace> m_traces; ///< what was fetched last; its memory is used again
    Image m_image;
    QImage m_coarseImage;
    TraceRaster m_raster;
    double m_ratio = 1;
    bool m_coarse = false;
    bool m_paper = false;
};
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
// A QChart that shows a TrendState: legend, axes, curves, marks, cursors. The same for the screen
// and for paper. Reads the store only in refresh(). Owned together with its QChart; main thread.
#pragma once

#include "ui/charts/lane_labels.h"
#include "ui/charts/off_scale_chips.h"
#include "ui/charts/trace_item.h"
#include "ui/charts/trend_axes.h"
#include "ui/charts/trend_channel.h"
#include "ui/charts/trend_overlay.h"

#include <QObject>

class QChart;
class QLineSeries;

namespace ui {
/// What a chart shows, without how. Store and marks are borrowed.
struct TrendState {
    const recording::SampleStore* store = nullptr;
    const std::vector<recording::Mark>* marks = nullptr;
    MarkTextFunction markTextFunction{};
    std::vector<TrendChannel> channels{};
    TimeView view{};
    bool live = true; ///< "now" goes on; else a recording stands there
    base::Duration origin{};
    std::optional<std::pair<base::Duration, base::Duration>> cursors{};
};

class TrendScene final : public QObject {
    Q_OBJECT

public:
    /// Calm: axes shrink with patience. AtOnce: the user has asked for another view.
    enum class Axes : std::uint8_t { Smooth, Immediate };

    TrendScene(QChart* chart, const TrendState& state, QObject* parent);

    void setColors(const TrendColors& colors);
    void setFont(const QFont& font);
    void setLanes(bool on); ///< each unit in a part of the plot of its own
    void setPaper(bool on);
    void setNotice(const QString& text) { m_overlay->setNotice(text); }

    void clearTraces() { m_traces->clear(); }
    void channelsChanged(); ///< other ones, or other names, colors, visibility
    void layOut();          ///< the chart's size has changed
    /// Fetches what is in view; `ratio`: device pixels a logical one. `coarseUpdates`: curves may
    /// be coarse, as the next change is expected at once.
    void refresh(Axes axes, double ratio, bool coarseUpdates = false);
    bool isCoarse() const { return m_traces->isCoarse(); }
    void refine(); ///< a part at a time, while coarse()
    /// Marks and cursors only.
    void refreshOverlay();

    const QRectF& plot() const { return m_plot; }
    bool hasCursors() const { return m_state.cursors.has_value(); }
    TrendAxes& axes() { return *m_axes; }
    TrendOverlay& overlay() { return *m_overlay; }
    const OffScaleChips& offScaleChips() const { return *m_offScaleChips; }

Q_SIGNALS:
    void legendClicked(int channel);

private:
    void rebuildSeries();
    void styleLegend();
    double layOutLegend(double width);
    std::optional<AxisRange> rangeInView(const QString& unit) const;
    void rangeAxes(Axes axes);
    void showOffScale();
    void showLaneLabels();
    void showTraces(double ratio, bool coarseUpdates);
    bool layOutPlot();

    QChart* m_chart;
    const TrendState& m_state;
    TrendAxes* m_axes;
    TraceItem* m_traces;
    LaneLabels* m_laneLabels;
    TrendOverlay* m_overlay;
    OffScaleChips* m_offScaleChips;
    std::vector<QLineSeries*> m_series; ///< empty ones; they give the legend its entries
    TrendColors m_colors;
    QRectF m_plot;
    double m_legendHeight = 0;
};
} // namespace ui

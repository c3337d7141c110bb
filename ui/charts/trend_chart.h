// SPDX-License-Identifier: GPL-3.0-or-later
// Trend chart of a sample store: the legend is Qt Charts', one item paints the axes and one all
// traces as min/max columns. Follows the newest sample or is paused; zoom by box, wheel and pinch,
// pan, overview strip, two cursors, marks. It never changes the store, which must outlive it.
// Repaints at most 30 times a second. Main thread.
#pragma once

#include "recording/trigger.h"
#include "ui/charts/trend_channel.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace ui {
struct TrendTable;

struct CursorReading {
    QString channel; ///< TrendChannel::key
    std::optional<double> a;
    std::optional<double> b;
    recording::SampleStatistics between;
};

class TrendChart final : public QWidget {
    Q_OBJECT

public:
    explicit TrendChart(QWidget* parent = nullptr);
    ~TrendChart() override;

    /// Null: nothing to show. The store must outlive the chart or be taken away first.
    void setStore(const recording::SampleStore* store);
    void setChannels(std::vector<TrendChannel> channels);
    const std::vector<TrendChannel>& channels() const;
    void setMarks(const std::vector<recording::Mark>* marks); ///< borrowed, in time order
    void setMarkTextFunction(MarkTextFunction words);         ///< without: the mark's own text
    /// Times on the axis count from here: 0 s is `instant` while not following; while following the
    /// right edge is 0 s.
    void setOrigin(base::Duration instant);
    /// False: the store is a recording; nothing is followed, and Space asks for playing.
    void setLive(bool live);
    /// Where "now" is, at about 30 Hz while following; repaints what is new.
    void advance(base::Duration now);

    using QWidget::show;
    /// A frame that waits for its turn is made now, and as fine as can be: while the view is being
    /// changed curves are painted coarsely, all extremes in, and fine ones follow a moment later.
    void flush();

    bool isFollowing() const;
    base::Duration width() const; ///< of time shown
    recording::TimeSpan shown() const;
    bool areCursorsVisible() const;
    std::optional<recording::TimeSpan> cursors() const; ///< A … B, in order of time
    /// A and B as they stand on the time axis: from the origin, or from now while following.
    std::optional<std::pair<base::Duration, base::Duration>> cursorTimes() const;
    std::vector<CursorReading> cursorReadings() const; ///< of the visible channels

    bool hasLanes() const;
    LaneLayout laneLayout() const;
    void setLaneLayout(const LaneLayout& layout);

    TrendTable shownTable() const; ///< of the visible channels
    bool savePng(const QString& path, QSize size, QString* errorMessage) const; ///< with legend
    bool saveSvg(const QString& path, QSize size, QString* errorMessage) const;

public Q_SLOTS:
    void setFollowing(bool on); ///< false: pause; the store goes on growing
    void setWidth(base::Duration width);
    void show(const recording::TimeSpan& span);         ///< stops following
    void setShownSpan(const recording::TimeSpan& span); ///< the same, without a step back
    void zoomToFit();                                   ///< everything there is; y too
    void zoomBack();                                    ///< the view before the last zoom
    void setCursorsShown(bool on);
    void setCursors(base::Duration a, base::Duration b);
    void setChannelVisible(int index, bool visible);
    void setLanes(bool on); ///< each unit in a part of the plot of its own; false: overlaid

Q_SIGNALS:
    void playRequested();     ///< Space, while not live
    void viewChanged();       ///< shown(), following(), width()
    void laneLayoutChanged(); ///< by the user
    void cursorsChanged();    ///< places, or what is read at them
    void channelsChanged();   ///< others, or their looks: legend, keys, list

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void retranslate();

    class Private;
    std::unique_ptr<Private> m_private;
};
} // namespace ui

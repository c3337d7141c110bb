// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_chart.h"

#include "ui/charts/axis_ticks.h"
#include "ui/charts/trend_chart_private.h"

#include <QEvent>
#include <QToolTip>
#include <QVBoxLayout>

namespace ui {
using base::Duration;
using recording::TimeSpan;

TrendChart::TrendChart(QWidget* parent)
    : QWidget(parent)
    , m_private(std::make_unique<Private>(this))
{
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_private->plot, 1);
    layout->addWidget(m_private->overview);
    setFocusProxy(m_private->plot);
    m_private->connectAll();
    m_private->updateColors();
    retranslate();
}

TrendChart::~TrendChart() = default;

void TrendChart::setStore(const recording::SampleStore* store)
{
    m_private->state().store = store;
    m_private->control.clearViewHistory();
    m_private->plot->picture().clearTraces();
    m_private->channelsChanged();
    if (areCursorsVisible())
        Q_EMIT cursorsChanged();
}

void TrendChart::setChannels(std::vector<TrendChannel> channels)
{
    m_private->state().channels = std::move(channels);
    m_private->channelsChanged();
    Q_EMIT channelsChanged();
    if (areCursorsVisible())
        Q_EMIT cursorsChanged();
}

const std::vector<TrendChannel>& TrendChart::channels() const
{
    return m_private->state().channels;
}

void TrendChart::setMarks(const std::vector<recording::Mark>* marks)
{
    m_private->state().marks = marks;
    m_private->plot->picture().refreshOverlay(); // it may be painted before the next frame
    m_private->scheduleFrame();
}

void TrendChart::setMarkTextFunction(MarkTextFunction words)
{
    m_private->state().markTextFunction = std::move(words);
    m_private->scheduleFrame();
}

void TrendChart::setOrigin(Duration instant)
{
    m_private->state().origin = instant;
    m_private->scheduleFrame();
}

void TrendChart::advance(Duration now)
{
    if (m_private->state().view.advance(now))
        m_private->scheduleFrame();
    else if (isVisible() && !isFollowing())
        m_private->advanceOverview(); // recording goes on
    m_private->updateCursorReadings();
}

void TrendChart::flush()
{
    m_private->flush();
}

bool TrendChart::isFollowing() const
{
    return m_private->state().view.isFollowing();
}

Duration TrendChart::width() const
{
    return m_private->state().view.width();
}

TimeSpan TrendChart::shown() const
{
    return m_private->state().view.span();
}

bool TrendChart::areCursorsVisible() const
{
    return m_private->state().cursors.has_value();
}

std::optional<TimeSpan> TrendChart::cursors() const
{
    const auto& pair = m_private->state().cursors;
    if (!pair)
        return {};
    return TimeSpan{std::min(pair->first, pair->second), std::max(pair->first, pair->second)};
}

std::optional<std::pair<Duration, Duration>> TrendChart::cursorTimes() const
{
    const TrendState& state = m_private->state();
    if (!state.cursors)
        return {};
    const Duration zero = isFollowing() ? shown().to : state.origin;
    return std::pair(state.cursors->first - zero, state.cursors->second - zero);
}

std::vector<CursorReading> TrendChart::cursorReadings() const
{
    std::vector<CursorReading> readings;
    const TrendState& state = m_private->state();
    const auto places = cursors();
    if (!places || state.store == nullptr)
        return readings;
    const auto all = state.store->span();
    const auto valueAt = [&](recording::ChannelId id, Duration at) -> std::optional<double> {
        if (!all || at > all->to)
            return {};
        const auto point = state.store->at(id, at);
        return point ? std::optional(point->value) : std::nullopt;
    };
    for (const TrendChannel& channel : state.channels) {
        if (!channel.visible || channel.id < 0)
            continue;
        readings.push_back({channel.key, valueAt(channel.id, state.cursors->first),
                            valueAt(channel.id, state.cursors->second),
                            state.store->statistics(channel.id, *places)});
    }
    return readings;
}

void TrendChart::setLive(bool live)
{
    m_private->state().live = live;
    m_private->control.clearViewHistory();
    if (!live)
        m_private->state().view.setFollowing(false);
}

void TrendChart::setShownSpan(const TimeSpan& span)
{
    m_private->control.drag(span);
}

void TrendChart::setFollowing(bool on)
{
    m_private->control.follow(on);
}

void TrendChart::setWidth(Duration width)
{
    m_private->control.setWidth(width);
}

void TrendChart::show(const TimeSpan& span)
{
    m_private->control.show(span);
}

void TrendChart::zoomToFit()
{
    m_private->control.zoomToFit();
}

void TrendChart::zoomBack()
{
    m_private->control.goBack();
}

void TrendChart::setCursorsShown(bool on)
{
    m_private->control.showCursors(on);
}

void TrendChart::setCursors(Duration a, Duration b)
{
    m_private->control.setCursors(a, b);
}

void TrendChart::setChannelVisible(int index, bool visible)
{
    m_private->changeChannel(index, [visible](TrendChannel& channel) {
        return std::exchange(channel.visible, visible) != visible;
    });
}

void TrendChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_private->updateColors();
    QWidget::changeEvent(event);
}

void TrendChart::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_private->frame();
}

void TrendChart::retranslate()
{
    m_private->plot->setAccessibleName(tr("Trend chart"));
    m_private->plot->setToolTip(
        tr("Drag: pan. Wheel: zoom time. Shift+wheel: zoom values. Ctrl+drag: zoom into a box. "
           "Double-click: show all. Backspace: previous view. Space: pause."));
    m_private->overview->setAccessibleName(tr("Whole recording"));
    m_private->overview->setToolTip(tr("All recorded data; drag the frame to show another part, or "
                                       "drag its edges to show more or less."));
    m_private->showNotice();
}

bool TrendChart::hasLanes() const
{
    return m_private->plot->picture().axes().hasLanes();
}

LaneLayout TrendChart::laneLayout() const
{
    return m_private->plot->picture().axes().laneLayout();
}

void TrendChart::setLaneLayout(const LaneLayout& layout)
{
    m_private->plot->picture().axes().setLaneLayout(layout);
    m_private->scheduleFrame();
}

void TrendChart::setLanes(bool on)
{
    m_private->plot->picture().setLanes(on);
    m_private->rangeImmediately();
    m_private->scheduleFrame();
}
} // namespace ui

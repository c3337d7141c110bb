// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_chart_private.h"

#include "ui/charts/axis_ticks.h"

#include <QChart>
#include <QToolTip>

namespace ui {
namespace {
constexpr int frameMs = 33;
constexpr int idleMs = 120;     ///< after the last change of the view the fine image is painted
constexpr int partMs = 10;      ///< between its parts
constexpr int readingsMs = 400; ///< while the span between the cursors still fills
} // namespace

TrendChart::Private::Private(TrendChart* chart)
    : q(chart)
    , control(nullptr)
    , plot(new TrendView(control.state(), chart))
    , overview(new TrendOverview(control.state(), chart))
{
    control.setAxes(&plot->picture().axes());
    plot->setObjectName(QStringLiteral("trendPlot"));
    overview->setObjectName(QStringLiteral("trendOverview"));
    m_frameTimer.setSingleShot(true);
    m_frameTimer.setTimerType(Qt::PreciseTimer);
    m_idleTimer.setSingleShot(true);
}

void TrendChart::Private::connectAll()
{
    QObject::connect(&m_frameTimer, &QTimer::timeout, q, [this] { frame(); });
    QObject::connect(&m_idleTimer, &QTimer::timeout, q, [this] { sharpen(); });
    QObject::connect(&control, &TrendControl::viewChanged, q, [this] {
        m_rangeImmediately = m_rangeImmediately || !m_isPanning;
        m_coarseUpdates = true;
        scheduleFrame();
        Q_EMIT q->viewChanged();
    });
    QObject::connect(&control, &TrendControl::cursorsChanged, q, [this] {
        plot->picture().refreshOverlay();
        Q_EMIT q->cursorsChanged();
    });
    QObject::connect(overview, &TrendOverview::spanRequested, &control,
                     [this](const recording::TimeSpan& span) { control.drag(span); });
    QObject::connect(overview, &TrendOverview::dragStarted, &control,
                     [this] { control.pushView(); });
    connectPlot();
}

void TrendChart::Private::connectPlot()
{
    TrendControl* const c = &control;
    QObject::connect(plot, &TrendView::resized, q, [this] {
        plot->picture().layOut();
        m_rangeImmediately = true;
        frame();
    });
    QObject::connect(plot, &TrendView::boxDrawn, c, &TrendControl::zoomToBox);
    QObject::connect(plot, &TrendView::panned, c, [this](double x, double y) {
        m_isPanning = true;
        control.pan(x, y);
        m_isPanning = false;
    });
    QObject::connect(plot, &TrendView::valuesPanned, c, &TrendControl::panValues);
    QObject::connect(plot, &TrendView::panStarted, c, &TrendControl::pushView);
    QObject::connect(plot, &TrendView::panEnded, q, [this] {
        m_rangeImmediately = true;
        scheduleFrame();
    });
    QObject::connect(plot, &TrendView::zoomed, c, &TrendControl::zoom);
    QObject::connect(plot, &TrendView::valuesZoomed, c, &TrendControl::zoomValues);
    QObject::connect(plot, &TrendView::backRequested, c, &TrendControl::goBack);
    QObject::connect(plot, &TrendView::fitRequested, c, &TrendControl::zoomToFit);
    QObject::connect(plot, &TrendView::valuesFitRequested, c, &TrendControl::fitValues);
    QObject::connect(plot, &TrendView::cursorStepped, c, &TrendControl::stepCursor);
    QObject::connect(plot, &TrendView::laneEdgeMoved, q, [this](const QString& unit, double y) {
        TrendAxes& axes = plot->picture().axes();
        axes.moveLaneEdge(axes.axisOf(unit), y);
        scheduleFrame();
    });
    QObject::connect(plot, &TrendView::laneMoved, q, [this](const QString& unit, double y) {
        plot->picture().axes().moveLane(unit, y);
        scheduleFrame();
    });
    QObject::connect(plot, &TrendView::laneReleased, q, &TrendChart::laneLayoutChanged);
    QObject::connect(plot, &TrendView::endRequested, c, &TrendControl::showEnd);
    QObject::connect(plot, &TrendView::pauseRequested, c, [this] {
        if (state().live)
            control.follow(!state().view.isFollowing());
        else
            Q_EMIT q->playRequested();
    });
    QObject::connect(plot, &TrendView::cursorsRequested, c,
                     [this] { control.showCursors(!state().cursors); });
    QObject::connect(plot, &TrendView::cursorMoved, c, [this](Cursor which, double place) {
        control.moveCursor(which, state().view.timeAt(place));
    });
    QObject::connect(plot, &TrendView::cursorNudged, c,
                     [this](Cursor which, double pixels) { nudge(which, pixels); });
    const auto toggle = [this](int index) {
        const auto& channels = state().channels;
        if (std::size_t(index) < channels.size())
            q->setChannelVisible(index, !channels[std::size_t(index)].visible);
    };
    QObject::connect(plot, &TrendView::channelToggleRequested, q, toggle);
    QObject::connect(&plot->picture(), &TrendScene::legendClicked, q, toggle);
    QObject::connect(plot, &TrendView::toolTipRequested, q,
                     [this](const QPointF& scene, const QPoint& at) { showTip(scene, at); });
}

void TrendChart::Private::nudge(Cursor which, double pixels)
{
    control.showCursors(true);
    const double width = std::max(plot->picture().plot().width(), 1.0);
    const auto step = double(state().view.width().count()) / width;
    const base::Duration from =
        which == Cursor::A ? state().cursors->first : state().cursors->second;
    control.moveCursor(which, from + base::Duration(std::llround(pixels * step)));
}

void TrendChart::Private::updateColors()
{
    const TrendColors colors = TrendColors::of(q->palette());
    plot->setBackgroundBrush(colors.background);
    plot->picture().setFont(q->font());
    plot->picture().setColors(colors);
    overview->setColors(colors);
    plot->picture().layOut();
    m_rangeImmediately = true;
    scheduleFrame();
}

void TrendChart::Private::channelsChanged()
{
    plot->picture().channelsChanged();
    plot->picture().layOut();
    overview->rebuild();
    showNotice();
    m_rangeImmediately = true;
    scheduleFrame();
}

void TrendChart::Private::changeChannel(int index, const std::function<bool(TrendChannel&)>& change)
{
    auto& channels = state().channels;
    if (index < 0 || std::size_t(index) >= channels.size() || !change(channels[std::size_t(index)]))
        return;
    channelsChanged();
    Q_EMIT q->channelsChanged();
    if (state().cursors)
        Q_EMIT q->cursorsChanged();
}

void TrendChart::Private::showNotice()
{
    const auto& channels = state().channels;
    const bool any = std::any_of(channels.begin(), channels.end(),
                                 [](const TrendChannel& channel) { return channel.visible; });
    plot->picture().setNotice(channels.empty() ? TrendChart::tr("No channels selected")
                              : any            ? QString()
                                               : TrendChart::tr("All channels are hidden"));
}

void TrendChart::Private::scheduleFrame()
{
    if (!q->isVisible() || m_frameTimer.isActive())
        return;
    const qint64 passed = m_sinceFrame.isValid() ? m_sinceFrame.elapsed() : frameMs;
    if (passed >= frameMs)
        frame();
    else
        m_frameTimer.start(int(frameMs - passed));
}

void TrendChart::Private::frame()
{
    m_frameTimer.stop();
    m_sinceFrame.start();
    plot->picture().refresh(m_rangeImmediately ? TrendScene::Axes::Immediate
                                               : TrendScene::Axes::Smooth,
                            plot->devicePixelRatioF(), m_coarseUpdates);
    if (m_coarseUpdates || (plot->picture().isCoarse() && !m_idleTimer.isActive()))
        m_idleTimer.start(idleMs);
    advanceOverview();
    m_rangeImmediately = m_coarseUpdates = false;
}

void TrendChart::Private::advanceOverview()
{
    overview->advance(m_idleTimer.isActive());
}

void TrendChart::Private::sharpen()
{
    plot->picture().refine();
    if (plot->picture().isCoarse())
        m_idleTimer.start(partMs);
}

void TrendChart::Private::flush()
{
    if (m_frameTimer.isActive())
        frame();
    while (plot->picture().isCoarse())
        plot->picture().refine();
}

/// Statistics between the cursors change while new samples arrive there.
void TrendChart::Private::updateCursorReadings()
{
    const auto places = q->cursors();
    if (!places || state().store == nullptr || places->to < state().view.now())
        return;
    if (m_sinceReadings.isValid() && m_sinceReadings.elapsed() < readingsMs)
        return;
    m_sinceReadings.start();
    Q_EMIT q->cursorsChanged();
}

void TrendChart::Private::showTip(const QPointF& scene, const QPoint& screen)
{
    const QRectF& area = plot->picture().plot();
    const QString marks = plot->picture().overlay().marksAt(scene);
    if (!marks.isEmpty()) {
        QToolTip::showText(screen, marks, plot);
        return;
    }
    if (plot->picture().axes().laneLabelAt(scene) != nullptr) {
        QToolTip::showText(screen, TrendChart::tr("Drag up or down to move this lane"), plot);
        return;
    }
    if (!area.contains(scene) || state().store == nullptr) {
        QToolTip::showText(screen, plot->toolTip(), plot);
        return;
    }
    const double place = (scene.x() - area.left()) / area.width();
    QToolTip::showText(screen, valuesAt(state().view.timeAt(place)), plot);
}

QString TrendChart::Private::valuesAt(base::Duration at) const
{
    const TrendState& shown = control.state();
    const base::Duration zero = shown.view.isFollowing() ? shown.view.span().to : shown.origin;
    QStringList lines{spanText(double((at - zero).count()) / 1e6)};
    for (const TrendChannel& channel : shown.channels) {
        const auto point =
            channel.visible && channel.id >= 0 ? shown.store->at(channel.id, at) : std::nullopt;
        if (point)
            lines << QStringLiteral("%1: %2 %3")
                         .arg(channel.name, readingText(point->value, point->value), channel.unit);
    }
    return lines.join(QLatin1Char('\n'));
}
} // namespace ui

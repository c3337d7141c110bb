// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_chart_private.h"

#include "ui/charts/axis_ticks.h"

#include <QChart>
#include <QToolTip>

namespace ui {
namespace {
constexpr int frameMs = 33;
constexpr int leisureMs = 120;  ///< after the last change of the view the picture becomes fine
constexpr int partMs = 10;      ///< between its parts
constexpr int readingsMs = 400; ///< of cursors whose stretch still fills
} // namespace

TrendChart::Private::Private(TrendChart* chart)
    : q(chart)
    , control(nullptr)
    , plot(new TrendPlot(control.state(), chart))
    , overview(new TrendOverview(control.state(), chart))
{
    control.setAxes(&plot->picture().axes());
    plot->setObjectName(QStringLiteral("trendPlot"));
    overview->setObjectName(QStringLiteral("trendOverview"));
    m_later.setSingleShot(true);
    m_later.setTimerType(Qt::PreciseTimer);
    m_leisure.setSingleShot(true);
}

void TrendChart::Private::connectAll()
{
    QObject::connect(&m_later, &QTimer::timeout, q, [this] { frame(); });
    QObject::connect(&m_leisure, &QTimer::timeout, q, [this] { sharpen(); });
    QObject::connect(&control, &TrendControl::viewChanged, q, [this] {
        m_atOnce = m_hasty = true;
        frameSoon();
        Q_EMIT q->viewChanged();
    });
    QObject::connect(&control, &TrendControl::cursorsChanged, q, [this] {
        plot->picture().refreshOverlay();
        Q_EMIT q->cursorsChanged();
    });
    QObject::connect(overview, &TrendOverview::wished, &control,
                     [this](const record::TimeSpan& span) { control.drag(span); });
    QObject::connect(overview, &TrendOverview::grabbed, &control,
                     [this] { control.rememberView(); });
    connectPlot();
}

void TrendChart::Private::connectPlot()
{
    TrendControl* const c = &control;
    QObject::connect(plot, &TrendPlot::resized, q, [this] {
        plot->picture().layOut();
        m_atOnce = true;
        frame();
    });
    QObject::connect(plot, &TrendPlot::boxed, c, &TrendControl::box);
    QObject::connect(plot, &TrendPlot::panned, c,
                     [c](double x, double y) { c->pan(x, y, x == 0); });
    QObject::connect(plot, &TrendPlot::zoomed, c, &TrendControl::zoom);
    QObject::connect(plot, &TrendPlot::valuesZoomed, c, &TrendControl::zoomValues);
    QObject::connect(plot, &TrendPlot::backWished, c, &TrendControl::back);
    QObject::connect(plot, &TrendPlot::fitWished, c, &TrendControl::fit);
    QObject::connect(plot, &TrendPlot::endWished, c, &TrendControl::goToEnd);
    QObject::connect(plot, &TrendPlot::pauseWished, c, [this] {
        if (state().live)
            control.follow(!state().view.following());
        else
            Q_EMIT q->playWished();
    });
    QObject::connect(plot, &TrendPlot::cursorsWished, c,
                     [this] { control.showCursors(!state().cursors); });
    QObject::connect(plot, &TrendPlot::cursorMoved, c, [this](Cursor which, double place) {
        control.moveCursor(which, state().view.at(place));
    });
    QObject::connect(plot, &TrendPlot::cursorNudged, c,
                     [this](Cursor which, double pixels) { nudge(which, pixels); });
    const auto toggle = [this](int index) {
        const auto& channels = state().channels;
        if (std::size_t(index) < channels.size())
            q->setChannelVisible(index, !channels[std::size_t(index)].visible);
    };
    QObject::connect(plot, &TrendPlot::channelWished, q, toggle);
    QObject::connect(&plot->picture(), &TrendPicture::legendClicked, q, toggle);
    QObject::connect(plot, &TrendPlot::tipWished, q,
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

void TrendChart::Private::takeColours()
{
    const TrendColours colours = TrendColours::of(q->palette());
    plot->setBackgroundBrush(colours.ground);
    plot->picture().setFont(q->font());
    plot->picture().setColours(colours);
    overview->setColours(colours);
    plot->picture().layOut();
    m_atOnce = true;
    frameSoon();
}

void TrendChart::Private::channelsChanged()
{
    plot->picture().channelsChanged();
    plot->picture().layOut();
    overview->rebuild();
    showNotice();
    m_atOnce = true;
    frameSoon();
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
    plot->picture().setNotice(channels.empty() ? TrendChart::tr("No channels chosen")
                              : any            ? QString()
                                               : TrendChart::tr("All channels are hidden"));
}

void TrendChart::Private::frameSoon()
{
    if (!q->isVisible() || m_later.isActive())
        return;
    const qint64 passed = m_sinceFrame.isValid() ? m_sinceFrame.elapsed() : frameMs;
    if (passed >= frameMs)
        frame();
    else
        m_later.start(int(frameMs - passed));
}

void TrendChart::Private::frame()
{
    m_later.stop();
    m_sinceFrame.start();
    plot->picture().refresh(m_atOnce ? TrendPicture::Axes::AtOnce : TrendPicture::Axes::Calm,
                            plot->devicePixelRatioF(), m_hasty);
    if (m_hasty || (plot->picture().coarse() && !m_leisure.isActive()))
        m_leisure.start(leisureMs);
    advanceOverview();
    m_atOnce = m_hasty = false;
}

void TrendChart::Private::advanceOverview()
{
    overview->advance(m_leisure.isActive());
}

void TrendChart::Private::sharpen()
{
    plot->picture().sharpen();
    if (plot->picture().coarse())
        m_leisure.start(partMs);
}

void TrendChart::Private::flush()
{
    if (m_later.isActive())
        frame();
    while (plot->picture().coarse())
        plot->picture().sharpen();
}

/// What is read between the cursors changes while samples still come in there.
void TrendChart::Private::cursorsGrow()
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
    if (!area.contains(scene) || state().store == nullptr) {
        QToolTip::showText(screen, plot->toolTip(), plot);
        return;
    }
    const double place = (scene.x() - area.left()) / area.width();
    QToolTip::showText(screen, valuesAt(state().view.at(place)), plot);
}

QString TrendChart::Private::valuesAt(base::Duration at) const
{
    const TrendState& shown = control.state();
    const base::Duration zero = shown.view.following() ? shown.view.span().to : shown.origin;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_panel.h"

#include "ui/charts/trend_chart.h"
#include "ui/common/palette.h"
#include "ui/common/widget_style.h"
#include "ui/trends/channels_dialog.h"
#include "ui/trends/cursor_table.h"
#include "ui/trends/export_control.h"
#include "ui/trends/recording_control.h"
#include "ui/trends/trend_preset.h"
#include "ui/trends/trend_replay.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/trends/trigger_control.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/replay_bar.h"

#include <QEvent>
#include <QInputDialog>
#include <QVBoxLayout>

#include <utility>

namespace ui {
using base::Duration;

namespace {
const QString subscriptionName = QStringLiteral("trend");
/// Often enough to count the turns and to see short alarms of the servos whose curves are shown,
/// and for curves without gaps.
constexpr Duration hiddenPeriod = std::chrono::milliseconds(100);
} // namespace

TrendPanel::TrendPanel(session::Workbench& workbench, session::LiveData& liveData,
                       Selection& selection, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_workbenchGuard(&workbench)
    , m_liveData(liveData)
    , m_selection(selection)
    , m_settings(settings)
    , m_curves(m_settings.curves())
{
    build();
    m_replay = new TrendReplay(m_workbench.registry(), m_settings,
                               {*m_chart, *m_replayBar, *m_toolbar, *m_banner}, this);
    m_trigger = new TriggerControl(m_workbench.registry(), m_liveData, m_selection,
                                   {*m_chart, *m_toolbar, *m_replay}, this);
    m_export = new ExportControl(*m_chart, *m_banner, settings, this);
    m_recording = new RecordingControl(m_liveData.recording(), settings,
                                       {*m_chart, *m_toolbar, *m_banner}, this);
    connectToolbar();
    connectChart();
    connectLiveData();
    showPresets();
    showCurves();
}

TrendPanel::~TrendPanel() = default;

QWidget* TrendPanel::chart() const
{
    return m_chart;
}

bool TrendPanel::isReplaying() const
{
    return m_replay->isActive();
}

void TrendPanel::build()
{
    setObjectName(QStringLiteral("trendPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("trendBanner"));
    m_toolbar = new TrendToolbar(this);
    m_chart = new TrendChart(this);
    m_chart->setObjectName(QStringLiteral("trendChart"));
    m_chart->setContextMenuPolicy(Qt::CustomContextMenu);
    m_cursors = new CursorTable(m_chart, this);
    m_cursors->setObjectName(QStringLiteral("cursorPanel"));
    m_cursors->setVisible(false);
    m_replayBar = new ReplayBar(this);
    m_replayBar->setVisible(false);
    column->addWidget(m_banner);
    column->addWidget(m_toolbar);
    column->addWidget(m_chart, 1);
    column->addWidget(m_replayBar);
    column->addWidget(m_cursors);
    makeCard(this);
    m_chart->setStore(&m_liveData.store());
    m_chart->setMarks(&m_liveData.marks());
    m_chart->setMarkTextFunction(
        [this](const recording::Mark& mark) { return markText(m_workbench.registry(), mark); });
    m_chart->setWidth(m_settings.width());
    m_toolbar->setShownWidth(m_chart->width());
    m_chart->setLaneLayout(m_settings.laneLayout());
    m_chart->setLanes(m_settings.hasLanes());
    m_toolbar->setLanes(m_settings.hasLanes());
    m_toolbar->setMemory(m_settings.memory());
    m_liveData.setBudget(std::size_t(m_settings.memory()) << 20);
    m_toolbar->setRate(m_settings.rate());
    setRate(m_settings.rate());
}

void TrendPanel::connectToolbar()
{
    connect(m_toolbar, &TrendToolbar::followRequested, m_chart, &TrendChart::setFollowing);
    connect(m_toolbar, &TrendToolbar::fitRequested, m_chart, &TrendChart::zoomToFit);
    connect(m_toolbar, &TrendToolbar::backRequested, m_chart, &TrendChart::zoomBack);
    connect(m_toolbar, &TrendToolbar::cursorsRequested, m_chart, &TrendChart::setCursorsShown);
    connect(m_toolbar, &TrendToolbar::lanesRequested, this, [this](bool on) {
        m_settings.setLanes(on);
        m_chart->setLanes(on);
    });
    connect(m_toolbar, &TrendToolbar::channelsRequested, this, &TrendPanel::chooseChannels);
    connect(m_toolbar, &TrendToolbar::triggerRequested, m_trigger, &TriggerControl::choose);
    connect(m_toolbar, &TrendToolbar::recordRequested, m_recording, &RecordingControl::toggle);
    connect(m_toolbar, &TrendToolbar::openRequested, m_replay, &TrendReplay::open);
    connect(m_toolbar, &TrendToolbar::liveRequested, m_replay, &TrendReplay::close);
    connect(m_toolbar, &TrendToolbar::exportRequested, m_export, &ExportControl::choose);
    connect(m_chart, &QWidget::customContextMenuRequested, m_toolbar,
            [this](const QPoint& at) { m_toolbar->showMenu(m_chart->mapToGlobal(at)); });
    connect(m_toolbar, &TrendToolbar::clearRequested, &m_liveData, &session::LiveData::clear);
    connect(m_toolbar, &TrendToolbar::presetRequested, this, &TrendPanel::applyPreset);
    connect(m_toolbar, &TrendToolbar::presetSaveRequested, this,
            qOverload<>(&TrendPanel::savePresetAs));
    connect(m_toolbar, &TrendToolbar::presetRemoveRequested, this, [this](const QString& name) {
        deletePreset(m_settings.all(), name);
        showPresets();
    });
    connect(m_toolbar, &TrendToolbar::widthRequested, this, [this](Duration width) {
        m_chart->setWidth(width);
        m_settings.setWidth(width);
    });
    connect(m_toolbar, &TrendToolbar::memoryRequested, this, [this](int megabytes) {
        m_settings.setMemory(megabytes);
        m_liveData.setBudget(std::size_t(megabytes) << 20);
        samplesAdded(); // there may be fewer
    });
    connect(&m_liveData, &session::LiveData::triggerChanged, this, &TrendPanel::updateSubscription);
    connect(m_toolbar, &TrendToolbar::rateRequested, this, [this](int hz) {
        m_settings.setRate(hz);
        setRate(hz);
        updateSubscription();
        Q_EMIT periodChanged();
    });
}

void TrendPanel::connectChart()
{
    connect(m_chart, &TrendChart::viewChanged, this, [this] {
        m_toolbar->setFollowing(m_chart->isFollowing());
        m_toolbar->setShownWidth(m_chart->width());
    });
    connect(m_chart, &TrendChart::cursorsChanged, this, [this] {
        m_toolbar->setCursorsShown(m_chart->areCursorsVisible());
        m_cursors->setVisible(m_chart->areCursorsVisible());
    });
    connect(m_chart, &TrendChart::laneLayoutChanged, this,
            [this] { m_settings.setLaneLayout(m_chart->laneLayout()); });
    connect(m_chart, &TrendChart::playRequested, this, &TrendPanel::toggleFollowing);
    connect(m_chart, &TrendChart::channelsChanged, this, &TrendPanel::applyLegend);
    connect(m_replay, &TrendReplay::shown, this, &TrendPanel::replayShown);
    connect(m_replay, &TrendReplay::closed, this, &TrendPanel::showLiveReadings);
}

void TrendPanel::connectLiveData()
{
    connect(&m_liveData, &session::LiveData::samplesAdded, this, &TrendPanel::samplesAdded);
    connect(&m_liveData, &session::LiveData::channelsChanged, this, &TrendPanel::showCurves);
    connect(&m_selection, &Selection::changed, this, &TrendPanel::showCurves);
    const session::ServoRegistry* registry = &m_workbench.registry();
    connect(registry, &session::ServoRegistry::servoAdded, this, &TrendPanel::showCurves);
    connect(registry, &session::ServoRegistry::servoRemoved, this, &TrendPanel::showCurves);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &TrendPanel::updateSubscription);
}

/// 0: as fast as the bus allows.
void TrendPanel::setRate(int hz)
{
    m_period = hz > 0 ? Duration(1'000'000 / hz) : Duration{};
    m_liveData.setPeriod(m_period);
}

void TrendPanel::samplesAdded()
{
    if (isReplaying() || !isVisible())
        return;
    if (followTorque())
        showCurves();
    m_chart->advance(m_workbench.now());
}

/// From when on the goals of each servo are meant; true if that has changed.
bool TrendPanel::followTorque()
{
    bool changed = false;
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const bool isOff = isTorqueOff(*m_workbench.registry().servo(ref));
        const auto known = m_goalsFrom.try_emplace(ref, Duration::min()).first;
        const bool wasOff = known->second == Duration::max();
        if (isOff == wasOff)
            continue;
        known->second = isOff ? Duration::max() : m_workbench.now();
        changed = true;
    }
    return changed;
}

void TrendPanel::showLiveReadings()
{
    m_chart->setMarks(&m_liveData.marks());
    m_chart->setStore(&m_liveData.store());
    m_chart->setLive(true);
    showCurves();
    m_chart->setWidth(m_settings.width());
    m_chart->setFollowing(true);
    samplesAdded();
}

TrendResolver TrendPanel::resolver() const
{
    return {m_workbench.registry(), m_liveData, m_selection.current()};
}

/// Shows the chosen curves whose servos are in the list.
void TrendPanel::showCurves()
{
    updateSubscription();
    if (isReplaying())
        return;
    QStringList keys;
    for (const TrendCurve& curve : m_curves)
        keys << curve.key;
    const std::vector<QColor> colors = trendColors(keys, palette().color(QPalette::Base));
    std::vector<TrendChannel> channels;
    m_shownCurves.clear();
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        auto channel = resolver().channel(m_curves[i], colors[i]);
        if (!channel)
            continue;
        const auto goalsFrom = m_goalsFrom.find(resolver().servoOf(m_curves[i]));
        if (channel->dashed && goalsFrom != m_goalsFrom.end())
            channel->axisFrom = goalsFrom->second;
        channels.push_back(std::move(*channel));
        m_shownCurves.push_back(i);
    }
    m_updatingChart = true;
    m_chart->setChannels(std::move(channels));
    m_updatingChart = false;
}

void TrendPanel::updateSubscription()
{
    if (!m_workbenchGuard)
        return;
    session::Subscription subscription = resolver().subscription(m_curves);
    // On other pages the curves go on, with less detail; a recording has a subscription of its own.
    const auto trigger = m_liveData.trigger().state();
    const bool isAwaited =
        trigger == recording::Trigger::State::Armed || trigger == recording::Trigger::State::Fired;
    subscription.period = isVisible() || isAwaited ? m_period : std::max(m_period, hiddenPeriod);
    m_workbench.polling().subscribe(subscriptionName, subscription);
}

void TrendPanel::setCurves(const std::vector<TrendCurve>& curves)
{
    m_curves = curves;
    m_settings.setCurves(m_curves);
    showCurves();
}

void TrendPanel::showCurvesInDialog()
{
    if (auto* dialog = findChild<ChannelsDialog*>())
        dialog->setCurves(m_curves);
}

/// A curve was hidden or shown at the legend.
void TrendPanel::applyLegend()
{
    if (m_updatingChart || isReplaying())
        return;
    const auto& channels = m_chart->channels();
    for (std::size_t i = 0; i < channels.size() && i < m_shownCurves.size(); ++i)
        m_curves[m_shownCurves[i]].visible = channels[i].visible;
    m_settings.setCurves(m_curves);
    updateSubscription();
    showCurvesInDialog();
}

void TrendPanel::chooseChannels()
{
    auto* dialog = findChild<ChannelsDialog*>(); // one is enough
    if (dialog == nullptr) {
        dialog = new ChannelsDialog(m_workbench.registry(), m_curves, this);
        connect(dialog, &ChannelsDialog::curvesChanged, this, &TrendPanel::setCurves);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void TrendPanel::toggleFollowing()
{
    if (isReplaying())
        m_replay->togglePlaying();
    else
        m_chart->setFollowing(!m_chart->isFollowing());
}

void TrendPanel::toggleRecording()
{
    m_recording->toggle();
}

void TrendPanel::openRecording()
{
    m_replay->open();
}

void TrendPanel::load(const QString& path)
{
    m_replay->load(path);
}

void TrendPanel::showPresets()
{
    m_toolbar->setPresets(presetNames(m_settings.all()));
}

void TrendPanel::savePresetAs()
{
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("presetDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save view"));
    dialog->setLabelText(tr("Name:"));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this](const QString& typed) { savePresetAs(typed.trimmed()); });
    dialog->open();
}

void TrendPanel::savePresetAs(const QString& name)
{
    TrendPreset preset;
    preset.width = m_chart->width();
    for (const TrendCurve& curve : m_curves)
        preset.channels.push_back(
            {curve.id(), curve.visible, curve.color, curve.scale, curve.offset});
    if (savePreset(m_settings.all(), name, preset))
        showPresets();
}

void TrendPanel::applyPreset(const QString& name)
{
    const auto preset = loadPreset(m_settings.all(), name);
    if (!preset)
        return;
    std::vector<TrendCurve> curves;
    for (const PresetChannel& channel : preset->channels) {
        TrendCurve curve = TrendCurve::fromId(channel.key);
        curve.visible = channel.visible;
        curve.color = channel.color;
        curve.scale = channel.scale;
        curve.offset = channel.offset;
        curves.push_back(curve);
    }
    setCurves(curves);
    showCurvesInDialog();
    m_chart->setWidth(preset->width);
}

void TrendPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        showCurves();
        m_trigger->retranslate();
        m_recording->retranslate();
    } else if (event->type() == QEvent::PaletteChange) {
        showCurves();
    }
}

void TrendPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showCurves();
    samplesAdded();
}

void TrendPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    updateSubscription();
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trend_panel.h"

#include "text/error_text.h"
#include "ui/charts/cursor_table.h"
#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_preset.h"
#include "ui/trends/channels_dialog.h"
#include "ui/trends/record_dialog.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/trends/trigger_dialog.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/replay_bar.h"

#include <QEvent>
#include <QVBoxLayout>

#include <utility>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

namespace {
const QString curvesKey = QStringLiteral("trend/curves");
const QString widthKey = QStringLiteral("trend/width_s");
const QString rateKey = QStringLiteral("trend/rate_hz");
const QString subscriptionName = QStringLiteral("trend");
constexpr int defaultSeconds = 10;

/// One text a curve: "1/present_position;visible;#rrggbb;scale;offset".
QString toText(const TrendCurve& choice)
{
    return QStringList{choice.id(), choice.visible ? QStringLiteral("1") : QStringLiteral("0"),
                       choice.color.isValid() ? choice.color.name() : QString(),
                       QString::number(choice.scale, 'g', 10),
                       QString::number(choice.offset, 'g', 10)}
        .join(QLatin1Char(';'));
}

TrendCurve fromText(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char(';'));
    TrendCurve choice = TrendCurve::fromId(parts.value(0));
    choice.visible = parts.value(1) != QLatin1String("0");
    choice.color = QColor(parts.value(2));
    const double scale = parts.value(3).toDouble();
    choice.scale = scale != 0 ? scale : 1;
    choice.offset = parts.value(4).toDouble();
    return choice;
}
} // namespace

TrendPanel::TrendPanel(session::Desk& desk, session::LiveData& scope, Selection& selection,
                       session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_deskGuard(&desk)
    , m_liveData(scope)
    , m_selection(selection)
    , m_settings(settings)
{
    for (const QString& text : settings.pageValue(curvesKey, QStringList()).toStringList()) {
        const TrendCurve choice = fromText(text);
        if (!choice.key.isEmpty())
            m_curves.push_back(choice);
    }
    if (m_curves.empty())
        m_curves = defaultCurves();
    build();
    connectToolbar();
    connectScope();
    showPresets();
    showCurves();
    showTrigger();
}

QWidget* TrendPanel::chart() const
{
    return m_chart;
}

TrendPanel::~TrendPanel() = default;

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
    m_chart->setStore(&m_liveData.store());
    m_chart->setMarks(&m_liveData.marks());
    m_chart->setMarkTextFunction(
        [this](const record::Mark& mark) { return markText(m_desk, mark); });
    m_chart->setWidth(defaultWidth());
    const int hz = m_settings.pageValue(rateKey, 0).toInt();
    m_period = hz > 0 ? Duration(1'000'000 / hz) : Duration{};
    m_liveData.setPeriod(m_period);
    m_toolbar->setRate(hz);
    m_toolbar->setShownWidth(m_chart->width());
}

void TrendPanel::connectToolbar()
{
    connect(m_toolbar, &TrendToolbar::followRequested, m_chart, &TrendChart::setFollowing);
    connect(m_toolbar, &TrendToolbar::fitRequested, m_chart, &TrendChart::zoomToFit);
    connect(m_toolbar, &TrendToolbar::backRequested, m_chart, &TrendChart::zoomBack);
    connect(m_toolbar, &TrendToolbar::cursorsRequested, m_chart, &TrendChart::setCursorsShown);
    connect(m_toolbar, &TrendToolbar::channelsRequested, this, &TrendPanel::chooseChannels);
    connect(m_toolbar, &TrendToolbar::triggerRequested, this, &TrendPanel::chooseTrigger);
    connect(m_toolbar, &TrendToolbar::recordRequested, this, &TrendPanel::toggleRecording);
    connect(m_toolbar, &TrendToolbar::openRequested, this, &TrendPanel::openRecording);
    connect(m_toolbar, &TrendToolbar::liveRequested, this, &TrendPanel::closeReplay);
    connect(m_toolbar, &TrendToolbar::saveImageRequested, this, &TrendPanel::saveImage);
    connect(m_toolbar, &TrendToolbar::clearRequested, &m_liveData, &session::LiveData::clear);
    connect(m_toolbar, &TrendToolbar::presetRequested, this, &TrendPanel::applyPreset);
    connect(m_toolbar, &TrendToolbar::presetSaveRequested, this, &TrendPanel::savePresetAs);
    connect(m_toolbar, &TrendToolbar::presetRemoveRequested, this, [this](const QString& name) {
        deletePreset(m_settings, name);
        showPresets();
    });
    connect(m_toolbar, &TrendToolbar::widthRequested, this, [this](Duration width) {
        m_chart->setWidth(width);
        m_settings.setPageValue(widthKey, int(width.count() / 1'000'000));
    });
    connect(m_toolbar, &TrendToolbar::rateRequested, this, [this](int hz) {
        m_period = hz > 0 ? Duration(1'000'000 / hz) : Duration{};
        m_settings.setPageValue(rateKey, hz);
        m_liveData.setPeriod(m_period);
        updateSubscription();
        Q_EMIT periodChanged();
    });
    connect(m_chart, &TrendChart::viewChanged, this, [this] {
        m_toolbar->setFollowing(m_chart->isFollowing());
        m_toolbar->setShownWidth(m_chart->width());
    });
    connect(m_chart, &TrendChart::cursorsChanged, this, [this] {
        m_toolbar->setCursorsShown(m_chart->areCursorsVisible());
        m_cursors->setVisible(m_chart->areCursorsVisible());
    });
    connect(m_chart, &TrendChart::playRequested, this, &TrendPanel::toggleFollowing);
    connect(m_chart, &TrendChart::channelsChanged, this, &TrendPanel::applyLegend);
    connect(m_replayBar, &ReplayBar::positionChanged, this, &TrendPanel::followReplay);
}

void TrendPanel::connectScope()
{
    connect(&m_liveData, &session::LiveData::samplesAdded, this, &TrendPanel::samplesAdded);
    connect(&m_liveData, &session::LiveData::channelsChanged, this, &TrendPanel::showCurves);
    connect(&m_liveData, &session::LiveData::triggerChanged, this, &TrendPanel::showTrigger);
    connect(&m_liveData, &session::LiveData::recordingChanged, this, &TrendPanel::showRecording);
    connect(&m_liveData, &session::LiveData::recordingFailed, this, &TrendPanel::recordingFailed);
    connect(&m_liveData, &session::LiveData::recordingBegan, this, [this] {
        if (m_recordDialog)
            m_recordDialog->close();
    });
    connect(&m_liveData, &session::LiveData::recordingEnded, this, &TrendPanel::recordingEnded);
    connect(&m_selection, &Selection::changed, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::servoAdded, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::servoRemoved, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::linkChanged, this, &TrendPanel::updateSubscription);
    connect(&m_replay, &session::Replay::loaded, this, &TrendPanel::showReplay);
    connect(&m_replay, &session::Replay::failed, this, [this](const base::Error& error) {
        const text::Description words = text::describe(error);
        showError(words.message, words.remedy);
    });
}

void TrendPanel::samplesAdded()
{
    if (!isReplaying() && isVisible())
        m_chart->advance(m_desk.now());
}

QColor TrendPanel::backgroundColor() const
{
    return palette().color(QPalette::Base);
}

TrendResolver TrendPanel::resolver() const
{
    return {m_desk, m_liveData, m_selection.current()};
}

/// What is chosen, as far as there are servos for it.
void TrendPanel::showCurves()
{
    updateSubscription();
    if (isReplaying())
        return;
    std::vector<TrendChannel> channels;
    m_shownCurves.clear();
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        auto channel = resolver().channel(m_curves[i], i, backgroundColor());
        if (!channel)
            continue;
        channels.push_back(std::move(*channel));
        m_shownCurves.push_back(i);
    }
    m_updatingChart = true;
    m_chart->setChannels(std::move(channels));
    m_updatingChart = false;
}

void TrendPanel::updateSubscription()
{
    if (!m_deskGuard)
        return;
    session::Subscription wish = resolver().subscription(m_curves);
    wish.period = m_period;
    m_desk.subscribe(subscriptionName, wish);
}

void TrendPanel::saveCurves()
{
    QStringList texts;
    for (const TrendCurve& choice : m_curves)
        texts << toText(choice);
    m_settings.setPageValue(curvesKey, m_curves == defaultCurves() ? QStringList() : texts);
}

void TrendPanel::setCurves(const std::vector<TrendCurve>& curves)
{
    m_curves = curves;
    saveCurves();
    showCurves();
    if (auto* dialog = findChild<ChannelsDialog*>())
        dialog->setCurves(m_curves);
}

/// Somebody has hidden or colored a curve at the legend.
void TrendPanel::applyLegend()
{
    if (m_updatingChart || isReplaying())
        return;
    const auto& channels = m_chart->channels();
    for (std::size_t i = 0; i < channels.size() && i < m_shownCurves.size(); ++i)
        m_curves[m_shownCurves[i]].visible = channels[i].visible;
    saveCurves();
    updateSubscription();
    if (auto* dialog = findChild<ChannelsDialog*>())
        dialog->setCurves(m_curves);
}

void TrendPanel::chooseChannels()
{
    auto* dialog = findChild<ChannelsDialog*>(); // one is enough
    if (dialog == nullptr) {
        dialog = new ChannelsDialog(m_desk, m_curves, this);
        connect(dialog, &ChannelsDialog::curvesChanged, this,
                [this](const std::vector<TrendCurve>& curves) {
                    m_curves = curves;
                    saveCurves();
                    showCurves();
                });
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void TrendPanel::chooseTrigger()
{
    if (m_liveData.trigger().state() == record::Trigger::State::Armed) {
        m_liveData.disarmTrigger();
        return;
    }
    std::vector<TrendChannel> curves;
    for (const TrendChannel& channel : m_chart->channels()) {
        if (channel.id >= 0)
            curves.push_back(channel);
    }
    record::ChannelId moving = -1;
    const session::ServoEntry* entry = m_desk.servo(m_selection.current());
    if (entry != nullptr && entry->servo.profile) {
        const QString key = registerOf(*entry->servo.profile, QStringLiteral("@moving"));
        const session::LiveChannel* found = m_liveData.find(m_selection.current(), key);
        moving = found != nullptr ? found->id : -1;
    }
    record::TriggerSpec before = m_liveData.trigger().spec();
    if (before.pre.count() == 0 && before.post.count() == 0)
        before.pre = before.post = 2s;
    auto* dialog = new TriggerDialog(std::move(curves), moving, before, this);
    connect(dialog, &TriggerDialog::triggerArmed, this, &TrendPanel::armTrigger);
    dialog->open();
}

void TrendPanel::armTrigger(const record::TriggerSpec& spec)
{
    m_chart->setFollowing(true);
    m_liveData.armTrigger(spec);
}

Duration TrendPanel::defaultWidth() const
{
    return std::chrono::seconds(
        std::max(m_settings.pageValue(widthKey, defaultSeconds).toInt(), 1));
}

void TrendPanel::updateTriggerText()
{
    using State = record::Trigger::State;
    const record::Trigger& trigger = m_liveData.trigger();
    QString words;
    if (trigger.state() == State::Armed)
        words = tr("Waiting — cancel");
    else if (trigger.state() == State::Fired)
        words = tr("Triggered …");
    m_toolbar->setTrigger(words, trigger.state() == State::Armed);
}

/// The moment has come: the chart stands there, once.
void TrendPanel::showTrigger()
{
    using State = record::Trigger::State;
    updateTriggerText();
    const record::Trigger& trigger = m_liveData.trigger();
    if (trigger.state() != State::Complete || isReplaying())
        return;
    if (const auto window = trigger.window()) {
        m_chart->setOrigin(*trigger.firedAt());
        m_chart->show(*window);
    }
}

void TrendPanel::toggleFollowing()
{
    if (!isReplaying())
        m_chart->setFollowing(!m_chart->isFollowing());
    else
        m_replayBar->setPlaying(!m_replayBar->isPlaying());
}

void TrendPanel::showError(const QString& words, const QString& remedy)
{
    m_banner->showMessage([words, remedy] { return BannerText{Tone::Bad, words, {}, remedy}; });
}

void TrendPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        showCurves();
        updateTriggerText();
        showRecording();
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
} // namespace ui

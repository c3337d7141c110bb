// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/trend_panel.h"

#include "text/error_words.h"
#include "ui/charts/cursor_table.h"
#include "ui/charts/trend_chart.h"
#include "ui/charts/trend_preset.h"
#include "ui/dialogs/channels_dialog.h"
#include "ui/dialogs/record_dialog.h"
#include "ui/dialogs/trigger_dialog.h"
#include "ui/pages/trend_toolbar.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/replay_bar.h"

#include <QEvent>
#include <QVBoxLayout>

#include <utility>

namespace ui {
using base::Duration;
using namespace std::chrono_literals;

namespace {
const QString choicesKey = QStringLiteral("trend/curves");
const QString widthKey = QStringLiteral("trend/width_s");
const QString rateKey = QStringLiteral("trend/rate_hz");
const QString wishName = QStringLiteral("trend");
constexpr int usualSeconds = 10;

/// One text a curve: "1/present_position;visible;#rrggbb;scale;offset".
QString toText(const TrendChoice& choice)
{
    return QStringList{choice.id(), choice.visible ? QStringLiteral("1") : QStringLiteral("0"),
                       choice.colour.isValid() ? choice.colour.name() : QString(),
                       QString::number(choice.scale, 'g', 10),
                       QString::number(choice.offset, 'g', 10)}
        .join(QLatin1Char(';'));
}

TrendChoice fromText(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char(';'));
    TrendChoice choice = TrendChoice::fromId(parts.value(0));
    choice.visible = parts.value(1) != QLatin1String("0");
    choice.colour = QColor(parts.value(2));
    const double scale = parts.value(3).toDouble();
    choice.scale = scale != 0 ? scale : 1;
    choice.offset = parts.value(4).toDouble();
    return choice;
}
} // namespace

TrendPanel::TrendPanel(session::Desk& desk, session::Scope& scope, Selection& selection,
                       session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_deskLives(&desk)
    , m_scope(scope)
    , m_selection(selection)
    , m_settings(settings)
{
    for (const QString& text : settings.choice(choicesKey, QStringList()).toStringList()) {
        const TrendChoice choice = fromText(text);
        if (!choice.key.isEmpty())
            m_choices.push_back(choice);
    }
    if (m_choices.empty())
        m_choices = defaultChoices();
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
    m_chart->setStore(&m_scope.store());
    m_chart->setMarks(&m_scope.marks());
    m_chart->setMarkWords([this](const record::Mark& mark) { return markWords(m_desk, mark); });
    m_chart->setWidth(usualWidth());
    const int hz = m_settings.choice(rateKey, 0).toInt();
    m_period = hz > 0 ? Duration(1'000'000 / hz) : Duration{};
    m_scope.setPeriod(m_period);
    m_toolbar->setRate(hz);
    m_toolbar->setWidthShown(m_chart->width());
}

void TrendPanel::connectToolbar()
{
    connect(m_toolbar, &TrendToolbar::followWished, m_chart, &TrendChart::setFollowing);
    connect(m_toolbar, &TrendToolbar::fitWished, m_chart, &TrendChart::fit);
    connect(m_toolbar, &TrendToolbar::backWished, m_chart, &TrendChart::zoomBack);
    connect(m_toolbar, &TrendToolbar::cursorsWished, m_chart, &TrendChart::setCursorsShown);
    connect(m_toolbar, &TrendToolbar::channelsWished, this, &TrendPanel::chooseChannels);
    connect(m_toolbar, &TrendToolbar::triggerWished, this, &TrendPanel::chooseTrigger);
    connect(m_toolbar, &TrendToolbar::recordWished, this, &TrendPanel::toggleRecording);
    connect(m_toolbar, &TrendToolbar::openWished, this, &TrendPanel::openRecording);
    connect(m_toolbar, &TrendToolbar::liveWished, this, &TrendPanel::leaveReplay);
    connect(m_toolbar, &TrendToolbar::saveImageWished, this, &TrendPanel::saveImage);
    connect(m_toolbar, &TrendToolbar::clearWished, &m_scope, &session::Scope::clear);
    connect(m_toolbar, &TrendToolbar::presetWished, this, &TrendPanel::usePreset);
    connect(m_toolbar, &TrendToolbar::presetSaveWished, this, &TrendPanel::keepPreset);
    connect(m_toolbar, &TrendToolbar::presetRemoveWished, this, [this](const QString& name) {
        deletePreset(m_settings, name);
        showPresets();
    });
    connect(m_toolbar, &TrendToolbar::widthWished, this, [this](Duration width) {
        m_chart->setWidth(width);
        m_settings.setChoice(widthKey, int(width.count() / 1'000'000));
    });
    connect(m_toolbar, &TrendToolbar::rateWished, this, [this](int hz) {
        m_period = hz > 0 ? Duration(1'000'000 / hz) : Duration{};
        m_settings.setChoice(rateKey, hz);
        m_scope.setPeriod(m_period);
        updateWish();
        Q_EMIT periodChanged();
    });
    connect(m_chart, &TrendChart::viewChanged, this, [this] {
        m_toolbar->setFollowing(m_chart->following());
        m_toolbar->setWidthShown(m_chart->width());
    });
    connect(m_chart, &TrendChart::cursorsChanged, this, [this] {
        m_toolbar->setCursorsShown(m_chart->cursorsShown());
        m_cursors->setVisible(m_chart->cursorsShown());
    });
    connect(m_chart, &TrendChart::playWished, this, &TrendPanel::toggleFollowing);
    connect(m_chart, &TrendChart::channelsChanged, this, &TrendPanel::takeLegend);
    connect(m_replayBar, &ReplayBar::moved, this, &TrendPanel::followReplay);
}

void TrendPanel::connectScope()
{
    connect(&m_scope, &session::Scope::grown, this, &TrendPanel::grown);
    connect(&m_scope, &session::Scope::channelsChanged, this, &TrendPanel::showCurves);
    connect(&m_scope, &session::Scope::triggerChanged, this, &TrendPanel::showTrigger);
    connect(&m_scope, &session::Scope::recordingChanged, this, &TrendPanel::showRecording);
    connect(&m_scope, &session::Scope::recordingFailed, this, &TrendPanel::recordingFailed);
    connect(&m_scope, &session::Scope::recordingBegan, this, [this] {
        if (m_recordDialog)
            m_recordDialog->close();
    });
    connect(&m_scope, &session::Scope::recordingEnded, this, &TrendPanel::recordingEnded);
    connect(&m_selection, &Selection::changed, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::servoAdded, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::servoRemoved, this, &TrendPanel::showCurves);
    connect(&m_desk, &session::Desk::linkChanged, this, &TrendPanel::updateWish);
    connect(&m_replay, &session::Replay::loaded, this, &TrendPanel::showReplay);
    connect(&m_replay, &session::Replay::failed, this, [this](const base::Error& error) {
        const text::Description words = text::describe(error);
        complain(words.what, words.remedy);
    });
}

void TrendPanel::grown()
{
    if (!replaying() && isVisible())
        m_chart->advance(m_desk.now());
}

QColor TrendPanel::ground() const
{
    return palette().color(QPalette::Base);
}

TrendResolver TrendPanel::resolver() const
{
    return {m_desk, m_scope, m_selection.current()};
}

/// What is chosen, as far as there are servos for it.
void TrendPanel::showCurves()
{
    updateWish();
    if (replaying())
        return;
    std::vector<TrendChannel> channels;
    m_shownChoices.clear();
    for (std::size_t i = 0; i < m_choices.size(); ++i) {
        auto channel = resolver().channel(m_choices[i], i, ground());
        if (!channel)
            continue;
        channels.push_back(std::move(*channel));
        m_shownChoices.push_back(i);
    }
    m_showing = true;
    m_chart->setChannels(std::move(channels));
    m_showing = false;
}

void TrendPanel::updateWish()
{
    if (!m_deskLives)
        return;
    session::FeedWish wish = resolver().wish(m_choices);
    wish.period = m_period;
    m_desk.wish(wishName, wish);
}

void TrendPanel::keepChoices()
{
    QStringList texts;
    for (const TrendChoice& choice : m_choices)
        texts << toText(choice);
    m_settings.setChoice(choicesKey, m_choices == defaultChoices() ? QStringList() : texts);
}

void TrendPanel::setChoices(const std::vector<TrendChoice>& choices)
{
    m_choices = choices;
    keepChoices();
    showCurves();
    if (auto* dialog = findChild<ChannelsDialog*>())
        dialog->setChoices(m_choices);
}

/// Somebody has hidden or coloured a curve at the legend.
void TrendPanel::takeLegend()
{
    if (m_showing || replaying())
        return;
    const auto& channels = m_chart->channels();
    for (std::size_t i = 0; i < channels.size() && i < m_shownChoices.size(); ++i)
        m_choices[m_shownChoices[i]].visible = channels[i].visible;
    keepChoices();
    updateWish();
    if (auto* dialog = findChild<ChannelsDialog*>())
        dialog->setChoices(m_choices);
}

void TrendPanel::chooseChannels()
{
    auto* dialog = findChild<ChannelsDialog*>(); // one is enough
    if (dialog == nullptr) {
        dialog = new ChannelsDialog(m_desk, m_choices, this);
        connect(dialog, &ChannelsDialog::chosen, this,
                [this](const std::vector<TrendChoice>& choices) {
                    m_choices = choices;
                    keepChoices();
                    showCurves();
                });
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void TrendPanel::chooseTrigger()
{
    if (m_scope.trigger().state() == record::Trigger::State::Armed) {
        m_scope.disarm();
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
        const session::ScopeChannel* found = m_scope.find(m_selection.current(), key);
        moving = found != nullptr ? found->id : -1;
    }
    record::TriggerSpec before = m_scope.trigger().spec();
    if (before.pre.count() == 0 && before.post.count() == 0)
        before.pre = before.post = 2s;
    auto* dialog = new TriggerDialog(std::move(curves), moving, before, this);
    connect(dialog, &TriggerDialog::armed, this, &TrendPanel::arm);
    dialog->open();
}

void TrendPanel::arm(const record::TriggerSpec& spec)
{
    m_chart->setFollowing(true);
    m_scope.arm(spec);
}

Duration TrendPanel::usualWidth() const
{
    return std::chrono::seconds(std::max(m_settings.choice(widthKey, usualSeconds).toInt(), 1));
}

void TrendPanel::nameTrigger()
{
    using State = record::Trigger::State;
    const record::Trigger& trigger = m_scope.trigger();
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
    nameTrigger();
    const record::Trigger& trigger = m_scope.trigger();
    if (trigger.state() != State::Complete || replaying())
        return;
    if (const auto window = trigger.window()) {
        m_chart->setOrigin(*trigger.firedAt());
        m_chart->show(*window);
    }
}

void TrendPanel::toggleFollowing()
{
    if (!replaying())
        m_chart->setFollowing(!m_chart->following());
    else
        m_replayBar->setPlaying(!m_replayBar->playing());
}

void TrendPanel::complain(const QString& words, const QString& remedy)
{
    m_banner->present([words, remedy] { return BannerWords{Tone::Bad, words, {}, remedy}; });
}

void TrendPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        showCurves();
        nameTrigger();
        showRecording();
    } else if (event->type() == QEvent::PaletteChange) {
        showCurves();
    }
}

void TrendPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showCurves();
    grown();
}
} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/operate_page.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/operate/control_panel.h"
#include "ui/operate/operate_status.h"
#include "ui/operate/servo_strip.h"
#include "ui/trends/trend_panel.h"
#include "ui/widgets/feedback.h"
#include "ui/widgets/floating_overlay.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ui {
using namespace std::chrono_literals;

namespace {
constexpr auto refreshInterval = 50ms; ///< numbers that change faster cannot be read
constexpr auto idleInterval = 1s;      ///< without a port only ages change
constexpr int minControlWidth = 350;
constexpr int maxControlWidth = 400;
constexpr int controlPercent = 36;
constexpr int minHeightForGauges = 460;
const QString subscriptionName = QStringLiteral("operate");
const QString gaugesKey = QStringLiteral("operate/gauges");

QString turnCountText(const session::ServoEntry& entry)
{
    const auto turns = entry.turns.value();
    if (!turns)
        return {};
    const QString count = QLocale().toString(turns->turns);
    if (turns->absolute)
        return OperatePage::tr("turns: %1").arg(count);
    if (turns->turns == 0 && turns->isCertain)
        return {};
    return turns->isCertain ? OperatePage::tr("turns since connecting: %1").arg(count)
                            : OperatePage::tr("turns since connecting: %1 (uncertain)").arg(count);
}
} // namespace

OperatePage::OperatePage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_commands(appContext.commands)
    , m_selection(appContext.selection)
    , m_motion(appContext.workbench.motion())
    , m_liveData(appContext.workbench.liveData())
{
    build(settings);
    connectAll();
    updateSubscription();
    followLanguage(this, [this] {
        setAccessibleName(tr("Operate"));
        m_dial->setAccessibleName(tr("Position and goal"));
        refresh();
    });
}

OperatePage::~OperatePage() = default;

void OperatePage::build(session::Settings& settings)
{
    auto* row = new QHBoxLayout(this);
    row->setSpacing(cardMargin);
    m_control = new ControlPanel(m_workbench, m_commands, m_selection, settings, m_motion, this);
    m_dial = new PositionDial(this);
    m_dial->setObjectName(QStringLiteral("positionDial"));
    m_control->setDial(m_dial);
    row->addWidget(m_control);
    row->addWidget(buildWatch(settings), 1);
    new FloatingOverlay(m_control->messages(), m_trend->chart(), FloatingOverlay::Corner::TopLeft);
}

QWidget* OperatePage::buildWatch(session::Settings& settings)
{
    m_watch = new QWidget(this);
    auto* column = new QVBoxLayout(m_watch);
    column->setContentsMargins({});
    column->setSpacing(6);
    m_status = new OperateStatus(m_watch);
    auto* gauges = new QHBoxLayout;
    gauges->setSpacing(6);
    for (std::size_t i = 0; i < m_gauges.size(); ++i) {
        m_gauges[i] = new Gauge(m_watch);
        m_gauges[i]->setObjectName(QStringLiteral("gauge%1").arg(i));
        gauges->addWidget(m_gauges[i], 1);
    }
    m_gaugesShown = settings.pageValue(gaugesKey, true).toBool();
    m_status->setGauges(m_gaugesShown, true);
    connect(m_status, &OperateStatus::gaugesToggled, this, [this, &settings](bool shown) {
        m_gaugesShown = shown;
        settings.setPageValue(gaugesKey, shown);
        showGauges(entry());
    });
    m_trend = new TrendPanel(m_workbench, m_liveData, m_selection, settings, m_watch);
    m_strip = new ServoStrip(m_workbench.registry(), m_workbench.link(), m_selection, m_watch);
    column->addWidget(m_status);
    column->addLayout(gauges);
    column->addWidget(m_trend, 1);
    column->addWidget(m_strip);
    return m_watch;
}

void OperatePage::connectAll()
{
    connect(&m_selection, &Selection::selectedServosChanged, this, &OperatePage::select);
    connect(m_status, &OperateStatus::acknowledgeRequested, this, [this] {
        m_workbench.registry().acknowledgeAlarms(m_selection.current());
        refresh();
    });
    connect(m_dial, &PositionDial::goalRequested, m_control, &ControlPanel::setGoalFromDial);
    connect(m_control, &ControlPanel::goalStateChanged, this, [this] { showDial(entry()); });
    connect(m_trend, &TrendPanel::periodChanged, this, &OperatePage::updateSubscription);
    connect(&m_workbench.registry(), &session::ServoRegistry::servoAdded, this,
            &OperatePage::updateSubscription);
    connect(&m_workbench.registry(), &session::ServoRegistry::servoRemoved, this,
            &OperatePage::updateSubscription);
    connect(&m_workbench.registry(), &session::ServoRegistry::servosCleared, this,
            &OperatePage::updateSubscription);
    connect(&m_workbench.search(), &session::SearchService::searchChanged, this,
            &OperatePage::updateSubscription);
    connect(&m_refreshTimer, &QTimer::timeout, this, &OperatePage::refresh);
    const auto adaptTimer = [this] {
        const bool open = m_workbench.link().state() == session::LinkState::Open;
        m_refreshTimer.setInterval(open ? refreshInterval : idleInterval);
        if (isVisible())
            refresh();
    };
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this, adaptTimer);
    adaptTimer();
}

const session::ServoEntry* OperatePage::entry() const
{
    return m_workbench.registry().servo(m_selection.current());
}

void OperatePage::select()
{
    updateSubscription();
    refresh();
}

/// All servos, for the strip; the chart has a subscription of its own.
void OperatePage::updateSubscription()
{
    if (!m_workbenchGuard)
        return;
    session::Subscription subscription;
    subscription.period = m_trend->period();
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const session::ServoEntry* known = m_workbench.registry().servo(ref);
        if (known == nullptr || !known->servo.profile || !isVisible())
            continue;
        // Settings only of selected servos: those of all would slow down the readings.
        const auto& chosen = m_selection.selected();
        const bool driven = std::find(chosen.begin(), chosen.end(), ref) != chosen.end();
        subscription.parts.push_back(
            {ref, feedbackKeys(known->servo), driven ? settingKeys(known->servo) : QStringList()});
    }
    m_workbench.polling().subscribe(subscriptionName, subscription);
}

void OperatePage::refresh()
{
    const session::ServoEntry* known = entry();
    m_status->show(known, m_workbench);
    showDial(known);
    showGauges(known);
    m_strip->refresh();
}

void OperatePage::showDial(const session::ServoEntry* known)
{
    DialState view = known != nullptr
                         ? dialState(*known, isFresh(*known, m_workbench.link(), m_workbench.now()))
                         : DialState{};
    if (known != nullptr) {
        view.isGoalMovable = m_control->isGoalMovable();
        if (const auto goal = m_control->positionGoal(); goal && view.goal)
            view.goal = double(*goal);
        const QString turns = turnCountText(*known);
        view.turnsText = view.turnsText.isEmpty() ? turns : view.turnsText;
    }
    m_dial->show(view);
}

void OperatePage::showGauges(const session::ServoEntry* known)
{
    const bool old = known == nullptr || !isFresh(*known, m_workbench.link(), m_workbench.now());
    // The chart comes first where the messages below leave little room.
    const bool hasRoom = height() >= minHeightForGauges;
    m_status->setGauges(m_gaugesShown, hasRoom);
    for (std::size_t i = 0; i < m_gauges.size(); ++i) {
        const GaugeState view =
            known != nullptr ? gaugeState(*known, allQuantities[i]) : GaugeState{};
        m_gauges[i]->setVisible(known != nullptr && view.isMeasured && m_gaugesShown && hasRoom);
        m_gauges[i]->setTitle(view.title);
        m_gauges[i]->setScale(view.scale);
        m_gauges[i]->setValue(view.value, view.caption, old);
    }
}

void OperatePage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_control->setFixedWidth(
        std::clamp(width() * controlPercent / 100, minControlWidth, maxControlWidth));
    showGauges(entry());
}

void OperatePage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_refreshTimer.start();
    select();
}

void OperatePage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_refreshTimer.stop();
    updateSubscription();
}
} // namespace ui

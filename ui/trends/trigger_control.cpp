// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trends/trigger_control.h"

#include "ui/charts/trend_chart.h"
#include "ui/trends/trend_curves.h"
#include "ui/trends/trend_replay.h"
#include "ui/trends/trend_toolbar.h"
#include "ui/trends/trigger_dialog.h"

namespace ui {
namespace {
using namespace std::chrono_literals;
using TriggerState = recording::Trigger::State;
constexpr base::Duration defaultTriggerSpan = 2s; ///< shown before and after the moment
} // namespace

TriggerControl::TriggerControl(const session::ServoRegistry& registry, session::LiveData& liveData,
                               const Selection& selection, const Views& views, QWidget* parent)
    : QObject(parent)
    , m_registry(registry)
    , m_liveData(liveData)
    , m_selection(selection)
    , m_views(views)
    , m_parent(parent)
{
    connect(&liveData, &session::LiveData::triggerChanged, this, &TriggerControl::showTrigger);
    showTrigger();
}

void TriggerControl::choose()
{
    if (m_liveData.trigger().state() == TriggerState::Armed) {
        m_liveData.disarmTrigger();
        return;
    }
    std::vector<TrendChannel> curves;
    for (const TrendChannel& channel : m_views.chart.channels()) {
        if (channel.id >= 0)
            curves.push_back(channel);
    }
    recording::TriggerSpec last = m_liveData.trigger().spec();
    if (last.pre.count() == 0 && last.post.count() == 0)
        last.pre = last.post = defaultTriggerSpan;
    auto* dialog = new TriggerDialog(std::move(curves), movingChannel(), last, m_parent);
    connect(dialog, &TriggerDialog::triggerArmed, this, &TriggerControl::arm);
    dialog->open();
}

/// −1: the moving flag of the selected servo is not read.
recording::ChannelId TriggerControl::movingChannel() const
{
    const session::ServoEntry* entry = m_registry.servo(m_selection.current());
    if (entry == nullptr || !entry->servo.profile)
        return -1;
    const QString key = registerOf(*entry->servo.profile, QStringLiteral("@moving"));
    const session::LiveChannel* found = m_liveData.find(m_selection.current(), key);
    return found != nullptr ? found->id : -1;
}

void TriggerControl::arm(const recording::TriggerSpec& spec)
{
    m_views.chart.setFollowing(true);
    m_liveData.armTrigger(spec);
}

void TriggerControl::retranslate()
{
    const TriggerState state = m_liveData.trigger().state();
    QString words;
    if (state == TriggerState::Armed)
        words = tr("Stop waiting");
    else if (state == TriggerState::Fired)
        words = tr("Triggered…");
    m_views.toolbar.setTrigger(words, state == TriggerState::Armed);
}

/// When all samples around the moment are there, the chart shows them and stops following.
void TriggerControl::showTrigger()
{
    retranslate();
    const recording::Trigger& trigger = m_liveData.trigger();
    if (trigger.state() != TriggerState::Complete || m_views.replay.isActive())
        return;
    if (const auto window = trigger.window()) {
        m_views.chart.setOrigin(*trigger.firedAt());
        m_views.chart.show(*window);
    }
}
} // namespace ui

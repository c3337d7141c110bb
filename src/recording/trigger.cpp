// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trigger.h"

#include "base/enum_names.h"

#include <cmath>

namespace recording {
namespace {
constexpr base::EnumName<MarkKind> markNames[]{
    {MarkKind::Write, "write"},
    {MarkKind::Fault, "fault"},
    {MarkKind::FaultCleared, "fault-over"},
    {MarkKind::LinkError, "link-error"},
    {MarkKind::LinkRestored, "link-back"},
    {MarkKind::Move, "move"},
    {MarkKind::Stop, "stop"},
    {MarkKind::Note, "note"},
};
} // namespace

QString markName(MarkKind kind)
{
    return base::nameOf(markNames, kind);
}

std::optional<MarkKind> markFromName(const QString& name)
{
    return base::valueOf(markNames, name);
}

void Trigger::arm(const TriggerSpec& spec)
{
    m_spec = spec;
    m_state = State::Armed;
    m_firedAt.reset();
    m_isPrimed = false;
}

void Trigger::disarm()
{
    m_state = State::Idle;
    m_firedAt.reset();
}

void Trigger::sample(ChannelId channel, base::Duration at, double value)
{
    if (m_state != State::Armed) {
        advanceTo(at);
        return;
    }
    if (channel != m_spec.channel)
        return;
    if (!std::isfinite(value)) {
        gap(channel);
        return;
    }
    const double level = m_spec.level;
    const bool above = value >= level;
    const bool below = value <= level;
    switch (m_spec.kind) {
    case TriggerSpec::Kind::Above:
        if (above)
            fire(at);
        break;
    case TriggerSpec::Kind::Below:
        if (below)
            fire(at);
        break;
    case TriggerSpec::Kind::Rising:
        if (above && m_isPrimed)
            fire(at);
        m_isPrimed = m_isPrimed || value < level - m_spec.hysteresis;
        break;
    case TriggerSpec::Kind::Falling:
        if (below && m_isPrimed)
            fire(at);
        m_isPrimed = m_isPrimed || value > level + m_spec.hysteresis;
        break;
    case TriggerSpec::Kind::Mark:
        break;
    }
}

void Trigger::gap(ChannelId channel)
{
    if (channel == m_spec.channel)
        m_isPrimed = false;
}

void Trigger::mark(const Mark& mark)
{
    if (m_state != State::Armed) {
        advanceTo(mark.at);
        return;
    }
    const bool concerned =
        m_spec.servoId == -1 || mark.servoId == -1 || mark.servoId == m_spec.servoId;
    if (m_spec.kind == TriggerSpec::Kind::Mark && mark.kind == m_spec.mark && concerned)
        fire(mark.at);
}

void Trigger::advanceTo(base::Duration now)
{
    if (m_state == State::Fired && now >= *m_firedAt + m_spec.post)
        m_state = State::Complete;
}

void Trigger::fire(base::Duration at)
{
    m_state = State::Fired;
    m_firedAt = at;
    advanceTo(at);
}

std::optional<TimeSpan> Trigger::window() const
{
    if (!m_firedAt)
        return std::nullopt;
    return TimeSpan{*m_firedAt - m_spec.pre, *m_firedAt + m_spec.post};
}
} // namespace recording

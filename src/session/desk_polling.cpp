// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly, and what is told of it.
#include "session/desk_work.h"

namespace session {
void Desk::subscribe(const QString& user, const Subscription& wish)
{
    m_polling.subscribe(user, wish);
    updatePolling();
}

/// Polling goes on beside everything that leaves the bus at its rate.
bool Desk::canPoll() const
{
    const bool searchMoves = m_search && m_search->started && !m_search->keepsBaud;
    const bool workMoves = m_running && m_running->changesRate;
    return m_state == LinkState::Open && !searchMoves && !workMoves;
}

std::vector<const ServoEntry*> Desk::pollableServos() const
{
    std::vector<const ServoEntry*> present;
    if (!canPoll())
        return present;
    for (const ServoRef ref : m_order) {
        const ServoEntry& known = m_servos.at(ref);
        if (known.servo.profile && (!canSetBaud() || known.servo.baud == baud()))
            present.push_back(&known);
    }
    return present;
}

void Desk::updatePolling()
{
    if (!m_connection) {
        m_polling.stop(nullptr);
        m_pollTimer.stop();
        return;
    }
    if (!m_polling.isOutdated(pollableServos(), baud()))
        return;
    collectReadings(); // who hears of it may wish for something else
    if (!m_connection)
        return;
    m_polling.startPolls(m_connection->bus(), pollableServos());
    if (!m_polling.isRunning())
        m_pollTimer.stop();
    else if (!m_pollTimer.isActive())
        m_pollTimer.start();
}

void Desk::collectReadings()
{
    if (!m_polling.isRunning() || !m_connection)
        return;
    const ReadingBatch batch =
        m_polling.takeBatch(m_connection->bus(), [this](ServoRef ref) { return entry(ref); });
    if (!batch.readings.empty())
        Q_EMIT readingsReceived(batch.readings);
    for (const record::Mark& one : batch.marks)
        Q_EMIT markAdded(one);
    for (const ServoRef ref : batch.updated)
        Q_EMIT tableChanged(ref);
    for (const ServoRef ref : batch.changed)
        Q_EMIT servoChanged(ref);
    if (!batch.changed.empty())
        identifyReturned();
}

Communication Desk::communication(ServoRef ref) const
{
    Communication state;
    const ServoEntry* known = servo(ref);
    if (known == nullptr)
        return state;
    state.answering = !known->silent;
    state.rate = pollRate(ref);
    const base::Duration heard =
        std::max(known->lastSeen, state.rate.lastAt.value_or(base::Duration{}));
    state.age = now() - heard;
    if (known->silent)
        state.silentSince = known->linkMonitor.silentSince().value_or(heard);
    const bus::Statistics all = statistics();
    if (const auto own = all.byId.find(known->servo.id); own != all.byId.end()) {
        state.timeouts = own->second.timeouts;
        state.badChecksums = own->second.badChecksums;
    }
    return state;
}

void Desk::acknowledgeAlarms(ServoRef ref)
{
    ServoEntry* known = entry(ref);
    if (known == nullptr)
        return;
    known->alarms.acknowledge();
    Q_EMIT servoChanged(ref);
}

void Desk::markAlarms(ServoEntry& entry)
{
    for (const record::Mark& one : latchAlarms(entry, now()))
        Q_EMIT markAdded(one);
}

void Desk::mark(record::MarkKind kind, const ServoEntry* about, const QString& text)
{
    Q_EMIT markAdded({now(), kind, about != nullptr ? about->servo.id : -1, text});
}

void Desk::markMove(ServoRef ref, const QString& text, bool dragged)
{
    mark(record::MarkKind::Move, servo(ref), text);
    emitEvent({.kind = Event::Kind::GoalSent, .servo = ref, .path = dragged ? QString() : text});
}
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
// What is read regularly, and what is told of it.
#include "session/desk_work.h"

namespace session {
void Desk::wish(const QString& user, const FeedWish& wish)
{
    m_feeder.wish(user, wish);
    updateFeed();
}

/// Polling goes on beside everything that leaves the bus at its rate.
bool Desk::mayFeed() const
{
    const bool searchMoves = m_search && m_search->started && !m_search->staysHere;
    const bool workMoves = m_running && m_running->movesRate;
    return m_state == LinkState::Open && !searchMoves && !workMoves;
}

std::vector<const ServoEntry*> Desk::feedable() const
{
    std::vector<const ServoEntry*> present;
    if (!mayFeed())
        return present;
    for (const ServoRef ref : m_order) {
        const ServoEntry& known = m_servos.at(ref);
        if (known.servo.profile && (!hasBaud() || known.servo.baud == baud()))
            present.push_back(&known);
    }
    return present;
}

void Desk::updateFeed()
{
    if (!m_connection) {
        m_feeder.stop(nullptr);
        m_feedTimer.stop();
        return;
    }
    if (!m_feeder.outdated(feedable(), baud()))
        return;
    collectFeed(); // who hears of it may wish for something else
    if (!m_connection)
        return;
    m_feeder.start(m_connection->bus(), feedable());
    if (!m_feeder.running())
        m_feedTimer.stop();
    else if (!m_feedTimer.isActive())
        m_feedTimer.start();
}

void Desk::collectFeed()
{
    if (!m_feeder.running() || !m_connection)
        return;
    const FeedBatch batch =
        m_feeder.take(m_connection->bus(), [this](ServoRef ref) { return entry(ref); });
    if (!batch.readings.empty())
        Q_EMIT readings(batch.readings);
    for (const record::Mark& one : batch.marks)
        Q_EMIT marked(one);
    for (const ServoRef ref : batch.read)
        Q_EMIT tableChanged(ref);
    for (const ServoRef ref : batch.news)
        Q_EMIT servoChanged(ref);
    if (!batch.news.empty())
        identifyHeard();
}

Communication Desk::communication(ServoRef ref) const
{
    Communication state;
    const ServoEntry* known = servo(ref);
    if (known == nullptr)
        return state;
    state.answering = !known->silent;
    state.rate = rate(ref);
    const base::Duration heard =
        std::max(known->lastSeen, state.rate.lastAt.value_or(base::Duration{}));
    state.age = now() - heard;
    if (known->silent)
        state.silentSince = known->link.silentSince().value_or(heard);
    const bus::Statistics all = statistics();
    if (const auto own = all.byId.find(known->servo.id); own != all.byId.end()) {
        state.timeOuts = own->second.timeOuts;
        state.badChecks = own->second.badChecks;
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
        Q_EMIT marked(one);
}

void Desk::mark(record::MarkKind kind, const ServoEntry* about, const QString& text)
{
    Q_EMIT marked({now(), kind, about != nullptr ? about->servo.id : -1, text});
}

void Desk::noteMove(ServoRef ref, const QString& text, bool dragged)
{
    mark(record::MarkKind::Move, servo(ref), text);
    tell({.kind = Event::Kind::Moved, .servo = ref, .path = dragged ? QString() : text});
}
} // namespace session

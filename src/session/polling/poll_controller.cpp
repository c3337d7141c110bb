// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/polling/poll_controller.h"

#include "session/workbench.h"

#include <algorithm>

namespace session {
namespace {
constexpr std::chrono::milliseconds shortestInterval(33);
constexpr std::chrono::milliseconds longestInterval(250);
} // namespace

PollController::PollController(Workbench& bench)
    : m_bench(bench)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        collectReadings();
        updatePolling(); // one of them may have a new ID now: asked under that one
    });
    ServoRegistry& servos = bench.registry();
    connect(&servos, &ServoRegistry::alarmMarked, this, &PollController::markAdded);
    connect(&servos, &ServoRegistry::servosCleared, this, [this] { m_polling.removeAllServos(); });
    connect(&servos, &ServoRegistry::servoRemoved, this, [this](ServoRef ref) {
        m_polling.removeServo(ref);
        updatePolling();
    });
}

void PollController::subscribe(const QString& user, const Subscription& subscription)
{
    m_polling.subscribe(user, subscription);
    updatePolling();
}

/// Polling goes on beside everything that leaves the bus at its rate.
bool PollController::canPoll() const
{
    const bool searchMoves = m_bench.search().isStarted() && !m_bench.search().keepsBaud();
    const bool workMoves = m_bench.tasks().running() && m_bench.tasks().running()->changesRate;
    return m_bench.link().state() == LinkState::Open && !searchMoves && !workMoves;
}

std::vector<const ServoEntry*> PollController::pollableServos() const
{
    std::vector<const ServoEntry*> present;
    if (!canPoll())
        return present;
    for (const ServoRef ref : m_bench.registry().order()) {
        const ServoEntry& known = m_bench.registry().entries().at(ref);
        if (known.servo.profile &&
            (!m_bench.link().canSetBaud() || known.servo.baud == m_bench.link().baud()))
            present.push_back(&known);
    }
    return present;
}

void PollController::updatePolling()
{
    if (!m_bench.link().connection()) {
        m_polling.stop(nullptr);
        m_timer.stop();
        return;
    }
    if (!m_polling.isOutdated(pollableServos(), m_bench.link().baud()))
        return;
    collectReadings(); // receivers of the signals may subscribe
    if (!m_bench.link().connection())
        return;
    m_polling.startPolls(m_bench.link().connection()->bus(), pollableServos());
    m_timer.setInterval(std::clamp(std::chrono::ceil<std::chrono::milliseconds>(m_polling.period()),
                                   shortestInterval, longestInterval));
    if (!m_polling.isRunning())
        m_timer.stop();
    else if (!m_timer.isActive())
        m_timer.start();
}

void PollController::collectReadings()
{
    if (!m_polling.isRunning() || !m_bench.link().connection())
        return;
    const ReadingBatch batch =
        m_polling.takeBatch(m_bench.link().connection()->bus(),
                            [this](ServoRef ref) { return m_bench.registry().entry(ref); });
    if (!batch.readings.empty())
        Q_EMIT readingsReceived(batch.readings);
    for (const recording::Mark& one : batch.marks)
        Q_EMIT markAdded(one);
    for (const ServoRef ref : batch.updated)
        Q_EMIT m_bench.registry().tableChanged(ref);
    for (const ServoRef ref : batch.changed)
        Q_EMIT m_bench.registry().servoChanged(ref);
    if (!batch.changed.empty())
        m_bench.presence().identifyReturned();
}

void PollController::mark(recording::MarkKind kind, const ServoEntry* about, const QString& text)
{
    Q_EMIT markAdded({m_bench.now(), kind, about != nullptr ? about->servo.id : -1, text});
}

void PollController::markMove(ServoRef ref, const QString& text, bool dragged)
{
    mark(recording::MarkKind::Move, m_bench.registry().servo(ref), text);
    m_bench.emitEvent(
        {.kind = Event::Kind::GoalSent, .servo = ref, .path = dragged ? QString() : text});
}
} // namespace session

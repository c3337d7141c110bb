// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/desk.h"

#include "session/desk_work.h"

#include <algorithm>

namespace session {
using namespace std::chrono_literals;

namespace {
/// Unplugging is noticed by the bus within 200 ms, and here within as much again.
constexpr auto lookInterval = 200ms;
/// Torque switches that have not been read back by then are reported.
constexpr auto confirmedWithin = 1500ms;
} // namespace

Desk::Desk(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_openThread(std::make_unique<JobThread>())
    , m_searchThread(std::make_unique<JobThread>())
    , m_taskThread(std::make_unique<JobThread>())
{
    m_look.setInterval(lookInterval);
    connect(&m_look, &QTimer::timeout, this, &Desk::lookAtLink);
    m_stopUnconfirmed.setInterval(confirmedWithin);
    m_stopUnconfirmed.setSingleShot(true);
    connect(&m_stopUnconfirmed, &QTimer::timeout, this, &Desk::reportUnconfirmed);
    m_feedTimer.setInterval(33ms);
    m_feedTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_feedTimer, &QTimer::timeout, this, [this] {
        collectFeed();
        updateFeed(); // one of them may have a new ID now: asked under that one
    });
}

Desk::~Desk()
{
    if (m_search)
        m_search->stop.request();
    if (m_running)
        m_running->stop.request();
}

bool Desk::simulated() const
{
    return m_connection && m_connection->simulated();
}

int Desk::baud() const
{
    return m_connection ? m_connection->bus().baud() : 0;
}

bool Desk::hasBaud() const
{
    return m_connection && m_connection->bus().hasBaud();
}

bus::Statistics Desk::statistics() const
{
    return m_connection ? m_connection->bus().statistics() : bus::Statistics{};
}

base::Duration Desk::now() const
{
    return m_session.clock().now();
}

void Desk::tell(Event event)
{
    event.at = QDateTime::currentDateTime();
    if (const ServoEntry* known = servo(event.servo))
        event.id = known->servo.id;
    Q_EMIT happened(event);
}

void Desk::setState(LinkState state)
{
    if (state == m_state)
        return;
    m_state = state;
    if (state == LinkState::Open)
        m_look.start();
    else
        m_look.stop();
    updateFeed();
    Q_EMIT linkChanged();
}

void Desk::connectTo(const PortRequest& request)
{
    if (m_connection || m_opening) {
        m_nextRequest = request;
        disconnectFrom();
        return;
    }
    if (request.name != m_request.name)
        forgetServos();
    m_request = request;
    m_intentsLooked = false;
    m_answers.clear();
    m_opening = true;
    setState(LinkState::Opening);
    m_openThread->start([this, request] {
        auto result =
            std::make_shared<base::Result<std::unique_ptr<Connection>>>(m_session.connect(request));
        m_inbox.post([this, result] { opened(std::move(*result)); });
    });
}

void Desk::forgetServos()
{
    m_servos.clear();
    m_order.clear();
    m_undo.clear();
    m_redo.clear();
    m_returning.reset();
    m_feeder.forgetAll();
    m_lastSearch.reset();
    Q_EMIT servosCleared();
    Q_EMIT undoChanged();
}

void Desk::opened(base::Result<std::unique_ptr<Connection>> result)
{
    m_opening = false;
    if (m_state == LinkState::Closing) { // the user has changed their mind meanwhile
        result = base::fail(base::ErrorCode::Stopped);
        goOn();
        return;
    }
    if (!result) {
        setState(LinkState::Off);
        Q_EMIT connectFailed(result.error());
        return;
    }
    m_connection = std::move(*result);
    m_portName = m_connection->bus().portName();
    for (auto& [ref, known] : m_servos) {
        m_connection->know(known.servo);
        known.turns.reset();
    }
    setState(LinkState::Open);
    tell({.kind = Event::Kind::Connected, .task = m_connection->bus().portName()});
    if (std::exchange(m_stopNotSent, false))
        tell({.kind = Event::Kind::StopNotSent, .earlier = true});
}

void Desk::disconnectFrom(AtClose moving, LockAtClose lock)
{
    if (m_state == LinkState::Off && !m_connection) {
        m_nextRequest.reset();
        return;
    }
    if (m_leaving) { // asked for again while servos are being stopped
        if (moving == AtClose::LeaveMoving)
            closeNow();
        return;
    }
    m_leaving = Leaving{moving, lock};
    makeSafe();
}

void Desk::closeNow()
{
    if (m_state == LinkState::Lost && !m_connection) {
        m_leaving.reset();
        setState(LinkState::Off);
        if (m_closing)
            QMetaObject::invokeMethod(this, &Desk::closed, Qt::QueuedConnection);
        return;
    }
    dropQueue(base::ErrorCode::Stopped, true);
    stopSearch();
    stopTest(); // hours may be left of it
    setState(LinkState::Closing);
    goOn();
}

void Desk::close(AtClose moving, LockAtClose lock)
{
    m_closing = true;
    m_nextRequest.reset();
    const bool idle = m_state == LinkState::Off && !m_connection && !m_opening;
    disconnectFrom(moving, lock);
    if (idle)
        QMetaObject::invokeMethod(this, &Desk::closed, Qt::QueuedConnection);
}

void Desk::powerCycle()
{
    if (!m_connection || !m_connection->powerCycle())
        return;
    for (auto& [ref, known] : m_servos)
        known.turns.reset();
}

void Desk::lookAtLink()
{
    if (m_connection) {
        noteHeard();
        identifyHeard();
    }
    if (!m_connection || !m_connection->bus().lost())
        return;
    setState(LinkState::Lost);
    stopSearch();
    dropQueue(base::ErrorCode::LinkLost);
    tell({.kind = Event::Kind::LinkLost, .task = m_request.name});
    goOn();
}

/// After anything has ended: the port is closed when that was waited for, the next search or task
/// begins.
void Desk::goOn()
{
    startNext();
    const bool idle = !m_opening && !m_running && m_queue.empty() &&
                      !(m_search && m_search->started) && m_identifying.empty();
    if (idle && (m_state == LinkState::Closing || m_state == LinkState::Lost)) {
        m_search.reset();
        m_feeder.stop(nullptr);
        // Closing a port may take as long as its adapter likes. Opening waits in the same line.
        m_openThread->start([old = std::shared_ptr<Connection>(std::move(m_connection))]() mutable {
            old.reset();
        });
        if (m_state == LinkState::Closing)
            finishClosing();
        return;
    }
    startSearch();
    startNext(); // what may go on beside the search that has just begun
    updateFeed();
}

void Desk::finishClosing()
{
    const Leaving left = std::exchange(m_leaving, std::nullopt).value_or(Leaving{});
    setState(LinkState::Off);
    tell({.kind = Event::Kind::Disconnected,
          .task = m_request.name,
          .halted = left.halted,
          .moving = left.moving,
          .locked = left.locked,
          .unlocked = left.unlocked});
    if (m_closing) {
        // Not from within the call that asked for it: a window being closed cannot be closed.
        QMetaObject::invokeMethod(this, &Desk::closed, Qt::QueuedConnection);
    } else if (m_nextRequest) {
        const PortRequest next = *m_nextRequest;
        m_nextRequest.reset();
        connectTo(next);
    }
}

const ServoEntry* Desk::servo(ServoRef ref) const
{
    const auto place = m_servos.find(ref);
    return place != m_servos.end() ? &place->second : nullptr;
}

ServoEntry* Desk::entry(ServoRef ref)
{
    const auto place = m_servos.find(ref);
    return place != m_servos.end() ? &place->second : nullptr;
}

ServoRef Desk::find(base::Protocol protocol, int id) const
{
    for (const ServoRef ref : m_order) {
        const device::Servo& known = m_servos.at(ref).servo;
        if (known.protocol == protocol && known.id == id)
            return ref;
    }
    return 0;
}
} // namespace session

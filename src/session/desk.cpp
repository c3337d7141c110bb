// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/desk.h"

#include "session/desk_work.h"

#include <algorithm>

namespace session {
using namespace std::chrono_literals;

namespace {
/// Unplugging is noticed by the bus within 200 ms, and here within as much again.
constexpr auto linkCheckInterval = 200ms;
/// Torque switches that have not been read back by then are reported.
constexpr auto confirmTimeout = 1500ms;
} // namespace

Desk::Desk(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_openThread(std::make_unique<JobThread>())
    , m_searchThread(std::make_unique<JobThread>())
    , m_taskThread(std::make_unique<JobThread>())
{
    m_linkTimer.setInterval(linkCheckInterval);
    connect(&m_linkTimer, &QTimer::timeout, this, &Desk::checkLink);
    m_stopUnconfirmed.setInterval(confirmTimeout);
    m_stopUnconfirmed.setSingleShot(true);
    connect(&m_stopUnconfirmed, &QTimer::timeout, this, &Desk::reportUnconfirmed);
    m_pollTimer.setInterval(33ms);
    m_pollTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_pollTimer, &QTimer::timeout, this, [this] {
        collectReadings();
        updatePolling(); // one of them may have a new ID now: asked under that one
    });
}

Desk::~Desk()
{
    if (m_search)
        m_search->stop.request();
    if (m_running)
        m_running->stop.request();
}

bool Desk::isSimulated() const
{
    return m_connection && m_connection->isSimulated();
}

int Desk::baud() const
{
    return m_connection ? m_connection->bus().baud() : 0;
}

bool Desk::canSetBaud() const
{
    return m_connection && m_connection->bus().canSetBaud();
}

bus::Statistics Desk::statistics() const
{
    return m_connection ? m_connection->bus().statistics() : bus::Statistics{};
}

base::Duration Desk::now() const
{
    return m_session.clock().now();
}

void Desk::emitEvent(Event event)
{
    event.at = QDateTime::currentDateTime();
    if (const ServoEntry* known = servo(event.servo))
        event.id = known->servo.id;
    Q_EMIT eventOccurred(event);
}

void Desk::setState(LinkState state)
{
    if (state == m_state)
        return;
    m_state = state;
    if (state == LinkState::Open)
        m_linkTimer.start();
    else
        m_linkTimer.stop();
    updatePolling();
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
        clearServos();
    m_request = request;
    m_intentsChecked = false;
    m_replyCounters.clear();
    m_opening = true;
    setState(LinkState::Opening);
    m_openThread->start([this, request] {
        auto result =
            std::make_shared<base::Result<std::unique_ptr<Connection>>>(m_session.connect(request));
        m_mainQueue.post([this, result] { portOpened(std::move(*result)); });
    });
}

void Desk::clearServos()
{
    m_servos.clear();
    m_order.clear();
    m_undo.clear();
    m_redo.clear();
    m_pendingStep.reset();
    m_polling.removeAllServos();
    m_lastSearch.reset();
    Q_EMIT servosCleared();
    Q_EMIT undoChanged();
}

void Desk::portOpened(base::Result<std::unique_ptr<Connection>> result)
{
    m_opening = false;
    if (m_state == LinkState::Closing) { // the user has changed their mind meanwhile
        result = base::fail(base::ErrorCode::Stopped);
        scheduleNext();
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
        m_connection->addStopTarget(known.servo);
        known.turns.reset();
    }
    setState(LinkState::Open);
    emitEvent({.kind = Event::Kind::Connected, .task = m_connection->bus().portName()});
    if (std::exchange(m_stopNotSent, false))
        emitEvent({.kind = Event::Kind::StopNotSent, .isRepeated = true});
}

void Desk::disconnectFrom(MotionOnClose moving, LockOnClose lock)
{
    if (m_state == LinkState::Off && !m_connection) {
        m_nextRequest.reset();
        return;
    }
    if (m_pendingClose) { // asked for again while servos are being stopped
        if (moving == MotionOnClose::LeaveMoving)
            closeNow();
        return;
    }
    m_pendingClose = PendingClose{moving, lock};
    prepareClose();
}

void Desk::closeNow()
{
    if (m_state == LinkState::Lost && !m_connection) {
        m_pendingClose.reset();
        setState(LinkState::Off);
        if (m_closing)
            QMetaObject::invokeMethod(this, &Desk::closed, Qt::QueuedConnection);
        return;
    }
    clearQueue(base::ErrorCode::Stopped, true);
    stopSearch();
    stopTest(); // hours may be left of it
    setState(LinkState::Closing);
    scheduleNext();
}

void Desk::closeForExit(MotionOnClose moving, LockOnClose lock)
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

void Desk::checkLink()
{
    if (m_connection) {
        updatePresence();
        identifyReturned();
    }
    if (!m_connection || !m_connection->bus().lost())
        return;
    setState(LinkState::Lost);
    stopSearch();
    clearQueue(base::ErrorCode::LinkLost);
    emitEvent({.kind = Event::Kind::LinkLost, .task = m_request.name});
    scheduleNext();
}

/// After anything has ended: the port is closed when that was waited for, the next search or task
/// begins.
void Desk::scheduleNext()
{
    startNext();
    const bool idle = !m_opening && !m_running && m_queue.empty() &&
                      !(m_search && m_search->started) && m_identifying.empty();
    if (idle && (m_state == LinkState::Closing || m_state == LinkState::Lost)) {
        m_search.reset();
        m_polling.stop(nullptr);
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
    updatePolling();
}

void Desk::finishClosing()
{
    const PendingClose left = std::exchange(m_pendingClose, std::nullopt).value_or(PendingClose{});
    setState(LinkState::Off);
    emitEvent({.kind = Event::Kind::Disconnected,
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
    const auto it = m_servos.find(ref);
    return it != m_servos.end() ? &it->second : nullptr;
}

ServoEntry* Desk::entry(ServoRef ref)
{
    const auto it = m_servos.find(ref);
    return it != m_servos.end() ? &it->second : nullptr;
}

ServoRef Desk::findServo(base::Protocol protocol, int id) const
{
    for (const ServoRef ref : m_order) {
        const device::Servo& known = m_servos.at(ref).servo;
        if (known.protocol == protocol && known.id == id)
            return ref;
    }
    return 0;
}
} // namespace session

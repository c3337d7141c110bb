// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/link/link_controller.h"

#include "session/workbench.h"

namespace session {
using namespace std::chrono_literals;

namespace {
/// Unplugging is noticed by the bus within 200 ms, and here within as much again.
constexpr auto linkCheckInterval = 200ms;
} // namespace

LinkController::LinkController(Workbench& bench)
    : m_bench(bench)
{
    m_timer.setInterval(linkCheckInterval);
    connect(&m_timer, &QTimer::timeout, this, &LinkController::checkLink);
}

bool LinkController::isSimulated() const
{
    return m_connection && m_connection->isSimulated();
}

int LinkController::baud() const
{
    return m_connection ? m_connection->bus().baud() : 0;
}

bool LinkController::canSetBaud() const
{
    return m_connection && m_connection->bus().canSetBaud();
}

bus::Statistics LinkController::statistics() const
{
    return m_connection ? m_connection->bus().statistics() : bus::Statistics{};
}

void LinkController::setState(LinkState state)
{
    if (state == m_state)
        return;
    m_state = state;
    if (state == LinkState::Open)
        m_timer.start();
    else
        m_timer.stop();
    m_bench.polling().updatePolling();
    Q_EMIT linkChanged();
}

void LinkController::connectTo(const PortRequest& request)
{
    if (m_connection || m_opening) {
        m_nextRequest = request;
        m_bench.closing().disconnectFrom();
        return;
    }
    if (request.name != m_request.name)
        m_bench.registry().clear();
    m_request = request;
    m_isReconnect = m_isRenamed = false;
    m_lostBaud = 0;
    setState(LinkState::Opening);
    open(request);
}

void LinkController::reconnect(const QString& portName)
{
    if (m_state != LinkState::Lost || m_connection || m_opening)
        return;
    m_isRenamed |= portName != m_request.name;
    m_request.name = portName;
    m_isReconnect = true;
    m_isCanceled = false;
    PortRequest request = m_request;
    if (m_lostBaud != 0) // that of the servos that were worked with
        request.baud = m_lostBaud;
    open(request);
}

void LinkController::cancelReconnect()
{
    m_isCanceled = m_opening && m_state == LinkState::Lost;
}

void LinkController::open(const PortRequest& request)
{
    m_bench.recovery().reset();
    m_bench.presence().reset();
    m_opening = true;
    m_bench.backgroundThread().start([this, request] {
        auto result = std::make_shared<base::Result<std::unique_ptr<Connection>>>(
            m_bench.session().connect(request));
        m_bench.mainQueue().post([this, result] { portOpened(std::move(*result)); });
    });
}

void LinkController::portOpened(base::Result<std::unique_ptr<Connection>> result)
{
    m_opening = false;
    if (m_state == LinkState::Closing) { // the user has changed their mind meanwhile
        result = base::fail(base::ErrorCode::Stopped);
        m_bench.scheduleNext();
        return;
    }
    if (m_isReconnect && std::exchange(m_isCanceled, false))
        return;
    if (!result) {
        if (!m_isReconnect)
            setState(LinkState::Off);
        Q_EMIT connectFailed(result.error());
        return;
    }
    m_connection = std::move(*result);
    m_portName = m_connection->bus().portName();
    for (const ServoRef ref : m_bench.registry().order()) {
        ServoEntry& known = *m_bench.registry().entry(ref);
        known.servo.port = m_portName; // after a reconnect it may be a new one
        m_connection->addStopTarget(known.servo);
        known.turns.reset();
    }
    if (m_isReconnect)
        m_bench.presence().askAll();
    setState(LinkState::Open);
    m_bench.emitEvent({.kind = Event::Kind::Connected, .task = m_connection->bus().portName()});
    m_bench.emergencyStop().portOpened();
    if (m_isReconnect) // under its old name the journal may have an interrupted write
        m_bench.recovery().checkOnce(m_isRenamed);
}

void LinkController::powerCycle()
{
    if (!m_connection || !m_connection->powerCycle())
        return;
    for (const ServoRef ref : m_bench.registry().order())
        m_bench.registry().entry(ref)->turns.reset();
}

void LinkController::checkLink()
{
    if (m_connection) {
        m_bench.presence().update();
        m_bench.presence().identifyReturned();
    }
    if (m_connection && !m_bench.search().isStarted())
        m_lostBaud = m_connection->bus().baud();
    if (!m_connection || !m_connection->bus().lost())
        return;
    m_isRenamed = false;
    setState(LinkState::Lost);
    m_bench.search().stop();
    m_bench.tasks().clearQueue(base::ErrorCode::LinkLost);
    m_bench.emitEvent({.kind = Event::Kind::LinkLost, .task = m_request.name});
    m_bench.scheduleNext();
}

void LinkController::connectToNext()
{
    if (const auto next = std::exchange(m_nextRequest, std::nullopt))
        connectTo(*next);
}

/// Closing a port may take as long as its adapter likes. Opening waits in the same line.
void LinkController::closeConnection()
{
    m_bench.backgroundThread().start(
        [old = std::shared_ptr<Connection>(std::move(m_connection))]() mutable { old.reset(); });
}
} // namespace session

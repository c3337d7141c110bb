// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/workbench.h"

#include "session/arm/arm_calibration.h"
#include "session/commission/commissioning.h"
#include "session/history/history_recorder.h"
#include "session/history/history_sender.h"
#include "session/history/history_service.h"
#include "session/motion/motion_controller.h"
#include "session/recording/live_data.h"
#include "session/snapshot/snapshots.h"
#include "session/step/step_test.h"
#include "session/sweep/sweep_test.h"

namespace session {
Workbench::Workbench(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_registry(session.clock())
    , m_link(*this)
    , m_polling(*this)
    , m_presence(*this)
    , m_search(*this)
    , m_tasks(*this)
    , m_emergencyStop(*this)
    , m_closing(*this)
    , m_writes(*this)
    , m_restores(*this)
    , m_recovery(*this)
    , m_backgroundThread(std::make_unique<base::JobThread>())
    , m_searchThread(std::make_unique<base::JobThread>())
    , m_taskThread(std::make_unique<base::JobThread>())
{
    connect(&m_registry, &ServoRegistry::addressChanged, this, [this](ServoRef ref) {
        if (m_link.connection() != nullptr)
            m_link.connection()->addStopTarget(m_registry.servo(ref)->servo);
    });
    connect(&m_link, &LinkController::linkChanged, this, &Workbench::stateChanged);
    connect(&m_registry, &ServoRegistry::servosCleared, this, &Workbench::stateChanged);
    connect(&m_search, &SearchService::searchChanged, this, &Workbench::stateChanged);
    connect(&m_tasks, &TaskQueue::taskChanged, this, &Workbench::stateChanged);
}

/// What works with the servos goes while the tasks it has begun can still end.
Workbench::~Workbench()
{
    m_historyRecorder.reset();
    m_commissioning.reset();
    m_snapshots.reset();
    m_stepTest.reset();
    m_sweepTest.reset();
    m_liveData.reset();
    m_motion.reset();
    m_search.requestStop();
    m_tasks.requestStop();
}

template <typename Service, typename... Parameters>
Service& Workbench::provide(std::unique_ptr<Service>& service, Parameters&... parameters)
{
    if (!service)
        service = std::make_unique<Service>(parameters...);
    return *service;
}

MotionController& Workbench::motion()
{
    return provide(m_motion, *this);
}

LiveData& Workbench::liveData()
{
    return provide(m_liveData, *this);
}

SweepTest& Workbench::sweepTest()
{
    return provide(m_sweepTest, *this);
}

StepTest& Workbench::stepTest()
{
    return provide(m_stepTest, *this);
}

Snapshots& Workbench::snapshots()
{
    return provide(m_snapshots, *this, history());
}

Commissioning& Workbench::commissioning()
{
    return provide(m_commissioning, *this);
}

ArmCalibration& Workbench::armCalibration()
{
    return provide(m_armCalibration, *this);
}

HistoryService& Workbench::history()
{
    return provide(m_history);
}

HistoryRecorder& Workbench::historyRecorder()
{
    return provide(m_historyRecorder, *this);
}

HistorySender& Workbench::historySender()
{
    return provide(m_historySender);
}

base::Duration Workbench::now() const
{
    return m_session.clock().now();
}

void Workbench::emitEvent(Event event)
{
    event.at = QDateTime::currentDateTime();
    if (const ServoEntry* known = m_registry.servo(event.servo))
        event.id = known->servo.id;
    Q_EMIT eventOccurred(event);
}

void Workbench::scheduleNext()
{
    m_tasks.startNext();
    const bool idle = !m_link.isOpening() && !m_tasks.isBusy() && !m_search.isStarted() &&
                      !m_presence.isIdentifying();
    const LinkState state = m_link.state();
    if (idle && (state == LinkState::Closing || state == LinkState::Lost)) {
        m_search.drop();
        m_polling.stop();
        m_link.closeConnection();
        if (state == LinkState::Closing)
            m_closing.finishClosing();
        return;
    }
    m_search.startPending();
    m_tasks.startNext(); // what may go on beside the search that has just begun
    m_polling.updatePolling();
}
} // namespace session

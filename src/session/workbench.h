// SPDX-License-Identifier: GPL-3.0-or-later
// The bench behind the window: one port, the servos on it, and every task done to them. Owns the
// services that share them, and decides what may begin next. Main thread; never waits: each call
// returns at once, and what comes of it arrives as a signal or in a callback, on the main thread.
// Nothing is written to a servo that was not asked for through its services.
#pragma once

#include "base/job_thread.h"
#include "session/event.h"
#include "session/link/link_controller.h"
#include "session/main_thread_queue.h"
#include "session/polling/poll_controller.h"
#include "session/search/search_service.h"
#include "session/servos/presence_monitor.h"
#include "session/servos/servo_registry.h"
#include "session/session.h"
#include "session/tasks/close_sequence.h"
#include "session/tasks/emergency_stop.h"
#include "session/tasks/task_queue.h"
#include "session/writes/recovery_service.h"
#include "session/writes/restore_service.h"
#include "session/writes/write_service.h"

namespace session {
class ArmCalibration;
class Commissioning;
class HistoryRecorder;
class HistorySender;
class HistoryService;
class LiveData;
class MotionController;
class Snapshots;
class StepTest;
class SweepTest;

class Workbench final : public QObject {
    Q_OBJECT

public:
    explicit Workbench(Session& session, QObject* parent = nullptr);
    ~Workbench() override; ///< waits for the running job; see CloseSequence

    base::Duration now() const; ///< the clock of all times here
    const catalog::Catalog& catalog() const { return m_session.catalog(); }
    Session& session() { return m_session; }

    LinkController& link() { return m_link; }
    const LinkController& link() const { return m_link; }
    ServoRegistry& registry() { return m_registry; }
    const ServoRegistry& registry() const { return m_registry; }
    SearchService& search() { return m_search; }
    const SearchService& search() const { return m_search; }
    TaskQueue& tasks() { return m_tasks; }
    const TaskQueue& tasks() const { return m_tasks; }
    WriteService& writes() { return m_writes; }
    const WriteService& writes() const { return m_writes; }
    RestoreService& restores() { return m_restores; }
    RecoveryService& recovery() { return m_recovery; }
    PollController& polling() { return m_polling; }
    const PollController& polling() const { return m_polling; }
    EmergencyStop& emergencyStop() { return m_emergencyStop; }
    CloseSequence& closing() { return m_closing; }
    const CloseSequence& closing() const { return m_closing; }

    // What works with the servos, made when it is first asked for.
    MotionController& motion();
    LiveData& liveData();
    SweepTest& sweepTest();
    StepTest& stepTest();
    Snapshots& snapshots();
    Commissioning& commissioning();
    ArmCalibration& armCalibration();
    HistoryService& history();
    HistoryRecorder& historyRecorder(); ///< from then on tests, alarms and recordings are kept
    HistorySender& historySender();     ///< no server is set at first

    /// For the services.
    PresenceMonitor& presence() { return m_presence; }
    MainThreadQueue& mainQueue() { return m_mainQueue; }
    base::JobThread& backgroundThread() { return *m_backgroundThread; } ///< ports and journal
    base::JobThread& searchThread() { return *m_searchThread; }
    base::JobThread& taskThread() { return *m_taskThread; }
    void emitEvent(Event event);
    /// After anything has ended: the port closes if that was waited for, or the next search or task
    /// begins.
    void scheduleNext();

Q_SIGNALS:
    /// The link, the search or the tasks have changed, or the list was cleared: what can be started
    /// now may be something else.
    void stateChanged();
    void eventOccurred(const session::Event& event);

private:
    template <typename Service, typename... Parameters>
    Service& provide(std::unique_ptr<Service>& service, Parameters&... parameters);

    Session& m_session;
    MainThreadQueue m_mainQueue;
    ServoRegistry m_registry;
    LinkController m_link;
    PollController m_polling;
    PresenceMonitor m_presence;
    SearchService m_search;
    TaskQueue m_tasks;
    EmergencyStop m_emergencyStop;
    CloseSequence m_closing;
    WriteService m_writes;
    RestoreService m_restores;
    RecoveryService m_recovery;

    std::unique_ptr<HistoryService> m_history;
    std::unique_ptr<HistorySender> m_historySender;
    std::unique_ptr<MotionController> m_motion;
    std::unique_ptr<LiveData> m_liveData;
    std::unique_ptr<SweepTest> m_sweepTest;
    std::unique_ptr<StepTest> m_stepTest;
    std::unique_ptr<Snapshots> m_snapshots;
    std::unique_ptr<Commissioning> m_commissioning;
    std::unique_ptr<ArmCalibration> m_armCalibration;
    std::unique_ptr<HistoryRecorder> m_historyRecorder;

    // Last: their jobs use everything above, so they end first.
    std::unique_ptr<base::JobThread> m_backgroundThread;
    std::unique_ptr<base::JobThread> m_searchThread;
    std::unique_ptr<base::JobThread> m_taskThread;
};
} // namespace session

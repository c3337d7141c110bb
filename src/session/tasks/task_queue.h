// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks with servos, one after the other on the task thread: a task gets copies of its servos, and
// what it has read is merged into the list when it has ended. Owned by the workbench; main thread;
// never waits. What cannot run is answered through its callback, never from within the call.
#pragma once

#include "jobs/job.h"
#include "session/tasks/work.h"

#include <QObject>

#include <deque>

namespace session {
class Workbench;

class TaskQueue final : public QObject {
    Q_OBJECT

public:
    explicit TaskQueue(Workbench& bench);

    void perform(ServoRef ref, Task task);
    bool isBusy() const;    ///< a task runs or waits
    bool isTesting() const; ///< a lasting task runs; see Task::isLongRunning
    std::optional<bool>
    testHoldsTorque() const;     ///< Task::holdsTorqueAfterwards of the one that runs
    QString runningName() const; ///< Task::name of the one that runs; empty: none
    void stop();                 ///< the running task; those that wait are dropped
    void stopTest();             ///< the running one, if it is a lasting one; nothing else

    /// For the services of the workbench.
    void enqueue(std::shared_ptr<Work> work);
    /// Without the checks of enqueue(): what must be done before the port closes.
    void enqueueClosing(std::shared_ptr<Work> work);
    void startNext();
    void clearQueue(base::ErrorCode why, bool finishWrites = false);
    void requestStop();
    const std::shared_ptr<Work>& running() const { return m_running; } ///< null: none
    /// Of the one that runs and those that wait.
    bool any(const std::function<bool(const Work&)>& matches) const;

Q_SIGNALS:
    void taskChanged();                                ///< isBusy() may have changed
    void taskProgress(const jobs::Progress& progress); ///< with an estimate, if there is one

private:
    bool canRun(const Work& work) const;
    std::optional<base::Error> copyServos(Work& work) const;
    base::Result<void> prepare(const device::Context& context, Work& work);
    void runWork(Work& work);
    void tryWork(Work& work);
    void workEnded(const std::shared_ptr<Work>& work);
    void partEnded(const Work& work, const Work::Part& part);
    void cancelWork(Work& work, base::Error why);

    Workbench& m_bench;
    std::deque<std::shared_ptr<Work>> m_queue;
    std::shared_ptr<Work> m_running;
};
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
// A JobThread for jobs that may hang in a library for as long as a server does: at the end its
// owner waits for a limited time only, and then leaves the thread behind. A job therefore owns all
// it uses (shared pointers), and checks whether it was left behind before it touches anything else.
// A thread that ends in time has ended altogether, with all that libraries keep for each thread;
// for the others main ends by exitCode().
#pragma once

#include "base/job_thread.h"
#include "session/main_thread_queue.h"

namespace session {
class DetachableWorker : private base::JobThread {
public:
    ~DetachableWorker(); ///< waits for nothing

    void start(std::function<void()> job);
    /// Drops the jobs that wait; `last` runs after the running job. True: all has ended within
    /// `grace` (which an idle thread does not need).
    bool finish(std::chrono::milliseconds grace, std::function<void()> last = {});

    /// For jobs that come back from where they hung: the thread may have been left behind, and the
    /// program may have ended so far that nothing of Qt can be touched any more. Then this stays.
    static void blockIfProgramEnds();

    /// What main returns. Where a thread was left behind this ends the program at once, because a
    /// library that is unloaded under a running thread crashes the program.
    static int exitCode(int code);
};

/// The way back from such a thread to the main thread. post() from any thread; what comes after
/// close() is dropped.
class GuardedPoster {
public:
    explicit GuardedPoster(MainThreadQueue& mainQueue)
        : m_mainQueue(&mainQueue)
    {}

    void post(std::function<void()> work);
    void close();

private:
    std::mutex m_mutex;
    MainThreadQueue* m_mainQueue;
};
} // namespace session

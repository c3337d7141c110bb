// SPDX-License-Identifier: GPL-3.0-or-later
// Like JobThread, for jobs that may hang in a library for as long as a server pleases: its owner
// waits for them at the end as long as it likes and no longer, and leaves one that is still at it
// behind. So a job owns all it uses (shared pointers), and looks whether it has been left before
// it touches anything else. start() from the owner only; never waits. What ends in time has ended
// altogether, with all that libraries keep for each thread; for the rest main ends by exitCode().
#pragma once

#include "session/main_thread_queue.h"

#include <chrono>
#include <memory>
#include <thread>

namespace session {
class DetachableWorker {
public:
    DetachableWorker();
    DetachableWorker(const DetachableWorker&) = delete;
    DetachableWorker& operator=(const DetachableWorker&) = delete;
    ~DetachableWorker(); ///< leaves it at once

    void start(std::function<void()> job);
    /// Drops what waits; `last` is done after the running job. True: all has ended within `grace`
    /// (which an idle thread does not need).
    bool finish(std::chrono::milliseconds grace, std::function<void()> last = {});

    /// For jobs that come back from where they hung: they may have been left behind, and the
    /// program may have ended so far that nothing of Qt can be touched any more. Then this stays.
    static void blockIfProgramEnds();

    /// What main returns. Where a thread was left behind this ends the program at once, since a
    /// library that is being torn down under a thread brings the program down with it.
    static int exitCode(int code);

private:
    struct State;
    static void run(const std::shared_ptr<State>& state);

    std::shared_ptr<State> m_state; ///< shared with the thread, which may outlive this
    std::thread m_thread;
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

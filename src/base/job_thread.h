// SPDX-License-Identifier: GPL-3.0-or-later
// A thread that runs jobs one after the other, in the order they were given. start() from any
// thread, without waiting. The destructor, by the owner, lets the running job end (its own stop
// must have been requested) and drops the jobs that wait.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

namespace base {
class JobThread {
public:
    JobThread();
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;
    ~JobThread();

    void start(std::function<void()> job);

protected:
    /// Drops the jobs that wait; `last` runs after the running job. Without `grace` it waits until
    /// all has ended. False: that took longer than `grace`, and the thread goes on by itself.
    bool finish(std::optional<std::chrono::milliseconds> grace, std::function<void()> last = {});

private:
    struct State;
    static void run(State& state);

    std::shared_ptr<State> m_state; ///< shared with the thread, which may outlive this
    std::thread m_thread;
};
} // namespace base

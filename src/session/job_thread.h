// SPDX-License-Identifier: GPL-3.0-or-later
// A thread that runs jobs one after the other, in the order they were given. start() from the owner
// only and without waiting; a job that blocks on the wire blocks nobody else. The destructor lets
// the running job end (its own stop must have been requested) and drops those that wait.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace session {
class JobThread {
public:
    JobThread();
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;
    ~JobThread();

    void start(std::function<void()> job);

private:
    void run();

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<std::function<void()>> m_jobs;
    bool m_ending = false;
    std::thread m_thread; ///< last: it uses the others
};
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/job_thread.h"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace base {
struct JobThread::State {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void()>> jobs;
    std::function<void()> last;
    bool busy = false;
    bool ending = false;
    bool ended = false;
};

JobThread::JobThread()
    : m_state(std::make_shared<State>())
    , m_thread([state = m_state] { run(*state); })
{}

JobThread::~JobThread()
{
    finish(std::nullopt);
}

void JobThread::start(std::function<void()> job)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->jobs.push_back(std::move(job));
    m_state->changed.notify_all();
}

bool JobThread::finish(std::optional<std::chrono::milliseconds> grace, std::function<void()> last)
{
    std::deque<std::function<void()>> dropped; // destroyed without the lock
    std::unique_lock lock(m_state->mutex);
    if (!m_thread.joinable())
        return m_state->ended;
    m_state->last = std::move(last);
    m_state->ending = true;
    dropped.swap(m_state->jobs);
    m_state->changed.notify_all();
    const bool isIdle = !m_state->busy && !m_state->last;
    const bool ends = !grace || isIdle ||
                      m_state->changed.wait_for(lock, *grace, [this] { return m_state->ended; });
    lock.unlock();
    if (ends)
        m_thread.join();
    else
        m_thread.detach();
    return ends;
}

void JobThread::run(State& state)
{
    std::unique_lock lock(state.mutex);
    for (;;) {
        state.changed.wait(lock, [&] { return state.ending || !state.jobs.empty(); });
        if (state.ending)
            break;
        std::function<void()> job = std::move(state.jobs.front());
        state.jobs.pop_front();
        state.busy = true;
        lock.unlock();
        job();
        job = {};
        lock.lock();
        state.busy = false;
    }
    std::function<void()> last = std::move(state.last);
    lock.unlock();
    if (last)
        last();
    last = {};
    lock.lock();
    state.ended = true;
    state.changed.notify_all();
}
} // namespace base

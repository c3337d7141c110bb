// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/detachable_worker.h"

#include <QCoreApplication>

#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <deque>

namespace session {
namespace {
std::atomic<bool> hasDetachedThread = false;
}

struct DetachableWorker::State {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::function<void()>> jobs;
    std::function<void()> last;
    bool busy = false;
    bool ending = false;
    bool ended = false;
};

DetachableWorker::DetachableWorker()
    : m_state(std::make_shared<State>())
    , m_thread([state = m_state] { run(state); })
{}

DetachableWorker::~DetachableWorker()
{
    finish({});
}

void DetachableWorker::start(std::function<void()> job)
{
    const std::lock_guard lock(m_state->mutex);
    m_state->jobs.push_back(std::move(job));
    m_state->changed.notify_all();
}

bool DetachableWorker::finish(std::chrono::milliseconds grace, std::function<void()> last)
{
    if (!m_thread.joinable()) {
        const std::lock_guard lock(m_state->mutex);
        return m_state->ended;
    }
    bool ended = false;
    {
        std::deque<std::function<void()>> dropped;
        std::unique_lock lock(m_state->mutex);
        m_state->last = std::move(last);
        m_state->ending = true;
        dropped.swap(m_state->jobs);
        m_state->changed.notify_all();
        const bool idle = !m_state->busy && !m_state->last;
        ended = idle || m_state->changed.wait_for(lock, grace, [this] { return m_state->ended; });
    }
    if (ended) {
        m_thread.join();
    } else {
        hasDetachedThread = true;
        m_thread.detach();
    }
    return ended;
}

void DetachableWorker::run(const std::shared_ptr<State>& state)
{
    for (;;) {
        std::function<void()> job;
        {
            std::unique_lock lock(state->mutex);
            state->changed.wait(lock, [&] { return state->ending || !state->jobs.empty(); });
            if (state->ending)
                break;
            job = std::move(state->jobs.front());
            state->jobs.pop_front();
            state->busy = true;
        }
        job();
        blockIfProgramEnds();
        job = {};
        const std::lock_guard lock(state->mutex);
        state->busy = false;
    }
    if (state->last)
        state->last();
    state->last = {};
    const std::lock_guard lock(state->mutex);
    state->ended = true;
    state->changed.notify_all();
}

void DetachableWorker::blockIfProgramEnds()
{
    while (QCoreApplication::instance() == nullptr)
        std::this_thread::sleep_for(std::chrono::hours(1));
}

int DetachableWorker::exitCode(int code)
{
    if (hasDetachedThread) {
        std::fflush(nullptr);
        std::_Exit(code);
    }
    return code;
}

void GuardedPoster::post(std::function<void()> work)
{
    const std::lock_guard lock(m_mutex);
    if (m_mainQueue != nullptr)
        m_mainQueue->post(std::move(work));
}

void GuardedPoster::close()
{
    const std::lock_guard lock(m_mutex);
    m_mainQueue = nullptr;
}
} // namespace session

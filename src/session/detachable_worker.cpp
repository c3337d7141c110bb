// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/detachable_worker.h"

#include <QCoreApplication>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace session {
namespace {
std::atomic<bool> hasDetachedThread = false;
}

DetachableWorker::~DetachableWorker()
{
    finish({});
}

void DetachableWorker::start(std::function<void()> job)
{
    JobThread::start([job = std::move(job)] {
        job();
        blockIfProgramEnds(); // before what the job holds is destroyed
    });
}

bool DetachableWorker::finish(std::chrono::milliseconds grace, std::function<void()> last)
{
    const bool ended = JobThread::finish(grace, std::move(last));
    if (!ended)
        hasDetachedThread = true;
    return ended;
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

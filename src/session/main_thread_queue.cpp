// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/main_thread_queue.h"

#include <QCoreApplication>
#include <QEvent>

namespace session {
namespace {
const auto wakeUp = static_cast<QEvent::Type>(QEvent::registerEventType());
} // namespace

void MainThreadQueue::post(std::function<void()> work)
{
    bool first = false;
    {
        const std::lock_guard lock(m_mutex);
        first = m_work.empty();
        m_work.push_back(std::move(work));
    }
    if (first)
        QCoreApplication::postEvent(this, new QEvent(wakeUp));
}

bool MainThreadQueue::event(QEvent* event)
{
    if (event->type() != wakeUp)
        return QObject::event(event);
    drain();
    return true;
}

void MainThreadQueue::drain()
{
    std::deque<std::function<void()>> work;
    {
        const std::lock_guard lock(m_mutex);
        work.swap(m_work);
    }
    for (const auto& one : work)
        one();
}
} // namespace session

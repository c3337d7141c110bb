// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/history_watcher.h"

#include "history/history_change_detector.h"

#include <QPointer>

namespace session {
namespace {
constexpr auto checkInterval = std::chrono::seconds(1);
}

HistoryWatcher::HistoryWatcher(const QString& path, base::JobThread& thread,
                               std::shared_ptr<GuardedPoster> post)
    : m_thread(thread)
    , m_post(std::move(post))
    , m_detector(std::make_shared<history::HistoryChangeDetector>(path))
{
    m_timer.setInterval(checkInterval);
    connect(&m_timer, &QTimer::timeout, this, &HistoryWatcher::ask);
}

HistoryWatcher::~HistoryWatcher() = default;

void HistoryWatcher::setWatched(QObject* viewer, bool viewed)
{
    if (viewed == (m_viewers.count(viewer) > 0))
        return;
    if (!viewed) {
        m_viewers.erase(viewer);
        disconnect(viewer, &QObject::destroyed, this, nullptr);
        if (m_viewers.empty()) {
            m_timer.stop();
            m_thread.start([detector = m_detector] { detector->close(); });
        }
        return;
    }
    m_viewers.insert(viewer);
    connect(viewer, &QObject::destroyed, this, [this, viewer] { setWatched(viewer, false); });
    if (m_viewers.size() == 1) {
        m_timer.start();
        // The state the viewer is about to read, also while an earlier question has no answer yet.
        m_thread.start([detector = m_detector] { detector->hasChanged(); });
    }
}

/// One question at a time: the thread may be busy for long.
void HistoryWatcher::ask()
{
    if (m_asking)
        return;
    m_asking = true;
    m_thread.start([detector = m_detector, post = m_post, self = QPointer(this)] {
        post->post([self, changed = detector->hasChanged()] {
            if (!self)
                return;
            self->m_asking = false;
            if (changed && !self->m_viewers.empty())
                Q_EMIT self->changed();
        });
    });
}
} // namespace session

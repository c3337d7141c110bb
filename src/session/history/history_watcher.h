// SPDX-License-Identifier: GPL-3.0-or-later
// Notices what other connections and programs write to the history, while a page shows it. Checks
// once a second on the thread of HistoryService, which owns it. Main thread, never waits.
#pragma once

#include "base/job_thread.h"
#include "session/detachable_worker.h"

#include <QTimer>

#include <set>

namespace history {
class HistoryChangeDetector;
}

namespace session {
class HistoryWatcher final : public QObject {
    Q_OBJECT

public:
    /// The thread must outlive it; a viewer may not.
    HistoryWatcher(const QString& path, base::JobThread& thread,
                   std::shared_ptr<GuardedPoster> post);
    ~HistoryWatcher() override;

    /// Nothing is checked without a viewer. What was written before the first one is not reported:
    /// a viewer reads the history when it comes.
    void setWatched(QObject* viewer, bool viewed);

Q_SIGNALS:
    void changed();

private:
    void ask();

    base::JobThread& m_thread;
    const std::shared_ptr<GuardedPoster> m_post;
    const std::shared_ptr<history::HistoryChangeDetector> m_detector; ///< used on that thread
    std::set<const QObject*> m_viewers;
    QTimer m_timer;
    bool m_asking = false;
};
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
// Notices what other connections and programs write to the history, while a page shows it. Asks
// once a second on the thread of session::Archive, which owns it. Main thread, never waits.
#pragma once

#include "session/detachable_worker.h"
#include "session/job_thread.h"

#include <QTimer>

#include <set>

namespace record {
class HistoryChangeDetector;
}

namespace session {
class HistoryWatcher final : public QObject {
    Q_OBJECT

public:
    /// The thread must outlive it; a viewer may not.
    HistoryWatcher(const QString& path, JobThread& thread, std::shared_ptr<GuardedPoster> post);
    ~HistoryWatcher() override;

    /// Nothing is asked without a viewer. What was written before the first one came is not told:
    /// a viewer reads the history when it comes.
    void setWatched(QObject* viewer, bool viewed);

Q_SIGNALS:
    void changed();

private:
    void ask();

    JobThread& m_thread;
    const std::shared_ptr<GuardedPoster> m_post;
    const std::shared_ptr<record::HistoryChangeDetector> m_detector; ///< used on that thread
    std::set<const QObject*> m_viewers;
    QTimer m_timer;
    bool m_asking = false;
};
} // namespace session

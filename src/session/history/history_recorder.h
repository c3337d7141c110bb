// SPDX-License-Identifier: GPL-3.0-or-later
// Saves in the history what happens besides writes and snapshots: tests and recordings that have
// ended, alarms that come and go. Checks the alarms once a second. Owned by the workbench; main
// thread; never waits.
#pragma once

#include "session/history/history_service.h"
#include "session/history/reported_alarms.h"
#include "session/recording/live_data.h"

#include <map>

namespace session {
class HistoryRecorder final : public QObject {
    Q_OBJECT

public:
    explicit HistoryRecorder(Workbench& workbench);

    /// Saves alarms that have come or gone, as the timer does.
    void checkNow();

private:
    void recorded(const recording::RecorderStatus& status, const QString& path);

    Workbench& m_workbench;
    LiveData& m_liveData;
    HistoryService& m_historyService;
    std::map<ServoRef, ReportedAlarms> m_reported;
    std::vector<base::ServoIdentity> m_recorded; ///< the servos of the running recording
    QDateTime m_recordedAt;
    QTimer m_checkTimer;
};
} // namespace session

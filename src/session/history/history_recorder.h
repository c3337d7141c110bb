// SPDX-License-Identifier: GPL-3.0-or-later
// Writes down in the history what happens at the bench beside writes and snapshots: alarms that
// come and go, recordings that have ended. Looks at the alarms once a second: one that flickers
// costs no more than that. Beside Desk, Scope and HistoryService, which must outlive it; main
// thread, never waits.
#pragma once

#include "session/history/history_service.h"
#include "session/recording/live_data.h"

#include <map>
#include <set>

namespace session {
class HistoryRecorder final : public QObject {
    Q_OBJECT

public:
    HistoryRecorder(Desk& desk, LiveData& liveData, HistoryService& historyService,
                    QObject* parent = nullptr);

    /// As the clock does; for whoever cannot wait for it.
    void checkNow();

private:
    /// Of one alarm, as the history has it.
    struct ReportedAlarm {
        int times = 0;
        bool active = false;
    };
    void checkServo(const ServoEntry& entry);
    void recorded(const record::RecorderStatus& status, const QString& path);

    Desk& m_desk;
    LiveData& m_liveData;
    HistoryService& m_historyService;
    std::map<ServoRef, std::map<QString, ReportedAlarm>> m_reported;
    std::vector<base::ServoIdentity> m_recorded; ///< whom the running recording is about
    QDateTime m_recordedAt;
    QTimer m_checkTimer;
};
} // namespace session

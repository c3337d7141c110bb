// SPDX-License-Identifier: GPL-3.0-or-later
// Writes down in the history what happens at the bench beside writes and snapshots: alarms that
// come and go, recordings that have ended. Looks at the alarms once a second: one that flickers
// costs no more than that. Beside Desk, Scope and Archive, which must outlive it; main thread,
// never waits.
#pragma once

#include "session/archive.h"
#include "session/scope.h"

#include <map>
#include <set>

namespace session {
class HistoryKeeper final : public QObject {
    Q_OBJECT

public:
    HistoryKeeper(Desk& desk, Scope& scope, Archive& archive, QObject* parent = nullptr);

    /// As the clock does; for whoever cannot wait for it.
    void look();

private:
    /// Of one alarm, as the history has it.
    struct Told {
        int times = 0;
        bool active = false;
    };
    void lookAt(const ServoEntry& entry);
    void recorded(const record::RecorderStatus& status, const QString& path);

    Desk& m_desk;
    Scope& m_scope;
    Archive& m_archive;
    std::map<ServoRef, std::map<QString, Told>> m_told;
    std::vector<base::ServoIdentity> m_recorded; ///< whom the running recording is about
    QDateTime m_recordedAt;
    QTimer m_look;
};
} // namespace session

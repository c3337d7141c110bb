// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes of earlier sessions: finds them in the journal and on the bus, finishes,
// undoes or gives them up. Owned by the workbench; main thread; never waits. After a check that
// failed there is only the Event.
#pragma once

#include "jobs/recover/recover.h"
#include "session/tasks/work.h"

#include <QObject>

namespace session {
class Workbench;

class RecoveryService final : public QObject {
    Q_OBJECT

public:
    explicit RecoveryService(Workbench& bench);

    /// Reads only, and answers with openIntentsFound; done automatically after the first search.
    /// `anyPort`: also for servos whose change was begun on a port that is gone.
    void findOpenIntents(bool anyPort = false);
    void recoverIntent(const QString& uuid, jobs::RecoveryAction action);
    void discardIntent(const QString& uuid);

    /// For the services of the workbench.
    void checkOnce(bool anyPort = false); ///< of this connection
    void reset() { m_checked = false; }

Q_SIGNALS:
    /// Also when empty. `elsewhere`: open as well, but begun on other ports, and not checked.
    void openIntentsFound(const std::vector<jobs::RecoveryResult>& found,
                          const std::vector<base::Intent>& elsewhere);

private:
    void recoverIntents(jobs::RecoveryAction action, const QString& uuid, bool anyPort);
    ServoRef findEntry(const jobs::OpenIntent& found) const;
    void removeFormerEntry(const base::ServoIdentity& left, ServoRef now);
    void updateRecovered(const jobs::RecoveryResult& one);

    Workbench& m_bench;
    bool m_checked = false;
};
} // namespace session

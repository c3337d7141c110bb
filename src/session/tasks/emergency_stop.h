// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency stop: torque off for the whole bus, ahead of everything and without waiting. Then
// every torque switch is read back, and what waits in servos is made harmless (StopVerified).
// Every motion is refused until torque has been turned on for it again. Owned by the
// workbench; main thread.
#pragma once

#include "session/event.h"
#include "session/tasks/work.h"

#include <QObject>
#include <QTimer>

namespace jobs {
struct StopCheckResult;
}

namespace session {
class Workbench;

class EmergencyStop final : public QObject {
    Q_OBJECT

public:
    explicit EmergencyStop(Workbench& bench);

    void trigger();
    /// False while a search, a test or a task keeps the bus: torque would come on later,
    /// unexpectedly.
    bool canAllowMovement() const;
    /// Turns torque on for servos that are blocked: they hold where they are, and may be moved
    /// again. Ask before. False: nothing was begun, because it cannot be allowed now. `done` for
    /// each, unless `guard` has gone.
    bool allowMovement(const std::vector<ServoRef>& servos, QObject* guard,
                       const std::function<void(const TaskCompletion&)>& done);

    /// For the services of the workbench.
    void portOpened();   ///< a stop that found no port is reported again
    void baudRestored(); ///< what changed the port's rate has ended: a check that waited begins
    std::optional<base::Error> refusal(const Work& work) const; ///< names the servos that are held
    void release(const Work& ended);

private:
    /// One stop being checked, servo by servo.
    struct StopVerification {
        StopResult result;
        std::vector<ServoRef> unread; ///< no verdict yet
        std::size_t openCount = 0;
        bool superseded = false; ///< by another stop
    };
    void verify();
    void verify(ServoRef ref, const std::shared_ptr<StopVerification>& check);
    void addVerdict(ServoRef ref, StopVerification& check, const jobs::StopCheckResult& verdict,
                    const std::optional<base::Error>& error);
    void reportUnconfirmed();
    void storeHere(ServoRef ref);

    Workbench& m_bench;
    bool m_notSent = false; ///< a stop found no port
    bool m_checkAtOldBaud = false;
    std::weak_ptr<StopVerification> m_verification; ///< of the latest stop
    QTimer m_unconfirmed;                           ///< when that has taken too long
};
} // namespace session

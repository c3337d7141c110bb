// SPDX-License-Identifier: GPL-3.0-or-later
// Regular reading of what pages and recordings want to see, of servos that reply at the port's baud
// rate, and what comes of it: readings for charts, marks, alarms. Owned by the workbench; main
// thread; never waits.
#pragma once

#include "session/polling/polling_service.h"

#include <QObject>
#include <QTimer>

namespace session {
class Workbench;

class PollController final : public QObject {
    Q_OBJECT

public:
    explicit PollController(Workbench& bench);

    /// What `user` ("memory", "operate", "record") wants to see. Replaces this user's subscription;
    /// one without parts ends it.
    void subscribe(const QString& user, const Subscription& subscription);
    PollRate pollRate(ServoRef ref) const { return m_polling.rate(ref); }
    /// A goal was sent: shown in charts and recordings.
    void markMove(ServoRef ref, const QString& text, bool dragged = false);

    /// For the services of the workbench.
    bool canPoll() const;
    void updatePolling();
    void limitRate(base::Duration period) { m_polling.limitRate(period); }
    void stop() { m_polling.stop(nullptr); }
    void mark(recording::MarkKind kind, const ServoEntry* about, const QString& text);

Q_SIGNALS:
    /// About 30 times a second, in time order. Those that were not answered too.
    void readingsReceived(const std::vector<session::Reading>& batch);
    void markAdded(const recording::Mark& mark);

private:
    std::vector<const ServoEntry*> pollableServos() const;
    void collectReadings();

    Workbench& m_bench;
    PollingService m_polling;
    QTimer m_timer;
};
} // namespace session

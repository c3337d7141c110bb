// SPDX-License-Identifier: GPL-3.0-or-later
// The list of servos: what is known of each, merged from searches, tasks and regular reading, in
// the order of the list. Owned by the workbench; main thread; never fails. Pages read it; only the
// services of the workbench change it.
#pragma once

#include "base/clock.h"
#include "jobs/scan/scan.h"
#include "recording/trigger.h"
#include "session/servos/servo_entry.h"

#include <QObject>

namespace session {
/// False when another servo answers there now than the one in the list. One that could not be
/// identified this time or last time is taken for the same.
bool isSameKind(const device::Servo& a, const device::Servo& b);

class ServoRegistry final : public QObject {
    Q_OBJECT

public:
    explicit ServoRegistry(const base::Clock& clock);

    const std::vector<ServoRef>& order() const
    {
        return m_order;
    }                                                          ///< by ID, then protocol and rate
    const ServoEntry* servo(ServoRef ref) const;               ///< null: gone
    ServoRef findServo(base::Protocol protocol, int id) const; ///< one that replies first; 0: none
    base::Duration now() const { return m_clock.now(); }       ///< the clock of all times in it

    void acknowledgeAlarms(ServoRef ref);

    const std::map<ServoRef, ServoEntry>& entries() const { return m_servos; }

    /// For the services of the workbench.
    ServoEntry* entry(ServoRef ref); ///< null: gone
    ServoRef add(const jobs::FoundServo& one);
    void remove(ServoRef ref);
    void clear();
    /// What a job has read, and beside it what regular reading has brought since the job began.
    void merge(ServoEntry& into, const device::Servo& from, base::Duration since);
    void changed(const ServoEntry& entry); ///< emits the signal

Q_SIGNALS:
    void servoAdded(session::ServoRef ref);
    void servoChanged(session::ServoRef ref); ///< anything but the numbers of its table
    void servoRemoved(session::ServoRef ref);
    void servosCleared();
    void orderChanged();                        ///< the same servos, sorted again
    void tableChanged(session::ServoRef ref);   ///< numbers or their states
    void addressChanged(session::ServoRef ref); ///< ID or baud rate, before orderChanged
    void alarmMarked(const recording::Mark& mark);

private:
    void insertServo(ServoEntry added);
    bool sortsBefore(ServoRef a, ServoRef b) const;
    void sortOrder();
    void markAlarms(ServoEntry& entry);

    const base::Clock& m_clock;
    std::map<ServoRef, ServoEntry> m_servos;
    std::vector<ServoRef> m_order;
    ServoRef m_lastRef = 0;
};
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of one servo as the user has to see them: an alarm stays, with the time of its first
// occurrence and the number of occurrences, until it is acknowledged and over. A value.
#pragma once

#include "device/servo.h"

#include <QDateTime>

#include <vector>

namespace session {
/// An alarm that is active now.
struct ActiveAlarm {
    QString key;          ///< "overload"; "bit4" where the map has no name for it
    int bit = -1;         ///< of Servo::status; -1: none
    bool derived = false; ///< from measurements and limits, not reported by the servo
    bool operator==(const ActiveAlarm&) const = default;
};
/// Reported bits, or the results of device::derivedAlarms ("temperature", "voltage").
std::vector<ActiveAlarm> activeAlarms(const device::Servo& servo);

struct Alarm {
    ActiveAlarm what;
    bool active = false;
    QDateTime firstSeen;
    QDateTime latestSeen;     ///< when it came the latest time
    base::Duration firstAt{}; ///< workbench clock
    base::Duration latestAt{};
    int count = 0; ///< of its occurrences
    bool acknowledged = false;
};

class AlarmLatch {
public:
    struct Change {
        ActiveAlarm what;
        bool raised = false; ///< otherwise it ended
    };
    /// `at`: workbench clock; `seen`: the same moment as a time of day.
    std::vector<Change> update(const std::vector<ActiveAlarm>& now, base::Duration at,
                               const QDateTime& seen = QDateTime::currentDateTime());
    /// Removes the alarms that are over, and the others as soon as they are over.
    void acknowledge();
    const std::vector<Alarm>& alarms() const { return m_alarms; } ///< oldest first
    bool hasActive() const;

private:
    std::vector<Alarm> m_alarms;
};
} // namespace session

// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of one servo as the technician has to see them: what came stays, with the time it was
// first seen and how often, until it is acknowledged and over. Part of a ServoEntry; main thread.
#pragma once

#include "device/servo.h"

#include <QDateTime>

#include <vector>

namespace session {
/// One that is active now.
struct ActiveAlarm {
    QString key;          ///< "overload"; "bit-4" where the map has no name for it
    int bit = -1;         ///< of Servo::status; -1: none
    bool derived = false; ///< worked out from measurements and limits, not reported
    bool operator==(const ActiveAlarm&) const = default;
};
/// Reported bits, or what device::derivedAlarms works out ("temperature", "voltage").
std::vector<ActiveAlarm> activeAlarms(const device::Servo& servo);

struct Alarm {
    ActiveAlarm what;
    bool active = false;
    QDateTime firstSeen;
    base::Duration firstAt{}; ///< desk clock
    base::Duration latestAt{};
    int count = 0; ///< how often it came
    bool acknowledged = false;
};

class AlarmLatch {
public:
    struct Change {
        ActiveAlarm what;
        bool raised = false; ///< else it went
    };
    std::vector<Change> update(const std::vector<ActiveAlarm>& now, base::Duration at);
    /// Those that are over go at once, the others as soon as they are.
    void acknowledge();
    const std::vector<Alarm>& alarms() const { return m_alarms; } ///< oldest first
    bool hasActive() const;

private:
    std::vector<Alarm> m_alarms;
};
} // namespace session

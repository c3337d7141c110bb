// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of one servo as the technician has to see them: what came stays, with the time it was
// first seen and how often, until it is acknowledged and over. Part of a ServoEntry; main thread.
#pragma once

#include "device/servo.h"

#include <QDateTime>

#include <vector>

namespace session {
/// One that is active now.
struct AlarmNow {
    QString key;          ///< "overload"; "bit-4" where the map has no name for it
    int bit = -1;         ///< of Servo::status; -1: none
    bool derived = false; ///< worked out from measurements and limits, not reported
    bool operator==(const AlarmNow&) const = default;
};
/// Reported bits, or what device::derivedAlarms works out ("temperature", "voltage").
std::vector<AlarmNow> alarmsNow(const device::Servo& servo);

struct Alarm {
    AlarmNow what;
    bool active = false;
    QDateTime firstSeen;
    base::Duration firstAt{}; ///< desk clock
    base::Duration latestAt{};
    int times = 0; ///< how often it came
    bool acknowledged = false;
};

class AlarmLatch {
public:
    struct Change {
        AlarmNow what;
        bool came = false; ///< else it went
    };
    std::vector<Change> update(const std::vector<AlarmNow>& now, base::Duration at);
    /// Those that are over go at once, the others as soon as they are.
    void acknowledge();
    const std::vector<Alarm>& alarms() const { return m_alarms; } ///< oldest first
    bool anyActive() const;

private:
    std::vector<Alarm> m_alarms;
};
} // namespace session

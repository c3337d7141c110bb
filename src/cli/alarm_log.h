// SPDX-License-Identifier: GPL-3.0-or-later
// Records in the history which alarms come and go while servos are watched, at most once a second
// for each servo, as the window does. Servos that report no alarms are left out. Main thread. A
// history that cannot be written is reported once on stderr, and the watch goes on.
#pragma once

#include "cli/output/console.h"
#include "session/history/reported_alarms.h"

#include <map>

namespace cli {
class AlarmLog {
public:
    AlarmLog(Console& console, const std::vector<device::Servo>& servos);

    /// The status of a reply, and its time (UTC).
    void addStatus(int id, std::uint8_t status, const QDateTime& at);
    /// Writes what has not been written yet.
    void finish();

private:
    struct WatchedServo {
        device::Servo servo;
        session::AlarmLatch latch{};
        session::ReportedAlarms reported{};
        QDateTime at{}; ///< of the latest reply
        QDateTime writtenAt{};
    };
    void write(WatchedServo& servo);

    Console& m_console;
    std::map<int, WatchedServo> m_servos;
    bool m_failed = false;
};
} // namespace cli

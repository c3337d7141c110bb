// SPDX-License-Identifier: GPL-3.0-or-later
// Writes down in the history which alarms came and went while servos are watched, at most once a
// second for each servo: one that flickers costs no more than that, and none is missed. Servos that
// report no alarms are left out. Main thread. That the history cannot be written is said once on
// stderr and ends nothing.
#pragma once

#include "cli/output/console.h"
#include "device/servo.h"

#include <QDateTime>

#include <map>

namespace cli {
class AlarmLog {
public:
    AlarmLog(Console& console, const std::vector<device::Servo>& servos);

    /// What the servo said in an answer, and when (UTC).
    void addStatus(int id, std::uint8_t status, const QDateTime& at);
    /// Writes down what has not been yet.
    void finish();

private:
    struct WatchedServo {
        base::ServoIdentity identity;
        catalog::ProfilePtr profile;
        std::optional<std::uint8_t> status{};
        QStringList now{};      ///< reported in the latest answer
        QStringList recorded{}; ///< active as the history has it
        /// Not yet written down: all that came since, and when.
        std::map<QString, QDateTime> raised{};
        QDateTime at{};    ///< of the latest answer
        QDateTime wrote{}; ///< when last written down
    };
    void write(WatchedServo& servo);

    Console& m_console;
    std::map<int, WatchedServo> m_servos;
    bool m_failed = false;
};
} // namespace cli

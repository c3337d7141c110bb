// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of one servo as the history has them, and what must be added to it: the start and the
// end of each. For the window and for the watch of the command line. A value.
#pragma once

#include "history/history_log.h"
#include "session/polling/alarm_latch.h"

#include <map>

namespace session {
struct AlarmChange {
    QString key;
    bool derived = false;
    bool raised = false; ///< otherwise it ended
    QDateTime at{};      ///< UTC
};
/// An alarm that the history has as active is not raised again.
base::Result<void> recordAlarm(const history::HistoryLog& log, const base::ServoIdentity& identity,
                               const AlarmChange& change);

class ReportedAlarms {
public:
    /// What has changed since the call before, in order. The latch keeps an alarm until it is
    /// acknowledged, so that one of a tenth of a second is not missed; one that flickers costs one
    /// start and one end per call.
    std::vector<AlarmChange> update(const std::vector<Alarm>& alarms, const QDateTime& now);

private:
    struct Reported {
        int count = 0; ///< of Alarm
        bool active = false;
    };
    std::map<QString, Reported> m_reported;
};
} // namespace session

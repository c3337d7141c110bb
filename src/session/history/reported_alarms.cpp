// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/reported_alarms.h"

#include <algorithm>

namespace session {
base::Result<void> recordAlarm(const history::HistoryLog& log, const base::ServoIdentity& identity,
                               const AlarmChange& change)
{
    return change.raised ? log.recordAlarmStart(identity, change.key, change.derived, change.at)
                         : log.recordAlarmEnd(identity, change.key, change.at);
}

std::vector<AlarmChange> ReportedAlarms::update(const std::vector<Alarm>& alarms,
                                                const QDateTime& now)
{
    std::vector<AlarmChange> changes;
    for (const Alarm& alarm : alarms) {
        const auto& [key, bit, derived] = alarm.what;
        Reported& known = m_reported[key];
        if (alarm.count != known.count) {
            const QDateTime at = (known.count == 0 ? alarm.firstSeen : alarm.latestSeen).toUTC();
            if (known.active) // it ended in between
                changes.push_back({key, derived, false, at});
            changes.push_back({key, derived, true, at});
            known.active = true;
        }
        if (known.active && !alarm.active)
            changes.push_back({key, derived, false, now});
        known = {alarm.count, alarm.active};
    }
    std::erase_if(m_reported, [&](const auto& reported) {
        const bool isListed = std::any_of(alarms.begin(), alarms.end(), [&](const Alarm& alarm) {
            return alarm.what.key == reported.first;
        });
        if (!isListed && reported.second.active) // acknowledged and over since the call before
            changes.push_back({reported.first, false, false, now});
        return !isListed;
    });
    return changes;
}
} // namespace session

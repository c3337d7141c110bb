// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/polling/alarm_latch.h"

#include "device/alarms.h"

#include <algorithm>

namespace session {
namespace {
QString bitName(const device::Servo& servo, int bit)
{
    const catalog::Register* status =
        servo.profile ? servo.profile->byRole(catalog::Role::Status) : nullptr;
    if (status != nullptr) {
        for (const catalog::NamedValue& value : status->values) {
            if (value.value == bit)
                return value.key;
        }
    }
    return QStringLiteral("bit%1").arg(bit);
}
} // namespace

std::vector<ActiveAlarm> activeAlarms(const device::Servo& servo)
{
    std::vector<ActiveAlarm> alarms;
    for (int bit = 0; bit < 8; ++bit) {
        if ((servo.status >> bit & 1) != 0)
            alarms.push_back({bitName(servo, bit), bit, false});
    }
    for (const device::Notice& alarm : device::derivedAlarms(servo)) {
        const bool hot = alarm.code == device::NoticeCode::DerivedTemperature;
        alarms.push_back(
            {hot ? QStringLiteral("temperature") : QStringLiteral("voltage"), -1, true});
    }
    return alarms;
}

std::vector<AlarmLatch::Change> AlarmLatch::update(const std::vector<ActiveAlarm>& now,
                                                   base::Duration at, const QDateTime& seen)
{
    std::vector<Change> changes;
    for (Alarm& alarm : m_alarms) {
        const bool still = std::find(now.begin(), now.end(), alarm.what) != now.end();
        if (alarm.active && !still)
            changes.push_back({alarm.what, false});
        if (!alarm.active && still) {
            changes.push_back({alarm.what, true});
            ++alarm.count;
            alarm.latestAt = at;
            alarm.latestSeen = seen;
        }
        alarm.active = still;
    }
    for (const ActiveAlarm& one : now) {
        const bool known = std::any_of(m_alarms.begin(), m_alarms.end(),
                                       [&](const Alarm& alarm) { return alarm.what == one; });
        if (known)
            continue;
        m_alarms.push_back({one, true, seen, seen, at, at, 1});
        changes.push_back({one, true});
    }
    std::erase_if(m_alarms, [](const Alarm& alarm) { return alarm.acknowledged && !alarm.active; });
    return changes;
}

void AlarmLatch::acknowledge()
{
    std::erase_if(m_alarms, [](const Alarm& alarm) { return !alarm.active; });
    for (Alarm& alarm : m_alarms)
        alarm.acknowledged = true;
}

bool AlarmLatch::hasActive() const
{
    return std::any_of(m_alarms.begin(), m_alarms.end(),
                       [](const Alarm& alarm) { return alarm.active; });
}
} // namespace session

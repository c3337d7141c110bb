// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/alarms.h"

#include "device/reader.h"

#include <algorithm>

namespace device {
using catalog::Role;

namespace {
struct AlarmNotice {
    QLatin1StringView bit;
    NoticeCode code;
};

// Protocol sheet §7: how each protection is released.
constexpr std::array alarmNotices{
    AlarmNotice{QLatin1StringView("overload"), NoticeCode::OverloadActive},
    AlarmNotice{QLatin1StringView("current"), NoticeCode::OvercurrentActive},
    AlarmNotice{QLatin1StringView("voltage"), NoticeCode::VoltageAlarmActive},
    AlarmNotice{QLatin1StringView("temperature"), NoticeCode::TemperatureAlarmActive},
    AlarmNotice{QLatin1StringView("sensor"), NoticeCode::SensorAlarmActive},
};

const AlarmNotice* alarmNoticeOf(const catalog::NamedValue& bit)
{
    const auto found =
        std::find_if(alarmNotices.begin(), alarmNotices.end(),
                     [&](const AlarmNotice& notice) { return bit.key == notice.bit; });
    return found == alarmNotices.end() ? nullptr : &*found;
}

/// Named bits that are no fault describe a state, not an alarm.
std::uint8_t faultBits(std::int64_t raw, const catalog::Register& status)
{
    auto faults = static_cast<std::uint8_t>(raw & 0xFF);
    for (const catalog::NamedValue& bit : status.values) {
        if (bit.value < 8 && alarmNoticeOf(bit) == nullptr)
            faults = static_cast<std::uint8_t>(faults & ~(1U << bit.value));
    }
    return faults;
}

bool reportsFaults(const Servo& servo)
{
    return servo.repliesCarryStatus() || servo.profile->byRole(Role::Status) != nullptr;
}
} // namespace

bool hasFault(const Servo& servo, const QStringList& faults)
{
    const catalog::Register* status = servo.profile ? servo.profile->byRole(Role::Status) : nullptr;
    return status != nullptr && std::any_of(status->values.begin(), status->values.end(),
                                            [&](const catalog::NamedValue& bit) {
                                                return bit.value < 8 && faults.contains(bit.key) &&
                                                       (servo.status >> bit.value & 1) != 0;
                                            });
}

void updateStatus(Servo& servo, int offset, int count)
{
    const catalog::Register* status = servo.profile && !servo.repliesCarryStatus()
                                          ? servo.profile->byRole(Role::Status)
                                          : nullptr;
    if (status == nullptr || status->offset < offset ||
        status->offset + status->size > offset + count)
        return;
    servo.status = faultBits(servo.raw(*status).value_or(0), *status);
}

std::vector<Notice> derivedAlarms(const Servo& servo)
{
    std::vector<Notice> alarms;
    if (!servo.profile || reportsFaults(servo))
        return alarms;
    const auto add = [&](NoticeCode code, Role measured, std::int64_t value, std::int64_t limit) {
        alarms.push_back({code, servo.id, servo.profile->byRole(measured)->key, value, limit});
    };
    const auto celsius = servo.raw(Role::PresentTemperature);
    const auto maxTemperature = servo.raw(Role::MaxTemperature);
    if (celsius && maxTemperature && *celsius > *maxTemperature)
        add(NoticeCode::DerivedTemperature, Role::PresentTemperature, *celsius, *maxTemperature);
    const auto volts = servo.raw(Role::PresentVoltage);
    const auto min = servo.raw(Role::MinVoltage);
    const auto max = servo.raw(Role::MaxVoltage);
    if (volts && min && *volts < *min)
        add(NoticeCode::DerivedVoltage, Role::PresentVoltage, *volts, *min);
    else if (volts && max && *volts > *max)
        add(NoticeCode::DerivedVoltage, Role::PresentVoltage, *volts, *max);
    return alarms;
}

namespace {
/// Registers that are not part of every reply. Limits are read once: they do not change by
/// themselves.
base::Result<void> readAlarmRegisters(const Context& context, Servo& servo)
{
    if (servo.repliesCarryStatus())
        return {};
    std::vector<Role> roles{Role::Status};
    if (!reportsFaults(servo)) {
        roles = {Role::PresentTemperature, Role::PresentVoltage};
        for (const Role limit : {Role::MaxTemperature, Role::MinVoltage, Role::MaxVoltage}) {
            if (!servo.raw(limit))
                roles.push_back(limit);
        }
    }
    return readRoles(context, servo, roles);
}
} // namespace

void addAlarmNotices(const Context& context, Servo& servo)
{
    // An old reading is no present alarm.
    if (!readAlarmRegisters(context, servo))
        return;
    for (const Notice& alarm : derivedAlarms(servo))
        context.notices.push_back(alarm);
    const catalog::Register* status = servo.profile->byRole(Role::Status);
    if (status == nullptr)
        return;
    for (const catalog::NamedValue& bit : status->values) {
        const AlarmNotice* notice = alarmNoticeOf(bit);
        if (notice != nullptr && (servo.status >> bit.value & 1) != 0)
            context.note(notice->code, servo.id, bit.key);
    }
}
} // namespace device

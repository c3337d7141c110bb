// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/alarms.h"

#include "device/reader.h"

#include <algorithm>

namespace device {
using catalog::Role;

namespace {
struct Release {
    QLatin1StringView bit;
    NoticeCode code;
};

// Protocol sheet §7: how each protection lets go.
constexpr std::array releases{
    Release{QLatin1StringView("overload"), NoticeCode::OverloadHolds},
    Release{QLatin1StringView("current"), NoticeCode::OvercurrentHolds},
    Release{QLatin1StringView("voltage"), NoticeCode::VoltageHolds},
    Release{QLatin1StringView("temperature"), NoticeCode::TemperatureHolds},
    Release{QLatin1StringView("sensor"), NoticeCode::SensorHolds},
};

const Release* releaseOf(const catalog::NamedValue& bit)
{
    const auto found = std::find_if(releases.begin(), releases.end(),
                                    [&](const Release& release) { return bit.key == release.bit; });
    return found == releases.end() ? nullptr : &*found;
}

/// Bits with a name that is no fault's say how the servo is, not what ails it.
std::uint8_t faultsIn(std::int64_t raw, const catalog::Register& status)
{
    auto faults = static_cast<std::uint8_t>(raw & 0xFF);
    for (const catalog::NamedValue& bit : status.values) {
        if (bit.value < 8 && releaseOf(bit) == nullptr)
            faults = static_cast<std::uint8_t>(faults & ~(1U << bit.value));
    }
    return faults;
}

bool reportsFaults(const Servo& servo)
{
    return servo.repliesCarryStatus() || servo.profile->byRole(Role::Status) != nullptr;
}
} // namespace

bool reports(const Servo& servo, const QStringList& faults)
{
    const catalog::Register* status = servo.profile ? servo.profile->byRole(Role::Status) : nullptr;
    return status != nullptr && std::any_of(status->values.begin(), status->values.end(),
                                            [&](const catalog::NamedValue& bit) {
                                                return bit.value < 8 && faults.contains(bit.key) &&
                                                       (servo.status >> bit.value & 1) != 0;
                                            });
}

void takeStatus(Servo& servo, int offset, int count)
{
    const catalog::Register* status = servo.profile && !servo.repliesCarryStatus()
                                          ? servo.profile->byRole(Role::Status)
                                          : nullptr;
    if (status == nullptr || status->offset < offset ||
        status->offset + status->size > offset + count)
        return;
    servo.status = faultsIn(servo.raw(*status).value_or(0), *status);
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
    const auto hottest = servo.raw(Role::MaxTemperature);
    if (celsius && hottest && *celsius > *hottest)
        add(NoticeCode::DerivedTemperature, Role::PresentTemperature, *celsius, *hottest);
    const auto volts = servo.raw(Role::PresentVoltage);
    const auto least = servo.raw(Role::MinVoltage);
    const auto most = servo.raw(Role::MaxVoltage);
    if (volts && least && *volts < *least)
        add(NoticeCode::DerivedVoltage, Role::PresentVoltage, *volts, *least);
    else if (volts && most && *volts > *most)
        add(NoticeCode::DerivedVoltage, Role::PresentVoltage, *volts, *most);
    return alarms;
}

namespace {
/// What is not told with every reply; limits are read once, they do not change by themselves.
base::Result<void> readEvidence(const Context& context, Servo& servo)
{
    if (servo.repliesCarryStatus())
        return {};
    std::vector<Role> wanted{Role::Status};
    if (!reportsFaults(servo)) {
        wanted = {Role::PresentTemperature, Role::PresentVoltage};
        for (const Role limit : {Role::MaxTemperature, Role::MinVoltage, Role::MaxVoltage}) {
            if (!servo.raw(limit))
                wanted.push_back(limit);
        }
    }
    return readRoles(context, servo, wanted);
}
} // namespace

void noteAlarms(const Context& context, Servo& servo)
{
    // What was read long ago is no alarm of now.
    if (!readEvidence(context, servo))
        return;
    for (const Notice& alarm : derivedAlarms(servo))
        context.notices.push_back(alarm);
    const catalog::Register* status = servo.profile->byRole(Role::Status);
    if (status == nullptr)
        return;
    for (const catalog::NamedValue& bit : status->values) {
        const Release* release = releaseOf(bit);
        if (release != nullptr && (servo.status >> bit.value & 1) != 0)
            context.note(release->code, servo.id, bit.key);
    }
}
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/motion.h"

namespace device {
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
} // namespace

void noteAlarms(const Context& context, const Servo& servo)
{
    const catalog::Register* status = servo.profile->byRole(catalog::Role::Status);
    if (status == nullptr)
        return;
    for (const catalog::NamedValue& bit : status->values) {
        if ((servo.status >> bit.value & 1) == 0)
            continue;
        for (const Release& release : releases) {
            if (bit.key == release.bit)
                context.note(release.code, servo.id, bit.key);
        }
    }
}
} // namespace device

// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/arm/lerobot_settings.h"

#include "jobs/arm/calibration.h"

namespace jobs {
using base::JointKind;
using catalog::Role;

JointSettings lerobotSettings(const device::Servo& servo, JointKind kind, bool isLeader)
{
    const catalog::Profile& profile = *servo.profile;
    if (profile.mapKey != QLatin1String("sts-sms"))
        return {};
    JointSettings settings = positionSettings(servo, kind);
    const auto add = [&](Role role, std::int64_t raw) {
        addSetting(settings, profile.byRole(role), raw);
    };
    addSetting(settings, profile.find(returnDelayKey), 0);
    const catalog::Mode* speed = profile.mode(QStringLiteral("speed"));
    if (kind == JointKind::Wheel && speed != nullptr && speed->operatingMode)
        add(Role::OperatingMode, *speed->operatingMode);
    if (isLeader)
        return settings;
    if (kind != JointKind::Wheel) {
        add(Role::PositionP, 16);
        add(Role::PositionD, 32);
        add(Role::PositionI, 0);
    }
    if (kind == JointKind::Gripper) {
        add(Role::MaxTorque, 500);
        add(Role::ProtectionCurrent, 250);
        add(Role::OverloadTorque, 25);
    }
    return settings;
}
} // namespace jobs

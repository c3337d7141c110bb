// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_traits.h"

#include <QHash>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
using catalog::Role;

PhaseMasks phaseMasks(const catalog::Profile& profile)
{
    PhaseMasks masks;
    const catalog::Register* phase = profile.byRole(Role::Phase);
    if (phase == nullptr) {
        return masks;
    }
    const QHash<QString, int*> known{
        {QStringLiteral("drive_direction"), &masks.driveDirection},
        {QStringLiteral("zero_is_maximum"), &masks.zeroIsMaximum},
        {QStringLiteral("full_angle"), &masks.fullAngle},
        {QStringLiteral("integrated_bridge"), &masks.integratedBridge},
        {QStringLiteral("feedback_direction"), &masks.feedbackDirection},
        {QStringLiteral("torque_by_command"), &masks.torqueByCommand},
        {QStringLiteral("manual_reset"), &masks.manualReset},
    };
    for (const catalog::NamedValue& bit : phase->values) {
        if (int* mask = known.value(bit.key)) {
            *mask = 1 << bit.value;
        }
    }
    if (profile.currentSensing == catalog::CurrentSensing::Yes) {
        masks.integratedBridge = 0;
    }
    return masks;
}

DriveMode driveModeOf(const QString& modeKey)
{
    static const QHash<QString, DriveMode> drives{
        {QStringLiteral("position-pd"), DriveMode::Direct},
        {QStringLiteral("speed"), DriveMode::Speed},
        {QStringLiteral("current"), DriveMode::Current},
        {QStringLiteral("pwm"), DriveMode::Pwm},
        {QStringLiteral("motor"), DriveMode::Pwm},
        {QStringLiteral("step"), DriveMode::Step},
    };
    return drives.value(modeKey, DriveMode::Position);
}

std::vector<ModeRule> modesOf(const catalog::Profile& profile)
{
    std::vector<ModeRule> rules;
    for (const catalog::Mode& mode : profile.modes) {
        rules.push_back({mode.operatingMode, mode.limitsZero, driveModeOf(mode.key), mode.command,
                         mode.key == QLatin1String("release")});
    }
    if (rules.empty()) {
        rules.emplace_back();
    }
    return rules;
}

/// As the position register states it; otherwise the typical range of a potentiometer.
double degreesPerStep(const catalog::Profile& profile)
{
    const catalog::Register* position = profile.byRole(Role::PresentPosition);
    if (position != nullptr && position->unit == QLatin1String("deg")) {
        return position->scale;
    }
    return profile.angleRangeDeg.value_or(300.0) / profile.stepsPerTurn;
}

Sensor sensorOf(const catalog::Profile& profile)
{
    if (profile.protocol == base::Protocol::Lx) {
        return Sensor::OneTurn;
    }
    return profile.stepsPerTurn < 4096 ? Sensor::Potentiometer : Sensor::Continuous;
}
} // namespace

const ModeRule& ServoTraits::modeOf(int value, bool limitsZero) const
{
    const auto chosen = [value](const ModeRule& rule) {
        return rule.value.value_or(value) == value;
    };
    const auto exact = std::find_if(modes.begin(), modes.end(), [&](const ModeRule& rule) {
        return chosen(rule) && rule.limitsZero == limitsZero;
    });
    if (exact != modes.end()) {
        return *exact;
    }
    const auto near = std::find_if(modes.begin(), modes.end(), chosen);
    return near == modes.end() ? modes.front() : *near;
}

ServoTraits traitsOf(const catalog::Profile& profile)
{
    ServoTraits traits;
    traits.sensor = sensorOf(profile);
    const double step = degreesPerStep(profile);
    traits.stepsPerRadian = 180.0 / (step * std::numbers::pi);
    traits.turnSteps = int(std::lround(360.0 / step));
    if (const catalog::Register* volts = profile.byRole(Role::PresentVoltage)) {
        traits.rawPerVolt = 1.0 / volts->scale;
    }
    traits.phase = phaseMasks(profile);
    traits.modes = modesOf(profile);
    traits.liveGains = profile.find(QStringLiteral("kp")) != nullptr;
    traits.currentLimited = profile.byRole(Role::GoalCurrent) != nullptr;
    traits.zeroSpeedStops = traits.currentLimited;
    traits.lx = profile.protocol == base::Protocol::Lx;
    traits.modbus = profile.protocol == base::Protocol::Modbus;
    return traits;
}
} // namespace sim

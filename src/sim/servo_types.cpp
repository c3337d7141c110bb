// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo_types.h"

#include <cmath>
#include <numbers>

namespace sim {
namespace {
constexpr double radPerSecondPerRpm = 2.0 * std::numbers::pi / 60.0;
constexpr double newtonMetresPerKgCm = 0.0980665;

/// Data-sheet figures of models a bench is likely to see.
struct Known {
    const char* model;
    double volts;
    double stallKgCm;
    double noLoadRpm;
    double stallAmps;
    double noLoadAmps;
};
constexpr Known knownTypes[] = {
    {"STS3215", 7.4, 19.5, 55.0, 2.4, 0.15},   {"STS3250", 12.0, 50.0, 75.0, 4.6, 0.25},
    {"STS3032", 6.0, 4.5, 110.0, 1.2, 0.12},   {"SM40BLHV", 12.0, 40.0, 65.0, 3.8, 0.25},
    {"SM45BLHV", 24.0, 45.0, 60.0, 2.2, 0.15}, {"SCS15", 6.0, 15.0, 62.0, 1.6, 0.13},
    {"SCS0009", 6.0, 2.3, 100.0, 0.8, 0.08},   {"SCS215", 6.0, 15.0, 60.0, 1.8, 0.13},
};

double nominalVolts(const catalog::Profile& profile)
{
    const double top = profile.maxVoltage.value_or(isSms(profile) ? 12.6 : 7.4);
    if (top > 16.0) {
        return 24.0;
    }
    if (top > 9.0) {
        return 12.0;
    }
    return top < 6.5 ? 6.0 : 7.4;
}

int maxVoltageRaw(double nominal, const catalog::Profile& profile)
{
    if (nominal > 16.0) {
        return 254;
    }
    if (nominal > 9.0) {
        return 140;
    }
    return profile.maxVoltage.value_or(7.4) > 8.0 ? 90 : 80;
}

ServoType seriesType(const catalog::Profile& profile)
{
    ServoType type;
    if (isScs(profile)) {
        type.stallTorque = 15.0 * newtonMetresPerKgCm;
        type.noLoadRpm = 60.0;
        type.stallAmps = 1.6;
        type.noLoadAmps = 0.13;
        type.phase = 8;
        type.positionD = 0;
        type.unloadCondition = 37;
        type.ledCondition = 37;
        type.minVoltageRaw = 25;
        type.currentSensing = profile.modelName == QLatin1String("SCS40");
    } else if (isSms(profile)) {
        type.stallTorque = 40.0 * newtonMetresPerKgCm;
        type.noLoadRpm = 65.0;
        type.stallAmps = 3.8;
        type.noLoadAmps = 0.25;
        type.phase = 44;
        type.minVoltageRaw = 70;
    }
    type.nominalVolts = nominalVolts(profile);
    return type;
}
} // namespace

double ServoType::noLoadSpeed() const
{
    return noLoadRpm * radPerSecondPerRpm;
}

ServoType servoType(const catalog::Profile& profile)
{
    ServoType type = seriesType(profile);
    for (const Known& known : knownTypes) {
        if (profile.modelName.compare(QLatin1String(known.model), Qt::CaseInsensitive) == 0) {
            type.nominalVolts = known.volts;
            type.stallTorque = known.stallKgCm * newtonMetresPerKgCm;
            type.noLoadRpm = known.noLoadRpm;
            type.stallAmps = known.stallAmps;
            type.noLoadAmps = known.noLoadAmps;
        }
    }
    type.maxVoltageRaw = maxVoltageRaw(type.nominalVolts, profile);
    // A small case sheds less heat: scale with the copper loss it was built for.
    const double stallWatts = type.nominalVolts * type.stallAmps;
    type.thermalResistance = 14.0 * std::sqrt(18.0 / stallWatts);
    return type;
}

Drive driveOf(const ServoType& type)
{
    // Half of the no-load loss is friction that does not depend on speed, half grows with it.
    Drive drive;
    const double speed = type.noLoadSpeed();
    drive.resistance = type.nominalVolts / type.stallAmps;
    drive.torqueConstant = type.stallTorque / (type.stallAmps - 0.5 * type.noLoadAmps);
    const double loss = drive.torqueConstant * type.noLoadAmps;
    drive.emfConstant = (type.nominalVolts - type.noLoadAmps * drive.resistance) / speed;
    drive.coulomb = 0.45 * loss;
    drive.shaftFriction = 0.05 * loss;
    drive.stiction = 1.3 * drive.coulomb;
    drive.viscous = 0.5 * loss / speed;
    drive.inertia = type.mechanicalTime * type.stallTorque / speed;
    drive.shaftInertia = 0.01 * drive.inertia;
    drive.idleAmps = 0.02;
    return drive;
}

int maximumSpeed(const ServoType& type, const catalog::Profile& profile)
{
    return int(0.78 * type.noLoadSpeed() * stepsPerRadian(profile) / 50.0) * 50;
}

double stepsPerRadian(const catalog::Profile& profile)
{
    const double degrees = isScs(profile) ? profile.angleRangeDeg.value_or(300.0) : 360.0;
    return profile.stepsPerTurn * 180.0 / (degrees * std::numbers::pi);
}

bool isScs(const catalog::Profile& profile)
{
    return profile.series == QLatin1String("SCS");
}

bool isSms(const catalog::Profile& profile)
{
    return profile.series == QLatin1String("SMS");
}
} // namespace sim

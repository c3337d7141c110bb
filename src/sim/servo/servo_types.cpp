// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_types.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
constexpr double radPerSecondPerRpm = 2.0 * std::numbers::pi / 60.0;
constexpr double newtonMetersPerKgCm = 0.0980665;

/// Data-sheet figures of models a bench is likely to see. Currents of LX servos are typical values
/// for their size.
struct KnownModel {
    const char* model;
    double volts;
    double stallKgCm;
    double noLoadRpm;
    double stallAmps;
    double noLoadAmps;
};
constexpr KnownModel knownTypes[] = {
    {"STS3215", 7.4, 19.5, 55.0, 2.4, 0.15},   {"STS3250", 12.0, 50.0, 75.0, 4.6, 0.25},
    {"STS3032", 6.0, 4.5, 110.0, 1.2, 0.12},   {"SM40BLHV", 12.0, 40.0, 65.0, 3.8, 0.25},
    {"SM45BLHV", 24.0, 45.0, 60.0, 2.2, 0.15}, {"SCS15", 6.0, 15.0, 62.0, 1.6, 0.13},
    {"SCS0009", 6.0, 2.3, 100.0, 0.8, 0.08},   {"SCS215", 6.0, 15.0, 60.0, 1.8, 0.13},
    {"LX-16A", 7.4, 17.0, 62.0, 2.4, 0.10},    {"LX-224", 7.4, 20.0, 55.0, 2.8, 0.12},
    {"LX-224HV", 11.1, 20.0, 53.0, 1.9, 0.10}, {"LX-824HV", 11.1, 17.0, 55.0, 1.7, 0.10},
    {"HTS-35H", 11.1, 35.0, 55.0, 2.9, 0.15},
};

/// Typical data of a series, and the factory values that its sheet leaves open: reported of one of
/// its servos, or typical. For SMCL and SCS2 no bit of the phase is known, for Modbus no factory
/// value at all.
struct SeriesData {
    const char* key;
    double stallTorque; ///< N·m
    double noLoadRpm;
    double stallAmps;
    double noLoadAmps;
    double minVoltage;
    int phase;
    int positionP;
    int positionD;
    int unloadCondition;
    int ledCondition;
    int startupForce; ///< enough for a servo without I to overcome its friction
};
constexpr SeriesData seriesData[] = {
    {"STS", 1.91, 55.0, 2.4, 0.15, 4.0, 12, 32, 32, 44, 45, 0},
    {"SCS", 15.0 * newtonMetersPerKgCm, 60.0, 1.6, 0.13, 2.5, 8, 32, 0, 37, 37, 50},
    {"SCS2", 15.0 * newtonMetersPerKgCm, 60.0, 1.6, 0.13, 4.0, 0, 32, 0, 37, 37, 0},
    {"SMS", 40.0 * newtonMetersPerKgCm, 65.0, 3.8, 0.25, 7.0, 44, 32, 32, 44, 45, 0},
    {"SMCL", 60.0 * newtonMetersPerKgCm, 45.0, 4.0, 0.25, 8.0, 0, 32, 0, 37, 37, 0},
    {"SMSMB", 40.0 * newtonMetersPerKgCm, 65.0, 3.8, 0.25, 7.0, 0, 32, 32, 47, 47, 0},
    {"HLS", 25.0 * newtonMetersPerKgCm, 60.0, 3.0, 0.18, 4.0, 0, 32, 40, 13, 13, 0},
    {"LX", 17.0 * newtonMetersPerKgCm, 60.0, 2.4, 0.12, 4.5, 0, 60, 8, 0, 7, 0},
};

/// LX servos of the 11.1 V class are known by their names only.
bool hasHighVoltageName(const catalog::Profile& profile)
{
    const QString& name = profile.modelName;
    return profile.protocol == base::Protocol::Lx &&
           (name.endsWith(QLatin1Char('H')) || name.endsWith(QLatin1String("HV")));
}

double nominalVolts(const catalog::Profile& profile)
{
    const bool high = profile.line == catalog::Line::Rs485 || hasHighVoltageName(profile);
    const double top = profile.maxVoltage.value_or(high ? 12.6 : 7.4);
    if (top > 16.0) {
        return 24.0;
    }
    if (top > 9.0) {
        return 12.0;
    }
    return top < 6.5 ? 6.0 : 7.4;
}

double maxSupplyVoltage(double nominal, const catalog::Profile& profile)
{
    if (nominal > 16.0) {
        return 25.4;
    }
    if (nominal > 9.0) {
        return 14.0;
    }
    return profile.maxVoltage.value_or(7.4) > 8.0 ? 9.0 : 8.0;
}

/// The sheet states it, or the table has a register for it.
bool sensesCurrent(const catalog::Profile& profile)
{
    return profile.currentSensing != catalog::CurrentSensing::No &&
           profile.byRole(catalog::Role::PresentCurrent) != nullptr;
}

ServoType seriesType(const catalog::Profile& profile)
{
    ServoType type;
    for (const SeriesData& series : seriesData) {
        if (profile.series == QLatin1String(series.key)) {
            type.stallTorque = series.stallTorque;
            type.noLoadRpm = series.noLoadRpm;
            type.stallAmps = series.stallAmps;
            type.noLoadAmps = series.noLoadAmps;
            type.minVoltage = series.minVoltage;
            type.phase = series.phase;
            type.positionP = series.positionP;
            type.positionD = series.positionD;
            type.unloadCondition = series.unloadCondition;
            type.startupForce = series.startupForce;
            type.ledCondition = series.ledCondition;
        }
    }
    type.nominalVolts = nominalVolts(profile);
    type.currentSensing = sensesCurrent(profile);
    if (const catalog::Register* limit = profile.byRole(catalog::Role::ProtectionCurrent)) {
        type.maxCurrent = int(limit->max.value_or(type.maxCurrent));
    }
    if (const catalog::Register* moving = profile.byRole(catalog::Role::Moving)) {
        type.movingBits = moving->encoding == catalog::Encoding::Bits;
    }
    // Bench notes on the HD-1910: it leaves the factory in mode 4.
    type.mode = profile.modelName == QLatin1String("HD-1910") ? 4 : 0;
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
    for (const KnownModel& known : knownTypes) {
        if (profile.modelName.compare(QLatin1String(known.model), Qt::CaseInsensitive) == 0) {
            type.nominalVolts = known.volts;
            type.stallTorque = known.stallKgCm * newtonMetersPerKgCm;
            type.noLoadRpm = known.noLoadRpm;
            type.stallAmps = known.stallAmps;
            type.noLoadAmps = known.noLoadAmps;
        }
    }
    type.maxVoltage = maxSupplyVoltage(type.nominalVolts, profile);
    // A small case gives off less heat: scale with its rated copper loss.
    const double stallWatts = type.nominalVolts * type.stallAmps;
    type.thermalResistance = 14.0 * std::sqrt(18.0 / stallWatts);
    return type;
}

MotorModel motorModelOf(const ServoType& type)
{
    // Half of the no-load loss is friction that does not depend on speed, half grows with it.
    MotorModel model;
    const double speed = type.noLoadSpeed();
    model.resistance = type.nominalVolts / type.stallAmps;
    model.torqueConstant = type.stallTorque / (type.stallAmps - 0.5 * type.noLoadAmps);
    const double loss = model.torqueConstant * type.noLoadAmps;
    model.emfConstant = (type.nominalVolts - type.noLoadAmps * model.resistance) / speed;
    model.coulomb = 0.45 * loss;
    model.shaftFriction = 0.05 * loss;
    model.stiction = 1.3 * model.coulomb;
    model.viscous = 0.5 * loss / speed;
    model.inertia = type.mechanicalTime * type.stallTorque / speed;
    model.shaftInertia = 0.01 * model.inertia;
    model.idleAmps = 0.02;
    return model;
}

int maximumSpeed(const ServoType& type, const ServoTraits& traits)
{
    return int(0.78 * type.noLoadSpeed() * traits.stepsPerRadian / 50.0) * 50;
}
} // namespace sim

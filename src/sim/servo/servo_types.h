// SPDX-License-Identifier: GPL-3.0-or-later
// The physical data of a kind of servo: motor and gear at the output shaft, heat, and the factory
// values that its register sheet leaves open. Pure values; any thread. The numbers are those of the
// makers' data sheets where they exist, of the series otherwise; no test depends on one of them.
#pragma once

#include "sim/servo/servo_traits.h"

namespace sim {
/// Data-sheet figures, at nominal volts and seen at the output shaft.
struct ServoType {
    double nominalVolts = 7.4;
    double stallTorque = 1.91; ///< N·m
    double noLoadRpm = 55.0;
    double stallAmps = 2.4;
    double noLoadAmps = 0.15;
    double mechanicalTime = 0.020;   ///< s, run-up time constant of motor and gear
    double thermalResistance = 14.0; ///< K/W, winding to air
    double thermalTime = 240.0;      ///< s
    bool currentSensing = true;
    int maxCurrent = 511;    ///< what its current register can show
    bool movingBits = false; ///< the moving register has two flags
    double maxVoltage = 8.0; ///< limits it leaves the factory with
    double minVoltage = 4.0;
    int phase = 12; ///< register 18: step/s, goal speed 0 = maximum
    int positionP = 32;
    int positionD = 32;
    int unloadCondition = 44;
    int startupForce = 0; ///< register value, where the sheet leaves it open
    int ledCondition = 45;
    int speedP = 10;
    int speedI = 200;
    int mode = 0; ///< operating mode

    double noLoadSpeed() const; ///< rad/s
};

ServoType servoType(const catalog::Profile& profile);

/// Everything about a servo that its register map decides.
struct ServoModel {
    explicit ServoModel(catalog::ProfilePtr servoProfile)
        : profile(std::move(servoProfile))
        , traits(traitsOf(*profile))
        , type(servoType(*profile))
    {}
    catalog::ProfilePtr profile;
    ServoTraits traits;
    ServoType type;
};

/// The electric motor and its gear, from the data-sheet figures.
struct MotorModel {
    double torqueConstant = 0; ///< N·m/A at the output
    double emfConstant = 0;    ///< V·s/rad at the output
    double resistance = 0;     ///< ohm
    double idleAmps = 0;       ///< electronics
    double inertia = 0;        ///< kg·m², motor and gear seen at the output
    double coulomb = 0;        ///< N·m, sliding
    double stiction = 0;       ///< N·m, from rest
    double viscous = 0;        ///< N·m·s/rad
    double shaftInertia = 0;   ///< kg·m², output shaft behind the play
    double shaftFriction = 0;  ///< N·m, its bearing
};

MotorModel motorModelOf(const ServoType& type);

/// Fastest goal speed the firmware accepts, step/s: what it can keep up at nominal volts with a
/// duty below the usual overload threshold.
int maximumSpeed(const ServoType& type, const ServoTraits& traits);
} // namespace sim

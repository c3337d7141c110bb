// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/mechanics.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
/// Semi-implicit: damping is taken at the end of the step, and dry friction may stop a body but
/// never reverse it.
double nextSpeed(double speed, double torque, double damping, double friction, double stiction,
                 double inertia, double seconds)
{
    const double gain = seconds / inertia;
    const double limit = gain * (speed == 0.0 ? stiction : friction);
    const double pushed = speed + gain * torque;
    if (std::abs(pushed) <= limit) {
        return 0.0;
    }
    return (pushed - std::copysign(limit, pushed)) / (1.0 + gain * damping);
}
} // namespace

Mechanics::Mechanics(const MotorModel& drive, double playRadians, double angle, double restAngle)
    : m_motorModel(drive)
    , m_initialHalfPlay(0.5 * playRadians)
    , m_halfPlay(m_initialHalfPlay)
    , m_restAngle(restAngle)
    , m_motor{angle, 0.0}
    , m_shaft{angle, 0.0}
    , m_supplyAmps(drive.idleAmps)
{}

double Mechanics::supplyVolts(const Environment& environment) const
{
    return std::max(0.0, environment.supplyVolts - environment.supplyOhms * m_supplyAmps);
}

double Mechanics::dutyFor(double amps, const Environment& environment) const
{
    const double volts = environment.supplyVolts - environment.supplyOhms * m_motorModel.idleAmps;
    if (volts <= 0.0) {
        return 0.0;
    }
    return std::clamp((amps * m_motorModel.resistance + m_motorModel.emfConstant * m_motor.speed) /
                          volts,
                      -1.0, 1.0);
}

double Mechanics::effortFor(double acceleration, double speed, double breakaway, const Load& load,
                            const Environment& environment) const
{
    const double volts = environment.supplyVolts - environment.supplyOhms * m_motorModel.idleAmps;
    if (volts <= 0.0) {
        return 0.0;
    }
    const Torques shaft = shaftTorques(load, 0.0);
    const double inertia =
        m_motorModel.inertia + m_motorModel.shaftInertia + std::max(0.0, load.inertia);
    const double amps = (inertia * acceleration + (m_motorModel.viscous + shaft.damping) * speed +
                         breakaway * (m_motorModel.stiction + shaft.stiction) - shaft.drive) /
                        m_motorModel.torqueConstant;
    const double needed = m_motorModel.emfConstant * speed + m_motorModel.resistance * amps;
    // The supply voltage sags under this current.
    const double first = std::clamp(needed / volts, -1.0, 1.0);
    return std::clamp((needed + environment.supplyOhms * first * first * amps) / volts, -1.0, 1.0);
}

double Mechanics::opposingTorque(double direction, const Load& load) const
{
    const Torques shaft = shaftTorques(load, 0.0);
    const double pull =
        direction == 0.0 ? 0.0 : -std::copysign(shaft.drive, shaft.drive * direction);
    return load.coulombFriction + load.viscousFriction * std::abs(m_shaft.speed) +
           std::max(0.0, pull);
}

/// The winding settles far faster than a step, so its current follows at once; the sag of the
/// supply under that current is solved in the same step: i = (d(U − R·I₀) − kω)/(R + r·d²).
Mechanics::Torques Mechanics::motorTorques(Bridge bridge, double effort,
                                           const Environment& environment) const
{
    Torques torques{0.0, m_motorModel.viscous, m_motorModel.coulomb, m_motorModel.stiction};
    if (bridge == Bridge::Driven) {
        const double resistance =
            m_motorModel.resistance + environment.supplyOhms * effort * effort;
        const double volts =
            environment.supplyVolts - environment.supplyOhms * m_motorModel.idleAmps;
        torques.drive = m_motorModel.torqueConstant * effort * volts / resistance;
        torques.damping += m_motorModel.torqueConstant * m_motorModel.emfConstant / resistance;
    } else if (bridge == Bridge::Shorted) {
        torques.damping += effort * m_motorModel.torqueConstant * m_motorModel.emfConstant /
                           m_motorModel.resistance;
    }
    return torques;
}

Mechanics::Torques Mechanics::shaftTorques(const Load& load, double seconds) const
{
    const double friction = m_motorModel.shaftFriction + load.coulombFriction;
    Torques torques{0.0, load.viscousFriction, friction, 1.3 * friction};
    if (load.gravityTorque != 0.0) {
        torques.drive -= load.gravityTorque * std::sin(m_shaft.angle - m_restAngle);
    }
    if (load.springRate != 0.0) {
        torques.drive -= load.springRate * (m_shaft.angle - load.springCenter);
        torques.damping += load.springRate * seconds;
    }
    return torques;
}

void Mechanics::measureCurrent(Bridge bridge, double effort, const Environment& environment)
{
    m_amps = 0.0;
    m_supplyAmps = m_motorModel.idleAmps;
    if (bridge == Bridge::Driven) {
        const double resistance =
            m_motorModel.resistance + environment.supplyOhms * effort * effort;
        const double volts =
            environment.supplyVolts - environment.supplyOhms * m_motorModel.idleAmps;
        m_amps = (effort * volts - m_motorModel.emfConstant * m_motor.speed) / resistance;
        m_supplyAmps += std::max(0.0, effort * m_amps);
    } else if (bridge == Bridge::Shorted) {
        m_amps = -effort * m_motorModel.emfConstant * m_motor.speed / m_motorModel.resistance;
    }
}

/// Both bodies move as one, the motor pushing (or being pushed) at one side of the play.
void Mechanics::moveTogether(double side, const Torques& motor, const Torques& shaft,
                             double shaftInertia, double seconds)
{
    const double inertia = m_motorModel.inertia + shaftInertia;
    const double speed =
        (m_motorModel.inertia * m_motor.speed + shaftInertia * m_shaft.speed) / inertia;
    const double next = nextSpeed(speed, motor.drive + shaft.drive, motor.damping + shaft.damping,
                                  motor.friction + shaft.friction, motor.stiction + shaft.stiction,
                                  inertia, seconds);
    m_motor.speed = m_shaft.speed = next;
    m_motor.angle += next * seconds;
    m_shaft.angle = m_motor.angle - side * m_halfPlay;
}

void Mechanics::stopAt(double limit, double sign)
{
    if (sign * (m_shaft.angle - limit) <= 0.0) {
        return;
    }
    m_shaft.angle = limit;
    m_shaft.speed = 0.0;
    if (sign * (m_motor.angle - limit) >= m_halfPlay) {
        m_motor.angle = limit + sign * m_halfPlay;
        m_motor.speed = 0.0;
    }
}

/// Stronger than friction and load: it sets the speed. It rests at a stop before it turns back.
void Mechanics::moveByHand(const Load& load, double seconds)
{
    constexpr double restSeconds = 0.3;
    m_handRest = std::max(0.0, m_handRest - seconds);
    const double speed = m_handRest > 0.0 ? 0.0 : m_handDirection * load.handSpeed;
    const double next = m_shaft.angle + speed * seconds;
    const double low = load.stopLow.value_or(next);
    const double high = std::max(low, load.stopHigh.value_or(next));
    m_shaft = {std::clamp(next, low, high), speed};
    m_motor = m_shaft;
    if (m_shaft.angle != next) {
        m_handDirection = -m_handDirection;
        m_handRest = restSeconds;
    }
    m_atRest = false;
}

void Mechanics::step(Bridge bridge, double effort, const Load& load, const Environment& environment,
                     double seconds)
{
    if (bridge == Bridge::Open && load.handSpeed > 0.0) {
        moveByHand(load, seconds);
        measureCurrent(bridge, effort, environment);
        return;
    }
    const Torques motor = motorTorques(bridge, effort, environment);
    const Torques shaft = shaftTorques(load, seconds);
    const double shaftInertia = m_motorModel.shaftInertia + std::max(0.0, load.inertia);
    const Body motorBefore = m_motor;
    const Body shaftBefore = m_shaft;

    const double motorSpeed = nextSpeed(m_motor.speed, motor.drive, motor.damping, motor.friction,
                                        motor.stiction, m_motorModel.inertia, seconds);
    const double shaftSpeed = nextSpeed(m_shaft.speed, shaft.drive, shaft.damping, shaft.friction,
                                        shaft.stiction, shaftInertia, seconds);
    const double gap = m_motor.angle - m_shaft.angle + (motorSpeed - shaftSpeed) * seconds;
    if (std::abs(gap) <= m_halfPlay) {
        m_motor = {m_motor.angle + motorSpeed * seconds, motorSpeed};
        m_shaft = {m_shaft.angle + shaftSpeed * seconds, shaftSpeed};
    } else {
        moveTogether(gap > 0.0 ? 1.0 : -1.0, motor, shaft, shaftInertia, seconds);
    }
    if (load.stopLow) {
        stopAt(*load.stopLow, -1.0);
    }
    if (load.stopHigh) {
        stopAt(*load.stopHigh, 1.0);
    }
    m_atRest = m_motor.speed == 0.0 && m_shaft.speed == 0.0 && m_motor.angle == motorBefore.angle &&
               m_shaft.angle == shaftBefore.angle;
    measureCurrent(bridge, effort, environment);
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// Motor, gear play and output shaft under load, advanced by one step of time. Two bodies with dry
// friction meet across the play without bouncing, so that the step is stable whatever the load.
// Plain values owned by one servo; its thread. Angles in rad, clockwise positive; SI units.
#pragma once

#include "sim/servo/servo_types.h"
#include "sim/servo/virtual_servo.h"

namespace sim {
enum class Bridge : std::uint8_t {
    Open,    ///< the motor turns freely
    Driven,  ///< `effort` is the duty, -1…1
    Shorted, ///< braked; `effort` is the share of time the winding is shorted, 0…1
};

class Mechanics {
public:
    Mechanics(const MotorModel& drive, double playRadians, double angle, double restAngle);

    void step(Bridge bridge, double effort, const Load& load, const Environment& environment,
              double seconds);

    /// Without gear play from now on, or with it again.
    void setRigid(bool stiff) { m_halfPlay = stiff ? 0.0 : m_initialHalfPlay; }

    double angle() const { return m_shaft.angle; } ///< the encoder sits here
    double speed() const { return m_shaft.speed; }
    double motorAmps() const { return m_amps; } ///< through the winding, signed like the duty
    double supplyAmps() const { return m_supplyAmps; }
    double supplyVolts(const Environment& environment) const;
    /// The duty, −1…1, that lets this current through the winding at the present speed.
    double dutyFor(double amps, const Environment& environment) const;
    /// The effort that gives the shaft this motion under this load. `breakaway` is the share of dry
    /// friction to push against, −1…1, signed as the direction.
    double effortFor(double acceleration, double speed, double breakaway, const Load& load,
                     const Environment& environment) const;
    /// N·m that the load sets against turning in this direction (sign); 0: its friction alone.
    double opposingTorque(double direction, const Load& load) const;
    double copperWatts() const { return m_amps * m_amps * m_motorModel.resistance; }

    /// Neither body moved in the last step: with an open bridge and the same load it never will.
    bool isAtRest() const { return m_atRest; }

private:
    struct Body {
        double angle = 0;
        double speed = 0;
    };
    /// The torques on one body: independent of its speed, and growing with it.
    struct Torques {
        double drive = 0;
        double damping = 0;
        double friction = 0; ///< sliding
        double stiction = 0; ///< from rest
    };
    Torques motorTorques(Bridge bridge, double effort, const Environment& environment) const;
    Torques shaftTorques(const Load& load, double seconds) const;
    void measureCurrent(Bridge bridge, double effort, const Environment& environment);
    void moveTogether(double side, const Torques& motor, const Torques& shaft, double shaftInertia,
                      double seconds);
    void stopAt(double limit, double sign);
    void moveByHand(const Load& load, double seconds);

    MotorModel m_motorModel;
    double m_initialHalfPlay;
    double m_halfPlay;  ///< at present
    double m_restAngle; ///< where gravity lets the load hang
    Body m_motor;
    Body m_shaft;
    double m_amps = 0;
    double m_supplyAmps = 0;
    bool m_atRest = true;
    double m_handDirection = 1;
    double m_handRest = 0; ///< seconds
};
} // namespace sim

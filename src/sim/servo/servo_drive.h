// SPDX-License-Identifier: GPL-3.0-or-later
// Motor, shaft and control loops of a servo, one millisecond at a time: it measures the position,
// drives the motor towards the goal, and knows whether the servo still moves. Owned by a
// ServoFirmware; one thread. Steps, step/s and duty in 0.1 %, in the servo's own coordinate.
#pragma once

#include "sim/servo/controller.h"
#include "sim/servo/mechanics.h"
#include "sim/servo/motion_goal.h"
#include "sim/servo/position_sensor.h"
#include "sim/servo/protection.h"
#include "sim/servo/register_store.h"

namespace sim {
class ServoDrive {
public:
    /// All arguments must outlive the drive; `config` may change meanwhile.
    ServoDrive(const ServoModel& model, const ServoConfig& config, RegisterStore& registers,
               Protection& protection);

    void powerOn();
    void powerOff();
    void tick(bool isRunning); ///< one millisecond

    /// The position counts from the present turn, as after power-on.
    void resetTurns();
    void holdPresentPosition();
    void goalRegisterWritten() { m_goal.registerWritten(); }
    /// A write to the register that drives the present mode: it releases protections, may turn the
    /// torque on, and adds to the goal in step mode. `goalBefore` is the goal before the write.
    void command(bool mayEnergize, double goalBefore);
    void stopMoving() { m_moving = false; }
    void wake() { m_restTicks = 0; } ///< a register has changed

    std::uint64_t ticks() const { return m_ticks; } ///< ms since it was made
    const Mechanics& mechanics() const { return m_mechanics; }
    const PositionSensor& sensor() const { return m_sensor; }
    const MotionGoal& goal() const { return m_goal; }
    double duty() const { return m_duty; } ///< towards larger positions positive
    double pathPosition() const { return m_controller.path().position; }
    bool isMoving() const { return m_moving; }
    double sensedCurrent() const; ///< in 6.5 mA, signed like the load

private:
    bool isIdle() const;
    void control(bool isRunning);
    void releaseBridge(bool damping);
    void startDriving();
    void updateMoving();
    double requestedDuty(double limit);
    double holdGoal(double limit);
    double holdDefectGoal(double limit);
    double topSpeed() const;
    double limitByWear(double requested, double direction) const;
    double limitCurrent(double requested) const;
    double commandDirection() const;

    const ServoModel& m_model;
    const ServoConfig& m_config;
    const Settings& m_settings;
    RegisterStore& m_registers;
    Protection& m_protection;
    Mechanics m_mechanics;
    PositionSensor m_sensor;
    MotionGoal m_goal;
    Controller m_controller;

    std::uint64_t m_ticks = 0;
    double m_duty = 0;
    Bridge m_bridge = Bridge::Open;
    bool m_moving = false;
    int m_stillTicks = 0; ///< the path has ended and the shaft is still
    int m_restTicks = 0;  ///< the mechanics rest with an open bridge
    Load m_restLoad;      ///< the load under which they came to rest
};
} // namespace sim

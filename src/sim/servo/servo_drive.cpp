// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/servo_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {
constexpr int stillTime = 50; ///< ms until the moving flag falls
constexpr int restTime = 200; ///< ms until an idle servo needs no computing

/// Where gravity lets the load hang: the middle of the range.
double midRange(const ServoModel& model)
{
    return 0.5 * model.profile->stepsPerTurn / model.traits.stepsPerRadian;
}
} // namespace

ServoDrive::ServoDrive(const ServoModel& model, const ServoConfig& config, RegisterStore& registers,
                       Protection& protection)
    : m_model(model)
    , m_config(config)
    , m_settings(registers.settings())
    , m_registers(registers)
    , m_protection(protection)
    , m_mechanics(motorModelOf(model.type), config.gearPlayDegrees * std::numbers::pi / 180.0,
                  config.initialDegrees * std::numbers::pi / 180.0, midRange(model))
    , m_sensor(model.traits, m_settings, config.seed)
    , m_goal(m_settings, model.traits.turnSteps)
{}

void ServoDrive::powerOn()
{
    m_sensor.powerOn(m_mechanics.angle(), m_ticks);
    m_restTicks = m_stillTicks = 0;
    m_sensor.resetTurns();
    m_controller.energize(m_sensor.position());
    m_goal.powerOn(m_sensor.position());
}

void ServoDrive::powerOff()
{
    m_duty = 0;
    m_moving = false;
}

/// An idle servo at rest under the load it came to rest under cannot move; only time and heat pass.
bool ServoDrive::isIdle() const
{
    return m_restTicks > restTime && m_settings.torqueSwitch != 1 && m_config.load == m_restLoad;
}

void ServoDrive::tick(bool isRunning)
{
    ++m_ticks;
    if (isIdle()) {
        return;
    }
    m_sensor.measure(m_mechanics.angle(), m_ticks);
    control(isRunning);
    m_mechanics.setRigid(m_config.defects.affectsPosition());
    m_mechanics.step(m_bridge,
                     m_bridge == Bridge::Driven ? m_duty / 1000.0 * m_settings.driveSign
                                                : m_settings.torqueLimit / 1000.0,
                     m_config.load, m_config.environment, Controller::tick);
    m_restTicks = m_mechanics.isAtRest() && m_bridge != Bridge::Driven ? m_restTicks + 1 : 0;
    if (m_restTicks > restTime) {
        m_restLoad = m_config.load;
        m_sensor.stop();
    }
}

void ServoDrive::resetTurns()
{
    const double distance = m_sensor.resetTurns();
    if (m_sensor.isContinuous()) {
        m_goal.shiftCoordinate(distance, m_sensor.position());
        m_controller.energize(m_sensor.position());
    }
}

void ServoDrive::holdPresentPosition()
{
    m_goal.hold(m_sensor.position());
    m_moving = false;
    m_controller.energize(m_sensor.position());
}

/// An LX servo obeys only when its torque is on.
void ServoDrive::command(bool mayEnergize, double goalBefore)
{
    if (!m_model.traits.lx || m_settings.torqueSwitch == 1) {
        const bool addsStep =
            m_settings.mode == DriveMode::Step && (m_settings.limitsZero || m_model.traits.modbus);
        m_goal.command(addsStep, m_sensor.position());
        if (m_protection.newCommand(m_settings, commandDirection())) {
            m_controller.energize(m_sensor.position());
        }
        if (mayEnergize && m_settings.goalEnergizes) {
            m_registers.setTorque(1);
        }
    }
    m_moving = m_moving || m_goal.position() != goalBefore;
    m_stillTicks = 0;
}

/// The sensor's range ends where that of its protection does.
double ServoDrive::sensedCurrent() const
{
    constexpr double ampsPerUnit = 0.0065;
    if (!m_settings.hasCurrentSensing) {
        return 0.0;
    }
    const double units = -m_mechanics.motorAmps() * m_settings.driveSign / ampsPerUnit;
    return std::clamp<double>(units, -m_model.type.maxCurrent, m_model.type.maxCurrent);
}

double ServoDrive::topSpeed() const
{
    return limitByWear(m_goal.speed(), m_goal.position() - pathPosition());
}

/// What is left of a speed; the direction is that of the position's growth.
double ServoDrive::limitByWear(double requested, double direction) const
{
    const Defects& defects = m_config.defects;
    if (defects.speedFactor == 1.0 && defects.speedPerLoad == 0.0) {
        return requested;
    }
    constexpr double minFraction = 0.02;
    const double load = m_mechanics.opposingTorque(direction * m_sensor.sign(), m_config.load);
    const double left = 1.0 - defects.speedPerLoad * load / m_model.type.stallTorque;
    const double limit = m_settings.maxSpeed * std::max(minFraction, defects.speedFactor * left);
    return std::clamp(requested, -limit, limit);
}

/// The duty that register 44 allows through the winding at the present speed.
double ServoDrive::limitCurrent(double requested) const
{
    const double sign = m_settings.driveSign;
    const auto dutyAt = [&](double amps) {
        return sign * 1000.0 * m_mechanics.dutyFor(amps, m_config.environment);
    };
    return std::clamp(requested, dutyAt(-sign * m_settings.currentLimit),
                      dutyAt(sign * m_settings.currentLimit));
}

double ServoDrive::holdGoal(double limit)
{
    if (m_config.defects.affectsPosition()) {
        return holdDefectGoal(limit);
    }
    return m_controller.holdPosition(m_settings, m_goal.position(), topSpeed(), m_sensor.position(),
                                     limit);
}

/// The loop is relieved of friction, load and gear play, so that the shaft is exactly where its
/// defects put it.
double ServoDrive::holdDefectGoal(double limit)
{
    constexpr double fullPushError = 0.25; // steps of error
    const double sign = m_sensor.sign();
    const double stepsPerRadian = m_model.traits.stepsPerRadian;
    const Shaft shaft = m_sensor.shaft(m_mechanics.speed());
    Setpoint setpoint = m_controller.defectSetpoint(m_settings, m_config.defects, m_goal.position(),
                                                    topSpeed(), shaft);
    if (m_model.traits.sensor == Sensor::Potentiometer) {
        // Beyond the ends of its range the sensor does not show the way back.
        setpoint.position = std::clamp(setpoint.position, 0.0 - m_settings.offset,
                                       m_model.profile->stepsPerTurn - 1.0 - m_settings.offset);
    }
    const double pushShare =
        std::clamp((setpoint.position - shaft.position) / fullPushError, -1.0, 1.0);
    const double perStep = sign / stepsPerRadian;
    const double effort =
        m_mechanics.effortFor(setpoint.acceleration * perStep, setpoint.speed * perStep,
                              sign * pushShare, m_config.load, m_config.environment);
    const double support =
        m_settings.positionP > 0.0 ? 1000.0 * m_settings.driveSign * effort : 0.0;
    return m_controller.holdDefectSetpoint(m_settings, setpoint, shaft.position, support, limit);
}

double ServoDrive::requestedDuty(double limit)
{
    double requested = 0;
    switch (m_settings.mode) {
    case DriveMode::Pwm:
        return std::clamp<double>(-m_settings.pwm, -limit, limit);
    case DriveMode::Current: {
        const double sign = m_settings.driveSign;
        requested =
            sign * 1000.0 * m_mechanics.dutyFor(-sign * m_settings.goalAmps, m_config.environment);
        return std::clamp(requested, -limit, limit);
    }
    case DriveMode::Direct:
        return holdGoal(limit);
    case DriveMode::Speed:
        requested = m_controller.holdSpeed(m_settings,
                                           limitByWear(m_settings.goalSpeed, m_settings.goalSpeed),
                                           m_sensor.speed(), limit);
        break;
    default:
        requested = holdGoal(limit);
    }
    return m_model.traits.currentLimited ? limitCurrent(requested) : requested;
}

void ServoDrive::control(bool isRunning)
{
    const bool hasTorque = isRunning && !m_protection.mustUnload(m_settings);
    if (!hasTorque || m_settings.torqueSwitch != 1) {
        releaseBridge(hasTorque && m_settings.torqueSwitch == 2);
        return;
    }
    if (m_bridge != Bridge::Driven) {
        startDriving();
    }
    m_duty = requestedDuty(m_protection.dutyLimit(m_settings));
    updateMoving();
}

void ServoDrive::releaseBridge(bool damping)
{
    m_bridge = damping ? Bridge::Shorted : Bridge::Open;
    m_duty = 0;
    m_moving = false;
    m_controller.follow(m_sensor.position());
    m_goal.follow(m_sensor.position());
}

void ServoDrive::startDriving()
{
    m_bridge = Bridge::Driven;
    if (m_settings.mode == DriveMode::Direct ||
        (!m_settings.limitsZero && m_settings.mode == DriveMode::Position)) {
        resetTurns();
    }
    m_controller.energize(m_sensor.position());
}

void ServoDrive::updateMoving()
{
    const bool still = m_sensor.isStill() && m_controller.isAtRest();
    m_stillTicks = still ? m_stillTicks + 1 : 0;
    const bool hasGoal = m_settings.mode == DriveMode::Position ||
                         m_settings.mode == DriveMode::Direct || m_settings.mode == DriveMode::Step;
    const bool movedBefore = m_moving;
    m_moving = hasGoal ? m_moving && m_stillTicks < stillTime : !still;
    if (m_settings.releaseAtGoal && movedBefore && !m_moving) {
        m_registers.setTorque(0);
    }
}

double ServoDrive::commandDirection() const
{
    switch (m_settings.mode) {
    case DriveMode::Speed:
        return m_settings.goalSpeed;
    case DriveMode::Pwm:
        return -m_settings.pwm;
    case DriveMode::Current:
        return -m_settings.goalAmps;
    default:
        return m_goal.position() - m_sensor.position();
    }
}
} // namespace sim

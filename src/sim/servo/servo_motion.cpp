// SPDX-License-Identifier: GPL-3.0-or-later
// One millisecond of a servo's life: measure, control, move, watch.
#include "sim/servo/servo_state.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
constexpr base::Duration tickTime = std::chrono::milliseconds(1);
constexpr double tickSeconds = Controller::tick;
constexpr double speedFilterShare = 0.2;    ///< smoothing over 5 ms
constexpr double reportedShare = 1.0 / 15;  ///< and 15 ms more for the register
constexpr double voltageFilterShare = 0.05; ///< 20 ms
constexpr int stillTime = 50;               ///< ms until the moving flag falls
constexpr int restTime = 200;               ///< ms until an idle servo is left alone
} // namespace

void VirtualServo::State::advance(base::Duration dt)
{
    deafLeft = std::max(base::Duration(), deafLeft - dt);
    if (rebootLeft.count() > 0) {
        rebootLeft = std::max(base::Duration(), rebootLeft - dt);
        if (rebootLeft.count() == 0) {
            switchOn();
        }
    }
    for (pending += dt; pending >= tickTime; pending -= tickTime) {
        tick();
    }
}

/// An idle servo at rest under the load it came to rest under cannot move; only time and heat pass.
bool VirtualServo::State::isIdle() const
{
    return restTicks > restTime && settings.torqueSwitch != 1 && config.load == restLoad;
}

void VirtualServo::State::tick()
{
    ++ticks;
    if (!isIdle()) {
        measure();
        control();
        mechanics.setRigid(config.defects.affectsPosition());
        mechanics.step(bridge,
                       bridge == Bridge::Driven ? duty / 1000.0 * settings.driveSign
                                                : settings.torqueLimit / 1000.0,
                       config.load, config.environment, tickSeconds);
        restTicks = mechanics.isAtRest() && bridge != Bridge::Driven ? restTicks + 1 : 0;
        if (restTicks > restTime) {
            restLoad = config.load;
            speed = reportedSpeed = 0;
        }
    }
    updateProtection();
}

void VirtualServo::State::resetTurnBase()
{
    if (!encoder.isContinuous()) {
        position = readPosition();
        return;
    }
    const auto turn = double(traits.turnSteps);
    const double before = readPosition();
    turnBase += std::int64_t(std::floor(before / turn) * turn);
    position = readPosition();
    stepGoal += position - before;
    if (restGoal) {
        restGoal = position;
    }
    controller.energize(position);
}

double VirtualServo::State::readPosition() const
{
    if (!encoder.isContinuous()) {
        return encoder.withinTurn(encoderCount) - settings.offset;
    }
    const std::int64_t steps =
        settings.reversed ? traits.turnSteps - 1 - encoderCount : encoderCount;
    return double(steps - settings.offset - turnBase);
}

void VirtualServo::State::measure()
{
    const std::int64_t before = encoderCount;
    encoderCount = encoder.sample(mechanics.angle(), ticks);
    const double direction = settings.reversed ? -1.0 : 1.0;
    speed += (direction * double(encoderCount - before) / tickSeconds - speed) * speedFilterShare;
    reportedSpeed += (speed - reportedSpeed) * reportedShare;
    position = readPosition();
}

double VirtualServo::State::positionGoal() const
{
    if (restGoal) {
        return *restGoal;
    }
    if (settings.mode == DriveMode::Step) {
        return stepGoal;
    }
    if (settings.mode == DriveMode::Direct) {
        return std::clamp<double>(settings.goalPosition, 0, traits.turnSteps - 1);
    }
    if (settings.limitsZero) {
        return settings.goalPosition;
    }
    return std::min(std::max(settings.goalPosition, settings.minAngle), settings.maxAngle);
}

double VirtualServo::State::topSpeed() const
{
    return limitByWear(requestedSpeed(), positionGoal() - controller.path().position);
}

/// What is left of a speed; the direction is that of the position's growth.
double VirtualServo::State::limitByWear(double requested, double direction) const
{
    const Defects& defects = config.defects;
    if (defects.speedFactor == 1.0 && defects.speedPerLoad == 0.0) {
        return requested;
    }
    constexpr double minFraction = 0.02;
    const double load = mechanics.opposingTorque(direction * sensorSign(), config.load);
    const double left = 1.0 - defects.speedPerLoad * load / type.stallTorque;
    const double limit = settings.maxSpeed * std::max(minFraction, defects.speedFactor * left);
    return std::clamp(requested, -limit, limit);
}

double VirtualServo::State::requestedSpeed() const
{
    if (settings.goalSpeed != 0) {
        return std::abs(settings.goalSpeed);
    }
    if (timedSpeed > 0.0) {
        return std::min<double>(timedSpeed, settings.maxSpeed);
    }
    return settings.zeroSpeedIsMaximum ? settings.maxSpeed : 0.0;
}

/// What 44 allows through the winding at the present speed.
double VirtualServo::State::limitCurrent(double requested) const
{
    const double sign = settings.driveSign;
    const double low =
        sign * 1000.0 * mechanics.dutyFor(-sign * settings.currentLimit, config.environment);
    const double high =
        sign * 1000.0 * mechanics.dutyFor(sign * settings.currentLimit, config.environment);
    return std::clamp(requested, low, high);
}

double VirtualServo::State::holdGoal(double limit)
{
    return config.defects.affectsPosition()
               ? holdDefectGoal(limit)
               : controller.holdPosition(settings, positionGoal(), topSpeed(), position, limit);
}

/// Friction, load and gear play are taken off the loop's shoulders, so that the shaft is where its
/// defects say and nowhere else.
double VirtualServo::State::holdDefectGoal(double limit)
{
    constexpr double fullPushError = 0.25; // steps of error
    const double sign = sensorSign();
    const Shaft shaft{position + sign * (encoder.unrounded() - double(encoderCount)),
                      sign * mechanics.speed() * traits.stepsPerRadian};
    Setpoint setpoint =
        controller.defectSetpoint(settings, config.defects, positionGoal(), topSpeed(), shaft);
    if (traits.sensor == Sensor::Potentiometer) {
        // Behind its ends the sensor does not tell the way back.
        setpoint.position = std::clamp(setpoint.position, 0.0 - settings.offset,
                                       profile->stepsPerTurn - 1.0 - settings.offset);
    }
    const double pushShare =
        std::clamp((setpoint.position - shaft.position) / fullPushError, -1.0, 1.0);
    const double perStep = sign / traits.stepsPerRadian;
    const double effort =
        mechanics.effortFor(setpoint.acceleration * perStep, setpoint.speed * perStep,
                            sign * pushShare, config.load, config.environment);
    const double support = settings.positionP > 0.0 ? 1000.0 * settings.driveSign * effort : 0.0;
    return controller.holdDefectSetpoint(settings, setpoint, shaft.position, support, limit);
}

double VirtualServo::State::drive(double limit)
{
    double requested = 0;
    switch (settings.mode) {
    case DriveMode::Pwm:
        return std::clamp<double>(-settings.pwm, -limit, limit);
    case DriveMode::Current: {
        const double sign = settings.driveSign;
        requested =
            sign * 1000.0 * mechanics.dutyFor(-sign * settings.goalAmps, config.environment);
        return std::clamp(requested, -limit, limit);
    }
    case DriveMode::Direct:
        return holdGoal(limit);
    case DriveMode::Speed:
        requested = controller.holdSpeed(
            settings, limitByWear(settings.goalSpeed, settings.goalSpeed), speed, limit);
        break;
    default:
        requested = holdGoal(limit);
    }
    return traits.currentLimited ? limitCurrent(requested) : requested;
}

void VirtualServo::State::control()
{
    const bool isDriven =
        isRunning() && settings.torqueSwitch == 1 && !protection.mustUnload(settings);
    if (!isDriven) {
        const bool damping =
            isRunning() && settings.torqueSwitch == 2 && !protection.mustUnload(settings);
        bridge = damping ? Bridge::Shorted : Bridge::Open;
        duty = 0;
        moving = false;
        controller.follow(position);
        stepGoal = position;
        return;
    }
    if (bridge != Bridge::Driven) {
        bridge = Bridge::Driven;
        if (settings.mode == DriveMode::Direct ||
            (!settings.limitsZero && settings.mode == DriveMode::Position)) {
            resetTurnBase();
        }
        controller.energize(position);
    }
    duty = drive(protection.dutyLimit(settings));
    const bool still = std::abs(reportedSpeed) < minReportedSpeed && controller.isAtRest();
    stillTicks = still ? stillTicks + 1 : 0;
    const bool drivesGoal = settings.mode == DriveMode::Position ||
                            settings.mode == DriveMode::Direct || settings.mode == DriveMode::Step;
    const bool movedBefore = moving;
    moving = drivesGoal ? moving && stillTicks < stillTime : !still;
    if (settings.releaseAtGoal && movedBefore && !moving) {
        setTorque(0);
    }
}

void VirtualServo::State::updateProtection()
{
    celsius += (config.environment.ambientCelsius +
                mechanics.copperWatts() * type.thermalResistance - celsius) *
               (tickSeconds / type.thermalTime);
    if (!isRunning()) {
        return;
    }
    volts += (mechanics.supplyVolts(config.environment) * traits.rawPerVolt - volts) *
             voltageFilterShare;
    const bool watchVoltage = settings.maxVoltage != 0 || settings.minVoltage != 0;
    protection.update(settings, {duty, std::abs(sensedCurrent()), volts, celsius}, watchVoltage);
    if (settings.release == FaultRelease::Command && protection.isOvercurrentTripped() &&
        settings.torqueSwitch != 0) {
        setTorque(0);
    }
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// One millisecond of a servo's life: measure, control, move, watch.
#include "sim/servo_state.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {
constexpr base::Duration tickTime = std::chrono::milliseconds(1);
constexpr double tickSeconds = Controller::tick;
constexpr double speedShare = 0.2;      ///< smoothing over 5 ms
constexpr double shownShare = 1.0 / 15; ///< and 15 ms more for the register
constexpr double voltShare = 0.05;      ///< 20 ms
constexpr int stillTime = 50;           ///< ms until the moving flag falls
constexpr int restTime = 200;           ///< ms until an idle servo is left alone
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
bool VirtualServo::State::sleeps() const
{
    return restTicks > restTime && settings.torqueSwitch != 1 && config.load == restLoad;
}

void VirtualServo::State::tick()
{
    ++ticks;
    if (!sleeps()) {
        measure();
        control();
        mechanics.stiffen(config.defects.bendGoal());
        mechanics.step(bridge,
                       bridge == Bridge::Driven ? duty / 1000.0 * settings.driveSign
                                                : settings.torqueLimit / 1000.0,
                       config.load, config.surroundings, tickSeconds);
        restTicks = mechanics.atRest() && bridge != Bridge::Driven ? restTicks + 1 : 0;
        if (restTicks > restTime) {
            restLoad = config.load;
            speed = shownSpeed = 0;
        }
    }
    watch();
}

void VirtualServo::State::rebase()
{
    if (!encoder.endless()) {
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
    controller.energise(position);
}

double VirtualServo::State::readPosition() const
{
    if (!encoder.endless()) {
        return encoder.withinTurn(counted) - settings.offset;
    }
    const std::int64_t steps = settings.reversed ? traits.turnSteps - 1 - counted : counted;
    return double(steps - settings.offset - turnBase);
}

void VirtualServo::State::measure()
{
    const std::int64_t before = counted;
    counted = encoder.sample(mechanics.angle(), ticks);
    const double direction = settings.reversed ? -1.0 : 1.0;
    speed += (direction * double(counted - before) / tickSeconds - speed) * speedShare;
    shownSpeed += (speed - shownSpeed) * shownShare;
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
    return worn(wantedSpeed(), positionGoal() - controller.path().position);
}

/// What is left of a speed; the direction is that of the position's growth.
double VirtualServo::State::worn(double wanted, double direction) const
{
    const Defects& defects = config.defects;
    if (defects.speedFactor == 1.0 && defects.speedPerLoad == 0.0) {
        return wanted;
    }
    constexpr double least = 0.02;
    const double load = mechanics.opposed(direction * senseOfSensor(), config.load);
    const double left = 1.0 - defects.speedPerLoad * load / type.stallTorque;
    const double most = settings.maxSpeed * std::max(least, defects.speedFactor * left);
    return std::clamp(wanted, -most, most);
}

double VirtualServo::State::wantedSpeed() const
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
double VirtualServo::State::withinCurrentLimit(double wanted) const
{
    const double sign = settings.driveSign;
    const double low =
        sign * 1000.0 * mechanics.dutyFor(-sign * settings.currentLimit, config.surroundings);
    const double high =
        sign * 1000.0 * mechanics.dutyFor(sign * settings.currentLimit, config.surroundings);
    return std::clamp(wanted, low, high);
}

double VirtualServo::State::holdGoal(double limit)
{
    return config.defects.bendGoal()
               ? holdBentGoal(limit)
               : controller.holdPosition(settings, positionGoal(), topSpeed(), position, limit);
}

/// Friction, load and gear play are taken off the loop's shoulders, so that the shaft is where its
/// defects say and nowhere else.
double VirtualServo::State::holdBentGoal(double limit)
{
    constexpr double fullPush = 0.25; // steps of error
    const double sense = senseOfSensor();
    const Shaft shaft{position + sense * (encoder.fine() - double(counted)),
                      sense * mechanics.speed() * traits.stepsPerRadian};
    Aim aim = controller.bend(settings, config.defects, positionGoal(), topSpeed(), shaft);
    if (traits.sensor == Sensor::Potentiometer) {
        // Behind its ends the sensor does not tell the way back.
        aim.position = std::clamp(aim.position, 0.0 - settings.offset,
                                  profile->stepsPerTurn - 1.0 - settings.offset);
    }
    const double push = std::clamp((aim.position - shaft.position) / fullPush, -1.0, 1.0);
    const double perStep = sense / traits.stepsPerRadian;
    const double effort = mechanics.effortFor(aim.acceleration * perStep, aim.speed * perStep,
                                              sense * push, config.load, config.surroundings);
    const double support = settings.positionP > 0.0 ? 1000.0 * settings.driveSign * effort : 0.0;
    return controller.holdBent(settings, aim, shaft.position, support, limit);
}

double VirtualServo::State::drive(double limit)
{
    double wanted = 0;
    switch (settings.mode) {
    case DriveMode::Pwm:
        return std::clamp<double>(-settings.pwm, -limit, limit);
    case DriveMode::Current: {
        const double sign = settings.driveSign;
        wanted = sign * 1000.0 * mechanics.dutyFor(-sign * settings.goalAmps, config.surroundings);
        return std::clamp(wanted, -limit, limit);
    }
    case DriveMode::Direct:
        return holdGoal(limit);
    case DriveMode::Speed:
        wanted = controller.holdSpeed(settings, worn(settings.goalSpeed, settings.goalSpeed), speed,
                                      limit);
        break;
    default:
        wanted = holdGoal(limit);
    }
    return traits.currentLimited ? withinCurrentLimit(wanted) : wanted;
}

void VirtualServo::State::control()
{
    const bool output = alive() && settings.torqueSwitch == 1 && !protection.unloads(settings);
    if (!output) {
        const bool damping = alive() && settings.torqueSwitch == 2 && !protection.unloads(settings);
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
            rebase();
        }
        controller.energise(position);
    }
    duty = drive(protection.dutyLimit(settings));
    const bool still = std::abs(shownSpeed) < slowestShown && controller.rests();
    stillTicks = still ? stillTicks + 1 : 0;
    const bool drivesGoal = settings.mode == DriveMode::Position ||
                            settings.mode == DriveMode::Direct || settings.mode == DriveMode::Step;
    const bool movedBefore = moving;
    moving = drivesGoal ? moving && stillTicks < stillTime : !still;
    if (settings.releaseAtGoal && movedBefore && !moving) {
        setTorque(0);
    }
}

void VirtualServo::State::watch()
{
    celsius += (config.surroundings.ambientCelsius +
                mechanics.copperWatts() * type.thermalResistance - celsius) *
               (tickSeconds / type.thermalTime);
    if (!alive()) {
        return;
    }
    volts += (mechanics.supplyVolts(config.surroundings) * traits.rawPerVolt - volts) * voltShare;
    const bool watchVoltage = settings.maxVoltage != 0 || settings.minVoltage != 0;
    protection.update(settings, {duty, std::abs(sensedCurrent()), volts, celsius}, watchVoltage);
    if (settings.release == Release::Command && protection.overcurrentTripped() &&
        settings.torqueSwitch != 0) {
        setTorque(0);
    }
}
} // namespace sim

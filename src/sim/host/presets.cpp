// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/host/presets.h"

#include "sim/faults/defect_list.h"
#include "sim/servo/servo_spec.h"

#include <algorithm>
#include <numbers>

namespace sim {
namespace {
constexpr int fastBaud = 1'000'000;

void turnTo(VirtualServo& servo, int steps)
{
    servo.poke(QStringLiteral("goal_position"), steps);
}

void runFor(VirtualServo& servo, base::Duration span)
{
    const base::Duration dt = std::chrono::milliseconds(1);
    for (base::Duration at{}; at < span; at += dt)
        servo.step(dt);
}

// Pressed against its stop until the overload protection has tripped.
void stall(VirtualServo& servo)
{
    turnTo(servo, 3000);
    runFor(servo, std::chrono::seconds(5));
}

// The supply is above what this servo allows, and stays so.
void overVoltage(VirtualServo& servo)
{
    constexpr double tooMuch = 0.6;
    const auto limit = static_cast<double>(servo.raw(QStringLiteral("max_voltage"))) / 10;
    servo.environment().supplyVolts = limit + tooMuch;
    runFor(servo, std::chrono::milliseconds(500));
}

void openLock(VirtualServo& servo)
{
    servo.poke(QStringLiteral("lock"), 0);
}

Load arm(double gravityTorque)
{
    Load load;
    load.inertia = 6e-4;
    load.gravityTorque = gravityTorque;
    load.coulombFriction = 0.02;
    return load;
}

Load turntable()
{
    Load load;
    load.inertia = 2e-3;
    load.coulombFriction = 0.05;
    return load;
}

Load spring()
{
    Load load;
    load.springRate = 0.04;
    load.springCenter = 3.14;
    return load;
}

Load jammed()
{
    Load load;
    load.stopHigh = 3.4;
    return load;
}

using ServoList = std::vector<ServoSpec>;

ServoList demo()
{
    return {
        {QStringLiteral("STS3215"), 1, fastBaud, 7.4, 180, arm(0.12), nullptr},
        {QStringLiteral("STS3215"), 2, fastBaud, 7.4, 135, arm(0.06), nullptr},
        {QStringLiteral("STS3250"), 3, fastBaud, 12.0, 200, turntable(), nullptr},
        {QStringLiteral("SM40BLHV"), 4, fastBaud, 12.0, 90, turntable(), nullptr},
        {QStringLiteral("SCS15"), 5, fastBaud, 7.4, 110, spring(), nullptr},
        {QStringLiteral("SCS0009"), 6, fastBaud, 6.0, 150, {}, overVoltage},
    };
}

ServoList trouble()
{
    return {
        {QStringLiteral("STS3215"), 1, fastBaud, 7.4, 180, {}, nullptr},
        {QStringLiteral("STS3215"), 1, fastBaud, 7.4, 95, {}, nullptr},
        {QStringLiteral("STS3250"), 2, 500'000, 12.0, 200, {}, nullptr},
        {QStringLiteral("SM40BLHV"), 3, 115'200, 12.0, 90, {}, nullptr},
        {QStringLiteral("SCS15"), 4, fastBaud, 7.4, 110, {}, openLock},
        {QStringLiteral("STS3215"), 5, fastBaud, 7.4, 180, jammed(), stall},
    };
}

ServoList modbus()
{
    return {{QStringLiteral("SMSMB"), 1, {}, {}, 180, arm(0.2), nullptr}};
}

// Registers 17 and 18, which a technician tries first.
void saveOffset(VirtualServo& servo)
{
    constexpr std::uint8_t adjust = 17;
    constexpr std::uint8_t save = 18;
    servo.handle({false, adjust, {12}, -1});
    servo.handle({false, save, {}, -1});
    runFor(servo, std::chrono::milliseconds(50));
}

// Warmer than its limit, so its torque stays off until it cools down.
void overheat(VirtualServo& servo)
{
    constexpr int limit = 60;
    constexpr double tooWarm = 64;
    servo.poke(QStringLiteral("temp_limit"), limit);
    servo.environment().ambientCelsius = tooWarm;
    servo.setTemperature(tooWarm);
    runFor(servo, std::chrono::milliseconds(50));
}

ServoList lx()
{
    return {
        {QStringLiteral("LX-16A"), 1, {}, {}, 120, arm(0.12), nullptr},
        {QStringLiteral("LX-16A"), 2, {}, {}, 90, {}, saveOffset},
        {QStringLiteral("LX-224"), 3, {}, {}, 150, turntable(), overheat},
        {QStringLiteral("LX-224HV"), 4, {}, {}, 60, arm(0.2), nullptr},
        {QStringLiteral("HTS-35H"), 5, {}, {}, 200, turntable(), nullptr},
    };
}

// The same but for their defects.
ServoList sweep()
{
    Defects worn;
    worn.restHysteresis = 12;
    worn.speedFactor = 0.8;
    Defects badlyDamped;
    badlyDamped.overshootPercent = 8;
    return {
        {QStringLiteral("STS3215"), 1, fastBaud, 7.4, 180, {}, nullptr},
        {QStringLiteral("STS3215"), 2, fastBaud, 7.4, 180, {}, nullptr, worn},
        {QStringLiteral("STS3215"), 3, fastBaud, 7.4, 180, {}, nullptr, badlyDamped},
    };
}

// New from the factory: ID 1, factory baud rate.
ServoList line()
{
    const auto fresh = [](const char* model, double volts, double degrees) {
        return ServoSpec{QString::fromLatin1(model), 1, {}, volts, degrees, {}, nullptr};
    };
    return {fresh("STS3215", 7.4, 180), fresh("STS3215", 7.4, 135), fresh("STS3250", 12.0, 200),
            fresh("STS3215", 7.4, 90),  fresh("SCS15", 7.4, 110),   fresh("STS3215", 7.4, 175)};
}

// One at another rate, one with an alarm, one that has been in use, one of another family, one with
// another protocol, and a healthy one.
ServoList lineTrouble()
{
    return {
        {QStringLiteral("STS3215"), 1, 115'200, 7.4, 180, {}, nullptr},
        {QStringLiteral("STS3215"), 1, {}, 7.4, 135, {}, overVoltage},
        {QStringLiteral("STS3215"), 7, {}, 7.4, 90, {}, nullptr},
        {QStringLiteral("SM40BLHV"), 1, {}, 12.0, 90, {}, nullptr},
        {QStringLiteral("LX-16A"), 1, {}, {}, 120, {}, nullptr},
        {QStringLiteral("STS3215"), 1, {}, 7.4, 175, {}, nullptr},
    };
}

// The first day of a robot arm: nobody has given the servos their IDs yet.
ServoList newArm()
{
    ServoList servos;
    for (const double degrees : {180.0, 135.0, 205.0, 90.0, 240.0, 175.0})
        servos.push_back({QStringLiteral("STS3215"), 1, {}, 7.4, degrees, {}, nullptr});
    return servos;
}

// A robot arm of six servos as it comes from assembly: each joint between its own stops, the
// encoder's seam anywhere, and an offset left from an earlier attempt. The wrist turns freely.
ServoList so101()
{
    constexpr auto joint = [](int id, double degrees, double low, double high) {
        Load load = arm(0.05);
        load.stopLow = low * std::numbers::pi / 180.0;
        load.stopHigh = high * std::numbers::pi / 180.0;
        return ServoSpec{QStringLiteral("STS3215"), id, fastBaud, 7.4, degrees, load, nullptr};
    };
    ServoList servos{joint(1, 120, 35, 250), joint(2, 300, 250, 450), joint(3, 140, 100, 285),
                     joint(4, 40, -60, 130), joint(6, 200, 170, 290)};
    servos.push_back({QStringLiteral("STS3215"), 5, fastBaud, 7.4, 220, turntable(), nullptr});
    servos[2].prepare = [](VirtualServo& servo) {
        servo.poke(QStringLiteral("lock"), 0);
        servo.poke(QStringLiteral("position_offset"), 850);
        servo.poke(QStringLiteral("lock"), 1);
    };
    return servos;
}

struct Preset {
    const char* name;
    ServoList (*servos)();
    bool hotplug = false; ///< no servo is plugged in yet
};
constexpr Preset presets[] = {
    {"demo", demo},   {"trouble", trouble}, {"modbus", modbus},
    {"lx", lx},       {"sweep", sweep},     {"new-arm", newArm},
    {"so101", so101}, {"line", line, true}, {"line-trouble", lineTrouble, true}};
base::Result<void> addToAll(ServoList& servos, const QStringList& words)
{
    for (ServoSpec& servoSpec : servos) {
        if (auto added = addDefects(servoSpec, words); !added)
            return added;
    }
    return {};
}
} // namespace

QStringList presetNames()
{
    QStringList names;
    for (const Preset& preset : presets)
        names << QString::fromLatin1(preset.name);
    return names;
}

base::Result<std::unique_ptr<VirtualBus>>
makePreset(const QString& text, const catalog::Catalog& catalog, const WireConfig& wire,
           std::optional<int> baud, std::optional<base::Duration> epromTime)
{
    QStringList words = text.split(QLatin1Char('+'));
    const QString name = words.takeFirst();
    const auto* preset =
        std::find_if(std::begin(presets), std::end(presets),
                     [&name](const Preset& known) { return name == QLatin1String(known.name); });
    if (preset == std::end(presets))
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("simulate"),
                          QStringLiteral("%1: no such preset; known are %2")
                              .arg(name, presetNames().join(QLatin1String(", "))));
    ServoList servos = preset->servos();
    if (auto added = addToAll(servos, words); !added)
        return tl::unexpected(added.error());
    for (ServoSpec& servoSpec : servos)
        servoSpec.baud = baud.has_value() ? baud : servoSpec.baud;
    auto bus = makeBus(servos, catalog, wire, epromTime);
    if (bus && preset->hotplug)
        (*bus)->makeHotplugQueue();
    return bus;
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/presets.h"

#include "sim/defect_list.h"
#include "sim/servo_maker.h"

#include <algorithm>

namespace sim {
namespace {
constexpr int fast = 1'000'000;

void turnTo(VirtualServo& servo, int steps)
{
    servo.poke(QStringLiteral("goal_position"), steps);
}

void letTimePass(VirtualServo& servo, base::Duration span)
{
    const base::Duration dt = std::chrono::milliseconds(1);
    for (base::Duration at{}; at < span; at += dt)
        servo.step(dt);
}

// Pressed against its stop until the overload protection has tripped.
void stall(VirtualServo& servo)
{
    turnTo(servo, 3000);
    letTimePass(servo, std::chrono::seconds(5));
}

// The supply is above what this servo allows, and stays so.
void overVoltage(VirtualServo& servo)
{
    constexpr double tooMuch = 0.6;
    const auto limit = static_cast<double>(servo.raw(QStringLiteral("max_voltage"))) / 10;
    servo.surroundings().supplyVolts = limit + tooMuch;
    letTimePass(servo, std::chrono::milliseconds(500));
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
    load.springCentre = 3.14;
    return load;
}

Load jammed()
{
    Load load;
    load.stopHigh = 3.4;
    return load;
}

using Scene = std::vector<ServoRecipe>;

Scene demo()
{
    return {
        {QStringLiteral("STS3215"), 1, fast, 7.4, 180, arm(0.12), nullptr},
        {QStringLiteral("STS3215"), 2, fast, 7.4, 135, arm(0.06), nullptr},
        {QStringLiteral("STS3250"), 3, fast, 12.0, 200, turntable(), nullptr},
        {QStringLiteral("SM40BLHV"), 4, fast, 12.0, 90, turntable(), nullptr},
        {QStringLiteral("SCS15"), 5, fast, 7.4, 110, spring(), nullptr},
        {QStringLiteral("SCS0009"), 6, fast, 6.0, 150, {}, overVoltage},
    };
}

Scene trouble()
{
    return {
        {QStringLiteral("STS3215"), 1, fast, 7.4, 180, {}, nullptr},
        {QStringLiteral("STS3215"), 1, fast, 7.4, 95, {}, nullptr},
        {QStringLiteral("STS3250"), 2, 500'000, 12.0, 200, {}, nullptr},
        {QStringLiteral("SM40BLHV"), 3, 115'200, 12.0, 90, {}, nullptr},
        {QStringLiteral("SCS15"), 4, fast, 7.4, 110, {}, openLock},
        {QStringLiteral("STS3215"), 5, fast, 7.4, 180, jammed(), stall},
    };
}

Scene modbus()
{
    return {{QStringLiteral("SMSMB"), 1, {}, {}, 180, arm(0.2), nullptr}};
}

// What a technician tries first, told in the servo's own words: 17 and 18.
void saveOffset(VirtualServo& servo)
{
    constexpr std::uint8_t adjust = 17;
    constexpr std::uint8_t save = 18;
    servo.handle({false, adjust, {12}, -1});
    servo.handle({false, save, {}, -1});
    letTimePass(servo, std::chrono::milliseconds(50));
}

// Warmer than the limit it was given, so unloaded until somebody opens a window.
void overheat(VirtualServo& servo)
{
    constexpr int limit = 60;
    constexpr double tooWarm = 64;
    servo.poke(QStringLiteral("temp_limit"), limit);
    servo.surroundings().ambientCelsius = tooWarm;
    servo.setTemperature(tooWarm);
    letTimePass(servo, std::chrono::milliseconds(50));
}

Scene lx()
{
    return {
        {QStringLiteral("LX-16A"), 1, {}, {}, 120, arm(0.12), nullptr},
        {QStringLiteral("LX-16A"), 2, {}, {}, 90, {}, saveOffset},
        {QStringLiteral("LX-224"), 3, {}, {}, 150, turntable(), overheat},
        {QStringLiteral("LX-224HV"), 4, {}, {}, 60, arm(0.2), nullptr},
        {QStringLiteral("HTS-35H"), 5, {}, {}, 200, turntable(), nullptr},
    };
}

// Alike but for their health.
Scene sweep()
{
    Defects worn;
    worn.restHysteresis = 12;
    worn.speedFactor = 0.8;
    Defects badlyDamped;
    badlyDamped.overshootPercent = 8;
    return {
        {QStringLiteral("STS3215"), 1, fast, 7.4, 180, {}, nullptr},
        {QStringLiteral("STS3215"), 2, fast, 7.4, 180, {}, nullptr, worn},
        {QStringLiteral("STS3215"), 3, fast, 7.4, 180, {}, nullptr, badlyDamped},
    };
}

// As they come out of their boxes: ID 1, the factory's rate.
Scene line()
{
    const auto fresh = [](const char* model, double volts, double degrees) {
        return ServoRecipe{QString::fromLatin1(model), 1, {}, volts, degrees, {}, nullptr};
    };
    return {fresh("STS3215", 7.4, 180), fresh("STS3215", 7.4, 135), fresh("STS3250", 12.0, 200),
            fresh("STS3215", 7.4, 90),  fresh("SCS15", 7.4, 110),   fresh("STS3215", 7.4, 175)};
}

// One from another rate, one with an alarm, one that has been in use, one of another family, one
// that speaks another language, and a healthy one.
Scene lineTrouble()
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

struct Preset {
    const char* name;
    Scene (*scene)();
    bool bag = false; ///< nobody is plugged in yet
};
constexpr Preset presets[] = {{"demo", demo},
                              {"trouble", trouble},
                              {"modbus", modbus},
                              {"lx", lx},
                              {"sweep", sweep},
                              {"line", line, true},
                              {"line-trouble", lineTrouble, true}};
base::Result<void> addToAll(Scene& scene, const QStringList& words)
{
    for (ServoRecipe& recipe : scene) {
        if (auto added = addDefects(recipe, words); !added)
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
    Scene scene = preset->scene();
    if (auto added = addToAll(scene, words); !added)
        return tl::unexpected(added.error());
    for (ServoRecipe& recipe : scene)
        recipe.baud = baud.has_value() ? baud : recipe.baud;
    auto bus = makeBus(scene, catalog, wire, epromTime);
    if (bus && preset->bag)
        (*bus)->makeBag();
    return bus;
}
} // namespace sim

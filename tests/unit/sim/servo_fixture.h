// SPDX-License-Identifier: GPL-3.0-or-later
// One simulated servo on a table, for the tests of this layer: made by model name, given the
// instructions of the protocol notes, observed through its own registers. Test thread only.
#pragma once

#include "catalog/catalog.h"
#include "sim/servo/virtual_servo.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>

namespace fixture {
using std::chrono::milliseconds;

inline QString key(const char* name)
{
    return QString::fromLatin1(name);
}

inline const catalog::Catalog& models()
{
    static const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    return catalog;
}

/// A firmware of each family; those of STS, SMS and SCS were seen.
inline catalog::ProfilePtr profileOf(const QString& modelName)
{
    struct Firmware {
        const char* series;
        int major;
        int minor;
    };
    constexpr Firmware firmwares[] = {
        {"STS", 3, 10}, {"SMS", 2, 48},  {"SCS", 0, 4},    {"HLS", 3, 46},
        {"SMCL", 1, 6}, {"SCS2", 3, 24}, {"SMSMB", 20, 9}, {"LX", -1, -1},
    };
    const catalog::ModelEntry* entry = models().model(modelName);
    for (const Firmware& firmware : firmwares) {
        if (entry != nullptr && entry->series == QLatin1String(firmware.series)) {
            return models().profileFor(*entry, firmware.major, firmware.minor);
        }
    }
    qFatal("no model %s", qPrintable(modelName));
}

inline sim::ServoConfig configOf(const QString& modelName)
{
    sim::ServoConfig config;
    if (modelName.startsWith(QLatin1String("LX"))) {
        config.environment.supplyVolts = modelName.endsWith(QLatin1String("HV")) ? 11.1 : 7.4;
        config.initialDegrees = 120;
    } else if (modelName.startsWith(QLatin1String("SM")) || modelName == QLatin1String("STS3250")) {
        config.environment.supplyVolts = 12.0;
    } else if (modelName.startsWith(QLatin1String("SCS"))) {
        config.environment.supplyVolts = 6.0;
    }
    return config;
}

class Servo : public sim::VirtualServo {
public:
    explicit Servo(const QString& model)
        : Servo(model, configOf(model))
    {}
    Servo(const QString& model, const sim::ServoConfig& config)
        : VirtualServo(profileOf(model), config)
    {}

    std::optional<sim::ServoReply> ask(std::uint8_t instruction,
                                       std::initializer_list<std::uint8_t> params = {})
    {
        return handle({false, instruction, base::Bytes(params), -1});
    }
    std::optional<sim::ServoReply> sendBroadcast(std::uint8_t instruction,
                                                 std::initializer_list<std::uint8_t> params = {})
    {
        return handle({true, instruction, base::Bytes(params), -1});
    }
    std::optional<sim::ServoReply> write(std::initializer_list<std::uint8_t> params)
    {
        return ask(0x03, params);
    }
    base::Bytes read(std::uint8_t address, std::uint8_t count)
    {
        const auto answer = ask(0x02, {address, count});
        return answer ? answer->data : base::Bytes{};
    }
    int at(const char* name) const { return int(raw(key(name))); }
    void set(const char* name, int value) { poke(key(name), value); }
    std::uint8_t lockAddress() const
    {
        return std::uint8_t(profile().byRole(catalog::Role::Lock)->address);
    }
    /// A correct EPROM write: unlock, write, lock.
    void keep(const char* name, int value)
    {
        set("lock", 0);
        set(name, value);
        set("lock", 1);
    }
    void powerCycle()
    {
        powerOff();
        run(20);
        powerOn();
    }
    void run(int ms)
    {
        for (int i = 0; i < ms; ++i) {
            step(milliseconds(1));
        }
    }
    /// Runs and hands every millisecond to `look`.
    template <typename Look>
    void run(int ms, Look&& look)
    {
        for (int i = 0; i < ms; ++i) {
            step(milliseconds(1));
            look();
        }
    }
    /// The true position of the shaft in steps of the sensor, independent of what the servo
    /// reports.
    double shaftSteps() const { return shaftDegrees() / 360.0 * 4096.0; }
};
} // namespace fixture

// SPDX-License-Identifier: GPL-3.0-or-later
// Random valid tables for servos of every family, and what a simulated servo really holds. For the
// tests of restoring; one thread.
#pragma once

#include "catalog/raw_range.h"
#include "device/persistence.h"
#include "device/reader.h"
#include "jobs/restore/restore_rows.h"
#include "support/sim_fixture.h"

#include <map>
#include <random>

namespace support {
struct Family {
    const char* name;
    const char* servos;
    int baud;
};

inline constexpr std::array restoreFamilies{
    Family{"STS", "sts3215@1", 1'000'000},  Family{"SMS", "sm40blhv@1", 115'200},
    Family{"SCS", "scs15@1", 1'000'000},    Family{"HLS", "hls3606@1", 1'000'000},
    Family{"SMCL", "sm60-360m@1", 115'200}, Family{"SCS-2", "scs15-2@1", 1'000'000},
    Family{"Modbus", "smsmb@1", 115'200},   Family{"LX", "lx16a@1", 115'200},
};

inline SimFixtureOptions atBaud(int baud)
{
    SimFixtureOptions options;
    options.baud = baud;
    return options;
}

/// Whoever answers, with its whole table read.
inline device::Servo identifyWithTable(SimFixture& fixture, int id = 1)
{
    const std::vector<base::Protocol> all(base::allProtocols.begin(), base::allProtocols.end());
    auto found = device::identifyAmong(fixture.context(), id, all);
    if (!found || !device::readAll(fixture.context(), *found))
        qFatal("servo %d does not answer", id);
    return *found;
}

using TableValues = std::map<QString, std::int64_t>;

/// What a restore may bring back: writable, not of the moment, not lost at power-off.
inline bool isRestorable(const catalog::Register& reg)
{
    const auto nature = jobs::registerReasons(reg);
    return reg.writable() && !nature.testFlag(jobs::RestoreReason::Live) &&
           !nature.testFlag(jobs::RestoreReason::OptIn) && !reg.identity;
}

inline TableValues held(SimFixture& fixture, int id = 1)
{
    return fixture.withBus([&](sim::VirtualBus& wire) {
        TableValues values;
        sim::VirtualServo& servo = *wire.servo(id);
        for (const catalog::Register& reg : servo.profile().registers) {
            if (isRestorable(reg))
                values[reg.key] = servo.raw(reg.key);
        }
        return values;
    });
}

/// As after a write with the lock open: it survives a power-off.
inline void pokePersistent(SimFixture& fixture, const QString& key, std::int64_t raw, int id = 1)
{
    const catalog::Profile profile =
        fixture.withBus([&](sim::VirtualBus& wire) { return wire.servo(id)->profile(); });
    const catalog::Register* lock = profile.byRole(catalog::Role::Lock);
    if (lock != nullptr)
        fixture.poke(id, lock->key, device::unlockValue(profile.find(key)->area));
    fixture.poke(id, key, raw);
    if (lock != nullptr)
        fixture.poke(id, lock->key, device::lockClosed);
}

inline void pokeAllPersistent(SimFixture& fixture, const TableValues& values, int id = 1)
{
    for (const auto& [key, raw] : values)
        pokePersistent(fixture, key, raw, id);
}

inline bool isLockOpen(SimFixture& fixture, int id = 1)
{
    return fixture.withBus([&](sim::VirtualBus& wire) {
        sim::VirtualServo& servo = *wire.servo(id);
        const catalog::Register* lock = servo.profile().byRole(catalog::Role::Lock);
        return lock != nullptr && servo.raw(lock->key) != 1;
    });
}

class RandomTable {
public:
    explicit RandomTable(unsigned seed)
        : m_random(seed)
    {}

    TableValues make(const device::Servo& servo)
    {
        TableValues values;
        for (const catalog::Register& reg : servo.profile->registers) {
            if (isRestorable(reg))
                values[reg.key] = valueFor(reg, servo.meaning(reg));
        }
        order(servo, values, catalog::Role::MinAngle, catalog::Role::MaxAngle);
        order(servo, values, catalog::Role::MinVoltage, catalog::Role::MaxVoltage);
        return values;
    }

private:
    std::int64_t between(std::int64_t low, std::int64_t high)
    {
        return std::uniform_int_distribution<std::int64_t>(low, high)(m_random);
    }

    std::int64_t valueFor(const catalog::Register& reg, const catalog::ValueFormat& meaning)
    {
        if (meaning.encoding == catalog::Encoding::Enum && !reg.values.empty()) {
            const auto which = between(0, std::int64_t(reg.values.size()) - 1);
            return reg.values[std::size_t(which)].value;
        }
        const auto range = catalog::representableRange(reg.size, meaning.encoding, meaning.signBit);
        return between(std::max(range.min, meaning.min.value_or(range.min)),
                       std::min(range.max, meaning.max.value_or(range.max)));
    }

    /// A lower limit below its upper one; now and then both 0, where that is a mode.
    void order(const device::Servo& servo, TableValues& values, catalog::Role min,
               catalog::Role max)
    {
        const catalog::Register* low = servo.profile->byRole(min);
        const catalog::Register* high = servo.profile->byRole(max);
        if (low == nullptr || high == nullptr || values.count(low->key) == 0)
            return;
        std::int64_t& a = values[low->key];
        std::int64_t& b = values[high->key];
        if (a > b)
            std::swap(a, b);
        const bool zeroIsMode =
            std::any_of(servo.profile->modes.begin(), servo.profile->modes.end(),
                        [](const catalog::Mode& mode) { return mode.limitsZero; });
        if (min == catalog::Role::MinAngle && zeroIsMode && between(0, 4) == 0)
            a = b = 0;
        else if (a == b)
            ++b, a -= b > high->max.value_or(b) ? 1 : 0, b -= b > high->max.value_or(b) ? 1 : 0;
    }

    std::mt19937 m_random;
};
} // namespace support

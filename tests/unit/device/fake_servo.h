// SPDX-License-Identifier: GPL-3.0-or-later
// A fake servo: a memory table that behaves as the sheet of its family states, without wire or
// physics. What it holds and what would survive a power-off are kept apart. Single thread.
#pragma once

#include "catalog/catalog.h"
#include "catalog/value.h"
#include "protocol/request.h"

#include <QtGlobal>

#include <map>

namespace fake {
using Table = std::map<int, std::uint8_t>;

inline const catalog::Catalog& models()
{
    static const catalog::Catalog catalog = catalog::Catalog::load().catalog;
    return catalog;
}

/// The families by the names the tests' rows use.
inline catalog::Identity identityOf(const QString& family)
{
    using base::Protocol;
    static const std::map<QString, catalog::Identity> identities{
        {QStringLiteral("STS"), {3, 10, 0, 9, 3}},
        {QStringLiteral("SMS"), {2, 48, 0, 8, 42}},
        {QStringLiteral("SCS"), {0, 15, 1, 5, 15}},
        {QStringLiteral("HLS"), {3, 43, 0, 10, 20}},
        {QStringLiteral("SMCL"), {1, 5, 0, 6, 8}},
        {QStringLiteral("SCS2"), {3, 20, 1, 9, 20}},
        {QStringLiteral("SMSMB"), {20, 8, -1, -1, -1, Protocol::Modbus}},
        {QStringLiteral("LX"), {-1, -1, -1, -1, -1, Protocol::Lx}},
    };
    return identities.at(family);
}

struct Servo {
    catalog::ProfilePtr profile;
    int id = 1;
    int baud = 115'200;
    std::uint8_t status = 0;       ///< error byte of its replies
    bool repliesStoredMove = true; ///< LX: answers command 8
    bool goalEnergizes = true;     ///< a goal switches torque on (Feetech, Modbus)
    bool baudNeedsRestart = false;
    int requestsUntilReady = 0;    ///< number of requests that are lost after a reboot
    std::map<int, int> exceptions; ///< Modbus: write offset → reason it is refused with
    Table now;
    Table kept;

    Servo(const QString& family, int withId)
        : profile(models().resolve(identityOf(family)))
    {
        const catalog::Identity& profileIdentity = profile->identity;
        for (const catalog::Register& reg : profile->registers)
            set(reg, reg.defaultRaw.value_or(0), true);
        const std::pair<catalog::Role, int> head[]{
            {catalog::Role::FirmwareMajor, profileIdentity.firmwareMajor},
            {catalog::Role::FirmwareMinor, profileIdentity.firmwareMinor},
            {catalog::Role::ByteOrder, profileIdentity.byteOrderFlag},
            {catalog::Role::ModelMajor, profileIdentity.modelMajor},
            {catalog::Role::ModelMinor, profileIdentity.modelMinor}};
        for (const auto& [role, value] : head) {
            if (const catalog::Register* reg = profile->byRole(role))
                set(*reg, value, true);
        }
        if (const catalog::Register* level = profile->byRole(catalog::Role::ResponseLevel))
            set(*level, 1, true);
        if (const catalog::Register* max = profile->byRole(catalog::Role::MaxAngle))
            set(*max, max->max.value_or(1000), true);
        id = withId;
        put(catalog::Role::Id, withId);
        if (const catalog::Register* rate = profile->byRole(catalog::Role::BaudRate)) {
            for (const catalog::NamedValue& value : rate->values) {
                if (value.key.toInt() == baud)
                    put(catalog::Role::BaudRate, value.value);
            }
        }
    }

    const catalog::Register& reg(const QString& key) const
    {
        const catalog::Register* found = profile->find(key);
        if (found == nullptr)
            qFatal("no register %s", qPrintable(key));
        return *found;
    }
    catalog::ValueFormat meaning(const catalog::Register& reg) const
    {
        return catalog::valueFormat(reg, *profile, [this](const QString& key) {
            const catalog::Register* other = profile->find(key);
            return other == nullptr ? std::nullopt
                                    : std::optional(catalog::decodeRaw(
                                          bytes(now, other->offset, other->size), *other,
                                          catalog::valueFormat(*other, *profile, catalog::noLookup),
                                          profile->byteOrder));
        });
    }
    std::int64_t raw(const QString& key) const { return rawIn(now, reg(key)); }
    std::int64_t persistentRaw(const QString& key) const { return rawIn(kept, reg(key)); }
    std::int64_t raw(catalog::Role role) const { return rawIn(now, *profile->byRole(role)); }
    bool has(catalog::Role role) const { return profile->byRole(role) != nullptr; }
    bool isLockClosed() const { return !has(catalog::Role::Lock) || raw(catalog::Role::Lock) == 1; }

    void poke(const QString& key, std::int64_t value) { set(reg(key), value, false); }
    /// As if it had been written and kept.
    void setPersistent(const QString& key, std::int64_t value) { set(reg(key), value, true); }

    void powerCycle()
    {
        now = kept;
        if (has(catalog::Role::TorqueLimit) && has(catalog::Role::MaxTorque))
            put(catalog::Role::TorqueLimit, raw(catalog::Role::MaxTorque)); // every start loads it
        id = static_cast<int>(raw(catalog::Role::Id));
        loadBaud();
    }

    base::Bytes read(int offset, int count) const { return bytes(now, offset, count); }

    /// A WRITE as it arrived.
    void write(int offset, const base::Bytes& data)
    {
        if (saved(offset, data))
            return;
        const int place = readPlace(offset);
        for (std::size_t i = 0; i < data.size(); ++i)
            now[place + static_cast<int>(i)] = data[i];
        for (const catalog::Register& one : profile->registers) {
            if (one.writable() && one.offset < place + static_cast<int>(data.size()) &&
                one.offset + one.size > place)
                take(one);
        }
    }

    /// The present position becomes the middle, and the difference the offset.
    void center()
    {
        const std::int64_t middle = profile->stepsPerTurn / 2;
        const catalog::Register& offset = *profile->byRole(catalog::Role::PositionOffset);
        const catalog::Register& present = *profile->byRole(catalog::Role::PresentPosition);
        set(offset, rawIn(now, present) - middle + rawIn(now, offset), isLockOpenFor(offset));
        set(present, middle, false);
    }

private:
    static base::Bytes bytes(const Table& table, int offset, int count)
    {
        base::Bytes found;
        for (int i = 0; i < count; ++i) {
            const auto cell = table.find(offset + i);
            found.push_back(cell == table.end() ? std::uint8_t{0} : cell->second);
        }
        return found;
    }
    std::int64_t rawIn(const Table& table, const catalog::Register& reg) const
    {
        return catalog::decodeRaw(bytes(table, reg.offset, reg.size), reg, meaning(reg),
                                  profile->byteOrder);
    }
    void set(const catalog::Register& reg, std::int64_t value, bool keep)
    {
        const base::Bytes wire = catalog::encodeRaw(value, reg, meaning(reg), profile->byteOrder);
        for (int i = 0; i < reg.size; ++i) {
            now[reg.offset + i] = wire[static_cast<std::size_t>(i)];
            if (keep)
                kept[reg.offset + i] = wire[static_cast<std::size_t>(i)];
        }
    }
    void put(catalog::Role role, std::int64_t value) { set(*profile->byRole(role), value, true); }

    /// LX commands write elsewhere than they read.
    int readPlace(int offset) const
    {
        for (const catalog::Register& one : profile->registers) {
            if (one.block && one.block->writeOffset == offset)
                return one.block->offset;
        }
        return profile->protocol == base::Protocol::Lx ? -1000 : offset;
    }
    bool saved(int offset, const base::Bytes& data)
    {
        for (const catalog::Register& one : profile->registers) {
            if (one.saveOffset == offset && data.empty()) {
                set(one, rawIn(now, one), true);
                return true;
            }
        }
        return false;
    }
    bool isLockOpenFor(const catalog::Register& reg) const
    {
        if (!has(catalog::Role::Lock))
            return false;
        const std::int64_t lock = raw(catalog::Role::Lock);
        return lock == (reg.area == catalog::Area::Factory ? 128 : 0);
    }
    bool survives(const catalog::Register& reg) const
    {
        if (reg.persistence == catalog::Persistence::Kept)
            return true;
        const bool locked = reg.area == catalog::Area::Eprom || reg.area == catalog::Area::Factory;
        return reg.persistence == catalog::Persistence::ByArea && locked && isLockOpenFor(reg);
    }
    void loadBaud()
    {
        const catalog::Register* rate = profile->byRole(catalog::Role::BaudRate);
        if (rate == nullptr)
            return;
        for (const catalog::NamedValue& value : rate->values) {
            if (value.value == raw(catalog::Role::BaudRate))
                baud = value.key.toInt();
        }
    }
    void take(const catalog::Register& written)
    {
        using catalog::Role;
        if (survives(written))
            set(written, rawIn(now, written), true);
        switch (written.role) {
        case Role::Id:
            id = static_cast<int>(rawIn(now, written));
            break;
        case Role::BaudRate:
            if (!baudNeedsRestart)
                loadBaud();
            break;
        case Role::OperatingMode:
            if (profile->protocol == base::Protocol::Feetech)
                set(*profile->byRole(Role::TorqueSwitch), 0, false);
            break;
        case Role::GoalPosition:
            if (goalEnergizes && profile->protocol != base::Protocol::Lx)
                set(*profile->byRole(Role::TorqueSwitch), 1, false);
            break;
        case Role::FaultReset:
            if (rawIn(now, written) == 4)
                center();
            set(written, 0, false);
            break;
        default:
            break;
        }
    }
};
} // namespace fake

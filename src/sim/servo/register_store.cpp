// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/register_store.h"

#include "catalog/value.h"
#include "sim/servo/factory_values.h"

#include <algorithm>
#include <array>

namespace sim {
namespace {
using catalog::Role;

/// Registers that power-on loads from another register, where a family has both.
struct StartLoad {
    const char* to;
    const char* from;
};
constexpr StartLoad startLoads[] = {
    {"torque_limit", "max_torque"},           {"torque_limit", "torque_limit_default"},
    {"acceleration", "acceleration_default"}, {"goal_speed", "speed_default"},
    {"goal_current", "protection_current"},
};
constexpr StartLoad positionGains[] = {
    {"kp", "position_p"},
    {"kd", "position_d"},
    {"ki", "position_i"},
};
constexpr StartLoad speedGains[] = {
    {"kp", "speed_p"},
    {"kd", "position_d"},
    {"ki", "speed_i"},
};

template <std::size_t count>
void copyRegisters(const StartLoad (&loads)[count], const catalog::Profile& profile,
                   const RegisterMap& map, Memory& memory)
{
    for (const StartLoad& load : loads) {
        const Field from = fieldOf(profile, QString::fromLatin1(load.from));
        if (from.exists()) {
            map.put(memory, fieldOf(profile, QString::fromLatin1(load.to)), map.read(memory, from));
        }
    }
}

/// Whether the value can be stored at all. Ranges of plain numbers are the host's business.
bool isKnownValue(const catalog::Register& reg, int value)
{
    if (reg.role == Role::Id) {
        return value <= reg.max.value_or(253);
    }
    return reg.values.empty() ||
           std::any_of(reg.values.begin(), reg.values.end(),
                       [value](const catalog::NamedValue& named) { return named.value == value; });
}
} // namespace

RegisterStore::RegisterStore(const ServoModel& model, const ServoConfig& config)
    : m_model(model)
    , m_map(*model.profile)
    , m_secondaryId(fieldOf(*model.profile, QStringLiteral("secondary_id")))
    , m_memory(*model.profile)
{
    fillFactoryValues(m_memory, model, config);
}

std::optional<int> RegisterStore::baudRate() const
{
    const catalog::Register* codes = m_model.profile->byRole(Role::BaudRate);
    if (codes == nullptr) {
        return std::nullopt;
    }
    const int code = read(Role::BaudRate);
    for (const catalog::NamedValue& value : codes->values) {
        if (value.value == code) {
            return value.key.toInt();
        }
    }
    return std::nullopt;
}

std::int64_t RegisterStore::raw(const catalog::Register& reg) const
{
    const auto format = catalog::valueFormat(reg, *m_model.profile,
                                             [this](const QString& other) { return rawOf(other); });
    return catalog::decodeRaw(m_memory.view(reg.offset, reg.size), reg, format,
                              m_model.profile->byteOrder);
}

/// 0 for a register that the model does not have.
std::optional<std::int64_t> RegisterStore::rawOf(const QString& key) const
{
    const catalog::Register* reg = m_model.profile->find(key);
    return reg == nullptr ? 0 : raw(*reg);
}

base::Bytes RegisterStore::encode(const catalog::Register& reg, std::int64_t raw) const
{
    const auto format = catalog::valueFormat(reg, *m_model.profile,
                                             [this](const QString& other) { return rawOf(other); });
    return catalog::encodeRaw(raw, reg, format, m_model.profile->byteOrder);
}

int RegisterStore::write(int address, base::ByteView data)
{
    const base::Bytes bytes = acceptedBytes(address, data);
    m_epromWritten = m_memory.write(address, bytes, m_settings.unlocked) || m_epromWritten;
    return int(bytes.size());
}

/// What a Feetech servo takes of a write. ID 254 is the broadcast address and "must never be
/// stored" (register sheets). No source states what a servo does with that ID, or with a rate or
/// mode that its sheet does not list. Chosen here: that byte keeps its value, and the write is
/// acknowledged all the same, because the error byte has no "rejected" (protocol notes, 2.2).
base::Bytes RegisterStore::acceptedBytes(int address, base::ByteView data) const
{
    base::Bytes bytes(data.begin(), data.end());
    if (m_model.profile->protocol != base::Protocol::Feetech) {
        return bytes;
    }
    for (const Role role : {Role::Id, Role::BaudRate, Role::OperatingMode}) {
        const catalog::Register* reg = m_model.profile->byRole(role);
        if (reg == nullptr || reg->offset < address || reg->offset >= address + int(data.size())) {
            continue;
        }
        std::uint8_t& byte = bytes[std::size_t(reg->offset - address)];
        byte = isKnownValue(*reg, byte) ? byte : m_memory.at(reg->offset);
    }
    return bytes;
}

void RegisterStore::save(int address, int count)
{
    m_epromWritten = m_memory.save(address, count) || m_epromWritten;
}

bool RegisterStore::restoreBackup()
{
    if (isLocked()) {
        return false;
    }
    m_memory.restore(field(Role::Id).address);
    m_epromWritten = true;
    return true;
}

void RegisterStore::makeBackup()
{
    if (!isLocked()) {
        m_memory.backup();
        m_epromWritten = true;
    }
}

/// HLS: writing the ID also sets the second one, which lasts as long as the ID itself.
void RegisterStore::copyIdToSecondary()
{
    if (m_secondaryId.exists()) {
        const std::array<std::uint8_t, 1> id{std::uint8_t(m_settings.id)};
        m_memory.write(m_secondaryId.address, id, m_settings.unlocked);
    }
}

void RegisterStore::setTorque(int value)
{
    m_settings.torqueSwitch = value;
    put(Role::TorqueSwitch, value);
}

void RegisterStore::reload()
{
    m_settings = readSettings(m_memory, m_map, *m_model.profile, m_model.traits, m_model.type);
}

void RegisterStore::loadGains()
{
    if (!m_model.traits.liveGains) {
        return;
    }
    if (m_settings.mode == DriveMode::Speed) {
        copyRegisters(speedGains, *m_model.profile, m_map, m_memory);
    } else {
        copyRegisters(positionGains, *m_model.profile, m_map, m_memory);
    }
}

void RegisterStore::setInitial(const catalog::Register& reg, std::int64_t raw)
{
    const base::Bytes bytes = encode(reg, raw);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        m_memory.setInitial(reg.offset + int(i), bytes[i]);
}

void RegisterStore::powerOn()
{
    m_memory.powerOn();
    // At full speed until the host sets another one, as a Feetech servo starts.
    if (!m_model.traits.lx) {
        reload();
        put(Role::GoalSpeed, m_settings.maxSpeed / m_settings.speedUnit);
    }
    copyRegisters(startLoads, *m_model.profile, m_map, m_memory);
    loadGains();
    reload();
}
} // namespace sim

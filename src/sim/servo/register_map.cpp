// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/register_map.h"

#include <algorithm>
#include <cstdlib>

namespace sim {
namespace {
constexpr int maxFieldSize = 2; ///< bytes

int decode(int word, const Field& field)
{
    if (field.twosComplement) {
        const int sign = 1 << (8 * field.size - 1);
        return (word ^ sign) - sign;
    }
    if (field.signBit < 0) {
        return word;
    }
    int magnitude = word & ((1 << field.signBit) - 1);
    if (field.extended && (word & 0x1000) != 0) {
        magnitude += 2048;
    }
    return (word >> field.signBit & 1) != 0 ? -magnitude : magnitude;
}

int encodeWord(int value, const Field& field)
{
    if (field.twosComplement) {
        const int sign = 1 << (8 * field.size - 1);
        return std::clamp(value, -sign, sign - 1) & (2 * sign - 1);
    }
    if (field.signBit < 0) {
        return std::clamp(value, 0, (1 << (8 * field.size)) - 1);
    }
    const int sign = value < 0 ? 1 << field.signBit : 0;
    if (field.extended) {
        const int magnitude = std::min(std::abs(value), 4095);
        return sign | (magnitude & 0x7FF) | (magnitude > 2047 ? 0x1000 : 0);
    }
    return sign | std::min(std::abs(value), (1 << field.signBit) - 1);
}
} // namespace

Field fieldOf(const catalog::Register& reg)
{
    Field field{reg.offset, reg.size};
    field.scale = reg.scale;
    if (reg.size > maxFieldSize || reg.offset + reg.size > Memory::size) {
        return {};
    }
    if (reg.encoding == catalog::Encoding::SignBit) {
        field.signBit = reg.signBit;
    } else if (reg.encoding == catalog::Encoding::SignBit11Ext12) {
        field.signBit = 11;
        field.extended = true;
    }
    field.twosComplement = reg.encoding == catalog::Encoding::TwosComplement;
    return field;
}

Field fieldOf(const catalog::Profile& profile, const QString& key)
{
    const catalog::Register* reg = profile.find(key);
    return reg == nullptr ? Field{} : fieldOf(*reg);
}

RegisterMap::RegisterMap(const catalog::Profile& profile)
    : m_order(profile.byteOrder)
{
    for (const catalog::Register& reg : profile.registers) {
        if (reg.role != catalog::Role::None) {
            m_fields[std::size_t(reg.role)] = fieldOf(reg);
        }
    }
}

int RegisterMap::read(const Memory& memory, const Field& field) const
{
    if (field.size == 1) {
        return decode(memory.at(field.address), field);
    }
    const int first = memory.at(field.address);
    const int second = memory.at(field.address + 1);
    return decode(m_order == base::ByteOrder::Little ? first | second << 8 : first << 8 | second,
                  field);
}

int RegisterMap::read(const Memory& memory, catalog::Role role, int fallback) const
{
    return at(role).exists() ? read(memory, at(role)) : fallback;
}

double RegisterMap::physical(const Memory& memory, catalog::Role role, double fallback) const
{
    return at(role).exists() ? read(memory, at(role)) * at(role).scale : fallback;
}

base::Bytes RegisterMap::encode(catalog::Role role, int value) const
{
    const Field& field = at(role);
    return base::writeUnsigned(std::uint64_t(encodeWord(value, field)), std::size_t(field.size),
                               m_order);
}

void RegisterMap::put(Memory& memory, const Field& field, int value) const
{
    if (!field.exists()) {
        return;
    }
    const int word = encodeWord(value, field);
    const bool little = m_order == base::ByteOrder::Little;
    for (int i = 0; i < field.size; ++i) {
        const int shift = 8 * (little ? i : field.size - 1 - i);
        memory.set(field.address + i, std::uint8_t(word >> shift));
    }
}
} // namespace sim

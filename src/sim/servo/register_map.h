// SPDX-License-Identifier: GPL-3.0-or-later
// Where the registers of a servo lie, by role, resolved once so that nothing is looked up by name
// while the servo runs. Immutable; its servo's thread. Numbers are signed as the register is.
#pragma once

#include "sim/servo/memory.h"

#include <array>

namespace sim {
struct Field {
    int address = -1; ///< -1: this family has no such register
    int size = 0;
    int signBit = -1;            ///< -1: no sign bit
    bool extended = false;       ///< newer STS offset: bit 12 adds 2048 to the magnitude
    bool twosComplement = false; ///< Modbus, LX
    double scale = 1;            ///< of one raw step, in the unit of the sheet
    bool exists() const { return address >= 0; }
    bool overlaps(int from, int count) const
    {
        return exists() && address < from + count && from < address + size;
    }
};

class RegisterMap {
public:
    explicit RegisterMap(const catalog::Profile& profile);

    const Field& at(catalog::Role role) const { return m_fields[std::size_t(role)]; }

    /// `fallback` where the family has no such register.
    int read(const Memory& memory, catalog::Role role, int fallback = 0) const;
    int read(const Memory& memory, const Field& field) const;
    /// In the unit of the sheet.
    double physical(const Memory& memory, catalog::Role role, double fallback = 0) const;

    /// Wire bytes of a value; a magnitude that does not fit is limited to the largest that does.
    base::Bytes encode(catalog::Role role, int value) const;
    /// The servo itself changes a register of RAM or feedback; nothing where it does not exist.
    void put(Memory& memory, catalog::Role role, int value) const { put(memory, at(role), value); }
    void put(Memory& memory, const Field& field, int value) const;

private:
    std::array<Field, 256> m_fields{}; ///< by role
    base::ByteOrder m_order;
};

/// Of any register, for those that have no role.
Field fieldOf(const catalog::Register& reg);
Field fieldOf(const catalog::Profile& profile, const QString& key);
} // namespace sim

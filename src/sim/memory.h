// SPDX-License-Identifier: GPL-3.0-or-later
// The servo's memory table as bytes: what acts now, what the EPROM holds, and the copy that 0x06
// brings back. Knows which addresses exist, not what they mean. Owned by one servo; its thread.
// Writes to read-only and undefined addresses are lost silently; undefined bytes read 0.
#pragma once

#include "base/bytes.h"
#include "catalog/profile.h"

#include <array>

namespace sim {
class Memory {
public:
    static constexpr int size = 256;

    explicit Memory(const catalog::Profile& profile);

    std::uint8_t at(int address) const { return m_live[std::size_t(address)]; }
    base::ByteView view(int address, int count) const;

    /// As from outside. `keep`: the lock is open, so EPROM bytes are stored as well. True when an
    /// EPROM cell was written.
    bool write(int address, base::ByteView data, bool keep);

    /// The servo itself sets a byte of RAM or feedback.
    void set(int address, std::uint8_t value) { m_live[std::size_t(address)] = value; }
    /// What a byte is after power-on (RAM) or leaves the factory with (EPROM, its back-up too).
    void setInitial(int address, std::uint8_t value);

    void powerOn();
    void backup() { m_backup = m_stored; }
    /// Everything but the byte at `keepAddress` becomes what backup() stored.
    void restore(int keepAddress);

    /// EPROM and back-up as one versioned block; a block of another size, version or model is
    /// refused.
    base::Bytes image() const;
    bool setImage(base::ByteView image);

private:
    enum class Kind : std::uint8_t { Undefined, ReadOnly, Sram, Eprom, EpromReadOnly };
    bool isEprom(std::size_t address) const { return m_kinds[address] >= Kind::Eprom; }

    std::array<Kind, size> m_kinds{};
    std::array<std::uint8_t, size> m_live{};
    std::array<std::uint8_t, size> m_stored{}; ///< EPROM cells; RAM: the value after power-on
    std::array<std::uint8_t, size> m_backup{};
    std::size_t m_epromSize = 0; ///< EPROM lies below this address
};
} // namespace sim

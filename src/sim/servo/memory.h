// SPDX-License-Identifier: GPL-3.0-or-later
// The servo's memory table as bytes: what acts now, what survives power-off, and the copy that 0x06
// brings back. Knows which bytes exist and how long each lasts, not what they mean. Offsets are
// those of catalog::Register. Owned by one servo; its thread. Writes to read-only and undefined
// bytes are lost silently; undefined bytes read 0.
#pragma once

#include "base/bytes.h"
#include "catalog/profile.h"

#include <array>

namespace sim {
/// The area in which a write survives power-off, as the lock register allows.
enum class UnlockedArea : std::uint8_t { Nothing, Eprom, Factory };

class Memory {
public:
    static constexpr int size = 1024; ///< of the largest table; what is not mapped is undefined

    explicit Memory(const catalog::Profile& profile);

    std::uint8_t at(int address) const { return m_live[std::size_t(address)]; }
    base::ByteView view(int address, int count) const;

    bool isMapped(int address, int count) const; ///< every byte belongs to a register
    /// Also, a write from outside has an effect: no byte is read-only or behind the factory lock.
    bool writable(int address, int count, UnlockedArea unlocked) const;

    /// A write from outside. EPROM bytes always act, and survive power-off if they are unlocked;
    /// bytes of the factory block do neither while they are locked. True when something was stored.
    bool write(int address, base::ByteView data, UnlockedArea unlocked);
    /// Stores bytes that survive only by this command (the LX offset). True when there is one.
    bool save(int address, int count);

    /// The servo itself sets a byte of RAM or feedback.
    void set(int address, std::uint8_t value) { m_live[std::size_t(address)] = value; }
    /// The value of a byte after power-on (RAM), or from the factory (EPROM, its backup too).
    void setInitial(int address, std::uint8_t value);

    void powerOn();
    void backup() { m_backup = m_stored; }
    /// The EPROM becomes what backup() stored, except for the byte at `keepAddress`.
    void restore(int keepAddress);

    /// Everything that survives, and its backup, as one versioned block; a block of another size,
    /// version or model is refused.
    base::Bytes image() const;
    bool setImage(base::ByteView image);

private:
    enum class Kind : std::uint8_t {
        Undefined,
        ReadOnly,
        Volatile,
        Persistent, ///< by every write
        Saved,      ///< by save()
        Factory,    ///< under a lock of its own
        Eprom,
        EpromReadOnly,
        FirmwareVersion, ///< read-only as well, but an update replaces it
    };
    static Kind kindOf(const catalog::Register& reg);
    static bool isReadOnly(Kind kind)
    {
        return kind == Kind::ReadOnly || kind >= Kind::EpromReadOnly;
    }
    bool isPersistent(std::size_t address) const { return m_kinds[address] >= Kind::Persistent; }
    bool isEprom(std::size_t address) const { return m_kinds[address] >= Kind::Eprom; }

    std::array<Kind, size> m_kinds{};
    std::array<std::uint8_t, size> m_live{};
    std::array<std::uint8_t, size> m_stored{}; ///< what survives; the rest: its value at power-on
    std::array<std::uint8_t, size> m_backup{};
    std::vector<std::size_t> m_persistent; ///< addresses of what the image holds
};
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
// What a servo remembers: its memory table with the lock, what a power-on loads into it, and the
// settings decoded from it. It stores and decodes; what a new value sets in motion is decided by
// ServoFirmware. Owned by a ServoFirmware; one thread. Nothing here can fail: a write that the
// table does not allow is lost silently.
#pragma once

#include "sim/servo/settings.h"

namespace sim {
struct ServoConfig;

class RegisterStore {
public:
    /// With factory values; `model` must outlive the store. Call powerOn() before use.
    RegisterStore(const ServoModel& model, const ServoConfig& config);

    const Settings& settings() const { return m_settings; }
    const Memory& memory() const { return m_memory; }
    const Field& field(catalog::Role role) const { return m_map.at(role); }
    /// Of a register that exists.
    int read(const Field& field) const { return m_map.read(m_memory, field); }
    int read(catalog::Role role) const { return m_map.read(m_memory, role); }
    const Field& secondaryId() const { return m_secondaryId; } ///< exists in HLS only
    /// The rate that the baud register names; nullopt: it names none, or there is no such register.
    std::optional<int> baudRate() const;

    std::int64_t raw(const catalog::Register& reg) const;
    base::Bytes encode(const catalog::Register& reg, std::int64_t raw) const;
    base::Bytes encode(catalog::Role role, int value) const { return m_map.encode(role, value); }

    /// A write from outside, under the lock as it stands. Returns the number of bytes. The settings
    /// follow with the next reload().
    int write(int address, base::ByteView data);
    void save(int address, int count); ///< LX: keeps what acts only until power-off otherwise
    bool restoreBackup();              ///< false: the lock is closed, nothing happened
    void makeBackup();                 ///< nothing while the lock is closed
    void copyIdToSecondary();

    /// The servo itself changes a register; nothing where its family has none.
    void put(catalog::Role role, int value) { m_map.put(m_memory, role, value); }
    void setInitial(const catalog::Register& reg, std::int64_t raw); ///< another factory value
    void setTorque(int value);                                       ///< register and setting
    void reload();                                                   ///< decodes the settings again
    void loadGains(); ///< HLS: those of the present mode become the acting ones

    void powerOn();                                  ///< what survives, with its defaults
    void powerOff() { m_settings.torqueSwitch = 0; } ///< the registers stay readable

    bool epromWritten() const { return m_epromWritten; } ///< since the last clearEpromWritten()
    void clearEpromWritten() { m_epromWritten = false; }

    base::Bytes epromImage() const { return m_memory.image(); }
    bool setEpromImage(base::ByteView image) { return m_memory.setImage(image); }

private:
    std::optional<std::int64_t> rawOf(const QString& key) const;
    base::Bytes acceptedBytes(int address, base::ByteView data) const;
    bool isLocked() const { return m_settings.unlocked == UnlockedArea::Nothing; }

    const ServoModel& m_model;
    RegisterMap m_map;
    Field m_secondaryId;
    Memory m_memory;
    Settings m_settings;
    bool m_epromWritten = false;
};
} // namespace sim

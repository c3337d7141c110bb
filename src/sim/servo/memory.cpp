// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/memory.h"

#include <algorithm>

namespace sim {
namespace {
constexpr std::array<std::uint8_t, 4> imageMagic{'S', 'D', 'E', 2}; // last: version
constexpr std::size_t countBytes = 2;
} // namespace

/// Where the sheet does not state whether a value survives, its area decides.
Memory::Kind Memory::kindOf(const catalog::Register& reg)
{
    using catalog::Persistence;
    if (!reg.writable() && reg.eprom())
        return reg.role == catalog::Role::FirmwareMajor || reg.role == catalog::Role::FirmwareMinor
                   ? Kind::FirmwareVersion
                   : Kind::EpromReadOnly;
    if (!reg.writable())
        return Kind::ReadOnly;
    switch (reg.persistence) {
    case Persistence::Kept:
        return Kind::Persistent;
    case Persistence::AfterSave:
        return Kind::Saved;
    case Persistence::Lost:
        return Kind::Volatile;
    case Persistence::NotStated:
        return reg.eprom() ? Kind::Persistent : Kind::Volatile;
    case Persistence::ByArea:
        break;
    }
    if (reg.area == catalog::Area::Factory)
        return Kind::Factory;
    return reg.eprom() ? Kind::Eprom : Kind::Volatile;
}

Memory::Memory(const catalog::Profile& profile)
{
    for (const catalog::Register& reg : profile.registers) {
        for (int i = reg.offset; i < std::min(size, reg.offset + reg.size); ++i)
            m_kinds[std::size_t(i)] = kindOf(reg);
    }
    for (std::size_t i = 0; i < m_kinds.size(); ++i) {
        if (isPersistent(i))
            m_persistent.push_back(i);
    }
}

base::ByteView Memory::view(int address, int count) const
{
    return base::ByteView(m_live).subspan(std::size_t(address), std::size_t(count));
}

bool Memory::isMapped(int address, int count) const
{
    if (address < 0 || count < 0 || address + count > size)
        return false;
    const auto first = m_kinds.begin() + address;
    return std::none_of(first, first + count, [](Kind kind) { return kind == Kind::Undefined; });
}

bool Memory::writable(int address, int count, UnlockedArea unlocked) const
{
    if (!isMapped(address, count))
        return false;
    const auto first = m_kinds.begin() + address;
    return std::none_of(first, first + count, [unlocked](Kind kind) {
        return isReadOnly(kind) || (kind == Kind::Factory && unlocked != UnlockedArea::Factory);
    });
}

bool Memory::write(int address, base::ByteView data, UnlockedArea unlocked)
{
    bool stored = false;
    for (std::size_t i = 0; i < data.size(); ++i) {
        const std::size_t index = std::size_t(address) + i;
        if (index >= m_live.size())
            break;
        const Kind kind = m_kinds[index];
        const bool isLocked = kind == Kind::Factory && unlocked != UnlockedArea::Factory;
        if (isLocked || kind < Kind::Volatile || isReadOnly(kind))
            continue;
        m_live[index] = data[i];
        const bool persists = kind == Kind::Persistent || kind == Kind::Factory ||
                              (kind == Kind::Eprom && unlocked == UnlockedArea::Eprom);
        if (persists) {
            m_stored[index] = data[i];
            stored = true;
        }
    }
    return stored;
}

bool Memory::save(int address, int count)
{
    bool stored = false;
    for (auto i = std::size_t(address); i < std::size_t(address) + std::size_t(count); ++i) {
        if (m_kinds[i] == Kind::Saved) {
            m_stored[i] = m_live[i];
            stored = true;
        }
    }
    return stored;
}

void Memory::setInitial(int address, std::uint8_t value)
{
    const std::size_t index = std::size_t(address);
    m_live[index] = m_stored[index] = value;
    if (isPersistent(index)) {
        m_backup[index] = value;
    }
}

void Memory::powerOn()
{
    m_live = m_stored;
}

void Memory::restore(int keepAddress)
{
    for (const std::size_t i : m_persistent) {
        if (isEprom(i) && int(i) != keepAddress) {
            m_live[i] = m_stored[i] = m_backup[i];
        }
    }
}

base::Bytes Memory::image() const
{
    base::Bytes image(imageMagic.begin(), imageMagic.end());
    const std::size_t count = m_persistent.size();
    image.push_back(std::uint8_t(count & 0xFF));
    image.push_back(std::uint8_t(count >> 8));
    for (const auto* cells : {&m_stored, &m_backup}) {
        for (const std::size_t i : m_persistent)
            image.push_back((*cells)[i]);
    }
    return image;
}

/// The read-only part except the firmware version must be the same: the servo's identity.
bool Memory::setImage(base::ByteView image)
{
    const std::size_t head = imageMagic.size() + countBytes;
    const std::size_t count = m_persistent.size();
    if (image.size() != head + 2 * count ||
        !std::equal(image.begin(), image.begin() + 4, imageMagic.begin()) ||
        std::size_t(image[4] | image[5] << 8) != count)
        return false;
    const base::ByteView stored = image.subspan(head, count);
    const base::ByteView backup = image.subspan(head + count, count);
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t index = m_persistent[n];
        if (m_kinds[index] == Kind::EpromReadOnly && stored[n] != m_stored[index])
            return false;
    }
    for (std::size_t n = 0; n < count; ++n) {
        m_stored[m_persistent[n]] = stored[n];
        m_backup[m_persistent[n]] = backup[n];
    }
    m_live = m_stored;
    return true;
}
} // namespace sim

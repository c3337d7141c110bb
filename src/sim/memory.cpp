// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/memory.h"

#include <algorithm>

namespace sim {
namespace {
constexpr std::array<std::uint8_t, 4> imageMagic{'S', 'D', 'E', 1}; // last: version
constexpr std::size_t modelPair = 3;                                // addresses 3 and 4
} // namespace

Memory::Memory(const catalog::Profile& profile)
{
    for (const catalog::Register& reg : profile.registers) {
        const bool eprom = reg.eprom();
        const Kind kind = reg.writable() ? (eprom ? Kind::Eprom : Kind::Sram)
                                         : (eprom ? Kind::EpromReadOnly : Kind::ReadOnly);
        for (int i = reg.offset; i < std::min(size, reg.offset + reg.size); ++i) {
            m_kinds[std::size_t(i)] = kind;
            if (eprom) {
                m_epromSize = std::max(m_epromSize, std::size_t(i) + 1);
            }
        }
    }
}

base::ByteView Memory::view(int address, int count) const
{
    return base::ByteView(m_live).subspan(std::size_t(address), std::size_t(count));
}

bool Memory::write(int address, base::ByteView data, bool keep)
{
    bool eprom = false;
    for (std::size_t i = 0; i < data.size(); ++i) {
        const std::size_t place = std::size_t(address) + i;
        if (place >= m_live.size()) {
            break;
        }
        if (m_kinds[place] == Kind::Sram) {
            m_live[place] = data[i];
        } else if (m_kinds[place] == Kind::Eprom) {
            m_live[place] = data[i];
            eprom = true;
            if (keep) {
                m_stored[place] = data[i];
            }
        }
    }
    return eprom;
}

void Memory::setInitial(int address, std::uint8_t value)
{
    const std::size_t place = std::size_t(address);
    m_live[place] = m_stored[place] = value;
    if (isEprom(place)) {
        m_backup[place] = value;
    }
}

void Memory::powerOn()
{
    m_live = m_stored;
}

void Memory::restore(int keepAddress)
{
    for (std::size_t i = 0; i < m_epromSize; ++i) {
        if (isEprom(i) && int(i) != keepAddress) {
            m_live[i] = m_stored[i] = m_backup[i];
        }
    }
}

base::Bytes Memory::image() const
{
    base::Bytes image(imageMagic.begin(), imageMagic.end());
    image.push_back(std::uint8_t(m_epromSize));
    image.insert(image.end(), m_stored.begin(), m_stored.begin() + std::ptrdiff_t(m_epromSize));
    image.insert(image.end(), m_backup.begin(), m_backup.begin() + std::ptrdiff_t(m_epromSize));
    return image;
}

bool Memory::setImage(base::ByteView image)
{
    const std::size_t head = imageMagic.size() + 1;
    if (image.size() != head + 2 * m_epromSize || image[imageMagic.size()] != m_epromSize ||
        !std::equal(imageMagic.begin(), imageMagic.end(), image.begin())) {
        return false;
    }
    const base::ByteView stored = image.subspan(head, m_epromSize);
    const base::ByteView backup = image.subspan(head + m_epromSize, m_epromSize);
    if (stored[modelPair] != m_stored[modelPair] ||
        stored[modelPair + 1] != m_stored[modelPair + 1]) {
        return false;
    }
    for (std::size_t i = 0; i < m_epromSize; ++i) {
        if (isEprom(i)) {
            m_stored[i] = stored[i];
            m_backup[i] = backup[i];
        }
    }
    m_live = m_stored;
    return true;
}
} // namespace sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/image.h"

#include <algorithm>

namespace device {
void Image::store(int address, base::ByteView bytes, base::Duration at)
{
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t place = static_cast<std::size_t>(address) + i;
        if (place >= tableSize)
            return;
        m_bytes[place] = bytes[i];
        m_at[place] = at.count() + 1;
    }
}

void Image::forget(int address, int count)
{
    for (int i = 0; i < count; ++i) {
        const std::size_t place = static_cast<std::size_t>(address + i);
        if (place < tableSize)
            m_at[place] = 0;
    }
}

void Image::clear()
{
    m_at.fill(0);
}

std::optional<base::Bytes> Image::bytes(int address, int count) const
{
    base::Bytes result;
    for (int i = 0; i < count; ++i) {
        const std::size_t place = static_cast<std::size_t>(address + i);
        if (place >= tableSize || m_at[place] == 0)
            return std::nullopt;
        result.push_back(m_bytes[place]);
    }
    return result;
}

std::optional<base::Duration> Image::readAt(int address) const
{
    const std::size_t place = static_cast<std::size_t>(address);
    if (place >= tableSize || m_at[place] == 0)
        return std::nullopt;
    return base::Duration(m_at[place] - 1);
}
} // namespace device

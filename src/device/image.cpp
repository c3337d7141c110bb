// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/image.h"

#include <algorithm>

namespace device {
void Image::store(int offset, base::ByteView bytes, base::Duration at)
{
    const auto first = static_cast<std::size_t>(std::max(offset, 0));
    if (m_cells.size() < first + bytes.size())
        m_cells.resize(first + bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        Cell& place = m_cells[first + i];
        if (place.at <= at)
            place = {bytes[i], true, at};
    }
}

void Image::forget(int offset, int count)
{
    forget(offset, count, {});
}

void Image::forget(int offset, int count, base::Duration readUntil)
{
    const auto first = static_cast<std::size_t>(std::max(offset, 0));
    const auto end = std::min(first + static_cast<std::size_t>(std::max(count, 0)), m_cells.size());
    for (std::size_t place = first; place < end; ++place)
        m_cells[place] = {0, false, readUntil};
}

void Image::clear()
{
    m_cells.clear();
}

void Image::takeNewer(const Image& other, base::Duration since)
{
    if (m_cells.size() < other.m_cells.size())
        m_cells.resize(other.m_cells.size());
    for (std::size_t place = 0; place < other.m_cells.size(); ++place) {
        const Cell& theirs = other.m_cells[place];
        Cell& mine = m_cells[place];
        const bool newer = mine.read ? mine.at < theirs.at : mine.at <= theirs.at;
        if (theirs.read && theirs.at >= since && newer)
            mine = theirs;
    }
}

void Image::takeMissing(const Image& other)
{
    if (m_cells.size() < other.m_cells.size())
        m_cells.resize(other.m_cells.size());
    for (std::size_t place = 0; place < other.m_cells.size(); ++place) {
        if (!m_cells[place].read)
            m_cells[place] = other.m_cells[place];
    }
}

const Image::Cell* Image::cell(int offset) const
{
    const auto place = static_cast<std::size_t>(std::max(offset, 0));
    return place < m_cells.size() && m_cells[place].read ? &m_cells[place] : nullptr;
}

std::optional<base::Bytes> Image::bytes(int offset, int count) const
{
    base::Bytes result;
    for (int i = 0; i < count; ++i) {
        const Cell* known = cell(offset + i);
        if (known == nullptr)
            return std::nullopt;
        result.push_back(known->value);
    }
    return result;
}

std::optional<base::Duration> Image::readAt(int offset) const
{
    const Cell* known = cell(offset);
    return known != nullptr ? std::optional(known->at) : std::nullopt;
}
} // namespace device

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
        Cell& index = m_cells[first + i];
        if (index.at <= at)
            index = {bytes[i], true, at};
    }
}

void Image::invalidate(int offset, int count)
{
    invalidate(offset, count, {});
}

void Image::invalidate(int offset, int count, base::Duration readUntil)
{
    const auto first = static_cast<std::size_t>(std::max(offset, 0));
    const auto end = std::min(first + static_cast<std::size_t>(std::max(count, 0)), m_cells.size());
    for (std::size_t index = first; index < end; ++index)
        m_cells[index] = {0, false, readUntil};
}

void Image::clear()
{
    m_cells.clear();
}

void Image::mergeNewer(const Image& other, base::Duration since)
{
    if (m_cells.size() < other.m_cells.size())
        m_cells.resize(other.m_cells.size());
    for (std::size_t index = 0; index < other.m_cells.size(); ++index) {
        const Cell& theirs = other.m_cells[index];
        Cell& mine = m_cells[index];
        const bool newer = mine.read ? mine.at < theirs.at : mine.at <= theirs.at;
        if (theirs.read && theirs.at >= since && newer)
            mine = theirs;
    }
}

void Image::mergeMissing(const Image& other)
{
    if (m_cells.size() < other.m_cells.size())
        m_cells.resize(other.m_cells.size());
    for (std::size_t index = 0; index < other.m_cells.size(); ++index) {
        if (!m_cells[index].read)
            m_cells[index] = other.m_cells[index];
    }
}

const Image::Cell* Image::cell(int offset) const
{
    const auto index = static_cast<std::size_t>(std::max(offset, 0));
    return index < m_cells.size() && m_cells[index].read ? &m_cells[index] : nullptr;
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

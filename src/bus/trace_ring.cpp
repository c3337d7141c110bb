// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/trace_ring.h"

#include <QByteArray>

namespace bus {
TraceRing::TraceRing(std::size_t capacity)
    : m_capacity(capacity)
{}

void TraceRing::setProtocol(base::Protocol protocol)
{
    const std::lock_guard lock(m_mutex);
    m_protocol = protocol;
}

void TraceRing::add(base::Duration at, TraceKind kind, base::ByteView bytes)
{
    const std::lock_guard lock(m_mutex);
    if (m_slots.size() < m_capacity && m_count == m_slots.size())
        m_slots.emplace_back();
    if (m_count == m_slots.size()) {
        m_first = (m_first + 1) % m_slots.size();
        --m_count;
        ++m_dropped;
    }
    TraceEntry& slot = m_slots[(m_first + m_count) % m_slots.size()];
    ++m_count;
    slot.at = at;
    slot.kind = kind;
    slot.protocol = m_protocol;
    slot.bytes.assign(bytes.begin(), bytes.end());
}

void TraceRing::note(base::Duration at, const QString& text)
{
    const QByteArray ascii = text.toLatin1();
    add(at, TraceKind::Note,
        {reinterpret_cast<const std::uint8_t*>(ascii.constData()), std::size_t(ascii.size())});
}

std::vector<TraceEntry> TraceRing::take()
{
    std::vector<TraceEntry> entries;
    const std::lock_guard lock(m_mutex);
    entries.reserve(m_count);
    for (std::size_t i = 0; i < m_count; ++i)
        entries.push_back(std::move(m_slots[(m_first + i) % m_slots.size()]));
    if (!entries.empty())
        entries.front().dropped = m_dropped;
    m_slots.clear();
    m_first = 0;
    m_count = 0;
    m_dropped = 0;
    return entries;
}
} // namespace bus

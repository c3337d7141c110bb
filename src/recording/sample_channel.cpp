// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/sample_channel.h"

#include <algorithm>

namespace recording {
template <typename Function>
void SampleChannel::forEachChunk(Position from, Position to, const Function& function) const
{
    for (std::size_t i = from.chunk; i < m_chunks.size() && i <= to.chunk; ++i) {
        const std::size_t begin = i == from.chunk ? from.index : 0;
        const std::size_t end = i == to.chunk ? to.index : m_chunks[i].size();
        if (begin < end)
            function(m_chunks[i], begin, end);
    }
}

SampleChannel::AppendResult SampleChannel::append(base::Duration at, double value,
                                                  std::size_t& bytes)
{
    if (!m_chunks.empty() && at < m_chunks.back().lastTime())
        return AppendResult::OutOfOrder;
    if (m_chunks.empty() || !m_chunks.back().accepts(at)) {
        if (!m_chunks.empty()) {
            bytes -= m_chunks.back().bytes();
            m_chunks.back().close();
            bytes += m_chunks.back().bytes();
        }
        m_chunks.emplace_back(at);
        bytes += m_chunks.back().bytes();
    }
    SampleChunk& chunk = m_chunks.back();
    if (m_gap || chunk.mustGrow()) {
        bytes -= chunk.bytes();
        if (chunk.mustGrow())
            chunk.grow();
        if (m_gap)
            chunk.markGap();
        m_gap = false;
        bytes += chunk.bytes();
    }
    chunk.append(at, value);
    return AppendResult::Appended;
}

void SampleChannel::clear()
{
    *this = SampleChannel();
}

TimeSpan SampleChannel::span() const
{
    return {m_chunks.front().base(), m_chunks.back().lastTime()};
}

SampleChannel::Position SampleChannel::next(Position position) const
{
    if (++position.index == m_chunks[position.chunk].size())
        return {position.chunk + 1, 0};
    return position;
}

SampleChannel::Position SampleChannel::previous(Position position) const
{
    if (position.index > 0)
        return {position.chunk, position.index - 1};
    return {position.chunk - 1, m_chunks[position.chunk - 1].size() - 1};
}

SampleChannel::Position SampleChannel::lowerBound(base::Duration at, Position start) const
{
    if (start == end())
        return start;
    if (m_chunks[start.chunk].lastTime() >= at)
        return {start.chunk, m_chunks[start.chunk].lowerBound(at, start.index)};
    const auto found =
        std::partition_point(m_chunks.begin() + std::ptrdiff_t(start.chunk), m_chunks.end(),
                             [at](const SampleChunk& chunk) { return chunk.lastTime() < at; });
    if (found == m_chunks.end())
        return end();
    return {std::size_t(found - m_chunks.begin()), found->lowerBound(at, 0)};
}

SamplePoint SampleChannel::point(Position position) const
{
    const SampleChunk& chunk = m_chunks[position.chunk];
    return {chunk.timeAt(position.index), chunk.valueAt(position.index)};
}

SampleColumn SampleChannel::column(Position from, Position to) const
{
    const SamplePoint first = point(from);
    const SamplePoint last = point(previous(to));
    const Extremes extreme = *extremes(from, to);
    return {first.at, last.at, first.value, last.value, extreme.min, extreme.max, gapAt(from)};
}

std::optional<Extremes> SampleChannel::extremes(Position from, Position to) const
{
    std::optional<Extremes> found;
    forEachChunk(from, to, [&](const SampleChunk& chunk, std::size_t begin, std::size_t end) {
        const Extremes piece = chunk.extremes(begin, end);
        if (found)
            found->include(piece);
        else
            found = piece;
    });
    return found;
}

Moments SampleChannel::moments(Position from, Position to, base::Duration origin) const
{
    Moments sum;
    forEachChunk(from, to, [&](const SampleChunk& chunk, std::size_t begin, std::size_t end) {
        Moments piece = chunk.moments(begin, end);
        piece.meanTime += double((chunk.base() - origin).count()) * 1e-6;
        sum.merge(piece);
    });
    return sum;
}

bool SampleChannel::exact(Position from, Position to) const
{
    bool exact = true;
    forEachChunk(from, to, [&](const SampleChunk& chunk, std::size_t begin, std::size_t end) {
        exact = exact && (!chunk.isDecimated() || (begin == 0 && end == chunk.size()));
    });
    return exact;
}

std::optional<base::Duration> SampleChannel::oldestToDecimate() const
{
    if (m_decimated + 1 >= m_chunks.size())
        return std::nullopt;
    return m_chunks[m_decimated].lastTime();
}

std::optional<base::Duration> SampleChannel::oldestDroppable() const
{
    if (m_chunks.size() < 2)
        return std::nullopt;
    return m_chunks.front().lastTime();
}

void SampleChannel::decimateOldest(std::size_t& bytes)
{
    SampleChunk& chunk = m_chunks[m_decimated++];
    bytes -= chunk.bytes();
    chunk = chunk.decimated();
    bytes += chunk.bytes();
}

void SampleChannel::dropOldest(std::size_t& bytes)
{
    bytes -= m_chunks.front().bytes();
    m_droppedUntil = m_chunks.front().lastTime();
    m_chunks.pop_front();
    m_decimated -= m_decimated > 0 ? 1 : 0;
}

std::size_t SampleChannel::bytes() const
{
    std::size_t sum = 0;
    for (const SampleChunk& chunk : m_chunks)
        sum += chunk.bytes();
    return sum;
}
} // namespace recording

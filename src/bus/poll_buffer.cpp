// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_buffer.h"

#include <iterator>

namespace bus {
PollId PollBuffer::open()
{
    const std::lock_guard lock(m_mutex);
    m_queues.try_emplace(++m_last);
    return m_last;
}

void PollBuffer::add(PollId id, Sample sample)
{
    const std::lock_guard lock(m_mutex);
    const auto queue = m_queues.find(id);
    if (queue == m_queues.end())
        return;
    auto& samples = queue->second.samples;
    if (samples.size() == capacity) {
        samples.pop_front();
        ++m_lost;
    }
    samples.push_back(std::move(sample));
}

void PollBuffer::close(PollId id)
{
    const std::lock_guard lock(m_mutex);
    const auto queue = m_queues.find(id);
    if (queue == m_queues.end())
        return;
    if (queue->second.samples.empty())
        m_queues.erase(queue);
    else
        queue->second.closed = true;
}

std::vector<Sample> PollBuffer::take(PollId id)
{
    const std::lock_guard lock(m_mutex);
    const auto queue = m_queues.find(id);
    if (queue == m_queues.end())
        return {};
    auto& samples = queue->second.samples;
    std::vector<Sample> taken(std::make_move_iterator(samples.begin()),
                              std::make_move_iterator(samples.end()));
    samples.clear();
    if (queue->second.closed)
        m_queues.erase(queue);
    return taken;
}

std::uint64_t PollBuffer::lost() const
{
    const std::lock_guard lock(m_mutex);
    return m_lost;
}
} // namespace bus
